"""The linear rocking block (Eq. 4), as the peers need it: the excitation without cancellation, and units for each flight.

phi'' = phi - i - f(tau), f = a sin(omega tau + psi), sin(psi) = 1/a. Written again, apart from the oracles of the repository.
"""

import math

from numba import njit


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
