#!/usr/bin/env python3
"""FITS files and profiles: the light of the EXR, and the scale that theory gives the shadow of M87* and Sgr A*."""
import cmath
import csv
import math
import re
import struct

import support

RING = '[camera]\nr = 1e4\ntheta = 90\nfov = 0.06\nsize = [320, 320]\n[sky]\nkind = "plain"\ncolour = [1, 1, 1]\n[object]\nname = "%s"\n'
FLOW = """[spacetime]
metric = "kerr"
spin = 0.9
[camera]
r = 500
theta = 60
fov = 1.71873
size = [64, 64]
[sky]
kind = "black"
[object]
mass_suns = 4063320
distance_pc = 7777.8
[medium]
kind = "flow"
flattening = 3.3333333333333335
"""
# GM/(c^2 D) in microarcseconds: the numbers of docs/scenes.md, computed apart with G M_sun = 1.3271244e20 m^3/s^2.
KNOWN = {"m87": ("M87*", 3.818993252351, 6.5e9, 16.8e6), "sgr-a": ("Sgr A*", 5.124331470710, 4.297e6, 8277.0)}
SHADOW_M = 2 * math.sqrt(27)     # its diameter, in GM/c^2
# 320 px with 8 x 8 rays each: 2561 rays across, and some 6,500 along an edge of which half are off by chance. Measured: see docs/fits.md.
EDGE = 1e-4


