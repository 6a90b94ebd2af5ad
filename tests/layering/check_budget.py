#!/usr/bin/env python3
"""The budget of a tier can be missed: budget.py is shown costs below, above and none at all, and measured.py a failing command."""
import subprocess
import sys
import tempfile
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]


def budget(folder, times, *words, tier="quick"):
    (folder / "times.tsv").write_text(times)
    (folder / "budget.csv").write_text("tier,kind,core_seconds\nquick,test,10\nturn,test,10\nturn,sum,15\n")
    return subprocess.run([sys.executable, "-B", TESTS / "budget.py", folder / "times.tsv", tier, "--budgets", folder / "budget.csv", *words],
                          capture_output=True, text=True)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        tests = "whole: gpu, others\t8.0\t9.0\t2.0\ncli: films\t5.5\t1.0\t1.0\n"
        within = budget(folder, tests + "build: gpu\t10\t50\t2\n", "--wall", "12")
        assert within.returncode == 0 and "gpu" in within.stdout and "WARNING" not in within.stdout, within
        over = budget(folder, "whole: gpu, others\t8.0\t9.0\t2.0\ncli: films\t6.5\t1.0\t1.0\n")
        assert over.returncode == 1 and "OVER BUDGET" in over.stdout and "10.5" in over.stdout, over
        part = budget(folder, "whole: gpu, others\t8.0\t9.0\t2.0\ncli: films\t6.5\t1.0\t1.0\n", tier="turn")   # of a turn the sum decides
        assert part.returncode == 0 and "over its part" in part.stdout, part
        over = budget(folder, tests + "check: tidy\t12\t9\t2\n", tier="turn")   # 4 + 5.5 + 6: each kind within, the sum not
        assert over.returncode == 1 and "15.5" in over.stdout and over.stdout.count("OVER BUDGET") == 1, over
        slow = budget(folder, tests, "--wall", "100")   # the clock warns and does not fail
        assert slow.returncode == 0 and "WARNING" in slow.stdout and "2 % of the 5400 s" in slow.stdout, slow
        assert budget(folder, "build: gpu\t1\t1\t1\n").returncode == 1, "nothing measured is no pass"
        times = folder / "new" / "times.tsv"
        command = [sys.executable, "-B", TESTS / "measured.py", times, "name", sys.executable, "-c", "sum(range(5000000)); exit(3)"]
        assert subprocess.run(command).returncode == 3
        said, processor, _, slowness = times.read_text().split("\t")
        assert said == "name" and 0.01 < float(processor) < 60 and 1 <= float(slowness) < 100, times.read_text()
    return 0


if __name__ == "__main__":
    sys.exit(main())
