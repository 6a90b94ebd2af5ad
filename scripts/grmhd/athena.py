"""HDF5 output of Athena++ (.athdf), in Kerr and Schild's r, theta, phi or x, y, z, and AthenaK's output converted to it."""
import math

import numpy as np

from .athenak import cartesian_flow, known_text
from .athenak import NAMES as NAMES_K
from .charts import Spherical, theta_itself
from .common import Flow, Parameters, asked, chosen_electrons, fail, words_of
from .mesh import Mesh

NAMES = ("rho", "press", "vel1", "vel2", "vel3", "Bcc1", "Bcc2", "Bcc3")
CARTESIAN = "cartesian-kerr-schild"


def is_of(file):
    return file.has("@NumMeshBlocks") or file.has("@MeshBlockSize") or file.has("@VariableNames")


def variables(file, names, blocks, cells):
    """Of each name the array (block, k, j, i), and the names of those that are not used."""
    datasets = words_of(file.value("@DatasetNames"))
    counts = [int(n) for n in file.array("@NumVariables", (len(datasets),), integers=True)]
    known, all_names = {}, words_of(file.value("@VariableNames"))
    if sum(counts) != len(all_names) or min(counts, default=0) < 0:
        fail(f"{file.path}: attribute NumVariables counts {sum(counts)} variables, but VariableNames has {len(all_names)}")
    for dataset, count in zip(datasets, counts):
        for number in range(count):
            known.setdefault(all_names[len(known)], (dataset, number, count))
    missing = [name for name in names if name not in known]
    if missing:
        fail(f"{file.path}: attribute VariableNames has no {', '.join(missing)}, but {', '.join(all_names)}; allowed: {', '.join(names)}, and others")
    arrays = {}
    for name in names:
        dataset, number, count = known[name]
        if dataset not in arrays:
            arrays[dataset] = file.array(dataset, (count, blocks, *cells[::-1]))
            if arrays[dataset].dtype.kind != "f":
                fail(f"{file.path}: {dataset} is of {arrays[dataset].dtype}; allowed: floating-point numbers (scaled whole ones cannot be turned back)")
    return [arrays[known[name][0]][known[name][1]] for name in names], [f"variable {name}" for name in all_names if name not in names]


def read_faces(file, blocks, cells):
    """Of the blocks, and how many of the cells at each side are ghosts: those beyond the domain's start."""
    sides = [file.array(f"x{axis + 1}f", (blocks, cells[axis] + 1)).astype(float) for axis in range(3)]
    domain = [file.array(f"@RootGridX{axis}", (3,)).astype(float) for axis in (1, 2, 3)]
    lowest = sides[0][np.argmin(sides[0][:, 0])]
    ghosts = int((lowest < domain[0][0] - 0.5 * np.diff(lowest).min()).sum())
    ghosts = [ghosts if n > 1 else 0 for n in cells]
    if any(n <= 2 * g for n, g in zip(cells, ghosts)):
        fail(f"{file.path}: x1f begins {ghosts[0]} cells before attribute RootGridX1, {domain[0][0]:g}, of blocks of {cells[0]} cells")
    sides = [side[:, g:side.shape[1] - g] for side, g in zip(sides, ghosts)]
    return [tuple(side[block] for side in sides) for block in range(blocks)], ghosts, domain


def read(file, wanted):
    blocks = int(file.number("@NumMeshBlocks", 1, 1 << 24))
    cells = [int(n) for n in file.array("@MeshBlockSize", (3,), integers=True)]
    if min(cells) < 1 or max(cells) > 1 << 20:
        fail(f"{file.path}: attribute MeshBlockSize is {cells}; allowed: 1 and more")
    coordinates, converted = file.text("@Coordinates"), file.has("@Header")
    known_coordinates(file.path, wanted, coordinates, converted)
    names = NAMES_K if converted else NAMES
    faces, ghosts, domain = read_faces(file, blocks, cells)
    levels = file.array("Levels", (blocks,), integers=True)
    arrays, others = variables(file, names, blocks, cells)
    chosen_electrons(file.path, wanted, [])
    for axis, ghost in enumerate(ghosts):
        if ghost:
            arrays = [np.moveaxis(np.moveaxis(array, 3 - axis, 0)[ghost:-ghost], 0, 3 - axis) for array in arrays]
    if converted:
        lines = words_of(file.value("@Header"))
        spin, gamma = known_text(file.path, Parameters(file.path, "\n".join(lines), "attribute Header"), wanted)
        length = 1.0
    else:
        spin = asked(file.path, wanted, "spin", "the spin")
        gamma = asked(file.path, wanted, "adiabatic_index", "the adiabatic index")
        length = asked(file.path, wanted, "code_mass", "the hole's mass m of the input's <coord> (mostly 1)")
    spherical = coordinates == "kerr-schild"
    def fetch(block):
        values = [array[block].transpose(2, 1, 0) for array in arrays]
        return values if converted else [values[0], values[1] / (gamma - 1)] + values[2:]
    mesh = Mesh(file.path, faces, levels, fetch, turn=spherical)
    for axis in range(3):
        mesh.check_span(axis, *domain[axis][:2], f"attribute RootGridX{axis + 1}")
    if not spherical:
        return cartesian_flow(file.path, spin, gamma, mesh, names, file.unused() + others, length=length)
    (first, _), (low, high) = mesh.span(0), mesh.span(1)
    if first <= 0 or low < -1e-4 or high > math.pi + 1e-4:
        fail(f"{file.path}: the cells go from r = {first:.6g}, and from theta = {low:.6g} to {high:.6g}; allowed: above 0, and 0 to pi")
    chart = Spherical(lambda x1: x1 / length, theta_itself, plain=True, length=length)
    cold = mesh.check_numbers(names, lambda block: True, "it")
    return Flow(file.path, spin, gamma, chart, mesh, unused=file.unused() + others,
                notes=[f"the pressure is below 0 in {cold} cells, and counts as 0 there"] if cold else [])


def known_coordinates(path, wanted, coordinates, converted):
    if converted:
        allowed = coordinates == "cartesian"
        needed = "cartesian, of files with an attribute Header (AthenaK's)"
    else:
        allowed = coordinates == "kerr-schild" or coordinates == "gr_user" and wanted.coordinates == CARTESIAN
        needed = f"kerr-schild, and gr_user with --coordinates {CARTESIAN} where they are that"
    if not allowed:
        fail(f"{path}: attribute Coordinates is {coordinates[:40]!r}; allowed: {needed}")
    if wanted.coordinates and (converted or coordinates != "gr_user"):
        fail(f"{path}: the file holds its coordinates, {coordinates}; --coordinates is for those of gr_user")
