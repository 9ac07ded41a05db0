"""What every peer is asked, how its answer is judged before it is timed, and the rows that come of it.

A peer is a module with TOOL, VERSION and SETTINGS: name -> function(epsilon, omega, eta, impacts) that returns
(times, intervals, why it ended, right-hand sides). Usage: measure.py MODULE DIR N, for its N-th setting.
"""

import csv
import importlib
import json
import sys
import time

RESOLVED = 0.01  # an impact is resolved while its interval is within 1 %
REPEATS, LONG = 5, 4.0  # what takes longer than LONG seconds is timed once


def read(folder):
    """The cases by name, each with the proven impacts."""
    cases = {}
    with open(f"{folder}/cases.csv", newline="") as file:
        for row in csv.DictReader(file):
            numbers = [float(row[key]) for key in ("epsilon", "omega", "eta")]
            tau_ch = float(row["tau_ch"]) if row["tau_ch"] else None
            cases[row["case"]] = {"parameters": (*numbers, int(row["impacts"])), "tau_ch": tau_ch, "truth": []}
    with open(f"{folder}/truth.csv", newline="") as file:
        for row in csv.DictReader(file):
            cases[row["case"]]["truth"].append((float(row["tau"]), float(row["interval"])))
    return cases


def judge(answer, case):
    """How many impacts are resolved, the worst error of time over the first 20, of the intervals that are resolved, and what went wrong."""
    times, intervals, ended, *_ = answer
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


def timed(run, parameters):
    """Seconds for all of them: the best of some repeats of each, in processor time, so that what else runs on the machine counts little."""
    best = [float("inf")] * len(parameters)
    for _ in range(REPEATS):
        for index, of_one in enumerate(parameters):
            start = time.thread_time()
            run(*of_one)
            best[index] = min(best[index], time.thread_time() - start)
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


def throughput(peer, setting, cases):
    """The row of a peer: first judged, then timed."""
    run = peer.SETTINGS[setting]
    listed = workload(cases).values()
    judged = [judge(run(*case["parameters"]), case) for case in listed]
    deep = judge(run(*cases["deep"]["parameters"]), cases["deep"])
    seconds = timed(run, [case["parameters"] for case in listed])
    return row(peer.TOOL, peer.VERSION, setting, judged, seconds, deep)


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


def work_precision(peer, setting, cases):
    """Rows as those of work_precision.csv, one for each distance to the critical amplitude."""
    run = peer.SETTINGS[setting]
    for name, case in cases.items():
        if not name.startswith("share "):
            continue
        epsilon, omega, eta, impacts = case["parameters"]
        answer = run(epsilon, omega, eta, impacts)
        times, intervals, _, rhs = answer
        resolved, *_, wrong = judge(answer, case)
        tau_ch = close(list(intervals), times[-1], eta) if wrong is None and case["tau_ch"] else None
        tau_40 = case["truth"][39][0]
        yield {
            "share": name.removeprefix("share "),
            "epsilon": epsilon,
            "family": f"{peer.TOOL} (peer)",
            "setting": setting,
            "impacts": len(times),
            "rhs": rhs or "",
            "seconds": f"{timed(run, [case['parameters']]):.3g}",
            "tau_ch_error": "" if tau_ch is None else f"{abs(tau_ch / case['tau_ch'] - 1.0):.3g}",
            "impact_40_error": "" if resolved < 40 else f"{abs(times[39] / tau_40 - 1.0):.3g}",
            "outcome": wrong or "",
        }


def main():
    module, folder, index = sys.argv[1:]
    peer = importlib.import_module(module)
    setting = list(peer.SETTINGS)[int(index)]
    cases = read(folder)
    rows = {"peers": [throughput(peer, setting, cases)], "work_precision": list(work_precision(peer, setting, cases))}
    print(json.dumps(rows))


if __name__ == "__main__":
    main()
