#!/usr/bin/env python3
"""Sequences in chunks: the lines of `nullscope frames` draw one sequence together, whatever is killed and run again."""
import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

import support

ENVIRONMENT = {**os.environ, "PATH": str(Path(support.BINARY).parent) + os.pathsep + os.environ["PATH"]}
SCRIPTS = Path(support.__file__).resolve().parents[2] / "scripts" / "farm"
FRAMES = 48
SCENE = """[sky]
kind = "grid"
[camera]
r = 9
[path]
kind = "keys"
[[path.key]]
phi = 0
[[path.key]]
frame = %d
phi = 90
"""
SIZE = ("--size", "32x18")


class FarmTest(support.CliTest):
    FRAMES, SIZE = FRAMES, SIZE

    def setUp(self):
        super().setUp()
        scene = SCENE % (self.FRAMES - 1)
        self.write("scene.toml", scene)
        self.write("other.toml", scene.replace("grid", "checker"))

    def lines(self, *words, scene="scene.toml", chunk=None, output="f%03d.png"):
        printed = self.run_nullscope("frames", scene, *words, "--chunk", chunk or self.FRAMES // 2, "-o", output, "--commands", "--",
                                     *self.SIZE).out
        return printed.splitlines()

    def begin(self, line):
        """A worker: a shell that runs the line."""
        process = subprocess.Popen(["sh", "-c", "exec " + line], cwd=self.folder, env=ENVIRONMENT,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def ended(self, process, status=0):
        """What the worker printed: one line for each picture that it drew."""
        out, err = process.communicate(timeout=support.LONGEST_S)
        self.assertEqual(process.returncode, status, err.decode())
        return out.decode().splitlines() if status == 0 else err.decode()

    def run_lines(self, lines):
        """The numbers of pictures that the lines drew, run at once."""
        return [len(self.ended(process)) for process in [self.begin(line) for line in lines]]

    def pictures(self, begins="f"):
        return {p.name[len(begins):]: (p.stat().st_ino, p.stat().st_mtime_ns) for p in self.folder.glob(f"{begins}[0-9]*.png")}

    def check_whole(self, begins="f"):
        """Every picture is the one that a single run draws."""
        self.run_nullscope("capture", "scene.toml", *self.SIZE, "--frames", f"0:{self.FRAMES}", "-o", "whole%03d.png")
        self.assertEqual(len(self.pictures("whole")), self.FRAMES)
        self.assertEqual(self.pictures("whole").keys(), self.pictures(begins).keys())
        for name in self.pictures("whole"):
            self.assertEqual((self.folder / f"{begins}{name}").read_bytes(), (self.folder / f"whole{name}").read_bytes(), name)


class Lines(FarmTest):
    def test_lines_draw_once(self):
        lines = self.lines(chunk=20, output="it's $1 %03d.png")
        self.assertEqual(len(lines), 3)
        self.assertEqual(self.run_lines(lines), [20, 20, 8])
        self.check_whole("it's $1 ")
        before = self.pictures("it's $1 ")
        self.assertEqual(self.run_lines(lines), [0, 0, 0])
        self.assertEqual(self.pictures("it's $1 "), before)

    def test_time_goes_on_from_chunk_to_chunk(self):
        words = ("hot-spot", "--size", "32x18", "--time-step", "0.7")
        self.run_nullscope("capture", *words, "--frames", "3:9", "-o", "whole%d.png")
        lines = self.run_nullscope("frames", words[0], "3:9", "--chunk", "2", "-o", "f%d.png", "--commands", "--", *words[1:]).out
        self.assertEqual(self.run_lines(lines.splitlines()), [2, 2, 2])
        drawn = {(self.folder / f"f{frame}.png").read_bytes() for frame in range(3, 9)}
        self.assertEqual(drawn, {(self.folder / f"whole{frame}.png").read_bytes() for frame in range(3, 9)})
        self.assertEqual(len(drawn), 6)

    def test_table(self):
        words = ("frames", "scene.toml", "--chunk", "20", "-o", "f%03d.png", "--", *SIZE)
        self.assertEqual(self.run_nullscope(*words).out.split(), f"frames {FRAMES} 0:{FRAMES} chunks 3 of 20 there 0".split())
        self.run_lines(self.lines("3:9"))
        (self.folder / "f005.png").unlink()
        self.write("f1.png", "another name")
        self.assertEqual(self.run_nullscope(*words).out.split()[-4:], "there 5 3:5 6:9".split())
        other = self.run_nullscope(*words[:-1], "32x16").out
        self.assertRegex(other, r"there +0\nother +5  3:5 6:9  different camera\.size")

    def test_bad_input(self):
        for words, says in ((("flat",), "no [path] in the scene"), (("scene.toml", "0:99"), f"allowed: 0:{FRAMES}"),
                            (("scene.toml", "5:5"), "not a range"), (("scene.toml", "-o", "f.png"), "one place"),
                            (("scene.toml", "-o", "f%d.mp4"), "one run"), (("scene.toml", "-o", "f%d/a.png"), "in the file's name"),
                            (("scene.toml", "-o", "a\n%d.png"), "line break"), (("scene.toml", "--", "--sise", "8x8"), "nearest: --size"),
                            (("scene.toml", "0:4", "--", "--size", "8"), "not a size"), (("scene.toml", "--", "--half"), "--half"),
                            (("scene.toml", "--", "--help"), "that draw"), (("scene.toml", "--chunk", "0"), "--chunk 0"),
                            (("no such scene",), "no such scene")):
            self.refused("frames", *words, says=[says])
        self.run_nullscope("frames", "flat", "0:4", "--", "--time-step", "1")


class Workers(FarmTest):
    def count_mine(self):
        return sum(int(name[:3]) < FRAMES // 2 for name in self.pictures())

    def stopped(self, line):
        """A worker that stands still after its first pictures."""
        worker = self.begin(line)
        self.wait("a picture", self.pictures, pause_s=0.001)
        worker.send_signal(signal.SIGSTOP)
        os.waitpid(worker.pid, os.WUNTRACED)
        return worker

    def test_a_worker_is_killed_again_and_again(self):
        chance = support.dice("moments of killing")
        mine, others = self.lines()
        kept, killed = {}, 0
        other = self.begin(others)
        while killed < 6:
            until = self.count_mine() + chance.randrange(1, 6)
            worker = self.begin(mine)
            deadline = time.monotonic() + chance.uniform(0, 1)
            while worker.poll() is None and self.count_mine() < until and time.monotonic() < deadline:
                time.sleep(chance.uniform(0, 0.003))
            worker.kill()
            worker.communicate(timeout=support.LONGEST_S)
            killed += 1
            now = self.pictures()
            for name, picture in kept.items():
                self.assertEqual(now[name], picture, f"{name} was drawn again")
            kept = now
        self.ended(self.begin(mine))
        self.ended(other)
        for name, picture in kept.items():
            self.assertEqual(self.pictures()[name], picture, f"{name} was drawn again")
        self.check_whole()

    def test_the_same_line_twice_at_once(self):
        line, = self.lines(chunk=FRAMES)
        drawn = self.run_lines([line, line, line])
        self.assertEqual(sum(drawn), FRAMES, f"drawn by each: {drawn}")
        self.check_whole()

    def test_what_a_killed_worker_was_drawing_is_drawn(self):
        """A worker stands still with a picture reserved; the other waits for that one alone, and draws it."""
        line, = self.lines(chunk=FRAMES)
        first = self.stopped(line)
        second = self.begin(line)
        deadline = time.monotonic() + support.LONGEST_S
        while len(self.pictures()) < FRAMES - 1 and second.poll() is None and time.monotonic() < deadline:
            time.sleep(0.01)
        first.kill()
        first.communicate()
        self.ended(second)
        self.check_whole()

    def test_workers_begin_at_once(self):
        """Without a stamp, and with one that a run of another scene left behind."""
        for scene in ("scene.toml", "other.toml", "scene.toml"):
            self.assertEqual(self.run_lines(self.lines("0:12", scene=scene, chunk=3)), [3, 3, 3, 3])
            stamp = self.folder / "f.png.stamp"
            text = stamp.read_text()
            self.assertEqual(self.run_lines(self.lines("12:13", scene=scene)), [1])
            self.assertEqual(stamp.read_text(), text)
            for picture in self.folder.glob("f0*.png"):
                picture.unlink()

    def test_another_scene_is_refused(self):
        mine, others = self.lines()
        _, wrong = self.lines(scene="other.toml")
        worker = self.stopped(mine)
        self.assertIn("sky.kind", self.ended(self.begin(wrong), 2))
        self.assertIn("another run is drawing it", self.ended(self.begin(mine.replace(" --resume", "")), 1))
        worker.send_signal(signal.SIGCONT)
        self.ended(worker)
        self.assertIn("sky.kind", self.ended(self.begin(wrong), 2))   # though none of its frames is there
        self.run_lines([others])
        self.check_whole()


FAKE_SBATCH = """#!/bin/bash
printf '%s\\n' "$@" > words.txt
cat > job.sh
while [[ $1 != --array ]]; do shift; done
range=${2%%%*}
for ((task = ${range%-*}; task <= ${range#*-}; ++task)); do SLURM_ARRAY_TASK_ID=$task bash job.sh || exit 1; done
"""
FAKE_PARALLEL = """#!/bin/bash
if [[ $1 == --version ]]; then echo GNU parallel 1; exit; fi
printf '%s\\n' "$@" > words.txt
sh -e
"""


class Scripts(FarmTest):
    def run_script(self, name, *words, lines="", path="bin", status=0):
        done = subprocess.run([SCRIPTS / name, *words], cwd=self.folder, input="\n".join(lines), text=True, capture_output=True,
                              env={**ENVIRONMENT, "PATH": f"{self.folder / path}:{ENVIRONMENT['PATH']}"}, timeout=support.LONGEST_S)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stdout if status == 0 else done.stderr

    def test_each_line_is_run(self):
        (self.folder / "bin").mkdir()
        for name, program, fake, words in (("slurm.sh", "sbatch", FAKE_SBATCH, ("--gpus", "1", "--array", "%2")),
                                           ("parallel.sh", "parallel", FAKE_PARALLEL, ("--jobs", "2"))):
            (self.folder / "bin" / program).write_text(fake)
            (self.folder / "bin" / program).chmod(0o755)
            begins = f"it's $HOME {program} "
            lines = self.lines("0:6", chunk=2, output=begins + "%03d.png")
            self.run_script(name, *words, lines=[lines[0], "", lines[1], "  "])
            self.assertEqual(len(self.pictures(begins)), 4)
            self.assertIn("\n".join(words[:2]), (self.folder / "words.txt").read_text())
            (self.folder / "lines.txt").write_text("\n".join(lines))   # the last without an end
            self.assertEqual(self.run_script(name, "-f", "lines.txt", *words).count(begins), 2)
            self.assertEqual(len(self.pictures(begins)), 6)
            self.assertIn("no lines", self.run_script(name, status=1))
            self.assertIn("cannot be read", self.run_script(name, "-f", "nowhere.txt", status=1))
            self.assertIn(name, self.run_script(name, "--help"))
        self.assertIn("only %N", self.run_script("slurm.sh", "--array", "1-5", status=1))

    def test_a_missing_program_is_named(self):
        (self.folder / "tools").mkdir()
        for tool in ("env", "bash", "grep", "wc"):
            (self.folder / "tools" / tool).symlink_to(shutil.which(tool))
        for name, says in (("slurm.sh", "sbatch is not installed"), ("parallel.sh", "GNU parallel is not installed")):
            done = subprocess.run([SCRIPTS / name], cwd=self.folder, input="true\n", text=True, capture_output=True,
                                  env={"PATH": str(self.folder / "tools")}, timeout=support.LONGEST_S)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
            self.assertIn(says, done.stderr)


if __name__ == "__main__":
    support.main()
