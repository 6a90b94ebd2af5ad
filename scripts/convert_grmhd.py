#!/usr/bin/env python3
"""Makes a grid of matter (medium.file, docs/matter.md) from a GRMHD dump of iharm3d's layout in HDF5. Needs NumPy and h5py.

    scripts/convert_grmhd.py dump.h5 -o flow.grid --density-unit 1e-18

Dumps have density, internal energy, velocity and field in units of the hole's mass M (G = c = 1) at the middles of cells that are even in X1 =
ln r, X2, X3 = phi of Kerr and Schild's coordinates, MKS or FMKS (header/metric). --density-unit, in g/cm^3, is what density 1 stands for: a
simulation does not know it, and it is found from the flux at one frequency; medium.density_scale changes it later. The electrons'
temperature follows from the gas's by R = (R_high beta^2 + R_low)/(1 + beta^2), beta the ratio of the gas's pressure to the field's
(Moscibrodzka, Falcke and Shiokawa 2016). Matter whose magnetization B^2/rho is above --sigma-cut has no density: simulations add gas there for
their own stability.

A dump whose spin is negative is turned by half a turn about the x axis, so that the hole turns eastward: theta becomes 180 - theta, phi
becomes -phi. A line says so, and what the camera of a scene needs then. Velocity and field are changed to the frames that the file wants: of
the zero-angular-momentum observer (ZAMO), and of the matter. The file's head keeps the command and the dump's SHA-256.
"""
import argparse
import hashlib
import math
import os
import shlex
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


PRIMITIVES = ("RHO", "UU", "U1", "U2", "U3", "B1", "B2", "B3")
FARTHEST = 1e7                                  # M, of the cells
LONGEST_NOTE = 1000                             # bytes of a line of the file's head

# What codes write into their files, by which a file of theirs is known.
OTHER_CODES = (("KHARMA or another code of Parthenon", lambda file: "Info" in file or "Params" in file or "Input" in file),
               ("Athena++", lambda file: "NumMeshBlocks" in file.attrs or "MeshBlockSize" in file.attrs),
               ("KORAL", lambda file: "quants" in file or "grid_out" in file),
               ("HARMPI, H-AMR or another code without a group header", lambda file: "prims" not in file and "header" not in file))


def said(text):
    print(f"convert_grmhd: {text}", file=sys.stderr)


def text_of(value):
    """What stands in a text of HDF5, however it is stored."""
    value = np.asarray(value).reshape(-1)
    word = value[0] if value.size == 1 else ""
    return (word.decode("utf-8", "replace") if isinstance(word, bytes) else str(word)).strip("\0 ")


class File:
    """The datasets and attributes of a dump, and which of them were asked for."""

    def __init__(self, path):
        self.path, self.items, self.used = path, {}, set()
        try:
            import h5py
        except ImportError:
            fail("needs h5py (pip install h5py)")
        try:
            with open(path, "rb") as file:
                start = file.read(64)
        except OSError as error:
            fail(f"{path}: no dump: {error.strerror}")
        if start.startswith(b"Athena binary output"):
            fail(f"{path}: no dump of iharm3d's layout: it is AthenaK's binary output, which is not read")
        if not h5py.is_hdf5(path):
            fail(f"{path}: no dump of iharm3d's layout: it is no HDF5 file")
        try:
            with h5py.File(path, "r") as file:
                self.code_of(file)
                self.read(file, h5py)
        except (OSError, KeyError, RuntimeError, ValueError, TypeError):
            fail(f"{path}: no dump of iharm3d's layout: its HDF5 cannot be read: it is cut short or damaged, or packed by a filter that is not installed")

    def code_of(self, file):
        if "prims" in file and "header" in file:
            return
        known = next((name for name, is_of in OTHER_CODES if is_of(file)), None)
        missing = " and ".join(name for name in ("prims", "header") if name not in file)
        fail(f"{self.path}: no dump of iharm3d's layout: "
             + (f"it looks like a file of {known}, which is not read" if known else f"it has no {missing}")
             + "; allowed: a dataset prims and a group header")

    def read(self, file, h5py):
        for name, value in file.attrs.items():
            self.items[f"attribute {name}"] = value
        def add(name, item):
            for key, value in item.attrs.items():
                self.items[f"attribute {name}/{key}"] = value
            if isinstance(item, h5py.Dataset):
                self.items[name] = item[()] if name.startswith("header/") else None
        file.visititems(add)
        prims = file["prims"]
        if not isinstance(prims, h5py.Dataset) or prims.dtype.kind not in "fiu":
            fail(f"{self.path}: prims is no dataset of numbers")
        self.prims = np.asarray(prims[()], dtype=np.float64)
        self.used.add("prims")

    def has(self, name):
        return f"header/{name}" in self.items

    def take(self, name):
        if not self.has(name):
            fail(f"{self.path}: the header has no {name}")
        self.used.add(f"header/{name}")
        return self.items[f"header/{name}"]

    def number(self, name, least=-math.inf, most=math.inf, allowed=None):
        """Of the header; as a scalar or an array of one."""
        value = np.asarray(self.take(name))
        if value.size != 1 or value.dtype.kind not in "fiub":
            fail(f"{self.path}: header/{name} is no single number (shape {value.shape}, {value.dtype}); allowed: one number")
        value = float(value.reshape(-1)[0])
        if not (math.isfinite(value) and least <= value <= most):
            fail(f"{self.path}: header/{name} is {value:g}; allowed: {allowed or f'{least:g} to {most:g}'}")
        return value

    def unused(self):
        return sorted(name for name in self.items if name not in self.used)


