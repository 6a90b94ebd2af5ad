"""Runs the real nullscope and judges how it ends.

Usage of every test here: test_NAME.py PATH-OF-NULLSCOPE [unittest options]
"""
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import depth
from depth import costly  # noqa: F401  for the tests
from dice import dice  # noqa: F401  for the tests
from image_bytes import exr_attributes

if len(sys.argv) < 2 or not os.access(sys.argv[1], os.X_OK):   # a case's name, as like as not
    sys.exit(f"usage: {sys.argv[0]} PATH-OF-NULLSCOPE [CASE...]")
BINARY = str(Path(sys.argv.pop(1)).resolve())
VECTORS = Path(__file__).resolve().parent.parent / "vectors"
SMALL = "48x27"      # px; large enough for a shadow, quick on a software driver
QUICK = not depth.deep()
LONGEST_S = 300      # a run that takes longer hangs

# What runs in a shell's background ignores SIGINT, under nohup SIGHUP, and so would every child: here they are heard again.
for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGHUP, signal.SIGTERM):
    if signal.getsignal(number) == signal.SIG_IGN:
        signal.signal(number, signal.SIG_DFL)
signal.pthread_sigmask(signal.SIG_SETMASK, ())


class Ran:
    """Exit status, standard output and standard error of one run."""

    def __init__(self, done):
        self.status = done.returncode
        self.out = done.stdout.decode("utf-8", "replace")
        self.err = done.stderr.decode("utf-8", "replace")

    def said(self):
        """Standard error without the lines of progress, which slow machines have."""
        return re.sub(r"^[^\n]*: \d+% \([^\n]*\)\n", "", self.err, flags=re.M)

    def __str__(self):
        return f"status {self.status}\nstdout: {self.out[:2000]}\nstderr: {self.err[:2000]}"


def exr_header(data):
    """Of a single-part EXR: (name, kind) of its channels, the data window's size, and where the table of its blocks begins."""
    attributes, at = exr_attributes(data)
    body, place, channels = attributes["channels"][1], 0, []
    while body[place] != 0:
        end = body.index(b"\0", place)
        channels.append((body[place:end].decode(), struct.unpack("<i", body[end + 1:end + 5])[0]))
        place = end + 17
    low_x, low_y, high_x, high_y = struct.unpack("<4i", attributes["dataWindow"][1])
    return channels, (high_x - low_x + 1, high_y - low_y + 1), at


def read_exr(data):
    """The channels of a single-part ZIP EXR of floats and half floats: name -> rows of values."""
    kinds, (width, height), at = exr_header(data)
    sizes = [2 if kind == 1 else 4 for _, kind in kinds]
    channels = {name: [] for name, _ in kinds}
    at += 8 * -(-height // 16)
    for top in range(0, height, 16):
        rows = min(16, height - top)
        (length,) = struct.unpack("<i", data[at + 4:at + 8])
        packed = data[at + 8:at + 8 + length]
        at += 8 + length
        whole = width * rows * sum(sizes)
        if length < whole:   # as OpenEXR's ZIP: differences, of even and odd bytes
            plain = bytearray(zlib.decompress(packed))
            for i in range(1, len(plain)):
                plain[i] = (plain[i - 1] + plain[i] - 128) & 255
            half = (len(plain) + 1) // 2
            packed = bytearray(len(plain))
            packed[0::2], packed[1::2] = plain[:half], plain[half:]
        place = 0
        for _ in range(rows):
            for (name, _), size in zip(kinds, sizes):
                channels[name].append(struct.unpack_from(f"<{width}{'e' if size == 2 else 'f'}", packed, place))
                place += width * size
    return channels


# Ray data in a file of --layers, by their names in one of --raydata.
BESIDE_LAYERS = {**{f"sky.{c}": f"direction.{c}" for c in "xyz"}, **{f"ray.hit_{c}": f"place.{axis}" for c, axis in zip("uvw", "xyz")}}
PLACE = ("ray.hit_u", "ray.hit_v", "ray.hit_w")


def as_ray_data(channels):
    """The channels of a file of --layers, ray data by their names in one of --raydata."""
    names = {other: name for name, other in BESIDE_LAYERS.items()}
    return {names.get(name, name): rows for name, rows in channels.items()}


class CliTest(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory(prefix="nullscope-cli-")
        self.addCleanup(self._folder.cleanup)
        self.folder = Path(self._folder.name)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return str(path)

    def run_nullscope(self, *arguments, status=0, before=None, environment=None):
        """before: called in the new process, to set its limits. environment: variables to add."""
        done = subprocess.run([BINARY, *map(str, arguments)], capture_output=True, timeout=LONGEST_S, cwd=self.folder,
                              preexec_fn=before,
                              env={**os.environ, "XDG_STATE_HOME": str(self.folder / "state"), **(environment or {})})
        ran = Ran(done)
        self.assertEqual(ran.status, status, f"nullscope {' '.join(map(str, arguments))}\n{ran}")
        return ran

    def refused(self, *arguments, status=2, says=(), before=None, environment=None):
        """One line on standard error with every word of `says`, nothing on standard output, no file more or less."""
        files = sorted(p.name for p in self.folder.rglob("*"))
        ran = self.run_nullscope(*arguments, status=status, before=before, environment=environment)
        self.assertEqual(ran.out, "", ran)
        self.assertTrue(ran.err.startswith("nullscope: ") and ran.err.endswith("\n"), ran)
        self.assertEqual(ran.err.count("\n"), 1, ran)
        self.assertFalse([c for c in ran.err[:-1] if ord(c) < 0x20 or c == "\x7f"], ran)
        for word in says:
            self.assertIn(word, ran.err)
        self.assertEqual(sorted(p.name for p in self.folder.rglob("*")), files, "files were left behind or lost")
        return ran.err

    def started(self, *arguments, **how):
        """A run that goes on; killed after the test if it still does. how: as subprocess.Popen has it."""
        process = subprocess.Popen([BINARY, *map(str, arguments)], cwd=self.folder, stdout=subprocess.DEVNULL, **how)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def wait(self, what, until, process=None, pause_s=0.005):
        """Until it is so: `what` says what is waited for. Fails where that takes too long, or where this process has ended."""
        deadline = time.monotonic() + LONGEST_S
        while not until():
            self.assertTrue(process is None or process.poll() is None, f"it ended by itself before {what}")
            self.assertLess(time.monotonic(), deadline, what)
            time.sleep(pause_s)

    def contexts(self):
        """The contexts that work here; at least one."""
        out = self.run_nullscope("info").out
        found = [kind for kind in ("egl", "osmesa", "wgl") if f"{kind}: OpenGL" in out]
        self.assertTrue(found, out)
        return found


def main():
    unittest.main()
