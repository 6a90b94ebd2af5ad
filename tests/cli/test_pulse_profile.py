#!/usr/bin/env python3
"""Light curves of hot caps on a neutron star that turns, against integrals over the star's surface: Schwarzschild's bending and light's delay, the
Doppler shift of the surface; and Beloborodov's closed form of a small spot (2002, ApJ 566, L85)."""
import csv
import math

import support

TURNS_A_SECOND = 6.18955e-5 * 1.4    # rad per r_s/c, of a star of 1.4 suns
AWAY = 1e6                           # r_s, of the camera
SCENE = """[camera]
r = {away}
theta = {theta}
plane_width = {width}
focal_distance = 1
size = [{size}, {size}]
[sky]
kind = "black"
[light]
band = "bolometric"
[sphere]
radius = {radius}
temperature = 6000
colour = [0, 0, 0]
spin_rate = {rate}
[[cap]]
colatitude = {colatitude}
radius = {cap}
temperature = 6000
"""
ALPHAS = 3000    # angles to the normal at which light leaves


def gauss(n):
    """Nodes and weights on [0, 1]."""
    found = []
    for i in range(n):
        z = math.cos(math.pi * (i + 0.75) / (n + 0.5))
        for _ in range(20):
            p, q = 1.0, 0.0
            for j in range(n):
                p, q = ((2 * j + 1) * z * p - j * q) / (j + 1), p
            slope = n * (z * p - q) / (z * z - 1)
            z -= p / slope
        found.append((0.5 * (1 - z), 1 / ((1 - z * z) * slope * slope)))
    return found


def bent(alpha, radius, nodes=tuple(gauss(48))):
    """The angle about the centre, and the delay behind light that leaves radially: integrals over x = radius/r = 1 - y^2."""
    square = math.sin(alpha) ** 2 / (1 - 1 / radius)
    angle = late = 0.0
    for y, weight in nodes:
        x = 1 - y * y
        s = square * x * x * (1 - x / radius)
        root = math.sqrt(max(1 - s, 1e-300))
        angle += 2 * y * weight / root
        late += 2 * y * weight * square / (root * (1 + root))
    return math.sqrt(square) * angle, radius * late


class Star:
    def __init__(self, radius, theta, colatitude, cap, rate):
        self.radius, self.rate, self.cap = radius, rate, cap
        self.k = (math.sin(theta), 0.0, math.cos(theta))   # towards the observer
        self.e = (math.cos(theta), 0.0, -math.sin(theta)), (0.0, 1.0, 0.0)
        self.colatitude = colatitude
        self.rays = [(a, *bent(a, radius)) for a in (0.5 * math.pi * (n + 0.5) / ALPHAS for n in range(ALPHAS))]

    def g4(self, b, psi, chi):
        """Of light with the impact parameter b, from the angle psi off the line of sight in the direction chi."""
        aside = [math.cos(chi) * e + math.sin(chi) * f for e, f in zip(*self.e)]
        place = [math.cos(psi) * k + math.sin(psi) * o for k, o in zip(self.k, aside)]
        lapse2 = 1 - 1 / self.radius
        v2 = (self.rate * self.radius) ** 2 * (place[0] ** 2 + place[1] ** 2) / lapse2
        momentum = b * (aside[0] * self.k[1] - aside[1] * self.k[0])   # about the axis, over the energy
        return (math.sqrt(lapse2 * (1 - v2)) / (1 - self.rate * momentum)) ** 4

    def flux(self, t, few=tuple(gauss(8))):
        """Integral of g^4 b db dchi over the cap; t: when radial light leaves that arrives now."""
        total = 0.0
        for alpha, psi, late in self.rays:
            phi = self.rate * (t - late)
            middle = (math.sin(self.colatitude) * math.cos(phi), math.sin(self.colatitude) * math.sin(phi), math.cos(self.colatitude))
            along, x, y = (sum(a * b for a, b in zip(middle, axis)) for axis in (self.k, *self.e))
            rim = (math.cos(self.cap) - math.cos(psi) * along) / (math.sin(psi) * math.hypot(x, y))
            if rim >= 1:
                continue
            half, turn = math.acos(max(rim, -1)), math.atan2(y, x)
            b = self.radius * math.sin(alpha) / math.sqrt(1 - 1 / self.radius)
            ring = sum(2 * half * weight * self.g4(b, psi, turn + half * (2 * part - 1)) for part, weight in few)
            total += ring * b * self.radius * math.cos(alpha) / math.sqrt(1 - 1 / self.radius)
        return total * 0.5 * math.pi / ALPHAS


class PulseProfile(support.CliTest):
    def curve(self, radius, theta, colatitude, cap, rate, size, steps):
        """(when radial light left, flux as Star has it) of some times in a turn."""
        width = 2.2 * radius / math.sqrt(1 - 1 / radius) / AWAY
        scene = self.write("star.toml", SCENE.format(away=AWAY, width=width, size=size, radius=radius, rate=rate, theta=theta, colatitude=colatitude, cap=cap))
        first = AWAY - radius + math.log((AWAY - 1) / (radius - 1))
        turn = 2 * math.pi / rate
        self.run_nullscope("lightcurve", scene, "--from", repr(first), "--to", repr(first + turn), "--steps", str(steps), "-o", "star")
        with open(self.folder / "star.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        unit = AWAY ** 2 * (1 - 1 / AWAY)   # sine of an angle: b sqrt(A)/r, and the camera's own g^4
        return [(float(row["time"]) - first, float(row["flux"]) * unit) for row in rows]

    def test_a_cap_that_turns_has_the_profile_of_the_integral_over_it(self):
        for hertz in (1, 600):
            rate = hertz * TURNS_A_SECOND
            star = Star(2.5, math.radians(70), math.radians(60), math.radians(15), rate)
            seen = self.curve(2.5, 70, 60, 15, rate, 768, 8)
            exact = [star.flux(t) for t, _ in seen]
            most = max(abs(flux / max(exact) - there / max(exact)) for (_, flux), there in zip(seen, exact))
            print(f"cap of 15 degrees, {hertz} Hz: off by {most:.1e} of the largest, least over largest {min(exact) / max(exact):.3f}")
            self.assertLess(most, 1e-4)   # pixels are covered in part: measured 7e-5
            self.assertLess(min(exact), 0.1 * max(exact))

    def test_a_small_spot_has_beloborodovs_profile(self):
        """F ~ (1 - u)^2 (u + (1 - u) cos psi) while that is above 0; he states 1 % of the bending for r > 3 r_s."""
        for radius in (3.0, 4.5):
            rate, u = TURNS_A_SECOND, 1 / radius
            seen = self.curve(radius, 50, 60, 4, rate, 512, 8)
            area = 2 * math.pi * (1 - math.cos(math.radians(4))) * radius ** 2
            off = []
            for t, flux in seen:
                cosine = math.cos(math.radians(50)) * math.cos(math.radians(60)) + math.sin(math.radians(50)) * math.sin(math.radians(60)) * math.cos(rate * t)
                off.append(abs(flux / area - (1 - u) ** 2 * max(u + (1 - u) * cosine, 0)) / (1 - u) ** 2)
            print(f"spot of 4 degrees at {radius} r_s: off Beloborodov's form by {max(off):.1e} of the largest")
            self.assertLess(max(off), 1e-2)


if __name__ == "__main__":
    support.main()
