"""Writes data/record/engines.md: what the simulators of data/engines/peers.toml make of the same grid of cases, with proven answers beside them.

Usage: record.py [OUT], after run.sh made the environments; about.toml says what each simulator is, and which change of a setting shows the cause.
"""

import math
import os
import platform
import statistics
import subprocess
import sys
import tomllib

import measure
from run import OWN, when_and_where
from talk import HERE, ROOT, Broke, Engine, manifest

GRID = os.path.join(ROOT, "target", "peers", "grid")
YARDSTICK = "numba-closed-form"  # whose processor time a case is the unit of all others, in the same run


def asked(entry, cases):
    """The reply to every case; a text where the engine broke."""
    replies, engine = {}, None
    for name, case in cases.items():
        try:
            engine = engine or Engine(entry)
            replies[name] = engine.ask(**case["question"])
        except Broke as broke:
            replies[name] = str(broke)
            if engine:
                engine.stop()
            engine = None
    if engine:
        replies["version"] = f"{engine.name} {engine.version}"
        engine.stop()
    return replies


class Sight:
    """One answer against what is proven."""

    def __init__(self, reply, case):
        history, truth = reply["history"], case["truth"]
        times, intervals, _ = answer = measure.told(reply)
        self.listed, self.there = len(times), len(truth)
        self.resolved, *_ = measure.judge(answer, case)
        # The errors of the intervals of impacts 1, 2, .., relative.
        self.errors = [abs(found / proven - 1.0) for found, (_, proven) in zip(intervals, truth)]
        # The interval of the last impact that is right, in half-periods.
        self.finest = truth[self.resolved - 1][1] * case["question"]["omega"] / math.pi if self.resolved else math.nan
        self.first_time = abs(times[0] / truth[0][0] - 1.0) if times and truth else math.nan
        self.ending, self.tau_ch = history["ending"], history.get("tau_ch")
        self.is_complete = case["ending"].startswith("at rest")
        self.says_complete = {"at-rest": True, "incomplete": False, "overturned": False}.get(self.ending)
        # A list as long as was asked for is silent about what follows.
        self.is_full = self.listed == case["question"]["impacts"]
        self.is_right = self.resolved == self.there == self.listed and self.says_complete in (None, self.is_complete) and self.ending != "lost"
        self.rest_error = math.nan
        if self.is_complete and self.says_complete and self.tau_ch is not None:
            self.rest_error = float(self.tau_ch) / case["tau_ch"] - 1.0
        self.ns = reply.get("ns")


def median(values):
    values = [value for value in values if not math.isnan(value)]
    return statistics.median(values) if values else math.nan


def figures(replies, cases):
    """What is told of a setting, as numbers."""
    sights, declined, broke = [], 0, 0
    for name, case in cases.items():
        reply = replies[name]
        if isinstance(reply, str):
            broke += 1
        elif "decline" in reply:
            declined += 1
        else:
            sights.append(Sight(reply, case))
    wrong = [sight for sight in sights if not sight.is_right]
    complete = [sight for sight in sights if sight.is_complete]
    rocking = [sight for sight in sights if not sight.is_complete]
    early = [error for sight in sights for error in sight.errors[:3]]
    return {
        "answered": len(sights),
        "declined": declined,
        "broke": broke,
        "wrong": len(wrong),
        "first_wrong": median([sight.resolved + 1 for sight in wrong]),
        "earliest_wrong": min((sight.resolved + 1 for sight in wrong), default=math.nan),
        "finest": median([sight.finest for sight in wrong]),
        "first_time": median([sight.first_time for sight in sights]),
        "early": median(early),
        "rests": sum(sight.says_complete is True for sight in complete),
        "rocks_on": sum(sight.says_complete is False for sight in complete),
        "complete": len(complete),
        "rocks": sum(sight.says_complete is False for sight in rocking),
        "falls_asleep": sum(sight.says_complete is True for sight in rocking),
        "incomplete": len(rocking),
        "rest_error": median([abs(sight.rest_error) for sight in complete]),
        "rest_bias": median([sight.rest_error for sight in complete]),
        "ns": median([sight.ns for sight in sights if sight.ns is not None] or [math.nan]),
    }


def short(value):
    return "-" if value is None or math.isnan(value) else f"{value:.2g}"


def whole(value):
    return "-" if math.isnan(value) else f"{value:.0f}"


