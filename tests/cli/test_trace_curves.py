#!/usr/bin/env python3
"""nullscope trace --points: constants of motion by metrics written down here, ends, and rays by what they conserve."""
import csv
import io
import math
import os
import random

import support

POINTS = 1200
NODES = 9             # of a derivative: by differences, of positions alone
NEAR = {"kerr 1": 3}  # times a horizon's radius, else 1.6: nearer, t and phi are not smooth over a step
CONSERVED = 1e-9      # of each constant, by positions alone; over the largest of its terms
BY_RATES = 1e-10      # the same by the rates that --rates prints
RATES = 1e-7          # those against differences, where a radius turns: a root of what is nearly 0
PRINT = os.environ.get("NULLSCOPE_PRINT_ERRORS")
PLACE = 1e-10         # of an end, r_s and rad

KERR = '[spacetime]\nmetric = "kerr"\nspin = {}\n'
NAMES = ("lambda", "r", "theta", "phi", "t")
RATE_NAMES = ("r_rate", "theta_rate", "phi_rate", "t_rate")


def kerr_like(spin, charge):
    """(g_tt, g_tphi, g_phiphi, g_rr, g_thth) of Boyer and Lindquist's form, r_s = 1."""
    a, q2 = spin / 2, charge * charge / 4

    def metric(r, theta):
        c2, s2 = math.cos(theta) ** 2, math.sin(theta) ** 2
        sigma, pull = r * r + a * a * c2, r - q2
        return (pull / sigma - 1, -a * pull * s2 / sigma, (r * r + a * a + a * a * pull * s2 / sigma) * s2,
                sigma / (r * r - pull + a * a), sigma)
    return metric, a


def spherical(lapse2, stretch2, radius2):
    def metric(r, theta):
        return (-lapse2(r), 0.0, radius2(r) * math.sin(theta) ** 2, stretch2(r), radius2(r))
    return metric, 0.0


def janis(gamma):
    def f(r):
        return 1 - 1 / (gamma * r)
    return spherical(lambda r: f(r) ** gamma, lambda r: f(r) ** -gamma, lambda r: r * r * f(r) ** (1 - gamma))


SPACES = {
    "kerr 0.9": (KERR.format(0.9), kerr_like(0.9, 0)),
    "kerr -0.7": (KERR.format(-0.7), kerr_like(-0.7, 0)),
    "kerr 1": (KERR.format(1), kerr_like(1, 0)),
    "kerr-newman": ('[spacetime]\nmetric = "kerr-newman"\nspin = 0.6\ncharge = 0.5\n', kerr_like(0.6, 0.5)),
    "schwarzschild": ('[spacetime]\nmetric = "schwarzschild"\n', kerr_like(0, 0)),
    "charged": ('[spacetime]\nmetric = "reissner-nordstrom"\ncharge = 0.8\n', kerr_like(0, 0.8)),
    "naked": ('[spacetime]\nmetric = "reissner-nordstrom"\ncharge = 1.05\n', kerr_like(0, 1.05)),
    "scalar": ('[spacetime]\nmetric = "janis-newman-winicour"\ngamma = 0.7\n', janis(0.7)),
    "star": ('[spacetime]\nmetric = "neutron-star"\n', kerr_like(0, 0)),
    "flat": ('[spacetime]\nmetric = "minkowski"\n', spherical(lambda r: 1, lambda r: 1, lambda r: r * r)),
    "wormhole": ('[spacetime]\nmetric = "ellis"\n', spherical(lambda r: 1, lambda r: 1, lambda r: r * r + 1)),
    "formula": ('[spacetime]\nmetric = "formula"\nA = "1-r^2/(r^3+0.05)"\n',
                spherical(lambda r: 1 - r * r / (r ** 3 + 0.05), lambda r: 1 / (1 - r * r / (r ** 3 + 0.05)), lambda r: r * r)),
}
HORIZONS = {"kerr 0.9": 0.72, "kerr -0.7": 0.86, "kerr 1": 0.5, "kerr-newman": 0.81, "schwarzschild": 1, "charged": 0.8, "scalar": 1 / 0.7, "formula": 0.95}


