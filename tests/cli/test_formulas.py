#!/usr/bin/env python3
"""Metrics by formula from the literature (tests/formulas/formulas.csv): each drawn and judged by integrals written down here and by the
reference, or refused with the reason."""
import csv
import math
import os

import support

LIST = support.VECTORS.parent / "formulas" / "formulas.csv"
PRINT = os.environ.get("NULLSCOPE_PRINT_ERRORS")
CAMERA = 15.0
# Of the impact parameter of the rim, or of R at the camera where all light comes back.
BACK = (0.2, 0.6, 0.97, 0.999)     # of its inverse: these rays miss the rim
INTO = (1.03, 1.5, 6.0)            # and these are within it
ANGLE = {"reference": 1e-7, "core64": 2e-6, "core32": 4e-6}   # rad, against the integrals here; tables are floats
MOST = 30.0      # rad: rays that wind for longer show nothing
RIM = 1e-6       # of b, where the rays of core64 change from sky to none, against what is known in closed form
NO_LAPSE = 1e-5  # of A, next to a horizon
NODES = ((0.0950125098376374, 0.1894506104550685), (0.2816035507792589, 0.1826034150449236), (0.4580167776572274, 0.1691565193950025),
         (0.6178762444026438, 0.1495959888165767), (0.7554044083550030, 0.1246289712555339), (0.8656312023878318, 0.0951585116824928),
         (0.9445750230732326, 0.0622535239386479), (0.9894009349916499, 0.0271524594117541))
NAMES = {name: getattr(math, name) for name in ("sqrt", "exp", "log", "atan", "pi")}
CIRCLES = "light can circle at r = "
REFUSED = {"schwarzschild-anti-de-sitter": "light comes back from infinity in a finite time", "euler-heisenberg-inner": CIRCLES,
           "quasi-topological-inner": CIRCLES, "galaxy": CIRCLES}


