"""A known flow, and files of GRMHD codes that hold it, each in its code's own layout: of test_grmhd_codes.py. Nothing here is shared with the converter."""
import math
import struct

import h5py
import numpy as np

SPIN = 0.7
GAMMA = 1.4
PROTON_OVER_ELECTRON, ELECTRON_K = 1836.15267, 5.92989658e9
TURN = 2 * math.pi


# --- the flow -------------------------------------------------------------------------------------------------------------------------------------------

def flow(r, theta, phi):
    """Density, energy, ut^i and B^i along r, theta, phi of Kerr and Schild's coordinates, electron entropy. Smooth, also on the axis and at the horizon."""
    s, c = np.sin(theta), np.cos(theta)
    one = np.ones(np.broadcast(r, theta, phi).shape)
    rho = r ** -1.5 * np.exp(-0.5 * c * c) * (1 + 0.3 * s * np.cos(phi))
    energy = 0.1 * r ** -2.5 * (1 + 0.2 * s * np.sin(phi)) * one
    velocity = np.stack([-0.4 * r ** -0.5 * (1 + 0.2 * s * np.sin(phi)), 0.15 * r ** -1.5 * s * c * one, 0.5 * r ** -1.5 * (1 + 0.1 * c) * one])
    field = np.stack([0.03 * r ** -2 * (1 + 0.2 * s * np.cos(phi)), 0.02 * r ** -2.5 * s * c * one, 0.015 * r ** -2.0 * (1 - 0.3 * c) * one])
    return rho, energy, velocity, field, 0.02 * r ** -0.3 * one


def metric(r, theta, a):
    """t, r, theta, phi: flat part and null vector, shape (..., 4, 4)."""
    s2, sigma = np.sin(theta) ** 2, r * r + a * a * np.cos(theta) ** 2
    flat = np.zeros(np.shape(r) + (4, 4))
    flat[..., 0, 0], flat[..., 1, 1], flat[..., 2, 2], flat[..., 3, 3] = -1, 1, sigma, (r * r + a * a) * s2
    flat[..., 1, 3] = flat[..., 3, 1] = -a * s2
    null = np.stack([np.ones_like(r), np.ones_like(r), np.zeros_like(r), -a * s2], axis=-1)
    return flat + (2 * r / sigma)[..., None, None] * null[..., :, None] * null[..., None, :]


def expected(r, theta, phi, a, unit, electrons="", r_high=40):
    """The eight numbers of the grid's file at places (M): by Gram and Schmidt's tetrad of the observer normal to Boyer and Lindquist's slices, and a
    Lorentz matrix."""
    r, theta, phi = (np.array(side, dtype=float) for side in np.broadcast_arrays(r, theta, phi))
    rho, energy, velocity, field, entropy = flow(r, theta, phi)
    g = metric(r, theta, a)
    up = np.linalg.inv(g)
    def product(v, w):
        return np.einsum("...i,...ij,...j->...", v, g, w)
    still = np.concatenate([np.zeros(r.shape + (1,)), np.moveaxis(velocity, 0, -1)], axis=-1)
    lorentz, normal = np.sqrt(1 + product(still, still)), -up[..., 0] / np.sqrt(-up[..., 0, 0])[..., None]
    u = still + lorentz[..., None] * normal                # of Kerr and Schild's slices' observer
    # B^i = b^i u^t - b^t u^i, and b u = 0
    system = np.zeros(r.shape + (4, 4))
    system[..., 0, :] = np.einsum("...i,...ij->...j", u, g)
    for i in (1, 2, 3):
        system[..., i, i], system[..., i, 0] = u[..., 0], -u[..., i]
    b = np.linalg.solve(system, np.concatenate([np.zeros(r.shape + (1,)), np.moveaxis(field, 0, -1)], axis=-1)[..., None])[..., 0]
    gradient = np.zeros(r.shape + (4,))                     # of Boyer and Lindquist's t
    gradient[..., 0], gradient[..., 1] = 1, -2 * r / (r * r - 2 * r + a * a)
    legs = [-np.einsum("...ij,...j->...i", up, gradient)]
    for axis in (3, 2, 1):
        legs.append(np.broadcast_to(np.eye(4)[axis], r.shape + (4,)).copy())
    for number, leg in enumerate(legs):
        for other in legs[:number]:
            leg -= (product(leg, other) / product(other, other))[..., None] * other
        leg /= np.sqrt(np.abs(product(leg, leg)))[..., None]
    legs = [legs[0], legs[3], legs[2], legs[1]]
    gamma_v = np.stack([product(u, leg) for leg in legs[1:]], axis=-1)
    in_zamo = np.stack([-product(b, legs[0])] + [product(b, leg) for leg in legs[1:]], axis=-1)
    whole = np.sqrt(1 + (gamma_v ** 2).sum(-1))
    boost = np.eye(3) + gamma_v[..., :, None] * gamma_v[..., None, :] * ((whole - 1) / (whole ** 2 - 1))[..., None, None]
    rest = np.einsum("...ij,...j->...i", boost, in_zamo[..., 1:]) - gamma_v * in_zamo[..., :1]
    if electrons == "entropy":
        kelvin = PROTON_OVER_ELECTRON * entropy * rho ** (1 / 3) * ELECTRON_K
    elif electrons == "kelvin":
        kelvin = 1e10 * entropy
    else:
        beta2 = ((GAMMA - 1) * energy / (0.5 * product(b, b))) ** 2
        kelvin = PROTON_OVER_ELECTRON * (2 / 3) / ((r_high * beta2 + 1) / (1 + beta2) + 2) * energy / rho * ELECTRON_K
    return np.concatenate([(rho * unit / 1.67262192e-24)[..., None], kelvin[..., None], math.sqrt(4 * math.pi * unit) * 2.99792458e10 * rest, gamma_v], axis=-1)


