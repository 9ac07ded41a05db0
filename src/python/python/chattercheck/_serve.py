"""Serves a function of Python as an engine: reads questions, a JSON object a line, and writes answers. It is started by :func:`chattercheck.verify`."""

import json
import math
import os
import platform
import sys
import time
import traceback
from collections.abc import Callable, Mapping
from typing import Any

_COLUMNS = ("time", "interval", "velocity")
_FIELDS = (*_COLUMNS, "ending", "tau_ch", "claim")
_NEEDED = ("time", "velocity", "ending")


def _number(value: Any) -> float | str:
    number = float(value)
    if math.isfinite(number):
        return number
    return "nan" if math.isnan(number) else "inf" if number > 0 else "-inf"


def _column(name: str, value: Any) -> list[float | str]:
    try:
        return [_number(one) for one in value]
    except (TypeError, ValueError):
        raise TypeError(f"{name!r} is {_short(value)}; expected is a list or an array of numbers, of one dimension") from None


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 80 else text[:77] + "..."


def history(answer: Any) -> dict[str, Any]:
    """What a simulator returned, as the protocol has it."""
    if not isinstance(answer, Mapping):
        raise TypeError(f"the simulator returned {_short(answer)}; expected is a dictionary with time, velocity and ending")
    for name in answer:
        if name not in _FIELDS:
            raise TypeError(f"the simulator returned the field {name!r}; known are {', '.join(_FIELDS)}")
    for name in _NEEDED:
        if name not in answer:
            raise TypeError(f"the simulator returned no {name!r}")
    told: dict[str, Any] = {name: _column(name, answer[name]) for name in _COLUMNS if answer.get(name) is not None}
    told["ending"] = str(answer["ending"])
    if answer.get("tau_ch") is not None:
        told["tau_ch"] = _number(answer["tau_ch"])
    if answer.get("claim") is not None:
        claim = dict(answer["claim"])
        told["claim"] = {name: _column(name, of) if hasattr(of, "__len__") else _number(of) for name, of in claim.items()}
    return told


def answer(engine: Callable[[Any], Any], question: Mapping[str, Any]) -> dict[str, Any]:
    """The answer to a case."""
    from ._gate import Case, Decline

    until = question["until"]
    case = Case(
        model=question["model"],
        epsilon=question["epsilon"],
        omega=question["omega"],
        eta=question["eta"],
        alpha=question["alpha"],
        normalisation=question["normalisation"],
        impacts=question["impacts"],
        until=None if until == "half-period" else until,
    )
    try:
        began = time.perf_counter_ns()
        found = engine(case)
        took = time.perf_counter_ns() - began
        return {"history": history(found), "ns": took}
    except Decline as decline:
        return {"decline": {"reason": str(decline.reason), "why": str(decline.why)}}
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        # To the report, which keeps the end of the error output.
        traceback.print_exc(limit=-5)
        return {"error": {"message": f"{type(error).__name__}: {error}"[:500]}}


def serve(path: str, claims: bool) -> None:
    """Talks until it is told to stop."""
    # What the simulator prints is no answer, and it reads none of the questions.
    questions, answers = os.fdopen(os.dup(0), "r", encoding="utf-8"), os.fdopen(os.dup(1), "w", encoding="utf-8")
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.dup2(2, 1)
    engine, failure = None, None
    try:
        import pickle

        with open(path, "rb") as payload:
            engine = pickle.load(payload)
    except Exception as error:
        traceback.print_exc()
        failure = f"the simulator can't be loaded in a process of its own: {type(error).__name__}: {error}"
    for line in questions:
        question = json.loads(line)
        if question["cmd"] == "start":
            reply: dict[str, Any] = {
                "version": 1,
                "engine": {"name": "a function", "version": platform.python_version(), "language": "Python"},
                "models": ["linear", "nonlinear"],
                "normalisations": ["threshold", "slender"],
                "ground": ["sine"],
                "claims": claims,
                "echo": question["echo"],
            }
            if engine is None:
                reply = {"error": {"message": failure}}
        elif question["cmd"] == "case" and engine is not None:
            reply = {"seq": question["seq"], **answer(engine, question)}
        else:
            break
        answers.write(json.dumps(reply, allow_nan=False) + "\n")
        answers.flush()


if __name__ == "__main__":
    serve(sys.argv[1], sys.argv[2] == "claims")
