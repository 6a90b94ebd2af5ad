"""Tests of the Python package, run by the interpreter that has it (scripts/python.sh): test_NAME.py PATH-OF-NULLSCOPE."""
import resource
import subprocess
import sys
import unittest
from pathlib import Path

BINARY = sys.argv.pop(1)
ROOT = Path(__file__).resolve().parents[2]


def command_line(*arguments):
    return subprocess.run([BINARY, *map(str, arguments)], check=True, capture_output=True, text=True, timeout=600).stdout


def core_seconds(who=resource.RUSAGE_SELF):
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


def resident_bytes():
    return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()


def main():
    unittest.main(verbosity=1)
