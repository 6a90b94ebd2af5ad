#!/usr/bin/env python3
"""nullscope trace: the reference against 50-digit vectors; core64, core32 and gl against the reference."""
import csv
import io
import json
import math
import os
import pathlib
import random

import support

Q_CRITICAL = 2 / (3 * math.sqrt(3))
COLUMNS = ["fate", "theta_inf", "phi_inf", "angle", "delay", "g", "turn", "at"]
# What is measured is how far the camera ray would have to turn for the answer to be exact (the screen error): an error
# in the sky of c max(1, d phi / d alpha) rad. A pixel of a 4K picture is 2.7e-4 rad.
# Table entries are floats (6e-8 of an angle of a few rad), the strip's straight lines leave 6e-7 at most, the
# arctangent 1.3e-8. Measured over 4000 random rays: 4.7e-7, in float and on Mesa's llvmpipe 8.4e-7
# (NULLSCOPE_PRINT_ERRORS=1 prints it for the rays of this file). The margin is for other drivers.
SCREEN_RAD = {"core64": 8e-7, "core32": 1.2e-6, "gl": 1.2e-6}
# A ray this close to the critical direction may end on either side: the arctangent's error and rounding.
FRONTIER_RAD = {"core64": 5e-8, "core32": 3e-7, "gl": 3e-7}
# Where a ray's plane meets the equator is geometry in floats; near the poles azimuths magnify it.
AZIMUTH_RAD = 2e-6
# Of rays about a rotating hole from 500 r_s (docs/ray-data.md, which tracer to take): measured 5.3e-7 in the median, 7.5e-6 at most of r,
# the step's truncation.
# rad, and of a crossing's radius: Boyer and Lindquist's azimuth winds up by a/Delta dr next to the horizon.
SPIN_AZIMUTH, SPIN_R = 1e-5, 2.5e-6
FAR_KERR, FAR_KERR_MOST = 1e-6, 1.5e-5
# Of g at a disc: u^t and the photon's constants are double, the crossing's radius and how fast the ray climbs there are floats.
SHIFT = 5e-6
# What is promised of T: relative, or in r_s/c, whichever is larger, and what the direction's last bit moves it.
DELAY, DELAY_LEAST = 2e-6, 1e-5
# The reference prints 17 digits and is good to 1e-14 (tests/unit/test_reference_vectors.cpp).
REFERENCE = 3e-14


def number(text):
    return float(text) if text else math.nan


def read_csv(text):
    return list(csv.DictReader(line for line in io.StringIO(text) if not line.startswith("#")))


def write_csv(rows, columns):
    lines = [",".join(map(str, row)) for row in rows]   # str of a float names that float
    return "\n".join([",".join(columns)] + lines) + "\n"


class Vectors:
    """A file of vectors as the shader's witnesses are given it: what its scene is, and sqrt(V) at the camera."""

    def __init__(self, file, scene, q_critical, root_v, place="zeta0"):
        self.file, self.scene, self.q_critical, self.root_v, self.place = file, scene, q_critical, root_v, place

    def text(self):
        text = (support.VECTORS / self.file).read_text().replace(",phi_a,", ",at_angle,")
        if self.place == "zeta0":
            return text
        rows = [(r["id"], r["group"], 1 / number(r["h"]), r["l0"], -int(r["s"])) for r in read_csv(text)]   # s: towards the throat
        return write_csv(rows, ["id", "group", "q", self.place, "s"])

    def sine(self, row):
        return min(1.0, self.root_v(number(row[self.place])) / number(row["q"]))

    def has_static_camera(self, row):
        return self.place == "l0" or self.root_v(number(row["zeta0"])) > 0

    def radius(self, row):
        return number(row["l0"]) if self.place == "l0" else 1 / number(row["zeta0"])


HOLE = Vectors("schwarzschild.csv", None, Q_CRITICAL, lambda zeta: zeta * math.sqrt(max(1 - zeta, 0.0)))
EXTREMAL = Vectors("rn_extremal.csv", '[spacetime]\nmetric = "reissner-nordstrom"\ncharge = 1\n', 0.5, lambda zeta: zeta * max(1 - 0.5 * zeta, 0.0))
THROAT = Vectors("ellis.csv", '[spacetime]\nmetric = "ellis"\n', 1.0, lambda l: 1 / math.hypot(l, 1), "l0")


def direction(row):
    theta, phi = number(row["theta_inf"]), number(row["phi_inf"])
    return [math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)]


def angle_between(a, b):
    chord = math.dist(a, b)
    return 2 * math.asin(min(1.0, chord / 2))


class TraceTest(support.CliTest):
    def trace(self, text, *options, scene="sky-only", status=0):
        ran = self.run_nullscope("trace", scene, "--rays", self.write("rays.csv", text), *options, status=status)
        return read_csv(ran.out)

    def tracers(self):
        self.contexts()
        return list(SCREEN_RAD)


