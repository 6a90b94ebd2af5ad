"""A running viewer, its hands and eyes: what the cases of drive_viewer.py are made of."""
import contextlib
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import depth
from dice import dice  # noqa: F401  for the cases
from machine import slowness, spent_s  # noqa: F401  bounds on processor time are divided by the slowness
from x_screen import wait_until

# else a few cases are shorter
EVERYTHING = depth.deep()
WIDTH, HEIGHT = 840, 600
COMPILING = {"MESA_SHADER_CACHE_DISABLE": "true"}   # a viewer's environment: no program that was compiled before
UNDER_STARS = """[camera]
r = 22.0
theta = 80.0
roll = -6.0
fov = 62.0
[disc]
"""
SCENE = UNDER_STARS + '[sky]\nkind = "checker"\n'     # a sky that needs no time to be computed
BODIES = """[sphere]
radius = 1.8
texture = "checker"
[ball]
position = [6, 6, -3]
radius = 3
texture = "noise"
"""
# Areas of the window, and places in it.
PICTURE = (320, 300, 820, 490)     # no panel and no message lies here
MENU = 21                          # px of the menu bar, above the panel
ADDED = (300, 60, 830, 460)       # where a planet is put
PANEL = (10, 60 + MENU, 284, 515 + MENU)
SIDE, KEYS = (10, 60 + MENU, 280, 300), (300, 10 + MENU, 830, 180 + MENU)
BESIDE = (420, 40)                 # a place for the pointer outside of all these areas
RELOAD = (240, 26 + MENU)                 # the button
LEGEND, BESIDE_LEGEND = (560, 470, 836, 574), (320, 300, 550, 490)   # of the overlay's colours
HEADERS = [(150, 377 + MENU), (150, 252 + MENU), (150, 52 + MENU)]   # lens, boost, camera; each where it is while those above are open
ALONE = (150, 227 + MENU)                 # the accuracy section's header while nothing else is open
METHOD, WORDS = (190, 413 + MENU), (14, 453 + MENU, 284, 515 + MENU)   # the box and what is chosen and why
AUTO = (150, 26 + MENU)                   # the first entry of its list while the list is not scrolled
LEAST, MOST = (108, 438 + MENU), (266, 438 + MENU)              # of the slider for the largest error
INSET = (600, 200, 820, 490)       # the probe's
# the last header while nothing else is open; its button and its box
CLOCK, RUN, DELAY = (150, 302 + MENU), (60, 327 + MENU), (112, 402 + MENU)
LIGHT, LENSING = (150, 177 + MENU), (112, 202 + MENU)   # the section's header while nothing else is open, and its first box
# the section's header while nothing else is open, its box and the last entry of the box's list; what the panel refuses
SPACETIME, METRIC, FLAT, REFUSAL = (150, 202 + MENU), (190, 227 + MENU), (140, 424 + MENU), (14, 40 + MENU, 284, 90 + MENU)
EFFECTS = (150, 252 + MENU)               # the section's header while nothing else is open, and its rows
EFFECT_ROW = lambda row: (30, 277 + MENU + 25 * row)
EDITOR, EDITOR_SEARCH, EDITOR_ADD, EDITOR_FIELD = (480, 60, 830, 200), (560, 69), (770, 69), (720, 142)
RESTORE = (520, 239)
FIRST_TOUR, TOUR, TOUR_NEXT, TOUR_BACK = (260, 190), (300, 470, 830, 570), (400, 555), (333, 555)
TOUR_CLOSE = (800, 555)
TOURED, GALLERY_TOUR = (320, 60, 820, 400), (160, 65)     # no panel and no message lies in the first
FIRST_CARD, HINTS = (120, 150), (320, 440, 640, 515)
MENUS = {name: (x, 10) for name, x in [("File", 24), ("Edit", 62), ("View", 104), ("Add", 146), ("Path", 188), ("Help", 231)]}
RIGHT = (560, 200, 820, 490)       # the ball is there, the tooltip of a row is not
BOOKMARK, BOOKMARK_PICTURE, BOOKMARK_RESTORE, NOT_SHOWN = (306, 440, 470, 532), (350, 470), (495, 529), (302, 414, 460, 434)
# Colours.
LETTERS = bytes([230, 232, 237])   # the theme's text
WRONG_FATE, RAY = bytes([255, 0, 255]), bytes([120, 200, 255])
# Shares of bytes.
NOISE = 0.002                      # single pixels on the edge of rounding
CURSOR = 0.01                      # the pointer itself is a part of the screen
CHANGED = 0.02
# Keys that do nothing in the viewer, by their names and GLFW's numbers: in turn the last of what is sent, so that the
# viewer's word on which key it has seen last tells that it has seen all before.
MARKS = [("Pause", 284), ("Scroll_Lock", 281)]
HUNG_S = 600.0                     # no bound on how long anything takes: a test that hangs shall end
MEASURED_S = 900.0                 # the same for all of a frame's errors


