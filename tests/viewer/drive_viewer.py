#!/usr/bin/env python3
"""Uses nullscope-viewer as a person would, on a screen of its own, and looks at the pixels.

Usage: drive_viewer.py VIEWER [CASE...]     (VIEWER: the program; CASE: names of test functions without "test_")

Exit status 0: all passed; 1: some failed; 77: Xvfb or xdotool is missing.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import traceback
from pathlib import Path

from x_screen import Screen, read_png, wait_until

WIDTH, HEIGHT = 840, 600
SCENE = """[camera]
r = 22.0
theta = 80.0
roll = -6.0
fov = 62.0
[disc]
"""
PICTURE = (320, 300, 820, 560)     # of the window: no panel lies here
PANEL = (10, 60, 284, 515)
SIDE, KEYS, FIELD = (10, 60, 280, 300), (300, 10, 830, 180), (110, 92, 180, 106)
LETTERS = bytes([230, 232, 237])   # the theme's text
NOISE = 0.002                      # share of bytes: single pixels on the edge of rounding
CURSOR = 0.01                       # share of bytes: the pointer itself is a part of the screen
CHANGED = 0.02
RELOAD = (240, 26)                 # the button
LEGEND, BESIDE_LEGEND = (560, 470, 836, 574), (320, 300, 550, 560)   # of the overlay's colours
HEADERS = [(150, 377), (150, 252), (150, 52)]   # lens, boost, camera; each where it is while those above are open
ALONE = (150, 227)                 # the section's header while nothing else is open
METHOD, WORDS = (190, 413), (14, 453, 284, 515)   # the box and what is chosen and why
AUTO = (150, 26)                   # the first entry of its list while the list is not scrolled
LEAST, MOST = (108, 438), (266, 438)              # of the slider for the largest error
WRONG_FATE = bytes([255, 0, 255])
INSET, RAY = (600, 200, 820, 560), bytes([120, 200, 255])   # the probe's, and the colour of its ray
CLOCK, RUN, DELAY = (150, 302), (60, 327), (112, 402)   # the last header while nothing else is open; its button and its box
EFFECTS = (150, 252)               # the section's header while nothing else is open, and its rows
EFFECT_ROW = lambda row: (30, 277 + 25 * row)
BODIES = """[sphere]
radius = 1.8
texture = "checker"
[ball]
position = [6, 6, -3]
radius = 3
texture = "noise"
"""
RIGHT = (560, 200, 820, 560)       # the ball is there, the tooltip of a row is not
CALLED_FOR = ["lensing", "disc", "disc-image", "sphere", "ball"]   # of SCENE + BODIES, those of the table up to the ball


def row_of(effect):
    """Which row of the panel is an effect's: the table's order, of those that the scene calls for."""
    table = (Path(__file__).resolve().parents[2] / "src" / "scene" / "effects.h").read_text()
    return [key for key in re.findall(r'\{Effect::k\w+, "([\w-]+)"', table) if key in CALLED_FOR].index(effect)


HITCH_MS = 300
# A turn is long also when other programs hold the cores: at a load of 8 on two cores the longest was 212, 292 and 602 ms in three tries.
# Such a wait comes in one try and not in the next; waiting for the compiler comes in each, as the test in one context shows.
HITCH_TRIES = 3
BESIDE = (420, 40)                 # a place for the pointer outside of all these areas
MEASURED_S = 120.0                 # for a frame's errors, on a machine that is busy
SETTLED_S = 0.4                    # without a change: the wheel's motion and the panels have come to rest


class Viewer:
    """A running viewer with its window at the screen's corner."""

    def __init__(self, screen, program, *arguments, scene=SCENE):
        self.screen, self.folder = screen, tempfile.mkdtemp(prefix="nullscope-viewer.")
        self.scene = Path(self.folder) / "scene.toml"
        self.scene.write_text(scene)
        self.env = {**os.environ, "DISPLAY": screen.display}
        self.process = subprocess.Popen([program, self.scene.name, *arguments], cwd=self.folder, env=self.env,
                                        stderr=subprocess.PIPE, text=True)
        self.window = None

    def start(self):
        self.window = wait_until("the window", self.find)
        self.hands("windowfocus", self.window)
        wait_until("the first picture", lambda: self.picture().mean() > 1)
        self.still()

    def find(self):
        assert self.process.poll() is None, f"the viewer ended early: {self.process.stderr.read()}"
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "nullscope"], env=self.env,
                               capture_output=True, text=True).stdout.split()
        return found[0] if found else None

    def hands(self, *words):
        return self.screen.hands(*words)

    def picture(self, area=PICTURE):
        return self.screen.picture(*area)

    def click(self, x, y):
        """On a panel; Dear ImGui 1.86 sees the pointer where it is during a frame, not where it was at the click."""
        for step in [["mousemove", x, y], ["mousedown", 1], ["mouseup", 1], ["mousemove", *BESIDE]]:
            self.hands(*step)
            self.still()

    def click_until(self, what, x, y, condition):
        """Again when the click went unseen, as it may on a machine that is too busy for stillness to mean that a frame
        has been drawn since."""
        for _ in range(3):
            self.click(x, y)
            end = time.monotonic() + 10.0
            while time.monotonic() < end:
                if condition():
                    return
                time.sleep(0.1)
        raise AssertionError(f"three clicks at {x}, {y} in vain: {what}")

    def toggle(self, x, y):
        before = self.picture(PANEL)
        self.click_until("the header opens or shuts", x, y, lambda: self.picture(PANEL).differing(before) > CHANGED)

    def still(self, area=(0, 0, WIDTH, HEIGHT), timeout_s=30.0):
        """The picture once the area's pixels have stayed the same for a while."""
        state = {"data": None, "since": 0.0}

        def unchanged():
            data = self.picture(area).data
            if data != state["data"]:
                state.update(data=data, since=time.monotonic())
            return time.monotonic() - state["since"] > SETTLED_S
        wait_until("the screen comes to rest", unchanged, timeout_s)
        return self.picture()

    def settle(self):
        """The picture once everything that was sent before has been answered, however slow the machine is."""
        self.answer()
        return self.still()

    def changes(self, what, before, area=PICTURE):
        wait_until(what, lambda: self.picture(area).differing(before) > CHANGED)

    def count(self, area, colour):
        data = self.picture(area).data
        return sum(data[i:i + 3] == colour for i in range(0, len(data), 3))

    def refused(self):
        """Pixels of red letters: thin strokes reach their colour, (255, 133, 115), in some versions of Dear ImGui only."""
        data = self.picture(WORDS).data
        return sum(data[i] > 150 and 2 * data[i + 1] < 1.2 * data[i] and data[i + 2] < data[i + 1] for i in range(0, len(data), 3))

    def shows_keys(self):
        """Whether the list of F1 is there, by the colour of its letters."""
        return self.count(KEYS, LETTERS) > 20

    def spent(self):
        """Processor time, s."""
        fields = Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def rests(self):
        """What was begun may take its time; then the processor is left alone."""
        def idle():
            before = self.spent()
            time.sleep(1.0)
            return self.spent() - before < 0.2
        wait_until("less than 0.2 s of processor time in a second", idle, MEASURED_S)

    def answer(self):
        """Everything that was sent before has been seen when F1's list is there and gone again."""
        for shown in (True, False):
            self.hands("key", "F1")
            wait_until(f"F1 {'shows' if shown else 'hides'} the keys", lambda: self.shows_keys() == shown)

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()
        shutil.rmtree(self.folder, ignore_errors=True)


