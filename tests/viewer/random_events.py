#!/usr/bin/env python3
"""Random mouse and key events for nullscope-viewer: it stays a window that answers, and what it saves can be read.

Usage: random_events.py VIEWER [--seconds S] [--seeds N] [--first-seed K] [--size WxH] [--nullscope PROGRAM]
Each seed starts with another scene that ships. Without --first-seed or NULLSCOPE_SEED each run has other ones, which it prints. A viewer that was told to quit (status 0) is started again; any other end is a failure.
Exit status 0: all seeds passed; 1: some failed; 77: Xvfb or xdotool is missing.
"""
import argparse
import os
import random
import subprocess
import sys
import time
from pathlib import Path

from viewer_process import EVERYTHING, HUNG_S, Viewer, dice
from x_screen import Screen, missing_tools, wait_until

SCENES = ["first-light", "kerr", "wormhole", "kerr-spot", "kerr-planet", "two-spacetimes", "starlight", "torus", "neutron-star",
          "hot-spot"]
KEYS = ["w", "a", "s", "d", "q", "e", "c", "space", "r", "h", "p", "l", "Tab", "F1", "F9", "F11", "F12", "F5", "Return", "BackSpace",
        "ctrl+z", "ctrl+shift+z", "ctrl+y", "ctrl+o", "ctrl+e", "ctrl+t", "ctrl+s", "ctrl+c", "ctrl+v", "ctrl+plus", "ctrl+minus", "b", "ctrl+b", "x",
        "1", "7", "0", "minus", "period", "Left", "Right"]


def act(v, chance, width, height):
    place = lambda: (chance.randrange(width), chance.randrange(height))
    kind = chance.random()
    if kind < 0.35:
        v.hands("mousemove", *place(), "mousedown", 1)
        time.sleep(0.05)
        v.hands("mouseup", 1)
    elif kind < 0.55:
        v.hands("mousemove", *place(), "mousedown", chance.choice([1, 1, 2, 3]))
        for _ in range(chance.randrange(1, 6)):
            v.hands("mousemove", *place())
        v.hands("mouseup", 1, "mouseup", 2, "mouseup", 3)
    elif kind < 0.65:
        v.hands("mousemove", *place(), *["click", chance.choice([4, 5])] * chance.randrange(1, 4))
    elif kind < 0.9:
        v.hands("key", chance.choice(KEYS))
    elif kind < 0.97:
        key = chance.choice("wasdqec")
        v.hands("keydown", key)
        time.sleep(0.3 * chance.random())
        v.hands("keyup", key)
    else:
        v.hands("windowsize", v.window, chance.randrange(200, width), chance.randrange(150, height))


def one_seed(screen, options, seed, width, height):
    chance, starts, end = random.Random(seed), 0, time.monotonic() + options.seconds
    actions = 0
    while time.monotonic() < end:
        starts += 1
        v = Viewer(screen, os.path.abspath(options.viewer), "--size", options.size, scene=SCENES[(seed + starts) % len(SCENES)])
        try:
            v.window = wait_until("the window", v.find, HUNG_S)
            v.hands("windowfocus", v.window)
            while time.monotonic() < end and v.process.poll() is None:
                try:
                    act(v, chance, width, height)
                except subprocess.CalledProcessError:    # the window has just gone
                    time.sleep(0.2)
                actions += 1
            if v.process.poll() is not None:
                assert v.process.returncode == 0, f"status {v.process.returncode}: {v.process.stderr.read()[-6000:]}"
                continue
            v.hands("keyup", "ctrl", "keyup", "shift", "mouseup", 1, "mouseup", 2, "mouseup", 3)
            at = v.log.size()
            v.hands("windowsize", v.window, width, height, "mousemove", width // 2, 4)
            wait_until("it answers", lambda: v.log.turns(at), HUNG_S)
            for saved in Path(v.folder).glob("*.toml"):
                done = subprocess.run([options.nullscope, "plan", saved], capture_output=True, text=True)
                assert done.returncode == 0 or "scene.toml" in str(saved), f"{saved.name}: {done.stderr.strip()}"
        finally:
            v.kill()
    print(f"seed {seed}: {actions} actions, {starts} viewers", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("viewer")
    parser.add_argument("--seconds", type=float, default=20.0 if "NULLSCOPE_EVERYTHING" in os.environ else 10.0 if EVERYTHING else 4.0)
    parser.add_argument("--seeds", type=int, default=3 if "NULLSCOPE_EVERYTHING" in os.environ else 2 if EVERYTHING else 1)
    parser.add_argument("--first-seed", type=int)
    parser.add_argument("--size", default="1000x640")
    parser.add_argument("--nullscope", help="the program that reads what was saved (default: beside the viewer)")
    options = parser.parse_args()
    first = dice().randrange(10 ** 6) if options.first_seed is None else options.first_seed
    options.nullscope = options.nullscope or str(Path(options.viewer).resolve().parent / "nullscope")
    if missing_tools():
        return 77
    os.environ.update(LIBGL_ALWAYS_SOFTWARE="1")
    width, height = map(int, options.size.split("x"))
    screen, good = Screen(width + 40, height + 40), True
    try:
        for seed in range(first, first + options.seeds):
            try:
                one_seed(screen, options, seed, width, height)
            except AssertionError as failure:
                print(f"FAILED seed {seed}: {failure}", flush=True)
                good = False
    finally:
        screen.close()
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
