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
        # As many steps as half a period has, and as many more as the horizon is longer.
        self.step = math.pi / case.omega / STEPS
        self.steps = round(case.end / self.step)
        if self.steps > 20 * STEPS:
            raise protocol.Decline("too long", f"{self.steps} steps")

    def __call__(self, time):
        angle = self.omega * time
        return math.cos(angle) + self.r * math.sin(angle)


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
    """Impacts in a row of states (time, phi, phi'), one a step: where phi changes its sign, reached with the velocity of the state before.

    For simulators that keep the floor rigid. Yields (time, velocity after it) at an impact and None at any other step.
    """
    side, before, is_up = -1.0, (0.0, 0.0, 0.0), False
    for state in states:
        _, phi, velocity = state
        is_up = is_up or side * phi > 0.0
        landed = None
        if is_up and side * phi < 0.0:
            start, height, speed = before
            fall = abs(height / speed) if speed * side < 0.0 else step
            landed = (start + min(fall, step), velocity)
            side, is_up = -side, False
        before = state
        yield state, landed


def by_rate(states, step, eta):
    """The same where phi' stops growing towards the base, by at least half of what an impact takes.

    For floors that give: the corner that carries sinks, so the other one lands before phi = 0.
    """
    side, peak, when, is_up, before, landing = -1.0, 0.0, 0.0, False, 0.0, None
    usual = 3.0 * step  # what a step changes phi' by without an impact
    for state in states:
        time, _, velocity = state
        closing = -side * velocity
        if closing < 0.0:
            is_up = True
        if is_up and closing > peak:
            peak, when = closing, time
        landed = None
        if landing is None and is_up and peak > 0.0 and closing < 0.5 * (1.0 + eta) * peak:
            landing = when + 0.5 * step
        if landing is not None and abs(velocity - before) < usual:
            landed = (landing, before)
            side, peak, is_up, landing = -side, 0.0, -side * -velocity < 0.0, None
        before = velocity
        yield state, landed


def listed(case, step, states, impacts=by_rotation):
    """The impacts as an answer. A flight of fewer than LEAST steps ends the list: what is shorter is not seen. What then never moves again by more than
    such a flight is at rest, from where it moved last.
    """
    times, velocities = [], []
    still, phi, moved, is_listing = (LEAST * step) ** 2, 0.0, 0.0, True
    for (time, phi, velocity), landed in impacts(states, step, case.eta):
        if not (abs(phi) < 10.0 and abs(velocity) < 1e6):
            return protocol.History(times, velocities, "overturned" if math.isfinite(phi) else "lost")
        if abs(phi) > still:
            moved = time
        if landed and is_listing:
            is_listing = landed[0] - (times[-1] if times else 0.0) >= LEAST * step
            if is_listing:
                times.append(landed[0])
                velocities.append(landed[1])
                if len(times) == case.impacts:
                    return protocol.History(times, velocities, "limit-reached")
    if abs(phi) > still:
        return protocol.History(times, velocities, case.still_rocking)
    if not times:
        return protocol.History([], [], "lost", notes={"why": "it never rocked"})
    return protocol.History(times, velocities, "at-rest", tau_ch=max(moved, times[-1]))


def serve(name, version, answer, model):
    """Puts a simulator under the protocol. Without an amplitude above the threshold there is nothing to simulate."""

    def rocking(case):
        return answer(case) if case.epsilon > 0.0 else protocol.History([], [], "never-rocks")

    protocol.serve(name, version, rocking, (model,))