def same(one, other, what, allowed=NOISE):
    share = one.differing(other)
    assert share <= allowed, f"{what}: {share:.2%} of the bytes differ"


def shift_between(before, after, reach):
    """(dx, dy) by which the picture's middle moved, in px; coarse pixels, all shifts up to reach."""
    def distance(dx, dy):
        total = 0
        for y in range(reach, before.height - reach, 6):
            for x in range(reach, before.width - reach, 6):
                total += abs(before.grey(x, y) - after.grey(x + dx, y + dy))
        return total
    steps = range(-reach, reach + 1, 5)
    return min(((dx, dy) for dx in steps for dy in steps), key=lambda shift: distance(*shift))


def test_motion_without_a_drag_changes_nothing(v):
    before = v.settle()
    for x, y in [(400, 320), (700, 500), (330, 550), BESIDE]:
        v.hands("mousemove", x, y)
    v.answer()
    same(before, v.picture(), "after motion without a drag")


def test_a_drag_moves_what_is_grabbed_with_the_hand(v):
    v.hands("mousemove", *BESIDE)
    before = v.settle()
    v.hands("mousemove", 560, 420, "mousedown", 1, "mousemove", 600, 440)
    v.changes("a drag turns the camera", before)
    dragged = v.settle()
    v.hands("mousemove", 700, 300, "mousemove", 560, 420)
    v.settle()
    same(before, v.picture(), "after the hand came back", CURSOR)
    v.hands("mousemove", 600, 440, "mouseup", 1, "mousemove", *BESIDE)
    after = v.settle()
    same(dragged, after, "after the button was let go", CURSOR)
    dx, dy = shift_between(before, after, 60)
    assert abs(dx - 40) <= 10 and abs(dy - 20) <= 10, f"the hand went 40 px right, 20 down, the picture {dx} and {dy}"
    v.hands("mousemove", 640, 500, "mousemove", *BESIDE)
    v.answer()
    same(after, v.picture(), "after motion that follows the drag")


