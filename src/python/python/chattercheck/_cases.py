"""Dimensionless cases, one or many."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import inf
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._numbers import Floats, number, outward, together, whole

_ENDINGS = np.array(_native.ENDINGS)


class Chattering(NamedTuple):
    """When blocks come to rest. Arrays of the shape that the parameters broadcast to; numbers where all of them are numbers."""

    #: The chattering time, from the beginning of rocking to rest, in ``1/p``; nan where there is none, or nothing is known of it.
    tau_ch: Any
    #: The largest error that is claimed for it, absolute; nan where ``tau_ch`` is.
    uncertainty: Any
    #: How it ends: ``at-rest`` (complete chattering), ``incomplete``, ``overturned``, ``never-rocks``, ``limit-reached``, ``lost``, ``unsure`` (the method
    #: claims nothing for its answer) or ``declined`` (the method can't do the case).
    ending: Any
    #: How many impacts were resolved.
    impacts: Any


def _asked(
    a: Any, epsilon: Any, normalisation: str | None, oracle: str | None, impacts: int | None, until: float | None
) -> _native.Asked:
    if (a is None) == (epsilon is None):
        given = "none" if a is None else "both"
        raise ValueError(f"one of a and epsilon is expected, not {given}")
    for name, text in (("normalisation", normalisation), ("oracle", oracle)):
        if text is not None and not isinstance(text, str):
            raise TypeError(f"{name}: a text is expected, not {text!r}")
    if impacts is not None:
        impacts = whole("impacts", impacts)
        if not 1 <= impacts <= 1_000_000:
            raise ValueError(f"impacts = {impacts} is outside the allowed range: 1 <= impacts <= 1000000")
    return {
        "is_epsilon": a is None,
        "normalisation": normalisation,
        "oracle": oracle,
        "impacts": impacts,
        "until": None if until is None else number("until", until),
    }


def _parameters(a: Any, epsilon: Any, omega: Any, eta: Any, alpha: Any) -> tuple[tuple[str, ...], tuple[Any, ...]]:
    names: tuple[str, ...] = ("a" if epsilon is None else "epsilon", "omega", "eta")
    values = (a if epsilon is None else epsilon, omega, eta)
    return (names, values) if alpha is None else ((*names, "alpha"), (*values, alpha))


def chatter(
    a: ArrayLike | None,
    omega: ArrayLike,
    eta: ArrayLike,
    alpha: ArrayLike | None = None,
    *,
    epsilon: ArrayLike | None = None,
    normalisation: str | None = None,
    oracle: str | None = None,
    impacts: int | None = None,
    until: float | None = None,
) -> Chattering:
    """The chattering time: when the infinite sequence of impacts comes to rest (Eqs 73 and 75).

    The ground is a sinusoid that passes the threshold of rocking at ``tau = 0``. Parameters are numbers or arrays, and broadcast.

    Parameters
    ----------
    a
        The amplitude of the ground acceleration over the threshold, ``0 <= a <= 1e9``; rocking starts at 1 (Eq. 1).
    omega
        The frequency ratio ``omega_g/p``, above 0 (Eq. 5).
    eta
        The coefficient of restitution, between 0 and 1 (Eq. 13).
    alpha
        The slenderness in radians, for the block as it is (Eq. 2); without, the slender block (Eq. 4).
    epsilon
        ``a - 1`` in place of ``a``, which is then None, without the rounding of ``a`` (Eq. 14).
    normalisation
        What ``a`` is a multiple of, together with ``alpha``: ``"threshold"``, g tan(alpha), or ``"slender"``, g alpha.
    oracle
        The name of an oracle, as ``chattercheck oracles`` lists them; the one that steps fastest unless given.
    impacts
        Close the sum after so many impacts; as many as sharpen the answer unless given.
    until
        Follow the block to this time ``tau``, past half a period.

    Returns
    -------
    Chattering
        ``tau_ch``, ``uncertainty``, ``ending`` and ``impacts``.

    Raises
    ------
    ValueError
        When a parameter is out of its range: the line of the command, with the index of the element; when shapes can't be broadcast together.
    TypeError
        When a parameter is no number.
    """
    asked = _asked(a, epsilon, normalisation, oracle, impacts, until)
    names, values = _parameters(a, epsilon, omega, eta, alpha)
    if all(type(value) is float or type(value) is int for value in values):
        row = [number(name, value) for name, value in zip(names, values)]
        first, second, third, *rest = row
        time, off, ending, listed = _native.chatter_one((first, second, third, rest[0] if rest else 0.0), bool(rest), asked)
        return Chattering(time, off, _native.ENDINGS[ending], listed)
    arrays = together(names, values)
    shape = arrays[0].shape
    times, offs, endings, many = _native.chatter(arrays, asked)
    columns = (times, offs, _ENDINGS[endings], many)
    # Of arrays without dimensions too, numbers.
    return Chattering(*(column.reshape(shape)[()] for column in columns))


@dataclass(frozen=True, eq=False)
class Impacts:
    """Impacts of ``n`` cases, one case after another: those of case ``k``, counted in the order of C, are at ``offsets[k]:offsets[k + 1]``."""

    #: Shape (n + 1,).
    offsets: NDArray[np.int64]
    #: When each is, ``tau`` since rocking began; shape (offsets[-1],), as those that follow.
    time: Floats
    #: The interval since the one before, which keeps its digits where those of the times are lost.
    interval: Floats
    #: ``phi'`` just after it.
    velocity: Floats
    #: The largest error claimed: of the time, absolute; nan where nothing is claimed.
    time_uncertainty: Floats
    #: Of the interval, relative.
    interval_uncertainty: Floats
    #: Of the velocity, relative.
    velocity_uncertainty: Floats
    #: How each case ends, as in :class:`Chattering`; of the shape that the parameters broadcast to.
    ending: NDArray[np.str_]

    def of(self, case: int) -> slice:
        """Where the impacts of a case are, counted in the order of C."""
        many = len(self.offsets) - 1
        if not -many <= case < many:
            raise IndexError(f"case {case} of {many}")
        case %= many
        return slice(int(self.offsets[case]), int(self.offsets[case + 1]))

    def __repr__(self) -> str:
        return f"Impacts({len(self.time)} impacts of {len(self.offsets) - 1} cases)"


def impacts(
    a: ArrayLike | None,
    omega: ArrayLike,
    eta: ArrayLike,
    alpha: ArrayLike | None = None,
    *,
    epsilon: ArrayLike | None = None,
    normalisation: str | None = None,
    oracle: str | None = None,
    impacts: int = 60,
    until: float | None = None,
) -> Impacts:
    """The impacts of cases, ``impacts`` of each at the most, as flat arrays with offsets. The other parameters are those of :func:`chatter`."""
    asked = _asked(a, epsilon, normalisation, oracle, impacts, until)
    arrays = together(*_parameters(a, epsilon, omega, eta, alpha))
    found = _native.impacts(arrays, asked)
    ending = _ENDINGS[found.pop("endings")].reshape(arrays[0].shape)
    return Impacts(ending=ending, **found)


class CriticalAmplitude(NamedTuple):
    """The amplitude below which chattering is complete and above which it is not, of the slender block; arrays where the parameters are."""

    #: ``a_cr``.
    a_cr: Any
    #: At this amplitude chattering is proven to be complete.
    lower: Any
    #: At this one it is proven to be incomplete.
    upper: Any
    #: ``beta`` of ``1 - tau_ch/(T/2) ~ K (a_cr - a)^beta``.
    exponent: Any
    #: What the fit of Eq. 76 gives.
    eq76: Any
    #: What that of Eq. 77 gives.
    eq77: Any


def critical_amplitude(omega: ArrayLike, eta: ArrayLike) -> CriticalAmplitude:
    """The critical amplitude ``a_cr`` of the slender block (Eq. 4), proven from both sides.

    ``omega``, 0.1 to 100, and ``eta``, 0.1 to 0.98, are numbers or arrays, and broadcast. Seconds each for ``eta`` near 0.97.

    Raises ValueError with the line of the command where one is out of range, TypeError where one is no number.
    """
    omegas, etas = together(("omega", "eta"), (omega, eta))
    rows = [_critical(float(one), float(other)) for one, other in zip(omegas.flat, etas.flat)]
    columns = np.array(rows, dtype=np.float64).reshape(-1, 6).T
    if omegas.ndim == 0:
        return CriticalAmplitude(*rows[0])
    return CriticalAmplitude(*(column.reshape(omegas.shape) for column in columns))


def _critical(omega: float, eta: float) -> tuple[float, float, float, float, float, float]:
    a_cr, exponent, eq76, eq77, lower, upper = _native.critical_amplitude(omega, eta)
    below, above = float(lower), float(upper)
    # A decimal is rounded to a double: to the side on which it is still proven.
    below = outward(below, -inf) if Fraction(below) > Fraction(lower) else below
    above = outward(above, inf) if Fraction(above) < Fraction(upper) else above
    return a_cr, below, above, exponent, eq76, eq77
