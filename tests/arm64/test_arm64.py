#!/usr/bin/env python3
"""What the program for arm64 does under qemu is what the program does here: scripts/arm64.sh builds it.

Usage: test_arm64.py PATH-OF-NULLSCOPE [CASE...]; prints a table of what was measured. Ends with 77, and says why, where there is no
program for arm64 or no qemu. NULLSCOPE_TESTS=few: two scenes in place of a dozen.
"""
import math
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/cli")]

import support  # noqa: E402
from test_trace import REFERENCE, read_csv, write_csv  # noqa: E402

FOLDER = ROOT / "build/arm64"
BIN = FOLDER / "build/bin"
EMULATED = ["qemu-aarch64-static", "-L", str(FOLDER / "root")]
SKIPPED = 77   # ctest's SKIP_RETURN_CODE
SIZE = "160x90"
SCENES = ("first-light", "kerr", "accretion", "soft-disc", "wormhole", "zoom", "hot-spot", "luminet", "m87", "sky-grid", "plunge", "saturn")
FEW = ("first-light", "kerr")
# Pictures are drawn by other code of llvmpipe, of vectors of 128 bits; tests/windows has the same bound.
FLOATS = 1e-5          # of the brightest, of colours
# long double, of the reference and of cameras' tetrads, has 64 bits here and 113 there, and some functions of the C library have other last bits
# (Library). Where what is given is exact, each of the two is this far from the truth.
BOTH = 2 * REFERENCE


def leave_if_missing():
    """Ends with the status of a skipped test, and says why, where nothing can be tested."""
    program = BIN / "nullscope"
    reason = f"there is no {program.relative_to(ROOT)}: scripts/arm64.sh makes it" if not program.is_file() else \
        None if shutil.which(EMULATED[0]) else f"{EMULATED[0]} is not installed"
    if reason:
        print(f"left out: {reason}")
        sys.exit(SKIPPED)


def row(what, measured):
    print(f"{what:46}  {measured}", flush=True)   # as it comes: a run that is cut off has said what it found


def vectors(name):
    return read_csv((support.VECTORS / f"{name}.csv").read_text())


class Arm64Test(support.CliTest):
    def there(self, *arguments, program="nullscope"):
        done = subprocess.run([*EMULATED, str(BIN / program), *map(str, arguments)], capture_output=True, timeout=support.LONGEST_S, cwd=self.folder)
        ran = support.Ran(done)
        self.assertEqual(ran.status, 0, f"{program} {' '.join(map(str, arguments))}\n{ran}")
        return ran


class Program(Arm64Test):
    def test_contracts(self):
        if not (BIN / "contract_tests").is_file():
            self.skipTest("there are no contract tests: scripts/arm64.sh build contract")
        said = self.there(program="contract_tests").out
        counts = re.findall(r"(?:cases|assertions): +([1-9]\d*) \|", said)
        self.assertEqual(len(counts), 2, said)
        row("contract tests", "{} cases, {} assertions hold".format(*counts))

    def test_words_are_those_of_here(self):
        for words in (["plan", "kerr"], ["scenes"], ["--help"], ["landmarks", "kerr"]):
            self.assertEqual(self.there(*words).out, self.run_nullscope(*words).out, words)


class Library(Arm64Test):
    # Of glibc, whose C is compiled with fused a*b+c there: docs/devices.md says so. All others have the same bits.
    OTHER = {"hypot", "cbrt", "tgamma", "lgamma", "erf", "atanf", "atan2f"}

    def bits(self, compiler, *emulator):
        program = self.folder / compiler
        subprocess.run([compiler, "-std=c++20", "-O1", "-ffp-contract=off", ROOT / "tests/arm64/libm_bits.cpp", "-o", program], check=True)
        said = subprocess.run([*emulator, program], capture_output=True, text=True, check=True).stdout
        return {name: values for name, *values in map(str.split, said.splitlines())}

    def test_functions(self):
        compiler = "aarch64-linux-gnu-g++"
        if shutil.which(compiler) is None:
            self.skipTest(f"{compiler} is not installed")
        there, here = self.bits(compiler, *EMULATED), self.bits("g++")
        self.assertEqual(list(there), list(here))
        other = {name: sum(a != b for a, b in zip(there[name], here[name], strict=True)) for name in here if there[name] != here[name]}
        row("functions of the C library", f"{len(other)} of {len(here)} have other bits somewhere: " +
            ", ".join(f"{name} at {count}" for name, count in other.items()) + f" of {len(here['sin'])} places")
        self.assertLessEqual(set(other), self.OTHER)


