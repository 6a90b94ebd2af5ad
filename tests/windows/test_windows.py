#!/usr/bin/env python3
"""What nullscope.exe does under Wine is what the program does here: scripts/windows.sh builds it.

Usage: test_windows.py PATH-OF-NULLSCOPE [CASE...]; prints a table of what was measured. Ends with 77, and says why, where there is no
nullscope.exe, Wine or Xvfb. NULLSCOPE_TESTS=few: a few scenes in place of all that ship.
"""
import json
import os
import re
import signal
import subprocess
import sys
import time
import unittest
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from wine import COMPILER, FOLDER, PROGRAM, ROOT, Table, foreign_imports, leave_if_missing, screen_for_wine

import support
from x_screen import read_png

SIZE = "160x90"
FEW = ("first-light", "kerr", "accretion", "wormhole")
# Pictures: the same driver draws the same shaders; the tables are computed by other functions of the C library, which differ in the last digits.
FLOATS = 1e-5          # of the brightest, of colours
CODES, ODD = 1, 1e-4   # of 255, and the share of the pixels that differ at all
FIT_OFF = 0.01         # standard deviations: that close both say the same; the search ends within a hundredth
NAME = "na\u00efve \u65e5\u672c"
ARCHIVE_BYTES = 15e6
SHIPPED = "earth"   # it needs a scene, stars and an image of those that ship
FILM = ("capture", "first-light", "--size", "32x18", "--frames", "0:2", "--time-step", "1")   # and -o
TABLE = Table()
OF_HARD = ("1e-9", "rain on the horizon")   # all take some five minutes


class WindowsTest(support.CliTest):
    def wine(self, *arguments, status=0, environment=None):
        done = subprocess.run(["wine", str(PROGRAM), *map(str, arguments)], capture_output=True, timeout=support.LONGEST_S, cwd=self.folder,
                              env=os.environ | (environment or {}))
        ran = support.Ran(done)
        self.assertEqual(ran.status, status, f"nullscope.exe {' '.join(map(str, arguments))}\n{ran}")
        return ran

    def build(self, name, *words):
        subprocess.run([COMPILER, "-std=c++20", "-O2", "-static", *words, "-o", self.folder / name], check=True)
        return self.folder / name

    def passes(self, name, *words):
        """A program of tests/windows, which says nothing."""
        done = subprocess.run(["wine", self.build(name, *words)], capture_output=True, text=True, timeout=support.LONGEST_S)
        self.assertEqual((done.returncode, done.stdout), (0, ""))


