"""Asks the peers and the project's own oracles the same cases, in one run, and writes one row for each setting.

The peers are the engines of data/engines/peers.toml that have the linear block; they are asked through the protocol, as the gate asks them.
Usage: run.py [OUT], after `cargo build --release --example peers`; OUT is data/record/peers unless given. See README.md.
"""

import csv
import datetime
import json
import os
import platform
import subprocess
import sys

import measure
from talk import HERE, ROOT, Broke, Engine, manifest

OWN = os.environ.get("OWN", os.path.join(ROOT, "target", "release", "examples", "peers"))
CASES = os.path.join(ROOT, "target", "peers")
PATIENCE = 120  # seconds of processor time for a setting, everything included

COLUMNS = {
    "peers": "tool,version,setting,cases,cases_lost,impacts,impacts_per_s,closed_form_ratio,worst_time_error_20,"
    "worst_interval_error,impacts_resolved,outcome",
    "work_precision": "share,epsilon,family,setting,impacts,rhs,seconds,tau_ch_error,impact_40_error,outcome",
}


def own():
    """The rows of the project's own oracles: their answers, judged as those of the peers are."""
    cases = measure.read(CASES)
    lines = subprocess.run([OWN, "time", CASES], check=True, capture_output=True, text=True).stdout.splitlines()
    for line in lines:
        answer = json.loads(line)
        judged = [measure.judge(answer["answers"][name], case) for name, case in measure.workload(cases).items()]
        deep = measure.judge(answer["answers"]["deep"], cases["deep"])
        yield measure.row("chattercheck", "0.1.0", answer["setting"], judged, answer["seconds"], deep)


def ask(entry, cases):
    """What a peer answers, judged and timed; how it failed if it did."""
    setting = entry["run"][2] if len(entry["run"]) > 2 else entry["name"]
    try:
        with Engine(entry, PATIENCE) as engine:
            rows = [measure.throughput(engine, setting, cases)]
            return {"peers": rows, "work_precision": list(measure.work_precision(engine, setting, cases))}
    except Broke as broke:
        failed = {"tool": entry["name"], "setting": setting, "outcome": str(broke)}
        return {"peers": [failed], "work_precision": []}


def write(folder, name, rows):
    """One CSV; what a row does not have stays empty."""
    with open(os.path.join(folder, f"{name}.csv"), "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS[name].split(","), restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def table(rows):
    """The same for people to read: one line a setting, the fastest first."""
    lines = [
        "| tool | setting | impacts/s | the closed form is faster by | worst time error, first 20 impacts | cases lost | impacts resolved on (1.03, 2, 0.92) | there |",
        "| --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    for row in sorted(rows, key=lambda row: -float(row.get("impacts_per_s") or 0)):
        numbers = [row.get(name, "") or "-" for name in ("impacts_per_s", "closed_form_ratio", "worst_time_error_20")]
        lost = f"{row['cases_lost']} of {row['cases']}" if "cases" in row else "-"
        cells = [f"{row['tool']} {row.get('version', '')}", row["setting"], *numbers, lost, row.get("impacts_resolved", "-"), row["outcome"]]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return "\n".join([when_and_where(), "", *lines]) + "\n"


def when_and_where():
    """The date, and what it ran on."""
    model = "unknown processor"
    if os.path.exists("/proc/cpuinfo"):
        with open("/proc/cpuinfo") as file:
            names = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
        model = next(iter(names), model)
    return f"{datetime.date.today()}, {model}, {os.cpu_count()} cores, Python {platform.python_version()}."


def main():
    out = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "data", "record", "peers")
    os.makedirs(out, exist_ok=True)
    subprocess.run([OWN, "cases", CASES], check=True)
    tables = {"peers": list(own()), "work_precision": []}
    cases = measure.read(CASES)
    for entry in manifest():
        if entry["model"] == "linear":
            print(entry["name"], file=sys.stderr)
            for name, rows in ask(entry, cases).items():
                tables[name] += rows
    fastest = float(tables["peers"][0]["impacts_per_s"])  # the closed form is asked first
    for row in tables["peers"]:
        if row.get("impacts"):
            row["closed_form_ratio"] = f"{fastest / float(row['impacts_per_s']):.3g}"
    for name, rows in tables.items():
        write(out, name, rows)
    with open(os.path.join(out, "peers.md"), "w") as file:
        file.write(table(tables["peers"]))


if __name__ == "__main__":
    main()
