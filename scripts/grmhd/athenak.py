"""Binary output of AthenaK (.bin): blocks of cells of Kerr and Schild's x, y, z. One file, or one a rank in folders rank_NNNNNNNN."""
import mmap
import os
import re

import numpy as np

from .charts import Cartesian
from .common import INDEX, SPIN, Flow, Parameters, asked, chosen_electrons, fail
from .mesh import Mesh

MAGIC = b"Athena binary output version="
NAMES = ("dens", "eint", "velx", "vely", "velz", "bcc1", "bcc2", "bcc3")
EXCISED = 1.0                       # M, the radius that the code cuts out
MOST_HEAD = 1 << 24                 # bytes of the input text


def known_text(path, text, wanted):
    """The spin and the adiabatic index of an input text of AthenaK, if its metric is one that is read."""
    if not text.has("mhd"):
        fail(f"{path}: {text.where} has no <mhd>; allowed: magnetohydrodynamics")
    for block in ("adm", "z4c"):
        if text.has(block):
            fail(f"{path}: {text.where} has <{block}>, a metric that changes, which is not read")
    if not text.flag("coord", "general_rel") or text.flag("coord", "minkowski"):
        fail(f"{path}: {text.where}: <coord> is not of Kerr and Schild's coordinates; needed: general_rel = true, and no minkowski = true")
    return (asked(path, wanted, "spin", "the spin", text.number("coord", "a", *SPIN)),
            asked(path, wanted, "adiabatic_index", "the adiabatic index", text.number("mhd", "gamma", *INDEX)))


class Part:
    """One file: its head, and where its blocks are."""

    def __init__(self, path):
        self.path = path
        try:
            with open(path, "rb") as file:
                self.bytes = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        except (OSError, ValueError) as error:
            fail(f"{path}: no dump: {getattr(error, 'strerror', None) or error}")
        line = self.line()
        if line != "Athena binary output version=1.1":
            fail(f"{path}: it begins with {line[:60]!r}; allowed: Athena binary output version=1.1")
        preheader = self.number("size of preheader")
        if preheader != 5:
            fail(f"{path}: size of preheader is {preheader}; allowed: 5 (7, coarsened output, is not read)")
        self.time, self.cycle = self.field("time"), self.field("cycle")
        location, variable = self.number("size of location"), self.number("size of variable")
        if location not in (4, 8) or variable != 4:
            fail(f"{path}: numbers of {location} and {variable} bytes (size of location, size of variable); allowed: 4 or 8, and 4")
        count = self.number("number of variables")
        self.names = self.field("variables", ":").split()
        if len(self.names) != count:
            fail(f"{path}: number of variables is {count}, but {len(self.names)} names follow")
        offset = self.number("header offset")
        if not 0 <= offset <= min(MOST_HEAD, self.bytes.size() - self.bytes.tell()):
            fail(f"{path}: header offset is {offset}, more than the file has: it is cut short")
        self.text = self.bytes.read(offset).decode("utf-8", "replace")
        self.geometry = np.dtype(f"<f{location}")
        self.blocks = list(self.find_blocks())

    def line(self):
        start = self.bytes.tell()
        end = self.bytes.find(b"\n", start, start + 4096)
        return self.bytes.read((end + 1 or start + 80) - start).decode("utf-8", "replace").strip()

    def field(self, name, mark="="):
        line = self.line()
        if not line.startswith(name + mark):
            fail(f"{self.path}: its head has {line[:60]!r} for {name}: it is cut short or damaged")
        return line[len(name) + 1:].strip()

    def number(self, name):
        word = self.field(name)
        if not re.fullmatch(r"\d{1,18}", word):
            fail(f"{self.path}: {name} is {word[:40]!r}; allowed: a whole number")
        return int(word)

    def find_blocks(self):
        """(first and last index of each axis, level, faces' ends, offset of the numbers), to the file's end."""
        at, size, head = self.bytes.tell(), self.bytes.size(), 40 + 6 * self.geometry.itemsize
        while at < size:
            if at + head > size:
                fail(f"{self.path}: its last block is cut short")
            whole = np.frombuffer(self.bytes, "<i4", 10, at)
            ends = np.frombuffer(self.bytes, self.geometry, 6, at + 40).astype(float)
            cells = [int(last) - int(first) + 1 for first, last in whole[:6].reshape(3, 2)]
            count = cells[0] * cells[1] * cells[2] if all(0 < n < 1 << 20 for n in cells) else -1
            if count < 0:
                fail(f"{self.path}: a block has cells from {whole[:6].tolist()}: it is damaged")
            yield cells, int(whole[9]), ends, at + head
            at += head + 4 * len(self.names) * count
            if at > size:
                fail(f"{self.path}: its last block is cut short")