class Reference(TraceTest):
    @support.costly
    def test_vectors(self):
        text = (support.VECTORS / "schwarzschild.csv").read_text().replace(",phi_a,", ",at_angle,")
        given = read_csv(text)
        found = self.trace(text)
        self.assertEqual([r["id"] for r in found], [r["id"] for r in given], "rows keep their order")
        fates = {"0": "escaped", "1": "captured"}
        for row, vector in zip(found, given):
            self.assertEqual(row["fate"], fates.get(vector["status"], "no_sky"), vector["id"])
            self.assertEqual({k: row[k] for k in vector}, vector, "input columns pass through unchanged")
            for column, exact in (("angle", "phi"), ("delay", "T"), ("turn", "zeta_turn")):
                self.assertEqual(row[column] == "", vector[exact] == "", (vector["id"], column))
                if vector[exact]:
                    error = abs(number(row[column]) - number(vector[exact]))
                    self.assertLessEqual(error, REFERENCE * abs(number(vector[exact])), (vector["id"], column))
            self.assertEqual(row["at"] == "", vector["zeta_a"] == "", vector["id"])

    def test_directions_and_crossings(self):
        rays = "r,theta,phi,n_r,n_theta,n_phi,note\n" \
               "10,1.5707963267948966,0.3,1,0,0,outward\n" \
               "10,1.0471975511965976,0.5,-1,0.2,0,over the south\n" \
               "10,1.0471975511965976,0.5,-1,0,0.2,with windings\n" \
               "10,1.0471975511965976,-9,-3,0,-0.6,scaled\n"
        rows = self.trace(rays, "--crossings", "2")
        self.assertEqual(list(rows[0])[7:], COLUMNS + ["r_1", "phi_1", "r_2", "phi_2"])
        self.assertEqual((rows[0]["fate"], rows[0]["delay"], rows[0]["angle"]), ("escaped", "0", "0"))
        self.assertAlmostEqual(number(rows[0]["theta_inf"]), math.pi / 2, delta=1e-15)
        self.assertAlmostEqual(number(rows[0]["phi_inf"]), 0.3, delta=1e-15)
        self.assertAlmostEqual(number(rows[1]["phi_1"]), 0.5, delta=1e-12)
        for row in rows[2:]:
            swept = number(row["phi_inf"]) - number(row["phi"]) if row["fate"] == "escaped" else 0
            self.assertGreaterEqual(swept * (-1 if row["note"] == "scaled" else 1), 0)

    @support.costly
    def test_shift_of_the_discs_matter(self):
        rays = "r,theta,phi,n_r,n_theta,n_phi\n10,1.3,0,-1,0.15,0.3\n10,1.3,0,-1,0.1,-0.6\n10,1.3,0,-1,-0.4,0.15\n"
        for a in (0.0, 0.45):   # r_s
            scene = self.write("disc.toml", f'[spacetime]\nmetric = "kerr"\nspin = {2 * a}\n[disc]\nemission = "thermal"\n')
            sine, sigma, delta = math.sin(1.3), 100 + (a * math.cos(1.3)) ** 2, 90 + a * a
            area = (100 + a * a) ** 2 - delta * (a * sine) ** 2
            for row in self.trace(rays, "--crossings", "2", scene=scene):
                self.assertEqual([c for c in row if c[-2:] in ("_1", "_2")], ["r_1", "phi_1", "g_1", "r_2", "phi_2", "g_2"])
                look = [number(row[c]) for c in ("n_r", "n_theta", "n_phi")]
                l_z = -look[2] / math.hypot(*look) * math.sqrt(area / sigma) * sine * number(row["g"])
                r = number(row["r_1"])
                self.assertGreater(r, 3)
                root = math.sqrt(0.5 / r ** 3)
                g = number(row["g"]) * math.sqrt(1 - 1.5 / r + 2 * a * root) / (1 + a * root - root * l_z)
                self.assertAlmostEqual(number(row["g_1"]) / g, 1, delta=1e-11)
        bare = '[spacetime]\nmetric = "janis-newman-winicour"\n'
        without = self.write("no-discs.toml", bare)
        self.assertNotIn("g_1", self.trace(rays, "--crossings", "1", scene=without)[0])
        self.write("no-discs.toml", bare + '[disc]\nemission = "thermal"\n')
        self.refused("trace", without, "--rays", "rays.csv", says=["no-discs.toml:3", "disc", "neither discs nor bodies"])

    def test_forms_of_files(self):
        plain = "r,theta,phi,n_r,n_theta,n_phi\n20,1.2,0.1,-1,0.05,0.3\n"
        expected = self.trace(plain)[0]
        same = [
            plain.replace("\n", "\r\n"),
            "\ufeff# comment\n\n" + plain + "\n\n# end",
            'r,theta,phi,n_r,n_theta,n_phi\n"20",1.2 , 0.1,"-1",+0.05,3e-1',
            "n_phi,n_theta,n_r,phi,theta,r\n0.3,0.05,-1,0.1,1.2,20\n",
            "r,theta,phi,n_r,n_theta,n_phi,frame\n20,1.2,0.1,-1,0.05,0.3,static\n20,1.2,0.1,-1,0.05,0.3,\n",
            "note,r,theta,phi,n_r,n_theta,n_phi\n\"a, \"\"quoted\"\" note\",20,1.2,0.1,-1,0.05,0.3\n",
            "note,r,theta,phi,n_r,n_theta,n_phi\n" + "x" * 100000 + ",20,1.2,0.1,-1,0.05,0.3\n",
        ]
        for text in same:
            for row in self.trace(text):
                self.assertEqual({c: row[c] for c in COLUMNS}, {c: expected[c] for c in COLUMNS}, text[:100])
        self.assertEqual(self.trace("r,theta,phi,n_r,n_theta,n_phi\n"), [])
        self.assertGreaterEqual(len(expected["angle"].replace(".", "")), 16)

    def test_file_out(self):
        rays = "q,zeta0,s\n0.5,0.1,1\n"
        shown = self.run_nullscope("trace", "sky-only", "--rays", self.write("in.csv", rays)).out
        ran = self.run_nullscope("trace", "sky-only", "--rays", "in.csv", "-o", "out.csv")
        self.assertEqual((ran.out, (self.folder / "out.csv").read_text()), ("", shown))

    def test_rain_frame(self):
        # Looking straight out while falling from rest at infinity: E = 1 + sqrt(r_s/r) at unit frequency in the camera.
        header = "r,theta,phi,n_r,n_theta,n_phi,frame\n"
        rows = self.trace(header + "4,1,0,1,0,0,rain\n0.25,1,0,1,0,0,rain\n0.25,1,0,-1,0,0,rain\n")
        self.assertAlmostEqual(number(rows[0]["g"]), 1 / 1.5, delta=1e-15)
        self.assertEqual([r["fate"] for r in rows], ["escaped", "escaped", "no_sky"])


