"""Whole responses of a block to a motion of the ground."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._numbers import Floats, number, refused, seconds, seconds_off, whole
from ._scene import Block, GroundMotion, scene

_STATES = np.array(["rest", "rocking", "overturned", "lying"])
_STATUS = {"at-rest": 0, "rocking": 0, "overturned": 1, "lying": 1}


@dataclass(frozen=True)
class Bout:
    """Rocking from rest to rest; times in seconds."""

    #: When it begins.
    start: float
    #: When it ends.
    end: float
    #: The largest error that is expected of ``end``; nan where nothing is known of it, which the ending ``unsure`` says too.
    uncertainty: float
    #: How many impacts are resolved; infinitely many follow where the ending is ``complete``.
    impacts: int
    #: ``complete``, ``overturned``, ``rocking`` (the response ends), ``too-many-impacts``, ``lost`` or ``unsure``.
    ending: str


@dataclass(frozen=True, eq=False)
class Response:
    """What a block does, in the manner of SciPy's ``solve_ivp``. Times are in seconds, angles in radians."""

    #: Times, never decreasing: at an impact there are two of the same, just before and just after it; shape (n,), as those that follow.
    t: Floats
    #: The rotation, with its sign; it overturns where it passes ``alpha`` for good.
    theta: Floats
    #: The angular velocity, rad/s.
    velocity: Floats
    #: The acceleration of the ground, in g.
    acceleration: Floats
    #: ``rest``, ``rocking``, ``overturned`` or ``lying``.
    state: NDArray[np.str_]
    #: When the block hits its base, as far as the impacts are resolved; shape (m,).
    t_events: Floats
    #: The interval before each of these, since the last one or since the block began to rock.
    intervals: Floats
    #: The angular velocity just after each of them, rad/s.
    velocity_events: Floats
    #: The times of rocking, in order.
    bouts: tuple[Bout, ...]
    #: When the block rests: from and to; shape (k, 2).
    rests: Floats
    #: The largest error that is expected of the beginning of each rest; nan where nothing is known; shape (k,).
    rest_uncertainty: Floats
    #: When the response ends.
    end: float
    #: 0: it is known to its end; 1: the block overturns; -1: somewhere nothing is known of it any more.
    status: int
    #: What happens in the end, in words.
    message: str
    #: The account of the command ``response``: seconds, degrees and g.
    summary: dict[str, Any]
    #: ``p``, 1/s: ``tau = p t``.
    frequency_parameter: float
    #: ``alpha``, radians: ``phi = theta/alpha``.
    alpha: float
    #: By whose flights.
    oracle: str
    _told: tuple[tuple[str, str], ...]

    @property
    def success(self) -> bool:
        """Whether it is known to its end."""
        return self.status >= 0

    @property
    def events(self) -> Floats:
        """The impact times, as :attr:`t_events`."""
        return self.t_events

    @property
    def tau(self) -> Floats:
        """The times in ``1/p``."""
        return self.t * self.frequency_parameter

    @property
    def phi(self) -> Floats:
        """The rotation over ``alpha``."""
        return self.theta / self.alpha

    def __repr__(self) -> str:
        return "\n".join(f"{name:>18}: {what}" for name, what in (*self._told, ("oracle", self.oracle)))


def rock(
    block: Block,
    motion: GroundMotion,
    t_span: tuple[float, float] | None = None,
    *,
    model: str = "nonlinear",
    rotation: float = 0.0,
    velocity: float = 0.0,
    steps: int = 1000,
    oracle: str | None = None,
) -> Response:
    """The response of a block from the start of the motion: rest, rocking, chattering into rest, rocking again, free rocking, overturning.

    Parameters
    ----------
    t_span
        From and to, in seconds; a motion begins at 0. Unless given the block is followed until it rests after the motion, and a motion without end for 5 cycles.
    model
        ``"nonlinear"``, the block as it is (Eq. 2), or ``"linear"``, the slender block (Eq. 4).
    rotation, velocity
        At the start: the rotation over ``alpha`` and the velocity ``phi'``, both with their signs; at rest unless given.
    steps
        Into how many steps the time is divided; each flight has 9 rows at least.
    oracle
        By whose flights: ``closed-form``, ``ode`` or ``taylor``; the fastest unless given.

    Raises ValueError with the line of the command for what is out of range, TypeError for what is no block, no motion or no number.
    """
    asked = scene(block, motion, model, rotation, velocity)
    p, alpha = asked.frequency_parameter, asked.alpha
    until = None
    if t_span is not None:
        try:
            first, last = t_span
        except (TypeError, ValueError):
            raise ValueError(f"t_span = {t_span!r}: expected is from and to, in seconds") from None
        if number("t_span", first) != 0:
            raise refused("t_span", t_span, "from 0, where the motion begins, to a time above")
        until = number("t_span", last) * p
    found = _native.rock(asked, until, whole("steps", steps), oracle)
    bouts = tuple(
        Bout(seconds(start, p), seconds(end, p), float(seconds_off(off, end, p)), many, ending)
        for start, end, off, many, ending, _ in found["bouts"]
    )
    rests = np.array(found["rests"], dtype=np.float64).reshape(-1, 2)
    ends = {end: off for _, end, off, _, _, _ in found["bouts"]}
    offs = np.array([ends.get(start, 0.0) for start in rests[:, 0]], dtype=np.float64)
    summary = json.loads(found["summary"])
    told: dict[str, str] = dict(found["told"])
    return Response(
        t=seconds(found["tau"], p),
        theta=found["phi"] * alpha,
        velocity=found["phi_velocity"] * (alpha * p),
        acceleration=found["ground"] * asked.threshold,
        state=_STATES[found["state"]],
        t_events=seconds(found["impact_tau"], p),
        intervals=seconds(found["impact_interval"], p),
        velocity_events=found["impact_velocity"] * (alpha * p),
        bouts=bouts,
        rests=seconds(rests, p),
        rest_uncertainty=seconds_off(offs, rests[:, 0], p),
        end=seconds(found["end"], p),
        status=_STATUS.get(summary["ending"], -1),
        message=told.get("in the end", told.get("begins to rock", "")),
        summary=summary,
        frequency_parameter=p,
        alpha=alpha,
        oracle=found["oracle"],
        _told=tuple(found["told"]),
    )
