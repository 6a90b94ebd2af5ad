"""casacore, whose reader of images CARTA and CASA have: values, unit, axes and places on the sky."""

import casacore
import numpy as np
from astropy.io import fits
from astropy.wcs import WCS
from casacore.images import image

import support

PROGRAM = f"casacore {casacore.__version__}"
SIZE = 96, 72
PLACES = (20, 30), (60, 11), (77, 50)   # as FITS counts pixels


def opened(report, folder):
    for scene in ("m87", "m87-swirl", "sgr-a-synchrotron"):
        support.nullscope("capture", scene, "--size", "%dx%d" % SIZE, "-o", scene + ".fits", folder=folder)
        with fits.open(folder / (scene + ".fits")) as file:
            header, light = file[0].header, file[0].data.astype(np.float32)
        read = image(str(folder / (scene + ".fits")))
        report.same_bits(f"{scene}: all pixels", read.getdata(), light)
        coordinates = read.coordinates()
        names = list(coordinates.get_names())
        report.add(f"{scene}: axes {names}", int(names != ["stokes"] * (light.ndim == 3) + ["direction"]), 0)
        report.add(f"{scene}: another frame than ICRS", int(coordinates.get_coordinate("direction").get_frame() != "ICRS"), 0)
        report.add(f"{scene}: unit {read.unit() or 'none'}", int(read.unit() != header.get("BUNIT", "").strip()), 0)
        wcs, off = WCS(header).celestial, []
        for x, y in PLACES:
            world = read.toworld([0] * (light.ndim - 2) + [y - 1, x - 1])
            found = np.degrees([float(value) for value in world[-1:-3:-1]])
            meant = np.array(wcs.pixel_to_world_values(x - 1, y - 1))
            off.append(np.abs(found - meant).max() / abs(header["CDELT2"]))
            print(f"     {scene} at {x}, {y}: {found[0]:.15f} {found[1]:.15f} deg, {light[(0,) * (light.ndim - 2) + (y - 1, x - 1)]:.7g}")
        report.add(f"{scene}: right ascension and declination of three pixels against astropy's", max(off), 1e-3, "px ")
        if light.ndim == 3:
            stokes = [float(read.toworld([plane, 0, 0])[0]) for plane in range(4)]
            report.add(f"{scene}: planes that are not I, Q, U, V (1 to 4)", sum(a != b for a, b in zip(stokes, (1, 2, 3, 4))), 0)


if __name__ == "__main__":
    support.main(PROGRAM, opened)
