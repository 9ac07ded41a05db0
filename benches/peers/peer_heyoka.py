"""heyoka.py: Taylor's method, compiled by LLVM, with a terminal event that turns the block over."""

from rocking import SILENT, excitation, forcing, guess, serve, told

import math

import heyoka


def integrator(tol, cooldown, callback, parameters, right_hand_side):
    options = {} if cooldown is None else {"cooldown": cooldown}
    phi, velocity = heyoka.make_vars("phi", "velocity")
    event = heyoka.t_event(phi, callback=callback, **options)
    system = [(phi, velocity), (velocity, right_hand_side(phi))]
    return heyoka.taylor_adaptive(system, [0.0, 0.0], t_events=[event], pars=[0.0] * parameters, tol=tol)


def lift_off(share, a, omega, delta):
    """A little of the first flight by its series, u = j s^3/6 + u^(4) s^4/24 + ..: at its start the event has a triple root."""
    g, f, q = forcing(-1.0, 0.0, a, omega, delta)
    s = share * guess(-1.0, 0.0, g, f, q, omega)[0]
    jerk, snap, fifth = -omega * q, omega**2 * f, omega**3 * q - omega * q
    phi = (jerk / 6.0 + s * (snap / 24.0 + s * fifth / 120.0)) * s**3
    velocity = (jerk / 2.0 + s * (snap / 6.0 + s * fifth / 24.0)) * s**2
    return s, phi, velocity


def one_clock(tol, cooldown):
    """phi'' = phi - i - a sin(omega tau + psi) on one clock; the callback applies Eq. 13."""
    found = {}

    def callback(solver, _):
        solver.state[0] = 0.0
        solver.state[1] *= found["eta"]
        found["times"].append(solver.time)
        found["velocities"].append(solver.state[1])
        solver.pars[0] *= -1.0
        return len(found["times"]) < found["impacts"]

    def right_hand_side(phi):
        i, a, omega, psi = (heyoka.par[k] for k in range(4))
        return phi - i - a * heyoka.sin(omega * heyoka.time + psi)

    solver = integrator(tol, cooldown, callback, 4, right_hand_side)

    def run(case):
        omega = case.omega
        found.update(times=[], velocities=[], eta=case.eta, impacts=case.impacts)
        a, delta = excitation(case.epsilon, omega)
        solver.time, *solver.state[:] = lift_off(1e-3, a, omega, delta)
        solver.pars[:4] = (-1.0, a, omega, math.asin(1.0 / a))
        solver.reset_cooldowns()
        outcome = solver.propagate_until(case.end)[0]
        ended = ""
        if len(found["times"]) < case.impacts:
            ended = SILENT if outcome == heyoka.taylor_outcome.time_limit else f"loud: {outcome.name}"
        return told(case, found["times"], found["velocities"], ended)

    return run


def rescaled(tol):
    """Each flight in its own units, in which a cooldown of a tenth of a flight is safe."""
    landed = {}

    def callback(solver, _):
        landed["at"], landed["speed"] = solver.time, solver.state[1]
        return False

    def right_hand_side(chi):
        g, f, q, half, scale, square = (heyoka.par[k] for k in range(6))
        s, c = heyoka.sin(half * heyoka.time), heyoka.cos(half * heyoka.time)
        return square * chi - scale * (g + 2.0 * s * (q * c - f * s))

    solver = integrator(tol, 0.1, callback, 6, right_hand_side)

    def run(case):
        omega, eta, end = case.omega, case.eta, case.end
        a, delta = excitation(case.epsilon, omega)
        i, velocity, tau, rest = -1.0, 0.0, 0.0, 0.0
        times, velocities, intervals = [], [], []
        for n in range(case.impacts):
            g, f, q = forcing(i, tau, a, omega, delta)
            time, rotation = guess(i, velocity, g, f, q, omega)
            start, chi, speed = 0.0, 0.0, velocity * time / rotation
            if n == 0:
                s, phi, velocity = lift_off(1e-3, a, omega, delta)
                start, chi, speed = s / time, phi / rotation, velocity * time / rotation
            solver.time, solver.state[:] = start, (chi, speed)
            solver.pars[:] = (g, f, q, 0.5 * omega * time, time / rotation * time, time * time)
            solver.reset_cooldowns()
            landed.clear()
            outcome = solver.propagate_until((end - tau - rest) / time, max_delta_t=1.5)[0]
            # The known root at the start of a flight is an event too, at time 0.
            while landed and landed["at"] <= 0.0:
                landed.clear()
                outcome = solver.propagate_until((end - tau - rest) / time, max_delta_t=1.5)[0]
            if not landed:
                ended = SILENT if outcome == heyoka.taylor_outcome.time_limit else f"loud: {outcome.name}"
                return told(case, times, velocities, ended, intervals)
            interval = time * landed["at"]
            total = tau + (interval + rest)
            rest = (interval + rest) - (total - tau)
            tau = total
            velocity = eta * landed["speed"] * rotation / time
            times.append(tau)
            velocities.append(velocity)
            intervals.append(interval)
            i = -i
        return told(case, times, velocities, "", intervals)

    return run


EPSILON = 2.0**-52
SETTINGS = {
    "one clock, default cooldown": one_clock(EPSILON, None),
    "one clock, cooldown 1e-13": one_clock(EPSILON, 1e-13),
    "one clock, cooldown 1e-12": one_clock(EPSILON, 1e-12),
    "one clock, cooldown 1e-14": one_clock(EPSILON, 1e-14),
    "one clock, cooldown 1e-14, tol 1e-9": one_clock(1e-9, 1e-14),
    "rescaled flights": rescaled(EPSILON),
    "rescaled flights, tol 1e-9": rescaled(1e-9),
}

if __name__ == "__main__":
    serve("heyoka.py", heyoka.__version__, SETTINGS)