class ShaderText(TraceTest):
    def slopes(self, rows, vectors, scene):
        """max(1, |d phi / d alpha|) of rays in the reduced form: differences of the reference, the larger of two sides.
        alpha is the angle between view direction and radius: d alpha = -tan(alpha) d ln(q)."""
        by_q, by_alpha = [], []
        for row in rows:
            q, s = number(row["q"]), int(row["s"])
            sine = vectors.sine(row)
            cosine = math.sqrt(1 - sine * sine)
            for side in (1, -1):
                if cosine < 1e-3:   # at its turning point: q is no measure of direction
                    alpha = math.atan2(sine, -s * cosine) + side * 1e-6
                    by_alpha.append((row["id"], 1e-6, vectors.radius(row), math.pi / 2, 0, math.cos(alpha), 0, math.sin(alpha)))
                else:
                    room = min(1.0, abs(q / vectors.q_critical - 1), cosine * cosine)
                    step = max(1e-5 * room, 1e-15)
                    by_q.append((row["id"], step * sine / cosine, q * (1 + side * step), row[vectors.place], s))
        moved = self.trace(write_csv(by_q, ["id", "step", "q", vectors.place, "s"]), scene=scene)
        moved += self.trace(write_csv(by_alpha, ["id", "step", "r", "theta", "phi", "n_r", "n_theta", "n_phi"]), scene=scene)
        here = {row["id"]: row for row in rows}
        found = dict.fromkeys(here, 1.0)
        for there in moved:
            row = here[there["id"]]
            if there["fate"] == row["fate"]:
                slope = abs(number(there["angle"]) - number(row["angle"])) / number(there["step"])
                found[row["id"]] = max(found[row["id"]], slope)
        return found

    def judge_vectors(self, vectors):
        scene = self.write("vectors.toml", vectors.scene) if vectors.scene else "sky-only"
        text = vectors.text()
        reference = self.trace(text, scene=scene)
        outside = [row for row in reference if vectors.has_static_camera(row)]
        slopes = self.slopes(outside, vectors, scene)
        self.assertGreater(len(outside), 100)
        for tracer, *stage in (*zip(self.tracers()), ("gl", "--stage", "compute")):
            worst, flipped, inside, delays = 0.0, 0, 0, 0
            for row, exact in zip(self.trace(text, "--with", tracer, *stage, scene=scene), reference):
                name = (vectors.file, tracer, exact["id"], exact["group"])
                if exact["id"] not in slopes:   # on or inside the horizon: by the rain observer, whose rays all come from outside
                    self.assertEqual(number(exact["s"]), -1, name)
                    self.assertEqual(row["fate"], exact["fate"], name)
                    if row["fate"] == "escaped":
                        error = abs(number(row["angle"]) - number(exact["angle"])) / (1 + abs(number(exact["q"]) * number(exact["dphi_dq"])))
                        self.assertLessEqual(error, SCREEN_RAD[tracer], name)
                        worst, inside = max(worst, error), inside + 1
                elif row["fate"] != exact["fate"]:
                    sine = vectors.sine(exact)
                    distance = abs(number(exact["q"]) / vectors.q_critical - 1) * sine / max(math.sqrt(1 - sine * sine), 1e-300)
                    self.assertLess(distance, FRONTIER_RAD[tracer], name)
                    flipped += 1
                else:
                    error = abs(number(row["angle"]) - number(exact["angle"])) / slopes[exact["id"]]
                    self.assertLessEqual(error, SCREEN_RAD[tracer], name)
                    worst = max(worst, error)
                    if row["delay"]:   # next to the critical ray it grows as the angle over q_crit
                        late = number(exact["delay"])
                        allowed = max(DELAY * late, DELAY_LEAST) + SCREEN_RAD[tracer] * slopes[exact["id"]] / vectors.q_critical
                        self.assertLessEqual(abs(number(row["delay"]) - late), allowed, name)
                        delays += 1
            self.assertEqual(delays > 0, vectors is not THROAT)
            self.report(f"{vectors.file}, {' '.join((tracer, *stage))}: {len(slopes)} rays and {inside} on or inside the horizon: {worst:.3g} rad, {flipped} on the frontier")

    def test_vectors(self):
        self.judge_vectors(HOLE)

    @support.costly
    def test_vectors_of_the_extremal_hole(self):
        self.judge_vectors(EXTREMAL)

    def test_a_wormhole_is_traced_by_the_shader(self):
        """It has no discs, by which the shader finds crossings and places: these stay empty."""
        rays = self.write("rays.csv", "r,theta,phi,n_r,n_theta,n_phi,at_angle\n5,1.5,0,-1,0,0.1,0.5\n")
        for tracer in ("core64", "gl"):
            ran = self.run_nullscope("trace", "wormhole", "--rays", rays, "--with", tracer, "--crossings", "1")
            self.assertIn("other_side", ran.out)
            self.assertTrue(ran.out.endswith(",,,\n"), ran.out)
            self.assertEqual(ran.err.count("left empty"), 1, ran.err)

    def test_vectors_of_the_ellis_wormhole(self):
        self.judge_vectors(THROAT)

    def report(self, line):
        if os.environ.get("NULLSCOPE_PRINT_ERRORS"):
            print(line)

    def random_rays(self, count):
        """Rays from some radii, each with tables of its own, in both frames, and the same turned by `step` in their plane."""
        dice = random.Random(20151127)
        step, each = 1e-7, 6 if support.QUICK else 4     # rays a radius
        rays, turned = [], []
        for i in range(count):
            r = r if i % each else 1.02 * 10 ** dice.uniform(0, 2.5)
            theta, phi = math.acos(dice.uniform(-1, 1)), dice.uniform(-7, 7)
            alpha, turn = math.acos(dice.uniform(-1, 1)), dice.uniform(0, 2 * math.pi)
            rest = (("static", "rain", "")[i % 3], dice.uniform(0, 6.0), i)
            for angle, rows in ((alpha, rays), (alpha + step, turned)):
                across = math.sin(angle)
                n = (math.cos(angle), across * math.cos(turn), across * math.sin(turn))
                rows.append((r, theta, phi, *n, *rest))
        columns = ["r", "theta", "phi", "n_r", "n_theta", "n_phi", "frame", "at_angle", "i"]
        return write_csv(rays, columns), write_csv(turned, columns), step

    def screen_errors(self, row, exact, slope):
        """What differs, each as the angle by which the camera ray would have to turn."""
        yield "angle", abs(number(row["angle"]) - number(exact["angle"])) / slope
        if exact["fate"] == "escaped":
            yield "sky", angle_between(direction(row), direction(exact)) / slope
            azimuth = abs(number(row["phi_inf"]) - number(exact["phi_inf"]))   # a missing winding would be 2 pi
            yield "azimuth", azimuth * math.sin(number(exact["theta_inf"])) / slope
            yield "g", abs(number(row["g"]) / number(exact["g"]) - 1)
        if exact["at"]:
            yield "at", abs(number(row["at"]) - number(exact["at"])) / slope
        for r in ("r_1", "r_2"):
            if exact[r]:
                yield "crossing", abs(1 / number(row[r]) - 1 / number(exact[r])) / slope

    @support.costly
    def test_random_rays(self):
        text, turned, step = self.random_rays(90 if support.QUICK else 400)
        reference = self.trace(text, "--crossings", "2")
        beside = self.trace(turned)
        angles = [(number(a["angle"]), number(b["angle"])) for a, b in zip(reference, beside)]
        later = [abs(number(a["delay"]) - number(b["delay"])) / step if a["delay"] and b["delay"] else 0.0 for a, b in zip(reference, beside)]
        slopes = [max(1.0, abs(a - b) / step) for a, b in angles]
        for tracer in self.tracers():
            worst = {}
            for row, exact, slope, lag in zip(self.trace(text, "--crossings", "2", "--with", tracer), reference, slopes, later):
                name = (tracer, exact["i"])
                self.assertEqual((row["i"], row["fate"]), (exact["i"], exact["fate"]), name)
                self.assertEqual(row["turn"], "", name)
                for both in ("theta_inf", "phi_inf", "at", "r_1", "phi_1", "r_2", "phi_2"):
                    self.assertEqual(row[both] == "", exact[both] == "", (name, both))
                self.assertEqual(row["delay"] == "", exact["delay"] == "", name)
                if exact["delay"]:
                    late = number(exact["delay"])
                    allowed = max(DELAY * late, DELAY_LEAST) + SCREEN_RAD[tracer] * lag
                    self.assertLessEqual(abs(number(row["delay"]) - late), allowed, name)
                    worst["delay over what is allowed"] = max(worst.get("delay over what is allowed", 0.0), abs(number(row["delay"]) - late) / allowed)
                for what, error in self.screen_errors(row, exact, slope):
                    self.assertLessEqual(error, SCREEN_RAD[tracer], (name, what))
                    worst[what] = max(worst.get(what, 0.0), error)
                for phi in ("phi_1", "phi_2"):
                    if exact[phi]:
                        self.assertAlmostEqual(number(row[phi]), number(exact[phi]), delta=AZIMUTH_RAD, msg=name)
            self.report(f"{tracer}: random rays: " + ", ".join(f"{k} {v:.3g}" for k, v in worst.items()))

    def test_spins_of_either_sign(self):
        """Against the reference, with the disc's shift; and the other spin, turned, is the same to rounding."""
        dice = random.Random(55)
        rays, mirrored = [], []
        for i in range(300):
            r, theta, phi = 1.2 * 30 ** dice.random(), math.acos(dice.uniform(-0.99, 0.99)), dice.uniform(-3, 3)
            b, turn = dice.uniform(0, 4) / r, dice.uniform(0, 2 * math.pi)
            rays.append((r, theta, phi, -1, b * math.cos(turn), b * math.sin(turn), i))
            mirrored.append((r, theta, -phi, -1, b * math.cos(turn), -b * math.sin(turn), i))
        columns = ["r", "theta", "phi", "n_r", "n_theta", "n_phi", "i"]
        text, other_text = write_csv(rays, columns), write_csv(mirrored, columns)

        def scene(name, spin, charge, sense):
            return self.write(name, f'[spacetime]\nmetric = "kerr-newman"\nspin = {spin!r}\ncharge = {charge!r}\n[camera]\nobserver = "zamo"\n'
                                    f'[disc]\ninner = 3\nouter = 12\nopacity = 0.5\nemission = "thermal"\nsense = "{sense}"\n')

        for spin, charge, sense in ((-0.9, 0, "eastward"), (-0.5, 0.3, "westward"), (0.9, 0, "retrograde"), (-1.0, 0, "prograde"), (-0.6, 0.8, "eastward")):
            one = scene("one.toml", spin, charge, sense)
            other = scene("other.toml", -spin, charge, {"eastward": "westward", "westward": "eastward"}.get(sense, sense))
            exact = self.trace(text, "--crossings", "1", scene=one)
            self.assertGreater(sum(bool(row["g_1"]) for row in exact), 150)
            for tracer in ["reference", *self.tracers()]:
                drawn = self.trace(text, "--crossings", "1", "--with", tracer, scene=one)
                turned = self.trace(other_text, "--crossings", "1", "--with", tracer, scene=other)
                worst, skies = {}, []
                for row, right, across in zip(drawn, exact, turned):
                    name = (spin, charge, sense, tracer, row["i"])
                    self.assertEqual((row["fate"], row["fate"]), (right["fate"], across["fate"]), name)
                    if row["phi_inf"]:
                        self.assertAlmostEqual(number(row["phi_inf"]), -number(across["phi_inf"]), delta=1e-9, msg=name)
                        self.assertAlmostEqual(number(row["theta_inf"]), number(across["theta_inf"]), delta=1e-9, msg=name)
                        skies.append(angle_between(direction(row), direction(right)))
                    if row["g_1"] and number(row["r_1"]) > 1.3:
                        self.assertAlmostEqual(number(row["g_1"]) / number(across["g_1"]), 1, delta=1e-9, msg=name)
                        worst["g"] = max(worst.get("g", 0), abs(number(row["g_1"]) / number(right["g_1"]) - 1))
                        worst["r"] = max(worst.get("r", 0), abs(number(row["r_1"]) / number(right["r_1"]) - 1))
                self.report(f"{tracer}: a = {spin}, Q = {charge}, {sense}: " + ", ".join(f"{k} {v:.2g}" for k, v in worst.items()))
                skies.sort()    # the largest are those next to the critical curve, where the sky turns fast
                self.assertLess(skies[len(skies) // 2], FAR_KERR, (spin, tracer))
                self.assertLess(skies[9 * len(skies) // 10], 1e-4, (spin, tracer))
                self.assertLess(worst["r"], 5e-5, (spin, tracer))
                self.assertLess(worst["g"], 5e-5, (spin, tracer))

    @support.costly
    def test_a_rays_answer_is_its_own(self):
        """Rays of one list share tables and draws: each is what it is alone, to the bit."""
        dice = random.Random(64)
        kerr = self.write("kerr.toml", '[spacetime]\nmetric = "kerr"\nspin = 0.9\n[disc]\ninner = 3\nouter = 12\nemission = "thermal"\n')
        plane = self.write("plane.toml", '[disc]\ninner = 3\nouter = 12\nopacity = 0.5\n')
        body = self.write("body.toml", '[sphere]\nradius = 1.7\n[ball]\nposition = [0, 8, 4]\nradius = 3\n[camera]\nr = 1000\n')
        for scene, tracers in ((kerr, self.tracers()), (plane, self.tracers()), (body, ["gl"])):
            rays = []
            for i in range(300):    # of 12 places: three radii, polar angles and azimuths, in a wild order
                place = dice.choice([(r, theta, phi) for r in (9, 30) for theta in (0.4, 1.3, 2.0) for phi in (0.1, 4.0)])
                n = [-1 + dice.uniform(-0.2, 0.2)] + [dice.uniform(-0.5, 0.5) for _ in range(2)]
                rays.append((*place, *n, i))
            columns = ["r", "theta", "phi", "n_r", "n_theta", "n_phi", "i"]
            for tracer in tracers:
                ask = ("--with", tracer, "--crossings", "6")
                together = self.trace(write_csv(rays, columns), *ask, scene=scene)
                self.assertEqual([int(row["i"]) for row in together], list(range(300)))
                for i in (0, 17, 150, 299):
                    alone = self.trace(write_csv([rays[i]], columns), *ask, scene=scene)
                    self.assertEqual(alone, [together[i]], (tracer, scene, i))

    def test_shift_of_the_discs_matter(self):
        """g_k of the shader's tracers: the photon's constants and the matter's velocity, in double but for how fast the ray climbs."""
        dice = random.Random(9)
        rays = []
        for i in range(120):
            n = (-1, dice.uniform(-0.35, 0.35), dice.uniform(-0.35, 0.35))
            rays.append((dice.choice((12, 40)), dice.choice((0.5, 1.4)), dice.uniform(-3, 3), *n, i))
        text = write_csv(rays, ["r", "theta", "phi", "n_r", "n_theta", "n_phi", "i"])
        for space, light in (('', ''), ('metric = "kerr"\nspin = 0.9\n', ''), ('', 'doppler = "off"\n'),
                             ('', 'gravity = "off"\n')):
            scene = self.write("matter.toml", f'[spacetime]\n{space}[disc]\ninner = 3\nouter = 12\nopacity = 0.5\nemission = "thermal"\n[light]\n{light}')
            reference = self.trace(text, "--crossings", "2", scene=scene)
            self.assertGreater(sum(bool(row["g_1"]) for row in reference), 60)
            self.assertTrue(light or any(number(row["r_1"]) < 2 for row in reference), "some within the last stable orbit")
            for tracer in self.tracers():
                for row, exact in zip(self.trace(text, "--crossings", "2", "--with", tracer, scene=scene), reference):
                    for g, r in (("g_1", "r_1"), ("g_2", "r_2")):
                        name = (tracer, space, light, exact["i"], g)
                        self.assertEqual(row[g] == "", exact[g] == "", name)
                        # The second crossing's place moves fast with the direction, and next to the horizon so does g.
                        if exact[g] and g == "g_1" and number(exact["r_1"]) > 1.3:
                            self.assertAlmostEqual(number(row[g]) / number(exact[g]), 1, delta=SHIFT, msg=name)

    def test_crossings_of_discs_that_lean(self):
        dice = random.Random(4)
        rays = [(dice.choice((12, 40)), dice.choice((0.5, 1.4, 2.2)), dice.uniform(-3, 3), -1, dice.uniform(-0.35, 0.35), dice.uniform(-0.35, 0.35))
                for _ in range(120)]
        text = write_csv(rays, ["r", "theta", "phi", "n_r", "n_theta", "n_phi"])
        for space in ("", 'metric = "kerr"\nspin = -0.6\n'):
            for opacity in (0.5, 1):
                scene = self.write("leaning.toml", f'[spacetime]\n{space}[disc]\ninner = 4\nouter = 12\nopacity = {opacity}\nemission = "thermal"\ntilt = 40\nnode = 30\n')
                reference = self.trace(text, "--crossings", "2", scene=scene)
                for tracer in ("gl",) if space else self.tracers():
                    met, most = 0, 0.0
                    for row, exact in zip(self.trace(text, "--crossings", "2", "--with", tracer, scene=scene), reference):
                        self.assertEqual(row["fate"], exact["fate"])
                        # The second crossing's place moves fast with the direction.
                        if exact["r_1"] and number(exact["r_1"]) > 1.5:
                            met += 1
                            turned = math.remainder(number(row["phi_1"]) - number(exact["phi_1"]), 2 * math.pi)
                            self.assertLess(abs(number(row["r_1"]) / number(exact["r_1"]) - 1), 5e-5)
                            self.assertLess(abs(turned), 1e-5)
                            if number(exact["r_1"]) > 3:   # nearer than any disc may be, some of its matter would outrun light
                                most = max(most, abs(number(row["g_1"]) / number(exact["g_1"]) - 1))
                    self.report(f"{tracer}, {space or 'no spin'}, opacity {opacity}: {met} crossings of a leaning plane, g within {most:.1e}")
                    self.assertGreater(met, 80)
                    self.assertLess(most, SHIFT)

    def test_rays_that_wind(self):
        """More crossings than one draw lists, next to the critical direction."""
        critical, step, rays, moved = math.asin(1.5 * math.sqrt(3) / 20 * math.sqrt(1 - 1 / 20)), 1e-9, [], []
        for i, off in enumerate((1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7)):
            for side in (1, -1):
                for angle, rows in ((critical + side * off, rays), (critical + side * off + step, moved)):
                    rows.append((20, 1.0, 0.3, -math.cos(angle), math.sin(angle) * 0.6, math.sin(angle) * 0.8, i))
        columns = ["r", "theta", "phi", "n_r", "n_theta", "n_phi", "i"]
        text = write_csv(rays, columns)
        reference, beside = (self.trace(t, "--crossings", "8") for t in (text, write_csv(moved, columns)))
        self.assertGreaterEqual(max(sum(bool(row[f"r_{k}"]) for k in range(1, 9)) for row in reference), 6)
        for tracer in self.tracers():
            for row, exact, next_to in zip(self.trace(text, "--crossings", "8", "--with", tracer), reference, beside):
                self.assertEqual(row["fate"], exact["fate"])
                for k in range(1, 9):
                    name = (tracer, exact["i"], k)
                    self.assertEqual(row[f"r_{k}"] == "", exact[f"r_{k}"] == "", name)
                    if exact[f"r_{k}"]:
                        place, there = 1 / number(exact[f"r_{k}"]), 1 / number(next_to[f"r_{k}"])
                        slope = max(1.0, abs(there - place) / step)
                        self.assertLessEqual(abs(1 / number(row[f"r_{k}"]) - place) / slope, SCREEN_RAD[tracer], name)

    @support.costly
    def test_disc_stops_rays(self):
        text, _, _ = self.random_rays(100 if support.QUICK else 200)
        scene = self.write("disc.toml", "[disc]\ninner = 3\nouter = 12\n")
        reference = self.trace(text, scene=scene)
        self.assertGreater(sum(r["fate"] == "hit:disc" for r in reference), 10)
        self.assertFalse(any(r["theta_inf"] for r in reference if r["fate"] == "hit:disc"))
        for tracer in self.tracers():
            for row, exact in zip(self.trace(text, "--with", tracer, scene=scene), reference):
                self.assertEqual(row["fate"], exact["fate"], (tracer, exact["i"]))
                if exact["fate"] == "hit:disc":   # where the plane is met is geometry alone
                    self.assertAlmostEqual(number(row["angle"]), number(exact["angle"]), delta=AZIMUTH_RAD)

    def test_bodies_stop_rays(self):
        dice, rays = random.Random(5), []
        for i in range(400):     # from outside of all bodies, towards them
            alpha, turn = dice.uniform(0, 0.5), dice.uniform(0, 2 * math.pi)
            n = (-math.cos(alpha), math.sin(alpha) * math.cos(turn), math.sin(alpha) * math.sin(turn))
            rays.append((40, math.acos(dice.uniform(-1, 1)), dice.uniform(-7, 7), *n, i))
        text = write_csv(rays, ["r", "theta", "phi", "n_r", "n_theta", "n_phi", "i"])
        scene = self.write("bodies.toml", "[disc]\ninner = 14\nouter = 15\n[sphere]\nradius = 1.7\n[cylinder]\ninner = 4\nouter = 7\nheight = 0.3\n"
                           "[ball]\nposition = [0, 8, 4]\nradius = 3\n[surface]\nkind = \"torus\"\nsize = 11\nbound = 15\n[camera]\nr = 1000\n")
        reference = self.trace(text, "--crossings", "1", scene=scene)
        fates = {r["fate"] for r in reference}
        for body in ("sphere", "cylinder", "ball", "surface"):
            self.assertIn(f"hit:{body}", fates)
        self.assertFalse(any(r["theta_inf"] for r in reference if r["fate"].startswith("hit:")))
        for row, exact in zip(self.trace(text, "--crossings", "1", "--with", "gl", scene=scene), reference):
            self.assertEqual(row["fate"], exact["fate"], exact["i"])
            self.assertEqual(row["r_1"] == "", exact["r_1"] == "", exact["i"])
            if exact["fate"].startswith("hit:"):
                self.assertAlmostEqual(number(row["angle"]), number(exact["angle"]), delta=1e-3, msg=exact["i"])
        self.write("r.csv", text)
        self.refused("trace", scene, "--rays", "r.csv", "--with", "core64", says=["core64", "bodies", "gl"])

    def test_bodies_that_are_seen_at_once_stop_rays(self):
        """How long light takes is asked of every ray, and changes nothing of what is seen without it."""
        at = (8, 0, 0)   # of the ball now; along the orbit light from it would have left 30 r_s/c earlier
        eye = (30 * math.sin(1.1), 0, 30 * math.cos(1.1))
        rays = []
        for i in range(60):
            aim = [at[0] - eye[0], at[1] - eye[1] + 0.1 * (i % 10 - 5), at[2] - eye[2] + 0.3 * (i // 10)]
            # Outward, south, east at azimuth 0.
            rays.append((30, 1.1, 0, aim[0] * math.sin(1.1) + aim[2] * math.cos(1.1), aim[0] * math.cos(1.1) - aim[2] * math.sin(1.1), aim[1]))
        text = write_csv(rays, ["r", "theta", "phi", "n_r", "n_theta", "n_phi"])
        for metric in ("schwarzschild", "kerr"):
            scene = self.write("at-once.toml", f'[spacetime]\nmetric = "{metric}"\n[light]\ndelay = "off"\n[camera]\nr = 30\n'
                               "[ball]\nposition = [8, 0, 0]\nradius = 1.5\nmotion = \"orbit\"\n")
            fates = [[r["fate"] for r in self.trace(text, *words, scene=scene)] for words in ((), ("--with", "gl"))]
            self.assertEqual(*fates)
            self.assertGreater(fates[0].count("hit:ball"), 10)

    def test_flat_space(self):
        text, _, _ = self.random_rays(100)
        reference = self.trace(text, "--crossings", "1", scene="flat")
        for tracer in self.tracers():
            for row, exact in zip(self.trace(text, "--crossings", "1", "--with", tracer, scene="flat"), reference):
                self.assertEqual(row["fate"], "escaped")
                error = angle_between(direction(row), direction(exact))
                self.assertLess(error, SCREEN_RAD[tracer], (tracer, exact["i"]))
                self.assertEqual(row["r_1"] == "", exact["r_1"] == "", (tracer, exact["i"]))

    def test_radial_rays(self):
        rays = "r,theta,phi,n_r,n_theta,n_phi\n" + "".join(
            f"{r},{theta},1,{n},0,0\n"
            for r in (1.1, 10, 1e6) for theta in (0, 1, math.pi / 2, math.pi) for n in (1, -1))
        for tracer in ["reference"] + self.tracers():
            for row in self.trace(rays, "--with", tracer):
                out = row["n_r"] == "1"
                self.assertEqual(row["fate"], "escaped" if out else "captured", (tracer, row))
                self.assertLess(number(row["angle"]), 1e-6)
                if out:
                    self.assertAlmostEqual(number(row["theta_inf"]), number(row["theta"]), delta=1e-6)

    def test_about_a_spinning_hole(self):
        scene = self.write("kerr.toml", '[spacetime]\nmetric = "kerr"\nspin = 0.9\n')
        rays = "r,theta,phi,n_r,n_theta,n_phi\n10,1.3,0.2,-0.95,0.2,0.24\n10,1.3,0.2,-0.98,0.1,-0.3\n5,0.4,0.2,-0.9,0.4,0.1\n3,1.57,1,0.2,0.3,-0.7\n5,0,0.2,-0.9,0.4,0.1\n"
        exact = self.trace(rays, "--crossings", "2", scene=scene)
        self.assertEqual([r["fate"] for r in exact], ["escaped", "escaped", "captured", "escaped", "captured"])
        self.assertTrue(any(r["r_2"] for r in exact))
        for tracer in self.tracers():
            for row, right in zip(self.trace(rays, "--with", tracer, "--crossings", "2", scene=scene), exact):
                self.assertEqual((row["fate"], row["angle"]), (right["fate"], ""), tracer)
                for r, phi in (("r_1", "phi_1"), ("r_2", "phi_2")):
                    self.assertEqual(row[r] == "", right[r] == "", (tracer, r))
                    if right[r]:
                        self.assertAlmostEqual(number(row[r]) / number(right[r]), 1, delta=1e-5)
                        self.assertAlmostEqual(math.remainder(number(row[phi]) - number(right[phi]), 2 * math.pi), 0, delta=1e-5)
                if right["fate"] == "escaped":
                    self.assertLess(angle_between(direction(row), direction(right)), 1e-5)   # truncation, six steps of 0.6 rad
        self.write("rain.csv", "r,theta,phi,n_r,n_theta,n_phi,frame\n5,1,0,-1,0,0,rain\n")
        self.refused("trace", scene, "--rays", "rain.csv", says=["frame", "rotating"])
        self.write("q.csv", "q,zeta0,s\n0.5,0.1,1\n")
        self.refused("trace", scene, "--rays", "q.csv", says=["q", "rotating"])

    @support.costly
    def test_azimuths_next_to_a_spinning_horizon(self):
        """They wind up there: what is left is the error of the radius over the distance from the horizon."""
        chance = support.dice()
        for spin in (0.5, 0.9, 0.99):
            scene = self.write("kerr.toml", f'[spacetime]\nmetric = "kerr"\nspin = {spin}\n')
            root, reach = math.sqrt(1 - spin * spin), 500.0
            outer, inner = 0.5 * (1 + root), 0.5 * (1 - root)
            lines = ["r,theta,phi,n_r,n_theta,n_phi"]
            for _ in range(3000):   # towards a square of 5 r_s about the hole
                x, y = chance.uniform(-2.5, 2.5) / reach, chance.uniform(-2.5, 2.5) / reach
                length = math.sqrt(1 + x * x + y * y)
                lines.append(f"{reach},{chance.uniform(0.3, 1.4)},0,{-1 / length},{y / length},{x / length}")
            text = "\n".join(lines) + "\n"
            exact = self.trace(text, "--crossings", "1", scene=scene)
            for tracer in self.tracers():
                worst, near = 0.0, 0
                for row, right in zip(self.trace(text, "--with", tracer, "--crossings", "1", scene=scene), exact):
                    if row["r_1"] and right["r_1"]:
                        r = number(right["r_1"])
                        winds = 0.5 * spin * r / ((r - outer) * (r - inner))
                        error = abs(math.remainder(number(row["phi_1"]) - number(right["phi_1"]), 2 * math.pi))
                        worst, near = max(worst, error / (SPIN_AZIMUTH + SPIN_R * winds)), near + (r < 1.1 * outer)
                self.assertGreater(near, 20)
                self.report(f"a = {spin}, {tracer}: {near} crossings within a tenth of the horizon, phi within {worst:.2g} of its bound")
                self.assertLess(worst, 1.0)

    @support.costly
    def test_bench_rays_judges_every_tracer(self):
        self.contexts()
        out = str(self.folder / "rays.json")
        self.run_nullscope("bench", "rays", "--times", "2", "--json", out)
        rows = {row["tracer"]: row for row in json.loads(pathlib.Path(out).read_text())}
        self.assertEqual(set(rows), set(SCREEN_RAD) | {"reference"})
        for tracer in SCREEN_RAD:
            row = rows[tracer]
            self.assertEqual(row["fate_errors"], 0, tracer)
            self.assertGreater(row["rays_a_core_second"], 0, tracer)
            for what in ("sky_rad", "r", "phi_rad", "g"):
                self.assertLess(0, row[what]["median"], (tracer, what))
                self.assertLess(row[what]["median"], FAR_KERR, (tracer, what))
            self.assertLess(row["r"]["max"], FAR_KERR_MOST, tracer)

    def test_what_needs_gl_says_so(self):
        self.write("r.csv", "q,zeta0,s\n1,0.1,1\n")
        flat = ("trace", "flat", "--rays", "r.csv")
        self.refused(*flat, "--with", "core64", "--method", "closed-form", says=["closed-form", "gl"])
        self.refused(*flat, "--with", "gl", "--method", "magic", says=["magic", "closed-form"])

    def test_left_empty(self):
        self.write("r.csv", "q,zeta0,s,n\n0.5,2,1,a\n0.5,0.1,1,b\n")
        ran = self.run_nullscope("trace", "sky-only", "--rays", "r.csv", "--with", "core32")
        rows = read_csv(ran.out)
        self.assertEqual([(r["fate"], r["n"]) for r in rows], [("", "a"), ("captured", "b")])
        self.assertEqual(ran.err.count("\n"), 1)
        self.assertIn("1 of 2 rays left empty", ran.err)


if __name__ == "__main__":
    support.main()
