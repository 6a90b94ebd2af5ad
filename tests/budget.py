#!/usr/bin/env python3
"""Prints what a tier's build, tests and checks cost, by label, and fails when a sum is over its budget.

Usage: budget.py TIMES TIER [--budgets FILE] [--wall SECONDS]

TIMES holds the lines of measured.py. The budgets (tests/budget.csv beside this script) are base seconds: processor seconds divided by
the slowness that was measured beside each entry (machine.py). Where a tier has a budget for the sum, the sum alone fails it: that is what
continuous integration waits for, and the one figure in which errors of the slowness even out (of one build they are 5 %). A kind over its
own part is marked, so that one sees what grew. Wall time depends on what else the machine does and never fails a tier:
with --wall the run's own is held against what continuous integration allows, and a warning says when it took longer than the
base seconds of its budget should on two cores. Exit status: 0 within, 1 over or nothing measured.
"""
import argparse
import csv
import statistics
import sys
from collections import defaultdict
from pathlib import Path
from typing import NamedTuple

LIMIT_S = 5400       # continuous integration kills a run after that many seconds
CORES = 2
USUAL_SLOWNESS = 1.35   # of the machines that run it: a budget of 2,400 base seconds is 1,800 s x 1.35 there, less than half idle
KINDS = ("programs", "build", "check", "web", "python")


class Cost(NamedTuple):
    base: float = 0.0        # s
    processor: float = 0.0   # s
    wall: float = 0.0        # s

    def plus(self, other):
        return Cost(*(a + b for a, b in zip(self, other)))


def read_times(file):
    """{kind: {label: Cost}}, the single entries, costliest first, and the median slowness; kind is one of KINDS or test."""
    sums, entries, slow = defaultdict(lambda: defaultdict(Cost)), [], []
    for line in Path(file).read_text(encoding="utf-8").splitlines():
        name, processor, wall, slowness = line.split("\t")
        cost = Cost(float(processor) / float(slowness), float(processor), float(wall))
        first, _, rest = name.partition(": ")
        kind, label = (first, rest) if first in KINDS else ("test", rest.split(",")[0] if first == "whole" else first)
        sums[kind][label] = sums[kind][label].plus(cost)
        entries.append((cost, name))
        slow.append(float(slowness))
    return sums, sorted(entries, reverse=True), statistics.median(slow)


def read_budgets(file, tier):
    with open(file, encoding="utf-8") as lines:
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        return {row["kind"]: float(row["core_seconds"]) for row in rows if row["tier"] == tier}


def row(name, cost, budget=None, said=""):
    cores = f"{cost.processor / cost.wall:6.2f}" if cost.wall > 0 else "     -"
    print(f"{name:<62}{cost.base:8.1f}{'' if budget is None else f'{budget:.0f}':>8}{cost.processor:10.1f}{cost.wall:9.1f}{cores}{said}")


def wall_lines(wall, total, slow):
    """What the run took by the clock; a warning where it is longer than its base seconds are on CORES cores."""
    yield f"the clock: {wall:.0f} s, {100 * wall / LIMIT_S:.0f} % of the {LIMIT_S} s of continuous integration; {total.processor / wall:.2f} cores in use"
    expected = total.base / CORES * max(USUAL_SLOWNESS, slow)
    if wall > 1.25 * expected:   # a quarter of the time idle, or the machine busy with something else
        yield f"WARNING: {total.base:.0f} base seconds should take some {expected:.0f} s here: cores were idle or busy with other work"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("times")
    parser.add_argument("tier")
    parser.add_argument("--budgets", default=Path(__file__).with_name("budget.csv"))
    parser.add_argument("--wall", type=float)
    options = parser.parse_args()
    sums, entries, slow = read_times(options.times)
    budgets = read_budgets(options.budgets, options.tier)
    total = Cost()
    over = [kind for kind in budgets if kind not in sums and kind != "sum"]
    parts_fail = "sum" not in budgets
    print(f"\nslowness of this machine: {slow:.2f} (tests/machine.py); base seconds are processor seconds divided by it")
    print(f"{'':<62}{'base s':>8}{'budget':>8}{'core-s':>10}{'wall s':>9} cores")
    for kind in over:
        print(f"{kind}: nothing was measured")
    for kind, labels in sums.items():
        of_kind = Cost()
        for label, cost in sorted(labels.items(), key=lambda item: -item[1].base):
            row(f"  {kind}: {label}", cost)
            of_kind = of_kind.plus(cost)
        late = kind in budgets and of_kind.base > budgets[kind]
        over += [kind] if late and parts_fail else []
        row(f"{kind}, all", of_kind, budgets.get(kind), "" if not late else "   OVER BUDGET" if parts_fail else "   over its part")
        total = total.plus(of_kind)
    late = "sum" in budgets and total.base > budgets["sum"]
    over += ["sum"] if late else []
    row("all of it", total, budgets.get("sum"), "   OVER BUDGET" if late else "")
    print("costliest entries: " + "; ".join(f"{name} {cost.base:.0f}" for cost, name in entries[:8]))
    if options.wall:
        print("\n".join(wall_lines(options.wall, total, slow)))
    if over:
        print(f"budget: {', '.join(over)} of tier {options.tier}: see above, and {Path(options.budgets).name}", file=sys.stderr)
    return 1 if over else 0


if __name__ == "__main__":
    sys.exit(main())
