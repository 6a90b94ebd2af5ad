"""The nodes of the grid's file, even in ln r, theta and phi, and the matter at them."""
import math

import numpy as np

from .charts import inverted
from .common import Progress, fail, said
from .matter import NOTHING, matter
from .mesh import trilinear

MOST_NODES, MOST_ROWS, MOST_AROUND = 1 << 24, 256, 256   # of a file; of theta and phi, where --nodes does not say
RINGS, CARTESIAN_ROWS = 160, 128
NEXT_TO_HORIZON = 1.01      # horizon radii, of the first node
CHUNK = 1 << 16             # nodes at a time


class SphericalNodes:
    """Of cells of r, theta, phi: rings from the first cell's middle outside the horizon, theta between the first and the last cell's, phi at cells'."""

    def __init__(self, flow, wanted):
        mesh, chart = self.mesh, self.chart = flow.mesh, flow.chart
        around = mesh.span(2)[1] - mesh.span(2)[0]
        times = round(2 * math.pi / around)
        if times < 1 or abs(times * around - 2 * math.pi) > 1e-3:
            fail(f"{flow.path}: the cells go through {around:.6g} rad of phi; allowed: a whole part of a turn")
        kinds = {tuple((face[axis][0], len(face[axis]), face[axis][-1]) for axis in range(3)): block for block, face in enumerate(mesh.faces)}
        blocks = {axis: list({kind[axis]: block for kind, block in kinds.items()}.values()) for axis in range(3)}
        middles = np.unique(np.concatenate([mesh.middles(block, 0) for block in blocks[0]]))
        radii = chart.radius(middles)
        outside = np.flatnonzero(radii >= NEXT_TO_HORIZON * flow.horizon)
        if len(outside) < 2:
            fail(f"{flow.path}: it has no two cells outside the horizon")
        first, last = radii[outside[0]], min(2 * wanted.outer, radii[-1])
        if last <= first:
            fail(f"--outer {wanted.outer} r_s is within the first cell; allowed: more than {0.5 * first:.6g}")
        rows = [chart.theta(middles[outside[0]], mesh.middles(block, 1)) for block in blocks[1]]
        low, high = min(row[0] for row in rows), max(row[-1] for row in rows)
        finest = min([np.diff(row).min() for row in rows if len(row) > 1] or [high - low])
        width = min(np.diff(mesh.faces[block][2]).min() for block in blocks[2])
        cells = max(1, round(2 * math.pi / width))
        rings, count, phis = wanted.nodes or (RINGS, int(min(MOST_ROWS, math.ceil((high - low) / finest - 1e-6) + 1)), min(cells, MOST_AROUND))
        phis = phis or min(cells, MOST_AROUND)
        self.count = (rings, count, phis)
        self.coarse = [(name, ratio) for name, ratio in (("theta", (high - low) / (count - 1) / finest), ("phi", cells / phis)) if ratio > 1.5]
        self.r = np.geomspace(first, last, rings)
        self.theta = np.linspace(low, high, count)
        self.phi = mesh.span(2)[0] + (np.arange(phis) + 0.5 * min(1, phis / cells)) * 2 * math.pi / phis
        self.x1 = inverted(chart.radius, *mesh.span(0), self.r)
        self.x2 = inverted(lambda x2: chart.theta(self.x1[:, None], x2), *mesh.span(1), np.broadcast_to(self.theta, (rings, count)))

    def native(self, i, j, k):
        return self.mesh.wrapped([self.x1[i], self.x2[i, j], self.phi[k]])


class CartesianNodes:
    """Of cells of x, y, z: rings from next to the horizon to the last that the cells hold whole, theta half a step off the poles."""

    def __init__(self, flow, wanted):
        self.chart, self.coarse = flow.chart, []
        ends = [[mesh_end(flow.mesh, axis, end) / flow.chart.length for end in (0, 1)] for axis in range(3)]
        if max(low for low, _ in ends) >= 0 or min(high for _, high in ends) <= 0:
            fail(f"{flow.path}: the hole is not within its cells")
        widest = min(min(-low, high) for low, high in ends)
        last = min(2 * wanted.outer, math.sqrt(max(widest ** 2 - flow.spin ** 2, 0)))
        first = NEXT_TO_HORIZON * flow.horizon
        if last <= first:
            fail(f"{flow.path}: no sphere about the hole beyond {first:.4g} M is within its cells and --outer {wanted.outer} r_s")
        rings, count, phis = wanted.nodes or (RINGS, CARTESIAN_ROWS, CARTESIAN_ROWS)
        self.count = (rings, count, phis or CARTESIAN_ROWS)
        self.r = np.geomspace(first, last, rings)
        self.theta = (np.arange(count) + 0.5) * math.pi / count
        self.phi = np.arange(self.count[2]) * 2 * math.pi / self.count[2]

    def native(self, i, j, k):
        return self.chart.place(self.r[i], self.theta[j], self.phi[k])


