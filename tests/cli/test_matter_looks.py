#!/usr/bin/env python3
"""How scenes of matter that ship look: displayed luminance of the matter's pixels, from PNG and layers; how much they send, in Jy."""
import re
import tomllib
import zlib
from pathlib import Path

import support
from image_bytes import png_chunks

SCENES = Path(__file__).resolve().parents[2] / "assets/scenes"
SIZE = ("--size", "96x54")
MATTER = 9          # of `hit`: half of a pixel's light or more is from matter
LEAST_SPAN = 0.5    # of 1, white: from nearly black to bright, where a murky or flat picture spans 0.2 to 0.4


def decoded(level):
    """IEC 61966-2-1: linear light of a display, of an 8-bit level."""
    value = level / 255
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


LINEAR = [decoded(level) for level in range(256)]


def luminances(data):
    """Rows of an RGB PNG of 8 bits: 0.2126 R + 0.7152 G + 0.0722 B (Rec. 709) of the light that a display sends, 1 is white."""
    packed = b""
    for name, body in png_chunks(data):
        if name == b"IHDR":
            width, height = int.from_bytes(body[:4], "big"), int.from_bytes(body[4:8], "big")
            if body[8:10] != b"\x08\x02":
                raise ValueError("not an RGB PNG of 8 bits")
        packed += body if name == b"IDAT" else b""
    plain, stride, above = zlib.decompress(packed), 3 * width, bytes(3 * width)
    rows = []
    for y in range(height):
        kind, line = plain[y * (stride + 1)], bytearray(plain[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = line[i - 3] if i > 2 else 0, above[i], above[i - 3] if i > 2 else 0
            paeth = min((left, up, corner), key=lambda side: abs(left + up - corner - side))
            line[i] = (line[i] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
        rows.append([0.2126 * LINEAR[line[x]] + 0.7152 * LINEAR[line[x + 1]] + 0.0722 * LINEAR[line[x + 2]] for x in range(0, stride, 3)])
        above = line
    return rows


def percentile(values, part):
    return sorted(values)[round(part * (len(values) - 1))]


class Looks(support.CliTest):
    def spread(self, scene):
        """5th and 95th percentile of the displayed luminance of matter, and the share of the picture that it is."""
        self.run_nullscope("capture", scene, *SIZE, "--plain", "-o", "shown.png")
        self.run_nullscope("capture", scene, *SIZE, "--layers", "-o", "layers.exr")
        shown = luminances((self.folder / "shown.png").read_bytes())
        hit = support.read_exr((self.folder / "layers.exr").read_bytes())["hit"]
        matter = [light for line, fates in zip(shown, hit) for light, fate in zip(line, fates) if fate == MATTER]
        return percentile(matter, 0.05), percentile(matter, 0.95), len(matter) / (96 * 54)

    @support.costly
    def test_matter_of_scenes_that_ship_is_neither_murky_nor_flat(self):
        scenes = [path for path in sorted(SCENES.glob("*.toml")) if "medium" in tomllib.loads(path.read_text())]
        for path in scenes:
            low, high, share = self.spread(path.stem)
            print(f"{path.stem}: luminance of matter {low:.3f} to {high:.3f}, {100 * share:.0f} % of the picture", flush=True)
            self.assertGreater(share, 0.1, path.stem)
            self.assertGreaterEqual(high - low, LEAST_SPAN, path.stem)

    def test_a_dim_scene_fails(self):
        dim = (SCENES / "soft-disc.toml").read_text().replace("brightness = ", "brightness = 0.1 #")
        low, high, _ = self.spread(self.write("dim.toml", dim))
        self.assertLess(high - low, LEAST_SPAN)


CLUMP = "1e7 * exp(-((x - 4 * cos(0.25 * t))^2 + (y - 4 * sin(0.25 * t))^2 + z^2))"   # once round in 8 pi r_s/c


class Fluxes(support.CliTest):
    def curve(self, scene, *options):
        self.run_nullscope("lightcurve", scene, *options, "-o", "curve")
        header, *lines = (self.folder / "curve.csv").read_text().split()
        return header.split(","), [[float(word) for word in line.split(",")] for line in lines]

    def test_sgr_a_is_as_bright_as_observed(self):
        """2.4 Jy at 230 GHz: Event Horizon Telescope Collaboration 2022 (ApJL 930, L16); by both tracers."""
        for how in ((), ("--renderer", "reference", "--samples", "1")):
            said = self.run_nullscope("capture", "sgr-a-synchrotron", "--size", "96x54", *how, "-o", "a.exr").out
            flux = float(re.search(r"(\S+) Jy at 230 GHz", said).group(1))
            self.assertLess(abs(flux / 2.4 - 1), 0.02, said)     # 96x54: within 0.5 % of 1280x720

    @support.costly
    def test_light_curves_of_matter_are_in_jansky(self):
        """A clump that goes round: as bright as each picture by itself, and as the reference has it."""
        text = (SCENES / "sgr-a-synchrotron.toml").read_text()
        moving = re.sub(r'(?m)^density = "(.*)"$', lambda key: f'density = "{key[1]} + {CLUMP}"', text)
        self.assertIn("cos(0.25 * t)", moving)
        scene = self.write("clump.toml", moving)
        columns, rows = self.curve(scene, "--size", "64x36", "--from", "1000", "--to", "1020", "--steps", "3")
        self.assertEqual(columns, ["time", "flux", "red", "green", "blue", "jansky"])
        self.assertGreater(max(row[5] for row in rows) / min(row[5] for row in rows), 1.02)
        for row in rows:
            said = self.run_nullscope("capture", scene, "--size", "64x36", "--time", row[0], "-o", "a.fits").out
            flux = float(re.search(r"(\S+) Jy at 230 GHz", said).group(1))
            self.assertLess(abs(row[5] / flux - 1), 0.01, (row, said))     # of refined pixels, which the curve does not have
        _, exact = self.curve(scene, "--size", "64x36", "--from", "1000", "--to", "1020", "--steps", "3", "--renderer", "reference")
        for row, other in zip(rows, exact):
            self.assertLess(abs(row[5] / other[5] - 1), 0.005, (row, other))
        diagram = (self.folder / "curve.svg").read_text(encoding="utf-8")
        self.assertIn("Jy at 230 GHz", diagram)
        half = self.curve(scene, "--size", "64x36", "--from", "1000", "--to", "1020", "--steps", "3", "--region", "0", "0", "32", "36")[1]
        rest = self.curve(scene, "--size", "64x36", "--from", "1000", "--to", "1020", "--steps", "3", "--region", "32", "0", "64", "36")[1]
        for whole, left, right in zip(rows, half, rest):
            self.assertAlmostEqual(left[5] + right[5], whole[5], delta=1e-6 * whole[5])


if __name__ == "__main__":
    support.main()
