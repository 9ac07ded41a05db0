/* The rocking block by CVODE, in C. The wheel brings the library without its headers, so the few prototypes stand here. */

#include <math.h>
#include <stddef.h>

typedef void *Handle;
typedef int (*Function)(double, Handle, Handle, void *);

int SUNContext_Create(int, Handle *);
int SUNContext_ClearErrHandlers(Handle);
Handle N_VNew_Serial(long, Handle);
double *N_VGetArrayPointer(Handle);
Handle SUNDenseMatrix(long, long, Handle);
Handle SUNLinSol_Dense(Handle, Handle, Handle);
Handle SUNNonlinSol_FixedPoint(Handle, int, Handle);
Handle CVodeCreate(int, Handle);
int CVodeInit(Handle, Function, double, Handle);
int CVodeReInit(Handle, double, Handle);
int CVodeSStolerances(Handle, double, double);
int CVodeSetUserData(Handle, void *);
int CVodeSetNonlinearSolver(Handle, Handle);
int CVodeSetLinearSolver(Handle, Handle, Handle);
int CVodeRootInit(Handle, int, int (*)(double, Handle, double *, void *));
int CVodeSetRootDirection(Handle, int *);
int CVodeSetNoInactiveRootWarn(Handle);
int CVodeSetMaxHnilWarns(Handle, int);
int CVodeSetInitStep(Handle, double);
int CVodeSetMaxNumSteps(Handle, long);
int CVodeSetStopTime(Handle, double);
int CVode(Handle, double, Handle, double *, int);
int CVodeGetNumRhsEvals(Handle, long *);
void CVodeFree(Handle *);

enum { ADAMS = 1, BDF = 2, NORMAL = 1, TSTOP_RETURN = 1, ROOT_RETURN = 2 };
/* How a run ended. */
enum { LISTED = 0, TIME_IS_UP = 1, SOLVER_FAILED = 2, WRONG_SIGN = 3, STALLED = 4 };

/* In units of its own a flight lasts about 1: before this share of it the noise of its first steps is not looked at. */
static const double BLIND = 0.25;

/* The excitation f = a sin(omega tau + psi) and the flight; in rescaled flights also its units. */
struct Flight {
    double i, a, omega, psi, delta;
    double g, f, q, time, rotation;
    int is_rescaled;
};

static int equation(double t, Handle y, Handle dy, void *data)
{
    const struct Flight *p = data;
    const double *u = N_VGetArrayPointer(y);
    double *du = N_VGetArrayPointer(dy);
    du[0] = u[1];
    if (p->is_rescaled) {
        double half = 0.5 * p->omega * p->time * t, s = sin(half), c = cos(half);
        du[1] = p->time / p->rotation * p->time * (p->rotation * u[0] - (p->g + 2.0 * s * (p->q * c - p->f * s)));
    } else {
        du[1] = u[0] - p->i - p->a * sin(p->omega * t + p->psi);
    }
    return 0;
}

static int event(double t, Handle y, double *g, void *data)
{
    const struct Flight *p = data;
    *g = p->is_rescaled && t < BLIND ? p->i : N_VGetArrayPointer(y)[0];
    return 0;
}

/* i + f without cancellation, and the units of the flight: as in rocking.py. */
static void launch(struct Flight *p, double tau, double velocity)
{
    double y = 0.5 * p->omega * tau, angle = p->omega * tau - p->delta;
    p->g = p->i < 0.0 ? 2.0 * p->a * sin(y) * sin(p->delta - y) : 2.0 * p->a * cos(y) * cos(p->delta - y);
    p->f = p->a * cos(angle);
    p->q = -p->a * sin(angle);
    double second = -p->g, third = velocity - p->omega * p->q, fourth = second + p->omega * p->omega * p->f;
    double c[4] = {p->i * velocity, p->i * second / 2.0, p->i * third / 6.0, p->i * fourth / 24.0};
    p->time = 1.0 / fmax(p->omega, 1.0);
    for (int k = 1; k < 4; k++) {
        double balance = 0.0;
        for (int j = 0; j < k && c[k] < 0.0; j++)
            if (c[j] > 0.0)
                balance = fmax(balance, pow(c[j] / -c[k], 1.0 / (k - j)));
        if (balance > 0.0)
            p->time = fmin(p->time, balance);
    }
    p->rotation = 0.0;
    for (int k = 0; k < 4; k++)
        p->rotation = fmax(p->rotation, fabs(c[k]) * pow(p->time, k + 1));
}

struct Solver {
    Handle context, y, memory, inner, matrix;
    struct Flight flight;
};

