"""The block for simulators that step in time: as a rigid body on a floor (Eq. 2), or as a point above a floor (Eq. 4); and impacts read off the steps.

**As a body.** Mass 1, distance R = 1 from a corner to the centre of mass, gravity so that p = 1. A rigid body that neither slides nor bounces at the corner
that lands keeps of its rotation eta = 1 - 2 sin^2(alpha)/I, with I its moment of inertia about a corner (Housner; Newton's law with restitution 0 at both
corners). So I is made to give the eta that is asked for. It is at least 1, that of a point mass: 1 - eta > 2 sin^2(alpha) can't be had, whoever simulates.
The shaking is a horizontal gravity -a g tan(alpha) sin(omega t + psi): in the frame of the ground that is exact.

**As a point.** u = |phi|: u'' = u - 1 - i f while u > 0, and u' -> -eta u' at u = 0, where i turns over. A ball on a floor in a gravity 1 - u + i f that
the driver sets before each step, and with the restitution eta.
"""

import protocol

import math
import os

# How many steps half a period has. The step follows the shaking: both models are asked with omega from 0.01 to 200.
STEPS = int(os.environ.get("STEPS", 20000))
LEAST = 3  # steps that a flight has to last in order to be listed


class Shaking:
    """f = a sin(omega tau + psi), written without its cancellation at the start: f = cos(omega tau) + r sin(omega tau)."""

    def __init__(self, case):
        self.omega, self.r = case.omega, math.sqrt(case.epsilon * (2.0 + case.epsilon))
        self.step = math.pi / case.omega / STEPS
        self.steps = round(case.end / self.step)
        if self.steps > 20 * STEPS:
            raise protocol.Decline("too long", f"{self.steps} steps")

    def __call__(self, time):
        angle = self.omega * time
        return math.cos(angle) + self.r * math.sin(angle)


class Push:
    """A steady push of nine tenths of what starts the rocking, for 200 steps."""

    def __init__(self, step):
        self.step, self.steps = step, 200

    def __call__(self, time):
        return 0.9


class Body:
    """The measures of a block of this slenderness and restitution; lengths in units of R, times of 1/p."""

    def __init__(self, case):
        sine, cosine = math.sin(case.alpha), math.cos(case.alpha)
        self.half_width, self.half_height = sine, cosine
        about_corner = 2.0 * sine * sine / (1.0 - case.eta)
        if about_corner < 1.001:
            raise protocol.Decline(
                "no such block", f"1 - eta = {1.0 - case.eta} of a block that neither slides nor bounces is below 2 sin^2(alpha) = {2.0 * sine * sine}"
            )
        self.inertia = about_corner - 1.0
        self.gravity = about_corner
        self.shake = self.gravity * math.tan(case.alpha)  # of f = 1


def by_rotation(states, step, eta):
    """Flights in a row of states (time, phi, phi'), one a step: phi changes its sign, reached with the velocity of the state before.

    For floors that are rigid. Yields each state, and with the step in which a flight ends (when, the velocity after it, how high it went).
    """
    side, before, height = -1.0, (0.0, 0.0, 0.0), 0.0
    for state in states:
        _, phi, velocity = state
        ended = None
        if height > 0.0 and side * phi < 0.0:
            start, above, speed = before
            fall = abs(above / speed) if speed * side < 0.0 else step
            ended = (start + min(fall, step), velocity, height)
            side, height = -side, 0.0
        height = max(height, side * phi)
        before = state
        yield state, ended


def by_rate(states, step, eta):
    """The same where phi' stops growing towards the base, by at least half of what an impact takes.

    For floors that give: the corner that carries sinks, so the other one lands before phi = 0.
    """
    side, peak, when, height, before, landing = -1.0, 0.0, 0.0, 0.0, 0.0, None
    usual = 3.0 * step  # what a step changes phi' by without an impact
    for state in states:
        time, phi, velocity = state
        closing = -side * velocity
        is_up = height > 0.0
        if is_up and closing > peak:
            peak, when = closing, time
        if landing is None and is_up and peak > 0.0 and closing < 0.5 * (1.0 + eta) * peak:
            landing = when + 0.5 * step
        ended = None
        if landing is not None and abs(velocity - before) < usual:
            ended = (landing, before, height)
            side, peak, height, landing = -side, 0.0, 0.0, None
        if side * velocity > 0.0:
            height = max(height, abs(phi))
        before = velocity
        yield state, ended


def listed(case, simulate, flights, give=None):
    """The impacts as an answer. `simulate` is a function of a shaking that yields states.

    What is not seen is not listed: flights of fewer than LEAST steps, or slower than what a step changes the velocity by, and what follows them; and at
    the end of the list what goes no higher than the floor gives (`give`, measured with a steady push unless it is known). A block that goes no higher than
    that is at rest, from the last impact on.
    """
    shaking = Shaking(case)
    if give is None:
        give = max(abs(phi) for _, phi, _ in simulate(Push(shaking.step)))
    still = max((LEAST * shaking.step) ** 2, 3.0 * give)
    seen, is_seen, phi = [], True, 0.0
    for (_, phi, velocity), ended in flights(simulate(shaking), shaking.step, case.eta):
        if not (abs(phi) < 10.0 and abs(velocity) < 1e6):
            break
        if ended and is_seen:
            is_long = ended[0] - (seen[-1][0] if seen else 0.0) >= LEAST * shaking.step
            is_seen = is_long and abs(ended[1]) > 0.1 * shaking.step
            if is_seen:
                seen.append(ended)
    while seen and seen[-1][2] <= max(3.0 * give, shaking.step**2):
        seen.pop()
    seen = seen[: case.impacts]
    times, velocities = [time for time, *_ in seen], [velocity for _, velocity, _ in seen]
    if len(seen) == case.impacts:
        return protocol.History(times, velocities, "limit-reached")
    if not abs(phi) < 10.0:
        return protocol.History(times, velocities, "overturned" if math.isfinite(phi) else "lost")
    if abs(phi) > (still if is_seen else 100.0 * still):
        return protocol.History(times, velocities, case.still_rocking)
    if not seen:
        return protocol.History([], [], "lost", notes={"why": "it never rocked"})
    return protocol.History(times, velocities, "at-rest", tau_ch=times[-1], notes={"give": give})


def serve(name, version, answer, model, finish=protocol.as_it_is):
    """Puts a simulator under the protocol. Without an amplitude above the threshold there is nothing to simulate."""

    def rocking(case):
        return answer(case) if case.epsilon > 0.0 else protocol.History([], [], "never-rocks")

    protocol.serve(name, version, rocking, (model,), finish=finish)