def rows():
    with open(LIST, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def function_of(text):
    code = compile(text.replace("^", "**"), text, "eval")
    return lambda r: eval(code, NAMES, {"r": r})


class World:
    def __init__(self, row):
        self.row = row
        self.a = function_of(row["A"])
        self.b = function_of(row["B"]) if row["B"] else lambda r: 1 / self.a(r)
        self.areal = function_of(row["R"] or "r")

    def scene(self):
        keys = "".join(f'{key} = "{self.row[key]}"\n' for key in ("A", "B", "R") if self.row[key])
        return f'[spacetime]\nmetric = "formula"\n{keys}[camera]\nr = {CAMERA}\n'

    def v(self, r):
        return self.a(r) / self.areal(r) ** 2

    def rests(self, r):
        try:
            value = self.v(r)
            return self.a(r) > 0 and not isinstance(value, complex) and value > 0 and self.b(r) > 0
        except (ZeroDivisionError, OverflowError, ValueError, TypeError):
            return False

    def survey(self):
        """(r, V) inward from the camera to the end, finely."""
        found, r = [], CAMERA
        while r > 1e-6 and self.rests(r) and self.a(r) > NO_LAPSE:
            found.append((r, self.v(r)))
            r *= 0.9995
        return found

    def turn(self, q):
        """The largest r below the camera's with V = q^2; None where light meets none."""
        before = CAMERA
        for r, v in self.inward:
            if v >= q * q:
                low, high = r, before
                for _ in range(100):
                    middle = 0.5 * (low + high)
                    if self.v(middle) >= q * q:
                        low = middle
                    else:
                        high = middle
                return high
            before = r
        return None

    def swept(self, q):
        """To infinity, of the ray inward: zeta = zeta_t (1 - s^2), by panels that shrink towards the sky."""
        turn = self.turn(q)

        def rate(s):
            zeta = (1 - s) * (1 + s) / turn
            r = 1 / zeta
            left = q * q - self.v(r)
            return r * r * math.sqrt(self.a(r) * self.b(r)) / self.areal(r) ** 2 / math.sqrt(left) * 2 * s / turn

        def integral(low, high):
            middle, half = 0.5 * (low + high), 0.5 * (high - low)
            return half * sum(w * (rate(middle - half * x) + rate(middle + half * x)) for x, w in NODES)

        def panels(low, high, count):
            # Denser at the turning point, where a ray may linger.
            return sum(integral(low + (high - low) * (i / count) ** 2, low + (high - low) * ((i + 1) / count) ** 2) for i in range(count))

        seen = math.sqrt(1 - turn / CAMERA)
        whole = 2 * panels(0, seen, 12)
        low = seen
        for _ in range(30):
            high = 0.5 * (1 + low)
            whole += integral(low, high)
            low = high
        return whole

    def rays(self):
        """(q, or None for one that does not come back) inward from the camera, and the swept angle of those that do."""
        self.inward = self.survey()
        highest = max(v for _, v in self.inward)
        bounce = self.row["end"] == "bounce"
        here = math.sqrt(self.v(CAMERA))
        inner = [v for i, (_, v) in enumerate(self.inward[1:-1], 1) if self.inward[i - 1][1] < v >= self.inward[i + 1][1]]
        rim = math.sqrt(inner[0] if bounce and inner else 4 * here * here if bounce else highest)
        qs = [part * rim for part in BACK if part * rim > here] + [part * rim for part in INTO]
        rays = [(q, self.swept(q) if bounce or q < rim else None) for q in qs]
        return [(q, angle) for q, angle in rays if angle is None or angle < MOST]


def direction(world, q):
    sine = math.sqrt(world.v(CAMERA)) / q
    return -math.sqrt((1 - sine) * (1 + sine)), sine


class Formulas(support.CliTest):
    def traced(self, world, directions, *with_):
        scene = self.write("formula.toml", world.scene())
        lines = [f"{CAMERA},{math.pi / 2!r},0,{n_r!r},0,{n_t!r}" for n_r, n_t in directions]
        rays = self.write("rays.csv", "r,theta,phi,n_r,n_theta,n_phi\n" + "\n".join(lines) + "\n")
        out = self.run_nullscope("trace", scene, "--rays", rays, *with_).out
        return list(csv.DictReader(out.splitlines()))

    def test_kinds(self):
        kinds = [row["kind"] for row in rows()]
        for kind in ("no horizon", "several photon spheres", "not flat far out", "isotropic", "extremal", "wormhole"):
            self.assertGreaterEqual(kinds.count(kind), 5, kind)
        self.assertGreaterEqual(len(kinds), 40)

    def judge(self, row, tracers):
        world = World(row)
        rays = world.rays()
        for tracer in tracers:
            found = self.traced(world, [direction(world, q) for q, _ in rays], "--with", tracer)
            worst = 0.0
            for (q, angle), one in zip(rays, found):
                self.assertEqual(one["fate"], "captured" if angle is None else "escaped", f"{row['name']} {tracer} q = {q}")
                if angle is not None:
                    worst = max(worst, abs(float(one["angle"]) - angle))
            if PRINT:
                print(f"{row['name']:28} {tracer:10} {worst:.2e}")
            self.assertLess(worst, ANGLE[tracer], f"{row['name']} {tracer}")

    def rim(self, row):
        """b of the rim, by halves of the angle between rays of sky and none."""
        world = World(row)
        low, high = 0.5, 2.0
        for _ in range(2):
            parts = [low + (high - low) * i / 2000 for i in range(2001)]
            looks = [direction(world, 1 / (float(row["b_crit"]) * part)) for part in parts]
            fates = [one["fate"] for one in self.traced(world, looks, "--with", "core64")]
            at = next(i for i, fate in enumerate(fates) if fate == "escaped")
            low, high = parts[at - 1], parts[at]
        return 0.5 * (low + high)

    def check(self, row, tracers):
        with self.subTest(row["name"]):
            if row["end"] != "refused":
                return self.judge(row, tracers)
            scene = self.write("formula.toml", World(row).scene())
            return self.assertIn(REFUSED[row["name"]], self.run_nullscope("plan", scene, status=2).err)

    def test_each(self):
        drawn = [row for row in rows() if row["end"] != "refused"]
        one_of_a_kind = list({row["kind"]: row for row in drawn}.values())
        for row in one_of_a_kind if support.QUICK else drawn:
            self.check(row, ("core64", "reference") if support.QUICK else ("reference", "core64", "core32"))

    def test_refused(self):
        for row in rows():
            if row["end"] == "refused":
                self.check(row, ())

    def test_rims(self):
        known = [row for row in rows() if row["b_crit"]]
        for row in known[1::8] if support.QUICK else known:
            with self.subTest(row["name"]):
                off = abs(self.rim(row) - 1)
                if PRINT:
                    print(f"{row['name']:28} rim {off:.2e}")
                self.assertLess(off, RIM)


if __name__ == "__main__":
    support.main()
