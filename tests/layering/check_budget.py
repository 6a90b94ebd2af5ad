#!/usr/bin/env python3
"""The budget of a tier can be missed: budget.py is shown costs below, above and none at all, and measured.py a failing command."""
import subprocess
import sys
import tempfile
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]


def budget(folder, times):
    (folder / "times.tsv").write_text(times)
    (folder / "budget.csv").write_text("tier,kind,core_seconds\nquick,test,10\n")
    return subprocess.run([sys.executable, "-B", TESTS / "budget.py", folder / "times.tsv", "quick", "--budgets", folder / "budget.csv"],
                          capture_output=True, text=True)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        within = budget(folder, "whole: gpu, others\t8.0\t9.0\t2.0\ncli: films\t5.5\t1.0\t1.0\nbuild: gpu\t99\t50\t1\n")
        assert within.returncode == 0 and "gpu" in within.stdout, within
        over = budget(folder, "whole: gpu, others\t8.0\t9.0\t2.0\ncli: films\t6.5\t1.0\t1.0\n")
        assert over.returncode == 1 and "OVER BUDGET" in over.stdout and "10.5" in over.stdout, over
        assert budget(folder, "build: gpu\t1\t1\t1\n").returncode == 1, "nothing measured is no pass"
        times = folder / "new" / "times.tsv"
        command = [sys.executable, "-B", TESTS / "measured.py", times, "name", sys.executable, "-c", "sum(range(5000000)); exit(3)"]
        assert subprocess.run(command).returncode == 3
        said, processor, _, slowness = times.read_text().split("\t")
        assert said == "name" and 0.01 < float(processor) < 60 and 1 <= float(slowness) < 100, times.read_text()
    return 0


if __name__ == "__main__":
    sys.exit(main())