class Program(WindowsTest):
    def test_imports_are_the_systems(self):
        foreign, count = foreign_imports(PROGRAM)
        self.assertEqual(foreign, set())
        TABLE.row("libraries that it imports", str(count), "the system's alone, and one beside it")

    def test_registers_are_kept_for_whoever_is_called(self):
        """-fno-ipa-ra (scripts/windows.cmake) with every file in C++, ours and the libraries': one without it may read what another has
        overwritten."""
        files = 0
        for build in [FOLDER / "build", *(FOLDER / "sources").glob("*/build")]:
            rules = build / "build.ninja"   # Dear ImGui has none: the script compiles it
            for entry in rules.read_text().split("\nbuild ")[1:] if rules.exists() else ():
                if ": CXX_COMPILER" in entry.partition("\n")[0]:
                    self.assertIn(" -fno-ipa-ra ", entry, rules)
                    files += 1
        self.assertGreater(files, 100)
        self.assertIn(" -fno-ipa-ra ", (ROOT / "scripts/windows.sh").read_text())
        TABLE.row("files in C++ without registers across calls", str(files), "all")

    def test_names_are_utf8(self):
        self.passes("names.exe", "-I", ROOT / "src", ROOT / "tests/windows/utf8_names.cpp", ROOT / "src/platform/windows/utf8.cpp")

    def test_threads_have_a_whole_long_double(self):
        """The reference relies on it; Windows begins a thread with 53 bits."""
        self.passes("precision.exe", "-I", FOLDER / "prefix/include", ROOT / "tests/windows/thread_precision.cpp", FOLDER / "prefix/lib/libtbb12.a")
        TABLE.row("long double of TBB's threads", "64 bits", "those of the thread that gives them work")

    def test_info(self):
        self.assertIn("wgl: OpenGL", self.wine("info").out)

    def test_version_is_that_of_the_sources(self):
        said = self.wine("--version").out
        self.assertRegex(said, r"^\d+\.\d+\.\d+ \([0-9a-f]{12}(, changed)?\)\n$")
        TABLE.row("--version", said.strip(), "")

    def test_words_are_those_of_here(self):
        for words in (["plan", "kerr"], ["scenes"], ["--help"]):
            there, here = (run(*words).out.replace("nullscope.exe", "nullscope") for run in (self.wine, self.run_nullscope))
            self.assertEqual(there, here)

    def test_names_of_any_language(self):
        folder = self.folder / NAME
        folder.mkdir()
        self.wine("capture", "first-light", "--size", "32x18", "-o", f"{NAME}/pict\u00fcre 1.png")
        self.assertEqual([file.name for file in folder.iterdir()], ["pict\u00fcre 1.png"])
        self.wine("capture", f"{NAME}/pict\u00fcre 1.png", "-o", f"{NAME}/again.exr")   # which holds its scene
        TABLE.row(f"a picture in a folder \"{NAME}\"", "drawn, and drawn again", "")

    def test_errors_name_the_file(self):
        said = self.wine("capture", "na\u00efve.toml", "-o", "a.png", status=2).err
        self.assertIn("na\u00efve.toml", said)
        self.assertEqual(said.count("\n"), 1)

    def test_what_it_lacks_is_said(self):
        said = self.wine(*FILM, "-o", "a.mp4", status=1).err
        self.assertEqual(said, "nullscope: ffmpeg is not installed, which films need; without it: -o NAME%05d.png and --frames\n")
        self.assertEqual(list(self.folder.iterdir()), [])
        TABLE.row("what is missing (ffmpeg)", "said", "")

    def test_fits(self):
        self.run_nullscope("capture", "hot-flow", "--size", "24x24", "-o", "data.exr")
        (there,), (here,) = (json.loads(run("fit", "data.exr", "hot-flow", "--free", "camera.theta=30:80", "--sigma", "2%", "--starts", "1", "--json").out)["parameters"]
                             for run in (self.wine, self.run_nullscope))
        off = abs(there["best"] - here["best"]) / here["sigma"]
        TABLE.row("fit of an inclination", f"{there['best']} +- {there['sigma']}, {off:.1e} standard deviations from Linux's", f"{FIT_OFF:.0e}")
        self.assertLess(off, FIT_OFF)

    def test_a_film(self):
        """By ffmpeg.exe itself, in PATH; as many frames as asked for are in it."""
        if not (FOLDER / "ffmpeg/ffmpeg.exe").exists():
            self.skipTest("there is no ffmpeg.exe: scripts/windows.sh --test fetches it")
        in_path = {"WINEPATH": str(FOLDER / "ffmpeg")}
        self.wine(*FILM, "-o", f"{NAME}.mp4", environment=in_path)
        done = subprocess.run(["wine", FOLDER / "ffmpeg/ffmpeg.exe", "-i", f"{NAME}.mp4", "-f", "framemd5", "-"], capture_output=True, timeout=support.LONGEST_S,
                              cwd=self.folder)
        frames = [line for line in done.stdout.decode().splitlines() if not line.startswith("#")]
        self.assertEqual(len(frames), 2, done.stderr.decode(errors="replace"))
        TABLE.row(f"a film \"{NAME}.mp4\" by ffmpeg.exe", f"{(self.folder / f'{NAME}.mp4').stat().st_size} bytes, {len(frames)} frames read back", "2 frames")

    def test_a_film_by_ffmpeg(self):
        """By the program that stands for it, in PATH."""
        (self.folder / "bin").mkdir()
        self.build("bin/ffmpeg.exe", "-municode", "-I", ROOT / "src", ROOT / "tests/windows/fake_ffmpeg.cpp", ROOT / "src/platform/windows/utf8.cpp")
        said = self.wine(*FILM, "--workers", "2", "-o", f"{NAME}.mp4", environment={"WINEPATH": str(self.folder / "bin")}).out
        self.assertIn(f"{NAME}.mp4: 32x18, 2 frames at 24 a second\n", said)
        words = (self.folder / f"{NAME}.mp4").read_text(encoding="utf-8").splitlines()
        self.assertEqual(words[words.index("-i") + 1], f"{NAME}.mp4.frames/%05d.png")
        self.assertEqual(words[words.index("-frames:v") + 1], "2")
        self.assertFalse((self.folder / f"{NAME}.mp4.frames").exists())
        TABLE.row(f"a film in \"{NAME}.mp4\", its pictures by two workers", "handed to ffmpeg.exe in PATH", "")


class Rays(WindowsTest):
    def test_vectors(self):
        """The cases of tests/cli/test_trace.py that compare the reference, and the shader's code in double and float, with rays of 50 digits."""
        program = self.folder / "nullscope"
        program.write_text(f'#!/bin/sh\nexec wine "{PROGRAM}" "$@"\n')
        program.chmod(0o755)
        cases = ["Reference.test_vectors", "ShaderText.test_vectors", "ShaderText.test_vectors_of_the_extremal_hole",
                 "ShaderText.test_vectors_of_the_ellis_wormhole"]
        for case in cases:
            done = subprocess.run([sys.executable, "-B", str(ROOT / "tests/cli/test_trace.py"), str(program), case], capture_output=True, text=True,
                                  timeout=6 * support.LONGEST_S, env={key: value for key, value in os.environ.items() if key != "NULLSCOPE_RUN"})
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertNotIn("skipped", done.stderr)
            TABLE.row(f"rays of 50 digits, {case}", "within", "the bounds of Linux")

    def test_hard_cases(self):
        for name in OF_HARD:
            said = self.wine("bench", "hard", "--only", name).out
            self.assertRegex(said, r"([1-9]\d*) of \1 rows within their bounds")
            TABLE.row(f"bench hard --only '{name}'", "within", "its bounds")


