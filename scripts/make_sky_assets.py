#!/usr/bin/env python3
"""Make assets/sky/stars.bin and assets/sky/milky-way.png from the npm package d3-celestial. Standard library only.

    npm pack d3-celestial@0.7.35
    python3 scripts/make_sky_assets.py d3-celestial-0.7.35.tgz          (or the folder it unpacks to)

Of the package: data/stars.14.json (Hipparcos stars of XHIP), data/mw.json (Milky Way Outline Catalog) and LICENSE.
The output depends on nothing else: the same package gives the same pictures.

stars.bin, little-endian: header of 16 bytes: magic "NSSTARS\\0", u32 version 1, u32 count; then one u64 a star,
brightest first, from the lowest bit:
    22 bits  right ascension, 2^22 steps a turn (0.31 arc seconds)
    21 bits  declination + 90 degrees, 2^21 - 1 steps to 180 (0.31 arc seconds)
    11 bits  V magnitude + 2, in steps of 0.01
    10 bits  B-V + 0.5, in steps of 0.01; 1023: unknown

milky-way.png: surface brightness, sRGB-encoded, its peak 1; equatorial, RA 0 in the middle of the columns and growing
to the left (the sky from inside), row 0 at declination +90.
"""
import array
import json
import math
import os
import struct
import sys
import tarfile
import zlib

WIDTH, HEIGHT = 1024, 512
LEVELS = 5
# Blur of each outline level, degrees: about the distance to the next outline, so that no edge remains.
LEVEL_SIGMA = (3.2, 2.2, 1.5, 1.1, 1.0)
LEVEL_WEIGHT = (0.10, 0.17, 0.22, 0.25, 0.26)
COUNT_LIMIT = 9.0      # star counts for the mottling: as deep as the catalogue is nearly complete
COUNT_SIGMA = 1.0      # degrees: some 25 stars in a patch on the Milky Way
COUNT_MIDDLE_SIGMA, COUNT_WIDE_SIGMA = 2.4, 9.0
MOTTLING, MIDDLE_MOTTLING = 0.36, 0.45   # exponents of the local over-densities: fine over middle, middle over wide
# The Magellanic clouds, which the outlines lack: RA, Dec, semi-axes and position angle (degrees, north through east),
# brightness beside the Milky Way's; round figures after de Vaucouleurs & Freeman (1972).
CLOUDS = ((80.9, -69.75, 2.4, 2.0, 170.0, 0.20), (80.9, -69.75, 1.6, 0.6, 120.0, 0.25),
          (13.2, -72.8, 1.3, 0.8, 45.0, 0.22))
RA_CENTRE, DEC_CENTRE = 266.405, -28.936      # galactic centre, J2000
RA_POLE, DEC_POLE = 192.8595, 27.1284         # north galactic pole, J2000
COLD, WARM = (0.80, 0.90, 1.0), (1.0, 0.80, 0.56)   # outer disc: A and F stars; bulge: K giants behind dust


# -------------------- input and output

def package_file(package, name):
    if os.path.isdir(package):
        with open(os.path.join(package, name), "rb") as file:
            return file.read()
    with tarfile.open(package) as archive:
        return archive.extractfile("package/" + name).read()


def write_png(path, width, height, rows):
    """rows: bytes of RGB; filter per row by the smallest sum of absolute differences."""
    def filtered(row, above):
        left = bytes(3) + row[:-3]
        corner = bytes(3) + above[:-3]
        candidates = [bytes([0]) + row,
                      bytes([1]) + bytes((a - b) & 255 for a, b in zip(row, left)),
                      bytes([2]) + bytes((a - b) & 255 for a, b in zip(row, above)),
                      bytes([4]) + bytes((x - paeth(a, b, c)) & 255 for x, a, b, c in zip(row, left, above, corner))]
        return min(candidates, key=lambda line: sum(min(v, 256 - v) for v in line[1:]))

    def paeth(a, b, c):
        pa, pb, pc = abs(b - c), abs(a - c), abs(a + b - 2 * c)
        return a if pa <= pb and pa <= pc else b if pb <= pc else c

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    lines, above = [], bytes(3 * width)
    for row in rows:
        lines.append(filtered(row, above))
        above = row
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"sRGB", b"\0") + chunk(b"IDAT", zlib.compress(b"".join(lines), 9)) + chunk(b"IEND", b""))


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


