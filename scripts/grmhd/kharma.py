"""Dumps (.phdf) and restarts (.rhdf) of KHARMA, as Parthenon writes them: blocks of one or more levels, in coordinates that the input text names."""
import math

import numpy as np

from .charts import Spherical, fmks_theta, mks_theta, theta_itself
from .common import ELECTRON_INDEX, INDEX, PROTON_INDEX, SPIN, Flow, Parameters, asked, chosen_electrons, fail
from .mesh import Mesh

VERSIONS = (None, 2, 3, 4)          # of Info's OutputFormatVersion; None: the file has none
NAMES = ("prims.rho", "prims.u", "prims.uvec 1", "prims.uvec 2", "prims.uvec 3", "B 1", "B 2", "B 3")
TRANSFORMS = {"null": "null", "none": "null", "exponential": "eks", "exp": "eks", "eks": "eks", "modified": "mks", "mks": "mks",
              "funky": "fmks", "fmks": "fmks", "superexponential": "superexp", "superexp": "superexp", "widepole": "wks", "wks": "wks"}


def is_of(file):
    return file.has("Input@File") or file.has("Info@OutputFormatVersion") or file.has("Info@NumMeshBlocks")


def radius_and_theta(text):
    """Of the transform's name and its parameters; and the last x2."""
    word = text.word("coordinates", "transform")
    kind = TRANSFORMS.get(word)
    if kind is None:
        fail(f"{text.path}: {text.where}: transform in <coordinates> is {word[:40]!r}; allowed: {', '.join(TRANSFORMS)}")
    def number(key, usual, least=-math.inf, most=math.inf, allowed=None):
        return text.number("coordinates", key, least, most, allowed, usual)
    if kind == "null":
        return (lambda x1: x1 + 0.0), theta_itself, math.pi
    if kind == "eks":
        return np.exp, theta_itself, math.pi
    if kind == "superexp":
        corner, power, factor = math.log(number("r_br", 1000, 1e-3, 1e9)), number("npow", 1, 1, 10), number("cpow", 4, 0, 100)
        return (lambda x1: np.exp(x1 + factor * np.maximum(x1 - corner, 0) ** power)), theta_itself, math.pi
    if kind == "wks":
        linear, width = number("lin_frac", 0.6, 1e-6, 1), number("smoothness", -1)
        width = width if width > 0 else 0.02
        def theta(x1, x2):
            return 0.5 * math.pi * (1 + 2 * linear * (x2 - 0.5) + (1 - linear) * (np.tanh((x2 - 1) / width) + np.tanh(x2 / width))) + 0 * x1
        return np.exp, theta, 1
    hslope = number("hslope", 0.3, 1e-6, 2 - 1e-6, "between 0 and 2, where theta grows with X2")
    if kind == "mks":
        return np.exp, mks_theta(hslope), 1
    alpha = number("poly_alpha", 14, 2, 200)
    if alpha % 2:
        fail(f"{text.path}: {text.where}: poly_alpha in <coordinates> is {alpha:g}; allowed: an even number, of which powers of negative numbers are known")
    start = number("fmks_zero_point", text.number("parthenon/mesh", "x1min"))
    return np.exp, fmks_theta(hslope, number("mks_smooth", 0.5, 0, 100), number("poly_xt", 0.82, 1e-3, 100), alpha, start), 1


class Layout:
    """How the arrays of this version lie, and which of their cells are ghosts."""

    def __init__(self, file):
        self.file = file
        version = int(file.number("Info@OutputFormatVersion")) if file.has("Info@OutputFormatVersion") else None
        if version not in VERSIONS:
            fail(f"{file.path}: Info attribute OutputFormatVersion is {version}; allowed: none, 2, 3, 4")
        self.version = version
        self.blocks = int(file.number("Info@NumMeshBlocks", 1, 1 << 24))
        self.cells = [int(n) for n in file.array("Info@MeshBlockSize", (3,), integers=True)]
        ghosts = int(file.number("Info@NGhost", 0, 16)) if file.has("Info@IncludesGhost") and file.number("Info@IncludesGhost") else 0
        if min(self.cells) < 1 or any(1 < n <= 2 * ghosts for n in self.cells):
            fail(f"{file.path}: Info attribute MeshBlockSize is {self.cells}, of which {ghosts} cells at each side are ghosts; allowed: more")
        self.ghosts = [ghosts if n > 1 else 0 for n in self.cells]

    def inner(self, axis):
        return slice(self.ghosts[axis], self.cells[axis] - self.ghosts[axis])

    def faces(self):
        sides = []
        for axis, name in enumerate("xyz"):
            face = self.file.array(f"Locations/{name}", (self.blocks, self.cells[axis] + 1)).astype(float)
            sides.append(face[:, self.ghosts[axis]:self.cells[axis] + 1 - self.ghosts[axis]])
        return [tuple(side[block] for side in sides) for block in range(self.blocks)]

    def scalar(self, name):
        """(block, k, j, i) without ghosts."""
        sides = tuple(self.cells[::-1])
        shape = {None: (self.blocks, *sides, 1), 2: (self.blocks, 1, *sides)}.get(self.version, (self.blocks, *sides))
        array = self.file.array(name, shape)
        array = array[..., 0] if self.version is None else array[:, 0] if self.version == 2 else array
        return self.cut(array)

    def vector(self, name):
        sides = tuple(self.cells[::-1])
        array = self.file.array(name, (self.blocks, *sides, 3) if self.version is None else (self.blocks, 3, *sides))
        return [self.cut(array[..., axis] if self.version is None else array[:, axis]) for axis in range(3)]

    def cut(self, array):
        return array[:, self.inner(2), self.inner(1), self.inner(0)]