def test_a_drag_on_a_panel_does_not_turn_the_camera(v):
    before = v.settle()
    for step in [["mousemove", 60, 450], ["mousedown", 1], ["mousemove", *BESIDE], ["mouseup", 1]]:
        v.hands(*step)
        v.still()
    v.answer()
    same(before, v.picture(), "after a drag that began on the panel")


def test_right_drag_rolls(v):
    before = v.settle()
    v.hands("mousemove", 700, 300, "mousedown", 3, "mousemove", 700, 420, "mouseup", 3, "mousemove", *BESIDE)
    v.changes("a right drag rolls the camera", before)


def test_keys_and_wheel_move_and_r_comes_back(v):
    v.hands("mousemove", *BESIDE, "key", "r")
    home = v.settle()
    for name, press, release in [("W", ["keydown", "w"], ["keyup", "w"]), ("D", ["keydown", "d"], ["keyup", "d"]),
                                 ("space", ["keydown", "space"], ["keyup", "space"]),
                                 ("E", ["keydown", "e"], ["keyup", "e"]),
                                 ("wheel", ["click", 4], ["click", 4]),
                                 ("shift and wheel", ["keydown", "shift", "click", 5], ["click", 5, "keyup", "shift"])]:
        v.hands(*press)
        v.changes(f"{name} moves the camera", home)
        v.hands(*release)
        v.settle()     # the wheel's motion runs on for a while
        v.hands("key", "r")
        same(home, v.settle(), f"R after {name}")


def test_typing_a_number_does_not_fly(v):
    shots = []
    for text in ["14", "w14"]:     # w is no part of a number, and no flight while a field has the keyboard
        v.hands("mousemove", *BESIDE, "key", "r")
        before, field = v.settle(), v.picture(FIELD)
        v.hands("mousemove", 200, 98, "click", 1)
        wait_until("a field takes the keyboard", lambda: v.picture(FIELD).data != field.data)
        for key in ["ctrl+a", *text, "Return"]:     # Dear ImGui 1.86 sees keys that are down during a frame
            v.hands("key", "--delay", 200, key)
        v.changes("a radius that is typed in takes effect", before)
        shots.append(v.settle())
    same(*shots, "between 14 and w14")
    v.hands("mousemove", *BESIDE, "key", "r")


def test_a_broken_scene_is_said_and_survived(v):
    good = v.scene.read_text()
    v.hands("mousemove", *BESIDE, "key", "r")
    before, side = v.settle(), v.picture(SIDE)
    for text, what in [("[camera]\nr = -1\n", "error"), (good.replace("r = 22.0", "r = 12.0"), "mended")]:
        v.scene.write_text(text)
        v.click(*RELOAD)
        if what == "error":
            v.changes("the panel shows the error", side, SIDE)
            same(before, v.settle(), "the picture of a scene that became unreadable")
        else:
            v.changes("the mended scene is read", before)
    v.scene.write_text(good)
    v.click(*RELOAD)
    same(before, v.settle(), "after reading the first scene again")


