"""How an answer is judged before it is timed, and the rows that come of it."""

import csv
import math

RESOLVED = 0.01  # an impact is resolved while its interval is within 1 %
REPEATS, LONG = 5, 4.0  # what takes longer than LONG seconds is timed once


def read(folder):
    """The cases by name, each with the proven impacts."""
    cases = {}
    with open(f"{folder}/cases.csv", newline="") as file:
        for row in csv.DictReader(file):
            question = {key: float(row[key]) for key in ("epsilon", "omega", "eta")} | {"impacts": int(row["impacts"])}
            question["alpha"] = float(row["alpha"]) if row["alpha"] else None
            tau_ch = float(row["tau_ch"]) if row["tau_ch"] else None
            cases[row["case"]] = {"question": question, "tau_ch": tau_ch, "ending": row["ending"], "truth": []}
    with open(f"{folder}/truth.csv", newline="") as file:
        for row in csv.DictReader(file):
            cases[row["case"]]["truth"].append((float(row["tau"]), float(row["interval"])))
    return cases


def told(reply):
    """The times and the intervals of a reply, and why its list ends."""
    if "decline" in reply:
        return [], [], f"declined: {reply['decline']['reason']}"
    history = reply["history"]
    times = [float(time) for time in history["time"]]
    intervals = history.get("interval") or [time - before for before, time in zip([0.0, *times], times)]
    return times, [float(interval) for interval in intervals], history.get("x-why", history["ending"])


def judge(answer, case):
    """How many impacts are resolved, the worst error of time over the first 20, of the intervals that are resolved, and what went wrong."""
    times, intervals, ended = answer
    resolved, worst_time, worst_interval = 0, 0.0, 0.0
    for found_time, found, (tau, interval) in zip(times, intervals, case["truth"]):
        error = abs(found / interval - 1.0)
        if not error < RESOLVED:
            break
        resolved += 1
        worst_interval = max(worst_interval, error)
        if resolved <= 20:
            worst_time = max(worst_time, abs(found_time - tau))
    wrong = None
    if resolved < len(case["truth"]):
        wrong = "silently wrong" if resolved < len(times) else ended
    elif len(times) > resolved:
        wrong = "impacts that are none"
    return resolved, worst_time, worst_interval, wrong


def timed(engine, questions):
    """Seconds for all of them, as the engine measures them: the best of some repeats of each."""
    best = [float("inf")] * len(questions)
    for _ in range(REPEATS):
        for index, question in enumerate(questions):
            best[index] = min(best[index], engine.ask(**question).get("ns", math.inf) * 1e-9)
        if sum(best) > LONG:
            break
    return sum(best)


def row(tool, version, setting, judged, seconds, deep):
    """A row of peers.csv, from what judge() said of each case of the workload and of the deep one."""
    impacts = sum(resolved for resolved, *_ in judged)
    depth, *_, fails = deep
    return {
        "tool": tool,
        "version": version,
        "setting": setting,
        "cases": len(judged),
        "cases_lost": sum(wrong is not None for *_, wrong in judged),
        "impacts": impacts,
        "impacts_per_s": f"{impacts / seconds:.3g}" if impacts else "",
        "worst_time_error_20": f"{max(error for _, error, *_ in judged):.2g}" if impacts else "",
        "worst_interval_error": f"{max(error for _, _, error, _ in judged):.2g}" if impacts else "",
        "impacts_resolved": depth,
        "outcome": fails or "resolved all",
    }


def workload(cases):
    """The cases that are timed: those whose names are numbers."""
    return {name: case for name, case in cases.items() if name.isdigit()}


def throughput(engine, setting, cases):
    """The row of a peer: first judged, then timed."""
    listed = workload(cases).values()
    judged = [judge(told(engine.ask(**case["question"])), case) for case in listed]
    deep = judge(told(engine.ask(**cases["deep"]["question"])), cases["deep"])
    resolves_any = any(resolved for resolved, *_ in judged)
    seconds = timed(engine, [case["question"] for case in listed]) if resolves_any else None
    return row(engine.name, engine.version, setting, judged, seconds, deep)


def close(intervals, last, eta):
    """The chattering time after the impact at `last`: Eq. 75 and its higher orders (Richardson's extrapolation), up to the column that changes least."""
    pairs = [intervals[k] + intervals[k + 1] for k in range(len(intervals) % 2, len(intervals), 2)][-24:]
    value, best, power = last, (float("inf"), last), 1.0
    while len(pairs) >= 2:
        power *= eta * eta
        change = power / (1.0 - power) * pairs[-1]
        value += change
        best = min(best, (abs(change), value))
        pairs = [(late - power * early) / (1.0 - power) for early, late in zip(pairs, pairs[1:])]
    return best[1]


def work_precision(engine, setting, cases):
    """Rows as those of work_precision.csv, one for each distance to the critical amplitude."""
    for name, case in cases.items():
        if not name.startswith("share "):
            continue
        question = case["question"]
        reply = engine.ask(**question)
        times, intervals, _ = answer = told(reply)
        resolved, *_, wrong = judge(answer, case)
        tau_ch = close(intervals, times[-1], question["eta"]) if wrong is None and case["tau_ch"] else None
        tau_40 = case["truth"][39][0]
        yield {
            "share": name.removeprefix("share "),
            "epsilon": question["epsilon"],
            "family": f"{engine.name} (peer)",
            "setting": setting,
            "impacts": len(times),
            "rhs": reply.get("history", {}).get("x-rhs", ""),
            "seconds": f"{timed(engine, [question]):.3g}",
            "tau_ch_error": "" if tau_ch is None else f"{abs(tau_ch / case['tau_ch'] - 1.0):.3g}",
            "impact_40_error": "" if resolved < 40 else f"{abs(times[39] / tau_40 - 1.0):.3g}",
            "outcome": wrong or "",
        }
