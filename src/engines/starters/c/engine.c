/* A rocking block that chatters, as an engine for chattercheck: reads questions, one JSON object a line, and prints answers.

   Between impacts phi'' = phi - side - f(tau), with side the sign of phi and f = cos(omega tau) + r sin(omega tau) the acceleration of the ground
   over that which starts the rocking, r = sqrt(a^2 - 1). At an impact, phi = 0, the velocity is multiplied by eta. Replace what is yours. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

/* A flight: its side, the velocity that it starts with, the ground, and the phase omega tau at its start. */
struct flight { double side, v, omega, r, phase; };
struct motion { double phi, speed; };

/* cosh or sinh (sign = 1), cos or sin (sign = -1) from the power x^n on, divided by x^n: 1/n! + sign x^2/(n+2)! + ... */
static double series(int n, double x, double sign) {
    double term = 1;
    for (int k = 2; k <= n; k++) term /= k;
    double total = term;
    while (fabs(term) > 1e-17 * fabs(total)) {
        n += 2;
        term *= sign * x * x / (n * (n - 1.0));
        total += term;
    }
    return total;
}

/* side + f; 1 - cos is written as 2 sin^2, so that nothing is lost next to the start. */
static double pull(double side, double r, double phase) {
    double c = cos(phase / 2), s = sin(phase / 2);
    return r * sin(phase) + (side > 0 ? 2 * c * c : -2 * s * s);
}

/* phi/s and phi' a time s after the impact. No term is the small difference of large ones, so that short flights are as right as long ones. */
static struct motion at(const struct flight *it, double s) {
    double w = it->omega, h[5], b[5], g = pull(it->side, it->r, it->phase);
    for (int n = 0; n < 5; n++) {
        h[n] = series(n, s, 1);
        b[n] = h[n] + w * w * series(n, w * s, -1);
    }
    double f = (cos(it->phase) + it->r * sin(it->phase)) * s * s * s * w * w / (1 + w * w);
    double slope = (it->r * cos(it->phase) - sin(it->phase)) * s * s * w / (1 + w * w);
    struct motion motion = {it->v * h[1] - g * s * h[2] + f * b[4] - slope * b[3], it->v * h[0] - g * s * h[1] + f * b[3] - slope * b[2]};
    return motion;
}

/* The first root of phi up to the time end, or -1, and phi' there: a scan for the change of sign, then Newton's method kept inside of the bracket. */
static double landing(const struct flight *it, double end, double *speed) {
    double g = pull(it->side, it->r, it->phase), low = 0;
    double step = it->v * g > 0 ? fmin(it->v / g / 2, end / 64) : end / 64, high = step;
    while (it->side * at(it, high).phi > 0) {
        if (high >= end) return -1;
        low = high;
        high = fmin(high + fmax(step, high / 16), end);
    }
    double s = high;
    for (int n = 0; n < 200; n++) {
        struct motion motion = at(it, s);
        *speed = motion.speed;
        if (it->side * motion.phi > 0) low = s; else high = s;
        double new = s - motion.phi * s / motion.speed;
        if (!(low < new && new < high)) new = (low + high) / 2;
        if (fabs(new - s) <= 2e-16 * s) break;
        s = new;
    }
    return s;
}

static void column(const char *name, const double *values, int count) {
    printf("\"%s\":[", name);
    for (int n = 0; n < count; n++) printf("%s%.17g", n ? "," : "", values[n]);
    printf("],");
}

/* Prints the history of a case: the impacts in columns, and why the list ends. The time end is half a period of the ground if until is 0. */
static void chatter(double epsilon, double omega, double eta, int impacts, double until) {
    double *time = calloc(3 * (size_t)impacts, sizeof *time), *interval = time + impacts, *velocity = interval + impacts;
    double r = sqrt(epsilon * (2 + epsilon)), end = until > 0 ? until : PI / omega, now = 0;
    struct flight flight = {-1, 0, omega, r, 0};
    const char *ending = "never-rocks";
    int count = 0;
    while (epsilon > 0) {
        double speed = 0, s = landing(&flight, end - now, &speed);
        if (s < 0 || now + s >= end) {
            ending = until > 0 ? "limit-reached" : "incomplete";
            break;
        }
        now += s;
        flight.side = -flight.side, flight.v = eta * speed, flight.phase = omega * now;
        time[count] = now, interval[count] = s, velocity[count] = flight.v;
        count++;
        if (fabs(flight.v) < 1e-250 || count == impacts) {
            /* The intervals that are left are a geometric series; if the pull hardly changes while they last, the block comes to rest. */
            double left = (s + (count > 1 ? interval[count - 2] : 0)) * eta * eta / (1 - eta * eta);
            double change = omega * left * fabs(r * cos(omega * now) - sin(omega * now));
            double weakest = fmin(pull(1, r, omega * now), -pull(-1, r, omega * now));
            ending = change < 0.1 * weakest ? "at-rest" : "limit-reached";
            break;
        }
    }
    printf("\"history\":{");
    column("time", time, count), column("interval", interval, count), column("velocity", velocity, count);
    printf("\"ending\":\"%s\"}", ending);
    free(time);
}

/* The number behind "name": in a question; 0 if it is none. Questions have no spaces, and every name once. */
static double number(const char *question, const char *name) {
    char key[32];
    snprintf(key, sizeof key, "\"%s\":", name);
    const char *found = strstr(question, key);
    return found ? strtod(found + strlen(key), NULL) : 0;
}

int main(void) {
    char *line = NULL;
    size_t size = 0;
    while (getline(&line, &size, stdin) > 0) {
        double omega = number(line, "omega"), until = number(line, "until");
        if (strstr(line, "\"cmd\":\"start\"")) {
            printf("{\"version\":1,\"engine\":{\"name\":\"my C engine\",\"version\":\"1\",\"language\":\"C\"},\"models\":[\"linear\"],"
                   "\"normalisations\":[\"threshold\"],\"ground\":[\"sine\"],\"echo\":[");
            /* The numbers are read and printed again, which shows that no digit is lost. */
            char *rest = strstr(line, "\"echo\":[");
            if (!rest) return 1;
            rest += strlen("\"echo\":[");
            for (int n = 0; n == 0 || *rest == ','; n++) printf("%s%.17g", n ? "," : "", strtod(rest + (n > 0), &rest));
            printf("]}");
        } else if (!strstr(line, "\"cmd\":\"case\"")) {
            break;
        } else if (!strstr(line, "\"model\":\"linear\"") || until * omega > 10) {
            printf("{\"seq\":%.0f,\"decline\":{\"reason\":\"not the linear block in little more than half a period\"}}", number(line, "seq"));
        } else {
            printf("{\"seq\":%.0f,", number(line, "seq"));
            chatter(number(line, "epsilon"), omega, number(line, "eta"), (int)number(line, "impacts"), until);
            printf("}");
        }
        /* Flushed, or the gate waits for ever for an answer that stays in a buffer. */
        printf("\n");
        fflush(stdout);
    }
    free(line);
    return 0;
}
