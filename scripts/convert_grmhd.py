#!/usr/bin/env python3
"""Makes a grid of matter (medium.file, docs/matter.md) from a GRMHD dump of iharm3d's layout in HDF5. Needs NumPy and h5py.

    scripts/convert_grmhd.py dump.h5 -o flow.grid --density-unit 1e-18

Dumps have density, internal energy, velocity and field in units of the hole's mass M (G = c = 1) at the middles of cells that are even in X1 =
ln r, X2, X3 = phi of Kerr and Schild's coordinates, MKS or FMKS (header/metric). --density-unit, in g/cm^3, is what density 1 stands for: a
simulation does not know it, and it is found from the flux at one frequency; medium.density_scale changes it later. The electrons'
temperature follows from the gas's by R = (R_high beta^2 + R_low)/(1 + beta^2), beta the ratio of the gas's pressure to the field's
(Moscibrodzka, Falcke and Shiokawa 2016). Matter whose magnetization B^2/rho is above --sigma-cut has no density: simulations add gas there for
their own stability.

A dump whose spin is negative is mirrored, so that the hole turns eastward. Velocity and field are changed to the frames that the file wants: of
the zero-angular-momentum observer (ZAMO), and of the matter.
"""
import argparse
import math
import os
import sys

import numpy as np

GRAM_A_PROTON, ELECTRON_K, LIGHT = 1.67262192e-24, 5.92989658e9, 2.99792458e10   # m_p; m_e c^2/k; cm/s
PROTON_OVER_ELECTRON = 1836.15267
ELECTRON_INDEX, PROTON_INDEX = 4 / 3, 5 / 3    # adiabatic
NOTHING = 1e-30
HOTTEST_K = 9.9e13                              # the file may have 1e14
MOST_NODES, MOST_ROWS = 1 << 24, 256            # of a file; of theta, where --nodes does not say


def fail(text):
    sys.exit(f"convert_grmhd: {text}")


