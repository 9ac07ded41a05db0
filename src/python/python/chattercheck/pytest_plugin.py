"""A simulator under the gate as tests of pytest, one for each class of finding.

::

    @pytest.mark.chattercheck(engine=simulate, cases=200, tolerance=1e-9, known={"ending": "it stops at a velocity"})
    def test_simulate(verdict):
        verdict.check()

The mark takes the parameters of :func:`chattercheck.verify`. ``known`` may name classes with reasons, as here: those tests are expected to fail, and one that passes is
a failure (strict); or it is a list of entries with regimes, as ``verify`` has them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from ._gate import Report

#: What is tested of a simulator. What is of none of the others is of ``laws`` or, where it broke, of ``breakdowns``.
CLASSES = (
    "breakdowns",
    "laws",
    "interval",
    "velocity",
    "impact-time",
    "interval-ratio",
    "chattering-time",
    "ending",
    "shortfalls",
)
_LAWS = (
    "answers",
    "not-lost",
    "form",
    "sign-alternates",
    "time-is-sum",
    "in-time",
    "rest-stays",
    "overturned-stays",
    "time-left",
)
_SHOWN = 5


class Verdict:
    """What the gate says of a simulator in one class."""

    def __init__(self, report: Report, kind: str) -> None:
        #: The whole report.
        self.report = report
        #: The class.
        self.kind = kind

    @property
    def problems(self) -> list[str]:
        """What is wrong in this class."""
        if self.kind == "shortfalls":
            out_of_date = [f"{says}: known to fail, and does not any more" for says, _, old in self.report.known if old]
            return [*self.report.shortfalls, *out_of_date]
        return [f"{of.case}: {of.text}" for of in self.report.findings if class_of(of.kind) == self.kind]

    def check(self) -> None:
        """Fails if something is wrong in this class."""
        __tracebackhide__ = True
        problems = self.problems
        if problems:
            more = [f"and {len(problems) - _SHOWN} more"] if len(problems) > _SHOWN else []
            explained = [] if self.kind in ("breakdowns", "shortfalls") else [self.report.explain()]
            pytest.fail("\n".join([*problems[:_SHOWN], *more, *explained]), pytrace=False)


def class_of(kind: str) -> str:
    """The class of a finding."""
    if kind in CLASSES:
        return kind
    return "laws" if kind in _LAWS else "breakdowns"


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "chattercheck(engine, ...): a simulator under the gate; parameters of chattercheck.verify")


_REPORTS = pytest.StashKey[dict[str, "Report | Exception"]]()


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "verdict" not in metafunc.fixturenames:
        return
    mark = metafunc.definition.get_closest_marker("chattercheck")
    if mark is None or mark.args or "engine" not in mark.kwargs:
        pytest.fail(f"{metafunc.definition.nodeid}: expected is @pytest.mark.chattercheck(engine=.., ..)", pytrace=False)
    known = mark.kwargs.get("known", ())
    reasons: dict[str, str] = dict(known) if isinstance(known, Mapping) else {}
    for name in reasons:
        if name not in CLASSES:
            pytest.fail(f"known: {name!r} is no class; known are {', '.join(CLASSES)}", pytrace=False)
    marks = {name: [pytest.mark.xfail(strict=True, reason=reason)] for name, reason in reasons.items()}
    metafunc.parametrize("verdict", [pytest.param(name, marks=marks.get(name, [])) for name in CLASSES], indirect=True)


@pytest.fixture
def verdict(request: pytest.FixtureRequest) -> Verdict:
    """What the gate says of the simulator of the mark, in one class. The run is made once."""
    mark = request.node.get_closest_marker("chattercheck")
    parameters: dict[str, Any] = dict(mark.kwargs)
    if isinstance(parameters.get("known"), Mapping):
        parameters.pop("known")
    function = request.node.nodeid.partition("[")[0]
    reports = request.config.stash.setdefault(_REPORTS, {})
    if function not in reports:
        import chattercheck

        try:
            reports[function] = chattercheck.verify(**parameters)
        except Exception as error:
            reports[function] = error
    found = reports[function]
    if isinstance(found, Exception):
        raise found
    return Verdict(found, request.param)
