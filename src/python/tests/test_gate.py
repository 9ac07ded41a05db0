"""The gate for simulators in Python."""

import json
from pathlib import Path

import pytest
import simulators

import chattercheck as cc


def test_an_honest_simulator_passes() -> None:
    report = cc.verify(simulators.honest, cases=30, claims=True)
    assert report.ok and report.findings == [] and report.shortfalls == [], str(report)
    assert repr(report).startswith("PASS") and "honest" in str(report)
    assert report.explain() == "nothing is wrong"
    assert json.loads(report.json)["verdict"] == "pass"
    assert report._repr_html_().startswith("<iframe") and "&lt;html" in report._repr_html_()


def test_one_that_claims_nothing_passes_by_what_is_granted_to_it() -> None:
    assert cc.verify(simulators.granted, cases=30, tolerance=1e-9).ok
    report = cc.verify(simulators.granted, cases=0, tolerance={"time": 1e-9, "interval": 1e-9, "velocity": 0, "tau_ch": 1e-9})
    assert {finding.kind for finding in report.findings} == {"velocity"}


def test_what_is_wrong_is_found_and_explained() -> None:
    report = cc.verify(simulators.wrong, cases=0, tolerance=1e-9)
    assert not report.ok and len(report.of("velocity")) > 20
    first = report.of("velocity")[0]
    assert first.impact == 1 and "WRONG on velocity" in first.text
    assert "velocity" in report.explain() or "restitution" in report.explain()


def test_a_function_of_here_can_be_sent() -> None:
    scale = 1.0

    def inner(case: cc.Case) -> object:
        answer = simulators.granted(case)
        return {**answer, "time": answer["time"] * scale}

    assert cc.verify(inner, cases=0, tolerance=1e-9).ok  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("simulator", "kind", "said"),
    [
        (simulators.raises, "error reported by the engine", "ArithmeticError: no root"),
        (simulators.nothing, "error reported by the engine", "returned None"),
        (simulators.nonsense, "error reported by the engine", "'velocity' is 'fast'"),
        (simulators.slip, "error reported by the engine", "'intervals'; known are"),
        (simulators.recurses, "error reported by the engine", "RecursionError"),
        (simulators.leaves, "error reported by the engine", "SystemExit: 3"),
        (simulators.hangs, "timed out", "no answer in 0.2 s"),
        (simulators.crashes, "crashed", "SIGABRT"),
    ],
)
def test_one_that_breaks_is_a_finding(simulator: cc._gate.Engine, kind: str, said: str) -> None:
    report = cc.verify(simulator, cases=0, case_timeout=0.2, restarts=1)
    assert not report.ok
    assert kind in {finding.kind for finding in report.findings}
    assert said in report.of(kind)[0].text


def test_what_it_prints_does_no_harm() -> None:
    assert cc.verify(simulators.prints, cases=0, tolerance=1e-9).ok


def test_one_that_does_not_start_is_an_error() -> None:
    class Engine:
        def __reduce__(self) -> tuple[object, ...]:
            return (eval, ("1/0",))

        def __call__(self, case: cc.Case) -> dict[str, object]:
            return {}

    with pytest.raises(cc.EngineError, match="ZeroDivisionError"):
        cc.verify(Engine())


def test_known_failures_are_strict() -> None:
    known = [{"class": "velocity", "where": {"eta": (0.97, 1)}, "reason": "it reports the speed before the impact"}]
    report = cc.verify(simulators.sometimes, cases=30, tolerance=1e-9, known=known)
    assert report.ok and report.known[0][1] > 20, str(report)
    report = cc.verify(simulators.honest, cases=30, claims=True, known=known)
    assert not report.ok and report.known[0][2]


TESTS = """
    import pytest, simulators

    @pytest.mark.chattercheck(engine=simulators.nothing, cases=0, known={known})
    def test_gate(verdict):
        verdict.check()
"""


def test_the_plugin_gives_a_test_for_each_class(pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(Path(__file__).parent))
    pytester.makepyfile(TESTS.format(known={}))
    found = pytester.runpytest_inprocess("-p", "no:cacheprovider")
    outcomes = found.parseoutcomes()
    assert outcomes["failed"] >= 2 and outcomes["passed"] + outcomes["failed"] == 9
    found.stdout.fnmatch_lines(["*test_gate?breakdowns?*"])
    failing = [line for line in found.outlines if line.startswith("FAILED")]
    names = {line.split("[")[1].split("]")[0] for line in failing}
    pytester.makepyfile(TESTS.format(known={name: "known" for name in names}))
    again = pytester.runpytest_inprocess("-p", "no:cacheprovider").parseoutcomes()
    assert again == {"passed": 9 - len(names), "xfailed": len(names)}
    pytester.makepyfile(TESTS.format(known={**{name: "known" for name in names}, "laws": "none"}))
    strict = pytester.runpytest_inprocess("-p", "no:cacheprovider").parseoutcomes()
    assert strict["failed"] == 1