def accumulation(f):
    """What becomes of the cases that come to rest, in words."""
    said = []
    if f["rests"]:
        off = "" if math.isnan(f["rest_error"]) else f", {short(f['rest_error'])} off"
        said.append(f"{f['rests']} at rest{off}")
    if f["rocks_on"]:
        said.append(f"{f['rocks_on']} rock on")
    silent = f["complete"] - f["rests"] - f["rocks_on"]
    if silent:
        said.append(f"{silent} not said")
    return "; ".join(said)


def side(f):
    """How often the side of the critical amplitude is right, where it is told."""
    told = f["rests"] + f["rocks_on"] + f["rocks"] + f["falls_asleep"]
    return f"{f['rests'] + f['rocks']} of {told}" if told else "not said"


def row(name, f, unit):
    ratio = f["ns"] / unit if unit else math.nan
    cells = [
        name,
        f"{f['answered']} / {f['declined']} / {f['broke']}",
        f"{f['wrong']}",
        f"{whole(f['first_wrong'])} ({whole(f['earliest_wrong'])})",
        short(f["finest"]),
        short(f["first_time"]),
        short(f["early"]),
        accumulation(f),
        side(f),
        f"{ratio:.2g}",
    ]
    return "| " + " | ".join(cells) + " |"


COLUMNS = [
    "engine",
    "answered / declined / broke",
    "wrong",
    "first wrong impact, median (earliest)",
    "last interval that is right",
    "first impact off by",
    "intervals 1-3 off by",
    "complete cases",
    "side of `a_cr`",
    "time",
]
HEAD = "\n".join(["| " + " | ".join(COLUMNS) + " |", "| --- " * len(COLUMNS) + "|"])
FEW = 3  # of the cases, every so many are asked again with what a variant changes


def varied(entry, variant):
    """The engine with what a variant changes."""
    changed = dict(entry, environment={**entry.get("environment", {}), **variant.get("environment", {})})
    if "argument" in variant:
        changed["run"] = [*entry["run"][:-1], variant["argument"]]
    return changed


def main():
    out = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "data", "record", "engines.md")
    only = sys.argv[2:]
    subprocess.run([OWN, "grid", GRID], check=True)
    grid = {model: measure.read(os.path.join(GRID, model)) for model in ("linear", "nonlinear")}
    with open(os.path.join(HERE, "about.toml"), "rb") as file:
        about = tomllib.load(file)
    entries = {entry["name"]: entry for entry in manifest()}
    results, unit = {}, None
    for simulator in about["simulator"]:
        for name in simulator["engines"]:
            if only and name not in only and name != YARDSTICK:
                continue
            print(name, file=sys.stderr)
            entry = entries[name]
            cases = grid[entry["model"]]
            replies = asked(entry, cases)
            results[name] = (replies.get("version", ""), figures(replies, cases), [])
            for variant in simulator.get("variant", []):
                if variant["engine"] == name:
                    print(f"  {variant['what']}", file=sys.stderr)
                    few = dict(list(cases.items())[::FEW])
                    if not results[name][2]:
                        results[name][2].append(("as above", figures(replies, few)))
                    results[name][2].append((variant["what"], figures(asked(varied(entry, variant), few), few)))
    unit = results[YARDSTICK][1]["ns"] if YARDSTICK in results else None
    with open(out, "w") as file:
        file.write(document(about, results, unit))


def document(about, results, unit):
    lines = ["# What simulators make of a block that chatters", "", about["introduction"].strip(), "", when_and_where(), "", HEAD]
    lines += [row(name, f, unit) for name, (_, f, _) in results.items()]
    lines += ["", about["legend"].strip(), ""]
    for simulator in about["simulator"]:
        told = [name for name in simulator["engines"] if name in results]
        if not told:
            continue
        versions = ", ".join(dict.fromkeys(results[name][0] for name in told))
        lines += [f"## {simulator['title']}", "", f"*{versions}.* {simulator['what'].strip()}", ""]
        lines += [f"**How the block is told.** {simulator['how'].strip()}", "", f"**What it can't say.** {simulator['never'].strip()}", ""]
        lines += [f"**Why.** {simulator['why'].strip()}", ""]
        rows = [row(f"{name}, {what}", f, unit) for name in told for what, f in results[name][2]]
        if rows:
            lines += [HEAD, *rows, ""]
    lines += ["## Tried and not here", "", about["not_here"].strip()]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    main()