# -------------------- maps: HEIGHT arrays of WIDTH floats

def column(ra):
    return (0.5 - ra / 360.0) * WIDTH


def fill(rings):
    """1 inside: even-odd crossings along the meridian from the north celestial pole, which is outside of all levels."""
    crossings = [[] for _ in range(WIDTH)]
    for ring in rings:
        for (ra0, dec0), (ra1, dec1) in zip(ring, ring[1:] + ring[:1]):
            x0 = column(ra0) - 0.5
            step = -((ra1 - ra0 + 180.0) % 360.0 - 180.0) / 360.0 * WIDTH   # the short way round
            x1 = x0 + step
            for x in range(math.ceil(min(x0, x1)), math.ceil(max(x0, x1))):
                crossings[x % WIDTH].append(dec0 + (dec1 - dec0) * (x - x0) / step)
    rows = [array.array("d", bytes(8 * WIDTH)) for _ in range(HEIGHT)]
    for x, decs in enumerate(crossings):
        decs.sort(reverse=True)
        assert len(decs) % 2 == 0, "the south celestial pole must be outside, too"
        for top, bottom in zip(decs[::2], decs[1::2]):
            y0, y1 = ((90.0 - dec) / 180.0 * HEIGHT for dec in (top, bottom))
            for y in range(int(y0), min(int(y1) + 1, HEIGHT)):   # covered part of the pixel
                rows[y][x] += min(y1, y + 1) - max(y0, y)
    return rows


def box_pass(line, radius, wrap):
    """Mean over 2 radius + 1 neighbours, radius fractional; wrapped or clamped at the ends."""
    n, whole = len(line), int(radius)
    part, norm = radius - whole, 1.0 / (2.0 * radius + 1.0)
    reach = whole + 1
    padded = (line[-reach:] + line + line[:reach]) if wrap else \
        array.array("d", [line[0]] * reach) + line + array.array("d", [line[-1]] * reach)
    total = math.fsum(padded[1:2 * whole + 2])
    out = array.array("d", bytes(8 * n))
    for i in range(n):
        out[i] = (total + part * (padded[i] + padded[i + 2 * reach])) * norm
        total += padded[i + 2 * whole + 2] - padded[i + 1]
    return out


def blur(rows, sigma_degrees):
    """Gaussian on the sphere: three box passes each way, along a parallel widened by 1/cos(declination)."""
    sigma = sigma_degrees / 180.0 * HEIGHT
    columns = [array.array("d", values) for values in zip(*rows)]
    for _ in range(3):
        columns = [box_pass(line, box_radius(sigma), False) for line in columns]
    rows = [array.array("d", values) for values in zip(*columns)]
    for y in range(HEIGHT):
        cosine = math.sin((y + 0.5) / HEIGHT * math.pi)
        radius = min(box_radius(sigma / cosine), WIDTH / 2 - 2)
        for _ in range(3):
            rows[y] = box_pass(rows[y], radius, True)
    return rows


def box_radius(sigma):
    return max((math.sqrt(4.0 * sigma * sigma + 1.0) - 1.0) / 2.0, 0.0)   # variance of three boxes = sigma^2


def star_density(stars):
    """Stars a square degree brighter than COUNT_LIMIT."""
    rows = [array.array("d", bytes(8 * WIDTH)) for _ in range(HEIGHT)]
    for ra, dec, mag, _ in stars:
        if mag <= COUNT_LIMIT:
            y = min(int((90.0 - dec) / 180.0 * HEIGHT), HEIGHT - 1)
            rows[y][int(column(ra)) % WIDTH] += 1.0
    for y in range(HEIGHT):
        pixel = (180.0 / HEIGHT)**2 * math.sin((y + 0.5) / HEIGHT * math.pi)
        rows[y] = array.array("d", [value / pixel for value in rows[y]])
    return rows


def unit(ra, dec):
    ra, dec = math.radians(ra), math.radians(dec)
    return (math.cos(dec) * math.cos(ra), math.cos(dec) * math.sin(ra), math.sin(dec))


def galactic_axes():
    x, z = unit(RA_CENTRE, DEC_CENTRE), unit(RA_POLE, DEC_POLE)
    return x, (z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]), z