class Dump:
    """Density, energy, velocity and field of a dump, and its coordinates: lengths in M."""

    def __init__(self, path):
        file = self.file = File(path)
        self.path = path
        self.primitives(file)
        self.coordinates(file)
        self.check_cells(file)
        self.check_numbers()
        count = self.prims.shape[2]
        times = round(2 * math.pi / (count * self.step[2]))
        if times < 1 or abs(times * count * self.step[2] - 2 * math.pi) > 1e-3:
            fail(f"{path}: the cells go through {count * self.step[2]:.6g} rad of phi; allowed: a whole part of a turn")
        self.prims = np.tile(self.prims, (1, 1, times, 1))   # of a wedge: all round
        self.turned = self.a < 0
        if self.turned:
            self.turn()

    def primitives(self, file):
        """Of all that the file has, those that are used, in their order."""
        prims = file.prims
        if prims.ndim != 4 or prims.shape[3] < 8 or min(prims.shape[:3]) < 1 or min(prims.shape[:2]) < 2:
            fail(f"{self.path}: prims has the shape {prims.shape}; allowed: (n1, n2, n3, 8 or more), n1 and n2 at least 2")
        for axis, name in enumerate(("n1", "n2", "n3")):
            if file.has(name) and file.number(name) != prims.shape[axis]:
                fail(f"{self.path}: header/{name} is {file.number(name):g}, but prims has the shape {prims.shape}; allowed: {prims.shape[axis]}")
        if file.has("n_prim"):
            file.number("n_prim", 8, prims.shape[3], f"8 to {prims.shape[3]}, the last side of prims")
        at, others = list(range(8)), [f"number {n}" for n in range(8, prims.shape[3])]
        if file.has("prim_names"):
            names = [text_of(name).upper() for name in np.asarray(file.take("prim_names")).reshape(-1)]
            missing = [name for name in PRIMITIVES if name not in names[:prims.shape[3]]]
            if missing:
                fail(f"{self.path}: header/prim_names has no {', '.join(missing)}; allowed: {', '.join(PRIMITIVES)}, and others")
            at = [names.index(name) for name in PRIMITIVES]
            others = [name for name in names if name not in PRIMITIVES] + others[max(len(names) - 8, 0):]
        self.prims, self.others = prims[..., at], others

    def coordinates(self, file):
        self.metric = text_of(file.take("metric")).upper()
        if self.metric == "MMKS":
            self.metric = "FMKS"
        if self.metric not in ("MKS", "FMKS"):
            fail(f"{self.path}: header/metric is {self.metric}; allowed: MKS, FMKS, MMKS")
        if file.has("has_derefine_poles") and file.number("has_derefine_poles"):
            fail(f"{self.path}: its cells near the poles are joined (header/has_derefine_poles), which is not read")
        folders = ("fmks", "mmks", "mks") if self.metric == "FMKS" else ("mks", "mmks", "fmks")
        folder = next((f"geom/{name}/" for name in folders if file.has(f"geom/{name}/a")), None)
        if folder is None:
            fail(f"{self.path}: the header has no {' or '.join(f'geom/{name}/a' for name in folders)}")
        self.a = file.number(folder + "a", math.nextafter(-1, 0), math.nextafter(1, 0), "between -1 and 1")
        self.hslope = file.number(folder + "hslope", 1e-6, 2 - 1e-6, "between 0 and 2, where theta grows with X2")
        self.start = [file.number(f"geom/startx{i}") for i in (1, 2, 3)]
        self.step = [file.number(f"geom/dx{i}", 1e-12, 1e6, "above 0") for i in (1, 2, 3)]
        self.gamma = file.number("gam", 1 + 1e-6, 3, "above 1, up to 3")
        self.electron_index, self.proton_index = (file.number(name, 1 + 1e-6, 3, "above 1, up to 3") if file.has(name) else usual for name, usual in
                                                  (("gam_e", ELECTRON_INDEX), ("gam_p", PROTON_INDEX)))
        if self.metric == "FMKS":
            self.smooth = file.number(folder + "mks_smooth", 0, 100)
            self.xt = file.number(folder + "poly_xt", 1e-3, 100)
            self.alpha = file.number(folder + "poly_alpha", 2, 200)
            if self.alpha % 2:
                fail(f"{self.path}: header/{folder}poly_alpha is {self.alpha:g}; allowed: an even number, of which powers of negative numbers are known")
        for name, axis_end in (("r_in", 0), ("Rin", 0), ("r_out", 1), ("Rout", 1)):
            if file.has(folder + name):
                self.check_end(file, folder + name, math.exp(min(self.start[0] + axis_end * file.prims.shape[0] * self.step[0], 100)))

    def check_end(self, file, name, cells):
        if abs(file.number(name) / cells - 1) > 0.01:
            fail(f"{self.path}: header/{name} is {file.number(name):g}, but by geom/startx1 and geom/dx1 it is {cells:.6g} M; allowed: X1 is the logarithm of r")

    def check_cells(self, file):
        ends = [self.start[axis] + np.array([0, self.prims.shape[axis]]) * self.step[axis] for axis in range(3)]
        if not (-20 < ends[0][0] and ends[0][1] < math.log(FARTHEST)):
            fail(f"{self.path}: the cells go from X1 = {ends[0][0]:.6g} to {ends[0][1]:.6g}; allowed: logarithms of r in M, up to {math.log(FARTHEST):.4g}")
        if not (ends[1][0] > -1e-4 and ends[1][1] < 1 + 1e-4):
            fail(f"{self.path}: the cells go from X2 = {ends[1][0]:.6g} to {ends[1][1]:.6g} (header/geom/startx2, dx2); allowed: 0 to 1, as {self.metric} has it")
        for x1 in self.middles(0)[[0, -1]]:
            theta = self.theta(x1, self.middles(1))
            if not (np.isfinite(theta).all() and (np.diff(theta) > 0).all() and theta[0] > 0 and theta[-1] < math.pi):
                fail(f"{self.path}: theta goes from {theta[0]:.6g} to {theta[-1]:.6g} rad at r = {math.exp(x1):.4g} M; allowed: growing from 0 to pi "
                     "(header/geom)")

    def check_numbers(self):
        for number, name in enumerate(PRIMITIVES):
            wrong = np.argwhere(~np.isfinite(self.prims[..., number]))
            if len(wrong):
                fail(f"{self.path}: prims has numbers that are not finite: {name} of cell {tuple(map(int, wrong[0]))}, in {len(wrong)} cells")
        low = np.argwhere(self.prims[..., 0] < 0)
        if len(low):
            fail(f"{self.path}: prims has densities below 0: RHO of cell {tuple(map(int, low[0]))}, in {len(low)} cells; allowed: 0 and above")
        cold = int((self.prims[..., 1] < 0).sum())
        if cold:
            said(f"{self.path}: the energy UU is below 0 in {cold} cells, and counts as 0 there")

    def turn(self):
        """By half a turn about the x axis: the hole turns eastward, the file knows no other. theta -> pi - theta, phi -> -phi."""
        for axis, whole in ((1, 1.0), (2, 0.0)):
            self.start[axis] = whole - self.start[axis] - self.prims.shape[axis] * self.step[axis]
        self.a, self.prims = -self.a, self.prims[:, ::-1, ::-1].copy()
        self.prims[..., [3, 4, 6, 7]] *= -1

    def say_rest(self):
        names = self.file.unused() + [f"prims {name}" for name in self.others]
        if names:
            said(f"{self.path}: not used: {', '.join(names)}")
        if any(name.startswith(("KEL", "KTOT")) for name in self.others):
            said(f"{self.path}: electron entropies are not used: temperatures follow from --r-high and --r-low")
        if self.turned:
            said(f"{self.path}: the spin is below 0: all is turned by half a turn about the x axis. A camera at theta, phi of the dump is at "
                 "camera.theta = 180 - theta, camera.phi = -phi, with camera.roll = 180 more")

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


