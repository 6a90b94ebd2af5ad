#!/usr/bin/env python3
"""What nullscope.exe does under Wine is what the program does here: scripts/windows.sh builds it.

Usage: test_windows.py PATH-OF-NULLSCOPE [unittest options]. Ends with 77, and says why, where there is no nullscope.exe, Wine or Xvfb. With
NULLSCOPE_TESTS=all every scene that ships, else a few.
"""
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

import support

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "build/windows"
PROGRAM = FOLDER / "build/bin/nullscope.exe"
SKIPPED = 77
SIZE = "96x54"
FEW = ("first-light", "kerr", "accretion", "wormhole")
# Of what Windows 10 brings. msvcrt.dll: its C library of before 2015.
SYSTEM = {"kernel32.dll", "msvcrt.dll", "user32.dll", "gdi32.dll", "opengl32.dll", "bcrypt.dll", "advapi32.dll", "shell32.dll", "ole32.dll", "ws2_32.dll"}
# Pictures: the same driver traces the same tables but for the last digits of msvcrt's functions.
FLOATS = 1e-5          # of the brightest, of colours
BYTES, ODD = 1, 1e-4   # of 255, but for this share of the pixels


def why_not():
    """Why nothing can be tested, or nothing."""
    if not PROGRAM.is_file():
        return f"there is no {PROGRAM.relative_to(ROOT)}: scripts/windows.sh makes it"
    return next((f"{tool} is not installed" for tool in ("wine", "Xvfb") if shutil.which(tool) is None), None)


class Screen:
    """An X server of this test's own: Wine's windows, those that are never shown too, are its."""

    def __init__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-nolisten", "tcp"],
                                       pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as said:
            self.name = ":" + said.readline().strip()


class WindowsTest(support.CliTest):
    def wine(self, *arguments, status=0):
        done = subprocess.run(["wine", str(PROGRAM), *map(str, arguments)], capture_output=True, timeout=support.LONGEST_S, cwd=self.folder)
        ran = support.Ran(done)
        self.assertEqual(ran.status, status, f"nullscope.exe {' '.join(map(str, arguments))}\n{ran}")
        return ran


class Program(WindowsTest):
    def test_imports_are_the_systems(self):
        said = subprocess.run(["x86_64-w64-mingw32-objdump", "-p", str(PROGRAM)], capture_output=True, text=True, check=True).stdout
        names = {name.lower() for name in re.findall(r"DLL Name: (\S+)", said)}
        self.assertIn("kernel32.dll", names)
        self.assertEqual(names - SYSTEM, set())

    def test_info(self):
        self.assertIn("wgl: OpenGL", self.wine("info").out)

    def test_lines_end_as_they_do_here(self):
        self.assertEqual(self.wine("plan", "kerr").out, self.run_nullscope("plan", "kerr").out)

    def test_names_of_any_language(self):
        folder = self.folder / "na\u00efve \u65e5\u672c"
        folder.mkdir()
        self.wine("capture", "first-light", "--size", "32x18", "-o", f"{folder.name}/pict\u00fcre 1.png")
        self.assertEqual([file.name for file in folder.iterdir()], ["pict\u00fcre 1.png"])

    def test_errors_name_the_file(self):
        said = self.wine("capture", "na\u00efve.toml", "-o", "a.png", status=2).err
        self.assertIn("na\u00efve.toml", said)
        self.assertEqual(said.count("\n"), 1)

    def test_what_it_lacks_is_said(self):
        self.assertIn("Ceres", self.wine("fit", "a.exr", "kerr", "--free", "camera.r=5:20", status=1).err)
        self.assertIn("--workers", self.wine("capture", "first-light", "--size", "32x18", "--frames", "0:2", "--workers", "2", "-o", "a%05d.png", status=1).err)


class Rays(WindowsTest):
    def test_vectors(self):
        rays = (support.VECTORS / "schwarzschild.csv").read_text().replace(",phi_a,", ",at_angle,")
        file = self.write("rays.csv", rays)
        here = self.run_nullscope("trace", file, "--with", "reference").out.splitlines()
        there = self.wine("trace", file, "--with", "reference").out.splitlines()
        self.assertEqual(len(there), len(here))
        worst = 0.0
        for mine, his in zip(here, there):
            for a, b in zip(mine.split(","), his.split(",")):
                if a != b:
                    worst = max(worst, abs(float(a) - float(b)) / max(abs(float(a)), 1.0))
        print(f"largest difference of a number of {len(here)} rays: {worst:.2g}")
        self.assertLess(worst, 1e-11)


class Pictures(WindowsTest):
    def both(self, scene, ending, *options):
        """The file's bytes, drawn there and here."""
        files = []
        for name, run in (("there", self.wine), ("here", self.run_nullscope)):
            file = f"{scene}-{name}{ending}"
            run("capture", scene, "--size", SIZE, "--quiet", "-o", file, *options)
            files.append((self.folder / file).read_bytes())
        return files

    def one(self, scene):
        there, here = (support.read_exr(data) for data in self.both(scene, ".exr"))
        self.assertEqual(list(there), list(here))
        values = [(a, b) for name in here for mine, his in zip(there[name], here[name]) for a, b in zip(mine, his)]
        brightest = max(abs(b) for _, b in values) or 1.0
        return max(abs(a - b) for a, b in values) / brightest

    def test_scenes(self):
        scenes = FEW if support.QUICK else sorted(file.stem for file in (ROOT / "assets/scenes").glob("*.toml"))
        off = {scene: self.one(scene) for scene in scenes}
        print("".join(f"{scene:24}{largest:.2g} of the brightest\n" for scene, largest in off.items()), end="")
        self.assertEqual({scene: largest for scene, largest in off.items() if not largest <= FLOATS}, {})


class Sequences(WindowsTest):
    def test_a_run_that_is_killed_goes_on(self):
        words = ["capture", "kerr", "--size", "320x180", "--frames", "0:12", "--time-step", "1", "--resume", "-o", "k%05d.png"]
        process = subprocess.Popen(["wine", str(PROGRAM), *words], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait("two pictures", lambda: len(list(self.folder.glob("k*.png"))) >= 2, process)
        process.send_signal(signal.SIGKILL)
        process.wait()
        time.sleep(1)
        before = {file.name: file.stat().st_mtime_ns for file in self.folder.glob("k*.png")}
        self.wine(*words)
        after = {file.name: file.stat().st_mtime_ns for file in self.folder.glob("k*.png")}
        self.assertEqual(sorted(after), [f"k{i:05}.png" for i in range(12)])
        kept = [name for name in before if after[name] == before[name]]
        self.assertGreaterEqual(len(kept), 2)


if __name__ == "__main__":
    if reason := why_not():
        print(f"left out: {reason}")
        sys.exit(SKIPPED)
    screen = Screen()
    os.environ.update(DISPLAY=screen.name, LIBGL_ALWAYS_SOFTWARE="1", WINEDEBUG="-all", WINEPREFIX=str(FOLDER / "wine"))
    try:
        unittest.main()
    finally:
        screen.server.terminate()
