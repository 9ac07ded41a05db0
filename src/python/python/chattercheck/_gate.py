"""The gate, for a simulator that is a function of Python."""

from __future__ import annotations

import html
import importlib.util
import os
import re
import sys
import tempfile
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import Any

from . import _native
from ._scene import toml


class Decline(Exception):
    """Raised by a simulator that can't do a case: a refusal, which is counted, and no failure. The reason in a word or two, without numbers; then why."""

    def __init__(self, reason: str, why: str = "") -> None:
        super().__init__(reason, why)
        self.reason, self.why = reason, why


class EngineError(RuntimeError):
    """A simulator that can't even be started."""


@dataclass(frozen=True)
class Case:
    """What a simulator is asked. The ground acceleration, over that at which the block begins to rock, is ``a sin(omega tau + psi)`` with ``sin psi = 1/a``: at
    ``tau = 0`` it has just reached the threshold, and grows (Eq. 12). The first flight is to the negative side."""

    #: ``"linear"`` (Eq. 4) or ``"nonlinear"`` (Eq. 2).
    model: str
    #: ``a - 1``, without the rounding of ``a``.
    epsilon: float
    #: ``omega_g/p``.
    omega: float
    #: The coefficient of restitution.
    eta: float
    #: The slenderness in radians; None for the slender block.
    alpha: float | None
    #: What ``a`` is a multiple of: ``"threshold"``, g tan(alpha), or ``"slender"``, g alpha.
    normalisation: str
    #: List so many impacts at the most.
    impacts: int
    #: Follow the block to this time; None for half a period.
    until: float | None

    @property
    def a(self) -> float:
        """The amplitude."""
        return 1 + self.epsilon

    @property
    def end(self) -> float:
        """The time to which the block is followed."""
        return pi / self.omega if self.until is None else self.until


#: A simulator: takes a case, and returns a dictionary with ``time`` and ``velocity`` (just after each impact), ``ending`` and, where it knows them, ``interval``,
#: ``tau_ch`` and ``claim``.
Engine = Callable[[Case], Mapping[str, Any]]


@dataclass(frozen=True)
class Finding:
    """One thing that is wrong."""

    #: Its class: ``interval``, ``velocity``, ``impact-time``, ``interval-ratio``, ``chattering-time``, ``ending``, a law, or how the simulator broke.
    kind: str
    #: The name of the case.
    case: str
    #: In words.
    text: str
    #: The first impact that is wrong; 0 for the history as a whole.
    impact: int


class Report:
    """What a run under the gate found."""

    def __init__(self, found: Mapping[str, Any]) -> None:
        #: Whether nothing is wrong.
        self.ok: bool = found["ok"]
        #: In one sentence.
        self.headline: str = found["headline"]
        #: What is wrong, case by case.
        self.findings: list[Finding] = [Finding(*of) for of in found["findings"]]
        #: What the run as a whole fails to prove.
        self.shortfalls: list[str] = found["shortfalls"]
        #: Failures that are known: what, in how many cases, and whether the entry is out of date, which turns the run red.
        self.known: list[tuple[str, int, bool]] = found["known"]
        #: The whole page, which needs no other file.
        self.html: str = found["page"]
        #: The report of ``chattercheck verify --json``.
        self.json: str = found["json"]
        self._text: str = found["text"]
        self._explanation: list[str] = found["explanation"]

    def explain(self) -> str:
        """What mistakes of the catalogue would explain the wrong answers, the best first, and what can be read off the numbers."""
        if self._explanation:
            return "\n".join(self._explanation)
        return "nothing is wrong" if not self.findings else "only breakdowns, or too little to explain"

    def of(self, kind: str) -> list[Finding]:
        """The findings of a class."""
        return [finding for finding in self.findings if finding.kind == kind]

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return self.headline

    def _repr_html_(self) -> str:
        page = html.escape(self.html, quote=True)
        return f'<iframe title="chattercheck" sandbox="allow-scripts" srcdoc="{page}" style="width: 100%; height: 40em; border: 0"></iframe>'


