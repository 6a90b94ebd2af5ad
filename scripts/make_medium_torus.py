#!/usr/bin/env python3
"""Makes a grid of matter (medium.file): a model of a hot torus about a rotating hole, with two spiral arms. Standard library only.

    scripts/make_medium_torus.py assets/medium/torus.grid          the grid that ships

It is no simulation: density, temperature and field are simple functions, the matter goes round more slowly than on circular orbits and falls
in. The format is that of src/scene/medium_grid.h; azimuths are Kerr and Schild's, so that arms that cross the horizon do not wind up.
"""
import argparse
import math
import os
import struct

CENTRE = 3.0        # radius of the densest matter, r_s
WIDTH = 0.42        # standard deviation of the density in ln r ...
HEIGHT = 0.25       # ... and in the cosine of the polar angle
DENSITY = 8e3       # electrons per cm^3 there
ARMS = 0.9          # by how much arms are denser than gaps
WINDING = 2.5       # rad that they trail for each factor of e in radius
TEMPERATURE = 5e10  # K, there; falls as 1/r
FIELD = 12.0        # G, there; falls as 1/r
SLOWNESS = 0.85     # of the speed on circular orbits
INFLOW = 0.25       # gamma v at the densest; grows as 1/r


def east(r, sine, a):
    """gamma v along e_phi of matter at SLOWNESS of the speed on circular orbits of r, for the zero-angular-momentum observer (ZAMO); lengths r_s."""
    delta, area = r * r - r + a * a, (r * r + a * a) ** 2 - a * a * (r * r - r + a * a) * sine * sine
    sigma = r * r + a * a * (1 - sine * sine)
    orbit, drag = math.sqrt(0.5) / (r ** 1.5 + math.sqrt(0.5) * a), a * r / area
    speed = min(SLOWNESS * (orbit - drag) * area * sine / (sigma * math.sqrt(delta)), 0.6)
    return speed / math.sqrt(1 - speed * speed)


def numbers(r, theta, phi, a):
    along, up = math.log(r / CENTRE) / WIDTH, math.cos(theta) / HEIGHT
    arms = 1 + ARMS * math.cos(2 * (phi + WINDING * math.log(r / CENTRE)))
    density = DENSITY * math.exp(-0.5 * (along * along + up * up)) * arms
    field = FIELD * CENTRE / r
    return (density, TEMPERATURE * CENTRE / r, 0.3 * field * math.cos(theta), 0.3 * field * math.sin(theta), field,
            -INFLOW * CENTRE / r, 0.0, east(r, math.sin(theta), a))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("--spin", type=float, default=0.9, help="of the hole, over its mass (0.9)")
    parser.add_argument("--nodes", type=int, nargs=3, default=(36, 20, 24), help="along r, theta and phi (36 20 24)")
    wanted = parser.parse_args()
    if not 0 <= wanted.spin < 1:
        parser.error(f"--spin {wanted.spin}; allowed: [0, 1)")
    if min(wanted.nodes[:2]) < 2 or wanted.nodes[2] < 1:
        parser.error(f"--nodes {wanted.nodes}; allowed: at least 2 2 1")
    a, (rings, rows, columns) = 0.5 * wanted.spin, wanted.nodes
    first, last = 1.02 * (0.5 + math.sqrt(0.25 - a * a)), 12.0
    north, south = 0.1, math.pi - 0.1
    unfinished = f"{wanted.file}.part"
    with open(unfinished, "wb") as out:
        out.write(f"nullscope-medium 1\ncoordinates kerr-schild\nspin {wanted.spin:.17g}\nr {first:.17g} {last:.17g} {rings}\n"
                  f"theta {north:.17g} {south:.17g} {rows}\nphi 0 {columns}\ndata\n".encode())
        for i in range(rings):
            r = first * (last / first) ** (i / (rings - 1))
            for j in range(rows):
                theta = north + (south - north) * j / (rows - 1)
                for k in range(columns):
                    out.write(struct.pack("<8f", *numbers(r, theta, 2 * math.pi * k / columns, a)))
    os.replace(unfinished, wanted.file)


if __name__ == "__main__":
    main()
