#!/usr/bin/env python3
"""Films and sequences: a run that was killed is resumed without loss, two runs never mix, one run at a time draws.

ffmpeg is replaced by a program that writes down which pictures it was given.
"""
import json
import os
import signal
import subprocess
import time

import support

FAKE_FFMPEG = """#!/usr/bin/env python3
import hashlib, json, os, sys
words = sys.argv[1:]
if "-version" in words:
    sys.exit(0)
value = lambda name: words[words.index(name) + 1]
first, count, pattern = int(value("-start_number")), int(value("-frames:v")), value("-i")
rows = []
for frame in range(first, first + count):
    file = pattern % frame
    rows.append({"hash": hashlib.sha256(open(file, "rb").read()).hexdigest(), "time": os.stat(file).st_mtime_ns})
json.dump(rows, open(words[-1], "w"))
"""
SIZE = ("--size", "16x9")
FRAMES = 40
MOVING = ("--time-step", "0.25", "--frames", f"0:{FRAMES}")
ENDLESS = ("--time-step", "0.25", "--frames", "0:1000000")   # the same pictures and more: killed long before its end
SCENE = 'time = 1\n[sky]\nkind = "grid"\n[camera]\nr = 9\n'


class FilmTest(support.CliTest):
    def setUp(self):
        super().setUp()
        folder = self.folder / "bin"
        folder.mkdir()
        (folder / "ffmpeg").write_text(FAKE_FFMPEG)
        (folder / "ffmpeg").chmod(0o755)
        self.environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}
        self.write("scene.toml", SCENE)

    def capture(self, *words, status=0):
        return self.run_nullscope("capture", "scene.toml", *words, status=status, environment=self.environment)

    def pictures(self, folder="."):
        return sorted(p for p in (self.folder / folder).glob("*.png") if not p.name.startswith("."))

    def begun(self, *words, folder="."):
        """A run that has drawn some pictures and goes on; its process."""
        process = subprocess.Popen([support.BINARY, "capture", "scene.toml", *words], cwd=self.folder, env=self.environment,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + support.LONGEST_S
        while len(self.pictures(folder)) < 3:
            self.assertIsNone(process.poll(), "it ended before it was killed")
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.001)
        return process

    def killed(self, *words, folder="."):
        process = self.begun(*words, folder=folder)
        process.kill()
        process.wait(timeout=support.LONGEST_S)
        pictures = self.pictures(folder)
        return {int(p.stem): p.stat().st_mtime_ns for p in pictures[:FRAMES]} if folder != "." else {}

    def film(self, name):
        return json.loads((self.folder / name).read_text())

    def hashes(self, name):
        return [row["hash"] for row in self.film(name)]