def test_tab_hides_the_panels(v):
    before = v.settle()
    side = v.picture(SIDE)
    v.hands("key", "Tab")
    v.changes("Tab hides the panels", side, SIDE)
    same(before, v.settle(), "the picture beside the panels")
    hidden = v.picture(SIDE)
    v.hands("key", "Tab")
    v.changes("Tab brings the panels back", hidden, SIDE)


def test_f12_saves_the_picture_without_panels(v):
    shown = v.settle()
    v.hands("key", "F12")
    path = wait_until("F12 saves a file", lambda: next(Path(v.folder).glob("nullscope-*.png"), None))
    saved = read_png(path)
    assert (saved.width, saved.height) == (WIDTH, HEIGHT), f"saved {saved.width}x{saved.height}"
    same(saved.crop(*PICTURE), shown, "the saved picture beside the panels")
    v.hands("key", "Tab")
    v.settle()
    same(saved.crop(*SIDE), v.picture(SIDE), "the saved picture below the panels")
    v.hands("key", "Tab")
    path.unlink()


def test_at_rest_it_leaves_the_processor_alone(v):
    v.settle()
    v.rests()


def test_h_lays_the_errors_over_the_picture(v):
    v.hands("mousemove", *BESIDE, "key", "r")
    before = v.settle()
    assert v.count(LEGEND, WRONG_FATE) == 0, "the legend is there before"
    v.hands("key", "h")
    v.changes("H lays the errors over the picture", before)
    wait_until("the legend is there", lambda: v.count(LEGEND, WRONG_FATE) > 40)
    first = v.picture()
    v.changes("the colours grow finer", first)
    measured = v.still(timeout_s=MEASURED_S)
    v.rests()
    left = v.picture(BESIDE_LEGEND)
    stars = sum(min(left.data[i:i + 3]) > 120 for i in range(0, len(left.data), 3))
    assert stars < 20, f"the picture still shows through: {stars} bright pixels"
    v.hands("keydown", "e")     # the picture in flight, then the errors of where it came to rest
    wait_until("in flight the picture is seen", lambda: v.picture().mean() > 1.5 * measured.mean())
    v.hands("keyup", "e", "key", "r")
    v.still(timeout_s=MEASURED_S)
    wait_until("the same errors at the same place", lambda: v.picture().differing(measured) <= NOISE)
    v.hands("key", "h")
    same(before, v.settle(), "the picture after the overlay")
    assert v.count(LEGEND, WRONG_FATE) == 0, "the legend is still there"
    v.rests()


def entry(method):
    """Where the open list of methods shows one: below auto, in the order of the file that ships."""
    lines = (Path(__file__).resolve().parents[2] / "assets" / "frontier.csv").read_text().splitlines()
    names = [line.split(",")[1] for line in lines if line.startswith("schwarzschild,")]
    return AUTO[0], AUTO[1] + 19 * (1 + names.index(method))


def test_p_shows_the_ray_under_the_cursor(v):
    v.hands("mousemove", 500, 200)
    v.settle()
    before = v.picture(INSET)
    v.hands("key", "p")
    v.changes("the inset", before, INSET)
    v.still()
    first = v.picture(INSET)
    assert v.count(INSET, RAY) > 20, "no ray is drawn"
    v.hands("mousemove", 420, 250)
    wait_until("another ray", lambda: v.picture(INSET).differing(first) > NOISE)
    v.hands("key", "p")
    v.hands("mousemove", 500, 200)
    wait_until("the picture alone", lambda: v.picture(INSET).differing(before) <= NOISE)


