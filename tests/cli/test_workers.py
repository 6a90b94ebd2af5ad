#!/usr/bin/env python3
"""`capture --workers N`: processes of one run draw its frames together, and end together."""
import os
import signal
import subprocess
from pathlib import Path

import support
from test_commands import png_size
from test_farm import FarmTest


class Workers(FarmTest):
    ENDLESS = ("--size", "64x36", "--time-step", "0.001", "--frames", "0:1000000", "-o", "g%d.png", "--workers", "3")

    def capture(self, *words, **more):
        return self.run_nullscope("capture", "scene.toml", *self.SIZE, "--frames", f"0:{self.FRAMES}", "-o", "f%03d.png", *words, **more)

    def test_they_draw_what_one_run_draws(self):
        before = self.capture("--workers", "2").out
        self.assertEqual(sorted(line.split(":")[0] for line in before.splitlines()), [f"f{i:03}.png" for i in range(self.FRAMES)])
        self.check_whole()
        pictures = self.pictures()
        self.assertEqual(self.capture("--workers", "2", "--resume").out, "")
        self.assertEqual(self.pictures(), pictures)
        self.capture("--workers", "5")   # anew: without --resume
        self.assertFalse(set(self.pictures().values()) & set(pictures.values()))
        self.assertEqual(sorted(p.name for p in self.folder.glob(".*")), [])

    def test_the_reference_too(self):
        words = ("--renderer", "reference", "--samples", "1", "--size", "16x9", "--frames", "0:6")
        self.run_nullscope("capture", "scene.toml", *words, "-o", "f%d.png", "--workers", "2")
        self.run_nullscope("capture", "scene.toml", *words, "-o", "g%d.png")
        for i in range(6):
            self.assertEqual((self.folder / f"f{i}.png").read_bytes(), (self.folder / f"g{i}.png").read_bytes())

    def test_where_it_changes_nothing(self):
        self.refused("capture", "scene.toml", "--workers", "2", "-o", "a.png", says=["--workers", "--frames A:B"])
        self.refused("capture", "scene.toml", "--workers", "0", "-o", "a.png", says=["--workers 0"])
        self.refused("capture", "scene.toml", "--frames", "0:4", "--workers", "2", "-o", "nowhere/f%d.png", status=1, says=["nowhere"])

    def test_what_is_wrong_is_said_once(self):
        for words, says, status in ((("--size", "32768x32768", "--raydata"), "32768x32768", 2), (("--context", "osmesa"), "OSMesa", 1)):
            self.refused("capture", "scene.toml", "--frames", "0:9", "-o", "g%d.exr", *words, "--workers", "3", status=status, says=[says],
                         environment={"MESA_GL_VERSION_OVERRIDE": "2.1"} if status == 1 else None)

    def endless(self):
        """A run that has drawn pictures; the processes of its workers."""
        for file in self.folder.glob("g*"):
            file.unlink()
        self.write("endless.toml", "[camera]\nr = 9\n[sky]\nkind = \"grid\"\n")
        run = self.started("capture", "endless.toml", *self.ENDLESS, text=True, stderr=subprocess.PIPE)
        self.wait("pictures", lambda: len(list(self.folder.glob("g*.png"))) > 9)
        workers = [int(word) for word in Path(f"/proc/{run.pid}/task/{run.pid}/children").read_text().split()]
        self.assertEqual(len(workers), 3)
        self.assertEqual(os.listdir(f"/proc/{run.pid}/task"), [str(run.pid)], "it was forked with threads")
        return run, workers

    def check_ended(self, workers):
        self.wait("the end of workers", lambda: not any(Path(f"/proc/{worker}").exists() for worker in workers))
        for picture in self.folder.glob("g*.png"):
            self.assertEqual(png_size(picture.read_bytes()), (64, 36))

    def test_a_signal_ends_all(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)[:1 if support.QUICK else None]:
            run, workers = self.endless()
            os.kill(workers[0], signal.SIGSTOP)   # one that stands still ends as well
            run.send_signal(number)
            said = run.communicate(timeout=support.LONGEST_S)[1]
            self.assertEqual(run.returncode, -number)
            self.assertNotIn("worker", said)
            self.assertFalse([w for w in workers if Path(f"/proc/{w}").exists()], "workers outlive the run")
            self.check_ended(workers)
            self.assertEqual(list(self.folder.glob(".*")), [], "left behind")

    def test_a_killed_run_leaves_no_worker(self):
        run, workers = self.endless()
        run.kill()
        run.wait(timeout=support.LONGEST_S)
        self.check_ended(workers)

    def test_killed_workers(self):
        """Each is reported in a line, with what it was drawing; the run goes on until none is left, and its pictures stay."""
        run, workers = self.endless()
        for left, worker in zip((2, 1, 0), workers):
            before = len(list(self.folder.glob("g*.png")))
            os.kill(worker, signal.SIGKILL)
            if left:
                self.wait("more pictures", lambda: len(list(self.folder.glob("g*.png"))) > before + 3)
        said = [line for line in run.communicate(timeout=support.LONGEST_S)[1].splitlines() if not line.startswith("frames: ")]
        self.assertEqual((run.returncode, len(said)), (1, 4), said)
        for line, left in zip(said, ("2 workers are left", "1 worker is left", "none is left")):
            self.assertRegex(line, rf"^nullscope: a worker ended \(Killed\); it was drawing (no frame|frame \d+), {left}$")
        self.assertIn("every worker has ended", said[3])
        self.check_ended(workers)
        self.assertTrue((self.folder / "g.png.stamp").exists())


if __name__ == "__main__":
    support.main()
