#!/usr/bin/env bash
# kerrz 0.4.1 (a ray tracer of Kerr holes), kerrz_python's KerrMetric(M, a) with a mass other than 1 or almost no spin.
#
# Guessed: every length scales with M, whether a is a length or a part of M (kerrz.h says dimensionless); a = 0 is Schwarzschild's hole.
# Seen: without a word,
#   the horizon and light's paths take a as a length and scale with M to 12 digits, but metric.isco does neither: at a = 0.9 M it is
#       3.92 M for M = 2 and -0.88 M for M = 1/2, where 2.32 M is right (as it is for M = 1);
#   circular_orbit_velocity lets gas fall in within that radius: for M = 2, at r = 2.75 M on a stable orbit, u^r is -0.11 and u^t 5.5 % too large;
#       transfer functions, whose tables start there by default, lack the inner disc;
#   |a| < 0.001 becomes a = +0.001, also of a < 0: of a = 0 the last stable orbit is at 5.9967 M, and redshifts agree with Schwarzschild's to 5 digits
#       only, where those of a = 0.9 agree with Kerr's to 12.
# kerrz's own command-line calculator has none of it (6.000000 for a = 0, 2.320883 at any mass).
# Who compares with kerrz keeps M = 1, scales lengths himself and compares with a = 0.001 in the place of Schwarzschild.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet kerrz==0.4.1 kerrz-lib==0.4.1 kerrz-python==0.4.1 kerrz-cli==0.4.1 numpy==2.4.6
cd "$folder"
venv/bin/kerrzcli calc --mass 10 --spin 0.9 isco >mass.txt
venv/bin/kerrzcli calc --spin 0 isco >spin.txt
venv/bin/python -W ignore - <<'PYTHON'
import math
import pathlib
import sys

from kerrz_python.wrappers import CunninghamTransferFunctionTable, FourVector, KerrMetric, NullGeodesic, circular_orbit_velocity

REST, FAR, TILT = FourVector(1, 0, 0, 0), 1e6, math.radians(60)
changed = []


def note(name, good):
    if not good:
        changed.append(name)


def last_stable(spin):
    """Bardeen, Press and Teukolsky's radius of the last stable orbit in units of M, 0 <= spin < 1."""
    first = 1 + (1 - spin**2) ** (1 / 3) * ((1 + spin) ** (1 / 3) + (1 - spin) ** (1 / 3))
    second = math.hypot(math.sqrt(3) * spin, first)
    return 3 + second - math.sqrt((3 - first) * (3 + first + 2 * second))


def on_orbit(r, spin):
    """u^t of a stable circular orbit at r (in M) with the spin's sense."""
    return (1 + spin * r**-1.5) / math.sqrt(1 - 3 / r + 2 * spin * r**-1.5)


def seen(mass, spin, used):
    """A ray to the disc: its radius in M, its energy shift by kerrz, and by the formula of an orbit about a hole of the spin used."""
    metric = KerrMetric(mass, spin * mass)
    ray = NullGeodesic.from_impact_parameters(metric, -8 * mass, 0.5 * mass, FourVector(r=FAR * mass, theta=TILT))
    hit = ray.trace_to_angle(math.pi / 2).to_four_vec()
    r = hit.r / mass
    turning = 8 * math.sin(TILT) / (r**1.5 + used)      # Omega times the light's angular momentum over its energy, towards us
    return r, ray.energyshift(REST, hit, circular_orbit_velocity(metric, hit.r)), 1 / on_orbit(r, used) / (1 - turning)


exact, isco = last_stable(0.9), {}
for mass in (1, 2, 0.5):
    metric = KerrMetric(mass, 0.9 * mass)
    isco[mass], horizon = metric.isco / mass, metric.horizon_radius / mass
    radius, shift, formula = seen(mass, 0.9, 0.9)
    print(f"M = {mass}, a = 0.9 M: isco {isco[mass]:.4f} M, exact {exact:.4f} M; horizon {horizon:.4f} M, a ray meets the disc at {radius:.12f} M")
    note(f"horizon and rays, M = {mass}", abs(horizon - 1 - math.sqrt(1 - 0.81)) < 1e-12 and abs(radius - seen(1, 0.9, 0.9)[0]) < 1e-11)
    note(f"redshift, M = {mass}", abs(shift / formula - 1) < 1e-12)
note("isco", abs(isco[1] - exact) < 1e-12 and abs(isco[2] - 3.9200) < 1e-3 and abs(isco[0.5] + 0.8774) < 1e-3)

metric, r = KerrMetric(2, 1.8), 2.75
velocity = circular_orbit_velocity(metric, 2 * r)
print(f"M = 2, r = {r} M: u^t {velocity.t:.4f}, u^r {velocity.r:.4f}; of a circular orbit {on_orbit(r, 0.9):.4f} and 0")
note("orbits", velocity.r < -0.1 and abs(velocity.t / on_orbit(r, 0.9) - 1.0553) < 1e-3)
ends = {}
for mass in (1, 2):
    table = CunninghamTransferFunctionTable(KerrMetric(mass, 0.9 * mass), FourVector(r=1e4, theta=TILT), r_max=50.0 * mass)
    ends[mass] = [table.interpolate_disc_coordinates(at * mass, 0.3).energyshift for at in (2.5, 3.0, 3.5)]
    print(f"M = {mass}: energy shifts in the table at 2.5, 3 and 3.5 M", *(f"{value:.5f}" for value in ends[mass]))
note("tables", len(set(ends[1])) == 3 and len(set(ends[2])) == 1)

for spin in (0.0, -1e-4, 5e-4):
    print(f"a = {spin}: stored as {KerrMetric(1, spin).a}, isco {KerrMetric(1, spin).isco:.6f} M")
    note(f"spin {spin}", KerrMetric(1, spin).a == 1e-3 and abs(KerrMetric(1, spin).isco - last_stable(1e-3)) < 1e-9)
    note("a spin of 0.002", KerrMetric(1, 2e-3).a == 2e-3)
_, shift, still = seen(1, 0.0, 0.0)
_, _, turning = seen(1, 0.0, 1e-3)
print(f"redshift at a = 0: kerrz {shift:.12f}, of Schwarzschild {still:.12f}, of a = 0.001 {turning:.12f}")
note("Schwarzschild", abs(shift / still - 1) > 5e-6 and abs(shift / turning - 1) < 1e-12)
note("the calculator", "2.320883" in pathlib.Path("mass.txt").read_text() and "6.000000" in pathlib.Path("spin.txt").read_text())
sys.exit(f"changed: {', '.join(changed)}" if changed else 0)
PYTHON
