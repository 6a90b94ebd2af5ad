#!/usr/bin/env python3
"""scripts/fetch_stars.py reads Stellarium's star files: made here, of stars that are known."""
import math
import random
import struct
import subprocess
import sys
from pathlib import Path

import support

ROOT = Path(support.__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import fetch_stars  # noqa: E402


def star_file(kind, level, stars):
    """A file with these stars, (unit vector, magnitude step, colour code), each in the zone whose middle is nearest."""
    zones, scale = fetch_stars.frames(level)
    largest = 0x7fffffff if kind == fetch_stars.HIPPARCOS else (1 << 19) - 1
    records = [b""] * len(zones)
    for place, magnitude, colour in stars:
        zone = max(range(len(zones)), key=lambda i: fetch_stars.dot(place, zones[i][0]))
        middle, east, north = zones[zone]
        along = fetch_stars.dot(place, middle)
        x, y = (round(fetch_stars.dot(place, axis) / along / scale * largest) for axis in (east, north))
        if kind == fetch_stars.HIPPARCOS:
            records[zone] += struct.pack("<IiiBBHiii", 1, x, y, colour, magnitude, 0, 0, 0, 0)
        else:
            records[zone] += (x & 0xfffff | (y & 0xfffff) << 20 | colour << 68 | magnitude << 75).to_bytes(10, "little")
    size = 28 if kind == fetch_stars.HIPPARCOS else 10
    counts = [len(record) // size for record in records] + [0]
    return (struct.pack("<5Ii2I", fetch_stars.MAGIC, kind, 0, 4, level, -2000, 12800, 256) +
            struct.pack(f"<{len(counts)}I", *counts) + b"".join(records))


class Stars(support.CliTest):
    def test_what_was_written_is_read(self):
        chance = random.Random(1)
        for kind, level, most_arc_seconds in ((fetch_stars.HIPPARCOS, 0, 0.01), (fetch_stars.TYCHO, 3, 0.2)):
            stars = [(fetch_stars.unit([chance.gauss(0, 1) for _ in range(3)]), chance.randrange(32), chance.randrange(128)) for _ in range(300)]
            read = list(fetch_stars.read_catalogue(star_file(kind, level, stars)))
            self.assertEqual(len(read), len(stars))
            for place, magnitude, colour in stars:
                ra, dec = math.degrees(math.atan2(place[1], place[0])) % 360.0, math.degrees(math.asin(place[2]))
                off, found = min((math.hypot((star[0] - ra + 180) % 360 - 180, 0) * math.cos(math.radians(dec)) + abs(star[1] - dec), star)
                                 for star in read)
                self.assertLess(3600.0 * off, most_arc_seconds)
                self.assertAlmostEqual(found[2], -2.0 + 12.8 * magnitude / 256)
                self.assertAlmostEqual(found[3], fetch_stars.colour_index(colour))

    def test_broken_files_are_refused(self):
        good = star_file(fetch_stars.TYCHO, 0, [((0.0, 0.6, 0.8), 3, 4)])
        for broken in (good[:20], good[:-1], good + b"\0", b"\0" * len(good)):
            with self.assertRaises((ValueError, struct.error)):
                list(fetch_stars.read_catalogue(broken))

    def test_without_the_package_one_line_says_what_to_do(self):
        done = subprocess.run([sys.executable, "-B", ROOT / "scripts/fetch_stars.py", self.folder, "-o", self.folder / "stars.bin"],
                              capture_output=True, text=True, timeout=support.LONGEST_S)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1)
        self.assertFalse((self.folder / "stars.bin").exists())

    def test_a_scene_with_stars_that_were_not_fetched(self):
        (self.folder / "deep.toml").write_text('[sky]\ncatalogue = "tycho-2"\n')
        if not (ROOT / "assets/sky/stars-tycho-2.bin").exists():
            self.refused("capture", "deep.toml", "--size", "32x32", "-o", "deep.png", says=["sky.catalogue", "scripts/fetch_stars.py"])

    def test_uniform_stars_are_alone(self):
        """Behind them is nothing, by either renderer."""
        self.write("s.toml", '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "points"\nuniform_stars = 1\nmagnitude_limit = 30\n')
        for renderer in "gl", "reference":
            self.run_nullscope("capture", "s.toml", "--size", "32x18", "--renderer", renderer, "-o", "s.exr")
            light = support.read_exr((self.folder / "s.exr").read_bytes())
            self.assertEqual(max(max(map(max, light[c])) for c in "RGB"), 0, renderer)


if __name__ == "__main__":
    support.main()
