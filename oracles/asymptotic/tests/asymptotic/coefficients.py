"""Reference coefficients of the asymptotic series, by a way that knows no series in epsilon.

omega tau_ch/epsilon^(1/2) is analytic in epsilon inside the circle through a_cr - 1, so its coefficients are the Fourier
coefficients of its values on a smaller circle. The values come from stepping with complex epsilon: Taylor series of Eq. 4 in
local time theta = omega tau/epsilon^(1/2), Newton's method from the duration at the point before, Richardson's extrapolation
in eta^2 over pairs of flights. Takes a minute for each case.

    python3 coefficients.py OMEGA ETA RADIUS POINTS PAIRS ORDERS >> coefficients.csv
    python3 coefficients.py 2.0 0.5 0.085 192 32 72
"""
import sys

import mpmath as mp
from mpmath import mpc, mpf

mp.mp.dps = 44
TERMS = 60


def over_factorials(derivatives):
    factorial, coefficients = mpf(1), []
    for k, derivative in enumerate(derivatives):
        factorial *= max(k, 1)
        coefficients.append(derivative / factorial)
    return coefficients


def value(c, x):
    total = mpc(0)
    for a in reversed(c):
        total = total * x + a
    return total


def slope(c, x):
    total = mpc(0)
    for k in range(len(c) - 1, 0, -1):
        total = total * x + k * c[k]
    return total


def shortened(c, x):
    """Without the terms that do not matter at x."""
    size = max(abs(a) * abs(x) ** k for k, a in enumerate(c[:6]))
    n = len(c)
    while n > 6 and abs(c[n - 1]) * abs(x) ** (n - 1) < size * mpf(10) ** -45:
        n -= 1
    return c[:n]


def flight(epsilon, q, v, g, h, odd):
    """Phi and g = (1 - f)/epsilon from an impact on: Phi'' = q epsilon Phi + g - (2/epsilon if odd), g'' = 1 - epsilon g."""
    forcing = [g, h, 1 - epsilon * g]
    while len(forcing) < TERMS:
        forcing.append(-epsilon * forcing[-2])
    phi = [mpc(0), v]
    for k in range(TERMS - 2):
        phi.append(q * epsilon * phi[k] + forcing[k] - (2 / epsilon if odd and k == 0 else 0))
    return over_factorials(phi), over_factorials(forcing)


def first_guess(n, odd, v, h, c):
    if n == 0:
        return -4 * h
    if odd:
        return -v / c[2]
    roots = mp.polyroots([mp.re(c[k]) for k in (4, 3, 2, 1)], maxsteps=200, extraprec=100)
    return min(mp.re(z) for z in roots if abs(mp.im(z)) < 1e-20 and mp.re(z) > 0)


def chattering_time(epsilon, omega, eta, pairs, known):
    q, v, g, h, time = 1 / omega**2, mpc(0), mpc(0), -mp.sqrt(2 + epsilon), mpc(0)
    durations, row = [], []
    for n in range(2 * pairs):
        odd = n % 2 == 1
        c, of_forcing = flight(epsilon, q, v, g, h, odd)
        d = known[n] if known else first_guess(n, odd, v, h, c)
        deflated = shortened(c[3 if n == 0 else 1 :], 1.2 * d)
        for _ in range(60):
            step = value(deflated, d) / slope(deflated, d)
            d -= step
            if abs(step) < abs(d) * mpf(10) ** -25:
                break
        else:
            raise ArithmeticError("Newton's method does not converge")
        d -= value(deflated, d) / slope(deflated, d)
        durations.append(d)
        v, time = eta * slope(c, d), time + d
        g, h = value(of_forcing, d), slope(of_forcing, d)
        if odd:
            new, power = [time], mpf(1)
            for old in row[:24]:
                power *= eta * eta
                new.append(new[-1] + power / (1 - power) * (new[-1] - old))
            row = new
    return row[-1], durations


def main(omega, eta, radius, points, pairs, orders):
    values, known = [], None
    # The other half of the circle is the conjugate.
    for j in range(points // 2 + 1):
        epsilon = radius * mp.expj(2 * mp.pi * j / points)
        at, known = chattering_time(epsilon, omega, eta, pairs, known)
        values.append(at)
    for k in range(orders):
        total = mp.re(values[0]) + mp.re(values[-1]) * (-1) ** k
        for j in range(1, points // 2):
            total += 2 * mp.re(values[j] * mp.expj(-2 * mp.pi * j * k / points))
        print(f"{mp.nstr(omega, 4)},{mp.nstr(eta, 4)},{k},{mp.nstr(total / points / radius**k, 24)}", flush=True)


if __name__ == "__main__":
    # eta is the double nearest to what is written; the radius need not be.
    numbers = [mpf(float(text)) for text in sys.argv[1:4]]
    main(*numbers, *map(int, sys.argv[4:7]))
