"""How much a test of a program measures: tests/support/depth.h, for Python. Depth belongs to the test's file, the one that Python was started with."""
import os
import sys
from pathlib import Path

EVERYTHING = "NULLSCOPE_EVERYTHING" in os.environ or os.environ.get("NULLSCOPE_TESTS") == "everything"


def deep(file=None):
    """Whether a file (of a folder of tests/) is run at depth all or more: by default the running script."""
    asked = os.environ.get("NULLSCOPE_TESTS", "quick")
    path = Path(file or sys.argv[0]).resolve()
    return EVERYTHING or asked == "all" or f"{path.parent.name}/{path.name}" in asked.split(",")


if __name__ == "__main__":   # depth.py FILE: for scripts
    sys.exit(0 if deep(sys.argv[1]) else 1)
