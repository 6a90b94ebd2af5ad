#!/usr/bin/env python3
"""Prints what a tier's build and tests cost, by label, and fails when a sum is over its budget.

Usage: budget.py TIMES TIER [--budgets FILE]

TIMES holds the lines of measured.py. The budgets (tests/budget.csv beside this script) are processor seconds of the machine
on which they were set: each entry counts divided by the slowness that was measured beside it (machine.py). Exit status: 0
within, 1 over or nothing measured.
"""
import csv
import statistics
import sys
from collections import defaultdict
from pathlib import Path


def read_times(file):
    """{kind: {label: seconds}}, the costliest single entries, the median slowness; kind is programs, build, test, check, web or python."""
    sums, entries, slow = defaultdict(lambda: defaultdict(float)), [], []
    for line in Path(file).read_text(encoding="utf-8").splitlines():
        name, processor, wall, slowness = line.split("\t")
        used = float(processor) / float(slowness)
        first, _, rest = name.partition(": ")
        kind, label = (first, rest) if first in ("programs", "build", "check", "web", "python") else ("test", rest.split(",")[0] if first == "whole" else first)
        sums[kind][label] += used
        entries.append((used, float(wall), name))
        slow.append(float(slowness))
    return sums, sorted(entries, reverse=True), statistics.median(slow)


def read_budgets(file, tier):
    with open(file, encoding="utf-8") as lines:
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        return {row["kind"]: float(row["core_seconds"]) for row in rows if row["tier"] == tier}


def main():
    arguments = sys.argv[1:]
    budgets_file = Path(__file__).with_name("budget.csv")
    if "--budgets" in arguments:
        at = arguments.index("--budgets")
        budgets_file = arguments[at + 1]
        del arguments[at:at + 2]
    file, tier = arguments
    sums, entries, slow = read_times(file)
    budgets = read_budgets(budgets_file, tier)
    print(f"\nslowness of this machine: {slow:.2f} (tests/machine.py); what was used is divided by it")
    print(f"{'processor seconds':<34}{'used':>8}{'budget':>9}")
    over = [kind for kind in budgets if kind not in sums]
    for kind in over:
        print(f"{kind}: nothing was measured")
    for kind, labels in sums.items():
        for label, seconds in sorted(labels.items(), key=lambda row: -row[1]):
            print(f"  {kind + ': ' + label:<32}{seconds:8.1f}")
        total = sum(labels.values())
        said = ""
        if kind in budgets and total > budgets[kind]:
            over.append(kind)
            said = "   OVER BUDGET"
        print(f"{kind + ', all':<34}{total:8.1f}{budgets.get(kind, float('nan')):9.0f}{said}")
    print("costliest: " + "; ".join(f"{name} {processor:.0f}" for processor, _, name in entries[:5]))
    if over:
        print(f"budget: {', '.join(over)} of tier {tier}: see above, and {Path(budgets_file).name}", file=sys.stderr)
    return 1 if over else 0


if __name__ == "__main__":
    sys.exit(main())
