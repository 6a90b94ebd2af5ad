#!/usr/bin/env python3
"""What happens when something fails that is not the input's fault: no driver, no memory, no room, an end by force."""
import os
import resource
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

import support
from machine import slowness, spent_s  # after support, which finds it
from test_commands import png_size

RAYS = "r,theta,phi,n_r,n_theta,n_phi\n" + "10,1.5,0,-1,0,0.1\n" * 5000
NO_EGL = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/dev/null"}     # GLVND then knows no driver
OLD_OPENGL = {"MESA_GL_VERSION_OVERRIDE": "2.1"}             # Mesa then refuses a context of version 3.3
SANITIZED = b"__asan_init" in Path(support.BINARY).read_bytes()   # reserves terabytes of addresses, so no limit on them
SMALL = ("--size", "16x9")
END_S = 0.5   # of processor time, divided by the machine's slowness: ends take none of it, a picture that is still drawn takes seconds

BLOOM = '[spacetime]\nmetric = "minkowski"\n[picture]\nbloom = 0.1\n'

class Drivers(support.CliTest):
    def test_no_egl_driver(self):
        self.refused("capture", "flat", *SMALL, "--context", "egl", "-o", "a.png", status=1, says=["EGL: no device", "apt install"],
                     environment=NO_EGL)
        if "osmesa" not in self.contexts():
            self.skipTest("no OSMesa to fall back to")
        said = self.run_nullscope("capture", "flat", *SMALL, "-o", "a.png", environment=NO_EGL).out
        self.assertIn("osmesa", said)
        self.assertEqual(png_size((self.folder / "a.png").read_bytes()), (16, 9))

    def test_every_context_is_refused(self):
        for command in (("capture", "flat", *SMALL, "-o", "a.png"), ("bench", "frames", "flat", "--json", "b.json")):
            self.refused(*command, status=1, says=["no OpenGL 3.3 context", "EGL: no device", "OSMesa: it gives no"],
                         environment=OLD_OPENGL)
        for context, says in (("egl", "EGL: no device"), ("osmesa", "OSMesa: it gives no")):
            self.refused("capture", "flat", *SMALL, "--context", context, "-o", "a.png", status=1, says=[says],
                         environment=OLD_OPENGL)
        self.run_nullscope("info", status=1, environment=OLD_OPENGL)

    def test_what_needs_no_driver_goes_on(self):
        self.run_nullscope("capture", "flat", *SMALL, "--renderer", "reference", "-o", "a.png", environment={**NO_EGL, **OLD_OPENGL})
        self.run_nullscope("plan", "first-light", environment={**NO_EGL, **OLD_OPENGL})


class Memory(support.CliTest):
    def test_a_frame_beyond_the_driver(self):
        self.refused("capture", "flat", "--size", "32768x32768", "-o", "a.png", says=["32768x32768", "-o FILE.exr"])
        bloom = self.write("bloom.toml", BLOOM)   # which needs the picture at once
        self.refused("capture", bloom, "--size", "32768x32768", "-o", "a.png", says=["32768x32768", "allowed: 1x1 to"])
        self.refused("capture", "flat", "--size", "32768x32768", "--raydata", "-o", "a.exr", says=["32768x32768", "allowed: 1x1 to"])

    @unittest.skipIf(SANITIZED, "the sanitizer's addresses are beyond any limit")
    def test_a_frame_beyond_the_memory(self):
        def little():
            resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))

        for context in self.contexts()[:1 if support.QUICK else None]:   # seconds each
            for output in ("a.exr",) if support.QUICK else ("a.png", "a.exr"):
                self.refused("capture", self.write("bloom.toml", BLOOM), "--size", "16384x16384", "--context", context, "-o", output,
                             status=1, says=["out of memory"], before=little)
        self.refused("capture", "flat", "--size", "65536x65536", "--renderer", "reference", "-o", "a.exr", status=1,
                     says=["out of memory"], before=little)
        self.assertEqual(self.run_nullscope("capture", "flat", *SMALL, "-o", "a.png", before=little).said(), "")


    @unittest.skipIf(SANITIZED or support.QUICK, "ten seconds: with --all")
    def test_a_large_picture_takes_little_memory(self):
        def little():
            resource.setrlimit(resource.RLIMIT_AS, (3 << 29, 3 << 29))   # 1.5 GiB

        dome = self.write("dome.toml", '[spacetime]\nmetric = "kerr"\n[camera]\nprojection = "fisheye"\nr = 30\n[sky]\nkind = "plain"\n'
                                       '[picture]\nrefine = "off"\n')
        for output in ("a.png", "a.exr"):
            self.run_nullscope("capture", dome, "--size", "8192x8192", "-o", output, before=little)


