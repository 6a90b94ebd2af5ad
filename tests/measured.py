#!/usr/bin/env python3
"""Runs a command and notes what it cost: adds a line to FILE: NAME, processor seconds, wall seconds and
the slowness of the machine meanwhile (machine.py), between tabs.

Usage: measured.py [--failures-first] FILE NAME COMMAND...

Exit status: the command's. Processor seconds are those of the command and of everything it started and waited for, user and
system. With --failures-first what the command prints comes when it
has ended, and what failed in it (doctest's ERROR, unittest's FAIL and ERROR, FAILED) before all else: who reads the
beginning of a log sees it.
"""
import os
import re
import resource
import subprocess
import sys
import time

from machine import slowness

FAILURE = re.compile(r"^(FAIL|FAILED|ERROR)\b|: (FATAL )?ERROR: ")


def failures(text, most=20, after=7):
    """The lines of the first failures, each with those after it."""
    lines, shown, left = text.splitlines(), [], 0
    for line in lines:
        if FAILURE.search(line) and most > 0:
            most, left = most - 1, after
        if left > 0:
            shown.append(line)
            left -= 1
    return "\n".join(shown)


def run(command, failures_first):
    if not failures_first:
        return subprocess.call(command)
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    if done.returncode not in (0, 77):   # 77: skipped
        print(f"FAILED, status {done.returncode}:\n{failures(done.stdout)}\n--- all of it:")
    print(done.stdout, end="", flush=True)
    return done.returncode


def main():
    failures_first = sys.argv[1] == "--failures-first"
    file, name, *command = sys.argv[2 if failures_first else 1:]
    slow = slowness()
    began = time.monotonic()
    status = run(command, failures_first)
    wall = time.monotonic() - began
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    slow = (slow + slowness()) / 2
    os.makedirs(os.path.dirname(file), exist_ok=True)
    with open(file, "a", encoding="utf-8") as out:   # one short write each, so that two tests at once do not mix
        out.write(f"{name}\t{used.ru_utime + used.ru_stime:.2f}\t{wall:.2f}\t{slow:.2f}\n")
    return status if status >= 0 else 128 - status


if __name__ == "__main__":
    sys.exit(main())