def test_the_accuracy_section_chooses_refuses_and_measures(v):
    v.hands("mousemove", *BESIDE, "key", "r")
    before = v.settle()
    for header in HEADERS:
        v.toggle(*header)
    v.toggle(*ALONE)
    v.still(timeout_s=MEASURED_S)
    v.rests()
    same(before, v.picture(), "the picture beside the section")
    usual = v.picture(WORDS)
    assert v.refused() == 0, "0.05 px is refused"
    v.click_until("1e-4 px is refused in words", *LEAST, lambda: v.refused() > 20)
    v.click_until("10 px is granted", *MOST, lambda: v.refused() == 0)
    wait_until("the words name what was asked", lambda: v.picture(WORDS).differing(usual) > 0)
    granted = v.picture(WORDS)
    v.click(*METHOD)
    coarse = entry("table:64:bilinear")     # some 0.3 px off in this frame
    v.hands("mousemove", *coarse)
    v.still()
    v.click(*coarse)
    v.changes("the words name the method chosen by hand", granted, WORDS)
    v.still(timeout_s=MEASURED_S)
    v.hands("key", "h")
    v.still(timeout_s=MEASURED_S)
    reds = v.picture(BESIDE_LEGEND).data[::3]
    worse = sum(red > 120 for red in reds) / len(reds)      # yellow to white: above some 0.03 px
    assert worse > 0.02, f"a coarse table is as exact as the strip: {worse:.1%} of the pixels are above 0.03 px"
    v.hands("key", "h")
    v.settle()
    v.click(*METHOD)
    v.hands("mousemove", 150, 300)     # the list begins where the method in use is
    v.hands("click", "--repeat", 10, "--delay", 200, 4)
    v.click(*AUTO)
    v.still(timeout_s=MEASURED_S)
    same(before, v.picture(), "the picture of auto")
    v.toggle(*ALONE)
    for header in reversed(HEADERS):
        v.toggle(*header)
    same(before, v.settle(), "the picture afterwards")


def test_resizing_keeps_the_horizontal_field_of_view(v):
    v.hands("windowsize", v.window, 600, 500)
    def saved_size():
        for old in Path(v.folder).glob("nullscope-*.png"):
            old.unlink()
        v.hands("key", "F12")
        path = wait_until("F12 saves a file", lambda: next(Path(v.folder).glob("nullscope-*.png"), None))
        picture = read_png(path)
        return picture if (picture.width, picture.height) == (600, 500) else None
    small = wait_until("a picture of the new size", saved_size)
    assert small.mean() > 1, "the picture of the new size is black"
    v.hands("windowsize", v.window, WIDTH, HEIGHT)
    v.settle()


def test_escape_quits(v):
    v.hands("key", "Escape")
    assert v.process.wait(timeout=30) == 0, f"exit status {v.process.returncode}"


def run(program, *arguments, **changes):
    env = {name: value for name, value in {**os.environ, **changes}.items() if value is not None}
    return subprocess.run([program, *arguments], env=env, capture_output=True, text=True, timeout=60)


def test_screenshot(screen, program, folder):
    for more in [[], ["--hidden"], ["--hidden", "--after-frames", "7"]]:
        path = folder / "window.png"
        done = run(program, "sky-only", "--size", "640x360", "--screenshot", path, *more, DISPLAY=screen.display)
        assert done.returncode == 0, f"{more}: exit status {done.returncode}: {done.stderr}"
        picture = read_png(path)
        assert (picture.width, picture.height) == (640, 360) and picture.mean() > 1, f"{more}: not a picture of 640x360"
        path.unlink()


def turns_of(path, first=0):
    """What --turns wrote from line `first` on: (when s, how long ms, programs, whether at work)."""
    lines = path.read_text().splitlines()[first:]
    return [(float(a), float(b), int(c), int(d)) for a, b, c, d in (line.split() for line in lines)]


class Effects:
    """A viewer whose effects panel is open, with what it writes of its turns."""

    def __init__(self, screen, program, *arguments):
        self.viewer = Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--turns", "turns.txt", *arguments,
                             scene=SCENE + BODIES)
        self.log = Path(self.viewer.folder) / "turns.txt"

    def start(self):
        self.viewer.start()
        for header in HEADERS:
            self.viewer.toggle(*header)
        self.viewer.toggle(*EFFECTS)

    def switch(self, row, what):
        """The turns while it works, and every picture seen on the way."""
        v, first, seen = self.viewer, len(turns_of(self.log)), []
        before = v.picture(RIGHT)
        programs = turns_of(self.log)[-1][2]
        v.hands("mousemove", *EFFECT_ROW(row))
        v.still()
        v.hands("mousedown", 1)
        v.still()
        v.hands("mouseup", 1)
        end = time.monotonic() + MEASURED_S
        while not seen or seen[-1].differing(before) <= CHANGED:
            assert time.monotonic() < end, f"waited in vain: {what}"
            seen.append(v.picture(RIGHT))
            time.sleep(0.05)
        v.hands("mousemove", *BESIDE)
        v.still()
        after = v.picture(RIGHT)
        turns = turns_of(self.log, first)
        return before, after, seen, turns, turns[-1][2] - programs


