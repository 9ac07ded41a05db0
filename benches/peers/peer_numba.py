"""What one would write by hand: the closed form of Eq. 4, compiled by numba."""

from rocking import SILENT, excitation, forcing, guess, serve, told

import math

import numba
import numpy as np
from numba import njit

# How a list ends: long enough, at the end of the time, or at a flight without a root.
LISTED, TIME_IS_UP, NO_ROOT = 0, 1, 2


@njit(cache=True)
def local(epsilon, omega, eta, impacts, end):
    """Each flight as the Taylor series of its exact solution in local time, without its root at the start; Newton's method."""
    a, delta = excitation(epsilon, omega)
    times, velocities, intervals = np.empty(impacts), np.empty(impacts), np.empty(impacts)
    c = np.empty(64)
    tau, rest, velocity, i = 0.0, 0.0, 0.0, -1.0
    for n in range(impacts):
        g, f, q = forcing(i, tau, a, omega, delta)
        if n < 5:
            s, _ = guess(i, velocity, g, f, q, omega)
        else:
            # Two flights earlier the interval was one of the same sign; its ratio to the one before that still holds, nearly.
            s = intervals[n - 2] * intervals[n - 2] / intervals[n - 4]
        # Coefficients u^(k)/k! of u = i phi: phi^(k+2) = phi^(k) - f^(k); as many as it takes where s is twice as long as guessed.
        reach = 2.0 * max(omega, 1.0) * s
        even, odd = -i * g, i * (velocity - omega * q)
        c[1], c[2], c[3] = i * velocity, even / 2.0, odd / 6.0
        f_even, f_odd = -omega * omega * f, -omega * omega * omega * q
        over_factorial, size, last = 1.0 / 6.0, 1.0, 4
        while size > 1e-18 and last < 62:
            over_factorial /= last
            even -= i * f_even
            c[last] = even * over_factorial
            over_factorial /= last + 1
            odd -= i * f_odd
            c[last + 1] = odd * over_factorial
            f_even *= -omega * omega
            f_odd *= -omega * omega
            size *= reach * reach / ((last - 2) * (last - 1))
            last += 2
        first = 3 if n == 0 else 1
        for _ in range(60):
            value, slope = c[last - 1], 0.0
            for k in range(last - 2, first - 1, -1):
                slope = slope * s + value
                value = value * s + c[k]
            step = value / slope
            s -= step
            if abs(step) <= 1e-9 * s:
                break  # the error is the square of that
        speed = 0.0
        for k in range(last - 1, 0, -1):
            speed = speed * s + k * c[k]
        total = tau + (s + rest)
        rest = (s + rest) - (total - tau)
        tau = total
        if not (s > 0.0 and speed < 0.0):
            return times[:n], velocities[:n], intervals[:n], NO_ROOT
        if tau >= end:
            return times[:n], velocities[:n], intervals[:n], TIME_IS_UP
        velocity = eta * i * speed
        times[n], velocities[n], intervals[n] = tau, velocity, s
        i = -i
    return times, velocities, intervals, LISTED


@njit(cache=True)
def printed(epsilon, omega, eta, impacts, end):
    """Eqs 6-13 as they are printed, in absolute time; Newton's method from the parabola."""
    a = 1.0 + epsilon
    psi = math.asin(1.0 / a)
    scale = a / (omega * omega + 1.0)
    times, velocities, intervals = np.empty(impacts), np.empty(impacts), np.empty(impacts)
    tau, velocity, i = 0.0, 0.0, -1.0
    for n in range(impacts):
        xi, dxi = scale * math.sin(omega * tau + psi), scale * omega * math.cos(omega * tau + psi)
        big_a = 0.5 * math.exp(tau) * (-i - xi - velocity + dxi)
        big_b = 0.5 * math.exp(-tau) * (-i - xi + velocity - dxi)
        acceleration = -i - a * math.sin(omega * tau + psi)
        if n == 0:
            at = 1.2 * 4.0 * math.sqrt(epsilon * (2.0 + epsilon)) / omega
        else:
            at = tau - 2.0 * velocity / acceleration
        slope, before = 0.0, math.inf
        for _ in range(60):
            value = big_b * math.exp(at) + big_a * math.exp(-at) + i + scale * math.sin(omega * at + psi)
            slope = big_b * math.exp(at) - big_a * math.exp(-at) + scale * omega * math.cos(omega * at + psi)
            step = value / slope
            if abs(step) >= before:
                break  # nothing but rounding is left
            at -= step
            before = abs(step)
        if not (at > tau and i * slope < 0.0):
            return times[:n], velocities[:n], intervals[:n], NO_ROOT
        if at >= end:
            return times[:n], velocities[:n], intervals[:n], TIME_IS_UP
        velocity = eta * slope
        times[n], velocities[n], intervals[n] = at, velocity, at - tau
        tau = at
        i = -i
    return times, velocities, intervals, LISTED


def peer(solve):
    def run(case):
        *columns, ended = solve(case.epsilon, case.omega, case.eta, case.impacts, case.end)
        times, velocities, intervals = columns
        return told(case, times, velocities, {TIME_IS_UP: SILENT, NO_ROOT: "stops: no root after the start"}.get(ended, ""), intervals)

    return run


SETTINGS = {
    "closed form in local time": peer(local),
    "Eq. 6 as printed": peer(printed),
}

if __name__ == "__main__":
    serve("numba", numba.__version__, SETTINGS)
