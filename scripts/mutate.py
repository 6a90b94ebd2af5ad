#!/usr/bin/env python3
"""Mutation testing: plants one mutant at a time and says whether its test catches it.

    scripts/mutate.py                 all of them, as a Markdown table; some fifteen minutes on two cores
    scripts/mutate.py --list          their names
    scripts/mutate.py NAME...         only these
    scripts/mutate.py --check         builds nothing: does the text of every mutant occur exactly once in its file, and is its test there?
    scripts/mutate.py --self-test     does --check report a text that is missing or occurs twice, and a test that is missing?
    --build FOLDER                    the build folder (default build/release), configured before

A mutant is a replacement of one piece of text in one file of shaders/ or src/. The file is changed in place, the one
program that holds the test is built and the test is run; then the file is as it was. Files with changes that are not
committed are not touched. Before that, every test has to pass without a mutant. Ends with 1 if a mutant survives: a
test is missing.
"""
import argparse
import fnmatch
import functools
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from mutants import MUTANTS, Mutant

ROOT = Path(__file__).resolve().parent.parent


def changed(path):
    return subprocess.run(["git", "diff", "--quiet", "HEAD", "--", path], cwd=ROOT).returncode != 0


def build(folder, target):
    return subprocess.run(["cmake", "--build", folder, "--target", target], cwd=ROOT, capture_output=True, text=True)


def run_test(folder, program, case):
    """True if the test failed, as it ought to."""
    environment = {**os.environ, "MESA_SHADER_CACHE_DISABLE": "true"}
    environment.pop("NULLSCOPE_RUN", None)   # a test at its whole quick depth
    if program == "cli":
        command = [sys.executable, "-B", str(ROOT / "tests/cli" / case), str(Path(folder) / "bin/nullscope")]
        return subprocess.run(command, cwd=ROOT, capture_output=True, env=environment).returncode != 0
    done = subprocess.run([str(Path(folder) / "bin" / program), f"-tc={case}", "--abort-after=1"], cwd=ROOT,
                          capture_output=True, env=environment, timeout=900)
    return done.returncode != 0


def occurrences(root, mutant):
    path = root / mutant.file
    return path.read_text().count(mutant.old) if path.is_file() else 0


@functools.cache
def cases_of(root, program):
    """Names of the test cases in the folder of a program's tests, joined where they go on in the next line."""
    text = "\n".join(path.read_text() for path in sorted((root / "tests" / program.removesuffix("_tests")).glob("*.cpp")))
    return ["".join(re.findall(r'"((?:[^"\\]|\\.)*)"', literals)) for literals in re.findall(r'TEST_CASE\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)', text)]


def has_test(root, program, case):
    if program == "cli":
        return (root / "tests/cli" / case).is_file()
    return any(fnmatch.fnmatchcase(name.lower(), case.lower()) for name in cases_of(root, program))   # as doctest's -tc matches


def check(root, mutants):
    """One line for each mutant whose text does not occur exactly once in its file, that changes nothing, or whose test is not there."""
    lost = [f"{mutant.name}: its text occurs {occurrences(root, mutant)} times in {mutant.file}"
            for mutant in mutants if occurrences(root, mutant) != 1]
    lost += [f"{mutant.name}: changes nothing" for mutant in mutants if mutant.old == mutant.new]
    return lost + [f"{mutant.name}: no test {': '.join(mutant.test)}" for mutant in mutants if not has_test(root, *mutant.test)]


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        (root / "a.txt").write_text("once twice twice")
        (root / "tests/unit").mkdir(parents=True)
        (root / "tests/unit/a.cpp").write_text('TEST_CASE("a: first "\n"part, and more" * test::costly()) {}')
        there = ("unit_tests", "a: first part*")
        samples = [Mutant(name, "", file, old, new, test) for name, file, old, new, test in [
            ("good", "a.txt", "once", "x", there), ("missing", "a.txt", "never", "x", there), ("twice", "a.txt", "twice", "x", there),
            ("no-file", "b.txt", "once", "x", there), ("equal", "a.txt", "once", "once", there),
            ("no-case", "a.txt", "once", "x", ("unit_tests", "first*")), ("no-test", "a.txt", "once", "x", ("cli", "test_a.py"))]]
        reported = [line.split(":")[0] for line in check(root, samples)]
        if reported != ["missing", "twice", "no-file", "equal", "no-case", "no-test"]:
            print(f"mutate: the self-test reported {reported}", file=sys.stderr)
            return 1
    return 0


def plant(folder, mutant):
    path = ROOT / mutant.file
    if occurrences(ROOT, mutant) != 1:
        return f"NOT PLANTED: its text occurs {occurrences(ROOT, mutant)} times"
    if changed(mutant.file):
        return "NOT PLANTED: the file has changes that are not committed"
    program, case = mutant.test
    text = path.read_text()
    try:
        path.write_text(text.replace(mutant.old, mutant.new))
        built = build(folder, "nullscope" if program == "cli" else program)
        if built.returncode != 0:
            return "NOT BUILT: " + built.stdout.strip().splitlines()[-1]
        return "caught" if run_test(folder, program, case) else "SURVIVED"
    finally:
        path.write_text(text)


def run(folder, chosen):
    for program, case in sorted({mutant.test for mutant in chosen}):
        built = build(folder, "nullscope" if program == "cli" else program)
        if built.returncode != 0 or run_test(folder, program, case):
            print(f"mutate: {program}: {case} fails without any mutant", file=sys.stderr)
            return 1
    bad = 0
    print("| mutant | where | test | |\n|---|---|---|---|", flush=True)
    for mutant in chosen:
        started = time.monotonic()
        verdict = plant(folder, mutant)
        bad += verdict != "caught"
        print(f"| {mutant.what} | {mutant.file} | {': '.join(mutant.test)} | {verdict} |", flush=True)
        print(f"mutate: {mutant.name}: {verdict} ({time.monotonic() - started:.0f} s)", file=sys.stderr, flush=True)
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    parser.add_argument("--build", default=str(ROOT / "build/release"))
    options = parser.parse_args()
    names = [mutant.name for mutant in MUTANTS]
    if options.list:
        print("\n".join(names))
        return 0
    if options.self_test:
        return self_test()
    if options.check:
        lost = check(ROOT, MUTANTS)
        print("\n".join(lost) or f"mutate: each of {len(MUTANTS)} mutants finds its text once, and its test")
        return 1 if lost else 0
    unknown = [name for name in options.names if name not in names]
    if unknown:
        print(f"mutate: no such mutant: {', '.join(unknown)}", file=sys.stderr)
        return 2
    return run(options.build, [mutant for mutant in MUTANTS if not options.names or mutant.name in options.names])


if __name__ == "__main__":
    sys.exit(main())
