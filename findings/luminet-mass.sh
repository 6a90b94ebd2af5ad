#!/usr/bin/env bash
# luminet 0.2.3 (Luminet's picture of a thin disc of 1979), the flux of the disc of a hole whose mass is not 1.
#
# Guessed: in units with G = c = 1 its two functions for the flux of a disc, for Schwarzschild's and for Kerr's hole, agree where the spin is 0, and
#   at a radius of so many M the flux falls as M^-2 for one accretion rate.
# Seen: without a word,
#   calc_flux_intrinsic_kerr is Page and Thorne's at any mass and spin, to 9 digits of their integral (spins -0.5 to 0.9, masses 1 and 2);
#   calc_flux_intrinsic_swarzschild (so spelt) grows as M: of M = 2 it is 8 times, of M = 10 a thousand times Kerr's of no spin, M^3 too much.
# At M = 1, its default, both are right. calc_flux_observed, which its pictures and samples use, goes by the latter.
# Who compares discs of other masses by it divides by M^3, or takes M = 1 and scales lengths himself.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet luminet==0.2.3 scipy==1.15.3
cd "$folder"
venv/bin/python -W ignore - <<'PYTHON'
import math
import sys

from luminet import black_hole_math
from scipy.integrate import quad

changed = []


def last_stable(a):
    """Radius of the last stable orbit in M; a below 0: against the hole's rotation."""
    first = 1 + (1 - a * a) ** (1 / 3) * ((1 + a) ** (1 / 3) + (1 - a) ** (1 / 3))
    second = math.hypot(math.sqrt(3) * a, first)
    return 3 + second - math.copysign(math.sqrt((3 - first) * (3 + first + 2 * second)), a)


def page_thorne(r, a):
    """Flux at r (in M) of a disc about a hole of mass 1 for one accretion rate, by the integral over energy, angular momentum and angular velocity."""
    norm = lambda x: math.sqrt(1 - 3 / x + 2 * a * x**-1.5)
    energy = lambda x: (1 - 2 / x + a * x**-1.5) / norm(x)
    momentum = lambda x: math.sqrt(x) * (1 - 2 * a * x**-1.5 + a * a / x**2) / norm(x)
    rate = lambda x: 1 / (x**1.5 + a)
    slope = lambda of, x: (of(x * (1 + 1e-6)) - of(x * (1 - 1e-6))) / (2e-6 * x)
    inside = quad(lambda x: (energy(x) - rate(x) * momentum(x)) * slope(momentum, x), last_stable(a), r, epsabs=1e-13)[0]
    return -slope(rate, r) / (energy(r) - rate(r) * momentum(r)) ** 2 * inside / (4 * math.pi * r)


for mass in (1, 2, 10):
    for a in (-0.5, 0.0, 0.5, 0.9):
        off = max(abs(black_hole_math.calc_flux_intrinsic_kerr(mass, a * mass, r * mass, 1.0) * mass**2 / page_thorne(r, a) - 1) for r in (8, 15, 30))
        print(f"M = {mass}, a = {a} M: Kerr's flux off by {off:.1e}")
        if off > 1e-8:
            changed.append(f"Kerr's flux at M = {mass}, a = {a}")
    ratios = [black_hole_math.calc_flux_intrinsic_swarzschild(mass, r * mass, 1.0) * mass**2 / page_thorne(r, 0.0) for r in (8, 15, 30)]
    print(f"M = {mass}: Schwarzschild's flux over Page and Thorne's", *(f"{ratio:.9f}" for ratio in ratios))
    if any(abs(ratio / mass**3 - 1) > 1e-8 for ratio in ratios):
        changed.append(f"Schwarzschild's flux at M = {mass}")
    seen = black_hole_math.calc_flux_observed(8 * mass, 1.0, mass, 1.0) * mass**2 / page_thorne(8, 0.0)
    if abs(seen / mass**3 - 1) > 1e-8:
        changed.append(f"the flux that pictures show, M = {mass}")
sys.exit(f"changed: {', '.join(changed)}" if changed else 0)
PYTHON
