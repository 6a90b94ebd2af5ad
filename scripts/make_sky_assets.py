#!/usr/bin/env python3
"""Make assets/sky/stars.bin from the npm package d3-celestial. Standard library only.

    npm pack d3-celestial@0.7.35
    python3 scripts/make_sky_assets.py d3-celestial-0.7.35.tgz          (or the folder it unpacks to)

Of the package: data/stars.14.json (Hipparcos stars of XHIP) and LICENSE. The Milky Way: scripts/make_milky_way.py.

stars.bin, little-endian: header of 16 bytes: magic "NSSTARS\\0", u32 version 1, u32 count; then one u64 a star,
brightest first, from the lowest bit:
    22 bits  right ascension, 2^22 steps a turn (0.31 arc seconds)
    21 bits  declination + 90 degrees, 2^21 - 1 steps to 180 (0.31 arc seconds)
    11 bits  V magnitude + 2, in steps of 0.01
    10 bits  B-V + 0.5, in steps of 0.01; 1023: unknown
"""
import json
import os
import struct
import sys
import tarfile


def package_file(package, name):
    if os.path.isdir(package):
        with open(os.path.join(package, name), "rb") as file:
            return file.read()
    with tarfile.open(package) as archive:
        return archive.extractfile("package/" + name).read()


def write_stars(path, stars):
    records = []
    for ra, dec, mag, bv in stars:
        fields = (round(ra / 360.0 * 2**22) % 2**22, round((dec + 90.0) / 180.0 * (2**21 - 1)),
                  min(max(round((mag + 2.0) * 100.0), 0), 2**11 - 1),
                  1023 if bv is None else min(max(round((bv + 0.5) * 100.0), 0), 1022))
        records.append(fields[0] | fields[1] << 22 | fields[2] << 43 | fields[3] << 54)
    with open(path, "wb") as file:
        file.write(struct.pack("<8sII", b"NSSTARS\0", 1, len(records)))
        file.write(struct.pack("<%dQ" % len(records), *records))


def read_stars(text):
    stars = []
    for feature in json.loads(text)["features"]:
        ra, dec = feature["geometry"]["coordinates"]
        bv = feature["properties"].get("bv")
        stars.append((ra % 360.0, dec, float(feature["properties"]["mag"]), None if bv in (None, "") else float(bv)))
    return sorted(stars, key=lambda star: (star[2], star[0], star[1]))


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = sys.argv[2] if len(sys.argv) == 3 else os.path.join(os.path.dirname(__file__), "..", "assets", "sky")
    write_stars(os.path.join(folder, "stars.bin"), read_stars(package_file(sys.argv[1], "data/stars.14.json")))
    with open(os.path.join(folder, "LICENSE-d3-celestial.txt"), "wb") as file:
        file.write(package_file(sys.argv[1], "LICENSE"))


if __name__ == "__main__":
    main()