def keep_programs(folder):
    """What one viewer has compiled serves the next, but those with COMPILING: kept where the caller keeps it, else in this folder."""
    caller_keeps = os.environ.get("MESA_SHADER_CACHE_DISABLE") != "true" and "MESA_SHADER_CACHE_DIR" in os.environ
    os.environ.update(LIBGL_ALWAYS_SOFTWARE="1", MESA_SHADER_CACHE_DISABLE="false")
    if not caller_keeps:
        os.environ["MESA_SHADER_CACHE_DIR"] = str(folder / "shaders")


def same(one, other, what, allowed=NOISE):
    share = one.differing(other)
    assert share <= allowed, f"{what}: {share:.2%} of the bytes differ"


class Log:
    """What --turns wrote (src/viewer/loop_log.h): lines as (word, {name: value})."""

    def __init__(self, path):
        self.path = path

    def size(self):
        return self.path.stat().st_size if self.path.exists() else 0

    def since(self, at=0):
        if not self.path.exists():
            return []
        with open(self.path, "rb") as file:
            file.seek(at)
            text = file.read().decode()
        whole = text[:text.rfind("\n") + 1].splitlines()   # the last line may not be complete
        return [(line.split()[0], dict(pair.split("=") for pair in line.split()[1:])) for line in whole]

    def turns(self, at=0):
        return [values for word, values in self.since(at) if word == "turn"]


