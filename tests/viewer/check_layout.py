#!/usr/bin/env python3
"""Opens every panel of nullscope-viewer at three sizes of the window and three of the text: no words are cut off, none lie on others,
no window on another or beyond the screen.

Usage: check_layout.py VIEWER [--sizes WxH,...] [--scales S,...] [--pictures FOLDER]
The viewer says where its words are (src/viewer/layout_log.h); the test finds by them what it clicks. --pictures keeps a picture of each step.
NULLSCOPE_TESTS=quick: the smallest window with the largest text, without tooltips; all: that with tooltips and one of the others, another
in each run (NULLSCOPE_SEED=n repeats that of a run that printed n); NULLSCOPE_EVERYTHING: all of it, some 7 minutes.
Exit status 0: nothing is wrong; 1: something is, and it is listed; 77: Xvfb or xdotool is missing.
"""
import argparse
import itertools
import os
import re
import sys
import tempfile
from pathlib import Path

from panel_list import panels
from viewer_process import EVERYTHING, Viewer, dice, keep_programs
from x_screen import Screen, missing_tools

SIZES, SCALES = ["1280x720", "1920x1080", "3840x2160"], ["1", "1.5", "2"]
SECTIONS = ["Camera", "Speed of the camera", "Lens", "Disc", "Sky", "Light", "Spacetime", "Accuracy", "Effects", "Free fall", "Clock", "Numbers"]
INSIDE = {"Scene": "##sections"}     # a window's own part that is scrolled
MENUS = ["File", "Edit", "View", "Add", "Path", "Help"]
OVER_OTHERS = ["##keys", "About_nullscope", "Guided_tours", "##Tooltip", "##Menu", "##message", "##hints", "##MainMenuBar", "##Popup", "##Combo"]


def covers(layout):
    """Which windows lie on others."""
    for (one, a), (other, b) in itertools.combinations(sorted(layout.windows.items()), 2):
        covered = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0]), min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
        if min(covered) > 1 and not any(name.startswith(top) for name in (one, other) for top in OVER_OTHERS):
            yield f"{one} {a} covers {other} {b}"


