"""When rest was certain, what overturns a block, and which method a scene needs."""

from __future__ import annotations

import json
from dataclasses import dataclass, fields
from math import inf
from typing import Any

from . import _native
from ._numbers import number, outward, seconds, seconds_off
from ._scene import Block, GroundMotion, scene


@dataclass(frozen=True)
class BoutCriterion:
    """What the criterion says of a time of rocking; times in seconds, None where there is nothing to say."""

    #: When it begins and ends.
    start: float
    end: float
    #: How it ends, as in :class:`chattercheck.Bout`.
    ending: str
    #: The impact from which on rest was certain, and when that was.
    certain_from_impact: int | None
    certain_at: float | None
    #: The bounds on the time of rest that hold from then on: proven of the impact as it was found, and wider by what rounding may have done before.
    rest_lower: float | None
    rest_upper: float | None
    #: The first impact from which alone the local series is trusted, when that was, when it says that rest comes, and by how much that may be off.
    predicted_from_impact: int | None
    predicted_at: float | None
    predicted_rest: float | None
    predicted_uncertainty: float | None
    #: When the ground pushes the block off again.
    gap_end: float | None
    #: Whether a gap was missed before: incomplete chattering.
    missed_a_gap: bool


@dataclass(frozen=True)
class Criterion:
    """When it was certain that a block comes to rest."""

    #: For each time of rocking.
    bouts: tuple[BoutCriterion, ...]
    #: The scale of the motion from which on some chattering is incomplete is between these; None where none was found up to ``searched_to``.
    incomplete_lower: float | None
    incomplete_upper: float | None
    searched_to: float
    #: Whether that is proven.
    certified: bool
    #: By whose flights.
    oracle: str


def criterion(
    block: Block,
    motion: GroundMotion,
    *,
    model: str = "nonlinear",
    rotation: float = 0.0,
    velocity: float = 0.0,
    until: float | None = None,
    to_scale: float = 2.0,
    oracle: str | None = None,
) -> Criterion:
    """For each time of rocking: from which impact on rest was certain, when it comes, and when the ground pushes again; and how much stronger the motion has to be, up to
    ``to_scale`` times, for some chattering to be incomplete.

    ``until`` is in seconds; the rest as in :func:`chattercheck.rock`. Raises ValueError with the line of the command.
    """
    asked = scene(block, motion, model, rotation, velocity)
    p = asked.frequency_parameter
    limit = None if until is None else number("until", until) * p
    found = json.loads(_native.criterion(asked, limit, number("to_scale", to_scale), oracle))
    incomplete = found["incomplete"]
    return Criterion(
        bouts=tuple(_bout(row, p) for row in found["bouts"]),
        incomplete_lower=incomplete["lower"],
        incomplete_upper=incomplete["upper"],
        searched_to=incomplete["searched_to"],
        certified=incomplete["certified"],
        oracle=found["oracle"],
    )


def _bout(row: dict[str, Any], p: float) -> BoutCriterion:
    row = {**row, "start": row["from"], "end": row["to"]}
    times = ("start", "end", "certain_at", "predicted_at", "predicted_rest", "gap_end")
    told = {field.name: row[field.name] for field in fields(BoutCriterion)}
    told |= {name: seconds(row[name], p) for name in times if row[name] is not None}
    for name, side in (("rest_lower", -inf), ("rest_upper", inf)):
        if row[name] is not None:
            told[name] = outward(row[name] / p, side)
    if row["predicted_uncertainty"] is not None:
        told["predicted_uncertainty"] = float(seconds_off(row["predicted_uncertainty"], row["predicted_rest"], p))
    return BoutCriterion(**told)


@dataclass(frozen=True)
class Changes:
    """Where something begins to happen as a motion gets stronger, and ceases to."""

    #: The smallest scale from which it happens is between these; None where it does not begin in the range.
    lower: float | None
    upper: float | None
    #: Whether it is proven that it happens at ``upper`` and does not at ``lower``.
    certified: bool
    #: Whether it happens at the smallest scale of the range already.
    happens_at_from: bool
    #: Every change in the range: lower, upper, and whether it happens above.
    changes: tuple[tuple[float, float, bool], ...]


@dataclass(frozen=True)
class Overturning:
    """How much stronger or weaker a motion has to be."""

    #: For the block to overturn.
    overturning: Changes
    #: For some chattering to be incomplete.
    incomplete: Changes
    #: By whose flights.
    oracle: str


def overturning(
    block: Block,
    motion: GroundMotion,
    scales: tuple[float, float] = (0.1, 10.0),
    *,
    model: str = "nonlinear",
    rotation: float = 0.0,
    velocity: float = 0.0,
    oracle: str | None = None,
) -> Overturning:
    """The scales of the motion, in this range, at which the block overturns, and at which some chattering is incomplete.

    400 scales are looked at, and each change that shows is narrowed down to neighbouring doubles; the first is proven where the judge can. The rest as in
    :func:`chattercheck.rock`. Raises ValueError with the line of the command.
    """
    try:
        low, high = scales
    except (TypeError, ValueError):
        raise ValueError(f"scales = {scales!r}: expected is from and to") from None
    asked = scene(block, motion, model, rotation, velocity)
    found = json.loads(_native.overturning(asked, (number("from", low), number("to", high)), oracle))

    def changes(of: dict[str, Any]) -> Changes:
        rows = tuple((row["lower"], row["upper"], row["happens_above"]) for row in of["changes"])
        return Changes(**{**of, "changes": rows})

    return Overturning(changes(found["overturning"]), changes(found["incomplete"]), found["oracle"])


@dataclass(frozen=True)
class Candidate:
    """A method that could answer."""

    #: Its name.
    method: str
    #: The relative error that is predicted of its answer, or was found; None where none is.
    error: float | None
    #: The part of it that comes from another equation of motion.
    model_error: float | None
    #: Its predicted cost; None where both were run.
    cost_microseconds: float | None
    #: Why it can't answer.
    refused: str | None


@dataclass(frozen=True)
class Plan:
    """The cheapest method that is accurate enough."""

    #: Its name.
    chosen: str | None
    candidates: tuple[Candidate, ...]
    #: Of a sinusoid under a block at rest: whether the first rocking ends with rest, how long it lasts, in ``1/p`` and in seconds, and by how much ``tau_ch`` may be off.
    complete: bool | None
    tau_ch: float | None
    seconds: float | None
    uncertainty: float | None
    #: Whether the answer is as accurate as asked.
    meets_tolerance: bool


def plan(block: Block, motion: GroundMotion, tolerance: float = 1e-6, *, model: str = "nonlinear") -> Plan:
    """Which method is enough for a relative tolerance: of a chattering time under a sinusoid, else of when the block rests and how far it turns.

    Raises ValueError with the line of the command.
    """
    found = json.loads(_native.plan(scene(block, motion, model), number("tolerance", tolerance)))
    return Plan(**{**found, "candidates": tuple(Candidate(**row) for row in found["candidates"])})