def parts_of(path):
    """The file, and those of the other ranks beside it."""
    folder, name = os.path.split(os.path.abspath(path))
    whole, rank = os.path.split(folder)
    if not re.fullmatch(r"rank_\d{8}", rank):
        return [path]
    ranks = sorted(each for each in os.listdir(whole) if re.fullmatch(r"rank_\d{8}", each))
    return [os.path.join(whole, each, name) for each in ranks if os.path.exists(os.path.join(whole, each, name))]


def read(path, wanted):
    files = parts_of(path)
    parts = [Part(each) for each in files]
    first = parts[0]
    for part in parts[1:]:
        if (part.time, part.cycle, part.names) != (first.time, first.cycle, first.names):
            fail(f"{part.path}: its time, cycle or variables are not those of {first.path}")
    text = Parameters(path, first.text, "the input text")
    spin, gamma = known_text(path, text, wanted)
    missing = [name for name in NAMES if name not in first.names]
    if missing:
        fail(f"{path}: the file has no {', '.join(missing)}, but {', '.join(first.names)}; allowed: {', '.join(NAMES)}, and others")
    chosen_electrons(path, wanted, [])
    at = [first.names.index(name) for name in NAMES]
    ghosts, sizes = int(text.number("mesh", "nghost", 0, 16, usual=2)), [int(text.number("meshblock", f"nx{axis}", 1, 1 << 20)) for axis in (1, 2, 3)]
    faces, levels, places = [], [], []
    for part in parts:
        for cells, level, ends, offset in part.blocks:
            inner = [(n - size) // 2 if n == size + 2 * ghosts else 0 for n, size in zip(cells, sizes)]
            if any(n - 2 * g != size for n, g, size in zip(cells, inner, sizes)):
                fail(f"{part.path}: a block has {' x '.join(map(str, cells))} cells, but <meshblock> {' x '.join(map(str, sizes))}: slices are not read")
            faces.append(tuple(np.linspace(ends[2 * axis], ends[2 * axis + 1], sizes[axis] + 1) for axis in range(3)))
            levels.append(level)
            places.append((part.bytes, cells, inner, offset))
    if not places:
        fail(f"{path}: the file has no blocks: it is cut short")
    def fetch(block):
        source, cells, inner, offset = places[block]
        values = np.frombuffer(source, "<f4", len(first.names) * cells[0] * cells[1] * cells[2], offset).reshape(-1, *cells[::-1])
        return [values[(number,) + tuple(slice(g, n - g) for g, n in zip(inner[::-1], cells[::-1]))].transpose(2, 1, 0) for number in at]
    mesh = Mesh(path, faces, levels, fetch)
    for axis in range(3):
        mesh.check_span(axis, text.number("mesh", f"x{axis + 1}min"), text.number("mesh", f"x{axis + 1}max"), "<mesh>")
    others = [name for name in first.names if name not in NAMES]
    return cartesian_flow(path, spin, gamma, mesh, NAMES, others, files)


def cartesian_flow(path, spin, gamma, mesh, names, unused, files=(), length=1.0):
    chart = Cartesian(spin, length)
    def kept(block):
        return chart.radius_of(np.meshgrid(*(mesh.middles(block, axis) for axis in range(3)), indexing="ij", sparse=True)) > EXCISED
    cold = mesh.check_numbers(names, kept, "it")
    return Flow(path, spin, gamma, chart, mesh, excised=EXCISED, unused=unused, files=list(files),
                notes=[f"the energy is below 0 in {cold} cells, and counts as 0 there"] if cold else [])