def field(file, layout, chart, spin, faces):
    """B^i: prims.B, or cons.B of flux_ct over sqrt(-g)."""
    if file.has("prims.B"):
        return layout.vector("prims.B"), lambda block, values: values
    if not file.has("cons.B"):
        fail(f"{file.path}: the file has no prims.B, and no cons.B of flux_ct" + (" (cons.fB, of face_ct, is not read)" if file.has("cons.fB") else ""))
    def divided(block, values):
        x1, x2 = (0.5 * (face[1:] + face[:-1]) for face in faces[block][:2])
        volume = chart.volume(x1[:, None, None], x2[None, :, None], spin)
        return values[:5] + [value / volume for value in values[5:8]] + values[8:]
    return layout.vector("cons.B"), divided


def read(file, wanted):
    if not file.has("Input@File"):
        fail(f"{file.path}: it looks like a file of Parthenon, but has no attribute Input/File")
    text = Parameters(file.path, file.text("Input@File"), "Input/File")
    if not (text.has("coordinates") and text.has("GRMHD")):
        fail(f"{file.path}: it is a file of Parthenon, but not of KHARMA: its input text has no <coordinates> and <GRMHD>")
    base = text.word("coordinates", "base")
    if base not in ("spherical_ks", "ks"):
        fail(f"{file.path}: Input/File: base in <coordinates> is {base[:40]!r}; allowed: spherical_ks, ks")
    spin = asked(file.path, wanted, "spin", "the spin", text.number("coordinates", "a", *SPIN))
    gamma = asked(file.path, wanted, "adiabatic_index", "the adiabatic index", text.number("GRMHD", "gamma", *INDEX))
    radius, theta, last = radius_and_theta(text)
    chart = Spherical(radius, theta)
    layout = Layout(file)
    faces = layout.faces()
    levels = file.array("Levels", (layout.blocks,), integers=True)
    mesh = Mesh(file.path, faces, levels, None, turn=True)
    domain = file.array("Info@RootGridDomain", (9,)).astype(float)
    for axis in range(3):
        mesh.check_span(axis, *domain[3 * axis:3 * axis + 2], "Info attribute RootGridDomain")
    check_coordinates(file.path, chart, mesh, last)
    electrons = chosen_electrons(file.path, wanted, sorted(name[6:] for name in file.names if name.startswith("prims.Kel_") and "@" not in name))
    vector, of_block = field(file, layout, chart, spin, faces)
    arrays = [layout.scalar("prims.rho"), layout.scalar("prims.u"), *layout.vector("prims.uvec"), *vector]
    if electrons:
        arrays.append(layout.scalar(f"prims.{electrons}"))
    mesh.fetch = lambda block: of_block(block, [array[block].transpose(2, 1, 0) for array in arrays])
    cold = mesh.check_numbers(NAMES + (electrons,), lambda block: True, "it")
    indices = [text.number("electrons", key, *INDEX, usual) for key, usual in (("gamma_e", ELECTRON_INDEX), ("gamma_p", PROTON_INDEX))]
    return Flow(file.path, spin, gamma, chart, mesh, "entropy" if electrons else "", *indices,
                notes=[f"the energy prims.u is below 0 in {cold} cells, and counts as 0 there"] if cold else [], unused=file.unused())


def check_coordinates(path, chart, mesh, last):
    """That all of the domain is where r and theta grow, and theta from 0 to pi."""
    first, end = mesh.span(1)
    if first < -1e-4 or end > last + 1e-4:
        fail(f"{path}: the cells go from X2 = {first:.6g} to {end:.6g}; allowed: 0 to {last:.6g}, as the transform has it")
    low, high = mesh.span(0)
    places = np.linspace(low, high, 257)
    with np.errstate(over="ignore"):
        r = chart.radius(places)
    if not (np.isfinite(r).all() and (np.diff(r) > 0).all() and r[0] > 0 and r[-1] < 1e9):
        fail(f"{path}: r goes from {r[0]:.6g} to {r[-1]:.6g} M over the cells; allowed: growing from above 0 to below 1e9")
    for x1 in (low, high):
        theta = chart.theta(x1, np.linspace(max(first, 0), min(end, last), 257))
        if not (np.isfinite(theta).all() and (np.diff(theta) > 0).all() and theta[0] > -1e-6 and theta[-1] < math.pi + 1e-6):
            fail(f"{path}: theta goes from {theta[0]:.6g} to {theta[-1]:.6g} rad at r = {chart.radius(x1):.4g} M; allowed: growing from 0 to pi")
