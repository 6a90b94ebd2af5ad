"""Measures how long `nullscope capture` takes to its first picture: no test, for documents and before-and-after comparisons.

Usage: measure_start.py PATH-OF-NULLSCOPE [ANOTHER-NULLSCOPE ...] [--runs N] [--size WxH] [--scenes A,B]

Of each scene and program the median wall time and its spread, the least processor time, page faults and resident memory, from a new
process each, without the driver's shader cache; programs are run in turn. Wall times mean something on a quiet machine only.
"""
import argparse
import os
import statistics
import subprocess
import tempfile
import time


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


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--runs", type=int, default=9)
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--scenes", default="sky-only,first-light,accretion,kerr")
    options = parser.parse_args()
    print(f"load before: {os.getloadavg()[0]:.1f}; {options.runs} runs, {options.size}")
    print("| scene | program | wall, s (least ... most) | processor, s | page faults | resident, MB |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for scene in options.scenes.split(","):
            runs = {program: [] for program in options.programs}
            for _ in range(options.runs):
                for program in options.programs:
                    runs[program].append(one(program, scene, options.size, folder))
            for number, program in enumerate(options.programs):
                wall, cpu, faults, resident = zip(*runs[program])
                print(f"| {scene} | {number + 1} | {statistics.median(wall):.2f} ({min(wall):.2f} ... {max(wall):.2f}) | {min(cpu):.2f} | "
                      f"{min(faults)} | {min(resident):.0f} |", flush=True)


if __name__ == "__main__":
    main()
