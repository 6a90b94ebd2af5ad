#!/usr/bin/env bash
# EinsteinPy 0.5.0, einsteinpy.rays.Shadow(mass, n_rays, fov): a mass with astropy's unit kg, a field of view in km.
#
# Guessed: the mass becomes a length, GM/c^2, so that for the Sun's mass impact parameters begin at 3 sqrt(3) times 1.4766 km = 7.67 km; rays pass the hole
# at the turning points of the same mass.
# Seen: without a word,
#   the number of kilograms is taken as GM/c^2 in kilometres: for the Sun's mass impact parameters go from 1.03e31 down to 30, and of 5 rays none is left;
#   turning points are those of the mass whose fraction is cut: of 1.9 kg the critical ray, b = 9.87, turns at r = 8.66, which is that of M = 1, instead of
#       at 3 M = 5.7, while b begins at 3 sqrt(3) 1.9;
#   of 50 impact parameters between the critical one and 30, 7 are kept for M = 1, those whose root the search happens to find.
# Who draws with it gives a whole number of "kg", the wanted GM/c^2 in the field's km, and looks at how many rays are left.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet einsteinpy==0.5.0 astropy==8.0.2 numpy==2.4.6 scipy==1.17.1
cd "$folder"
venv/bin/python -W ignore - <<'PYTHON'
import sys

import astropy.units as u
import numpy as np
from astropy.constants import GM_sun, M_sun, c
from einsteinpy.rays import Shadow


def turning_point(b, m):
    """Of a ray with impact parameter b about a mass m, both lengths: r^3 = b^2 (r - 2 m)."""
    return max(np.roots([1, 0, -b * b, 2 * m * b * b]).real)


changed = []
sun, length_km = Shadow(M_sun, 5, 30 * u.km), (GM_sun / c**2).to(u.km).value
print(f"Sun: impact parameters from {sun.b[0]:.4g}, expected {3 * 3**0.5 * length_km:.4g} km; {len(sun.z)} rays are left")
if abs(sun.b[0] / (3 * 3**0.5 * M_sun.value) - 1) > 1e-6 or len(sun.z) != 0:
    changed.append("the Sun's mass")
for mass in (1.0, 1.9, 2.0):
    shadow = Shadow(mass * u.kg, 50, 30 * u.km)
    for b, r in shadow.z:
        if abs(r - turning_point(b, int(mass))) > 1e-6:
            changed.append(f"a turning point of {mass}")
    b, r = shadow.z[0]
    print(f"{mass} kg: {len(shadow.z)} of 50 rays; b = {b:.4f} turns at {r:.4f}, expected {turning_point(b, mass):.4f}, of {int(mass)}: "
          f"{turning_point(b, int(mass)):.4f}")
    if len(shadow.z) >= 25:
        changed.append(f"the number of rays of {mass}")
print("changed:", changed or "nothing")
sys.exit(bool(changed))
PYTHON
