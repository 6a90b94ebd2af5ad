#!/usr/bin/env python3
"""Runs a command and notes what it cost: adds a line "NAME<tab>processor seconds<tab>wall seconds" to FILE.

Usage: measured.py FILE NAME COMMAND...

Exit status: the command's. Processor seconds are those of the command and of everything it started and waited for, user and
system, so they hardly depend on what else the machine does.
"""
import os
import resource
import subprocess
import sys
import time


def main():
    file, name, *command = sys.argv[1:]
    began = time.monotonic()
    status = subprocess.call(command)
    wall = time.monotonic() - began
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    os.makedirs(os.path.dirname(file), exist_ok=True)
    with open(file, "a", encoding="utf-8") as out:   # one short write each, so that two tests at once do not mix
        out.write(f"{name}\t{used.ru_utime + used.ru_stime:.2f}\t{wall:.2f}\n")
    return status if status >= 0 else 128 - status


if __name__ == "__main__":
    sys.exit(main())
