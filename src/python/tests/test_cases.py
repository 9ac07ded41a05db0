"""Cases in arrays: the answers are those of the program, and what is known of them."""

import math
from typing import Any

import numpy as np
import pytest

import chattercheck as cc

from conftest import Program

CASES = [(1.03, 2.0, 0.92), (1.01, 1.0, 0.85), (1.2, 3.0, 0.5), (1.1225, 2.0, 0.6), (0.9, 2.0, 0.9), (1.3, 2.0, 0.9)]


def flags(a: float, omega: float, eta: float) -> list[str]:
    return ["--a", repr(a), "--omega", repr(omega), "--eta", repr(eta)]


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("alpha", [None, 0.2])
def test_chattering_times_are_those_of_the_program(program: Program, case: tuple[float, float, float], alpha: float | None) -> None:
    more = [] if alpha is None else ["--alpha", repr(alpha)]
    told = program("chattering-time", *flags(*case), *more, "--format", "json")
    found = cc.chatter(*case, alpha)
    of_program = [math.nan if told[name] is None else told[name] for name in ("tau_ch", "uncertainty")]
    np.testing.assert_equal([found.tau_ch, found.uncertainty], of_program)
    assert (found.ending == "at-rest") == bool(told["complete"])
    assert (found.ending != "never-rocks") == told["rocks"]
    assert found.impacts == told["impacts"]


def test_arrays_broadcast_and_are_as_one_by_one() -> None:
    a, eta = np.linspace(0.99, 1.1, 7), np.array([[0.6], [0.8], [0.9]])
    found = cc.chatter(a, 2, eta)
    assert found.tau_ch.shape == found.uncertainty.shape == found.ending.shape == found.impacts.shape == (3, 7)
    for (row, column), time in np.ndenumerate(found.tau_ch):
        one = cc.chatter(float(a[column]), 2, float(eta[row, 0]))
        np.testing.assert_equal((time, found.ending[row, column]), (one.tau_ch, one.ending))
    assert {"at-rest", "incomplete", "never-rocks"} == set(found.ending.ravel())
    assert np.array_equal(np.isnan(found.tau_ch), np.isnan(found.uncertainty))
    assert np.array_equal(np.isnan(found.tau_ch), found.ending != "at-rest")


def test_the_uncertainty_holds_against_proven_bounds(program: Program) -> None:
    for case in CASES[:3]:
        told = program("chattering-time", *flags(*case), "--oracle", "enclosure", "--digits", "30", "--format", "json")
        found = cc.chatter(*case)
        if told["tau_ch"] is not None:
            assert float(told["lower"]) - found.uncertainty <= found.tau_ch <= float(told["upper"]) + found.uncertainty


def test_epsilon_keeps_what_a_loses() -> None:
    found = cc.chatter(None, 2, 0.6, epsilon=[1e-20, 1e-3])
    assert list(found.ending) == ["at-rest", "at-rest"]
    assert 0 < found.tau_ch[0] < 1e-9
    assert found.tau_ch[1] == cc.chatter(None, 2, 0.6, epsilon=1e-3).tau_ch


def test_impacts_are_flat_with_offsets(program: Program) -> None:
    found = cc.impacts([1.03, 0.9, 1.02], 2, [0.92, 0.92, 0.8], impacts=20)
    assert list(found.offsets) == [0, 20, 20, 40]
    assert list(found.ending) == ["limit-reached", "never-rocks", "at-rest"]
    told = program("simulate", *flags(1.03, 2, 0.92), "--impacts", "20", "--format", "json")["impacts"][1:]
    assert list(found.time[found.of(0)]) == [row["tau"] for row in told]
    assert list(found.interval[found.of(0)]) == [row["interval"] for row in told]
    assert list(found.velocity[found.of(0)]) == [row["velocity"] for row in told]
    assert list(found.time_uncertainty[found.of(0)]) == [row["tau_uncertainty"] for row in told]
    assert list(found.interval_uncertainty[found.of(0)]) == [row["interval_uncertainty"] for row in told]
    assert found.time[found.of(-1)].shape == (20,)
    assert cc.impacts(1.03, 2, 0.92).time.shape == (60,)
    with pytest.raises(IndexError):
        found.of(3)


@pytest.mark.parametrize("oracle", ["ode/linear/bdf", "asymptotic/order-16", "enclosure", "accumulation"])
def test_other_oracles_agree_to_within_what_they_claim(oracle: str) -> None:
    one, other = cc.chatter([1.01, 1.02], 2, 0.85), cc.chatter([1.01, 1.02], 2, 0.85, oracle=oracle)
    assert np.all(np.abs(one.tau_ch - other.tau_ch) <= one.uncertainty + other.uncertainty)


def test_what_an_oracle_cannot_do_is_declined() -> None:
    found = cc.chatter([1.01, 5.0], 2, 0.85, oracle="asymptotic/order-16")
    assert list(found.ending) == ["at-rest", "declined"]
    assert np.isnan(found.tau_ch[1]) and np.isnan(found.uncertainty[1])


def test_the_critical_amplitude_is_that_of_the_program(program: Program) -> None:
    found = cc.critical_amplitude(2, 0.6)
    told = program("critical-amplitude", "--omega", "2", "--eta", "0.6", "--format", "json")
    assert [found.a_cr, found.exponent, found.eq76, found.eq77] == [told[name] for name in ("a_cr", "exponent", "eq76", "eq77")]
    assert isinstance(found.a_cr, float)
    assert found.lower < found.a_cr < found.upper
    assert cc.chatter(found.lower, 2, 0.6).ending == "at-rest"
    assert cc.chatter(found.upper, 2, 0.6).ending == "incomplete"
    both = cc.critical_amplitude([2, 1], [[0.6], [0.5]])
    assert both.a_cr.shape == (2, 2) and both.a_cr[0, 0] == found.a_cr


@pytest.mark.parametrize(
    ("words", "call"),
    [
        (["--a", "-1", "--omega", "2", "--eta", "0.9"], lambda: cc.chatter(-1, 2, 0.9)),
        (["--a", "1.1", "--omega", "0", "--eta", "0.9"], lambda: cc.chatter(1.1, 0, 0.9)),
        (["--a", "1.1", "--omega", "2", "--eta", "1.5"], lambda: cc.chatter(1.1, 2, 1.5)),
        (["--a", "1.1", "--omega", "2", "--eta", "nan"], lambda: cc.chatter(1.1, 2, math.nan)),
        (["--epsilon", "-2.5", "--omega", "2", "--eta", ".9"], lambda: cc.chatter(None, 2, 0.9, epsilon=-2.5)),
        (["--a", "1.1", "--omega", "2", "--eta", ".9", "--alpha", "1.75"], lambda: cc.chatter(1.1, 2, 0.9, 1.75)),
        (["--a", "1.1", "--omega", "2", "--eta", ".9", "--until", "-1.5"], lambda: cc.chatter(1.1, 2, 0.9, until=-1.5)),
        (["--a", "1.1", "--omega", "2", "--eta", ".9", "--oracle", "ode/linear/foo"], lambda: cc.chatter(1.1, 2, 0.9, oracle="ode/linear/foo")),
    ],
)
def test_an_error_is_the_line_of_the_command(program: Program, words: list[str], call: Any) -> None:
    with pytest.raises(ValueError) as caught:
        call()
    told = program("chattering-time", *words)
    # The command shows a value as it was typed: -1, and not -1.0.
    assert str(caught.value).replace(".0 is", " is") in told.replace(".0 is", " is")
