"""Dumps of iharm3d's layout: one array of cells that are even in X1, X2, X3 of MKS or FMKS."""
import math

import numpy as np

from .charts import Spherical, fmks_theta, mks_theta
from .common import ELECTRON_INDEX, INDEX, POSITIVE, PROTON_INDEX, SPIN, Flow, asked, chosen_electrons, fail, words_of
from .mesh import slabs

PRIMITIVES = ("RHO", "UU", "U1", "U2", "U3", "B1", "B2", "B3")
FARTHEST = 1e7                                  # M, of the cells


def is_of(file):
    return file.has("prims") and any(name.startswith("header/") for name in file.names)


def primitives(file, wanted):
    """Of all that the file has, those that are used, in their order; the names of the others; the electrons' one."""
    prims = file.array("prims")
    if prims.ndim != 4 or prims.shape[3] < 8 or min(prims.shape[:3]) < 1 or min(prims.shape[:2]) < 2:
        fail(f"{file.path}: prims has the shape {prims.shape}; allowed: (n1, n2, n3, 8 or more), n1 and n2 at least 2")
    for axis, name in enumerate(("n1", "n2", "n3")):
        if file.has(f"header/{name}") and file.number(f"header/{name}") != prims.shape[axis]:
            fail(f"{file.path}: header/{name} is {file.number(f'header/{name}'):g}, but prims has the shape {prims.shape}; allowed: {prims.shape[axis]}")
    if file.has("header/n_prim"):
        file.number("header/n_prim", 8, prims.shape[3], f"8 to {prims.shape[3]}, the last side of prims")
    at, others, names = list(range(8)), [f"number {n}" for n in range(8, prims.shape[3])], []
    if file.has("header/prim_names"):
        names = [name.upper() for name in words_of(file.value("header/prim_names"))][:prims.shape[3]]
        missing = [name for name in PRIMITIVES if name not in names]
        if missing:
            fail(f"{file.path}: header/prim_names has no {', '.join(missing)}; allowed: {', '.join(PRIMITIVES)}, and others")
        at = [names.index(name) for name in PRIMITIVES]
        others = [name for name in names if name not in PRIMITIVES] + others[max(len(names) - 8, 0):]
    electrons = chosen_electrons(file.path, wanted, [name for name in others if name.startswith("KEL")])
    if electrons:
        at.append(names.index(electrons))
        others.remove(electrons)
    return [prims[..., number] for number in at], others, electrons


def coordinates(file, start, shape, step):
    """The chart, and the spin."""
    metric = file.text("header/metric").upper()
    if metric == "MMKS":
        metric = "FMKS"
    if metric not in ("MKS", "FMKS"):
        fail(f"{file.path}: header/metric is {metric}; allowed: MKS, FMKS, MMKS")
    if file.has("header/has_derefine_poles") and file.number("header/has_derefine_poles"):
        fail(f"{file.path}: its cells near the poles are joined (header/has_derefine_poles), which is not read")
    folders = ("fmks", "mmks", "mks") if metric == "FMKS" else ("mks", "mmks", "fmks")
    folder = next((f"header/geom/{name}/" for name in folders if file.has(f"header/geom/{name}/a")), None)
    if folder is None:
        fail(f"{file.path}: the header has no {' or '.join(f'geom/{name}/a' for name in folders)}")
    spin = file.number(folder + "a", *SPIN)
    hslope = file.number(folder + "hslope", 1e-6, 2 - 1e-6, "between 0 and 2, where theta grows with X2")
    theta = mks_theta(hslope)
    if metric == "FMKS":
        smooth, xt = file.number(folder + "mks_smooth", 0, 100), file.number(folder + "poly_xt", 1e-3, 100)
        theta = fmks_theta(hslope, smooth, xt, even(file.path, folder + "poly_alpha", file.number(folder + "poly_alpha", 2, 200)), start[0])
    for name, end in (("r_in", 0), ("Rin", 0), ("r_out", 1), ("Rout", 1)):
        if file.has(folder + name):
            check_end(file, folder + name, math.exp(min(start[0] + end * shape[0] * step[0], 100)))
    return Spherical(np.exp, theta), spin, metric


def even(path, name, alpha):
    if alpha % 2:
        fail(f"{path}: {name} is {alpha:g}; allowed: an even number, of which powers of negative numbers are known")
    return alpha


def check_end(file, name, cells):
    if abs(file.number(name) / cells - 1) > 0.01:
        fail(f"{file.path}: {name} is {file.number(name):g}, but by geom/startx1 and geom/dx1 it is {cells:.6g} M; allowed: X1 is the logarithm of r")


def check_logarithms(path, first, last):
    if not (-20 < first and last < math.log(FARTHEST)):
        fail(f"{path}: the cells go from X1 = {first:.6g} to {last:.6g}; allowed: logarithms of r in M, up to {math.log(FARTHEST):.4g}")


def check_theta(path, chart, mesh, where):
    """Of the cells' middles, at the first and last radius."""
    for block in (0, len(mesh.faces) - 1):
        for x1 in mesh.middles(block, 0)[[0, -1]]:
            theta = chart.theta(x1, mesh.middles(block, 1))
            if not (np.isfinite(theta).all() and (np.diff(theta) > 0).all() and theta[0] > 0 and theta[-1] < math.pi):
                fail(f"{path}: theta goes from {theta[0]:.6g} to {theta[-1]:.6g} rad at r = {chart.radius(x1):.4g} M; allowed: growing from 0 to pi ({where})")


def read(file, wanted):
    arrays, others, electrons = primitives(file, wanted)
    shape = arrays[0].shape
    start = [file.number(f"header/geom/startx{i}") for i in (1, 2, 3)]
    step = [file.number(f"header/geom/dx{i}", 1e-12, 1e6, "above 0") for i in (1, 2, 3)]
    chart, spin, metric = coordinates(file, start, shape, step)
    asked(file.path, wanted, "spin", "the spin", spin)
    gamma = asked(file.path, wanted, "adiabatic_index", "the adiabatic index", file.number("header/gam", *INDEX))
    indices = [file.number(f"header/{name}", *INDEX) if file.has(f"header/{name}") else usual
               for name, usual in (("gam_e", ELECTRON_INDEX), ("gam_p", PROTON_INDEX))]
    ends = [(start[axis], start[axis] + shape[axis] * step[axis]) for axis in range(3)]
    check_logarithms(file.path, *ends[0])
    if not (ends[1][0] > -1e-4 and ends[1][1] < 1 + 1e-4):
        fail(f"{file.path}: the cells go from X2 = {ends[1][0]:.6g} to {ends[1][1]:.6g} (header/geom/startx2, dx2); allowed: 0 to 1, as {metric} has it")
    mesh = slabs(file.path, start, step, arrays, turn=True)
    check_theta(file.path, chart, mesh, "header/geom")
    cold = mesh.check_numbers(PRIMITIVES + (electrons,), lambda block: True, "prims")
    notes = [f"the energy UU is below 0 in {cold} cells, and counts as 0 there"] if cold else []
    if any(name.startswith(("KEL", "KTOT")) for name in others) and not electrons:
        notes.append("electron entropies are not used: temperatures follow from --r-high and --r-low")
    unit = file.number("header/units/RHO_unit", *POSITIVE) if file.has("header/units/RHO_unit") else 0    # ebhlight's
    return Flow(file.path, spin, gamma, chart, mesh, "entropy" if electrons else "", *indices, unit, notes=notes,
                unused=file.unused() + [f"prims {name}" for name in others])
