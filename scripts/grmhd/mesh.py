"""Blocks of cells, of one or more levels of refinement, as one field that is linear between the middles of cells.

Each block gets one layer of cells around it from its neighbours: the neighbour's own cell on the same level, the mean of the cells of a finer one, what
is interpolated in a coarser one. Where the domain ends the last cell is repeated.
"""
import functools
import math

import numpy as np

from .common import Progress, fail

MOST_PLACES = 1 << 26       # boxes between all edges of blocks
DEEPEST = 60                # level
ROUNDED = 1e-9              # of a cell: a place that is a middle but for rounding is the middle
SLAB = 1 << 17              # cells of a slab
KEPT = 1 << 19              # cells of blocks with their surroundings, where finer ones may need them again


class Around:
    """A block with a layer of cells around it. values (number, i, j, k); x: of middles, three arrays, which repeat the last cell's where the domain
    ends; present: along each axis, the first and one past the last of these that may be interpolated between."""

    def __init__(self, values, x, present):
        self.values, self.x, self.present = values, x, present

    def at(self, points, ruler=lambda axis, x: x):
        """Counted in cells along each axis."""
        found = []
        for axis, ((first, last), point) in enumerate(zip(self.present, points)):
            middles = ruler(axis, self.x[axis][first:last])
            found.append(first + np.interp(ruler(axis, point), middles, np.arange(last - first)))
        return found


def trilinear(values, at, weights=None):
    """Of arrays (i, j, k) at places counted in cells: (number, place). weights: of the cells; then also whether any counted, and only those count."""
    at = [np.where(np.abs(place - np.rint(place)) < ROUNDED, np.rint(place), place) for place in at]
    low = [np.clip(np.floor(place).astype(int), 0, max(side - 2, 0)) for place, side in zip(at, values[0].shape)]
    part = [place - first for place, first in zip(at, low)]
    total, weight = np.zeros((len(values), len(at[0]))), np.zeros(len(at[0]))
    for corner in np.ndindex(2, 2, 2):
        index = tuple(np.minimum(first + one, side - 1) for first, one, side in zip(low, corner, values[0].shape))
        share = math.prod(p if one else 1 - p for one, p in zip(corner, part))
        if weights is not None:
            share = share * weights[index]
            weight += share
        if isinstance(values, np.ndarray):
            total += share * values[(slice(None), *index)]
            continue
        for number, value in enumerate(values):
            total[number] += share * value[index]
    return total if weights is None else (total / np.where(weight > 0, weight, 1), weight > 0)