def derivatives(rows, k):
    """Of r, theta, phi, t by lambda in row k, through x, y, z, which the axis does not bend: Lagrange's polynomial through the rows about it."""
    first = min(max(k - NODES // 2, 0), len(rows) - NODES)
    near = rows[first:first + NODES]
    x, at = [row[0] for row in near], rows[k][0]
    places = [(r * math.sin(theta) * math.cos(phi), r * math.sin(theta) * math.sin(phi), r * math.cos(theta), t) for _, r, theta, phi, t, *_ in near]
    here, found = places[k - first], [0.0] * 4
    whole = [math.prod(a - b for b in x if b != a) for a in x]
    for j in range(NODES):
        if first + j != k:
            weight = math.prod(at - b for b in x if b not in (at, x[j])) / whole[j]
            for n in range(4):
                found[n] += weight * (places[j][n] - here[n])
    (px, py, pz, _), (dx, dy, dz, dt) = here, found
    flat, r = math.hypot(px, py), rows[k][1]
    outward = (px * dx + py * dy + pz * dz) / r
    return [outward, (pz * outward / r - dz) / flat, (px * dy - py * dx) / flat ** 2, dt]


def constants(space, place, rates):
    """Energy, L_z, Carter's constant (without rotation L^2 - L_z^2) and the null condition, each with the size of its terms."""
    metric, a = space
    r, theta = place[1], place[2]
    tt, tphi, phiphi, rr, thth = metric(r, theta)
    dr, dtheta, dphi, dt = rates
    p_t, p_phi, p_theta = tt * dt + tphi * dphi, tphi * dt + phiphi * dphi, thth * dtheta
    c2, s2 = math.cos(theta) ** 2, math.sin(theta) ** 2
    carter = [p_theta ** 2, c2 * p_phi ** 2 / s2, -c2 * a * a * p_t ** 2]
    null = [tt * dt * dt, 2 * tphi * dt * dphi, phiphi * dphi ** 2, rr * dr * dr, thth * dtheta ** 2]
    return ((p_t, abs(tt * dt) + abs(tphi * dphi)), (p_phi, abs(tphi * dt) + abs(phiphi * dphi) + 1),
            (sum(carter), sum(map(abs, carter)) + 1), (sum(null), sum(map(abs, null))))


class CurveTest(support.CliTest):
    def rows_of(self, scene, rays, *options, points=POINTS):
        """Rays' rows by number: (lambda, r, theta, phi, t[, rates])."""
        self.write("scene.toml", scene)
        self.write("rays.csv", rays)
        out = self.run_nullscope("trace", "scene.toml", "--rays", "rays.csv", "--points", str(points), *options).out
        curves = {}
        for row in csv.DictReader(io.StringIO(out)):
            curves.setdefault(int(row.pop("ray")), []).append([float(value) if value else math.nan for value in row.values()])
        return curves

    def traced(self, rays, *options):
        self.write("rays.csv", rays)
        out = self.run_nullscope("trace", "scene.toml", "--rays", "rays.csv", *options).out
        return list(csv.DictReader(io.StringIO(out)))

    @staticmethod
    def some_rays(count, reach=4.0, least=0.0, chance=None):
        """From 8 to 40 r_s, by the centre within `reach` r_s up and down, and from `least` on to one side."""
        chance = chance or support.dice()
        lines = ["r,theta,phi,n_r,n_theta,n_phi"]
        for _ in range(count):
            r = chance.uniform(8, 40)
            x, y = chance.uniform(least or -reach, reach) / r, chance.uniform(-reach, reach) / r
            lines.append(f"{r!r},{chance.uniform(0.4, 2.7)!r},{chance.uniform(-3, 3)!r},-1,{y!r},{x!r}")
        return "\n".join(lines) + "\n"


class Curves(CurveTest):
    def test_constants_of_motion(self):
        for name, (scene, space) in SPACES.items():
            points = {"kerr 1": 4 * POINTS, "scalar": 300}.get(name, POINTS)   # it winds up next to that horizon; 5 ms a point
            rays = self.some_rays(2, least=3.3 if name == "scalar" else 0)   # captured ones take milliseconds a place there
            curves = self.rows_of(scene, rays, "--rates", points=points)
            self.assertEqual(len(curves), 2, name)
            worst = [0.0, 0.0, 0.0]
            for rows in curves.values():
                self.assertEqual(len(rows), points, name)
                begin = constants(space, rows[0], rows[0][5:])
                self.assertAlmostEqual(begin[0][0], 1, delta=1e-13, msg=name)   # the tangent runs backward in time: p_t = E = 1
                for k in range(0, points, points // 32):
                    far = not rows[k][1] < NEAR.get(name, 1.6) * HORIZONS.get(name, 0)
                    by_place = derivatives(rows, k) if far else rows[k][5:]
                    for n, rates in enumerate((by_place, rows[k][5:])):
                        for (value, size), (first, _) in zip(constants(space, rows[k], rates), begin):
                            worst[n] = max(worst[n], abs(value - first) / max(size, abs(first)))
                    for value, right in zip(rows[k][5:], by_place):
                        worst[2] = max(worst[2], abs(value - right) / max(1.0, abs(right)))
            if PRINT:
                print(f"{name}: constants to {worst[0]:.1g} by places, {worst[1]:.1g} by rates, rates to {worst[2]:.1g}")
            for error, bound in zip(worst, (CONSERVED, BY_RATES, RATES)):
                self.assertLess(error, bound, name)

    def test_points_stand_evenly(self):
        """A step is the same part of the distance, or the same angle, everywhere."""
        rows = self.rows_of(KERR.format(0.9), self.some_rays(1, 1e-9), "--cartesian", points=300)[1]
        steps = [math.dist(a[1:4], b[1:4]) / math.hypot(*(0.5 * (x + y) for x, y in zip(a[1:4], b[1:4]))) for a, b in zip(rows, rows[1:])]
        self.assertLess(max(steps), 2.5 * min(steps))

    def test_ends(self):
        """Where trace says that the ray ends: the sky's direction far out, the disc, a horizon, a star."""
        for name in ("kerr 0.9", "schwarzschild", "star", "wormhole"):
            scene, _ = SPACES[name]
            if name in ("kerr 0.9", "schwarzschild"):
                scene += "[disc]\ninner = 3.5\nouter = 9\n"
            rays = self.some_rays(12, 1.5 if name == "wormhole" else 4.0)
            curves = self.rows_of(scene, rays, "--far", "1e6", points=20)
            seen = set()
            for i, row in enumerate(self.traced(rays, "--crossings", "9"), 1):
                *_, (_, r, theta, phi, _) = curves[i]
                fate = row["fate"]
                seen.add(fate)
                if fate in ("escaped", "other_side"):
                    self.assertAlmostEqual(abs(r), 1e6, delta=1)
                    self.assertAlmostEqual(theta, float(row["theta_inf"]), delta=2e-5)
                    self.assertAlmostEqual(phi, float(row["phi_inf"]), delta=2e-5 / math.sin(theta))
                elif fate == "captured":
                    horizon = 0.5 * (1 + math.sqrt(1 - 0.81)) if "kerr" in name else 1
                    self.assertAlmostEqual(r, 1.01 * horizon, delta=PLACE)
                elif fate == "hit:disc":
                    radii = [float(row[f"r_{k}"]) for k in range(1, 10) if row[f"r_{k}"]]
                    k = next(k for k, x in enumerate(radii, 1) if 3.5 <= x <= 9)
                    self.assertAlmostEqual(theta, math.pi / 2, delta=PLACE)
                    self.assertAlmostEqual(r, radii[k - 1], delta=PLACE)
                    self.assertAlmostEqual(phi, float(row[f"phi_{k}"]), delta=PLACE)
                else:
                    self.assertEqual(fate, "hit:star")
                    self.assertAlmostEqual(r, 2.25, delta=0.75)
            self.assertGreater(len(seen), 1, (name, seen))

    def test_ends_that_are_asked_for(self):
        """A radius, a polar angle, also where a ray turns back just beyond it, Mino's time by the points themselves and by L, and a disc that leans."""
        for name in ("kerr 0.9", "schwarzschild"):
            scene, (_, a) = SPACES[name][0], SPACES[name][1]
            rays = self.some_rays(12, least=2.8, chance=random.Random(3))   # to one side: these escape
            whole = self.rows_of(scene, rays, "--far", "50", "--rates", points=400)
            near = {i: min(row[1] for row in rows) for i, rows in whole.items()}
            for i, rows in self.rows_of(scene, rays, "--far", "50", "--to-r", "7", points=9).items():
                self.assertAlmostEqual(rows[-1][1], 7 if near[i] < 7 else 50, delta=PLACE, msg=(name, i))
            north = {i: min(row[2] for row in rows) for i, rows in whole.items()}
            turned = 0
            for i, rows in whole.items():
                least = min(range(400), key=lambda k: rows[k][2])
                asked = north[i] + 1e-4   # between two points
                if 5 < least < 395:
                    turned += 1
                    line = rays.splitlines()[i]
                    found = self.rows_of(scene, "r,theta,phi,n_r,n_theta,n_phi\n" + line + "\n", "--far", "50", "--to-theta", repr(asked), points=9)[1]
                    self.assertAlmostEqual(found[-1][2], asked, delta=PLACE)
                    self.assertLess(found[-1][0], rows[least][0] + 1e-6)
            self.assertGreater(turned, 2, name)
            for rows in self.rows_of(scene, rays, "--to-mino", "0.3", "--rates", points=801).values():
                steps = [b[0] - p[0] for p, b in zip(rows, rows[1:])]
                rate = [1 / (row[1] ** 2 + (a * math.cos(row[2])) ** 2) for row in rows]
                by_points = sum(h * (p + q) / 2 for h, p, q in zip(steps, rate, rate[1:]))
                self.assertAlmostEqual(by_points, 0.3, delta=3e-5, msg=name)
                if name == "schwarzschild":
                    (_, _), (p_phi, _), (square, _), _ = constants(SPACES[name][1], rows[0], rows[0][5:])
                    n = [[math.sin(r[2]) * math.cos(r[3]), math.sin(r[2]) * math.sin(r[3]), math.cos(r[2])] for r in (rows[0], rows[-1])]
                    swept = math.acos(sum(x * y for x, y in zip(*n)))
                    self.assertAlmostEqual(swept, math.sqrt(square + p_phi ** 2) * 0.3, delta=1e-9)
        for name in ("kerr 0.9", "schwarzschild"):
            scene = SPACES[name][0] + "[disc]\ninner = 4\nouter = 9\ntilt = 50\nnode = 20\n"
            rays, met = self.some_rays(16, chance=random.Random(4)), 0
            curves = self.rows_of(scene, rays, points=9)
            for i, row in enumerate(self.traced(rays, "--crossings", "6"), 1):
                if row["fate"] == "hit:disc":
                    met += 1
                    radii = [float(row[f"r_{k}"]) for k in range(1, 7) if row[f"r_{k}"]]
                    self.assertAlmostEqual(curves[i][-1][1], next(x for x in radii if 4 <= x <= 9), delta=PLACE)
            self.assertGreater(met, 2, name)

    def test_pixels_end_where_ray_data_say(self):
        """A ball and a disc about a rotating hole, by capture --raydata."""
        self.write("scene.toml", KERR.format(0.8) + "[camera]\nobserver = \"zamo\"\nr = 20\ntheta = 70\nfov = 60\nsize = [16, 9]\n"
                   "[disc]\ninner = 3\nouter = 7\n[ball]\nposition = [8, 5, 0]\nradius = 1.5\n[light]\ndelay = \"off\"\n")
        self.run_nullscope("capture", "scene.toml", "--renderer", "reference", "--raydata", "-o", "a.exr")
        channels = support.read_exr((self.folder / "a.exr").read_bytes())
        half, lines, wanted = math.tan(math.radians(30)), ["r,theta,phi,n_r,n_theta,n_phi"], []
        for y in range(9):
            for x in range(16):
                lines.append(f"20,{math.radians(70)!r},0,-1,{(y + 0.5 - 4.5) / 8 * half!r},{(x + 0.5 - 8) / 8 * half!r}")
                wanted.append([channels[name][y][x] for name in ("hit", "ray.hit_u", "ray.hit_v", "ray.hit_w")])
        text = (self.folder / "scene.toml").read_text()
        curves, hits = self.rows_of(text, "\n".join(lines) + "\n", "--cartesian", points=3), set()
        for i, (hit, *place) in enumerate(wanted, 1):
            if hit:
                hits.add(hit)
                for value, right in zip(curves[i][-1][1:4], place):
                    self.assertAlmostEqual(value, right, delta=2e-6)   # of a float
        self.assertEqual(hits, {1, 4})

    def test_obj(self):
        self.write("scene.toml", KERR.format(0.9))
        self.write("rays.csv", self.some_rays(3))
        trace = ("trace", "scene.toml", "--rays", "rays.csv", "--points", "20")
        self.run_nullscope(*trace, "-o", "x.obj")
        rows = list(csv.DictReader(io.StringIO(self.run_nullscope(*trace, "--cartesian").out)))
        lines = (self.folder / "x.obj").read_text().splitlines()
        places = [list(map(float, line.split()[1:])) for line in lines if line.startswith("v ")]
        strips = [list(map(int, line.split()[1:])) for line in lines if line.startswith("l ")]
        self.assertEqual([k for strip in strips for k in strip], list(range(1, 61)))
        self.assertEqual([len(strip) for strip in strips], [20, 20, 20])
        for place, row in zip(places, rows):
            for value, right in zip(place, (row["x"], row["y"], row["z"])):
                self.assertAlmostEqual(value, float(right), delta=1e-7)

    def test_what_is_refused(self):
        self.write("rays.csv", self.some_rays(1))
        trace = ("trace", "flat", "--rays", "rays.csv")
        for options, says in (((*trace, "-o", "x.obj"), "--points N"), ((*trace, "--cartesian"), "--points N"), ((*trace, "--to-mino", "1"), "--points N"), ((*trace, "--points", "9", "--to-theta", "4"), "--to-theta"),
                              ((*trace, "--points", "1"), "[2, 100000]"), ((*trace, "--points", "9", "--with", "gl"), "reference"),
                              ((*trace, "--points", "9", "--crossings", "1"), "--crossings"),
                              ((*trace, "--points", "9", "--rates", "-o", "x.obj"), ".csv")):
            self.refused(*options, says=[says])
        self.write("rays.csv", "r,theta,phi,n_r,n_theta,n_phi\n200,1,0,1,0,0\n20,1,0,1,0,0\n")
        ran = self.run_nullscope(*trace, "--points", "2")
        self.assertIn("1 of 2 rays have no curve", ran.err)
        self.assertEqual({line.split(",")[0] for line in ran.out.splitlines()[1:]}, {"2"})


class Conserved(CurveTest):
    """Rays by alpha, beta and by lambda, eta (Bardeen 1973), in M."""

    @staticmethod
    def spherical_orbit(spin, r):
        """lambda and eta of light that stays at r, M = 1 (Bardeen 1973)."""
        delta = r * r - 2 * r + spin * spin
        away = (r * r - spin * spin) - r * delta
        lam = away / (spin * (r - 1))
        return lam, r ** 3 * (4 * delta - r * (r - 1) ** 2) / (spin * (r - 1)) ** 2

    def test_critical_curve(self):
        """Just within it light is captured, just outside it escapes; both forms give the same rays."""
        for spin, degrees in ((0.9, 60.0), (-0.6, 17.0), (0.998, 89.0)):
            self.write("scene.toml", KERR.format(spin))
            theta = math.radians(degrees)
            places = []
            for i in range(1, 60):
                lam, eta = self.spherical_orbit(spin, 1 + 3 * i / 60)
                square = eta + (spin * math.cos(theta)) ** 2 - (lam / math.tan(theta)) ** 2
                if eta > 0 and square > 0.01:
                    places.append((-lam / math.sin(theta), math.sqrt(square), lam, eta))
            self.assertGreater(len(places), 8)
            middle = 0.5 * (min(p[0] for p in places) + max(p[0] for p in places))
            for off, fate in ((-1e-6, "captured"), (1e-6, "escaped")):
                lines, same = ["alpha,beta,theta,unit"], ["lambda,eta,theta,up,unit"]
                for alpha, beta, _, _ in places:
                    for up in (1, -1):
                        x, y = middle + (alpha - middle) * (1 + off), up * beta * (1 + off)
                        lines.append(f"{x!r},{y!r},{theta!r},M")
                        lam = -x * math.sin(theta)
                        eta = y * y - (spin * math.cos(theta)) ** 2 + (lam / math.tan(theta)) ** 2
                        same.append(f"{lam!r},{eta!r},{theta!r},{up},M")
                rows = self.traced("\n".join(lines) + "\n")
                self.assertEqual({row["fate"] for row in rows}, {fate}, (spin, degrees))
                again = self.traced("\n".join(same) + "\n")
                self.assertEqual({row["fate"] for row in again}, {fate}, (spin, degrees))

    def test_curves_have_what_was_asked(self):
        """lambda and eta of the points are those that were asked for: from an observer at 1e9 r_s to 1e-8."""
        spin, (scene, space) = 0.9, SPACES["kerr 0.9"]
        asked = [(2.0, 10.0, 1.1, 1), (-4.5, 9.0, 1.1, -1), (0.0, 20.0, 2.0, -1), (0.0, 30.0, 0.0, 1)]
        text = "lambda,eta,theta,up,unit\n" + "".join(f"{l},{e},{t},{u},M\n" for l, e, t, u in asked)
        curves = self.rows_of(scene, text, "--rates", points=41)
        for i, (lam, eta, theta, up) in enumerate(asked, 1):
            row = curves[i][20]
            (_, _), (p_phi, _), (carter, _), _ = constants(space, row, row[5:])
            self.assertAlmostEqual(-2 * p_phi, lam, delta=1e-7)   # r_s = 2 M; the tangent runs backward
            self.assertAlmostEqual(4 * carter, eta, delta=1e-6)
            if theta > 0:
                self.assertGreater(-curves[i][0][6] * up, 0)   # light that comes from above has beta > 0: backward theta falls

    def test_refused(self):
        self.write("scene.toml", KERR.format(0.9))
        for text, says in (("lambda,theta\n", "missing: eta"), ("lambda,eta,theta\n5,0,1\n", "eta >= "),
                           ("lambda,eta,theta\n1,0,0\n", "axis"), ("lambda,eta,theta,up\n1,9,1,0\n", "up"),
                           ("alpha,beta,theta,unit\n1,1,1,km\n", "M, r_s or nothing")):
            self.write("rays.csv", text)
            self.refused("trace", "scene.toml", "--rays", "rays.csv", says=[says])


if __name__ == "__main__":
    support.main()
