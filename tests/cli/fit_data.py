"""Data for fits, written without the program: a scene and what is free in it, pictures as FITS, noise that a seed gives."""
import random
import re
import struct

CARD, BLOCK = 80, 2880
SCENE = """[spacetime]
metric = "kerr"
spin = 0.7
[camera]
r = 500.0
theta = 50.0
fov = 3.0
size = [%d, %d]
[sky]
kind = "black"
[disc]
emission = "thermal"
temperature = 5000.0
outer = 10.0
edge = 0.3
[light]
band = "bolometric"
"""
TRUE = {"spacetime.spin": 0.7, "camera.theta": 50.0}


def fits(rows):
    """The bytes of a picture of doubles; rows from the top, which FITS has last."""
    cards = ["SIMPLE  = %20s" % "T", "BITPIX  = %20d" % -64, "NAXIS   = %20d" % 2, "NAXIS1  = %20d" % len(rows[0]), "NAXIS2  = %20d" % len(rows), "END"]
    header = "".join(card.ljust(CARD) for card in cards).encode()
    numbers = b"".join(struct.pack(">%dd" % len(row), *row) for row in reversed(rows))
    return header + b" " * (-len(header) % BLOCK) + numbers + b"\0" * (-len(numbers) % BLOCK)


def rows_of(data):
    """Of the first plane of a FITS file of floats; rows from the top."""
    header = re.match(rb"(?:.{80})*?END {77}", data, re.S)[0]
    width, height = (int(re.search(rb"NAXIS%d *= *(\d+)" % axis, header)[1]) for axis in (1, 2))
    at = len(header) + -len(header) % BLOCK
    kind, size = ("f", 4) if b"-32" in re.search(rb"BITPIX *= *(\S+)", header)[1] else ("d", 8)
    numbers = struct.unpack(">%d%s" % (width * height, kind), data[at:at + size * width * height])
    return [list(numbers[y * width:(y + 1) * width]) for y in reversed(range(height))]


def noisy(rows, sigma, seed):
    dice = random.Random(seed)
    return [[value + dice.gauss(0, sigma) for value in row] for row in rows]


def brightest(rows):
    return max(map(max, rows))
