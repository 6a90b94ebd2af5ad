#!/usr/bin/env python3
"""Make assets/images/accretion-disc.png, an accretion disc seen from above. Standard library; always the same picture.

    python3 scripts/make_disc_image.py [output file]

The image's square is [-outer, outer]^2 and the disc begins at 0.25 outer (DiscSpec of src/scene/scene.h: 3 to 12 r_s).
Colour and brightness are a black body's of the thin disc's temperature, T ~ r^(-3/4) (1 - sqrt(r0 / r))^(1/4)
(Shakura & Sunyaev 1973); brightness is compressed and colour stretched to what a display can show. The structure is
made up: noise in (ln r, azimuth), periodic in azimuth, wound into trailing spirals as differential rotation does (the
gas turns counter-clockwise), and darker gaps.
"""
import math
import os
import struct
import sys
import zlib

SIZE = 1024
INNER = 0.25              # of outer
TORQUE_FREE = 0.82        # r0 / inner: below 1, so that the inner rim is not black
HOTTEST = 5000.0          # K, at the brightest radius: white-yellow
COLOUR_STRETCH = 2.1      # exponent on T for the colour, so that it spans white to deep red (1350 K at the rim)
COMPRESSION = 0.62        # exponent on brightness T^4: a span of 12 becomes one of 5
PEAK = 0.95               # linear, of the brightest streaks
WINDING = 4.2             # radians of azimuth a unit of ln r: spirals of 13 degrees of pitch
OCTAVES = ((4, 3.7, 0.46), (11, 9.0, 0.32), (27, 23.0, 0.24), (57, 61.0, 0.15))   # turns, cells a unit of ln r, weight
GAPS = ((0.36, 0.010, 0.35), (0.515, 0.016, 0.50), (0.70, 0.012, 0.40), (0.83, 0.02, 0.35))   # radius, width, depth
RIM = 0.10                # the outer rim fades over this


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


def encode(linear):
    linear = min(max(linear, 0.0), 1.0)
    return 255.0 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear**(1.0 / 2.4) - 0.055)


def hashed(i, j, octave):
    value = (i * 374761393 + j * 668265263 + octave * 2246822519 + 974711) & 0xffffffff
    value = ((value ^ value >> 15) * 2246822519) & 0xffffffff
    value = ((value ^ value >> 13) * 3266489917) & 0xffffffff
    return (value ^ value >> 16) / 4294967296.0


TABLES = [[[hashed(i, j, octave) for i in range(turns)] for j in range(int(1.6 * cells) + 4)]
          for octave, (turns, cells, _) in enumerate(OCTAVES)]


def smooth(t):
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0)


def value_noise(octave, azimuth, log_radius):
    """In [0, 1]; azimuth in turns, periodic; log_radius = ln(r / inner) in [0, ln 4]."""
    turns, cells, _ = OCTAVES[octave]
    x, y = azimuth % 1.0 * turns, max(log_radius, 0.0) * cells
    i, j = int(x), int(y)
    u, v = smooth(x - i), smooth(y - j)
    a, b = TABLES[octave][j], TABLES[octave][j + 1]
    i, k = i % turns, (i + 1) % turns
    return (a[i] * (1.0 - u) + a[k] * u) * (1.0 - v) + (b[i] * (1.0 - u) + b[k] * u) * v


def turbulence(azimuth, log_radius):
    """About 1 in the mean, 0.2 to 2."""
    total = 0.0
    for octave, (_, _, weight) in enumerate(OCTAVES):
        wound = azimuth + (WINDING + 0.9 * octave) / (2.0 * math.pi) * log_radius
        total += weight * (2.0 * value_noise(octave, wound, log_radius) - 1.0)
    return math.exp(1.5 * total)


def lobe(nm, peak, below, above):
    return math.exp(-0.5 * ((nm - peak) / (below if nm < peak else above))**2)


def black_body(kelvin):
    """Linear Rec. 709 of luminance 1; CIE 1931 by Wyman, Sloan, Shirley (2013)."""
    x = y = z = 0.0
    for nm in range(380, 781, 10):
        power = nm**-5.0 / math.expm1(1.438776877e7 / (nm * kelvin))
        x += power * (1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
                      0.065 * lobe(nm, 501.1, 20.4, 26.2))
        y += power * (0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1))
        z += power * (1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8))
    rgb = (3.2404542 * x - 1.5371385 * y - 0.4985314 * z, -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
           0.0556434 * x - 0.2040259 * y + 1.0572252 * z)
    return [max(c, 0.0) / y for c in rgb]


def temperature(r):
    """Relative to the hottest radius, (49 / 36) r0."""
    def law(q):
        return q**-0.75 * max(1.0 - q**-0.5, 0.0)**0.25
    return law(r / (INNER * TORQUE_FREE)) / law(49.0 / 36.0)


def fade(t):
    return smooth(min(max(t, 0.0), 1.0))


def pixel(x, y, colours):
    r = math.hypot(x, y)
    edge = 1.5 * 2.0 / SIZE
    cover = fade((r - INNER) / edge + 0.5) * fade((1.0 - edge - r) / RIM)
    if cover <= 0.0:
        return bytes(3)
    heat = turbulence(math.atan2(y, x) / (2.0 * math.pi), math.log(r / INNER))
    t = temperature(r) * heat**0.12     # thin streaks are a little cooler
    light = PEAK * 0.72 * t**(4.0 * COMPRESSION) * heat**0.9 * cover
    for radius, width, depth in GAPS:
        light *= 1.0 - depth * math.exp(-((r - radius - 0.006 * (heat - 1.0)) / width)**2)
    colour = colours[min(int(t**COLOUR_STRETCH * 200.0), len(colours) - 1)]
    highest = max(colour)
    light = min(light, 4.0) / (1.0 + 0.25 * max(light - 0.6, 0.0))      # a shoulder instead of clipping
    return bytes(int(encode(light * c / highest) + 0.5) for c in colour)


def main():
    folder = os.path.join(os.path.dirname(__file__), "..", "assets", "images")
    path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(folder, "accretion-disc.png")
    colours = [black_body(max(HOTTEST * (i + 0.5) / 200.0, 1200.0)) for i in range(320)]
    centres = [(2.0 * i + 1.0) / SIZE - 1.0 for i in range(SIZE)]
    write_png(path, SIZE, SIZE, [b"".join(pixel(x, -y, colours) for x in centres) for y in centres])


if __name__ == "__main__":
    main()
