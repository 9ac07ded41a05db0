"""SciPy's solve_ivp with events: as one would write it first, with care for the start of each flight, and in the units of each flight."""

from rocking import AT_START, SILENT, excitation, forcing, guess, scaled_acceleration, serve, told

import math

import scipy
from scipy.integrate import solve_ivp


def one_clock(method, rtol, care):
    """One clock, phi itself as the event. With care 1 the direction of the event is given, with 2 also a first step of a quarter of the flight."""

    def run(case):
        omega, eta, end = case.omega, case.eta, case.end
        a, delta = excitation(case.epsilon, omega)
        psi = math.asin(1.0 / a)
        i, y, tau, rhs = -1.0, [0.0, 0.0], 0.0, 0
        times, velocities = [], []

        def fun(t, y):
            return y[1], y[0] - i - a * math.sin(omega * t + psi)

        def event(t, y):
            return y[0]

        event.terminal = True
        while len(times) < case.impacts:
            first = None
            if care >= 1:
                event.direction = -i
            if care == 2:
                g, f, q = forcing(i, tau, a, omega, delta)
                first = min(0.25 * guess(i, y[1], g, f, q, omega)[0], end - tau)
            try:
                found = solve_ivp(fun, (tau, end), y, method, events=event, rtol=rtol, atol=rtol * 1e-3, first_step=first)
            except ValueError as error:
                return told(case, times, velocities, f"exception: {error}", rhs=rhs)
            rhs += found.nfev
            if found.status == -1:
                return told(case, times, velocities, f"loud: {found.message}", rhs=rhs)
            if found.status == 0:
                return told(case, times, velocities, SILENT, rhs=rhs)
            landed = float(found.t_events[0][0])
            if landed <= tau:
                return told(case, times, velocities, AT_START, rhs=rhs)
            tau, i, y = landed, -i, [0.0, eta * float(found.y_events[0][0][1])]
            times.append(tau)
            velocities.append(y[1])
        return told(case, times, velocities, rhs=rhs)

    return run


def rescaled(method, rtol):
    """Each flight in its own units, tau = tau_n + T xi and phi = P chi, with the root at its start divided out of the event."""

    def run(case):
        omega, eta, end = case.omega, case.eta, case.end
        a, delta = excitation(case.epsilon, omega)
        i, velocity, tau, rest, rhs = -1.0, 0.0, 0.0, 0.0, 0
        times, velocities, intervals = [], [], []
        for _ in range(case.impacts):
            g, f, q = forcing(i, tau, a, omega, delta)
            time, rotation = guess(i, velocity, g, f, q, omega)
            power = 1 if times else 3

            def fun(xi, y):
                return y[1], scaled_acceleration(xi, y[0], i, time, rotation, g, f, q, omega)

            def event(xi, y):
                return y[0] / xi**power if xi > 0.0 else i

            event.terminal, event.direction = True, -i
            span = (0.0, (end - tau - rest) / time)
            start = [0.0, velocity * time / rotation]
            found = solve_ivp(fun, span, start, method, events=event, rtol=rtol, atol=rtol, first_step=min(0.25, span[1]))
            rhs += found.nfev
            if found.status != 1:
                ended = SILENT if found.status == 0 else f"loud: {found.message}"
                return told(case, times, velocities, ended, intervals, rhs)
            interval = time * float(found.t_events[0][0])
            total = tau + (interval + rest)
            rest = (interval + rest) - (total - tau)
            tau = total
            velocity = eta * float(found.y_events[0][0][1]) * rotation / time
            times.append(tau)
            velocities.append(velocity)
            intervals.append(interval)
            i = -i
        return told(case, times, velocities, "", intervals, rhs)

    return run


SETTINGS = {
    "one clock, DOP853, rtol 1e-12": one_clock("DOP853", 1e-12, 0),
    "event with direction, RK45, rtol 1e-6": one_clock("RK45", 1e-6, 1),
    "event with direction, LSODA, rtol 1e-12": one_clock("LSODA", 1e-12, 1),
    "event with direction, DOP853, rtol 1e-12": one_clock("DOP853", 1e-12, 1),
    "careful start, DOP853, rtol 1e-12": one_clock("DOP853", 1e-12, 2),
    **{f"rescaled flights, DOP853, rtol {rtol:g}": rescaled("DOP853", rtol) for rtol in (1e-6, 1e-9, 1e-12)},
}

if __name__ == "__main__":
    serve("SciPy solve_ivp", scipy.__version__, SETTINGS)
