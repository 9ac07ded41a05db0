"""Simulators to be put under the gate, honest and not."""

import math
import os
import sys
from typing import Any

import numpy as np

import chattercheck as cc


def histories(case: cc.Case, oracle: str) -> dict[str, Any]:
    """Those of an oracle, with what it claims: any error where it claims nothing."""
    if case.model != "linear":
        raise cc.Decline("another model", f"this one is for slender blocks, not for alpha = {case.alpha}")
    found = cc.impacts(None, case.omega, case.eta, epsilon=case.epsilon, impacts=case.impacts, until=case.until, oracle=oracle)
    off = {"time": found.time_uncertainty, "interval": found.interval_uncertainty, "velocity": found.velocity_uncertainty}
    claim = {name: np.nan_to_num(of, nan=np.inf) for name, of in off.items()}
    return {"time": found.time, "interval": found.interval, "velocity": found.velocity, "ending": str(found.ending), "claim": claim}


def honest(case: cc.Case) -> dict[str, Any]:
    """Another method than that of the oracle that stands beside it, with its claims."""
    return histories(case, "ode/linear/tsit45")


def granted(case: cc.Case) -> dict[str, Any]:
    """One that claims nothing."""
    answer = histories(case, "closed-form")
    del answer["claim"]
    return answer


def wrong(case: cc.Case) -> dict[str, Any]:
    """It forgets the restitution in what it reports."""
    answer = granted(case)
    return {**answer, "velocity": answer["velocity"] / case.eta}


def sometimes(case: cc.Case) -> dict[str, Any]:
    """Wrong where little is lost at an impact."""
    return wrong(case) if case.eta > 0.97 else granted(case)


def raises(case: cc.Case) -> dict[str, Any]:
    raise ArithmeticError("no root")


def nothing(case: cc.Case) -> dict[str, Any]:
    return None  # type: ignore[return-value]


def prints(case: cc.Case) -> dict[str, Any]:
    print('{"seq": 1}')
    os.write(1, b"from C\n")
    return granted(case)


def hangs(case: cc.Case) -> dict[str, Any]:
    while True:
        pass


def recurses(case: cc.Case) -> dict[str, Any]:
    return recurses(case)


def leaves(case: cc.Case) -> dict[str, Any]:
    sys.exit(3)


def crashes(case: cc.Case) -> dict[str, Any]:
    os.abort()


def nonsense(case: cc.Case) -> dict[str, Any]:
    return {"time": [math.nan], "velocity": "fast", "ending": "well"}


def slip(case: cc.Case) -> dict[str, Any]:
    return {**granted(case), "intervals": []}