def galaxy_model(longitude, latitude):
    """(disc, bulge): smooth surface brightness, each 1 at its peak; angles in degrees."""
    along = math.exp(-1.1 * (1.0 - math.cos(math.radians(longitude))))
    thickness = 4.5 + 2.5 * along
    disc = (0.30 + 0.70 * along) / math.cosh(latitude / thickness)
    bulge = math.exp(-math.hypot(longitude / 13.0, latitude / 8.0)**1.4)
    return disc, bulge


def clouds(ra, dec):
    light = 0.0
    for ra0, dec0, a, b, angle, peak in CLOUDS:
        east, north = ((ra - ra0 + 180.0) % 360.0 - 180.0) * math.cos(math.radians(dec)), dec - dec0
        if abs(north) > 6.0 * a or abs(east) > 6.0 * a:
            continue
        s, c = math.sin(math.radians(angle)), math.cos(math.radians(angle))
        light += peak * math.exp(-0.5 * (((east * s + north * c) / a)**2 + ((east * c - north * s) / b)**2))
    return light


def noise(x, y, c):
    value = (x * 374761393 + y * 668265263 + c * 1274126177) & 0xffffffff
    value = ((value ^ value >> 13) * 1274126177) & 0xffffffff
    return ((value ^ value >> 16) & 0xffff) / 65536.0


def encode(linear):
    linear = min(max(linear, 0.0), 1.0)
    return 255.0 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear**(1.0 / 2.4) - 0.055)


def milky_way(outlines, stars):
    """Linear RGB triples, row by row."""
    levels = []
    for index in range(LEVELS):
        polygons = outlines["features"][index]["geometry"]["coordinates"]
        levels.append(blur(fill([ring for polygon in polygons for ring in polygon]), LEVEL_SIGMA[index]))
    density = star_density(stars)
    fine, middle, wide = (blur(density, sigma) for sigma in (COUNT_SIGMA, COUNT_MIDDLE_SIGMA, COUNT_WIDE_SIGMA))
    axes = galactic_axes()
    rows = []
    for y in range(HEIGHT):
        row = []
        for x in range(WIDTH):
            ra, dec = (0.5 - (x + 0.5) / WIDTH) * 360.0, 90.0 - (y + 0.5) / HEIGHT * 180.0
            d = unit(ra, dec)
            gx, gy, gz = (sum(a * b for a, b in zip(axis, d)) for axis in axes)
            disc, bulge = galaxy_model(math.degrees(math.atan2(gy, gx)), math.degrees(math.asin(gz)))
            outline = sum(w * level[y][x] for w, level in zip(LEVEL_WEIGHT, levels))
            mottling = ((fine[y][x] + 0.3) / (middle[y][x] + 0.3))**MOTTLING * \
                ((middle[y][x] + 0.3) / (wide[y][x] + 0.3))**MIDDLE_MOTTLING
            light = outline * (0.50 + 0.45 * disc + 0.25 * bulge) * mottling
            light += 0.06 * disc + 0.16 * bulge + clouds(ra, dec)
            warmth = min(1.0, 0.15 * disc + 0.85 * bulge**0.7 + 0.10 * (1.0 - abs(gz))**8)
            row.append([light * (c + (w - c) * warmth) for c, w in zip(COLD, WARM)])
        rows.append(row)
    return rows


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = sys.argv[2] if len(sys.argv) == 3 else os.path.join(os.path.dirname(__file__), "..", "assets", "sky")
    stars = read_stars(package_file(sys.argv[1], "data/stars.14.json"))
    write_stars(os.path.join(folder, "stars.bin"), stars)
    with open(os.path.join(folder, "LICENSE-d3-celestial.txt"), "wb") as file:
        file.write(package_file(sys.argv[1], "LICENSE"))
    light = milky_way(json.loads(package_file(sys.argv[1], "data/mw.json")), stars)
    peak = max(max(pixel) for row in light for pixel in row)
    rows = [bytes(int(encode(value / peak) + noise(x, y, c)) if value / peak < 1.0 else 255   # dithered against banding
                  for x, pixel in enumerate(row) for c, value in enumerate(pixel)) for y, row in enumerate(light)]
    write_png(os.path.join(folder, "milky-way.png"), WIDTH, HEIGHT, rows)


if __name__ == "__main__":
    main()