def mesh_end(mesh, axis, end):
    """The outermost middle of a cell."""
    edge = mesh.span(axis)[end]
    inset = min(np.diff(face[axis])[-end] for face in mesh.faces if abs(face[axis][-end] - edge) < 0.5 * np.diff(face[axis])[-end])
    return edge - inset / 2 if end else edge + inset / 2


def smooth_around(flow, block):
    """A block's cells and those around it as they are interpolated: logarithms of what is positive, vectors as the chart has them; weights where some
    cells hold nothing."""
    around = flow.mesh.around(block)
    x = np.meshgrid(*around.x, indexing="ij", sparse=True)
    values = around.values.copy()
    weights = None
    if flow.excised:
        weights = flow.chart.radius_of(x) > flow.excised
        values[:, ~weights] = 0
        weights = weights.astype(float)
    for first in (2, 5):
        values[first:first + 3] = flow.chart.smooth(x, values[first:first + 3])
    for number in [0, 1] + list(range(8, len(values))):
        values[number] = np.log(np.maximum(values[number], NOTHING))
    return around, values, weights


def even_in_theta(chart, around, points, at):
    """Places along x2, counted in cells, of which the part of a cell is of theta at that radius."""
    middles = around.x[1]
    low = np.clip(np.floor(at).astype(int), 0, len(middles) - 2)
    first, last, here = (chart.theta(points[0], x2) for x2 in (middles[low], middles[low + 1], points[1]))
    return np.where(last > first, low + np.clip((here - first) / np.where(last > first, last - first, 1), 0, 1), at)


def interpolated(flow, surroundings, points):
    around, values, weights = surroundings
    at = around.at(points, flow.chart.ruler)
    if flow.chart.spherical:
        at[1] = even_in_theta(flow.chart, around, points, at[1])
    numbers, known = trilinear(values, at, weights) if weights is not None else (trilinear(values, at), np.ones(len(points[0]), dtype=bool))
    for number in [0, 1] + list(range(8, len(numbers))):
        numbers[number] = np.exp(numbers[number])
    return numbers, known


def resampled(flow, wanted):
    """r (r_s), theta and phi of the nodes, and the file's numbers at them."""
    nodes = (SphericalNodes if flow.chart.spherical else CartesianNodes)(flow, wanted)
    rings, rows, around = nodes.count
    if rings * rows * around > MOST_NODES or rings > 1024 or rows > 2048 or around > 256:
        fail(f"{rings} x {rows} x {around} nodes; allowed: at most {MOST_NODES} (--nodes)")
    for name, ratio in nodes.coarse:
        said(f"cells are up to {ratio:.1f} times as fine in {name} as the nodes (--nodes)")
    owners = np.empty((rings, rows * around), dtype=np.int32)
    j, k = (side.ravel() for side in np.indices((rows, around)))
    for i in range(rings):
        owners[i] = flow.mesh.locate(nodes.native(np.full(j.shape, i), j, k))
    owners = owners.ravel()
    order = np.argsort(owners, kind="stable")
    ends = np.flatnonzero(np.diff(owners[order])) + 1
    out, progress = np.empty((owners.size, 8), dtype="<f4"), Progress("nodes", owners.size)
    for first, last in zip(np.append(0, ends), np.append(ends, len(order))):
        surroundings = smooth_around(flow, int(owners[order[first]]))
        for start in range(first, last, CHUNK):
            here = order[start:min(start + CHUNK, last)]
            i, j, k = np.unravel_index(here, nodes.count)
            numbers, known = interpolated(flow, surroundings, nodes.native(i, j, k))
            out[here] = matter(flow, wanted, nodes.r[i], nodes.theta[j], nodes.phi[k], numbers, known)
            if not np.isfinite(out[here]).all():
                fail(f"{flow.path}: at r = {nodes.r[i[0]]:.4g} M and next to it the matter's numbers are not finite: field or velocity are too large")
            progress.at(start)
    out = out.reshape(nodes.count + (8,))
    if flow.spin < 0:
        return 0.5 * nodes.r, math.pi - nodes.theta[::-1], -nodes.phi[::-1], out[:, ::-1, ::-1]
    return 0.5 * nodes.r, nodes.theta, nodes.phi, out
