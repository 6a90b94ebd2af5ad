"""KORAL's HDF5 output for other programs (version KORALv2): places in grid_out, vectors of Kerr and Schild's r, theta, phi, big-endian."""
import math

import numpy as np

from .charts import Spherical, tabled
from .common import INDEX, POSITIVE, SPIN, Flow, asked, chosen_electrons, fail
from .iharm import check_theta
from .mesh import slabs

NAMES = tuple(f"quants/{name}" for name in ("rho", "uint", "U1", "U2", "U3", "B1", "B2", "B3"))
SAME = 1e-5                         # of places: relative for r, rad for angles


def is_of(file):
    return file.has("grid_out/r") or any(name.startswith("quants/") for name in file.names)


def places(file, shape):
    """r of i, theta of (i, j), and the first azimuth and their step."""
    r, theta, phi = (file.array(f"grid_out/{name}", shape).astype(float) for name in ("r", "th", "ph"))
    r_i, theta_ij, phi_k = r[:, :1, :1], theta[:, :, :1], phi[:1, :1, :]
    even = phi_k[0, 0, 0] + np.arange(shape[2]) * (phi_k[0, 0, -1] - phi_k[0, 0, 0]) / max(shape[2] - 1, 1)
    with np.errstate(invalid="ignore"):
        for name, here, known, scale in (("r", r, r_i, np.abs(r_i)), ("th", theta, theta_ij, 1), ("ph", phi, even, 1)):
            if not (np.abs(here - known) <= SAME * scale).all():
                fail(f"{file.path}: grid_out/{name} is not finite or not of a grid in r(i), th(i, j), ph(k), with even steps of ph")
    r_i, theta_ij = r_i[:, 0, 0], theta_ij[:, :, 0]
    if not (r_i[0] > 0 and (np.diff(r_i) > 0).all() and (np.diff(theta_ij, axis=1) > 0).all()):
        fail(f"{file.path}: grid_out/r or grid_out/th do not grow")
    step = 2 * math.pi if shape[2] == 1 else even[1] - even[0]
    if not step > 0:
        fail(f"{file.path}: grid_out/ph does not grow")
    return r_i, theta_ij, even[0], step


def read(file, wanted):
    version = file.text("header/version")
    if version != "KORALv2":
        fail(f"{file.path}: header/version is {version[:40]!r}; allowed: KORALv2")
    metric = file.text("header/metric_out").upper()
    if metric != "KS":
        fail(f"{file.path}: header/metric_out is {metric[:40]!r}; allowed: KS")
    shape = tuple(int(file.number(f"header/{name}", least, 1 << 20)) for name, least in (("n1", 2), ("n2", 2), ("n3", 1)))
    spin = asked(file.path, wanted, "spin", "the spin", file.number("header/bhspin", *SPIN))
    gamma = asked(file.path, wanted, "adiabatic_index", "the adiabatic index", file.number("header/gam", *INDEX))
    electrons = chosen_electrons(file.path, wanted, ["te"] if file.has("quants/te") else [])
    names = NAMES + (("quants/te",) if electrons else ())
    r, theta, phi, step = places(file, shape)
    chart = Spherical(*tabled(np.log(r), theta), plain=True)
    mesh = slabs(file.path, (0, 0, phi - step / 2), (1, 1, step), [file.array(name, shape) for name in names], turn=True)
    check_theta(file.path, chart, mesh, "grid_out/th")
    cold = mesh.check_numbers(names, lambda block: True, "it")
    unit = file.number("header/units/M_unit", *POSITIVE) if file.has("header/units/M_unit") else 0      # a density, for all its name
    return Flow(file.path, spin, gamma, chart, mesh, "kelvin" if electrons else "", density_unit=unit, unused=file.unused(),
                notes=[f"the energy uint is below 0 in {cold} cells, and counts as 0 there"] if cold else [])