class Films(FilmTest):
    def test_a_killed_film_is_resumed_without_loss(self):
        self.capture(*SIZE, *MOVING, "-o", "whole.mp4")
        kept = self.killed(*SIZE, *ENDLESS, "-o", "film.mp4", folder="film.mp4.frames")
        ran = self.capture(*SIZE, *MOVING, "-o", "film.mp4")
        self.assertNotIn("starting over", ran.err)
        self.assertEqual(self.hashes("film.mp4"), self.hashes("whole.mp4"))
        for frame, when in kept.items():
            self.assertEqual(self.film("film.mp4")[frame]["time"], when, "a whole picture was drawn again")
        self.assertFalse((self.folder / "film.mp4.frames").exists())

    def test_a_changed_film_is_drawn_anew(self):
        changes = {"camera.r": (SCENE.replace("r = 9", "r = 8"), SIZE, MOVING), "camera.size": (SCENE, ("--size", "18x10"), MOVING),
                   "--time-step": (SCENE, SIZE, ("--time-step", "0.5", *MOVING[2:])),
                   "--renderer": (SCENE, SIZE, (*MOVING[:3], "0:4", "--renderer", "reference", "--samples", "1"))}
        for named, (scene, size, moving) in changes.items():
            with self.subTest(named):
                self.write("scene.toml", SCENE)
                self.killed(*SIZE, *ENDLESS, "-o", "film.mp4", folder="film.mp4.frames")
                self.write("scene.toml", scene)
                ran = self.capture(*size, *moving, "-o", "film.mp4")
                said = [line for line in ran.err.splitlines() if "starting over" in line]
                self.assertEqual(len(said), 1, ran)
                self.assertIn(named, said[0])
                self.capture(*size, *moving, "-o", "whole.mp4")
                self.assertEqual(self.hashes("film.mp4"), self.hashes("whole.mp4"))

    def test_a_shorter_film_of_the_same_pictures(self):
        self.killed(*SIZE, *ENDLESS, "-o", "film.mp4", folder="film.mp4.frames")
        self.capture(*SIZE, "--time-step", "0.25", "--frames", "0:2", "-o", "film.mp4")
        self.assertEqual(len(self.film("film.mp4")), 2)

    def test_one_run_at_a_time(self):
        for output, folder in (("film.mp4", "film.mp4.frames"), ("%d.png", ".")):
            process = self.begun(*SIZE, *ENDLESS, "-o", output, folder=folder)
            process.send_signal(signal.SIGSTOP)
            os.waitpid(process.pid, os.WUNTRACED)   # once it stands still
            short = ("capture", "scene.toml", *SIZE, "--time-step", "0.25", "--frames", "0:9", "-o", output)
            self.refused(*short, status=1, says=["another run is drawing it"], environment=self.environment)
            self.refused(*short, "--resume", status=1, says=["another run is drawing it"], environment=self.environment)
            process.kill()
            process.wait(timeout=support.LONGEST_S)
            self.run_nullscope(*short, "--resume", environment=self.environment)   # the lock went with the process


class Sequences(FilmTest):
    def test_another_scene_is_refused(self):
        words = (*SIZE, *MOVING, "-o", "f%05d.png")
        self.killed(*SIZE, *ENDLESS, "-o", "f%05d.png")
        for scene, changed, says in ((SCENE.replace("grid", "checker"), words, "sky.kind"),
                                     (SCENE, ("--size", "8x8", *words[2:]), "camera.size"),
                                     (SCENE, (*SIZE, "--time-step", "0.5", *words[4:]), "--time-step")):
            self.write("scene.toml", scene)
            self.refused("capture", "scene.toml", *changed, "--resume", says=["--resume", says, "start over"],
                         environment=self.environment)
        self.write("scene.toml", SCENE)
        stamp = self.folder / "f.png.stamp"
        text = stamp.read_text()
        stamp.unlink()
        self.refused("capture", "scene.toml", *words, "--resume", says=["they have no stamp"], environment=self.environment)
        stamp.write_text(text[:100])
        self.refused("capture", "scene.toml", *words, "--resume", says=["do not match"], environment=self.environment)

    def test_pictures_of_an_older_run_are_not_kept(self):
        """A fresh run of another scene ends early; what it had not reached is drawn again, not taken from before."""
        words = ("--time-step", "1", "-o", "f%d.png")
        self.capture(*SIZE, "--frames", "0:12", *words)
        old = {p.name: p.read_bytes() for p in self.pictures()}
        self.write("scene.toml", SCENE.replace("grid", "checker"))
        self.capture(*SIZE, "--frames", "0:4", *words)
        drawn = self.capture(*SIZE, "--frames", "0:12", *words, "--resume").out.count("\n")
        self.assertEqual(drawn, 8)
        for picture in self.pictures():
            self.assertNotEqual(picture.read_bytes(), old[picture.name], picture.name)

    def test_a_run_that_draws_nothing_leaves_nothing(self):
        self.refused("capture", "scene.toml", *SIZE, "--frames", "0:2", "-o", "nowhere/f%d.png", status=1, says=["nowhere"])
        self.refused("capture", "flat", "--size", "32768x32768", "--raydata", "--frames", "0:2", "-o", "f%d.exr", says=["32768x32768"])


if __name__ == "__main__":
    support.main()