# --- coordinates: r and theta of x1, x2, and derivatives by five points ---------------------------------------------------------------------------------------

def mks(x1, x2, h=0.3):
    return np.exp(x1), math.pi * x2 + (1 - h) / 2 * np.sin(TURN * x2)


def fmks(x1, x2, h=0.3, xt=0.82, al=14, ms=0.5, zero=0.0):
    y, norm = 2 * x2 - 1, (math.pi / 2) / (1 + 1 / ((al + 1) * xt ** al))
    wide = norm * y * (1 + (y / xt) ** al / (al + 1)) + math.pi / 2
    plain = mks(x1, x2, h)[1]
    return np.exp(x1), plain + np.exp(ms * (zero - x1)) * (wide - plain)


def superexp(x1, x2, corner=math.log(10), power=2, factor=0.4):
    return np.exp(x1 + np.where(x1 > corner, factor * np.abs(x1 - corner) ** power, 0)), x2 + 0 * x1


def widepole(x1, x2, linear=0.6, w=0.1):
    return np.exp(x1), math.pi / 2 * (1 + 2 * linear * (x2 - 0.5) + (1 - linear) * (np.tanh((x2 - 1) / w) + np.tanh(x2 / w))) + 0 * x1


def eks(x1, x2):
    return np.exp(x1), x2 + 0 * x1


def plain(x1, x2):
    return x1 + 0 * x2, x2 + 0 * x1


def cells_of(chart, x1, x2, x3, h=1e-3):
    """rho, u, ut^1..3, B^1..3, entropy along x1, x2, x3, and sqrt(-g), at arrays of x1, x2, x3."""
    x1, x2, x3 = np.meshgrid(x1, x2, x3, indexing="ij")
    r, theta = chart(x1, x2)
    def slope(f):
        return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h)
    r_1, th_1 = (slope(lambda d: chart(x1 + d, x2)[n]) for n in (0, 1))
    th_2 = slope(lambda d: chart(x1, x2 + d)[1])
    rho, energy, velocity, field, entropy = flow(r, theta, x3)
    native = [[v[0] / r_1, (v[1] - th_1 * v[0] / r_1) / th_2, v[2]] for v in (velocity, field)]
    root = r_1 * th_2 * (r * r + SPIN ** 2 * np.cos(theta) ** 2) * np.sin(theta)
    return np.stack([rho, energy, *native[0], *native[1], entropy]), root


