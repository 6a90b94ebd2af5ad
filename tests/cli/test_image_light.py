#!/usr/bin/env python3
"""What an image holds arrives: skies, bodies and discs from files that are written here, number by number, against the light that is
drawn. Nothing of the program or of its packages makes the files or reads the pictures."""
import json
import math
import re
import shutil
import struct
import subprocess
from pathlib import Path

import support
from image_bytes import attribute, exr_head, png

TOLERANCE = 1e-3   # relative: half a step of a half float is 4.9e-4, and weights of a software driver's filter have 8 bits


def exr(*parts, half=False):
    """Of parts (name, {channel: value_of(x, y)}, data window, display window, attributes): an uncompressed EXR."""
    several = len(parts) > 1
    heads, offsets = [], []
    for name, channels, data, display, extra in parts:
        rows = data[3] - data[1] + 1
        more = [attribute("name", "string", name.encode()), attribute("type", "string", b"scanlineimage"),
                attribute("chunkCount", "int", struct.pack("<i", rows))] if several else []
        heads.append(exr_head(channels, data, display, 1 if half else 2, [*extra, *more]))
    start = b"\x76\x2f\x31\x01" + struct.pack("<I", 2 | (0x1000 if several else 0)) + b"".join(heads) + (b"\0" if several else b"")
    at = len(start) + sum(8 * (p[2][3] - p[2][1] + 1) for p in parts)
    blocks = []
    for number, (_, channels, data, _, _) in enumerate(parts):
        for y in range(data[1], data[3] + 1):
            line = b"".join(struct.pack(f"<{data[2] - data[0] + 1}{'e' if half else 'f'}",
                                        *(channels[n](x, y) for x in range(data[0], data[2] + 1))) for n in sorted(channels))
            blocks.append((struct.pack("<i", number) if several else b"") + struct.pack("<ii", y, len(line)) + line)
            offsets.append(at)
            at += len(blocks[-1])
    return start + struct.pack(f"<{len(offsets)}Q", *offsets) + b"".join(blocks)


def plain_exr(width, height, channels, extra=(), half=False):
    window = (0, 0, width - 1, height - 1)
    return exr(("", channels, window, window, list(extra)), half=half)


def rgb(red, green, blue):
    return {"R": red, "G": green, "B": blue}


def grey(value):
    return rgb(*[lambda x, y: value] * 3)


def hdr(width, height, pixel, header="", size=None):
    rows = b"".join(bytes(pixel(x, y)) for y in range(height) for x in range(width))
    return f"#?RADIANCE\n{header}FORMAT=32-bit_rle_rgbe\n\n{size or f'-Y {height} +X {width}'}\n".encode() + rows


def coloured_png(width, height, pixel, bits=16, chunks=(), alpha=False):
    rows = b"".join(b"\0" + struct.pack(f">{(4 if alpha else 3) * width}{'H' if bits == 16 else 'B'}",
                                        *(v for x in range(width) for v in pixel(x, y))) for y in range(height))
    return png(width, height, rows, bits, 6 if alpha else 2, chunks)


def linear(code):
    return code / 12.92 if code <= 0.04045 else ((code + 0.055) / 1.055) ** 2.4


FLAT = '[spacetime]\nmetric = "minkowski"\n[camera]\nr = 30.0\ntheta = 90.0\nfov = {fov}\n'


