#!/usr/bin/env python3
"""Frame rate and delay of nullscope-viewer while the picture is dragged, with a software driver, and how soon the whole
picture is there.

Usage: measure_motion.py VIEWER [--scenes A,B] [--size WxH] [--seconds S] [--coarse N] [--telescope] [--check]
What is promised for 1280x720 on two quiet cores: 20 pictures a second, 95 % of them within 100 ms of their input, whole 0.5 s after the
hand rests (1 s for kerr). --check (with NULLSCOPE_TESTS=quick for first-light alone) holds what of that does not depend on what else the
machine does: the processor time of a picture in motion and of the whole one, divided by the machine's slowness (tests/machine.py), and the
pictures that are drawn between an input and what follows it. --telescope: with that panel open. Of up to three runs the best counts, for whoever else runs only adds.
Exit status 0: measured, and kept; 1: broken; 77: Xvfb or xdotool is missing.
"""
import argparse
import math
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

from viewer_process import EVERYTHING, Viewer
from x_screen import Screen, missing_tools, wait_until

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from machine import slowness  # noqa: E402

MOTION_S = 2 / 20                                  # two cores, 20 pictures a second
WHOLE_S, WHOLE_OF_KERR_S = 2 * 0.5, 2 * 1.0        # two cores, half a second, and one
MOST_BEHIND = 3.0                                  # pictures: one is drawn, one is shown
RUNS = 3
MOUSE_HZ = 125                                     # of an ordinary mouse


class Mouse:
    """Moves of a mouse by one xdotool: one for each would take a quarter of a core from the viewer."""
    def __init__(self, screen):
        self.hands = subprocess.Popen(["xdotool", "-"], env={**os.environ, "DISPLAY": screen.display}, stdin=subprocess.PIPE, text=True)

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.hands.stdin.close()
        self.hands.wait()

    def move(self, x, y):
        self.hands.stdin.write(f"mousemove {x} {y}\n")
        self.hands.stdin.flush()
        time.sleep(1 / MOUSE_HZ)


def drag(v, width, height, seconds, down=0.55):
    """What one drag measures: see said(). down: where it begins, of the height."""
    x, y, reach = 0.55 * width, down * height, 0.1 * width
    v.hands("mousemove", int(x), int(y), "mousedown", 1)
    at, begun, steps, before = v.log.size(), time.monotonic(), 0, v.spent()
    shown = lambda: [float(turn["age_ms"]) for turn in v.log.turns(at) if float(turn["age_ms"]) > 0]
    with Mouse(v.screen) as mouse:
        while time.monotonic() - begun < seconds or len(shown()) < 10:
            angle = steps / 10.0
            mouse.move(int(x + reach * math.sin(angle)), int(y + 0.6 * reach * (1.0 - math.cos(angle))))
            steps += 1
    sizes = sorted((turn["size"].split("x") for turn in v.log.turns(at) if float(turn["age_ms"]) > 0), key=lambda size: int(size[0]))
    ages, spent_s, wall_s = sorted(shown()), v.spent() - before, time.monotonic() - begun
    v.hands("mouseup", 1)
    rested, before = time.monotonic(), v.spent()

    def whole():
        last = v.log.turns(at)[-1]
        return last["picture"] == "whole" and last["work"] == "0"
    wait_until("the whole picture", whole, 60, every_s=0.005)
    return {"rate": len(ages) / wall_s, "delay_ms": ages[int(0.95 * (len(ages) - 1))], "whole_s": time.monotonic() - rested,
            "size": "x".join(sizes[len(sizes) // 2]), "motion_cpu_s": spent_s / len(ages), "whole_cpu_s": v.spent() - before,
            "behind": statistics.median(ages) / 1000 * len(ages) / wall_s}


def said(scene, m):
    return (f"{scene}: {m['rate']:.1f} pictures of {m['size']} a second, 95 % within {m['delay_ms']:.0f} ms of their input, whole after {m['whole_s']:.2f} s; "
            f"processor time of a picture {m['motion_cpu_s']:.3f} s, of the whole one {m['whole_cpu_s']:.2f}, divided by the slowness; "
            f"{m['behind']:.1f} pictures behind")


def kept(scene, m):
    return (m["motion_cpu_s"] <= MOTION_S and m["whole_cpu_s"] <= (WHOLE_OF_KERR_S if scene == "kerr" else WHOLE_S) and
            m["behind"] <= MOST_BEHIND)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("viewer")
    parser.add_argument("--scenes", default="first-light,kerr")
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--seconds", type=float, default=4.0 if EVERYTHING else 2.0)
    parser.add_argument("--coarse", default="1", help="pictures have 1/N of the window's width and height")
    parser.add_argument("--telescope", action="store_true")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if missing_tools():
        return 77
    os.environ.update(LIBGL_ALWAYS_SOFTWARE="1")
    width, height = map(int, options.size.split("x"))
    screen, good = Screen(width + 40, height + 40), True
    try:
        for scene in options.scenes.split(",") if EVERYTHING or not options.check else ["first-light"]:
            v = Viewer(screen, os.path.abspath(options.viewer), "--size", options.size, "--coarse", options.coarse, scene=scene)
            try:
                v.start()
                if options.telescope:
                    v.settle("key", "t")
                v.rests()     # programs that make motion cheaper are compiled meanwhile
                for run in range(RUNS):
                    slow = slowness()
                    measured = drag(v, width, height, options.seconds, down=0.7 if options.telescope else 0.55)
                    slow = (slow + slowness()) / 2
                    measured.update({name: value / slow for name, value in measured.items() if name.endswith("_cpu_s")})
                    print(said(scene, measured), flush=True)
                    if kept(scene, measured) or not options.check:
                        break
                good = good and (kept(scene, measured) or not options.check)
            finally:
                v.kill()
    finally:
        screen.close()
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
