#!/usr/bin/env python3
"""Makes a grid of matter (medium.file, docs/matter.md) from a GRMHD code's file. Needs NumPy, and h5py for HDF5.

    scripts/convert_grmhd.py dump.h5 -o flow.grid --density-unit 1e-18

Files of iharm3d, KHARMA, Athena++, AthenaK, KORAL and H-AMR are read (docs/matter.md; one reader each in scripts/grmhd). What a file does not hold must be
given. --density-unit, in g/cm^3, is what density 1 stands for: most simulations do not know it, and it is found from the flux at one frequency;
medium.density_scale changes it later. The electrons' temperature is that of the file where it has one (--electrons), or follows from the gas's by
R = (R_high beta^2 + R_low)/(1 + beta^2), beta the ratio of the gas's pressure to the field's (Moscibrodzka, Falcke and Shiokawa 2016). Matter whose
magnetization B^2/rho is above --sigma-cut has no density: simulations add gas there for their own stability.

Flows about a hole whose spin is negative are turned by half a turn about the x axis, so that the hole turns eastward: theta becomes 180 - theta, phi
becomes -phi. A line says so, and what the camera of a scene needs then. Velocity and field are changed to the frames that the file wants: of
the zero-angular-momentum observer (ZAMO), and of the matter. The file's head keeps the command and the dump's SHA-256.
"""
import argparse
import hashlib
import math
import os
import pathlib
import shlex
import sys

sys.dont_write_bytecode = True   # next to the sources

import numpy as np

from grmhd.athena import CARTESIAN
from grmhd.common import RATIO, fail, said
from grmhd.nodes import resampled
from grmhd.readers import read

LONGEST_NOTE = 1000                             # bytes of a line of the file's head


def say_rest(flow):
    for line in flow.notes:
        said(f"{flow.path}: {line}")
    if flow.unused:
        said(f"{flow.path}: not used: {', '.join(flow.unused)}")
    if flow.spin < 0:
        said(f"{flow.path}: the spin is below 0: all is turned by half a turn about the x axis. A camera at theta, phi of the dump is at "
             "camera.theta = 180 - theta, camera.phi = -phi, with camera.roll = 180 more")


def note(text):
    """A line of the file's head: no control characters, and not too long."""
    line = text.encode("ascii", "backslashreplace").decode()
    line = "".join(c if c.isprintable() else "?" for c in line)
    return line if len(line) <= LONGEST_NOTE else line[:LONGEST_NOTE - 3] + "..."


def sha256(paths):
    """Of all bytes, one file after the other."""
    digest = hashlib.sha256()
    for path in paths:
        with open(path, "rb") as file:
            while part := file.read(1 << 20):
                digest.update(part)
    return digest.hexdigest()


def write(path, spin, r, theta, phi, numbers, notes):
    """phi: of the first node."""
    head = (f"nullscope-medium 1\ncoordinates kerr-schild\nspin {spin:.17g}\nr {r[0]:.17g} {r[-1]:.17g} {len(r)}\n"
            f"theta {theta[0]:.17g} {theta[-1]:.17g} {len(theta)}\nphi {phi:.17g} {numbers.shape[2]}\n"
            + "".join(f"{key} {note(text)}\n" for key, text in notes) + "data\n")
    unfinished = f"{path}.part"
    try:
        with open(unfinished, "wb") as out:
            out.write(head.encode())
            for ring in numbers:
                out.write(np.ascontiguousarray(ring, dtype="<f4"))
        os.replace(unfinished, path)
    except OSError as error:
        pathlib.Path(unfinished).unlink(missing_ok=True)
        fail(f"{path}: {error.strerror}")


class Parser(argparse.ArgumentParser):
    def error(self, message):
        fail(f"{message} (--help)")


def options():
    parser = Parser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("dump", help="file of a GRMHD code")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="the grid")
    parser.add_argument("--density-unit", type=float, metavar="G/CM3", help="what density 1 stands for, where the file does not hold it")
    parser.add_argument("--electrons", metavar="NAME", help=f"the file's number that their temperature is made of, or {RATIO}: by --r-high and --r-low")
    parser.add_argument("--r-high", type=float, default=40, help="ions' over electrons' temperature where the gas's pressure rules (40)")
    parser.add_argument("--r-low", type=float, default=1, help="and where the field's does (1)")
    parser.add_argument("--sigma-cut", type=float, default=1, help="largest magnetization of matter that is kept (1)")
    parser.add_argument("--outer", type=float, default=25, metavar="R_S", help="last radius, r_s (25)")
    parser.add_argument("--nodes", type=int, nargs="+", metavar="N", help="along r and theta, and phi if a third is given (160, and as fine as the "
                        "cells, at most 256; 160, 128, 128 of Cartesian cells)")
    parser.add_argument("--spin", type=float, metavar="A", help="a/M of the hole, -1 to 1, where the file does not hold it")
    parser.add_argument("--adiabatic-index", type=float, metavar="GAMMA", help="of the gas, where the file does not hold it")
    parser.add_argument("--code-mass", type=float, metavar="M", help="of Athena++: m of the input's <coord>, the unit of lengths (mostly 1)")
    parser.add_argument("--coordinates", choices=[CARTESIAN], help="of Athena++'s gr_user: what its user's coordinates are")
    parser.add_argument("--field-has-lapse", choices=["yes", "no"], help="of H-AMR: whether its B^i are *F^it times the lapse")
    wanted = parser.parse_args()
    for name in ("density_unit", "r_high", "r_low", "sigma_cut", "outer", "code_mass"):
        value = getattr(wanted, name)
        if value is not None and not (0 < value < math.inf):
            fail(f"--{name.replace('_', '-')} {value}; allowed: above 0")
    if wanted.spin is not None and not -1 < wanted.spin < 1:
        fail(f"--spin {wanted.spin}; allowed: between -1 and 1")
    if wanted.adiabatic_index is not None and not 1 < wanted.adiabatic_index <= 3:
        fail(f"--adiabatic-index {wanted.adiabatic_index}; allowed: above 1, up to 3")
    if wanted.nodes:
        wanted.nodes += [None] * (3 - len(wanted.nodes))
        if len(wanted.nodes) > 3 or not all(n is None or least <= n <= most for n, least, most in zip(wanted.nodes, (2, 2, 1), (1024, 2048, 256))) \
                or wanted.nodes[1] is None:
            fail("--nodes: allowed: 2 to 1024, 2 to 2048, and if there is a third 1 to 256")
    return wanted


def main():
    wanted = options()
    np.seterr(all="ignore")   # what is not finite is found, and said in one line
    flow = read(wanted.dump, wanted)
    wanted.density_unit = wanted.density_unit or flow.density_unit
    if not wanted.density_unit:
        fail(f"{wanted.dump}: the file does not hold what density 1 stands for; needed: --density-unit, in g/cm^3")
    r, theta, phi, grid = resampled(flow, wanted)
    files = flow.files or [wanted.dump]
    name = os.path.basename(wanted.dump) + (f" of {len(files)} ranks" if len(files) > 1 else "")
    notes = (("converter", shlex.join(["convert_grmhd.py"] + sys.argv[1:])), ("source", f"sha256 {sha256(files)} {name}"))
    write(wanted.output, abs(flow.spin), r, theta, math.remainder(phi[0], 2 * math.pi), grid, notes)
    say_rest(flow)
    print(f"{wanted.output}: {len(r)} x {len(theta)} x {grid.shape[2]} nodes from {r[0]:.4g} to {r[-1]:.4g} r_s, spin {abs(flow.spin):g}")


if __name__ == "__main__":
    main()
