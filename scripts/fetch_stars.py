#!/usr/bin/env python3
"""Fetch the deep star catalogue: stars to V = 10.5, for scenes with sky.catalogue = "tycho-2". Standard library only.

    scripts/fetch_stars.py                     downloads the Debian package stellarium-data by apt-get (30 MB), and takes the stars from it
    scripts/fetch_stars.py FOLDER              of a package that is unpacked there, or installed: the folder with the files stars_*.cat

Writes assets/sky/stars-tycho-2.bin (4.8 MB, layout: scripts/make_sky_assets.py), which is not part of the repository. Data: Hipparcos and
Tycho-2 (Hog et al. 2000, A&A 355, L27), ESA, as they come with Stellarium; its copyright file, which has the terms, is written beside it.

The files' format, as Stellarium reads it: a header of eight 32-bit words (magic, kind of record, version, version, level of the grid, least
magnitude, range and number of its steps), the number of stars of each zone, their records. Zones are the triangles of an icosahedron that is
divided `level` times; a star is at the zone's middle plus two coordinates along its east and north.
"""
import argparse
import math
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from make_sky_assets import write_stars  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
FILES = ["stars_0_0v0_8.cat", "stars_1_0v0_8.cat", "stars_2_0v0_8.cat", "stars_3_1v0_4.cat"]
INSIDE = "usr/share/stellarium/stars/default"
COPYRIGHT = "usr/share/doc/stellarium-data/copyright"
MAGIC, HEADER_BYTES = 0x835f040a, 32
HIPPARCOS, TYCHO = 0, 1                    # kinds of records, of 28 and of 10 bytes
LEAST_STARS = 500_000

LONG = math.sqrt((5.0 + math.sqrt(5.0)) / 10.0)
SHORT = math.sqrt((5.0 - math.sqrt(5.0)) / 10.0)
CORNERS = [(LONG, -SHORT, 0), (LONG, SHORT, 0), (-LONG, SHORT, 0), (-LONG, -SHORT, 0), (0, LONG, -SHORT), (0, LONG, SHORT),
           (0, -LONG, SHORT), (0, -LONG, -SHORT), (-SHORT, 0, LONG), (SHORT, 0, LONG), (SHORT, 0, -LONG), (-SHORT, 0, -LONG)]
FACES = [(1, 0, 10), (0, 1, 9), (0, 9, 6), (9, 8, 6), (0, 7, 10), (6, 7, 0), (7, 6, 3), (6, 8, 3), (11, 10, 7), (7, 3, 11), (3, 2, 11),
         (2, 3, 8), (10, 11, 4), (2, 4, 11), (5, 4, 2), (2, 8, 5), (4, 1, 10), (4, 5, 1), (5, 9, 1), (8, 9, 5)]


def unit(v):
    size = math.sqrt(sum(c * c for c in v))
    return tuple(c / size for c in v)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def triangles(level):
    """Of each zone in turn its three corners."""
    found = [tuple(CORNERS[i] for i in face) for face in FACES]
    for _ in range(level):
        finer = []
        for a, b, c in found:
            middle_a, middle_b, middle_c = (unit([x + y for x, y in zip(p, q)]) for p, q in ((b, c), (c, a), (a, b)))
            finer += [(a, middle_c, middle_b), (middle_c, b, middle_a), (middle_b, middle_a, c), (middle_a, middle_b, middle_c)]
        found = finer
    return found


def frames(level):
    """Of each zone (middle, east, north), and the largest coordinate of a corner in any: what the largest number of a record stands for."""
    zones, scale = [], 0.0
    for corners in triangles(level):
        middle = unit([sum(parts) for parts in zip(*corners)])
        east = unit(cross((0, 0, 1), middle))
        north = cross(middle, east)
        zones.append((middle, east, north))
        for corner in corners:
            x, y = dot(corner, east), dot(corner, north)
            scale = max(scale, max(abs(x), abs(y)) / math.sqrt(1.0 - x * x - y * y))
    return zones, scale


def signed(number, bits):
    return number - (1 << bits) if number >> (bits - 1) else number


def colour_index(code):
    return code * (4.0 / 127.0) - 0.5


def read_catalogue(data):
    """(right ascension, declination in degrees, V, B-V) of each star, as the file has them."""
    magic, kind, _, _, level, faintest_from, reach, steps = struct.unpack_from("<5Ii2I", data)
    if magic != MAGIC or kind not in (HIPPARCOS, TYCHO):
        raise ValueError("not a star file that is known")
    zones, scale = frames(level)
    counts = struct.unpack_from(f"<{len(zones) + 1}I", data, HEADER_BYTES)
    at, size = HEADER_BYTES + 4 * len(counts), 28 if kind == HIPPARCOS else 10
    if at + size * sum(counts) != len(data):
        at, counts = at - 4, counts[:-1]     # older files have no zone for the whole sky
    if at + size * sum(counts) != len(data):
        raise ValueError("its length does not fit its zones")
    largest = 0x7fffffff if kind == HIPPARCOS else (1 << 19) - 1
    for (middle, east, north), count in zip(zones, counts):
        for _ in range(count):
            if kind == HIPPARCOS:
                _, x, y, colour, magnitude = struct.unpack_from("<IiiBB", data, at)
            else:
                bits = int.from_bytes(data[at:at + size], "little")
                x, y = signed(bits & 0xfffff, 20), signed(bits >> 20 & 0xfffff, 20)
                colour, magnitude = bits >> 68 & 0x7f, bits >> 75 & 0x1f
            at += size
            u, v = scale * x / largest, scale * y / largest
            place = unit([m + u * e + v * n for m, e, n in zip(middle, east, north)])
            yield (math.degrees(math.atan2(place[1], place[0])) % 360.0, math.degrees(math.asin(place[2])),
                   1e-3 * (faintest_from + magnitude * reach / steps), colour_index(colour))


def download(folder):
    """Unpacks the Debian package into the folder."""
    for command in (["apt-get", "download", "stellarium-data"], ["sh", "-c", "dpkg -x stellarium-data_*.deb ."]):
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"fetch_stars: {' '.join(command)}: {done.stderr.strip().splitlines()[-1:]}; or unpack the package yourself and name the folder "
                     "of its stars_*.cat")
    return Path(folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", nargs="?", type=Path, help="with stars_*.cat (default: the package is downloaded)")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "assets/sky/stars-tycho-2.bin", help="default: %(default)s")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="nullscope-stars-") as scratch:
        root = download(scratch) if options.folder is None else None
        folder = root / INSIDE if root else options.folder
        stars = []
        for name in FILES:
            try:
                stars += read_catalogue((folder / name).read_bytes())
            except (OSError, ValueError, struct.error) as error:
                sys.exit(f"fetch_stars: {folder / name}: {error}")
        if len(stars) < LEAST_STARS:
            sys.exit(f"fetch_stars: only {len(stars)} stars")
        stars.sort(key=lambda star: (star[2], star[0], star[1]))
        unfinished = options.output.with_suffix(".part")
        write_stars(unfinished, stars)
        unfinished.replace(options.output)
        if root:
            options.output.with_suffix(".copyright.txt").write_bytes((root / COPYRIGHT).read_bytes())
    print(f"{options.output}: {len(stars)} stars to V = {stars[-1][2]:.2f}, {options.output.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