def read_parts(data):
    """Of each part of a file of one picture: cards (keyword -> value) and planes of rows, from the top."""
    parts, at = [], 0
    while at < len(data):
        cards = {}
        while not data[at:at + 80].startswith(b"END "):
            card = data[at:at + 80].decode("ascii")
            if card[8:10] == "= ":
                text = re.match(r"'((?:[^']|'')*)'", card[10:])
                value = card[10:].split("/")[0].strip()
                cards[card[:8].strip()] = text.group(1).replace("''", "'").strip() if text else \
                    value == "T" if value in "TF" else float(value) if re.search("[.E]", value) else int(value)
            at += 80
        at = -(-(at + 80) // 2880) * 2880
        width, height, planes = cards["NAXIS1"], cards["NAXIS2"], cards.get("NAXIS3", 1)
        values = struct.unpack_from(f">{width * height * planes}f", data, at)
        parts.append((cards, [[values[(plane * height + y) * width:][:width] for y in reversed(range(height))] for plane in range(planes)]))
        at += -(-4 * width * height * planes // 2880) * 2880
    return parts


def read_fits(data):
    return read_parts(data)[0]


def checksum(data):
    """Of 32-bit words by ones' complement, which is -0 of every part (FITS Standard 4.0, appendix J)."""
    total = sum(struct.unpack(f">{len(data) // 4}I", data))
    while total >> 32:
        total = (total & 0xffffffff) + (total >> 32)
    return total


def table(path):
    with open(path, encoding="utf-8") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(line for line in file if line[0] != "#")]


class Fits(support.CliTest):
    def fits(self, scene, *options, name="a.fits"):
        self.run_nullscope("capture", scene, "-o", name, *options)
        self.data = (self.folder / name).read_bytes()
        self.assertEqual(checksum(self.data), 0xffffffff)
        parts = read_parts(self.data)
        self.colours = {cards["EXTNAME"]: planes[0] for cards, planes in parts[1:]}
        return parts[0]

    def test_the_light_is_the_exr_s(self):
        cards, planes = self.fits("m87", "--size", "64x36")
        self.run_nullscope("capture", "m87", "--size", "64x36", "-o", "a.exr")
        exr = support.read_exr((self.folder / "a.exr").read_bytes())
        self.assertEqual((cards["BITPIX"], cards["NAXIS"], cards["BUNIT"]), (-32, 2, ""))
        luminance = [[0.2126 * r + 0.7152 * g + 0.0722 * b for r, g, b in zip(*rows)] for rows in zip(exr["R"], exr["G"], exr["B"])]
        for row, meant in zip(planes[0], luminance):
            for value, light in zip(row, meant):
                self.assertAlmostEqual(value, light, delta=1e-6 * (1 + light))
        for name, channel in {"RED": "R", "GREEN": "G", "BLUE": "B"}.items():
            plane = self.colours[name]
            flux, meant = (sum(map(math.fsum, rows)) for rows in (plane, exr[channel]))
            self.assertGreater(meant, 0)
            self.assertLess(abs(flux / meant - 1), 1e-6)
            self.assertEqual([tuple(row) for row in plane], [tuple(row) for row in exr[channel]], "rows in their order")

    def test_stokes_planes_of_matter_are_in_jansky(self):
        cards, planes = self.fits("m87-polarimetry", "--size", "48x27")
        said = self.run_nullscope("capture", "m87-polarimetry", "--size", "48x27", "-o", "a.exr").out
        exr = support.read_exr((self.folder / "a.exr").read_bytes())
        self.assertEqual((cards["BUNIT"], cards["NAXIS3"]), ("Jy/pixel", 4))
        flux = [sum(map(math.fsum, plane)) for plane in planes]
        told = float(re.search(r"([\d.]+) Jy at 230 GHz", said).group(1))
        self.assertLess(abs(flux[0] / told - 1), 1e-3, "four digits are printed")
        light = sum(map(math.fsum, exr["stokes.I"]))
        for value, channel, sign in zip(flux, "IQUV", (1, -1, -1, 1)):
            self.assertLess(abs(value / flux[0] - sign * sum(map(math.fsum, exr["stokes." + channel])) / light), 1e-6)
        self.assertIn(f"circular {100 * flux[3] / flux[0]:.3g} % net", said)

    def test_stokes_planes_are_the_exr_s_from_north_through_east(self):
        cards, planes = self.fits("m87-swirl", "--size", "64x36")
        said = self.run_nullscope("capture", "m87-swirl", "--size", "64x36", "-o", "a.exr").out
        exr = support.read_exr((self.folder / "a.exr").read_bytes())
        self.assertEqual((cards["NAXIS3"], cards["CTYPE3"], cards["CRVAL3"], cards["CDELT3"], cards["CRPIX3"]), (4, "STOKES", 1, 1, 1))
        for plane, channel, sign in zip(planes, "IQUV", (1, -1, -1, 1)):   # a position angle is an angle from the picture's right less a quarter turn
            self.assertEqual([tuple(row) for row in plane], [tuple(sign * value for value in row) for row in exr["stokes." + channel]])
        # beta_2, by the header's coordinates: angles from north (up) through east (left).
        light, net, second, resolved = 0.0, 0j, 0j, 0.0
        for y, rows in enumerate(zip(*planes[:3])):
            for x, (i, q, u) in enumerate(zip(*rows)):
                east = (x + 1 - cards["CRPIX1"]) * cards["CDELT1"]
                north = (36 - y - cards["CRPIX2"]) * cards["CDELT2"]
                linear = complex(q, u)
                light, net, resolved = light + i, net + linear, resolved + abs(linear)
                second += linear * cmath.exp(-2j * math.atan2(east, north))
        found = re.search(r"polarised ([\d.e-]+) % net, ([\d.e-]+) % resolved, beta_2 ([\d.e-]+) at (-?[\d.]+) deg", said)
        told = [float(number) for number in found.groups()]
        for value, meant in zip(told, (100 * abs(net) / light, 100 * resolved / light, abs(second) / light, math.degrees(cmath.phase(second)))):
            self.assertAlmostEqual(value, meant, delta=6e-3 * abs(meant))
        self.assertTrue(-163 < told[3] < -129, told)   # as of M87* in 2017; its mirror image is positive

    def test_flux_of_a_known_flow(self):
        # Test 3 of docs/matter.md: 30 M by 30 M at 1000 M, GM/c^2 = 6e11 cm, 2.4e22 cm away.
        scene = self.write("flow.toml", FLOW)
        cards, planes = self.fits(scene)
        self.assertEqual((cards["NAXIS"], cards["BUNIT"], cards["FREQ"], len(planes)), (2, "Jy/pixel", 230e9, 1))
        flux = sum(map(math.fsum, planes[0]))
        self.assertLess(abs(flux / 0.4418 - 1), 0.02)
        said = self.run_nullscope("capture", scene, "-o", "a.exr").out
        self.assertAlmostEqual(float(re.search(r"([\d.]+) Jy at 230 GHz", said).group(1)), flux, delta=1e-4 * flux)
        # Other light has other units.
        cards, planes = self.fits(self.write("lit.toml", FLOW.replace('"black"', '"plain"')))
        self.assertEqual((cards["BUNIT"], len(planes), len(self.colours)), ("", 1, 3))

    def test_scale_and_shadow_of_what_is_known(self):
        for key, (name, m_uas, mass, distance) in KNOWN.items():
            cards, planes = self.fits(self.write("ring.toml", RING % key), "--samples", "8")
            self.assertEqual((cards["OBJECT"], cards["MASS"], cards["DISTANCE"], cards["METRIC"], cards["SPIN"]),
                             (name, mass, distance, "schwarzschild", 0))
            self.assertEqual((cards["CTYPE1"], cards["CTYPE2"], cards["CUNIT1"], cards["RADESYS"]), ("RA---TAN", "DEC--TAN", "deg", "ICRS"))
            self.assertEqual((cards["CRPIX1"], cards["CRPIX2"], cards["CAMERA_R"], cards["INCLINAT"]), (160.5, 160.5, 1e4, 90))
            # In GM/c^2, the radius over the lapse at the camera times the tangent of a pixel.
            pixel = 2 * math.tan(math.radians(0.03)) / 320 * 2e4 / math.sqrt(1 - 1e-4) * m_uas
            self.assertLess(abs(cards["CDELT2"] * 3.6e9 / pixel - 1), 1e-6)
            self.assertEqual(cards["CDELT1"], -cards["CDELT2"])
            self.assertLess(abs(cards["PIXELUAS"] / pixel - 1), 1e-6)
            self.assertLess(abs(cards["M_UAS"] / m_uas - 1), 1e-9)
            shadow = sum(1 - value for row in planes[0] for value in row)
            diameter = 2 * math.sqrt(shadow / math.pi) * cards["CDELT2"] * 3.6e9
            self.assertLess(abs(diameter / (SHADOW_M * m_uas) - 1), EDGE, f"{key}: {diameter} microarcseconds")

    def test_a_file_is_the_same_file_again(self):
        files = []
        for name in ("a.fits", "b.fits"):
            self.fits("flat", "--size", "48x27", name=name)
            files.append((self.folder / name).read_bytes())
        self.assertEqual(*files)
        self.assertEqual(len(files[0]) % 2880, 0)

    def test_where_the_hole_is_and_which_way_is_up(self):
        """A camera that looks up and to the right of the hole has it below and to the left."""
        turned = RING % "m87" + "[picture]\nrefine = \"off\"\n"
        turned = turned.replace("fov = 0.06", "fov = 0.06\nyaw = 0.005\npitch = 0.01")
        cards, planes = self.fits(self.write("turned.toml", turned))
        dark = [(x, y) for y, row in enumerate(planes[0]) for x, value in enumerate(row) if value < 0.5]
        column, row = (sum(place) / len(dark) + 0.5 for place in zip(*dark))
        self.assertLess(column, 140)
        self.assertGreater(row, 200)
        self.assertLess(math.hypot(cards["CRPIX1"] - 0.5 - column, 320 - (cards["CRPIX2"] - 0.5) - row), 0.1)

    def test_scenes_of_m87_are_bright_in_the_south(self):
        for scene in ("m87", "m87-synchrotron"):     # Event Horizon Telescope Collaboration 2019 (ApJL 875, L1)
            _, planes = self.fits(scene, "--size", "64x36")
            light, height = planes[0], 36     # rows from the top, which is north
            south, north = (sum(map(sum, light[rows])) for rows in (slice(height // 2, None), slice(None, height // 2)))
            west, east = (sum(sum(row[columns]) for row in light) for columns in (slice(32, None), slice(None, 32)))
            self.assertGreater(south, 1.3 * north, scene)
            self.assertLess(max(east, west) / min(east, west) - 1, south / north - 1, scene)

    def test_other_pictures_have_other_coordinates_or_none(self):
        cards, _ = self.fits("first-light", "--size", "64x36")     # no object
        self.assertEqual((cards["CTYPE1"], cards["CTYPE2"], cards["OBJECT"]), ("CALN-TAN", "CALT-TAN", "First light"))
        self.assertNotIn("MASS", cards)
        self.assertGreater(cards["CDELT1"], 0)
        near = self.write("near.toml", (RING % "m87").replace("1e4", "10.0"))
        cards, _ = self.fits(near, "--size", "32x32")
        self.assertEqual((cards["CTYPE1"], cards["MASS"]), ("CALN-TAN", 6.5e9))
        self.assertLess(abs(cards["CDELT1"] / (2 * math.degrees(math.tan(math.radians(0.03))) / 32) - 1), 1e-9)
        for scene, *options in (("dome",), ("two-spacetimes",), ("m87", "--split", "flat")):
            cards, _ = self.fits(scene, "--size", "64x64", *options)
            self.assertNotIn("CTYPE1", cards, scene)
        cards, _ = self.fits("gargantua", "--size", "32x18", "--renderer", "reference", "--samples", "1")
        self.assertEqual((cards["METRIC"], cards["RENDERER"]), ("kerr", "reference tracer"))

    def test_frames_of_a_sequence(self):
        self.run_nullscope("capture", "kerr-plunge", "--size", "32x18", "--frames", "3:5", "-o", "f%d.fits")
        cards, _ = read_fits((self.folder / "f4.fits").read_bytes())
        self.assertEqual((cards["FRAME"], cards["SCENE"]), (4, "Kerr plunge"))


class Profiles(support.CliTest):
    def test_a_cut_through_the_shadow_is_as_long_as_theory_says(self):
        scene = self.write("ring.toml", RING % "sgr-a")
        said = self.run_nullscope("profile", scene, "-o", "cut", "--samples", "4").out
        self.assertIn("320 points along 320 px", said)
        rows = table(self.folder / "cut.csv")
        self.assertEqual(list(rows[0]), ["x", "y", "px", "M", "uas", "luminance", "red", "green", "blue"])
        step = rows[1]["M"] - rows[0]["M"]
        dark = sum(1 - row["luminance"] for row in rows) * step
        self.assertLess(abs(dark - SHADOW_M), 0.5 * step)     # either edge to a quarter of a px
        for row in rows[::37]:
            self.assertLess(abs(row["uas"] - KNOWN["sgr-a"][1] * row["M"]), 1e-6)
        self.assertIn("along the line, µas", (self.folder / "cut.svg").read_text(encoding="utf-8"))

    def test_values_are_the_picture_s(self):
        size = ("--size", "64x36")
        self.run_nullscope("capture", "first-light", *size, "-o", "a.exr")
        exr = support.read_exr((self.folder / "a.exr").read_bytes())
        self.run_nullscope("profile", "first-light", *size, "--through", "3.5,10.5", "-o", "row")
        rows = table(self.folder / "row.csv")
        self.assertEqual([row["x"] for row in rows], [x + 0.5 for x in range(64)])
        for row, (red, blue) in zip(rows, zip(exr["R"][10], exr["B"][10])):
            self.assertAlmostEqual(row["red"], red, delta=1e-6 * (1 + red))
            self.assertAlmostEqual(row["blue"], blue, delta=1e-6 * (1 + blue))
        self.run_nullscope("profile", "first-light", *size, "--angle", "90", "--through", "20.5,3.5", "-o", "column")
        rows = table(self.folder / "column.csv")
        self.assertEqual([round(row["y"], 9) for row in rows], [y + 0.5 for y in reversed(range(36))])   # upward
        for row, green in zip(rows, [line[20] for line in reversed(exr["G"])]):
            self.assertAlmostEqual(row["green"], green, delta=1e-6 * (1 + green))

    def test_q_and_u_are_those_of_the_picture_s_layers(self):
        size = ("--size", "64x36")
        self.run_nullscope("capture", "m87-swirl", *size, "-o", "a.exr")
        exr = support.read_exr((self.folder / "a.exr").read_bytes())
        self.run_nullscope("profile", "m87-swirl", *size, "--through", "3.5,10.5", "-o", "row")
        rows = table(self.folder / "row.csv")
        self.assertEqual(list(rows[0])[-2:], ["stokes_q", "stokes_u"])
        for x, row in enumerate(rows):
            self.assertAlmostEqual(row["stokes_q"], exr["stokes.Q"][10][x], delta=1e-6)
            self.assertAlmostEqual(row["stokes_u"], exr["stokes.U"][10][x], delta=1e-6)
        self.assertGreater(max(math.hypot(row["stokes_q"], row["stokes_u"]) for row in rows), 1e-3)
        # The reference's pictures are of light alone.
        self.run_nullscope("profile", "m87-swirl", "--size", "16x9", "--renderer", "reference", "--samples", "1", "-o", "exact")
        self.assertNotIn("stokes_q", table(self.folder / "exact.csv")[0])

    def test_between_four_pixels_is_their_mean(self):
        size = ("--size", "16x9")
        scene = self.write("slope.toml", '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "formula"\nformula = "0.5 + 0.4 * y + 0.3 * z * z"\n')
        self.run_nullscope("capture", scene, *size, "-o", "a.exr")
        red = support.read_exr((self.folder / "a.exr").read_bytes())["R"]
        self.run_nullscope("profile", scene, *size, "--angle", "45", "--through", "8,5.3", "--steps", "7", "-o", "slant")
        rows = table(self.folder / "slant.csv")
        for row in rows[1:-1]:     # linear between the centres of four pixels
            x, y = row["x"] - 0.5, row["y"] - 0.5
            i, j, u, v = int(x), int(y), x % 1, y % 1
            meant = (1 - v) * ((1 - u) * red[j][i] + u * red[j][i + 1]) + v * ((1 - u) * red[j + 1][i] + u * red[j + 1][i + 1])
            self.assertAlmostEqual(row["red"], meant, delta=1e-6)
        self.assertGreater(max(row["red"] for row in rows) - min(row["red"] for row in rows), 0.01)

    def test_the_reference_draws_the_same_line(self):
        scene = self.write("ring.toml", RING % "m87")
        lines = ["--size", "80x80", "--angle", "30", "--through", "41.5,33.5", "--samples", "4"]
        self.run_nullscope("profile", scene, *lines, "-o", "gl")
        self.run_nullscope("profile", scene, *lines, "-o", "exact", "--renderer", "reference")
        one, other = table(self.folder / "gl.csv"), table(self.folder / "exact.csv")
        self.assertEqual([(row["x"], row["M"]) for row in one], [(row["x"], row["M"]) for row in other])
        self.assertGreater(max(row["red"] for row in one) - min(row["red"] for row in one), 0.9)
        for a, b in zip(one, other):
            self.assertLess(abs(a["red"] - b["red"]), 1.5 / 16)     # a ray of 4 x 4 next to the edge

    def test_a_picture_without_a_scale_has_px_alone(self):
        self.run_nullscope("profile", "wormhole", "--size", "32x18", "-o", "cut")
        self.assertEqual(list(table(self.folder / "cut.csv")[0]), ["x", "y", "px", "luminance", "red", "green", "blue"])
        self.assertIn("along the line, px", (self.folder / "cut.svg").read_text(encoding="utf-8"))


class PolarisedCurve(support.CliTest):
    SPOT = """[camera]
r = 100
theta = %s
fov = 8
size = [96, 96]
[sky]
kind = "black"
[disc]
inner = 3
outer = 6
emission = "thermal"
opacity = 0.0
brightness = 0.0
polarisation = "synchrotron"
field = "toroidal"
polarised_fraction = 0.5
[spot]
r = 4.5
size = 0.3
"""

    def test_a_spot_seen_face_on_goes_round_the_loop_of_q_and_u_twice(self):
        # The electric vector is along the radius, whose azimuth grows as seen from above and falls as seen from below.
        for theta, turns in ((0, 2), (180, -2)):
            said = self.run_nullscope("lightcurve", self.write("spot.toml", self.SPOT % theta), "--steps", "17", "-o", "spot").out
            self.assertIn(f"turns 2 times {'counterclockwise' if turns > 0 else 'clockwise'}\n", said)
            curve = table(self.folder / "spot.csv")
            linear = [complex(row["stokes_q"], row["stokes_u"]) / row["flux"] for row in curve]
            for value in linear:
                self.assertAlmostEqual(abs(value), 0.375, delta=2e-2)   # 0.5 (alpha + 1)/(alpha + 5/3), less what the spot's size takes
            turned = sum(cmath.phase(after / before) for before, after in zip(linear, linear[1:]))
            self.assertAlmostEqual(turned / (2 * math.pi), turns, delta=2e-2)
            # Its axes are equal, and it is closed.
            svg = (self.folder / "spot.svg").read_text(encoding="utf-8")
            self.assertIn("Q and U, % of the mean I", svg)
            loop = re.findall("<polyline[^>]* points=\"([^\"]*)\"", svg)[1].split()
            xs, ys = ([float(point.split(",")[i]) for point in loop] for i in (0, 1))
            self.assertEqual(len(loop), 17)
            self.assertLess(math.hypot(xs[0] - xs[-1], ys[0] - ys[-1]), 4)
            self.assertAlmostEqual((max(xs) - min(xs)) / (max(ys) - min(ys)), 1, delta=3e-2)

    def test_half_an_orbit_is_no_closed_loop(self):
        said = self.run_nullscope("lightcurve", self.write("spot.toml", self.SPOT % 40), "--steps", "9", "--to", "30", "--size", "32x32", "-o", "half").out
        self.assertIn("Q and U end elsewhere than they begin\n", said)


class PolarisedLine(support.CliTest):
    DISC = """[spacetime]
metric = "kerr"
spin = 0.7
[camera]
theta = %s
[disc]
inner = 3
outer = 6
emission = "thermal"
polarisation = "synchrotron"
field = "vector"
field_vector = [0.6, -0.5, 0.4]
"""

    def test_q_and_u_by_energy_are_sums_over_the_image_from_above_and_below(self):
        """Of rays that are traced one by one, on a grid that is fine along both rims."""
        radii, angles, bins = 90, 60, 4
        low, high = math.log(2), math.log(8.5)
        places = [(math.exp(low + (i + 0.5) / radii * (high - low)), 2 * math.pi * (j + 0.5) / angles) for i in range(radii) for j in range(angles)]
        for theta in (55, 125):
            scene = self.write("disc.toml", self.DISC % theta)
            self.write("rays.csv", "alpha,beta,theta\n" + "".join(
                f"{rho * math.cos(chi)!r},{rho * math.sin(chi)!r},{math.radians(theta)!r}\n" for rho, chi in places))
            self.run_nullscope("trace", scene, "--rays", "rays.csv", "--with", "core64", "--crossings", "1", "-o", "traced.csv")
            said = self.run_nullscope("spectrum", scene, "--bins", bins, "--from", "0.5", "--to", "1.3", "-o", "line").out
            rows = table(self.folder / "line.csv")
            self.assertEqual(list(rows[0]), ["g_from", "g_to", "g", "photons", "energy", "stokes_q", "stokes_u", "fraction", "angle_deg"])
            photons, linear = [0.0] * bins, [0j] * bins
            with open(self.folder / "traced.csv", encoding="utf-8") as file:
                for (rho, _), ray in zip(places, csv.DictReader(file)):
                    if not ray["r_1"] or not 3 <= float(ray["r_1"]) <= 6:
                        continue
                    g, light = float(ray["g_1"]), float(ray["g_1"]) ** 3 * float(ray["r_1"]) ** -3 * rho ** 2
                    photons[int((g - 0.5) / 0.8 * bins)] += light
                    linear[int((g - 0.5) / 0.8 * bins)] += light * float(ray["p_1"]) * cmath.exp(2j * float(ray["chi_1"]))
            for row, part, value in zip(rows, photons, linear):
                self.assertAlmostEqual(row["photons"], part / sum(photons), delta=0.01)
                self.assertAlmostEqual(complex(row["stokes_q"], row["stokes_u"]), value / sum(photons), delta=0.01)
                self.assertAlmostEqual(row["fraction"] * cmath.exp(2j * math.radians(row["angle_deg"])) * row["photons"],
                                       complex(row["stokes_q"], row["stokes_u"]), delta=1e-6)
            self.assertGreater(max(abs(complex(row["stokes_q"], row["stokes_u"])) for row in rows), 0.05)
            net = float(re.search(r"polarised ([\d.]+) % of all photons", said).group(1))
            self.assertAlmostEqual(net, 100 * abs(sum(linear)) / sum(photons), delta=1)


class Ticks(support.CliTest):
    def test_ticks_are_over_displayed_pictures_that_are_not_plain(self):
        text = self.run_nullscope("scenes", "m87-swirl").out.replace('scale_bar = "uas"\n', "")
        self.run_nullscope("capture", self.write("on.toml", text), "--size", "160x90", "-o", "on.png")
        self.run_nullscope("capture", "on.toml", "--plain", "--size", "160x90", "-o", "plain.png")
        self.run_nullscope("capture", self.write("off.toml", text.replace('ticks = "on"', 'ticks = "off"')), "--size", "160x90", "-o", "off.png")
        for name, largest in (("plain.png", 0), ("on.png", 255)):
            said = self.run_nullscope("compare", "off.png", name).out
            self.assertEqual(float(re.search(r"max ([\d.e-]+)", said).group(1)) > 0.1, largest > 0, said)


if __name__ == "__main__":
    support.main()