class ScenePictures(WindowsTest):
    def both(self, scene, ending, *options):
        """The file's bytes, drawn there and here, at once."""
        def drawn(name, run):
            file = f"{scene}-{name}{ending}"
            run("capture", scene, "--size", SIZE, "--quiet", "-o", file, *options)
            return (self.folder / file).read_bytes()
        with ThreadPoolExecutor(2) as pool:
            runs = [pool.submit(drawn, *how) for how in (("there", self.wine), ("here", self.run_nullscope))]
            return [run.result() for run in runs]

    def floats_off(self, scene):
        """Largest difference of the colours, of the brightest."""
        there, here = (support.read_exr(data) for data in self.both(scene, ".exr"))
        self.assertEqual(list(there), list(here))
        brightest, off = 0.0, 0.0
        for name in here:
            for mine, his in zip(there[name], here[name], strict=True):
                if mine != his:
                    off = max(off, max(abs(a - b) for a, b in zip(mine, his)))
                brightest = max(brightest, max(map(abs, his)))
        return off / (brightest or 1.0)

    def codes_off(self, scene):
        """Of the displayed picture: the largest difference, and the share of the pixels that differ."""
        pictures = []
        for name, data in zip("ab", self.both(scene, ".png")):
            (self.folder / f"{name}.png").write_bytes(data)
            pictures.append(read_png(self.folder / f"{name}.png").data)
        off = [max(abs(a - b) for a, b in zip(pictures[0][at:at + 3], pictures[1][at:at + 3])) if pictures[0][at:at + 3] != pictures[1][at:at + 3] else 0
               for at in range(0, len(pictures[1]), 3)]
        return max(off), sum(x > 0 for x in off) / len(off)

    def test_scenes(self):
        few = os.environ.get("NULLSCOPE_TESTS") == "few"
        for scene in FEW if few else sorted(file.stem for file in (ROOT / "assets/scenes").glob("*.toml")):
            with self.subTest(scene):
                floats, (most, share) = self.floats_off(scene), self.codes_off(scene)
                TABLE.row(f"picture {scene}", f"EXR {floats:.1e} of the brightest, PNG {most} of 255 in {100 * share:.3f} % of the pixels",
                          f"{FLOATS:.0e}; {CODES} in {100 * ODD} %")
                self.assertLessEqual(floats, FLOATS)
                self.assertLessEqual(most, CODES)
                self.assertLessEqual(share, ODD)


class Archive(WindowsTest):
    def test_unpacked_and_started(self):
        """What a user does: two steps to the first picture."""
        archive = next(FOLDER.glob("nullscope-*-windows-x86_64.zip"), None)
        if archive is None:
            self.skipTest("there is no archive: scripts/windows.sh --zip")
        self.assertLessEqual(archive.stat().st_size, ARCHIVE_BYTES)
        with zipfile.ZipFile(archive) as packed:
            packed.extractall(self.folder / NAME)
        (folder,) = (self.folder / NAME).iterdir()
        done = subprocess.run(["wine", "./nullscope.exe", "capture", SHIPPED, "--size", SIZE, "-o", "first.png"], cwd=folder, capture_output=True,
                              timeout=support.LONGEST_S, env={key: value for key, value in os.environ.items() if key != "NULLSCOPE_ASSETS"})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.run_nullscope("capture", SHIPPED, "--size", SIZE, "-o", "here.png")
        self.assertEqual(read_png(folder / "first.png").data, read_png(self.folder / "here.png").data)
        TABLE.row(f"{SHIPPED} from the archive of {archive.stat().st_size / 1e6:.1f} MB", "drawn, the colours of the Linux program", f"{ARCHIVE_BYTES / 1e6:.0f} MB")


