#!/usr/bin/env bash
# yt 4.4.3, an Athena++ snapshot (.athdf) whose Coordinates are "kerr-schild".
#
# Guessed: refused, as "gr_user" is, or read with a word that the metric (whose spin the file does not hold) is not applied; and no derived field
# that needs a metric.
# Seen: without a word about it (its warnings are of units alone), r, theta and phi are taken as flat spherical coordinates, and Athena++'s
# components, which are on the coordinate basis here (u^i relative to the normal observer, B^i), as orthonormal, as those of "spherical_polar" are:
#   volumes lack the factor 1 + a^2 cos^2(theta) / r^2 of sqrt(-g): at a = 0.9375, 26 % too small in the innermost cell next to the pole
#       (r = 1.57), 5 % between r = 1.5 and 3 altogether;
#   velocity_magnitude adds the squares of u^r, u^theta and u^phi without g_ij: some r times too small for what orbits, 23 times at r = 23;
#   magnetic_field_strength and magnetic_energy_density do so with B^i: the energy of a toroidal field is 78 times too small at r = 9.7 and 480 times
#       at r = 23.
# So the plasma's beta and the magnetisation of a disc, and every mean weighted by volume, are wrong, with a wrong slope in r.
# Who looks at such a snapshot in yt keeps to the stored fields, and computes the others with the metric as derived fields of his own.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet yt==4.4.3 h5py==3.16.0 numpy==2.4.6
cd "$folder"
venv/bin/python - <<'PYTHON'
import sys

import h5py
import numpy as np
import yt

SPIN, CELLS = 0.9375, (32, 16, 8)
EDGES = [np.geomspace(1.5, 24, CELLS[0] + 1), np.linspace(0, np.pi, CELLS[1] + 1), np.linspace(0, 2 * np.pi, CELLS[2] + 1)]   # units of M
VARIABLES = ["rho", "press", "vel1", "vel2", "vel3", "Bcc1", "Bcc2", "Bcc3"]
yt.set_log_level("warning")


def write(name, coordinates):
    """One block of gas of uniform density with u^phi = B^phi = r^-1.5 as stored."""
    around = np.broadcast_to((0.5 * (EDGES[0][1:] + EDGES[0][:-1])) ** -1.5, CELLS[::-1])
    prim, field = np.zeros((5, 1, *CELLS[::-1]), "f4"), np.zeros((3, 1, *CELLS[::-1]), "f4")
    prim[0], prim[1], prim[4], field[2] = 1, 0.01, around, around
    with h5py.File(name, "w") as file:
        file.attrs.update({"NumCycles": np.int32(0), "Time": 0.0, "Coordinates": np.bytes_(coordinates), "NumMeshBlocks": np.int32(1),
                           "MaxLevel": np.int32(0), "RootGridSize": np.int32(CELLS), "MeshBlockSize": np.int32(CELLS),
                           "NumVariables": np.int32([5, 3]), "DatasetNames": np.array(["prim", "B"], "S21"),
                           "VariableNames": np.array(VARIABLES, "S21")})
        for axis, edges in enumerate(EDGES, 1):
            file.attrs[f"RootGridX{axis}"] = np.array([edges[0], edges[-1], (edges[2] - edges[1]) / (edges[1] - edges[0])])
            file[f"x{axis}f"] = edges[None].astype("f4")
            file[f"x{axis}v"] = 0.5 * (edges[1:] + edges[:-1])[None].astype("f4")
        file["Levels"], file["LogicalLocations"] = np.zeros(1, "i4"), np.zeros((1, 3), "i8")
        file["prim"], file["B"] = prim, field


def read(name):
    """Of every cell: r, theta, and yt's volume, speed, field strength and magnetic energy density."""
    data = yt.load(name).all_data()
    return [np.array(data[key]) for key in (("index", "r"), ("index", "theta"), ("gas", "volume"), ("gas", "velocity_magnitude"),
                                            ("gas", "magnetic_field_strength"), ("gas", "magnetic_energy_density"))]


write("hole.athdf", "kerr-schild")
write("flat.athdf", "spherical_polar")
hole, flat = read("hole.athdf"), read("flat.athdf")
same = all(np.array_equal(*pair) for pair in zip(hole, flat))
print("every field equals that of the same numbers in flat space:", same)

r, theta, volume, speed, strength, energy = hole
# The integral of sqrt(-g) = (r^2 + a^2 cos^2 theta) sin theta over each cell.
low = [np.array([edges[np.searchsorted(edges, value) - 1] for value in at]) for edges, at in ((EDGES[0], r), (EDGES[1], theta))]
high = [np.array([edges[np.searchsorted(edges, value)] for value in at]) for edges, at in ((EDGES[0], r), (EDGES[1], theta))]
cosines = np.cos(low[1]), np.cos(high[1])
round_ = 2 * np.pi / CELLS[2]
own = round_ * ((high[0] ** 3 - low[0] ** 3) / 3 * (cosines[0] - cosines[1]) + SPIN**2 * (high[0] - low[0]) * (cosines[0] ** 3 - cosines[1] ** 3) / 3)
# Of a velocity and a field around the axis: squares of their sizes for the normal observer.
sigma = r**2 + SPIN**2 * np.cos(theta) ** 2
g_phi = (r**2 + SPIN**2 + 2 * r * SPIN**2 * np.sin(theta) ** 2 / sigma) * np.sin(theta) ** 2
lapse_squared = 1 / (1 + 2 * r / sigma)
stored = r**-1.5
exact_speed, exact_energy = np.sqrt(g_phi) * stored, 0.5 * lapse_squared * g_phi * stored**2

near = r < 3
missing = 1 - volume[near].sum() / own[near].sum()
first = np.lexsort((theta, r))[0]
print(f"volume, 1.5 < r < 3: yt {volume[near].sum():.2f}, with sqrt(-g) {own[near].sum():.2f}, {100 * missing:.1f} % missing; "
      f"in the cell at r = {r[first]:.2f} next to the pole {100 * (1 - volume[first] / own[first]):.1f} %")
factors = {}
for radius in (3, 10, 24):
    cell = np.argmin(abs(np.log(r / radius)) + abs(theta - np.pi / 2))
    factors[radius] = exact_speed[cell] / speed[cell], exact_energy[cell] / energy[cell]
    print(f"equator, r = {r[cell]:5.2f}: speed (u relative to the normal observer) yt {speed[cell]:.4f}, with the metric {exact_speed[cell]:.4f}; "
          f"energy of the field yt {energy[cell]:.3g}, with the metric {exact_energy[cell]:.3g}, {factors[radius][1]:.3g} times more")
as_stored = np.allclose(speed, stored, rtol=1e-5) and np.allclose(strength, stored, rtol=1e-5) and np.allclose(energy, stored**2 / 2, rtol=1e-5)
apart = abs(missing - 0.0528) < 1e-3 and factors[10][0] > 8 and factors[24][0] > 20 and factors[10][1] > 60
try:
    write("user.athdf", "gr_user")
    read("user.athdf")
    refused = False
except KeyError as error:
    print("gr_user: KeyError", error)
    refused = True
sys.exit(0 if same and as_stored and apart and refused else "changed: yt no longer reads such snapshots as flat space")
PYTHON
