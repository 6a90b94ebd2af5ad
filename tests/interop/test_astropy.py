"""astropy: FITS files are whole, their checksums hold, and their coordinates put pixels where they are on the sky."""
import math
import warnings

import astropy
import numpy as np
from astropy.io import fits
from astropy.wcs import WCS

import support

PROGRAM = f"astropy {astropy.__version__}"
SIZE = 96, 72


def opened(report, folder):
    warnings.simplefilter("error")   # a warning fails the case
    for scene in ("m87", "m87-swirl", "sgr-a-synchrotron", "kerr"):
        support.nullscope("capture", scene, "--size", "%dx%d" % SIZE, "-o", scene + ".fits", folder=folder)
        support.nullscope("capture", scene, "--size", "%dx%d" % SIZE, "-o", scene + ".exr", folder=folder)
        with fits.open(folder / (scene + ".fits"), checksum=True) as file:   # and verifies CHECKSUM and DATASUM
            file.verify("exception")
            header, light = file[0].header, file[0].data
            colours = {part.name: part.data for part in file[1:]}
            coordinates(report, scene, header)
        meant = support.exr(folder / (scene + ".exr"))
        for name, channel in {"RED": "R", "GREEN": "G", "BLUE": "B"}.items():
            if name in colours:
                report.same_bits(f"{scene}: {name} from the bottom up", colours[name][::-1], meant[channel])
        if light.ndim == 3:
            for plane, name in ((0, "I"), (1, "Q"), (2, "U")):
                report.same_bits(f"{scene}: Stokes {name}", light[plane][::-1] * (1 if name == "I" else -1), meant["stokes." + name])


def saved(report, folder):
    """What astropy writes of a file is still a scene, and is drawn again; the spin axis has its position angle."""
    for scene in ("m87", "sgr-a-synchrotron"):
        support.nullscope("capture", scene, "--size", "%dx%d" % SIZE, "-o", "first.fits", folder=folder)
        with fits.open(folder / "first.fits") as file:
            file.writeto(folder / "saved.fits", overwrite=True)
            angle = file[0].header["SPIN_PA"]
        ours, theirs = (support.nullscope("scenes", name, folder=folder) for name in ("first.fits", "saved.fits"))
        report.add(f"{scene}: saved by it holds another scene", int(ours != theirs), 0)
        support.nullscope("capture", "saved.fits", "-o", "again.fits", folder=folder)
        report.add(f"{scene}: drawn again from that: bytes that differ", sum(a != b for a, b in zip((folder / "first.fits").read_bytes(), (folder / "again.fits").read_bytes(), strict=True)), 0)
        report.add(f"{scene}: SPIN_PA {angle:g} is no angle", int(not 0 <= angle < 360), 0)


def coordinates(report, scene, header):
    wcs = WCS(header).celestial
    x, y = header["CRPIX1"] - 1, header["CRPIX2"] - 1
    left, middle, above = (wcs.pixel_to_world_values(*place) for place in ((x - 10, y), (x, y), (x, y + 10)))
    step = header["CDELT2"]
    if header["CTYPE1"].startswith("RA"):
        east = (left[0] - middle[0]) * math.cos(math.radians(middle[1]))
        report.add(f"{scene}: ten pixels to the left, in pixels to the east, off by", abs(east / step - 10), 1e-3)
    report.add(f"{scene}: ten pixels up, in pixels to the north, off by", abs((above[1] - middle[1]) / step - 10), 0.2 if scene == "kerr" else 1e-3)


if __name__ == "__main__":
    support.main(PROGRAM, opened, saved)