class Dump:
    """Density, energy, velocity and field of a dump, and its coordinates: lengths in M."""

    def __init__(self, path):
        import h5py
        try:
            with h5py.File(path, "r") as file:
                head = {}
                file["header"].visititems(lambda name, item: head.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
                self.prims = np.asarray(file["prims"], dtype=np.float64)
        except (OSError, KeyError) as error:
            fail(f"{path}: no dump of iharm3d's layout: {error}")
        metric = head.get("metric", b"MKS")
        self.metric = (metric.decode() if isinstance(metric, bytes) else str(metric)).upper()
        if self.metric == "MMKS":
            self.metric = "FMKS"
        if self.metric not in ("MKS", "FMKS"):
            fail(f"{path}: header/metric is {self.metric}; allowed: MKS, FMKS, MMKS")
        if head.get("has_derefine_poles", 0):
            fail(f"{path}: its cells near the poles are joined (header/has_derefine_poles), which is not read")
        folder = next((f"geom/{name}/" for name in (self.metric.lower(), "mmks", "mks") if f"geom/{name}/a" in head), None)
        if folder is None:
            fail(f"{path}: the header has no geom/mks/a or geom/mmks/a")
        try:
            self.a, self.hslope = float(head[folder + "a"]), float(head[folder + "hslope"])
            self.start = [float(head[f"geom/startx{i}"]) for i in (1, 2, 3)]
            self.step = [float(head[f"geom/dx{i}"]) for i in (1, 2, 3)]
            self.gamma = float(head["gam"])
            self.electron_index, self.proton_index = (float(head.get(name, usual)) for name, usual in
                                                      (("gam_e", ELECTRON_INDEX), ("gam_p", PROTON_INDEX)))
            if self.metric == "FMKS":
                self.smooth, self.xt, self.alpha = (float(head[folder + name]) for name in ("mks_smooth", "poly_xt", "poly_alpha"))
        except (KeyError, TypeError) as error:
            fail(f"{path}: the header has no {error}")
        if self.prims.ndim != 4 or self.prims.shape[3] < 8 or min(self.prims.shape[:3]) < 1 or min(self.prims.shape[:2]) < 2:
            fail(f"{path}: prims has the shape {self.prims.shape}; allowed: (n1, n2, n3, 8 or more)")
        if not abs(self.a) < 1:
            fail(f"{path}: the spin is {self.a}; allowed: between -1 and 1")
        times = round(2 * math.pi / (self.prims.shape[2] * self.step[2]))
        if times < 1 or abs(times * self.prims.shape[2] * self.step[2] - 2 * math.pi) > 1e-3:
            fail(f"{path}: the cells go through {self.prims.shape[2] * self.step[2]:.6g} rad of phi; allowed: a whole part of a turn")
        self.prims = np.tile(self.prims[..., :8], (1, 1, times, 1))   # of a wedge: all round
        if self.a < 0:   # seen in a mirror, the hole turns eastward: the file knows no other
            self.a, self.prims = -self.a, self.prims[:, :, ::-1].copy()
            self.prims[..., [4, 7]] *= -1
            self.start[2] *= -1
        if not np.isfinite(self.prims).all():
            fail(f"{path}: prims has numbers that are not finite")

    def horizon(self):
        return 1 + math.sqrt(1 - self.a ** 2)

    def middles(self, axis):
        return self.start[axis] + (np.arange(self.prims.shape[axis]) + 0.5) * self.step[axis]

    def theta(self, x1, x2):
        geometric = math.pi * x2 + 0.5 * (1 - self.hslope) * np.sin(2 * math.pi * x2)
        if self.metric == "MKS":
            return geometric + 0 * x1
        y = 2 * x2 - 1
        norm = 0.5 * math.pi / (1 + self.xt ** -self.alpha / (1 + self.alpha))
        straight = norm * y * (1 + (y / self.xt) ** self.alpha / (1 + self.alpha)) + 0.5 * math.pi
        return geometric + np.exp(self.smooth * (self.start[0] - x1)) * (straight - geometric)


def kerr_schild(r, theta, a):
    """Covariant metric of (t, r, theta, phi), M = 1; shape of r and theta + (4, 4)."""
    sine2 = np.sin(theta) ** 2
    sigma = r * r + a * a * np.cos(theta) ** 2
    pull = 2 * r / sigma
    g = np.zeros(np.broadcast(r, theta).shape + (4, 4))
    g[..., 0, 0] = pull - 1
    g[..., 0, 1] = g[..., 1, 0] = pull
    g[..., 0, 3] = g[..., 3, 0] = -pull * a * sine2
    g[..., 1, 1] = 1 + pull
    g[..., 1, 3] = g[..., 3, 1] = -(1 + pull) * a * sine2
    g[..., 2, 2] = sigma
    g[..., 3, 3] = sine2 * (sigma + a * a * (1 + pull) * sine2)
    return g


def fluid(dump):
    """u and b of the matter at the middles of the cells: contravariant, Kerr and Schild's coordinates."""
    x1, x2 = np.meshgrid(dump.middles(0), dump.middles(1), indexing="ij")
    r, theta = np.exp(x1), dump.theta(x1, x2)
    small = 1e-5
    jacobian = np.zeros(r.shape + (4, 4))   # d(t, r, theta, phi)/d(t, X1, X2, X3)
    jacobian[..., 0, 0] = jacobian[..., 3, 3] = 1
    jacobian[..., 1, 1] = r
    jacobian[..., 2, 1] = (dump.theta(x1 + small, x2) - dump.theta(x1 - small, x2)) / (2 * small)
    jacobian[..., 2, 2] = (dump.theta(x1, x2 + small) - dump.theta(x1, x2 - small)) / (2 * small)
    g = np.einsum("...ai,...ab,...bj->...ij", jacobian, kerr_schild(r, theta, dump.a), jacobian)[:, :, None]   # of X
    up = np.linalg.inv(g)
    lapse = 1 / np.sqrt(-up[..., 0, 0])
    velocity = np.zeros(dump.prims.shape[:3] + (4,))
    velocity[..., 1:] = dump.prims[..., 2:5]
    lorentz = np.sqrt(1 + np.einsum("...i,...ij,...j->...", velocity, g, velocity))
    u = velocity.copy()
    u[..., 0] = lorentz / lapse
    u[..., 1:] -= (lorentz * lapse)[..., None] * up[..., 0, 1:]
    field = np.zeros_like(u)
    field[..., 1:] = dump.prims[..., 5:8]
    b = np.zeros_like(u)
    b[..., 0] = np.einsum("...i,...ij,...j->...", field, g, u)
    b[..., 1:] = (field[..., 1:] + b[..., :1] * u[..., 1:]) / u[..., :1]
    to = jacobian[:, :, None]
    return r[..., None], theta[..., None], np.einsum("...ij,...j->...i", to, u), np.einsum("...ij,...j->...i", to, b)


def zamo_components(r, theta, a, vector):
    """Of a vector in Kerr and Schild's coordinates: along the zero-angular-momentum observer (ZAMO) and its e_r, e_theta, e_phi."""
    delta, sigma = r * r - 2 * r + a * a, r * r + a * a * np.cos(theta) ** 2
    area = (r * r + a * a) ** 2 - a * a * delta * np.sin(theta) ** 2
    t = vector[..., 0] - 2 * r / delta * vector[..., 1]            # Boyer and Lindquist's
    phi = vector[..., 3] - a / delta * vector[..., 1]
    return np.stack([np.sqrt(sigma * delta / area) * t, np.sqrt(sigma / delta) * vector[..., 1], np.sqrt(sigma) * vector[..., 2],
                     np.sqrt(area / sigma) * np.sin(theta) * (phi - 2 * a * r / area * t)], axis=-1)


def matter(dump, wanted):
    """The file's eight numbers, and the magnetization, at the middles of the cells outside the horizon; and the first of these along X1."""
    first = int(np.searchsorted(np.exp(dump.middles(0)), 1.01 * dump.horizon()))
    if dump.prims.shape[0] - first < 2:
        fail("the dump has no two cells outside the horizon")
    r, theta, u, b = (part[first:] for part in fluid(dump))
    rho, energy = np.maximum(dump.prims[first:, ..., 0], NOTHING), np.maximum(dump.prims[first:, ..., 1], NOTHING)
    u, b = zamo_components(r, theta, dump.a, u), zamo_components(r, theta, dump.a, b)
    rest = b[..., 1:] - u[..., 1:] * (b[..., :1] / (1 + u[..., :1]))       # boosted without a rotation
    field2 = np.maximum((rest * rest).sum(axis=-1), NOTHING)
    beta2 = ((dump.gamma - 1) * energy / (0.5 * field2)) ** 2
    ratio = (wanted.r_high * beta2 + wanted.r_low) / (1 + beta2)
    electron, proton = dump.electron_index - 1, dump.proton_index - 1
    heat = electron * proton / (electron * ratio + proton)
    out = np.empty(rho.shape + (9,))
    out[..., 0] = rho * wanted.density_unit / GRAM_A_PROTON
    out[..., 1] = np.clip(PROTON_OVER_ELECTRON * heat * energy / rho * ELECTRON_K, 0, HOTTEST_K)
    out[..., 8] = field2 / rho
    out[..., 2:5] = math.sqrt(4 * math.pi * wanted.density_unit) * LIGHT * rest
    out[..., 5:8] = u[..., 1:]
    return out, first


def between(values, at, logarithm):
    """Along the first axis, at places counted in cells; logarithm: of which of the last axis's numbers these are mixed."""
    low = np.clip(np.floor(at).astype(int), 0, values.shape[0] - 2)
    part = np.clip(at - low, 0, 1)
    shape = (-1,) + (1,) * (values.ndim - 1)
    values = values.copy()
    values[..., logarithm] = np.log(np.maximum(values[..., logarithm], NOTHING))
    mixed = values[low] * (1 - part.reshape(shape)) + values[low + 1] * part.reshape(shape)
    mixed[..., logarithm] = np.exp(mixed[..., logarithm])
    return mixed


def resampled(dump, numbers, first, wanted):
    """On even steps of ln r and theta; azimuths stay. Matter of too large a magnetization goes last: between cells it is not known."""
    x1, x2 = dump.middles(0)[first:], dump.middles(1)
    last = min(math.log(2 * wanted.outer), x1[-1])
    if last <= x1[0]:
        fail(f"--outer {wanted.outer} r_s is within the first cell; allowed: more than {0.5 * math.exp(x1[0]):.6g}")
    innermost = dump.theta(x1[0], x2)
    span, finest = innermost[-1] - innermost[0], np.diff(innermost).min()
    rings, rows = wanted.nodes or (160, int(min(MOST_ROWS, max(len(x2), math.ceil(span / finest) + 1))))
    if rings * rows * numbers.shape[2] > MOST_NODES:
        fail(f"{rings} x {rows} x {numbers.shape[2]} nodes; allowed: at most {MOST_NODES} (--nodes)")
    if span / (rows - 1) > 1.5 * finest:
        print(f"convert_grmhd: cells are up to {span / (rows - 1) / finest:.1f} times as fine in theta as the nodes (--nodes)", file=sys.stderr)
    places = np.linspace(x1[0], last, rings)
    thetas = np.linspace(innermost[0], innermost[-1], rows)
    logarithm = [0, 1, 8]
    # Next to the horizon the velocity along e_r is as 1/sqrt(1 - horizon/r).
    numbers = numbers.copy()
    numbers[..., 5] *= np.sqrt(1 - dump.horizon() * np.exp(-x1))[:, None, None]
    by_ring = between(numbers, (places - x1[0]) / dump.step[0], logarithm)
    by_ring[..., 5] /= np.sqrt(1 - dump.horizon() * np.exp(-places))[:, None, None]
    out = np.empty((rings, rows) + numbers.shape[2:])
    for i, x in enumerate(places):
        out[i] = between(by_ring[i], np.interp(thetas, dump.theta(x, x2), np.arange(len(x2))), logarithm)
    out[..., 0] = np.where(out[..., 8] > wanted.sigma_cut, 0, out[..., 0])
    return 0.5 * np.exp(places), thetas, out[..., :8]


def write(path, spin, r, theta, phi, numbers):
    """phi: of the first node."""
    head = (f"nullscope-medium 1\ncoordinates kerr-schild\nspin {spin:.17g}\nr {r[0]:.17g} {r[-1]:.17g} {len(r)}\n"
            f"theta {theta[0]:.17g} {theta[-1]:.17g} {len(theta)}\nphi {phi:.17g} {numbers.shape[2]}\ndata\n")
    unfinished = f"{path}.part"
    with open(unfinished, "wb") as out:
        out.write(head.encode())
        out.write(np.ascontiguousarray(numbers, dtype="<f4").tobytes())
    os.replace(unfinished, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("dump", help="HDF5 file of iharm3d's layout")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="the grid")
    parser.add_argument("--density-unit", type=float, required=True, metavar="G/CM3", help="what density 1 stands for")
    parser.add_argument("--r-high", type=float, default=40, help="ions' over electrons' temperature where the gas's pressure rules (40)")
    parser.add_argument("--r-low", type=float, default=1, help="and where the field's does (1)")
    parser.add_argument("--sigma-cut", type=float, default=1, help="largest magnetization of matter that is kept (1)")
    parser.add_argument("--outer", type=float, default=25, metavar="R_S", help="last radius, r_s (25)")
    parser.add_argument("--nodes", type=int, nargs=2, metavar=("R", "THETA"), help="along r and theta (160, and as fine as the cells, at most 256)")
    wanted = parser.parse_args()
    for name in ("density_unit", "r_high", "r_low", "sigma_cut", "outer"):
        if not getattr(wanted, name) > 0:
            fail(f"--{name.replace('_', '-')} {getattr(wanted, name)}; allowed: above 0")
    if wanted.nodes and not (2 <= wanted.nodes[0] <= 1024 and 2 <= wanted.nodes[1] <= 2048):
        fail("--nodes: allowed: 2 to 1024, 2 to 2048")
    dump = Dump(wanted.dump)
    if dump.prims.shape[2] > 256:
        fail(f"{dump.prims.shape[2]} cells around; allowed: at most 256")
    numbers, first = matter(dump, wanted)
    r, theta, grid = resampled(dump, numbers, first, wanted)
    write(wanted.output, dump.a, r, theta, dump.middles(2)[0], grid)
    print(f"{wanted.output}: {len(r)} x {len(theta)} x {grid.shape[2]} nodes from {r[0]:.4g} to {r[-1]:.4g} r_s, spin {dump.a:g}")


if __name__ == "__main__":
    main()