class Room(support.CliTest):
    """No room for a file: RLIMIT_FSIZE, a full device, a full file system."""

    def test_a_limit_that_would_kill(self):
        def no_room():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))   # SIGXFSZ at its default: it ends a process

        for output in ("new.png", "new.exr", "new.fits"):
            self.refused("capture", "sky-only", "--size", "64x36", "-o", output, status=1,
                         says=[f"cannot write '{output}'", "File too large"], before=no_room)

    def test_a_full_device(self):
        rays = self.write("rays.csv", RAYS)
        full = ("No space left on device",)
        self.refused("trace", "flat", "--rays", rays, "-o", "/dev/full", status=1, says=["/dev/full", *full])
        with open("/dev/full", "w") as device:
            for command in (("trace", "flat", "--rays", rays), ("plan", "first-light"), ("plan", "first-light", "--json"), ("scenes",),
                            ("info",), ("capture", "sky-only", "--dump-shader"), ("compare", self.picture(), self.picture())):
                done = subprocess.run([support.BINARY, *command], stdout=device, stderr=subprocess.PIPE, cwd=self.folder,
                                      timeout=support.LONGEST_S)
                self.assertEqual((done.returncode, done.stderr.decode().count("\n")), (1, 1), (command, done.stderr))
                self.assertIn(b"standard output cannot be written", done.stderr, command)

    def picture(self):
        self.run_nullscope("capture", "flat", *SMALL, "-o", "picture.png")
        return "picture.png"

    def test_a_full_file_system(self):
        (self.folder / "small").mkdir()
        rays = self.write("rays.csv", RAYS)
        script = ('mount -t tmpfs -o size=16k none small || exit 77; "$@" -o small/new.csv; status=$?; '
                  'ls -A small; exit $status')
        done = subprocess.run(["unshare", "--mount", "--map-root-user", "sh", "-c", script, "sh", support.BINARY, "trace", "flat",
                               "--rays", rays], cwd=self.folder, capture_output=True, text=True, timeout=support.LONGEST_S)
        if done.returncode == 77 or "unshare" in done.stderr:
            self.skipTest(f"no mount of our own here: {done.stderr.strip()}")
        self.assertEqual(done.returncode, 1, done)
        self.assertEqual(done.stderr, "nullscope: cannot write 'small/new.csv': No space left on device\n")
        self.assertEqual(done.stdout, "", "something was left behind")


class Sequences(support.CliTest):
    """What ends a sequence in the middle: one line, status 1, finished pictures stay, nothing else is left."""
    PICTURE = ("capture", "flat", "--size", "64x36", "--time-step", "1")

    def pictures(self):
        return {p.name: p.read_bytes() for p in self.folder.glob("**/f*.png") if not p.is_symlink()}

    def check_pictures(self):
        pictures = self.pictures()
        for picture in pictures.values():
            self.assertEqual(png_size(picture), (64, 36))
            self.assertTrue(picture.endswith(b"IEND\xaeB`\x82"))
        self.assertFalse([p for p in self.folder.glob("**/.*")], "left behind")
        return pictures

    def ends_in_one_line(self, *words, says, before=None):
        ran = self.run_nullscope(*self.PICTURE, *words, status=1, before=before)
        said = [line for line in ran.err.splitlines() if not line.startswith("frames: ")]   # of a slow machine
        self.assertEqual(len(said), 1, ran)
        self.assertTrue(said[0].startswith("nullscope: ") and says in said[0], ran)

    def test_a_full_device(self):
        for workers in ((), ("--workers", "2")):
            (self.folder / "f003.png").symlink_to("/dev/full")
            self.ends_in_one_line("--frames", "0:300", "-o", "f%03d.png", *workers, says="No space left on device")
            there = self.check_pictures()
            self.assertTrue(0 < len(there) < 250, there.keys())
            self.assertTrue(workers or sorted(there) == ["f000.png", "f001.png", "f002.png"])
            for picture in self.folder.glob("f*"):
                picture.unlink()

    def test_a_limit_of_size(self):
        """As a quota: writing fails, and the signal that goes with it ends nothing."""
        def no_room():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

        words = ("-o", "f%03d.png", "--resume")
        self.run_nullscope(*self.PICTURE, "--frames", "0:3", *words)
        before = self.pictures()
        for workers in ((), ("--workers", "2")):
            self.ends_in_one_line("--frames", "0:9", *words, *workers, says="File too large", before=no_room)
            self.assertEqual(self.check_pictures(), before)
        self.run_nullscope(*self.PICTURE, "--frames", "0:9", *words, "--workers", "2")
        self.assertEqual(len(self.check_pictures()), 9)

    def test_a_folder_where_nobody_may_write(self):
        self.ends_in_one_line("--frames", "0:3", "-o", "/sys/f%d.png", says="/sys/f.png.stamp: ")

    def test_a_full_file_system(self):
        (self.folder / "small").mkdir()
        script = ('mount -t tmpfs -o size=64k none small || exit 77; "$@" --frames 0:300 -o small/f%03d.png; status=$?; '
                  'cp -a small/. kept; ls -A small | grep ^[.]; mount -o remount,ro small; '
                  '"$@" --frames 0:300 -o small/f%03d.png --resume && exit 0; exit $status')
        for workers in ((), ("--workers", "2")):
            (self.folder / "kept").mkdir()
            done = subprocess.run(["unshare", "--mount", "--map-root-user", "sh", "-c", script, "sh", support.BINARY, *self.PICTURE,
                                   *workers], cwd=self.folder, capture_output=True, text=True, timeout=support.LONGEST_S)
            if done.returncode == 77 or "unshare" in done.stderr:
                self.skipTest(f"no mount of our own here: {done.stderr.strip()}")
            self.assertEqual(done.returncode, 1, done)
            said = [line for line in done.stderr.splitlines() if not line.startswith("frames: ")]
            self.assertEqual(len(said), 2, done)
            self.assertRegex(said[0], "^nullscope: cannot write 'small/f[0-9]*.png': No space left on device$")
            self.assertRegex(said[1], "^nullscope: small/f.png.stamp: Read-only file system$")
            self.assertNotIn(".tmp", done.stdout)
            self.assertGreater(len(self.check_pictures()), 2)
            shutil.rmtree(self.folder / "kept")


