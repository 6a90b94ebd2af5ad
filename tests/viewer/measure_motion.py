#!/usr/bin/env python3
"""Frame rate and delay of nullscope-viewer while the picture is dragged, with a software driver, and how soon the whole
picture is there.

Usage: measure_motion.py VIEWER [--scenes A,B] [--size WxH] [--seconds S] [--check]
--check: holds (with NULLSCOPE_TESTS=quick for first-light alone) what is promised for 1280x720 on two cores: 20 pictures
a second, 95 % of them within 100 ms of their input, whole 0.5 s after the hand rests (1 s for kerr). Of up to three runs
the best counts, for whoever else runs only adds.
Exit status 0: measured, and promises kept; 1: broken; 77: Xvfb or xdotool is missing.
"""
import argparse
import math
import os
import sys
import time

from viewer_process import EVERYTHING, Viewer
from x_screen import Screen, missing_tools, wait_until

LEAST_RATE, MOST_DELAY_MS = 20.0, 100.0
WHOLE_S = {"kerr": 1.0}    # others: 0.5
RUNS = 3
BEGIN_S = 6.0 if EVERYTHING else 4.0              # programs that make motion cheaper are compiled meanwhile


def drag(v, width, height, seconds):
    """(pictures a second, 95th percentile of their age in ms, s until the whole picture)."""
    x, y, reach = 0.55 * width, 0.55 * height, 0.1 * width
    v.hands("mousemove", int(x), int(y), "mousedown", 1)
    at, begun, steps = v.log.size(), time.monotonic(), 0
    while time.monotonic() - begun < seconds:
        angle = steps / 10.0
        v.hands("mousemove", int(x + reach * math.sin(angle)), int(y + 0.6 * reach * (1.0 - math.cos(angle))))
        steps += 1
    turns, spent = v.log.turns(at), time.monotonic() - begun
    v.hands("mouseup", 1)
    rested = time.monotonic()

    def whole():
        last = v.log.turns(at)[-1]
        return last["picture"] == "whole" and last["work"] == "0"
    wait_until("the whole picture", whole, 60, every_s=0.005)
    whole_s = time.monotonic() - rested
    ages = sorted(float(turn["age_ms"]) for turn in turns if float(turn["age_ms"]) > 0)
    return len(ages) / spent, ages[int(0.95 * (len(ages) - 1))], whole_s


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("viewer")
    parser.add_argument("--scenes", default="first-light,kerr")
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--seconds", type=float, default=4.0 if EVERYTHING else 2.0)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if missing_tools():
        return 77
    os.environ.update(LIBGL_ALWAYS_SOFTWARE="1")
    width, height = map(int, options.size.split("x"))
    screen, kept = Screen(width + 40, height + 40), True
    try:
        for scene in options.scenes.split(",") if EVERYTHING or not options.check else ["first-light"]:
            v = Viewer(screen, os.path.abspath(options.viewer), "--size", options.size, scene=scene)
            try:
                v.start()
                time.sleep(BEGIN_S)
                for run in range(RUNS):
                    rate, delay_ms, whole_s = drag(v, width, height, options.seconds)
                    print(f"{scene}: {rate:.1f} pictures a second, 95 % within {delay_ms:.0f} ms of their input, whole after {whole_s:.2f} s",
                          flush=True)
                    good = rate >= LEAST_RATE and delay_ms <= MOST_DELAY_MS and whole_s <= WHOLE_S.get(scene, 0.5)
                    if good or not options.check:
                        break
                kept = kept and (good or not options.check)
            finally:
                v.kill()
    finally:
        screen.close()
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