class Mesh:
    """faces: of each block three growing arrays; levels; fetch(block): arrays (i, j, k), one for each number. turn: the third axis goes all round. offsets:
    of each block's first cell, where all blocks are parts of one array."""

    def __init__(self, path, faces, levels, fetch, turn=False, offsets=None):
        self.path, self.faces, self.levels, self.fetch, self.turn, self.offsets = path, faces, np.asarray(levels), fetch, turn, offsets
        if self.levels.min() < 0 or self.levels.max() > DEEPEST:
            fail(f"{path}: its levels go from {self.levels.min()} to {self.levels.max()}; allowed: 0 to {DEEPEST}")
        self.edges, spans = [], []
        for axis in range(3):
            ends = np.array([[block[axis][0], block[axis][-1]] for block in faces], dtype=float)
            if not np.isfinite(ends).all() or not all((np.diff(block[axis]) > 0).all() for block in faces):
                fail(f"{path}: its cells' edges along x{axis + 1} do not grow")
            known = np.unique(ends)
            edges = known[np.append(True, np.diff(known) > 1e-3 * (ends[:, 1] - ends[:, 0]).min())]
            self.edges.append(edges)
            spans.append(np.clip(np.searchsorted(0.5 * (edges[1:] + edges[:-1]), ends), 0, len(edges) - 1))
        self.fill(spans)
        largest = max(math.prod(len(face) for face in block) for block in faces)
        self.around = functools.lru_cache(max(8, KEPT // largest) if np.ptp(self.levels) else 1)(self.make_around)

    def fill(self, spans):
        shape = tuple(len(edges) - 1 for edges in self.edges)
        if min(shape) < 1 or math.prod(shape) > MOST_PLACES:
            fail(f"{self.path}: its {len(self.faces)} blocks have {' x '.join(map(str, shape))} places; allowed: at most {MOST_PLACES}")
        self.owner = np.full(shape, -1, dtype=np.int32)
        filled = 0
        for block in range(len(self.faces)):
            place = tuple(slice(*spans[axis][block]) for axis in range(3))
            self.owner[place] = block
            filled += self.owner[place].size
        if filled != self.owner.size or (self.owner < 0).any():
            wrong = "overlap" if filled > self.owner.size else "leave gaps: is a block or the file of a rank missing?"
            fail(f"{self.path}: its {len(self.faces)} blocks {wrong}")

    def span(self, axis):
        return self.edges[axis][0], self.edges[axis][-1]

    def check_span(self, axis, low, high, what):
        """The domain that the file tells, against that of its cells."""
        first, last = self.span(axis)
        if max(abs(first - low), abs(last - high)) > 1e-4 * (last - first):
            fail(f"{self.path}: its blocks go from x{axis + 1} = {first:.6g} to {last:.6g}, but {what} has {low:.6g} to {high:.6g}")

    def wrapped(self, points):
        if not self.turn:
            return points
        first, last = self.span(2)
        return [points[0], points[1], first + np.mod(points[2] - first, last - first)]

    def locate(self, points):
        """Which block holds each place."""
        return self.owner[tuple(np.clip(np.searchsorted(edges, point, side="right") - 1, 0, len(edges) - 2) for edges, point in zip(self.edges, points))]

    def middles(self, block, axis):
        face = self.faces[block][axis]
        return 0.5 * (face[1:] + face[:-1])

    def make_around(self, block):
        own = self.fetch(block)
        x, present = [], []
        for axis, face in enumerate(self.faces[block]):
            width, middles, (first, last) = np.diff(face), self.middles(block, axis), self.span(axis)
            before, after = (width[0] ** 2 / width[1], width[-1] ** 2 / width[-2]) if len(width) > 1 else (width[0], width[0])   # even or geometric
            around_all = self.turn and axis == 2
            low, high = (around_all or abs(face[end] - whole) > 1e-3 * width[end] for end, whole in ((0, first), (-1, last)))
            x.append(np.concatenate([[face[0] - 0.5 * before if low else middles[0]], middles, [face[-1] + 0.5 * after if high else middles[-1]]]))
            present.append((0 if low else 1, len(middles) + (2 if high else 1)))
        values = np.empty((len(own),) + tuple(len(side) for side in x))
        for number, value in enumerate(own):
            values[number, 1:-1, 1:-1, 1:-1] = value
        shell = np.ones(values.shape[1:], dtype=bool)
        shell[1:-1, 1:-1, 1:-1] = False
        index = np.nonzero(shell)
        points = self.wrapped([side[i] for side, i in zip(x, index)])
        owners = self.locate(points)
        for owner in np.unique(owners):
            here = owners == owner
            values[(slice(None),) + tuple(i[here] for i in index)] = self.of_neighbour(owner, [point[here] for point in points], self.levels[block])
        return Around(values, x, present)

    def of_neighbour(self, block, points, level):
        if self.levels[block] < level:
            coarse = self.around(int(block))
            return trilinear(coarse.values, coarse.at(points))
        values, faces = self.fetch(block), self.faces[block]
        if self.levels[block] == level:
            index = tuple(np.clip(np.searchsorted(face, point, side="right") - 1, 0, len(face) - 2) for face, point in zip(faces, points))
            return np.stack([np.asarray(value[index], dtype=float) for value in values])
        at = [np.interp(point, self.middles(block, axis), np.arange(len(faces[axis]) - 1)) for axis, point in enumerate(points)]
        return trilinear(values, at)

    def cell(self, block, index):
        """How a message names a cell."""
        if self.offsets is None:
            return f"cell {tuple(map(int, index))} of block {block}"
        return f"cell {tuple(int(i + j) for i, j in zip(index, self.offsets[block]))}"

    def check_numbers(self, names, kept, what):
        """Finite numbers, and densities of 0 and above, in cells that are kept(block), and how many energies are below 0."""
        cold, progress = 0, Progress("cells checked", len(self.faces))
        for block in range(len(self.faces)):
            values, inside = self.fetch(block), kept(block)
            for name, value in zip(names, values):
                wrong = np.argwhere(~np.isfinite(value) & inside)
                if len(wrong):
                    fail(f"{self.path}: {what} has numbers that are not finite: {name} of {self.cell(block, wrong[0])}, in {len(wrong)} cells")
            low = np.argwhere((values[0] < 0) & inside)
            if len(low):
                fail(f"{self.path}: {what} has densities below 0: {names[0]} of {self.cell(block, low[0])}, in {len(low)} cells; allowed: 0 and above")
            cold += int(((values[1] < 0) & inside).sum())
            progress.at(block)
        return cold


def slabs(path, start, step, arrays, turn):
    """Of arrays (i, j, k) of even cells: a mesh of parts along the first axis, so that little of it is in use at a time."""
    shape = arrays[0].shape
    thick = max(SLAB // max(shape[1] * shape[2], 1), 2)
    cuts = list(range(0, shape[0], thick)) + [shape[0]]
    if len(cuts) > 2 and cuts[-1] - cuts[-2] < 2:
        del cuts[-2]
    others = [start[axis] + np.arange(shape[axis] + 1) * step[axis] for axis in (1, 2)]
    faces = [(start[0] + np.arange(first, last + 1) * step[0], *others) for first, last in zip(cuts, cuts[1:])]
    return Mesh(path, faces, [0] * len(faces), lambda block: [array[cuts[block]:cuts[block + 1]] for array in arrays], turn,
                [(cut, 0, 0) for cut in cuts[:-1]])
