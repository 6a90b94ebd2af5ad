"""Measures how long `nullscope capture` takes to its first picture: no test, for documents and before-and-after comparisons.

Usage: measure_start.py PATH-OF-NULLSCOPE [ANOTHER-NULLSCOPE ...] [--runs N] [--size WxH] [--scenes A,B]

A program named nullscope-viewer is started on a screen of its own (Xvfb); its first picture, a coarse one, is what it says itself
(--turns), and its processor time is that until then.

Of each scene and program the median wall time and its spread, the least processor time, page faults and resident memory, from a new
process each, without the driver's shader cache; programs are run in turn. Wall times mean something on a quiet machine only.
"""
import argparse
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "viewer"))
from x_screen import Screen  # noqa: E402


def one(binary, scene, size, folder):
    begin = time.monotonic()
    child = subprocess.Popen([binary, "capture", scene, "--size", size, "-o", os.path.join(folder, "start.png")], stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL, env={**os.environ, "MESA_SHADER_CACHE_DISABLE": "true"})
    _, status, used = os.wait4(child.pid, 0)
    wall = time.monotonic() - begin
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise SystemExit(f"{binary} capture {scene}: status {child.returncode}")
    return wall, used.ru_utime + used.ru_stime, used.ru_minflt, used.ru_maxrss / 1024


def one_viewer(binary, scene, size, folder, screen):
    turns = Path(folder) / "turns.txt"
    turns.unlink(missing_ok=True)
    child = subprocess.Popen([binary, scene, "--size", size, "--turns", turns], cwd=folder, stdout=subprocess.DEVNULL,
                             env={**os.environ, "XDG_CONFIG_HOME": str(folder), "XDG_STATE_HOME": str(folder), "DISPLAY": screen.display,
                                  "LIBGL_ALWAYS_SOFTWARE": "1", "MESA_SHADER_CACHE_DISABLE": "true"})
    first = None
    while first is None and child.poll() is None:
        time.sleep(0.01)
        first = re.search(r"^first t=(\S+) cpu=(\S+) .*\n", turns.read_text() if turns.exists() else "", re.M)
    child.kill()
    _, _, used = os.wait4(child.pid, 0)
    child.returncode = -9
    if first is None:
        raise SystemExit(f"{binary} {scene}: ended before its first picture")
    return float(first[1]), float(first[2]), used.ru_minflt, used.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--runs", type=int, default=9)
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--scenes", default="sky-only,first-light,accretion,kerr")
    options = parser.parse_args()
    print(f"load before: {os.getloadavg()[0]:.1f}; {options.runs} runs, {options.size}")
    print("| scene | program | wall, s (least ... most) | processor, s | page faults | resident, MB |\n|---|---|---|---|---|---|")
    views = [program for program in options.programs if Path(program).name == "nullscope-viewer"]
    screen = Screen(*(int(n) + 20 for n in options.size.split("x"))) if views else None
    with tempfile.TemporaryDirectory() as folder:
        for scene in options.scenes.split(","):
            runs = {program: [] for program in options.programs}
            for _ in range(options.runs):
                for program in options.programs:
                    at = os.path.abspath(program)
                    runs[program].append(one_viewer(at, scene, options.size, folder, screen) if program in views else
                                         one(at, scene, options.size, folder))
            for number, program in enumerate(options.programs):
                wall, cpu, faults, resident = zip(*runs[program])
                print(f"| {scene} | {number + 1} | {statistics.median(wall):.2f} ({min(wall):.2f} ... {max(wall):.2f}) | {min(cpu):.2f} | "
                      f"{min(faults)} | {min(resident):.0f} |", flush=True)
    if screen:
        screen.close()


if __name__ == "__main__":
    main()