/* A solver for all runs with these settings. It lives as long as the process. */
static int prepare(struct Solver *s, int method, double rtol, double atol)
{
    if (SUNContext_Create(0, &s->context))
        return 1;
    SUNContext_ClearErrHandlers(s->context);
    s->y = N_VNew_Serial(2, s->context);
    s->memory = CVodeCreate(method, s->context);
    if (!s->y || !s->memory || CVodeInit(s->memory, equation, 0.0, s->y) || CVodeSStolerances(s->memory, rtol, atol))
        return 1;
    if (method == ADAMS) {
        s->inner = SUNNonlinSol_FixedPoint(s->y, 0, s->context);
        if (!s->inner || CVodeSetNonlinearSolver(s->memory, s->inner))
            return 1;
    } else {
        s->matrix = SUNDenseMatrix(2, 2, s->context);
        s->inner = SUNLinSol_Dense(s->y, s->matrix, s->context);
        if (!s->inner || CVodeSetLinearSolver(s->memory, s->inner, s->matrix))
            return 1;
    }
    CVodeSetUserData(s->memory, &s->flight);
    CVodeSetMaxNumSteps(s->memory, 20000);
    CVodeSetMaxHnilWarns(s->memory, -1); /* thousands of lines otherwise, once steps vanish beside the time */
    return CVodeRootInit(s->memory, 1, event);
}

/* Lists up to `impacts` impacts. `how`: 0 one clock; 1 one clock, with the direction of the root, the
 * first step and the absolute tolerance, as a share of the rotation, given for each flight; 2 rescaled flights. */
int follow(int how, int method, double rtol, double atol, double epsilon, double omega, double eta, double end, int impacts,
           double *times, double *velocities, double *intervals, int *count, long *evaluations)
{
    static struct Solver solvers[32];
    static struct { int how, method; double rtol, atol; } keys[32];
    static int known;
    int at = 0;
    while (at < known && !(keys[at].how == how && keys[at].method == method && keys[at].rtol == rtol && keys[at].atol == atol))
        at++;
    struct Solver *s = &solvers[at];
    if (at == known) {
        if (known == 32 || prepare(s, method, rtol, atol))
            return SOLVER_FAILED;
        keys[at].how = how, keys[at].method = method, keys[at].rtol = rtol, keys[at].atol = atol;
        known++;
    }
    struct Flight *p = &s->flight;
    double a = 1.0 + epsilon, tau = 0.0, rest = 0.0, velocity = 0.0;
    *p = (struct Flight){.i = -1.0, .a = a, .omega = omega, .psi = asin(1.0 / a), .is_rescaled = how == 2};
    p->delta = 2.0 * asin(sqrt(epsilon / (2.0 * a)));
    double *y = N_VGetArrayPointer(s->y);
    *count = 0;
    *evaluations = 0;
    for (; *count < impacts; ++*count) {
        launch(p, tau, velocity);
        double start = how == 2 ? 0.0 : tau, stop = how == 2 ? (end - tau - rest) / p->time : end, t = start;
        y[0] = 0.0;
        y[1] = how == 2 ? velocity * p->time / p->rotation : velocity;
        int direction = p->i < 0.0 ? 1 : -1, none = 0;
        CVodeReInit(s->memory, start, s->y);
        if (how == 1)
            CVodeSStolerances(s->memory, rtol, atol * p->rotation);
        CVodeSetNoInactiveRootWarn(s->memory);
        CVodeSetRootDirection(s->memory, how ? &direction : &none);
        CVodeSetInitStep(s->memory, how == 2 ? 0.01 : how == 1 ? 0.25 * fmin(p->time, end - tau) : 0.0);
        CVodeSetStopTime(s->memory, stop);
        int flag = CVode(s->memory, stop, s->y, &t, NORMAL);
        long some = 0;
        CVodeGetNumRhsEvals(s->memory, &some);
        *evaluations += some;
        if (flag < 0)
            return SOLVER_FAILED;
        if (flag != ROOT_RETURN)
            return TIME_IS_UP;
        double interval = how == 2 ? p->time * t : t - tau;
        double speed = how == 2 ? y[1] * p->rotation / p->time : y[1];
        if (interval <= 0.0)
            return STALLED;
        if (p->i * speed >= 0.0)
            return WRONG_SIGN;
        double add = how == 2 ? interval + rest : interval, sum = tau + add;
        rest = how == 2 ? add - (sum - tau) : 0.0;
        tau = how == 2 ? sum : t;
        velocity = eta * speed;
        times[*count] = tau;
        velocities[*count] = velocity;
        intervals[*count] = interval;
        p->i = -p->i;
    }
    return LISTED;
}