def cartesian_cells(x, y, z, a):
    """The same along Kerr and Schild's x, y, z, from the null form of the spheroidal coordinates; within r = 1 what no one may use."""
    x, y, z = np.meshgrid(x, y, z, indexing="ij")
    d = x * x + y * y + z * z - a * a
    r = np.sqrt((d + np.sqrt(d * d + 4 * a * a * z * z)) / 2)
    out = np.maximum(r, 0.5)
    theta, phi = np.arccos(np.clip(z / out, -1, 1)), np.arctan2(y, x) - np.arctan2(a, r)
    rho, energy, velocity, field, entropy = flow(out, theta, phi)
    def turned(v):
        """v^x + i v^y = (v^r + i (r + i a) v^phi) sin e^(i phi) + (r + i a) cos e^(i phi) v^theta."""
        ring = np.exp(1j * phi) * ((v[0] + 1j * (r + 1j * a) * v[2]) * np.sin(theta) + (r + 1j * a) * np.cos(theta) * v[1])
        return [ring.real, ring.imag, v[0] * np.cos(theta) - r * np.sin(theta) * v[1]]
    cells = np.stack([rho, energy, *turned(velocity), *turned(field), entropy])
    cells[:, r <= 1] = 1e30
    return cells


# --- blocks -----------------------------------------------------------------------------------------------------------------------------------------------

class Block:
    """level, place on the level (i, j, k), faces of the cells with ghosts, of which there are ghosts at each side."""

    def __init__(self, level, place, size, root, domain, ghosts, spacing):
        self.level, self.place, self.faces, self.middles = level, place, [], []
        for axis in range(3):
            n = root[axis] * 2 ** (level if root[axis] > 1 else 0)
            g = ghosts if root[axis] > 1 else 0
            part = (place[axis] * size[axis] + np.arange(-g, size[axis] + g + 1)) / n
            low, high = domain[axis]
            self.faces.append(low * (high / low) ** part if spacing[axis] == "log" else low + (high - low) * part)
            self.middles.append(0.5 * (self.faces[-1][1:] + self.faces[-1][:-1]))


