"""Files of nullscope in other people's programs: each test_NAME.py opens them with the real program and prints a table of what it found.

Usage of every test here: test_NAME.py PATH-OF-NULLSCOPE, by the interpreter of an environment that has the program; scripts/interop.sh makes it.
"""
import subprocess
import sys
import tempfile
import traceback
from pathlib import Path

import numpy as np
import OpenEXR

BINARY = str(Path(sys.argv[1]).resolve())
ROOT = Path(__file__).resolve().parents[2]


def nullscope(*arguments, folder):
    """Standard output and standard error of a command that succeeds in `folder`."""
    done = subprocess.run([BINARY, *map(str, arguments)], cwd=folder, capture_output=True, text=True, timeout=600)
    if done.returncode != 0:
        raise AssertionError(f"nullscope {' '.join(map(str, arguments))}: status {done.returncode}: {done.stderr}")
    return done.stdout + done.stderr


def exr(path):
    """Channel -> rows of values of all parts of an EXR, by OpenEXR."""
    with OpenEXR.File(str(path), separate_channels=True) as file:
        return {name: channel.pixels.copy() for part in file.parts for name, channel in part.channels.items()}


def write_exr(path, channels):
    """Floats of 32 bits."""
    with OpenEXR.File({"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage},
                      {name: np.ascontiguousarray(rows, dtype=np.float32) for name, rows in channels.items()}) as file:
        file.write(str(path))


class Report:
    """What was looked at: a row each, which fails where the number is above what is allowed."""

    def __init__(self, program):
        self.program, self.rows = program, []

    def add(self, what, found, allowed, unit=""):
        good = bool(found <= allowed)   # not of NaN
        self.rows.append(good)
        print(f"{'ok  ' if good else 'FAIL'} {self.program}: {what}: {found:.4g} {unit}(allowed {allowed:g})", flush=True)

    def known_fault(self, what, wrong):
        """Of the program, not of the file: said, and a failure once it is mended."""
        self.rows.append(bool(wrong))
        print(f"{'known' if wrong else 'FAIL'} {self.program}: {what}{'' if wrong else ': no longer so'}", flush=True)

    def same_bits(self, what, found, meant):
        """The number of values that differ in a bit; found is cast to float only where it is one already."""
        found, meant = np.ascontiguousarray(found, dtype=np.float32), np.ascontiguousarray(meant, dtype=np.float32)
        if found.shape != meant.shape:
            raise AssertionError(f"{what}: shape {found.shape} instead of {meant.shape}")
        if not np.any(meant != meant.flat[0]):
            raise AssertionError(f"{what}: one value everywhere shows nothing")
        self.add(f"{what}: values of {meant.size} that differ in a bit", int((found.view(np.uint32) != meant.view(np.uint32)).sum()), 0)


def main(program, *cases):
    """Each case(report, folder) in a folder of its own; fails unless every row of every case is good."""
    report, broken = Report(program), 0
    for case in cases:
        with tempfile.TemporaryDirectory(prefix="nullscope-interop-") as folder:
            try:
                case(report, Path(folder))
            except Exception:
                traceback.print_exc()
                broken += 1
    bad = report.rows.count(False) + broken
    print(f"{program}: {len(report.rows) - report.rows.count(False)} passed, {bad} failed", flush=True)
    sys.exit(1 if bad or not report.rows else 0)