class Ends(support.CliTest):
    """Ended from outside: at once, by that signal, and what has a name is whole."""
    LONG = ("--frames", "0:100000", "-o", "f-%05d.png")

    def started_until(self, *arguments, until, before=None):
        process = self.started(*arguments, stderr=subprocess.DEVNULL, preexec_fn=before)
        self.wait("it came that far", until, process)
        return process

    def files(self):
        """But the stamp of a sequence (test_films.py)."""
        return sorted(p.name for p in self.folder.iterdir() if p.suffix != ".stamp")

    def end(self, process, number):
        before = spent_s(process.pid)
        process.send_signal(number)
        _, status, used = os.wait4(process.pid, 0)   # a hang ends with the test's own time limit
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, -number, "a shell would say 128 + the signal's number")
        spent = used.ru_utime + used.ru_stime - before
        if spent > END_S:
            spent /= slowness()
        self.assertLess(spent, END_S, "it went on with its work")

    def test_a_sequence_is_interrupted(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for p in self.folder.iterdir():
                p.unlink()
            process = self.started_until("capture", "flat", "--size", "640x360", *self.LONG, until=lambda: len(self.files()) > 3)
            self.end(process, number)
            for name in self.files():
                self.assertRegex(name, r"^f-\d{5}\.png$")
                self.assertEqual(png_size((self.folder / name).read_bytes()), (640, 360))

    def test_a_sequence_is_killed(self):
        process = self.started_until("capture", "flat", "--size", "640x360", *self.LONG, until=lambda: len(self.files()) > 3)
        self.end(process, signal.SIGKILL)
        whole = [name for name in self.files() if not name.startswith(".")]
        self.assertGreater(len(whole), 2)
        for name in whole:
            self.assertEqual(png_size((self.folder / name).read_bytes()), (640, 360))

    def test_a_killed_sequence_resumes(self):
        frames = ("--frames", "0:200", "-o", "f-%05d.png")
        process = self.started_until("capture", "flat", "--size", "320x180", *frames, until=lambda: len(self.files()) > 3)
        process.kill()
        process.wait(timeout=support.LONGEST_S)
        before = {name: (self.folder / name).stat().st_mtime_ns for name in self.files() if not name.startswith(".")}
        self.assertTrue(2 < len(before) < 200, before)
        said = self.run_nullscope("capture", "flat", "--size", "320x180", *frames, "--resume").out
        self.assertEqual(said.count("\n"), 200 - len(before), said)
        for number in range(200):
            file = self.folder / f"f-{number:05d}.png"
            self.assertEqual(png_size(file.read_bytes()), (320, 180))
            self.assertEqual(before.get(file.name, file.stat().st_mtime_ns), file.stat().st_mtime_ns, "a whole frame was drawn again")

    def test_long_work_is_interrupted(self):
        """Tables, the reference tracer, the benches: nothing of theirs is on disk before it is done."""
        for command in (("capture", "first-light", "--renderer", "reference", "--size", "1920x1080", "-o", "a.png"),
                        ("bench", "accuracy", "--json", "b.json"),
                        ("capture", "first-light", "--method", "table:1024", "-o", "c.png")):
            begun = time.monotonic()
            process = self.started_until(*command, until=lambda: time.monotonic() - begun > 0.3)
            self.end(process, signal.SIGINT)
            self.assertEqual(self.files(), [])

    def test_an_ignored_signal_stays_ignored(self):
        """As nohup and a shell's background jobs ask for."""
        def ignore():
            signal.signal(signal.SIGINT, signal.SIG_IGN)
            signal.signal(signal.SIGHUP, signal.SIG_IGN)

        process = self.started_until("capture", "flat", *SMALL, *self.LONG, until=lambda: len(self.files()) > 3, before=ignore)
        for number in (signal.SIGINT, signal.SIGHUP):
            seen = len(self.files())
            process.send_signal(number)
            self.wait(f"more pictures after signal {number}", lambda: len(self.files()) >= seen + 10, process)
        self.end(process, signal.SIGTERM)


if __name__ == "__main__":
    support.main()
