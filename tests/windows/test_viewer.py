#!/usr/bin/env python3
"""nullscope-viewer.exe under Wine, used by real events of keyboard and mouse: opens, flies, looks around, saves a picture, closes.

Usage: test_viewer.py [CASE...]; prints a table of what was measured. Ends with 77, and says why, where there is no nullscope-viewer.exe, Wine, Xvfb or xdotool.
"""
import os
import subprocess
import tempfile
import time
import unittest
import zipfile
from pathlib import Path

from wine import FOLDER, VIEWER, Table, foreign_imports, leave_if_missing, screen_for_wine

from viewer_process import HUNG_S, MARKS, SCENE, Log
from x_screen import WindowCloser, read_png, wait_until

WIDTH, HEIGHT = 840, 600
PICTURE = (340, 320, 800, 480)   # no panel and no message lies here
GALLERY, GALLERY_CODES = (40, 120, 800, 300), 150   # pictures of scenes among text on one colour
ENDINGS = 8
CHANGED = 0.02                   # share of the bytes
TABLE = Table()


class Window(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="nullscope-windows-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name) / "na\u00efve 1"
        self.folder.mkdir()
        (self.folder / "scene.toml").write_text(SCENE)
        self.marks = 0
        self.log = Log(self.folder / "turns.txt")
        self.begun = time.monotonic()
        self.process = subprocess.Popen(["wine", str(VIEWER), "scene.toml", "--size", f"{WIDTH}x{HEIGHT}", "--turns", "turns.txt"], cwd=self.folder,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        self.addCleanup(self.process.communicate)
        self.addCleanup(self.process.kill)

    def find(self):
        if self.process.poll() is not None:
            self.fail(f"the viewer ended early, status {self.process.returncode}: {self.process.stderr.read().decode('utf-8', 'replace')}")
        return subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "nullscope"], capture_output=True, text=True).stdout.split()

    def rest_after(self, *words):
        """What xdotool does, and the picture once the viewer rests."""
        at, (name, number) = self.log.size(), MARKS[self.marks % len(MARKS)]
        self.marks += 1
        SCREEN.hands(*words, "key", name)

        def rests():
            if self.process.poll() is not None:
                self.fail(f"the viewer ended, status {self.process.returncode}: {self.process.stderr.read().decode('utf-8', 'replace')}")
            word, values = (self.log.since(at) or [("", {})])[-1]
            return word == "rest" and int(values["key"]) == number
        wait_until(f"rest after {' '.join(map(str, words))}", rests, HUNG_S)
        return SCREEN.picture(*PICTURE)

    def changes(self, what, before, *words):
        after = self.rest_after(*words)
        share = after.differing(before)
        self.assertGreater(share, CHANGED, f"{what} changes the picture")
        TABLE.row(what, f"changes {100 * share:.0f} % of the picture", f"at least {100 * CHANGED:.0f} %")
        return after

    def test_a_visit(self):
        window = wait_until("the window", self.find, HUNG_S)[0]
        TABLE.row("the window is there", f"after {time.monotonic() - self.begun:.1f} s", "")
        wait_until("the first whole picture", lambda: any(word == "rest" for word, _ in self.log.since()), HUNG_S)
        TABLE.row("the first picture is whole", f"after {time.monotonic() - self.begun:.1f} s", "")
        picture = self.rest_after("windowfocus", window, "mousemove", WIDTH // 2, HEIGHT - 150)
        self.assertGreater(len(set(picture.data)), 20, "there is a picture")
        at = (WIDTH // 2, HEIGHT - 150)
        picture = self.changes("key W, held for a second", picture, "keydown", "w", "sleep", 1, "keyup", "w")
        picture = self.changes("a drag of the mouse", picture, "mousemove", *at, "mousedown", 1, "mousemove", at[0] - 60, at[1] - 10, "sleep", 0.5, "mouseup", 1)
        picture = self.changes("the wheel", picture, "click", 4, "click", 4)

        SCREEN.hands("key", "F12")
        saved = wait_until("F12 saves a file", lambda: next(self.folder.glob("nullscope-*.png"), None), HUNG_S)
        wait_until("the file is whole", lambda: saved.read_bytes()[-8:-4] == b"IEND", HUNG_S)
        png = read_png(saved)
        self.assertGreater(len(set(png.data)), 20)
        TABLE.row("F12 saves a picture", f"{png.width}x{png.height}", "")

        closer = WindowCloser(os.environ["DISPLAY"])
        begun = time.monotonic()
        closer.close(int(window))
        closer.leave()
        _, said = self.process.communicate(timeout=HUNG_S)
        self.assertEqual(self.process.returncode, 0, said.decode("utf-8", "replace"))
        TABLE.row("the window's button closes it", f"status 0, after {time.monotonic() - begun:.1f} s", "status 0")


class Screenshot(unittest.TestCase):
    def test_it_ends(self):
        """The threads of the painter and of TBB do not wait for each other at the end: before, in six of ten runs."""
        with tempfile.TemporaryDirectory(prefix="nullscope-windows-") as folder:
            for run in range(ENDINGS):
                done = subprocess.run(["wine", str(VIEWER), "kerr", "--size", "640x360", "--screenshot", f"{run}.png"], cwd=folder, stdout=subprocess.DEVNULL,
                                      stderr=subprocess.PIPE, timeout=HUNG_S)
                self.assertEqual(done.returncode, 0, done.stderr.decode("utf-8", "replace"))
                self.assertGreater(len(set(read_png(Path(folder) / f"{run}.png").data)), 20)
        TABLE.row(f"--screenshot, {ENDINGS} times", "saved, and ended with status 0", "each")


class Archive(unittest.TestCase):
    def test_the_gallery(self):
        """What a user does: unpacks the archive, and starts the viewer in its folder."""
        archive = next(FOLDER.glob("nullscope-*-windows-x86_64.zip"), None)
        if archive is None:
            self.skipTest("there is no archive: scripts/windows.sh --zip")
        with tempfile.TemporaryDirectory(prefix="nullscope-windows-") as place:
            with zipfile.ZipFile(archive) as packed:
                packed.extractall(place)
            (folder,) = Path(place).iterdir()
            self.assertIn("Start nullscope-viewer.exe in this folder.", (folder / "README.txt").read_text())
            process = subprocess.Popen(["wine", "./nullscope-viewer.exe"], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                       env={key: value for key, value in os.environ.items() if key != "NULLSCOPE_ASSETS"})
            try:
                begun = time.monotonic()
                wait_until("pictures of scenes", lambda: len(set(SCREEN.picture(*GALLERY).data)) > GALLERY_CODES, HUNG_S)
                TABLE.row("the gallery, from the archive", f"after {time.monotonic() - begun:.1f} s", "")
            finally:
                process.kill()
                process.wait()


class Program(unittest.TestCase):
    def test_imports_are_the_systems(self):
        foreign, count = foreign_imports(VIEWER)
        self.assertEqual(foreign, set())
        TABLE.row("libraries that the viewer imports", str(count), "the system's alone, and one beside it")


if __name__ == "__main__":
    leave_if_missing(VIEWER)
    SCREEN = screen_for_wine(WIDTH + 100, HEIGHT + 100)
    unittest.main()