class Sequences(WindowsTest):
    def test_a_run_that_is_killed_goes_on(self):
        words = ["capture", "kerr", "--size", "320x180", "--frames", "0:12", "--time-step", "1", "--resume", "-o", "k%05d.png"]
        process = subprocess.Popen(["wine", str(PROGRAM), *words], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait("two pictures", lambda: len(list(self.folder.glob("k*.png"))) >= 2, process)
        process.send_signal(signal.SIGKILL)
        process.wait()
        time.sleep(1)
        before = {file.name: file.stat().st_mtime_ns for file in self.folder.glob("k*.png")}
        self.assertLess(len(before), 12, "it was killed after its end")
        self.wine(*words)
        after = {file.name: file.stat().st_mtime_ns for file in self.folder.glob("k*.png")}
        self.assertEqual(sorted(after), [f"k{i:05}.png" for i in range(12)])
        kept = [name for name in before if after[name] == before[name]]
        self.assertEqual(len(kept), len(before))
        TABLE.row("a sequence killed and resumed", f"{len(kept)} of {len(before)} pictures kept, {len(after)} of 12 in the end", "")


class Workers(WindowsTest):
    FRAMES, LONG = 16, 60

    def words(self, name, frames=FRAMES):
        return ("capture", "kerr", "--size", "320x180", "--frames", f"0:{frames}", "--time-step", "1", "-o", f"{name}%05d.png")

    def pictures(self, name):
        return {file.name.removeprefix(name): file.read_bytes() for file in self.folder.glob(f"{name}*.png")}

    def started(self, name, *words, frames=FRAMES):
        """A run with three workers that has drawn some pictures; its processes, the run's own first."""
        run = subprocess.Popen(["wine", str(PROGRAM), *self.words(name, frames), "--workers", "3", *words], cwd=self.folder, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
        self.wait("two pictures", lambda: len(self.pictures(name)) >= 2, run)
        there = self.processes(name)
        self.assertEqual((there[0], len(there)), (run.pid, 4))
        return run, there

    @staticmethod
    def processes(name):
        found = []
        for entry in Path("/proc").glob("[0-9]*"):
            try:
                if f"{name}%05d.png" in (entry / "cmdline").read_text(errors="replace") and " Z " not in (entry / "stat").read_text():
                    found.append(int(entry.name))
            except OSError:
                pass   # it has ended
        return sorted(found)

    def test_they_draw_what_one_run_draws(self):
        self.wine(*self.words("one"))
        self.wine(*self.words("two"), "--workers", "2")
        self.assertEqual(self.pictures("two"), self.pictures("one"))
        self.assertEqual(len(self.pictures("one")), self.FRAMES)
        self.assertIn(f"all {self.FRAMES} frames were there", self.wine(*self.words("two"), "--workers", "2", "--resume").err)
        self.assertFalse({file.name for file in self.folder.iterdir()} - {f"{name}{i:05}.png" for name in ("one", "two") for i in range(self.FRAMES)} -
                         {"one.png.stamp", "two.png.stamp"}, "left behind")

        run, there = self.started("killed", "--resume")
        run.kill()
        run.stderr.close()
        run.wait(timeout=support.LONGEST_S)
        self.wait("the end of the workers of a killed run", lambda: not self.processes("killed"))
        before = len(self.pictures("killed"))
        self.assertLess(before, self.FRAMES, "it was killed after its end")
        self.wine(*self.words("killed"), "--workers", "3", "--resume")
        self.assertEqual(self.pictures("killed"), self.pictures("one"))
        TABLE.row("--workers 2", f"{self.FRAMES} pictures, the bytes of one run", "the same")
        TABLE.row("a run with three workers is killed at {} pictures".format(before), "no worker outlives it; resumed, the bytes of one run", "the same")

    def test_killed_workers(self):
        run, there = self.started("w", frames=self.LONG)
        listed = subprocess.run(["wine", "wmic", "process", "get", "processid,name"], capture_output=True, check=True).stdout.decode("utf-16")
        of_windows = sorted(int(number) for number in re.findall(r"^nullscope\.exe\s+(\d+)", listed, re.MULTILINE))
        self.assertEqual(len(of_windows), len(there))
        subprocess.run(["wine", "taskkill", "/f", "/pid", str(of_windows[1])], stdout=subprocess.DEVNULL, check=True)
        said = [line for line in run.communicate(timeout=support.LONGEST_S)[1].splitlines() if not line.startswith("frames: ")]
        self.assertEqual(run.returncode, 0, said)
        self.assertEqual(len(said), 1, said)
        self.assertRegex(said[0], r"nullscope: a worker ended \(.+\); it was drawing (no frame|frame \d+), 2 workers are left$")
        self.assertEqual(len(self.pictures("w")), self.LONG)
        TABLE.row("one of three workers is killed", "said in one line, its frame is drawn by the others", "")

    def test_what_is_wrong_is_said_once(self):
        said = self.wine("capture", "kerr", "--frames", "0:9", "--size", "32768x32768", "--raydata", "-o", "g%d.exr", "--workers", "3", status=2).err
        self.assertEqual(said.count("32768x32768"), 1, said)


if __name__ == "__main__":
    leave_if_missing(PROGRAM)
    screen_for_wine()
    unittest.main()