class Layout:
    """What --layout layout.txt wrote (src/viewer/layout_log.h): windows, texts as (window, words, rectangle), and faults."""

    def __init__(self, text):
        self.windows, self.texts, self.faults = {}, [], []
        for line in text.splitlines():
            kind, *rest = line.split(" ", 1)
            if kind == "window":
                name, *numbers = rest[0].split(" ")
                self.windows[name] = tuple(map(int, numbers))
            elif kind == "text":
                name, x, y, width, height, words = rest[0].split(" ", 5)
                self.texts.append((name, words, tuple(map(int, (x, y, width, height)))))
            elif kind == "fault":
                self.faults.append(rest[0])

    def place(self, words, window):
        """The middle of the first words that begin so."""
        for name, text, (x, y, width, height) in self.texts:
            if text.startswith(words) and name.startswith(window):
                return x + width // 2, y + height // 2
        return None

    def words(self):
        """What the panels say, each with its middle."""
        return {words: (x + width // 2, y + height // 2) for _, words, (x, y, width, height) in self.texts}


def shipped(name):
    return (Path(__file__).resolve().parents[2] / "assets" / "scenes" / f"{name}.toml").read_text()


class Viewer:
    """A running viewer with its window at the screen's corner."""

    def __init__(self, screen, program, *arguments, scene=SCENE, first_visit=False, home=None, settings="", environment={}):
        self.screen, self.folder, self.marks = screen, tempfile.mkdtemp(prefix="nullscope-viewer."), 0
        self.scene = Path(self.folder) / "scene.toml"
        self.scene.write_text(scene if "\n" in scene else shipped(scene))
        self.settings = Path(home or self.folder) / "nullscope" / "viewer.toml"
        self.log = Log(Path(self.folder) / "turns.txt")
        self.env = {**os.environ, "DISPLAY": screen.display, "XDG_CONFIG_HOME": home or self.folder,
                    "XDG_STATE_HOME": home or self.folder, **environment}
        if not first_visit:
            self.settings.parent.mkdir(exist_ok=True)
            self.settings.write_text("hints_seen = true\n" + settings)
        self.begun = time.time()
        self.process = subprocess.Popen([program, self.scene.name, "--turns", self.log.path, *arguments],
                                        cwd=self.folder, env=self.env, stderr=subprocess.PIPE, text=True)
        self.window = None

    def start(self):
        self.window = wait_until("the window", self.find)
        self.settle("windowfocus", self.window, "mousemove", *BESIDE)

    def find(self):
        assert self.process.poll() is None, f"the viewer ended early: {self.process.stderr.read()}"
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "nullscope"], env=self.env,
                               capture_output=True, text=True).stdout.split()
        return found[0] if found else None

    def title(self):
        return subprocess.run(["xdotool", "getwindowname", self.window], env=self.env, capture_output=True, text=True).stdout.strip()

    def hands(self, *words):
        return self.screen.hands(*words)

    def picture(self, area=PICTURE):
        return self.screen.picture(*area)

    def send(self, *words, measured=False):
        """Does what the words say, all of it in one frame, on fast machines and slow ones; a question: was all of it answered, and
        does the viewer rest? measured: the errors and the effects' times too."""
        at, (name, number) = self.log.size(), MARKS[self.marks % len(MARKS)]
        self.marks += 1
        with self.stopped():
            self.hands(*words, "key", name)

        def rests():
            assert self.process.poll() is None, f"the viewer ended: {self.process.stderr.read()}"
            word, values = (self.log.since(at) or [("", {})])[-1]
            return word == "rest" and int(values["key"]) == number and not (measured and values["measuring"] == "1")
        return rests

    def settle(self, *words, measured=False):
        """As send(); the picture once the viewer rests."""
        wait_until("the viewer comes to rest", self.send(*words, measured=measured),
                   MEASURED_S if measured else HUNG_S, every_s=0.01)
        return self.picture()

    @contextlib.contextmanager
    def stopped(self):
        self.process.send_signal(signal.SIGSTOP)
        try:
            yield
        finally:
            self.process.send_signal(signal.SIGCONT)

    def click(self, x, y):
        """On a panel; Dear ImGui 1.86 sees the pointer where it is during a frame, not where it was at the click."""
        for step in [["mousemove", x, y, "mousedown", 1], ["mouseup", 1], ["mousemove", *BESIDE]]:
            self.settle(*step)

    def choose(self, menu, entry):
        """Of a viewer with --layout layout.txt."""
        self.click(*MENUS[menu])
        self.click(*self.layout().place(entry, "##Menu"))

    def toggle(self, x, y):
        before = self.picture(PANEL)
        self.click(x, y)
        assert self.picture(PANEL).changed(before, CHANGED), f"no header at {x}, {y} opens or shuts"

    def changes(self, what, before, area=PICTURE):
        wait_until(what, lambda: self.picture(area).changed(before, CHANGED), HUNG_S)

    def layout(self):
        """Of a viewer with --layout layout.txt that rests."""
        return Layout((Path(self.folder) / "layout.txt").read_text())

    def count(self, area, colour):
        data = self.picture(area).data
        return sum(pixel == tuple(colour) for pixel in zip(data[::3], data[1::3], data[2::3]))

    def refused(self, area=WORDS):
        """Pixels of red letters: thin strokes reach (255, 133, 115) in some versions of Dear ImGui only."""
        data = self.picture(area).data
        return sum(r > 150 and 2 * g < 1.2 * r and b < g for r, g, b in zip(data[::3], data[1::3], data[2::3]))

    def spent(self):
        return spent_s(self.process.pid)

    def rests(self):
        """What was begun may take its time; then the processor is left alone."""
        def idle():
            before = self.spent()
            time.sleep(0.5)
            return self.spent() - before < 0.1
        wait_until("less than 0.1 s of processor time in half a second", idle, MEASURED_S)

    def __enter__(self):
        self.start()
        return self

    def __exit__(self, *_):
        self.kill()

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()
        shutil.rmtree(self.folder, ignore_errors=True)


def row_of(effect, called_for=("lensing", "disc", "disc-image", "sphere", "ball")):
    """Which row of the panel is an effect's: in the order of the enumerators, of those that SCENE + BODIES calls for."""
    folder = Path(__file__).resolve().parents[2] / "src" / "plan"
    order = re.findall(r"^    (k\w+),?$", (folder / "effects.h").read_text(), re.MULTILINE)
    features = "".join(path.read_text() for path in sorted(folder.glob("*.cpp")))
    keys = dict(re.findall(r'\{Effect::(k\w+),\s*"([\w-]+)"', features))
    return [keys[name] for name in order if keys[name] in called_for].index(effect)
