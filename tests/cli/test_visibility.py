#!/usr/bin/env python3
"""Visibilities of scenes and of FITS pictures: closed forms, signs, arrays, noise, faults of tables, and what a day's scans cost."""
import cmath
import csv
import math
import os
import re
import struct
from xml.etree import ElementTree

import support

UAS = math.pi / 180 / 3600e6
# A flat scene, face-on from the axis, in which a r_s is M87*'s: 2 GM/(c^2 D), microarcseconds.
UAS_PER_RS = 2 * 3.818993252351
FLAT = '[spacetime]\nmetric = "minkowski"\n[camera]\nr = 1000\ntheta = {theta}\nfov = {fov}\nsize = [{size}, {size}]\n' \
       '[sky]\nkind = "black"\n[object]\nname = "m87"\n'
RADIUS = 10   # r_s, of rings and discs
DISC = FLAT.format(theta=0, fov=1.5, size=512) + '[disc]\ninner = {}\nouter = {}\ntexture = "plain"\ncolour = [1, 1, 1]\n[picture]\nsamples = 4\n'
# Density exp(-r^2/(2 s^2)), thin: so is the picture.
WIDTH = 3.0   # s, r_s
GAUSSIAN = FLAT.format(theta=60, fov=2.4, size=128) + f'[medium]\nkind = "formula"\nemission = "power-law"\ndensity = "exp(-r^2/{2 * WIDTH ** 2})"\n' \
           f'outer = {5 * WIDTH}\nsteps = 128\nemissivity = 1e-22\n'
# Two balls across the line of sight: the camera is at phi = 0, its right is +y, which is west.
BALL = '[[ball]]\nposition = [0, {y}, {z}]\nradius = 0.5\ntexture = "plain"\ncolour = [{light}, {light}, {light}]\n'
PAIR = FLAT.format(theta=90, fov=1.5, size=512) + "[picture]\nsamples = 4\n" + BALL.format(y=-4, z=1, light=1) + BALL.format(y=4, z=1, light=0.5)
OF_PICTURE = 1e-3


def bessel(order, x):
    """J_n by its integral; the trapezoid rule is exact to rounding for whole turns."""
    steps = 200
    return sum(math.cos(order * t - x * math.sin(t)) for t in (2 * math.pi * k / steps for k in range(steps))) / steps


