"""diffrax (JAX): an adaptive Runge-Kutta method with an event, compiled by XLA. diffrax ends at an event, so each flight is a solve of its own.

One clock: as one would write it first. Local time: each flight starts at 0 and carries the phase, so that a short one keeps its digits.
"""

from rocking import AT_START, SILENT, WRONG_SIGN, excitation, serve, told

import math

import diffrax
import jax
import jax.numpy as jnp
import optimistix

jax.config.update("jax_enable_x64", True)


def flight(rtol, atol, smallest):
    """A compiled flight from `start` on: whether phi came back before `end`, when, and the velocity there."""

    def field(t, y, parameters):
        i, a, omega, psi, _ = parameters
        return jnp.array([y[1], y[0] - i - a * jnp.sin(omega * t + psi)])

    def above_the_base(t, y, args, **_):
        # At the start phi is 0: there the sign is that of the flight.
        i, *_, start = args
        return jnp.where(t > start, i * y[0], 1.0)

    event = diffrax.Event(above_the_base, optimistix.Newton(rtol=1e-13, atol=smallest, norm=optimistix.rms_norm), direction=False)

    @jax.jit
    def fly(start, end, first, velocity, i, a, omega, psi):
        found = diffrax.diffeqsolve(
            diffrax.ODETerm(field),
            diffrax.Dopri8(),
            start,
            end,
            first,
            jnp.array([0.0, velocity]),
            (i, a, omega, psi, start),
            stepsize_controller=diffrax.PIDController(rtol=rtol, atol=atol),
            event=event,
            max_steps=4096,
            throw=False,
        )
        return found.event_mask, found.result == diffrax.RESULTS.max_steps_reached, found.ts[-1], found.ys[-1, 1], found.stats["num_steps"]

    return fly


def flights(rtol, atol, is_local):
    # The root is the time of the impact: in local time it may be tiny.
    fly = flight(rtol, atol, 1e-300 if is_local else 1e-15)

    def run(case):
        omega, eta = case.omega, case.eta
        a, delta = excitation(case.epsilon, omega)
        psi, tau, velocity, i, steps = math.asin(1.0 / a), 0.0, 0.0, -1.0, 0
        times, velocities, intervals = [], [], []
        while len(times) < case.impacts:
            start, phase = (0.0, omega * tau + psi) if is_local else (tau, psi)
            # A first step that is shorter than the flight; diffrax chooses the later ones.
            pull = max(abs(i + a * math.sin(omega * tau + psi)), 1e-300)
            first = min(0.1 / omega, 0.1, 0.5 * abs(velocity) / pull) if velocity else 0.01 / max(omega, 1.0)
            is_event, is_stuck, at, speed, some = fly(start, case.end - (tau - start), first, velocity, i, a, omega, phase)
            steps += int(some)
            if not is_event:
                return told(case, times, velocities, "loud: the most steps" if is_stuck else SILENT, intervals, steps)
            interval, speed = float(at) - start, float(speed)
            if interval <= 0.0:
                return told(case, times, velocities, AT_START, intervals, steps)
            if i * speed >= 0.0:
                return told(case, times, velocities, WRONG_SIGN, intervals, steps)
            tau, velocity, i = tau + interval, eta * speed, -i
            times.append(tau)
            velocities.append(velocity)
            intervals.append(interval)
        return told(case, times, velocities, "", intervals, steps)

    return run


SETTINGS = {
    "one clock, Dopri8, rtol 1e-12": flights(1e-12, 1e-15, is_local=False),
    "local time, Dopri8, rtol 1e-12, atol 1e-30": flights(1e-12, 1e-30, is_local=True),
}

if __name__ == "__main__":
    serve("diffrax", diffrax.__version__, SETTINGS)
