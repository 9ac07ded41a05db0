"""Version 1 of chattercheck's protocol for engines: a simulator in Python becomes one with this file beside it, which needs nothing but Python.

    import protocol  # first, before the simulator

    def answer(case):
        if case.eta > 0.99:
            raise protocol.Decline("hardly damped", f"eta = {case.eta}: it would take too many steps")
        ...
        return protocol.History(time, velocity, "limit-reached")

    protocol.serve("mine", "1.0", answer)

What is asked and what is answered: the chapter on engines of the guide.
"""

import json
import math
import os
import sys
import time
from dataclasses import dataclass, field

# Standard output is for answers only: from here on whatever a simulator prints, from C too, goes to standard error.
_answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
os.dup2(2, 1)


@dataclass(frozen=True)
class Case:
    """A question. The ground shakes with f = a sin(omega tau + psi), sin(psi) = 1/a, in units of what starts the rocking."""

    epsilon: float  # a - 1
    omega: float
    eta: float
    alpha: float | None  # in radians; None where the model does not look at it
    normalisation: str
    impacts: int  # at the most
    end: float  # follow the block to here
    is_half_period: bool  # whether that is half a period, pi/omega

    @staticmethod
    def of(question):
        """What a line asks."""
        until = question["until"]
        is_half_period = until == "half-period"
        end = math.pi / question["omega"] if is_half_period else until
        names = ("epsilon", "omega", "eta", "alpha", "normalisation", "impacts")
        return Case(*(question[name] for name in names), end, is_half_period)

    @property
    def still_rocking(self):
        """The ending of a block that rocks when the time is up."""
        return "incomplete" if self.is_half_period else "limit-reached"


@dataclass
class History:
    """An answer: a number for each impact in each column."""

    time: list
    velocity: list  # phi' just after the impact, with its sign
    ending: str  # never-rocks, at-rest, incomplete, overturned, limit-reached or lost
    interval: list | None = None  # where it is known better than as a difference of times
    tau_ch: float | None = None  # when the block comes to rest
    notes: dict = field(default_factory=dict)  # what else the reader of a record may want to know


class Decline(Exception):
    """What the simulator can't do: the reason in a word or two without numbers, which is counted, and why."""

    def __init__(self, reason, why):
        super().__init__(f"{reason}: {why}")
        self.refusal = {"reason": reason, "why": why}


def number(value):
    """A number as JSON can say it. Python prints a double so that the same one is read again."""
    value = float(value)
    return value if math.isfinite(value) else repr(value)


def columns(history):
    """A history in the words of the protocol; what the protocol has no word for goes by x-."""
    told = {"time": [number(t) for t in history.time], "velocity": [number(v) for v in history.velocity], "ending": history.ending}
    if history.interval is not None:
        told["interval"] = [number(interval) for interval in history.interval]
    if history.tau_ch is not None:
        told["tau_ch"] = number(history.tau_ch)
    return told | {f"x-{name}": value for name, value in history.notes.items()}


def reply(question, models, answer, finish):
    """The answer to a case. Its time is that of the processor, of all threads, so that what else runs on the machine counts little."""
    if question["model"] not in models:
        return {"decline": {"reason": "another model", "why": f"it has the model {' and '.join(models)}"}}
    case = Case.of(question)
    began = time.process_time_ns()
    try:
        history = answer(case)
    except Decline as decline:
        return {"decline": decline.refusal}
    except Exception as error:  # a failure of this case, in the simulator's words; the next one may go well
        return {"error": {"message": f"{type(error).__name__}: {error}"}}
    took = time.process_time_ns() - began
    return {"history": columns(finish(case, history)), "ns": took}


def as_it_is(case, history):
    """A history that needs no finish."""
    return history


def serve(name, version, answer, models=("linear",), normalisations=("threshold",), finish=as_it_is):
    """Answers questions until there are none. `finish` is what an adapter adds to a history that is not the simulator's work; it is not timed."""
    for line in sys.stdin:
        question = json.loads(line)
        if question["cmd"] == "start":
            said = {
                "version": 1,
                "engine": {"name": name, "version": version, "language": "Python"},
                "models": models,
                "normalisations": normalisations,
                "ground": ["sine"],
                "echo": question["echo"],
            }
        elif question["cmd"] == "case":
            said = {"seq": question["seq"], **reply(question, models, answer, finish)}
        else:
            break
        # Flushed: an answer that stays in a buffer is one that never came.
        print(json.dumps(said, allow_nan=False), file=_answers, flush=True)