def switches(screen, program):
    """The longest turn, ms, while the ball goes and comes back, in a viewer of its own; the pictures seen are judged."""
    effects, longest = Effects(screen, program), 0
    try:
        effects.start()
        for what, compiled in [("the ball goes", 1), ("the ball comes back", 0)]:
            before, after, seen, turns, programs = effects.switch(row_of("ball"), what)
            assert programs == compiled, f"{what}: {programs} programs compiled instead of {compiled}"
            slowest = max(turn[1] for turn in turns)
            print(f"    {what}: longest turn of {len(turns)} is {slowest:.0f} ms, {programs} compiled, {len(seen)} looks", flush=True)
            for picture in seen:     # the last picture until the next is whole
                kept = min(picture.differing(before), picture.differing(after))
                assert kept <= CURSOR, f"{what}: neither the picture before nor the one after: {kept:.1%} differ from both"
            longest = max(longest, slowest)
    finally:
        effects.viewer.kill()
    return longest


def test_an_effect_is_switched_without_a_hitch(screen, program, folder):
    tries = []
    while len(tries) < HITCH_TRIES and (not tries or tries[-1] >= HITCH_MS):
        tries.append(switches(screen, program))
    assert min(tries) < HITCH_MS, f"the longest turns of {len(tries)} tries took {', '.join(f'{t:.0f}' for t in tries)} ms"


def test_without_a_second_context_the_hitch_is_seen(screen, program, folder):
    """That the test before can fail, in each of its tries: the same in one context."""
    for _ in range(HITCH_TRIES):
        effects = Effects(screen, program, "--one-context")
        try:
            effects.start()
            _, _, _, turns, programs = effects.switch(row_of("ball"), "the ball goes")
            longest = max(turn[1] for turn in turns)
            print(f"    in one context: longest turn {longest:.0f} ms", flush=True)
            assert programs == 1 and longest > HITCH_MS, f"{programs} programs; the longest turn took {longest:.0f} ms"
        finally:
            effects.viewer.kill()


def test_exposure_follows_like_an_eye(screen, program, folder):
    """Towards the dark sky: the picture is there, and goes on growing brighter without a hand."""
    v = Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", scene=SCENE + '[picture]\nauto_exposure = "on"\n')
    try:
        v.start()
        for step in [["mousemove", 800, 300], ["mousedown", 1]]:
            v.hands(*step)
            v.still()
        before = v.picture()
        v.hands("mousemove", 320, 540)
        v.changes("the drag turns the camera", before)
        means, end = [], time.monotonic() + 2.0
        while time.monotonic() < end:
            means.append(v.picture().mean())
            time.sleep(0.05)
        v.hands("mouseup", 1)
        v.still()
        last = v.picture().mean()
        dark, steps = min(means), len({round(mean, 3) for mean in means})
        print(f"    mean {dark:.2f} to {last:.2f} of 255 in {steps} pictures", flush=True)
        assert steps >= 5, f"exposure jumped: {steps} pictures"
        assert last > 1.2 * dark, f"from {dark:.2f} to {last:.2f}: exposure did not follow"
    finally:
        v.kill()


def test_the_clock_runs_and_stops(screen, program, folder):
    """A ball goes on while the clock runs, stays where it is when it stops, and jumps when its light takes no time."""
    v = Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", scene=SCENE.replace("[disc]", "") + '[ball]\nposition = [6, 0, 0]\nmotion = "orbit"\n')
    try:
        v.start()
        for header in HEADERS:
            v.hands("mousemove", *header, "click", 1)
            v.still()
        v.hands("mousemove", *CLOCK, "click", 1)
        v.still()
        before = v.picture()
        v.hands("mousemove", *RUN, "click", 1)
        for _ in range(2):
            v.changes("the ball moves", before)
            before = v.picture()
        v.hands("mousemove", *RUN, "click", 1)
        before = v.still()
        v.hands("mousemove", *DELAY, "click", 1)
        v.changes("light that takes no time shows it elsewhere", v.picture() if before is None else before)
    finally:
        v.kill()


