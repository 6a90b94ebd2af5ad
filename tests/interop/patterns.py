"""A picture whose every pixel is another, as a file that is written here byte by byte, and what light it is."""
import re

import numpy as np

import support

WIDTH, HEIGHT = 37, 21


def codes(bits):
    """Rows of pixels of red, green and blue."""
    x, y = np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT))
    eight = np.stack([(7 * x + y) % 256, 11 * y % 256, x * y % 256], axis=-1)
    return eight if bits == 8 else 257 * eight + (x + 3 * y)[:, :, None] - 257 * (eight == 255)


def write_source(folder):
    """eight.ppm and sixteen.ppm, of 8 and 16 bits a colour; and their light, eight.exr and sixteen.exr, of which nullscope's is to be the same."""
    for name, bits in (("eight", 8), ("sixteen", 16)):
        values = codes(bits)
        head = f"P6\n{WIDTH} {HEIGHT}\n{2 ** bits - 1}\n".encode()
        (folder / (name + ".ppm")).write_bytes(head + values.astype("u1" if bits == 8 else ">u2").tobytes())
        write_light(folder / (name + ".exr"), values / (2 ** bits - 1))


def write_light(path, display):
    """Of sRGB-encoded values, by IEC 61966-2-1."""
    light = np.where(display <= 0.04045, display / 12.92, ((display + 0.055) / 1.055) ** 2.4)
    support.write_exr(path, {channel: light[:, :, i] for i, channel in enumerate("RGB")})


def read_pnm(path):
    """Rows of pixels of a P6 or P5."""
    data = path.read_bytes()
    kind, width, height, most = re.match(rb"(P[56])\s+(?:#[^\n]*\n)?(\d+)\s+(\d+)\s+(\d+)\s", data).groups()
    size = 1 if int(most) < 256 else 2
    start = len(data) - int(width) * int(height) * (3 if kind == b"P6" else 1) * size
    return np.frombuffer(data, "u1" if size == 1 else ">u2", offset=start).reshape(int(height), int(width), -1).astype(int)


def difference(folder, name, meant):
    """The largest, of what nullscope reads of two pictures, as display values."""
    said = support.nullscope("compare", name, meant, folder=folder)
    return float(re.search(r"^difference\s+max (\S+)", said, re.M)[1])