class Rays(Arm64Test):
    """Both programs' answers to the same rays, all digits."""

    def lists(self):
        """(name, scene, columns, rows): the rays of the vectors of 50 digits."""
        yield "schwarzschild", "sky-only", ["q", "zeta0", "s"], [[float(r["q"]), float(r["zeta0"]), int(r["s"])] for r in vectors("schwarzschild")]
        columns = ["r", "theta", "phi", "n_r", "n_theta", "n_phi"]
        yield "kerr_a0.9", "kerr", columns, [[0.5 * float(r["r0"]), float(r["theta0"]), 0.0, *(float(r[n]) for n in ("n_r", "n_th", "n_ph"))]
                                             for r in vectors("kerr_a0.9")]
        yield "ellis", "wormhole", columns, [[float(r["l0"]), 1.2, 0.0, -math.cos(alpha), 0.6 * math.sin(alpha), 0.8 * math.sin(alpha)]
                                             for r in vectors("ellis") for alpha in [float(r["alpha"])]]

    def traced(self, run, scene, columns, rows, tracer):
        file = self.write("rays.csv", write_csv(rows, columns))
        found = read_csv(run("trace", scene, "--rays", file, "--with", tracer, "--crossings", "2").out)
        self.assertEqual(len(found), len(rows))
        return [{name: text for name, text in ray.items() if name not in columns} for ray in found]

    def moved(self, scene, columns, rows, found, tracer):
        """What the last bit of one number that is given moves each answer at most."""
        most = [{name: 0.0 for name in ray} for ray in found]
        for at, column in enumerate(columns):
            for side in (-math.inf, math.inf):
                beside = [[*r[:at], math.nextafter(r[at], side) if column != "s" else r[at], *r[at + 1:]] for r in rows]
                for ray, here, by in zip(self.traced(self.run_nullscope, scene, columns, beside, tracer), found, most):
                    for name in by:
                        if name != "fate" and ray[name] and here[name]:
                            by[name] = max(by[name], abs(float(ray[name]) - float(here[name])))
        return most

    def judge(self, tracer):
        for name, scene, columns, rows in self.lists():
            there, here = (self.traced(run, scene, columns, rows, tracer) for run in (self.there, self.run_nullscope))
            self.assertEqual([ray["fate"] for ray in there], [ray["fate"] for ray in here])
            numbers, other, most, beyond = 0, 0, 0.0, 0.0
            for mine, his, by in zip(there, here, self.moved(scene, columns, rows, here, tracer)):
                for column in his.keys() - {"fate"}:
                    self.assertEqual(mine[column] == "", his[column] == "", (name, column, mine, his))
                    if his[column]:
                        off, size = abs(float(mine[column]) - float(his[column])), max(abs(float(his[column])), 1.0)
                        numbers, other, most = numbers + 1, other + (off > 0), max(most, off / size)
                        beyond = max(beyond, (off - by[column]) / size)
                        self.assertLessEqual(off, by[column] + BOTH * size, (name, column, mine, his))
            row(f"rays of {name}, {tracer}", f"{other} of {numbers} numbers have other bits, by {most:.1e} at most; by {beyond:.1e} more than "
                f"the last bit of what is given moves them ({BOTH:.0e})" if other else f"all {numbers} numbers have the same bits")

    def test_reference(self):
        self.judge("reference")

    def test_core64(self):
        self.judge("core64")

    def test_core32(self):
        self.judge("core32")


class Pictures(Arm64Test):
    def test_scenes(self):
        for scene in FEW if os.environ.get("NULLSCOPE_TESTS") == "few" else SCENES:
            drawn = []
            for name, run in (("there", self.there), ("here", self.run_nullscope)):
                run("capture", scene, "--size", SIZE, "--quiet", "-o", f"{name}.exr")
                drawn.append(support.read_exr((self.folder / f"{name}.exr").read_bytes()))
            there, here = drawn
            self.assertEqual(list(there), list(here))
            brightest = max(max(map(abs, row)) for rows in here.values() for row in rows)
            off = [abs(a - b) for name in here for mine, his in zip(there[name], here[name], strict=True) if mine != his for a, b in zip(mine, his)]
            most = max(off, default=0.0) / brightest
            row(f"picture {scene}", f"{sum(x > 0 for x in off)} numbers differ, by {most:.1e} of the brightest at most" if most else "the same bits")
            self.assertLessEqual(most, FLOATS)


if __name__ == "__main__":
    leave_if_missing()
    support.main()