def blocks_of(root, size, domain, refined, ghosts=0, spacing=("even",) * 3):
    """Leaves: a block of which refined(level, middle) is true is eight of the next level. A level is at most one beyond its neighbours' if refined has it so."""
    def split(level, place):
        ends = [[(place[axis] + d) * size[axis] / (root[axis] * 2 ** level) for d in (0, 1)] for axis in range(3)]
        middle = [low + (high - low) * 0.5 * (a + b) for (low, high), (a, b) in zip(domain, ends)]
        if not refined(level, middle):
            yield Block(level, place, size, root, domain, ghosts, spacing)
            return
        for k, j, i in np.ndindex(2, 2, 2):
            yield from split(level + 1, (2 * place[0] + i, 2 * place[1] + j, 2 * place[2] + k))
    counts = [root[axis] // size[axis] for axis in range(3)]
    return [leaf for k, j, i in np.ndindex(*counts[::-1]) for leaf in split(0, (i, j, k))]


# --- files --------------------------------------------------------------------------------------------------------------------------------------------------

def write_iharm(path, cells=(48, 32, 16), r=(1.2, 60.0), names=(), h=1.0, values=None, a=SPIN):
    """iharm3d: prims (i, j, k, variable)."""
    step = (math.log(r[1] / r[0]) / cells[0], 1 / cells[1], TURN / cells[2])
    start = (math.log(r[0]), 0.0, 0.0)
    prims, _ = cells_of(lambda x1, x2: mks(x1, x2, h), *(start[n] + (np.arange(cells[n]) + 0.5) * step[n] for n in range(3)))
    columns = list(prims[:8]) + [prims[8] if name == "KEL" else 7 + 0 * prims[8] for name in names]
    with h5py.File(path, "w") as file:
        file["prims"] = np.stack(columns, axis=-1).astype("<f4")
        file["header/metric"], file["header/gam"] = np.bytes_("MKS"), GAMMA
        if names:
            file["header/prim_names"] = np.array([b"RHO", b"UU", b"U1", b"U2", b"U3", b"B1", b"B2", b"B3"] + [name.encode() for name in names])
        for n in range(3):
            file[f"header/geom/startx{n + 1}"], file[f"header/geom/dx{n + 1}"] = start[n], step[n]
        file["header/geom/mks/a"], file["header/geom/mks/hslope"] = a, h


KHARMA_TEXT = """<parthenon/job>
problem_id = torus  # Default value added at run time
<parthenon/mesh>
nx1 = {n[0]}
x1min = {x1[0]!r}
x1max = {x1[1]!r}
<coordinates>
base = spherical_ks
transform = {transform}
a = {a!r}
{more}
<GRMHD>
gamma = &  # goes on
 {gamma}  # of the gas
<electrons>
on = true
gamma_e = 1.3333333333333333
<floors>
gamma = 9
"""


def write_kharma(path, chart, transform, more="", version=3, domain=((0.18, 4.1), (0.0, 1.0), (0.0, TURN)), root=(32, 16, 16), size=(16, 8, 8),
                 refined=lambda level, middle: False, ghosts=0, restart=False, kel=(), dtype="<f4", a=SPIN):
    """Parthenon's layout: (block, component, k, j, i), or what older versions have."""
    leaves = blocks_of(root, size, domain, refined, ghosts)
    both = [cells_of(chart, *leaf.middles) for leaf in leaves]
    cells = np.stack([pair[0] for pair in both]).transpose(0, 1, 4, 3, 2)    # block, number, k, j, i
    volume = np.stack([pair[1] for pair in both]).transpose(0, 3, 2, 1)[:, None]
    def scalar(values):
        return values[..., None] if version is None else values[:, None] if version == 2 else values
    def vector(values):
        return np.moveaxis(values, 1, -1) if version is None else values
    with h5py.File(path, "w") as file:
        info = file.create_group("Info").attrs
        if version is not None:
            info["OutputFormatVersion"] = np.int64(version)
        info["NumMeshBlocks"], info["MeshBlockSize"] = np.int64(len(leaves)), np.array([n + 2 * ghosts for n in size], dtype="i8")
        info["IncludesGhost"], info["NGhost"], info["Time"] = np.int32(ghosts > 0), np.int32(ghosts or 4), 100.0
        info["Coordinates"] = "TransformedSpherical"
        info["RootGridDomain"] = np.array([n for low, high in domain for n in (low, high, 1.0)])
        text = KHARMA_TEXT.format(n=root, x1=domain[0], transform=transform, a=a, more=more, gamma=GAMMA)
        file.create_group("Input").attrs["File"] = text
        for number in range(8):
            file.require_group("Params").attrs[f"Package/{number}"] = number
        for axis, name in enumerate("xyz"):
            file[f"Locations/{name}"] = np.stack([leaf.faces[axis] for leaf in leaves])
            file[f"VolumeLocations/{name}"] = np.stack([leaf.middles[axis] for leaf in leaves])
        file["Levels"] = np.array([leaf.level for leaf in leaves], dtype="i8")
        file["LogicalLocations"] = np.array([leaf.place for leaf in leaves], dtype="i8")
        file.create_dataset("prims.rho", data=scalar(cells[:, 0]).astype(dtype), compression="gzip", compression_opts=1)
        file["prims.u"], file["prims.uvec"] = scalar(cells[:, 1]).astype(dtype), vector(cells[:, 2:5]).astype(dtype)
        file["cons.B" if restart else "prims.B"] = vector(cells[:, 5:8] * (volume if restart else 1)).astype(dtype)
        for name in kel:
            file[f"prims.Kel_{name}"] = scalar(cells[:, 8] * (1 if name == "Howes" else 2)).astype(dtype)


def write_athena(path, root=(48, 32, 16), size=(16, 16, 16), r=(1.25, 60.0), refined=lambda level, middle: False, ghosts=0, real="f4", spoil=None, m=1.0,
                 coordinates="kerr-schild", a=SPIN):
    """Athena++: datasets prim and B (variable, block, k, j, i), x1 = r even in its logarithm."""
    domain = ((m * r[0], m * r[1]), (0.0, math.pi), (0.0, TURN))
    leaves = blocks_of(root, size, domain, refined, ghosts, ("log", "even", "even"))
    cells = np.stack([cells_of(plain, leaf.middles[0] / m, *leaf.middles[1:], h=1e-4)[0] for leaf in leaves]).transpose(1, 0, 4, 3, 2)
    cells[[3, 4, 6, 7]] /= m                                            # per unit of length m
    write_athdf(path, leaves, domain, root, [n + 2 * ghosts for n in size], coordinates, real,
                (("prim", ("rho", "press", "vel1", "vel2", "vel3", "r0"), [cells[0], cells[1] * (GAMMA - 1), *cells[2:5], cells[8]]),
                 ("B", ("Bcc1", "Bcc2", "Bcc3"), list(cells[5:8]))), spoil)


def write_athena_cartesian(path, root=32, size=8, half=32.0, widths=(16.0, 8.0, 4.0), m=1.0, a=SPIN):
    """Athena++ with coordinates of a user's own, which are Kerr and Schild's x, y, z."""
    leaves = blocks_of((root,) * 3, (size,) * 3, ((-half, half),) * 3, nested(widths))
    cells = np.stack([cartesian_cells(*leaf.middles, a).transpose(0, 3, 2, 1) for leaf in leaves], axis=1)
    cells[1] *= GAMMA - 1
    for leaf in leaves:
        leaf.faces, leaf.middles = ([m * side for side in sides] for sides in (leaf.faces, leaf.middles))
    write_athdf(path, leaves, ((-half * m, half * m),) * 3, (root,) * 3, (size,) * 3, "gr_user", "f4",
                (("prim", ("rho", "press", "vel1", "vel2", "vel3"), list(cells[:5])), ("B", ("Bcc1", "Bcc2", "Bcc3"), list(cells[5:8]))))


def write_athdf(path, leaves, domain, root, size, coordinates, real, datasets, spoil=None, header=None):
    with h5py.File(path, "w") as file:
        top = file.attrs
        top["NumCycles"], top["Time"], top["Coordinates"] = np.int32(5), 100.0, np.bytes_(coordinates)
        for axis in range(3):
            top[f"RootGridX{axis + 1}"] = np.array([*domain[axis], 1.0])
        top["RootGridSize"], top["NumMeshBlocks"], top["MeshBlockSize"] = np.array(root, "i4"), np.int32(len(leaves)), np.array(size, "i4")
        top["MaxLevel"], top["NumVariables"] = np.int32(max(leaf.level for leaf in leaves)), np.array([len(names) for _, names, _ in datasets], "i4")
        top["DatasetNames"] = np.array([name for name, _, _ in datasets], "S21")
        top["VariableNames"] = np.array([name for _, names, _ in datasets for name in names], "S21")
        if header:
            top["Header"] = header
        for name, _, values in datasets:
            file[name] = np.stack(values).astype(real)
        for axis in range(3):
            file[f"x{axis + 1}f"] = np.stack([leaf.faces[axis] for leaf in leaves]).astype(real)
            file[f"x{axis + 1}v"] = np.stack([leaf.middles[axis] for leaf in leaves]).astype(real)
        file["Levels"] = np.array([leaf.level for leaf in leaves], ">i4")
        file["LogicalLocations"] = np.array([leaf.place for leaf in leaves], ">i8")
        if spoil:
            spoil(file)


ATHENAK_TEXT = """# a torus
<mesh>
nghost = 4  # ghost cells
nx1 = {n}
x1min = {low}
x1max = {high}
x2min = {low}
x2max = {high}
x3min = {low}
x3max = {high}
<meshblock>
nx1 = {size}
nx2 = {size}
nx3 = {size}
<coord>
general_rel = true
a = {a}
excise = true
<mhd>
eos = ideal
gamma = {gamma}
"""
NAMES_K = ("dens", "velx", "vely", "velz", "eint", "s_00", "bcc1", "bcc2", "bcc3")
ORDER_K = (0, 2, 3, 4, 1, 8, 5, 6, 7)


def nested(widths):
    """Blocks whose middle is within these boxes are refined, one level each."""
    return lambda level, middle: level < len(widths) and max(map(abs, middle)) < widths[level]


def athenak_parts(root, size, half, widths, a):
    leaves = blocks_of((root,) * 3, (size,) * 3, ((-half, half),) * 3, nested(widths))
    return leaves, [cartesian_cells(*leaf.middles, a)[list(ORDER_K)].transpose(0, 3, 2, 1) for leaf in leaves]


def write_athenak(path, root=32, size=8, half=32.0, widths=(16.0, 8.0, 4.0), a=SPIN, ranks=0, location=8, text=ATHENAK_TEXT, names=NAMES_K):
    """AthenaK's .bin; ranks: as many files path/rank_NNNNNNNN/flow.bin."""
    leaves, cells = athenak_parts(root, size, half, widths, a)
    said = text.format(n=root, low=-half, high=half, size=size, a=a, gamma=GAMMA).encode()
    head = (f"Athena binary output version=1.1\n  size of preheader=5\n  time=1.0e+02\n  cycle=77\n  size of location={location}\n  size of variable=4\n"
            f"  number of variables={len(names)}\n  variables:  {'  '.join(names)}  \n  header offset={len(said)}\n").encode() + said
    real = "<f8" if location == 8 else "<f4"
    parts = [struct.pack("<10i", *(n for _ in range(3) for n in (4, 3 + size)), *leaf.place, leaf.level)
             + np.array([end for face in leaf.faces for end in (face[0], face[-1])], real).tobytes() + values.astype("<f4").tobytes()
             for leaf, values in zip(leaves, cells)]
    if not ranks:
        path.write_bytes(head + b"".join(parts))
    for rank in range(ranks):
        folder = path / f"rank_{rank:08d}"
        folder.mkdir(parents=True)
        (folder / "flow.bin").write_bytes(head + b"".join(parts[rank::ranks]))


def write_athenak_hdf5(path, root=32, size=8, half=32.0, widths=(16.0, 8.0, 4.0), a=SPIN):
    """The same, converted by AthenaK's script: datasets uov and B, the input text in an attribute."""
    leaves, cells = athenak_parts(root, size, half, widths, a)
    values = np.stack(cells, axis=1)
    lines = [line.encode() for line in ATHENAK_TEXT.format(n=root, low=-half, high=half, size=size, a=a, gamma=GAMMA).splitlines()]
    write_athdf(path, leaves, ((-half, half),) * 3, (root,) * 3, (size,) * 3, "cartesian", "f4",
                (("uov", NAMES_K[:6], list(values[:6])), ("B", NAMES_K[6:], list(values[6:]))), header=lines)


def write_koral(path, cells=(32, 24, 16), te=True, a=SPIN, spoil=None):
    """KORAL's output for other programs: all big-endian, [i, j, k], vectors along r, theta, phi, places in grid_out, azimuths from -pi."""
    x1, x2, x3 = np.log(1.2) + (np.arange(cells[0]) + 0.5) * np.log(50) / cells[0], (np.arange(cells[1]) + 0.5) / cells[1], \
        -math.pi + (np.arange(cells[2]) + 0.5) * TURN / cells[2]
    r, theta = (np.broadcast_to(side[..., None], cells) for side in fmks(x1[:, None], x2[None, :], 0.5, zero=x1[0]))
    r, phi = r * np.ones(cells), np.broadcast_to(x3, cells)
    rho, energy, velocity, field, entropy = flow(r, theta, phi)
    with h5py.File(path, "w") as file:
        def put(name, value):
            file[name] = np.asarray(value, ">i4" if isinstance(value, int) else ">f8")
        file["header/version"], file["header/metric_run"], file["header/metric_out"] = np.bytes_("KORALv2"), np.bytes_("MKS3"), np.bytes_("KS")
        for name, value in zip(("n1", "n2", "n3", "gam", "bhspin", "has_electrons", "units/M_unit"), (*cells, GAMMA, a, int(te), 2e-17)):
            put(f"header/{name}", value)
        put("t", 1000.0)
        for name, value in zip(("r", "th", "ph"), (r, theta, phi)):
            put(f"grid_out/{name}", value)
        for name, value in zip(("rho", "uint", "U1", "U2", "U3", "B1", "B2", "B3"), (rho, energy, *velocity, *field)):
            put(f"quants/{name}", value)
        if te:
            put("quants/te", 1e10 * entropy)
        if spoil:
            spoil(file)


def write_hamr(path, cells=(40, 32, 16), lapse=False, hslope=1.0, r0=0.0, places=True, a=SPIN):
    """H-AMR's regular grid: attributes at the root, flat datasets; x2 from -1 to 1, startx at middles."""
    step = np.array([math.log(50) / cells[0], 2 / cells[1], TURN / cells[2]])
    start = np.array([math.log(1.2), -1, 0]) + step / 2
    def chart(x1, x2):
        plain = mks(x1, 0.5 * (1 + x2), hslope)
        return plain[0] + r0, plain[1]
    x = [start[n] + np.arange(cells[n]) * step[n] for n in range(3)]
    values, _ = cells_of(chart, *x)
    r, theta = (np.broadcast_to(side[..., None], cells) for side in np.broadcast_arrays(*chart(x[0][:, None], x[1][None, :])))
    if lapse:
        values[5:8] /= np.sqrt(1 + 2 * r / (r * r + a * a * np.cos(theta) ** 2))
    with h5py.File(path, "w") as file:
        for name, value in zip(("dscale", "t", "N1", "N2", "N3", "startx", "dx", "a", "gam", "R0", "hslope"),
                               (1.0, 1e4, *cells, start, step, a, GAMMA, r0, hslope)):
            file.attrs[name] = value
        for name, value in zip(("RHO", "UU", "U1", "U2", "U3", "B1", "B2", "B3"), values):
            file[name] = value.ravel()
        if places:
            file["r"], file["h"] = r.ravel(), theta.ravel()
