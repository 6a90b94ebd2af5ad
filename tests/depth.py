"""How much a test of a program measures: tests/support/depth.h, for Python. Depth belongs to the test's file, the one that Python was started with."""
import itertools
import os
import sys
import unittest
import zlib
from pathlib import Path

EVERYTHING = "NULLSCOPE_EVERYTHING" in os.environ or os.environ.get("NULLSCOPE_TESTS") == "everything"


def deep(file=None):
    """Whether a file (of a folder of tests/) is run at depth all or more: by default the running script."""
    asked = os.environ.get("NULLSCOPE_TESTS", "quick")
    path = Path(file or sys.argv[0]).resolve()
    return EVERYTHING or asked == "all" or f"{path.parent.name}/{path.name}" in asked.split(",")


COSTLY_PARTS = 8   # as in support/depth.h
_costly = itertools.count(zlib.crc32(Path(sys.argv[0]).name.encode()))   # else every file's first would fall to the same run


def left_to_another_run():
    """Of the file's next costly case: whether this run leaves it out. As in support/depth.h."""
    number, run = next(_costly), os.environ.get("NULLSCOPE_RUN")
    return bool(run) and not deep() and number % COSTLY_PARTS != int(run) % COSTLY_PARTS


def costly(test):
    """Of a test method that costs more than a base second at quick depth."""
    return unittest.skipIf(left_to_another_run(), "costly: another NULLSCOPE_RUN takes it")(test)


if __name__ == "__main__":   # depth.py FILE: for scripts
    sys.exit(0 if deep(sys.argv[1]) else 1)
