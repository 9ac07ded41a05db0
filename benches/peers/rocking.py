"""The linear rocking block (Eq. 4), as the peers need it: the excitation without cancellation, units for each flight, and how an answer is told.

phi'' = phi - i - f(tau), f = a sin(omega tau + psi), sin(psi) = 1/a. Written again, apart from the oracles of the repository.
"""

import sys

import protocol  # first: what a simulator prints must not reach standard output

import math

from numba import njit

from closing import closed


@njit(cache=True)
def excitation(epsilon, omega):
    """The amplitude a and delta = pi/2 - psi, so that f = a cos(omega tau - delta)."""
    a = 1.0 + epsilon
    return a, 2.0 * math.asin(math.sqrt(epsilon / (2.0 * a)))


@njit(cache=True)
def forcing(i, tau, a, omega, delta):
    """i + f as a product that does not cancel, f = a sin(theta), and a cos(theta)."""
    y = 0.5 * omega * tau
    if i < 0.0:
        g = 2.0 * a * math.sin(y) * math.sin(delta - y)
    else:
        g = 2.0 * a * math.cos(y) * math.cos(delta - y)
    angle = omega * tau - delta
    return g, a * math.cos(angle), -a * math.sin(angle)


@njit(cache=True)
def guess(i, velocity, g, f, q, omega):
    """The first time at which what brings the block back balances what takes it away: about how long the flight lasts."""
    second = -g
    third = velocity - omega * q
    fourth = second + omega * omega * f
    c = (i * velocity, i * second / 2.0, i * third / 6.0, i * fourth / 24.0)
    time = 1.0 / max(omega, 1.0)
    for k in range(1, 4):
        if c[k] < 0.0:
            balance = 0.0
            for j in range(k):
                if c[j] > 0.0:
                    balance = max(balance, (c[j] / -c[k]) ** (1.0 / (k - j)))
            if balance > 0.0:
                time = min(time, balance)
    rotation = 0.0
    for k in range(4):
        rotation = max(rotation, abs(c[k]) * time ** (k + 1))
    return time, rotation


@njit(cache=True)
def scaled_acceleration(xi, chi, i, time, rotation, g, f, q, omega):
    """chi'' in the units of a flight, tau = tau_n + time xi, phi = rotation chi."""
    half = 0.5 * omega * time * xi
    s, c = math.sin(half), math.cos(half)
    g_now = g + 2.0 * s * (q * c - f * s)
    return time / rotation * time * (rotation * chi - g_now)


# How a list ends that is shorter than was asked for. No event until the time is up: for the peer the block is rocking. The others know that they are lost.
SILENT = "silent: no event until the end"
AT_START = "event returned at the start time"
WRONG_SIGN = "event with a velocity of the wrong sign"


def told(case, times, velocities, ended="", intervals=None, rhs=None):
    """A list of impacts as an answer; `ended` says why it is shorter than was asked for."""
    ending = {"": "limit-reached", SILENT: case.still_rocking}.get(ended, "lost")
    notes = {name: value for name, value in (("why", ended), ("rhs", rhs)) if value}
    return protocol.History(times, velocities, ending, intervals, notes=notes)


def serve(tool, version, settings):
    """Puts the setting that the command line names under the protocol; a setting is a function of a case."""
    if len(sys.argv) != 2 or sys.argv[1] not in settings:
        sys.exit("\n".join([f"usage: {sys.argv[0]} SETTING, with one of", *settings]))
    run = settings[sys.argv[1]]

    def answer(case):
        return run(case) if case.epsilon > 0.0 else protocol.History([], [], "never-rocks")

    protocol.serve(tool, version, answer, finish=closed)