def test_bad_input(screen, program, folder):
    scene = folder / "bad.toml"
    scene.write_text("[camera]\nr = -1\n")
    for arguments in [[scene], ["no-such-scene"], ["--size", "12"], ["--screenshot", "x.jpg"], ["--hidden"], ["--no"]]:
        done = run(program, *arguments, DISPLAY=screen.display)
        assert done.returncode == 2, f"{arguments}: exit status {done.returncode}"
        assert done.stderr.strip(), f"{arguments}: no word on what is wrong"
    line = run(program, scene, DISPLAY=screen.display).stderr
    assert line.count("\n") == 1 and "bad.toml:2: camera.r" in line, f"not one line with file, line and key: {line}"


def test_no_display(screen, program, folder):
    for display, words in [(None, "DISPLAY is not set"), (":9999", ":9999")]:
        done = run(program, DISPLAY=display, WAYLAND_DISPLAY=None)
        assert done.returncode == 1, f"exit status {done.returncode}"
        assert "display" in done.stderr and words in done.stderr and "nullscope capture" in done.stderr, done.stderr


def test_old_opengl(screen, program, folder):
    done = run(program, DISPLAY=screen.display, MESA_GL_VERSION_OVERRIDE="2.1")
    assert done.returncode == 1, f"exit status {done.returncode}"
    assert "3.3" in done.stderr and "2.1" in done.stderr and "display" not in done.stderr, done.stderr


WITH_WINDOW = [test_motion_without_a_drag_changes_nothing, test_a_drag_moves_what_is_grabbed_with_the_hand,
               test_a_drag_on_a_panel_does_not_turn_the_camera, test_right_drag_rolls,
               test_keys_and_wheel_move_and_r_comes_back, test_typing_a_number_does_not_fly,
               test_a_broken_scene_is_said_and_survived, test_tab_hides_the_panels,
               test_at_rest_it_leaves_the_processor_alone, test_h_lays_the_errors_over_the_picture,
               test_p_shows_the_ray_under_the_cursor,
               test_the_accuracy_section_chooses_refuses_and_measures, test_f12_saves_the_picture_without_panels,
               test_resizing_keeps_the_horizontal_field_of_view, test_escape_quits]
FROM_OUTSIDE = [test_an_effect_is_switched_without_a_hitch, test_without_a_second_context_the_hitch_is_seen, test_exposure_follows_like_an_eye, test_the_clock_runs_and_stops, test_screenshot, test_bad_input, test_no_display, test_old_opengl]


def attempt(test, *arguments):
    start = time.monotonic()
    try:
        test(*arguments)
    except (AssertionError, subprocess.SubprocessError, OSError) as error:
        print(f"FAILED {test.__name__}: {error}", flush=True)
        if not isinstance(error, AssertionError):
            traceback.print_exc()
        return False
    print(f"passed {test.__name__} ({time.monotonic() - start:.1f} s)", flush=True)
    return True


def main():
    missing = [tool for tool in ("Xvfb", "xdotool") if shutil.which(tool) is None]
    if missing:
        print(f"skipped: {' and '.join(missing)} not installed")
        return 77
    program = str(Path(sys.argv[1]).resolve())
    chosen = lambda tests: [t for t in tests if len(sys.argv) < 3 or t.__name__.removeprefix("test_") in sys.argv[2:]]
    os.environ.update(LIBGL_ALWAYS_SOFTWARE="1", MESA_SHADER_CACHE_DISABLE="true")
    screen, folder, good = Screen(WIDTH + 100, HEIGHT + 100), Path(tempfile.mkdtemp(prefix="nullscope-drive.")), True
    viewers = []
    try:
        if chosen(WITH_WINDOW):
            def test_start():
                viewers.append(Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}"))
                viewers[0].start()
            good = attempt(test_start)
        for test in chosen(WITH_WINDOW) if good else []:
            good = attempt(test, viewers[0]) and good
        for test in chosen(FROM_OUTSIDE):
            good = attempt(test, screen, program, folder) and good
    finally:
        for viewer in viewers:
            viewer.kill()
        screen.close()
        shutil.rmtree(folder, ignore_errors=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
