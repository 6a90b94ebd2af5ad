#!/usr/bin/env python3
"""Visibilities that see the photon ring: to 100 Gλ those of its rings' closed form, at a few times the cost of a picture, where pixels of that cost fail."""
import csv
import math
import os

import support
from support import costly

UAS = math.pi / 180 / 3600e6
M = 3.818993252351 * UAS   # M87*'s, rad
# A ring of light at r = 6 M = 3 r_s, seen along its axis: its profile is a Gaussian, and it shines at every place alike. Images n = 0, 1, 2, of
# n half turns more, are rings of radius b, and db/dr as wide.
SIGMA = 0.03   # M
IMAGES = ((6.93214847919, 1.0092948), (5.47891372208, 0.0656387), (5.20798958755, 0.00243445))
VIEW = '[spacetime]\n{metric}\n[camera]\nr = {r}\ntheta = {theta}\nfov = {fov}\nsize = [512, 512]\n[sky]\nkind = "black"\n[object]\nname = "m87"\n'
RING = '[disc]\ninner = {inner}\nouter = {outer}\ntexture = "formula"\nformula = "exp(-0.5 * ((v - 0.5) * {width} / {sigma})^2)"\n' \
       'colour = [1, 1, 1]\nsecond_colour = [0, 0, 0]\n'
FACE_ON = VIEW.format(metric='metric = "schwarzschild"', r=1e5, theta=0, fov=0.00573) + RING.format(inner=2.9, outer=3.1, width=0.2, sigma=SIGMA / 2)
INCLINED = VIEW.format(metric='metric = "kerr"\nspin = 0.9', r=1e4, theta=60, fov=0.0573) + RING.format(inner=2.0, outer=4.0, width=2.0, sigma=0.1)
LINE = ("--radial", "30", "100", "--points", "401")


def bessel(x):
    steps = 800
    return sum(math.cos(x * math.sin(t)) for t in (2 * math.pi * k / steps for k in range(steps))) / steps


def rings(u):
    """V of the three rings, and the envelope of its fringes."""
    whole = sum(b * width for b, width in IMAGES)
    seen = envelope = 0
    for b, width in IMAGES:
        light = b * width / whole * math.exp(-2 * (math.pi * SIGMA * width * M * u) ** 2)
        seen += light * bessel(2 * math.pi * b * M * u)
        envelope += light * min(1, math.sqrt(1 / (math.pi ** 2 * b * M * u)) if u else 1)
    return seen, envelope


class PhotonRing(support.CliTest):
    def seen(self, *words):
        """What it said, and V by the baseline's length."""
        ran = self.run_nullscope("visibility", *words, "-o", "v")
        with open(self.folder / "v.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        unit = "_jy" if "real_jy" in rows[0] else ""
        return ran, [(math.hypot(float(row["u"]), float(row["v"])), complex(float(row["real" + unit]), float(row["imaginary" + unit]))) for row in rows]

    def off(self, found):
        """The most by which |V| departs from the rings', of the envelope, at all baselines and beyond 20 Gλ."""
        errors = []
        for u, light in found:
            meant, envelope = rings(u)
            errors.append((u, abs(abs(light) - abs(meant)) / envelope))
        return max(error for _, error in errors), max(error for u, error in errors if u > 20e9)

    def spent(self, *words):
        """Core-seconds; the least of three, as others use the machine."""
        least = math.inf
        for _ in range(3):
            before = os.times()
            self.run_nullscope(*words)
            after = os.times()
            least = min(least, after.children_user + after.children_system - before.children_user - before.children_system)
        return least

    def test_three_images_to_100_glambda(self):
        scene = self.write("ring.toml", FACE_ON)
        ran, parts = self.seen(scene, *LINE, "--rings")
        self.assertRegex(ran.out, r"512x512 pixels \(points\) of 0\.149\d µas and 512x512 rays along the critical curve")
        self.assertLess(self.off(parts)[0], 0.01)
        ran, grid = self.seen(scene, *LINE, "--size", "640x640")
        self.assertGreater(self.off(grid)[1], 0.01)
        print(f"off by {self.off(parts)[0]:.2g} of the envelope; pixels of that cost, beyond 20 Gλ, by {self.off(grid)[1]:.2g}")
        self.assertRegex(ran.err, r"V may be off by more than 1 % from [\d.]+ Gλ on, where it changes by that with half as many pixels a side: .* --rings")

    @support.costly
    def test_they_cost_four_pictures_at_most(self):
        scene = self.write("ring.toml", FACE_ON)
        picture = self.spent("capture", scene, "-o", "p.png")
        parts = self.spent("visibility", scene, *LINE, "--rings", "-o", "v")
        grid = self.spent("visibility", scene, *LINE, "--size", "640x640", "-o", "v")
        print(f"{picture:.2f}, {parts:.2f} and {grid:.2f} core-s: a picture, parts, 640x640 pixels")
        self.assertLess(parts, 4 * picture, "of its picture's core-seconds")
        self.assertLess(parts, 1.5 * grid, "the grid that fails costs no less")

    @costly
    def test_a_rotating_hole_seen_from_the_side(self):
        scene = self.write("kerr.toml", INCLINED)
        line = ("--radial", "30", "60", "--points", "31")
        _, parts = self.seen(scene, *line, "--rings")
        _, fine = self.seen(scene, *line, "--size", "2048x2048")
        off = max(abs(light - meant) for (_, light), (_, meant) in zip(parts, fine))
        print(f"rotating: off by {off:.2g} of the light")
        self.assertLess(off, 3e-4)   # |V| falls to 0.04; pixels and, here, textures are means over their places

    @costly
    def test_matter(self):
        line = ("--radial", "90", "40", "--points", "41")
        ran, parts = self.seen("m87-synchrotron", "--size", "128x128", *line, "--rings")
        _, grid = self.seen("m87-synchrotron", "--size", "128x128", *line)
        _, fine = self.seen("m87-synchrotron", "--size", "768x768", *line)
        self.assertIn(" Jy in all", ran.out)
        error = [max(abs(light - meant) for (_, light), (_, meant) in zip(found, fine)) for found in (parts, grid)]
        print(f"matter: off by {error[0]:.2g} Jy; its 128x128 pixels alone by {error[1]:.2g}")
        self.assertLess(error[0], 5e-4)   # Jy, of 0.488
        self.assertLess(error[0], 0.5 * error[1])

    def test_what_cannot_be_is_refused(self):
        scene = self.write("ring.toml", FACE_ON)
        flat = self.write("flat.toml", FACE_ON.replace("schwarzschild", "minkowski"))
        near = self.write("near.toml", FACE_ON.replace("fov = 0.00573", "fov = 0.004"))
        zoomed = self.write("zoomed.toml", FACE_ON + "[zoom]\ndepth = 1\n")
        for words, says in (((scene, "--pixel", "square"), ["--pixel", "--rings"]), ((flat,), ["--rings", "critical curve"]),
                            ((near,), ["--rings", "does not hold the band", "1.6"]), ((zoomed,), ["[zoom]"]),
                            (("--image", "a.fits"), ["--rings", "--image"])):
            with self.subTest(words):
                self.refused("visibility", *words, "--radial", "0", "1", "--rings", says=says)


if __name__ == "__main__":
    support.main()