def note(text):
    """A line of the file's head: no control characters, and not too long."""
    line = text.encode("ascii", "backslashreplace").decode()
    line = "".join(c if c.isprintable() else "?" for c in line)
    return line if len(line) <= LONGEST_NOTE else line[:LONGEST_NOTE - 3] + "..."


def sha256(path):
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def write(path, spin, r, theta, phi, numbers, notes):
    """phi: of the first node."""
    head = (f"nullscope-medium 1\ncoordinates kerr-schild\nspin {spin:.17g}\nr {r[0]:.17g} {r[-1]:.17g} {len(r)}\n"
            f"theta {theta[0]:.17g} {theta[-1]:.17g} {len(theta)}\nphi {phi:.17g} {numbers.shape[2]}\n"
            + "".join(f"{key} {note(text)}\n" for key, text in notes) + "data\n")
    unfinished = f"{path}.part"
    try:
        with open(unfinished, "wb") as out:
            out.write(head.encode())
            out.write(np.ascontiguousarray(numbers, dtype="<f4").tobytes())
        os.replace(unfinished, path)
    except OSError as error:
        fail(f"{path}: {error.strerror}")


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
    phi = math.remainder(dump.middles(2)[0], 2 * math.pi)
    notes = (("converter", shlex.join(["convert_grmhd.py"] + sys.argv[1:])), ("source", f"sha256 {sha256(wanted.dump)} {os.path.basename(wanted.dump)}"))
    write(wanted.output, dump.a, r, theta, phi, grid, notes)
    dump.say_rest()
    print(f"{wanted.output}: {len(r)} x {len(theta)} x {grid.shape[2]} nodes from {r[0]:.4g} to {r[-1]:.4g} r_s, spin {dump.a:g}")


if __name__ == "__main__":
    main()