class Reader:
    """A viewer, and what was wrong in it."""

    def __init__(self, program, viewer, label, pictures, with_tooltips):
        self.program = program
        self.viewer, self.label, self.pictures, self.found, self.layout = viewer, label, pictures, set(), None
        self.with_tooltips = with_tooltips

    def look(self, what, *words):
        self.viewer.settle(*words)
        layout = self.viewer.layout()
        faults = [*layout.faults, *covers(layout)]
        for fault in faults:
            if fault not in self.found:
                print(f"{self.label}, {what}: {fault}", flush=True)
        self.found.update(faults)
        if self.pictures:
            width, height = (int(side) for side in self.label.split()[0].split("x"))
            picture = self.viewer.picture((0, 0, width, height))
            name = re.sub(r"[^\w.-]+", "-", f"{self.label}-{what}") + ".ppm"
            (Path(self.pictures) / name).write_bytes(b"P6 %d %d 255\n" % (width, height) + picture.data)
        self.layout = layout
        return layout

    def find(self, what, words, window):
        """Where they are, after the window was turned to them."""
        layout = self.layout
        for button in [4] * 20 + [5] * 40:
            if place := layout.place(words, window):
                return place
            name = next(name for name in layout.windows if name.startswith(window))
            left, top, across, down = layout.windows[name]
            layout = self.look(what, "mousemove", left + across - 20, top + down // 2, "click", button)
        raise AssertionError(f"no words {words!r} in {window}: {[t[1] for t in layout.texts]}")

    def click(self, what, words, window):
        x, y = self.find(what, words, window)
        self.viewer.settle("mousemove", x, y, "mousedown", 1)
        return self.look(what, "mouseup", 1)

    def tooltips(self, window):
        """The pointer on every word at the window's left."""
        if not self.with_tooltips:
            return
        left = self.layout.windows[window][0]
        for name, words, (x, y, width, height) in self.layout.texts:
            if name.startswith((window, INSIDE.get(window, window))) and x < left + 40 * float(self.label.split("*")[1]):
                self.look(f"tooltip of {words}", "mousemove", x + width // 2, y + height // 2)


def check(reader, width, height):
    away = ["mousemove", width - 3, height // 2]
    reader.look("start", *away)
    for name in MENUS:
        reader.click(f"menu {name}", name, "##MainMenuBar")
        reader.look("menu closed", "key", "Escape", *away)
    for name in ["Camera", "Speed of the camera", "Lens"]:     # open at first
        reader.click(f"section {name}", name, "##side")
    for name in SECTIONS:
        reader.click(f"section {name}", name, "##side")
        reader.tooltips("##side")
        reader.look("sections", *away)
        reader.click(f"section {name}", name, "##side")
    reader.look("a bookmark", "key", "ctrl+b")
    for name, keys, _ in panels(reader.program):
        key = keys if re.fullmatch(r"Tab|F\d+", keys) else keys.lower()     # as xdotool has it
        reader.look(f"without {name}" if name == "Panels" else name, *away, *(["key", key] if key else []))
        if not key:
            reader.click("menu Help", "Help", "##MainMenuBar")
            if not reader.layout.place(name, "##Menu"):
                reader.look("closed", *away, "key", "Escape")
                reader.click("menu View", "View", "##MainMenuBar")
            reader.click(name, name, "##Menu")
        if name == "Scene editor":
            reader.tooltips("Scene")
        reader.look("closed", *away, "key", key or "Escape")
    for what, keys in [("errors", ["h"]), ("gallery", ["ctrl+o"]), ("comparison", ["x"])]:
        reader.look(what, *away, *(word for key in keys for word in ("key", key)))
        reader.look("closed", *away, "key", "Escape" if what == "gallery" else keys[-1])
    reader.look("zoom", "mousemove", 2 * width // 3, height // 2, "keydown", "z", *["click", 4] * 20, "keyup", "z")
    reader.look("closed", *away, "key", "r")
    reader.look("editor and timeline", "key", "ctrl+e", "key", "ctrl+t")
    reader.look("closed", "key", "ctrl+e", "key", "ctrl+t")
    reader.click("menu View", "View", "##MainMenuBar")
    reader.click("embedding diagram", "Embedding diagram", "##Menu")
    reader.look("embedding diagram, image orders and ray", "key", "o", "key", "p", "mousemove", 2 * width // 3, height // 2)
    reader.look("embedding diagram and image orders", "key", "p", *away)
    reader.look("embedding diagram, image orders and editor", "key", "ctrl+e", *away)
    reader.look("embedding diagram, image orders and timeline", "key", "ctrl+e", "key", "ctrl+t", *away)
    reader.look("closed", "key", "ctrl+t", "key", "o")
    reader.click("menu View", "View", "##MainMenuBar")
    reader.click("closed", "Embedding diagram", "##Menu")
    for words in ["Numbers", "km", "Numbers"]:
        reader.click("numbers in km", words, "##side")
    reader.look("ray in km", "key", "p", "mousemove", 2 * width // 3, height // 2)
    reader.look("closed", "key", "p", *away)
    reader.click("menu Help", "Help", "##MainMenuBar")
    reader.click("tours", "Guided tours", "##Menu")
    reader.click("first tour", "Why is the shadow", "Guided_tours")
    for step in range(2, 8 if EVERYTHING else 4):
        reader.look(f"step {step} of the tour", "key", "Next")
    reader.look("closed", "key", "Escape")
    reader.look("ray of a pixel", "key", "p", "mousemove", 2 * width // 3, height // 2)
    reader.click("menu View", "View", "##MainMenuBar")
    reader.click("effective potential", "Effective potential", "##Menu")
    reader.look("effective potential", "mousemove", 2 * width // 3, height // 2)
    reader.look("closed", "key", "p", *away)
    reader.click("menu View", "View", "##MainMenuBar")
    reader.click("clock and redshift", "Clock and redshift", "##Menu")
    reader.look("clock and record", *away, "key", "F9")
    reader.look("clock, record and editor", "key", "ctrl+e")
    reader.look("closed", "key", "F9", "key", "ctrl+e")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("viewer")
    parser.add_argument("--sizes", default=",".join(SIZES))
    parser.add_argument("--scales", default=",".join(SCALES))
    parser.add_argument("--pictures")
    parser.add_argument("--coarse", default="8", help="pictures under the panels are rendered at 1/N of the window's resolution (default: 8)")
    options = parser.parse_args()
    if missing_tools():
        return 77
    programs = tempfile.TemporaryDirectory(prefix="nullscope-layout.")
    keep_programs(Path(programs.name))
    sizes, scales = options.sizes.split(","), options.scales.split(",")
    wrong, every = 0, "NULLSCOPE_EVERYTHING" in os.environ
    hardest, *others = sorted(itertools.product(sizes, scales), key=lambda kind: kind != (sizes[0], scales[-1]))
    for size, scale in [hardest, *(others if every or not others else [dice().choice(others)] if EVERYTHING else [])]:
        width, height = map(int, size.split("x"))
        screen = Screen(width + 40, height + 40)
        viewer = Viewer(screen, os.path.abspath(options.viewer), "--size", size, "--coarse", options.coarse, "--layout", "layout.txt",
                        settings=f"text_scale = {float(scale)}\n")
        with_tooltips = every or (EVERYTHING and (size, scale) == hardest)
        reader = Reader(options.viewer, viewer, f"{size} text *{scale}", options.pictures, with_tooltips)
        try:
            viewer.start()
            check(reader, width, height)
            wrong += len(reader.found)
            print(f"{reader.label}: {len(reader.found)} faults", flush=True)
        finally:
            viewer.kill()
            screen.close()
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