class ImageLight(support.CliTest):
    def drawn(self, name, *options, fov=60, size="32x18", sky="", more=""):
        self.write("s.toml", FLAT.format(fov=fov) + f'[sky]\nkind = "image"\nimage = "{name}"\n{sky}\n{more}')
        self.notes = self.run_nullscope("capture", "s.toml", "--size", size, *options, "-o", "s.exr").err
        self.notes = "".join(line for line in self.notes.splitlines(True) if "reading" not in line)
        got = support.read_exr((self.folder / "s.exr").read_bytes())
        return [[tuple(got[c][y][x] for c in "RGB") for x in range(len(got["R"][0]))] for y in range(len(got["R"]))]

    def near(self, got, wanted, tolerance=TOLERANCE):
        for one, other in zip(got, wanted):
            self.assertLessEqual(abs(one - other), tolerance * abs(other), (got, wanted))

    def test_a_grey_arrives_as_it_is_and_is_neutral(self):
        for value in (1.03, 0.2007, 0.0123, 3e-6, 333.3, 2.5e5):
            self.write("g.exr", plain_exr(64, 32, grey(value)))
            for size, fov in (("16x9", 60), ("4x2", 150)):   # the finest level, and a coarse one
                for row in self.drawn("g.exr", size=size, fov=fov):
                    for pixel in row:
                        self.near(pixel, (value,) * 3)
                        self.assertEqual(len(set(pixel)), 1, pixel)
            self.assertEqual(self.notes, "")

    def test_kinds_of_files(self):
        value = linear(40321 / 65535)
        self.write("g.png", coloured_png(64, 32, lambda x, y: (40321,) * 3))
        self.near(self.drawn("g.png", size="8x4")[1][3], (value,) * 3)
        self.write("g.hdr", hdr(64, 32, lambda x, y: (211, 211, 211, 129)))
        self.near(self.drawn("g.hdr", size="8x4")[1][3], (211 / 128,) * 3)
        self.write("b.png", coloured_png(64, 32, lambda x, y: (201, 101, 11), bits=8))
        self.near(self.drawn("b.png", size="8x4")[1][3], [linear(v / 255) for v in (201, 101, 11)])
        self.near(self.drawn("b.png", size="8x4", sky="brightness = 1e-4")[1][3], [1e-4 * linear(v / 255) for v in (201, 101, 11)])
        self.write("h.exr", plain_exr(64, 32, grey(1.03), half=True))
        self.near(self.drawn("h.exr", size="8x4")[1][3], (struct.unpack("<e", struct.pack("<e", 1.03))[0],) * 3)

    def test_light_that_varies(self):
        """Of a direction d: 0.3 + 0.1 d. The camera looks along -x; columns are azimuth, 0 in the middle, growing to the left."""
        w, h = 1024, 512
        angles = [((0.5 - (x + 0.5) / w) * 2 * math.pi) for x in range(w)]
        heights = [(0.5 - (y + 0.5) / h) * math.pi for y in range(h)]
        self.write("v.exr", plain_exr(w, h, rgb(lambda x, y: 0.3 + 0.1 * math.cos(angles[x]) * math.cos(heights[y]),
                                                lambda x, y: 0.3 + 0.1 * math.sin(angles[x]) * math.cos(heights[y]),
                                                lambda x, y: 0.3 + 0.1 * math.sin(heights[y]))))
        got = self.drawn("v.exr", size="64x36", fov=80)
        for y in range(36):
            for x in range(64):
                along, up = [t * math.tan(math.radians(40)) / 32 for t in (x + 0.5 - 32, 18 - y - 0.5)]
                length = math.sqrt(1 + along * along + up * up)
                self.near(got[y][x], [0.3 + 0.1 * v / length for v in (-1, along, up)])

    def test_a_galactic_panorama(self):
        """The recipe of docs/vfx.md: a spot at a galactic place is seen at its right ascension and declination (SIMBAD)."""
        w, h = 360, 180
        recipe = (Path(__file__).resolve().parents[2] / "docs/vfx.md").read_text()
        shift = float(re.search(r"scroll=hpos=([0-9.]+)", recipe)[1])   # of the width, to the right
        by_ffmpeg = re.search(r"ffmpeg .*scroll.*", recipe)[0].split() if shutil.which("ffmpeg") else None
        turns = re.search(r"tilt = [0-9.]+\nyaw = [0-9.]+\n", recipe)[0]
        for l, b, ra, dec in ((359.9442, -0.0462, 266.4168, -29.0078), (283.7778, 74.4912, 187.7059, 12.3911), (0.0, 90.0, 192.8595, 27.1283)):
            column, row = (0.5 - ((l + 180) % 360 - 180) / 360) * w, (0.5 - b / 180) * h
            width = math.cos(math.radians(b))
            def spot(x, y):
                along = (x + 0.5 - (0 if by_ffmpeg else shift * w) - column + w / 2) % w - w / 2
                return 60000 if math.hypot(width * along, y + 0.5 - row) < 3 else 0
            self.write("galactic.png" if by_ffmpeg else "shifted.png", coloured_png(w, h, lambda x, y: (spot(x, y),) * 3))
            if by_ffmpeg:
                subprocess.run([*by_ffmpeg[:1], "-y", "-v", "error", *by_ffmpeg[1:]], cwd=self.folder, check=True)
            self.write("g.toml", FLAT.format(fov=360) + f'projection = "equirectangular"\n[sky]\nkind = "image"\nimage = "shifted.png"\n{turns}')
            self.run_nullscope("capture", "g.toml", "--size", f"{w}x{h}", "--raydata", "-o", "g.exr")
            got = support.read_exr((self.folder / "g.exr").read_bytes())
            sums = [0.0] * 3
            for y in range(h):
                for x in range(w):
                    light = got["G"][y][x] * math.cos(math.pi * ((y + 0.5) / h - 0.5))   # of a pixel's solid angle
                    for i, axis in enumerate("xyz" if light > 0 else ""):
                        sums[i] += light * got[f"sky.{axis}"][y][x]
            ra, dec = math.radians(ra), math.radians(dec)
            wanted = math.cos(dec) * math.cos(ra), math.cos(dec) * math.sin(ra), math.sin(dec)
            off = math.degrees(math.acos(min(1, sum(a * b for a, b in zip(sums, wanted)) / math.hypot(*sums))))
            self.assertLess(off, 0.5, (l, b))   # half a pixel; ffmpeg shifts by whole ones

    def test_coarse_levels_keep_the_mean(self):
        self.write("c.exr", plain_exr(256, 128, rgb(*[lambda x, y: 2.0 if (x + y) % 2 else 0.03] * 3)))
        for row in self.drawn("c.exr", size="4x2", fov=120):
            for pixel in row:
                self.near(pixel, (1.015,) * 3)

    def faces(self, name, fov):
        """As plan says: (px without the border of 1/32 on each side, bytes a texel, why)."""
        self.write("p.toml", FLAT.format(fov=fov) + f'[sky]\nkind = "image"\nimage = "{name}"\n')
        (line,) = [t for t in json.loads(self.run_nullscope("plan", "p.toml", "--json").out)["tables"] if t["name"] == "sky"]
        return line["width"] * 32 // 34, line["bytes"] / (8 * line["width"] ** 2), line["reason"]

    def test_faces_are_as_fine_as_picture_and_image(self):
        """A texel in a face's middle spans 2/px; a picture of fov over w px asks for 2/(fov/w), an image for 1.5 columns/pi."""
        for columns, fov, wanted, lost in ((256, 100, 2048, False), (2048, 1, 2048, False), (8192, 100, 2048, False), (8192, 1, 4096, False), (16384, 1, 4096, True)):
            self.write("w.png", coloured_png(columns, 2, lambda x, y: (200,) * 3, bits=8))
            width, texel, reason = self.faces("w.png", fov)
            self.assertEqual(texel, 8)
            self.assertIn("half floats", reason)
            self.assertEqual(width, wanted, (columns, fov))
            self.assertEqual("details are lost" in reason, lost, reason)
        self.assertIn("7823 px", reason)

    @support.costly
    def test_images_on_bodies_and_discs(self):
        for value in (1.03, 0.0123, 333.3):
            self.write("g.exr", plain_exr(33, 17, grey(value)))   # odd sides
            ball = '[ball]\nposition = [10, 0, 0]\nradius = 8\ntexture = "image"\nimage = "g.exr"\n'
            disc = '[disc]\ninner = 0.5\nouter = 12\ntexture = "image"\nimage = "g.exr"\n'
            for body, theta in ((ball, 90), (disc, 5)):
                for size in ("32x18", "2x2"):   # the finest level, and a coarse one
                    self.write("b.toml", FLAT.format(fov=10).replace("90.0", f"{theta}.0") + '[sky]\nkind = "black"\n' + body)
                    self.run_nullscope("capture", "b.toml", "--size", size, "-o", "b.exr")
                    got = support.read_exr((self.folder / "b.exr").read_bytes())
                    for row in range(len(got["R"])):
                        self.near([got[c][row][0] for c in "RGB"], (value,) * 3)

    def test_skies_of_both_ends_of_a_wormhole(self):
        self.write("a.exr", plain_exr(64, 32, grey(1.03)))
        self.write("b.exr", plain_exr(64, 32, grey(250.0)))
        for near, far, values in (("a", "b", {1.03, 250.0}), (None, "b", {0.0, 250.0})):
            sky = f'[sky]\nkind = "image"\nimage = "{near}.exr"\n' if near else '[sky]\nkind = "black"\n'
            self.write("w.toml", '[spacetime]\nmetric = "ellis"\n[camera]\nr = 5.0\ntheta = 90.0\n' + sky + f'[far_sky]\nkind = "image"\nimage = "{far}.exr"\n')
            self.run_nullscope("capture", "w.toml", "--size", "32x18", "-o", "w.exr")
            got = support.read_exr((self.folder / "w.exr").read_bytes())
            light = [tuple(got[c][y][x] for c in "RGB") for y in range(18) for x in range(32)]
            pure = [v for v in values if any(abs(p[0] - v) <= TOLERANCE * v for p in light)]
            self.assertEqual(set(pure), values)   # and mixtures at the throat's edge
            self.assertTrue(all(len(set(p)) == 1 for p in light))

    def test_half_floats_are_finite(self):
        sky = '[sky]\nkind = "plain"\ncolour = [1000, 1000, 0.5]\nbrightness = 1000\n'
        for eyes in ("", 'stereo = "pair"\neye_distance = 0.1\n'):
            self.write("hot.toml", FLAT.format(fov=60) + eyes + sky)
            self.run_nullscope("capture", "hot.toml", "--size", "8x4", "--half", "-o", "a.exr")
            self.assertEqual({value for rows in support.read_exr((self.folder / "a.exr").read_bytes()).values() for row in rows for value in row}, {500.0, 65504.0}, eyes)

    def test_images_on_things_say_where_half_floats_end(self):
        for name, light, cut in (("a.exr", 1e6, True), ("b.exr", 6e4, False)):
            self.write(name, plain_exr(16, 8, grey(light)))
            for thing in (f'[sphere]\nradius = 4\ntexture = "image"\nimage = "{name}"\n', f'[disc]\nimage = "{name}"\n'):
                self.write("s.toml", FLAT.format(fov=60) + '[sky]\nkind = "black"\n' + thing)
                for words in ((), ("--quiet",)):
                    said = self.run_nullscope("capture", "s.toml", "--size", "32x18", *words, "-o", "s.exr").said()
                    self.assertEqual("above 65504, the largest half float" in said, cut and not words, (thing, words, said))

    def test_no_light_is_below_0(self):
        self.run_nullscope("capture", "m87", "--size", "96x54", "-o", "m.exr")
        got = support.read_exr((self.folder / "m.exr").read_bytes())
        self.assertGreaterEqual(min(v for rows in got.values() for row in rows for v in row), 0.0)


if __name__ == "__main__":
    support.main()