def verify(
    engine: Engine,
    cases: int = 200,
    *,
    seed: int = 1,
    name: str | None = None,
    model: str = "linear",
    normalisation: str = "threshold",
    tolerance: float | Mapping[str, float] | None = None,
    reason: str = "as given to chattercheck.verify",
    claims: bool = False,
    known: Iterable[Mapping[str, Any]] = (),
    case_timeout: float = 10.0,
    start_timeout: float = 60.0,
    processes: int = 1,
    restarts: int = 20,
    may_decline: float = 0.5,
    never_at_rest: bool = False,
    judge_every: int = 10,
) -> Report:
    """Puts a simulator under the gate: listed, edge, spaced and ``cases`` random cases, beside the oracle that steps fastest and under a judge with proven bounds.

    The simulator runs in a process of its own: one that raises, returns nonsense, prints, hangs, recurses or crashes is a finding, and does no harm.

    Parameters
    ----------
    engine
        A function of a :class:`Case`. It returns a dictionary: ``time`` and ``velocity`` (just after each impact, with its sign), arrays of shape (n,);
        ``ending``: ``"at-rest"``, ``"incomplete"``, ``"never-rocks"``, ``"overturned"`` or ``"limit-reached"``; and, where it knows them, ``interval``, ``tau_ch``,
        and ``claim``, its own errors. It raises :class:`Decline` for what it can't do.
    tolerance
        The errors that are granted to it where it claims none: of ``time`` and ``tau-ch``, absolute, and of ``interval`` and ``velocity``, relative; one number
        for all. More is granted where a case is ill-conditioned. Without, every rounding counts as wrong.
    claims
        Whether it claims errors of its own, with ``claim``: of ``time`` (absolute), ``interval`` and ``velocity`` (relative), each a number or an array of shape (n,),
        and ``tau_ch`` (absolute).
    known
        Failures that are known, each a dictionary: ``class``, ``reason`` and, where it has to be, ``where`` with ranges, as ``{"eta": (0.97, 1.0)}``. Strict: one
        that fails no more is an error.
    case_timeout, start_timeout
        Seconds.
    processes
        How many of it run side by side.

    Returns
    -------
    Report
        With ``ok``, ``findings``, ``explain()``; a notebook shows its page.

    Raises
    ------
    ValueError, TypeError
        When a parameter is wrong.
    EngineError
        When the simulator does not start.
    """
    if not callable(engine):
        raise TypeError(f"engine: a function of a case is expected, not {type(engine).__name__}")
    for field, value in (("cases", cases), ("seed", seed), ("judge_every", judge_every)):
        if isinstance(value, bool) or not isinstance(value, int):
            raise TypeError(f"{field}: a whole number is expected, not {value!r}")
        if not 0 <= value < 2**64:
            raise ValueError(f"{field} = {value} is outside the allowed range: a whole number from 0 on")
    for field, seconds in (("case_timeout", case_timeout), ("start_timeout", start_timeout)):
        if not isinstance(seconds, (int, float)):
            raise TypeError(f"{field}: a number of seconds is expected, not {seconds!r}")
    called = name if name is not None else _name_of(engine)
    granted: dict[str, Any] | None = None
    if tolerance is not None:
        granted = dict(tolerance) if isinstance(tolerance, Mapping) else dict.fromkeys(_GRANTED, tolerance)
        granted = {"tau-ch" if field == "tau_ch" else field: float(of) for field, of in granted.items()}
        granted["reason"] = reason
    with tempfile.TemporaryDirectory(prefix="chattercheck-") as folder:
        payload = Path(folder, "engine.pickle")
        payload.write_bytes(_pickled(engine))
        fields = {
            "name": called,
            "run": [sys.executable, "-m", "chattercheck._serve", str(payload), "claims" if claims else ""],
            "environment": {"PYTHONPATH": os.pathsep.join(os.path.abspath(path) for path in sys.path)},
            "model": model,
            "normalisation": normalisation,
            "case-timeout": float(case_timeout),
            "start-timeout": float(start_timeout),
            "processes": processes,
            "restarts": restarts,
            "may-decline": float(may_decline),
            "never-at-rest": never_at_rest,
            "tolerance": granted,
            "known": [_known(entry) for entry in known],
        }
        lines = [f"{field} = {toml(of)}" for field, of in fields.items() if of is not None]
        manifest = "\n".join(["[[engine]]", *lines, ""])
        try:
            return Report(_native.verify(manifest, cases, seed, judge_every))
        except RuntimeError as error:
            raise EngineError(str(error)) from None
        except ValueError as error:
            # Nobody wrote the file of which this is a line.
            raise ValueError(re.sub(r"^engine: (line \d+: )?", "", str(error))) from None


_GRANTED = ("time", "interval", "velocity", "tau-ch")


def _known(entry: Mapping[str, Any]) -> dict[str, Any]:
    if not isinstance(entry, Mapping):
        raise TypeError(f"known: dictionaries with class, reason and where are expected, not {entry!r}")
    where = {field: [float(bound) for bound in of] for field, of in dict(entry.get("where", {})).items()}
    return {**entry, "where": where}


def _name_of(engine: Engine) -> str:
    name = getattr(engine, "__name__", type(engine).__name__)
    return re.sub(r"[^\w.+-]", "-", name)[:60].strip("-") or "engine"


def _pickled(engine: Engine) -> bytes:
    """The simulator as it is sent to a process of its own. What a new process can't import goes by value."""
    import cloudpickle

    module = sys.modules.get(getattr(engine, "__module__", None) or "")
    by_value = module is not None and module.__name__ != "__main__" and not _is_found(module.__name__)
    try:
        if by_value:
            cloudpickle.register_pickle_by_value(module)
        try:
            sent: bytes = cloudpickle.dumps(engine)
            return sent
        finally:
            if by_value:
                cloudpickle.unregister_pickle_by_value(module)
    except Exception as error:
        raise ValueError(f"engine: it can't be sent to a process of its own: {type(error).__name__}: {error}") from None


def _is_found(module: str) -> bool:
    try:
        spec = importlib.util.find_spec(module)
    except (ImportError, ValueError):
        return False
    if spec is None or spec.origin is None:
        return False
    # Found by the paths, and not only because it is loaded.
    top = module.partition(".")[0]
    from importlib.machinery import PathFinder

    return PathFinder.find_spec(top, [os.path.abspath(path) for path in sys.path]) is not None
