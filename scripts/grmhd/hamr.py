"""H-AMR's regular grid in HDF5: flat datasets, attributes at the root; x2 from -1 to 1. What public readers disagree on is asked for."""
import numpy as np

from .charts import Spherical, mks_theta
from .common import INDEX, SPIN, Flow, asked, chosen_electrons, fail
from .iharm import check_logarithms, check_theta
from .mesh import slabs

NAMES = ("RHO", "UU", "U1", "U2", "U3", "B1", "B2", "B3")
SAME = 1e-4                         # of places: relative for r, rad for theta


def is_of(file):
    return file.has("@dscale")


def checked(file, mesh, chart, shape, formula):
    """The formula of r and theta against the file's own r and h, which must be there where readers disagree on it."""
    for name, of_chart, scaled in (("r", lambda x1, x2: chart.radius(x1) + 0 * x2, True), ("h", chart.theta, False)):
        if not file.has(name):
            if formula:
                fail(f"{file.path}: {formula}, on which readers of this format disagree, and the file has no {name} to tell")
            continue
        known = file.array(name, (shape[0] * shape[1] * shape[2],)).reshape(shape)[:, :, 0]
        x1 = np.concatenate([mesh.middles(block, 0) for block in range(len(mesh.faces))])
        here = of_chart(x1[:, None], mesh.middles(0, 1)[None, :])
        if not (np.abs(here - known) <= SAME * (here if scaled else 1)).all():
            fail(f"{file.path}: its dataset {name} is not that of its attributes startx, dx, R0 and hslope")


def read(file, wanted):
    if wanted.field_has_lapse is None:
        fail(f"{file.path}: the file does not hold whether its B1, B2, B3 are *F^it times the lapse; needed: --field-has-lapse yes or no")
    shape = tuple(int(file.number(f"@{name}", least, 1 << 20)) for name, least in (("N1", 2), ("N2", 2), ("N3", 1)))
    spin = asked(file.path, wanted, "spin", "the spin", file.number("@a", *SPIN))
    gamma = asked(file.path, wanted, "adiabatic_index", "the adiabatic index", file.number("@gam", *INDEX))
    chosen_electrons(file.path, wanted, [])
    inner = file.number("@R0", -1e3, 1e3) if file.has("@R0") else 0.0
    hslope = file.number("@hslope", 1e-6, 2 - 1e-6, "between 0 and 2, where theta grows with x2") if file.has("@hslope") else 1.0
    step = file.array("@dx", (3,)).astype(float)
    start = file.array("@startx", (3,)).astype(float) - step / 2       # startx: the first cell's middle
    if not (np.isfinite(start).all() and np.isfinite(step).all() and (step > 0).all()):
        fail(f"{file.path}: attributes startx and dx are {start + step / 2} and {step}; allowed: finite, dx above 0")
    ends = start + step * shape
    check_logarithms(file.path, start[0], ends[0])
    if start[1] < -1 - 1e-4 or ends[1] > 1 + 1e-4:
        fail(f"{file.path}: the cells go from x2 = {start[1]:.6g} to {ends[1]:.6g} (attributes startx, dx); allowed: -1 to 1")
    if np.exp(start[0]) + inner <= 0:
        fail(f"{file.path}: attribute R0 is {inner:g}, and r of the first cell below 0")
    theta = mks_theta(hslope)
    chart = Spherical(lambda x1: np.exp(x1) + inner, lambda x1, x2: theta(x1, 0.5 * (1 + x2)))
    mesh = slabs(file.path, start, step, [file.array(name, (shape[0] * shape[1] * shape[2],)).reshape(shape) for name in NAMES], turn=True)
    checked(file, mesh, chart, shape, f"R0 is {inner:g} and hslope {hslope:g}" if inner or hslope != 1 else "")
    check_theta(file.path, chart, mesh, "attributes startx, dx, hslope")
    if wanted.field_has_lapse == "yes":
        whole = mesh.fetch
        def fetch(block):
            values = list(whole(block))
            x1, x2 = mesh.middles(block, 0)[:, None, None], mesh.middles(block, 1)[None, :, None]
            r = chart.radius(x1)
            lapse = 1 / np.sqrt(1 + 2 * r / (r * r + (spin * np.cos(chart.theta(x1, x2))) ** 2))
            return values[:5] + [value / lapse for value in values[5:8]]
        mesh.fetch = fetch
    cold = mesh.check_numbers(NAMES, lambda block: True, "it")
    return Flow(file.path, spin, gamma, chart, mesh, unused=file.unused(),
                notes=[f"the energy UU is below 0 in {cold} cells, and counts as 0 there"] if cold else [])