def write_fits(rows, cards):
    text = "".join(f"{card:<80}" for card in ["SIMPLE  =                    T", "BITPIX  =                  -64", "NAXIS   =                    2",
                                              f"NAXIS1  = {len(rows[0]):>20}", f"NAXIS2  = {len(rows):>20}", *cards, "END"])
    numbers = [value for row in reversed(rows) for value in row]
    return text.ljust(-(-len(text) // 2880) * 2880).encode() + struct.pack(f">{len(numbers)}d", *numbers)


def sky_cards(pixel_uas, *more):
    degrees = pixel_uas / 3600e6
    return [f"CDELT1  = {-degrees!r:>20}", f"CDELT2  = {degrees!r:>20}", *more]


class Visibilities(support.CliTest):
    def rows(self, name="v.csv"):
        with open(self.folder / name, encoding="utf-8", newline="") as file:
            return [{key: value if key.startswith("station") else float(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def visibilities(self, *words):
        """What it said, and V by (u, v)."""
        ran = self.run_nullscope("visibility", *words, "-o", "v")
        unit = "_jy" if "_jy" in (self.folder / "v.csv").read_text().split("\n", 1)[0] else ""
        return ran, [((row["u"], row["v"]), complex(row["real" + unit], row["imaginary" + unit])) for row in self.rows()]

    def minimum(self, ran):
        return float(re.search(r"first minimum of \|V\| at ([\d.]+) Gλ", ran.out)[1]) * 1e9

    def test_a_ring(self):
        size = 2 * RADIUS * UAS_PER_RS * UAS
        ran, found = self.visibilities(self.write("ring.toml", DISC.format(0.995 * RADIUS, 1.005 * RADIUS)), "--radial", "30", 1.5e-9 / size, "--points", "301")
        self.assertIn("not in Jy", ran.err)
        self.assertLess(abs(self.minimum(ran) * size / 0.7654797496 - 1), OF_PICTURE)
        self.assertLess(abs(found[0][1] - 1), 1e-6)
        for (u, v), light in found:
            self.assertLess(abs(light - bessel(0, math.pi * size * math.hypot(u, v))), OF_PICTURE)
        extreme = min(found, key=lambda row: row[1].real)
        self.assertLess(abs(extreme[1].real / -0.4027593957 - 1), 2 * OF_PICTURE)
        self.assertLess(abs(math.hypot(*extreme[0]) * size / 1.2196698913 - 1), 0.005, "the step between two points")

    def test_a_disc(self):
        size = 2 * RADIUS * UAS_PER_RS * UAS
        ran, found = self.visibilities(self.write("disc.toml", DISC.format(1e-3, RADIUS)), "--radial", "-75", 2e-9 / size, "--points", "201")
        self.assertLess(abs(self.minimum(ran) * size / 1.2196698913 - 1), OF_PICTURE)
        for (u, v), light in found[1:]:
            x = math.pi * size * math.hypot(u, v)
            self.assertLess(abs(light - 2 * bessel(1, x) / x), OF_PICTURE)

    def test_a_gaussian_of_matter_in_jansky(self):
        scene = self.write("gaussian.toml", GAUSSIAN)
        said = self.run_nullscope("capture", scene, "-o", "a.fits").out
        ran, found = self.visibilities(scene, "--radial", "10", "4", "--points", "41")
        flux = float(re.search(r"([\d.e-]+) Jy at", said)[1])
        self.assertLess(abs(found[0][1].real / flux - 1), 1e-3, "four digits are printed")
        self.assertNotIn("not in Jy", ran.err)
        width = WIDTH * UAS_PER_RS * UAS
        for (u, v), light in found:
            self.assertLess(abs(light / found[0][1] - math.exp(-2 * (math.pi * width) ** 2 * (u * u + v * v))), OF_PICTURE)
        _, of_file = self.visibilities("--image", "a.fits", "--radial", "10", "4", "--points", "41")
        for (_, light), (_, there) in zip(found, of_file):
            self.assertLess(abs(light - there), 1e-6 * flux)

    def test_a_pair_and_its_east(self):
        scene = self.write("pair.toml", PAIR)
        apart, size, north = (n * UAS_PER_RS * UAS for n in (8, 1, 1))   # of their places, of their discs, over the middle
        self.write("b.csv", "u,v,time_h\n" + "".join(f"{turns / apart!r},{v!r},{turns}\n" for turns in (0, 0.25, 0.5, 1, 2) for v in (0.0, 3e8)))
        _, found = self.visibilities(scene, "--baselines", "b.csv")
        for (u, v), light in found:
            x = math.pi * size * math.hypot(u, v)
            blur = 2 * bessel(1, x) / x if x else 1.0
            # The bright one is at y = -4, left, in the east; half as bright in the west.
            meant = blur * (2 * cmath.exp(1j * math.pi * u * apart) + cmath.exp(-1j * math.pi * u * apart)) / 3 * cmath.exp(2j * math.pi * v * north)
            self.assertLess(abs(light - meant), OF_PICTURE, (u, v))
        self.assertEqual([row["time_h"] for row in self.rows()], [t for t in (0, 0.25, 0.5, 1, 2) for _ in range(2)])

    def said(self):
        """What the diagram says of itself and of the table beside it."""
        texts = ElementTree.parse(self.folder / "v.svg").findall(".//{nullscope}text")
        return {text.get("keyword"): text.text for text in texts}

    def test_the_diagram_says_what_it_was_made_from(self):
        scene = self.write("pair.toml", PAIR)
        self.visibilities(scene, "--radial", "0", "1", "--points", "3", "--size", "32x32")
        said = self.said()
        self.assertEqual(said["nullscope.options"], "--radial 0 1 --points 3 --size 32x32")
        self.write("again.toml", said["nullscope.scene_text"])
        self.run_nullscope("plan", "again.toml")
        self.write("a.fits", self.sky(8))
        self.visibilities("--image", "a.fits", "--radial", "0", "1", "--points", "3")
        self.assertEqual(self.said()["nullscope.options"], "--image a.fits --radial 0 1 --points 3")
        self.assertNotIn("nullscope.scene_text", self.said())
        self.assertIn("to the east", self.said()["nullscope.columns"])

    def test_pixels_of_a_file_are_its_sum_to_a_millionth(self):
        random = support.dice("pixels of a file")
        rows = [[random.random() for _ in range(17)] for _ in range(12)]
        self.write("a.fits", write_fits(rows, sky_cards(1.5, "BUNIT   = 'JY/PIXEL'", "FREQ    =               2.3E11")))
        points = [(0, 0), (3e9, -1e9), (-7e9, 2e10), (8e10, 5e10)]
        self.write("b.csv", "u,v\n" + "".join(f"{u},{v}\n" for u, v in points))
        whole = sum(map(math.fsum, rows))
        for shape in ("point", "square", "triangle"):
            _, found = self.visibilities("--image", "a.fits", "--baselines", "b.csv", "--pixel", shape)
            for (u, v), light in found:
                turns = [1.5 * UAS * w for w in (u, v)]
                factor = math.prod(math.sin(math.pi * t) / (math.pi * t) if t else 1 for t in turns) ** {"point": 0, "square": 1, "triangle": 2}[shape]
                meant = factor * sum(value * cmath.exp(2j * math.pi * (turns[0] * (8 - x) + turns[1] * (5.5 - y)))
                                     for y, row in enumerate(rows) for x, value in enumerate(row))
                self.assertLess(abs(light - meant), 1e-9 * whole)

    def sky(self, side, flux=1.0):
        """A crescent of `side` px, 100 microarcseconds across."""
        rows = [[max(0.0, 1 - abs(math.hypot(x - side / 2, y - side / 2) / side - 0.2) * 20) * (1 + y / side) for x in range(side)] for y in range(side)]
        whole = sum(map(math.fsum, rows))
        return write_fits([[flux * value / whole for value in row] for row in rows],
                          sky_cards(100 / side, "BUNIT   = 'Jy/pixel'", "FREQ    =               2.3E11", "CRVAL1  =          187.7059308", "CRVAL2  =           12.3911233"))

    def test_an_array_as_the_earth_turns(self):
        self.write("a.fits", self.sky(64))
        ran = self.run_nullscope("visibility", "--image", "a.fits", "--array", "eht-2017", "--hours", "0", "24", "0.5", "-o", "v")
        rows, phases = self.rows(), self.rows("v-closure-phases.csv")
        self.assertRegex(ran.out, rf"{len(rows)} baselines up to [\d.]+ Gλ of 8 stations in \d+ scans at 230 GHz; 64x64 pixels \(points\) of 1.563 µas; 1 Jy in all")
        light = {(row["time_h"], row["station_1"], row["station_2"]): cmath.rect(row["amplitude_jy"], math.radians(row["phase_deg"])) for row in rows}
        self.assertGreater(len(phases), 100)
        self.assertFalse({"SPT"} & {name for _, *names in light for name in names}, "M87* never rises at the pole")
        for row in phases:
            a, b, c = (row[f"station_{k}"] for k in (1, 2, 3))
            meant = cmath.phase(light[row["time_h"], a, b] * light[row["time_h"], b, c] * light[row["time_h"], a, c].conjugate())
            self.assertLess(abs(math.remainder(math.radians(row["phase_deg"]) - meant, 2 * math.pi)), 1e-6)
        for row in self.rows("v-closure-amplitudes.csv"):
            a, b, c, d = (row[f"station_{k}"] for k in (1, 2, 3, 4))
            size = lambda *pair: math.log(abs(light[row["time_h"], *pair]))   # noqa: E731
            self.assertLess(abs(size(a, b) + size(c, d) - size(a, c) - size(b, d) - row["log_12_34_over_13_24"]), 1e-6)
            self.assertLess(abs(size(a, b) + size(c, d) - size(a, d) - size(b, c) - row["log_12_34_over_14_23"]), 1e-6)
        svg = (self.folder / "v.svg").read_text()
        self.assertEqual(svg.count("<circle"), len(rows) + 1)
        self.assertIn("--array eht-2017", svg)
        # A dish in space reaches farther than the Earth is wide.
        self.assertLess(max(math.hypot(row["u"], row["v"]) for row in rows), 9.9e9)
        self.run_nullscope("visibility", "--image", "a.fits", "--array", "eht-2017-space", "--hours", "0", "24", "2", "-o", "v")
        self.assertGreater(max(math.hypot(row["u"], row["v"]) for row in self.rows()), 2e10)
        # A source in the south, a lower horizon.
        self.run_nullscope("visibility", "--image", "a.fits", "--array", "eht-2017", "--source", "17.761", "-29.008", "--hours", "0", "24", "2", "--elevation", "5", "-o", "v")
        self.assertIn("SPT", {row["station_2"] for row in self.rows()})

    def test_noise_is_seeded_and_as_large_as_it_says(self):
        self.write("a.fits", self.sky(32))
        array = ("--image", "a.fits", "--array", "eht-2017")
        _, still = self.visibilities(*array)
        off = []
        for seed in ("1", "1", "2"):
            _, found = self.visibilities(*array, "--noise", seed, "--integration", "10")
            off.append([(noisy - light) / row["noise_jy"] for (_, noisy), (_, light), row in zip(found, still, self.rows())])
        self.assertEqual(off[0], off[1])
        self.assertNotEqual(off[0], off[2])
        spread = math.sqrt(sum(abs(one) ** 2 for one in off[0]) / (2 * len(off[0])))
        self.assertLess(abs(spread - 1), 5 / math.sqrt(4 * len(off[0])))
        pair = next(row for row in self.rows() if {row["station_1"], row["station_2"]} == {"ALMA", "LMT"})
        self.assertLess(abs(pair["noise_jy"] / (math.sqrt(74 * 4500 / (4 * 2e9 * 10)) / 0.88) - 1), 1e-5)

    def test_scattering_blurs_by_its_kernel(self):
        self.write("a.fits", self.sky(32))
        line = ("--image", "a.fits", "--radial", "81.9", "6", "--points", "7")
        (_, plain), (_, blurred) = self.visibilities(*line), self.visibilities(*line, "--scattering", "sgr-a")
        width = 1.380e3 * UAS * (29.9792458 / 230) ** 2
        for ((u, v), light), (_, seen) in zip(plain, blurred):
            self.assertLess(abs(seen - light * math.exp(-(math.pi * width) ** 2 * (u * u + v * v) / (4 * math.log(2)))), 1e-8)

    def test_a_days_scans_take_less_than_a_core_second(self):
        self.write("a.fits", self.sky(256))
        spent = []
        for words in (("--radial", "0", "1", "--points", "2"), ("--array", "eht-2017")):
            before = os.times()
            self.run_nullscope("visibility", "--image", "a.fits", *words, "-o", "v")
            after = os.times()
            spent.append(after.children_user + after.children_system - before.children_user - before.children_system)
        self.assertGreater(len(self.rows()), 800)
        self.assertLess(spent[1] - spent[0], 1.0)

    def test_stokes_of_polarised_matter(self):
        self.run_nullscope("capture", "m87-polarimetry", "--size", "48x27", "-o", "a.fits")
        self.run_nullscope("visibility", "m87-polarimetry", "--size", "48x27", "--radial", "45", "5", "--points", "3", "-o", "v")
        of_scene = self.rows()
        self.run_nullscope("visibility", "--image", "a.fits", "--radial", "45", "5", "--points", "3", "-o", "v")
        for here, there in zip(of_scene, self.rows()):
            self.assertEqual(here.keys(), there.keys())
            for plane in "quv":
                for part in "real", "imaginary":
                    name = f"stokes_{plane}_{part}_jy"
                    self.assertLess(abs(here[name] - there[name]), 1e-6 * of_scene[0]["amplitude_jy"])
        self.assertGreater(abs(of_scene[0]["stokes_q_real_jy"]), 1e-6 * of_scene[0]["amplitude_jy"])

    def test_what_cannot_be_is_refused(self):
        self.write("a.fits", self.sky(8))
        self.write("bad.csv", "station,x_m,y_m,z_m,sefd_jy\nA,6371000,0,0,1\nB,0,6371,0,1\n")
        self.write("uv.csv", "u,v\n1,2\n3,four\n")
        self.write("of.csv", "u,v,frequency_ghz\n1,2,345\n")
        turned = write_fits([[1.0]], [*sky_cards(1), "CROTA2  =                 10.0"])
        self.write("turned.fits", turned), self.write("plain.fits", write_fits([[1.0]], [])), self.write("dark.fits", write_fits([[0.0]], sky_cards(1)))
        image = ("--image", "a.fits")
        for words, says in (((*image, "--array", "bad.csv"), ["bad.csv:3: x_m", "6371 m"]), ((*image, "--baselines", "uv.csv"), ["uv.csv:3: v", "four"]),
                            ((*image, "--baselines", "of.csv"), ["of.csv:2: frequency_ghz", "230"]), ((*image, "--baselines", "none.csv"), ["none.csv"]),
                            ((*image, "--array", "eht-2071"), ["eht-2071", "eht-2017, eht-2017-space"]), (image, ["--radial ANGLE MAX"]),
                            ((*image, "--radial", "0", "1", "--array", "eht-2017"), ["one of"]), ((*image, "--radial", "0", "many"), ["--radial 0 many"]),
                            ((*image, "--radial", "0", "1", "--noise", "3"), ["--array"]), ((*image, "--radial", "0", "1", "--frequency", "345"), ["--frequency 345", "230"]),
                            ((*image, "--array", "eht-2017", "--hours", "3", "2", "1"), ["--hours", "2 is before 3"]),
                            ((*image, "--array", "eht-2017", "--elevation", "89"), ["no two stations"]), (("m87", *image, "--radial", "0", "1"), ["one of both"]),
                            ((*image, "--radial", "0", "1", "--size", "8x8"), ["--size", "--image"]), (("kerr", "--radial", "0", "1"), ["scale on the sky"]), (("--image", "turned.fits", "--radial", "0", "1"), ["turned.fits: CROTA2"]),
                            (("--image", "plain.fits", "--radial", "0", "1"), ["plain.fits: CDELT1"]), (("--image", "dark.fits", "--radial", "0", "1"), ["dark.fits", "above 0"])):
            with self.subTest(words):
                self.refused("visibility", *words, says=says)


if __name__ == "__main__":
    support.main()
