#!/usr/bin/env bash
# ehtim 1.3.2, ehtim.image.load_fits: where a pixel lies on the sky is taken from the size |CDELT1| and the number of pixels alone.
#
# Guessed: the header's axes decide, as astropy's WCS has them, or a header that cannot be honoured is refused.
# Seen: without a word,
#   CDELT1 > 0 (right ascension grows to the right): read as if it grew to the left, a mirrored sky;
#   CDELT2 < 0: read as if declination grew upwards;
#   |CDELT2| = 2 |CDELT1|: square pixels of |CDELT1|;
#   CUNIT = arcsec: degrees, a picture 3,600 times too large;
#   CRPIX in the first pixel: the middle of the picture;
#   CROTA2 = 90: not rotated.
# Who hands pictures to ehtim writes east to the left, north up, square pixels, degrees, the reference pixel in the middle.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet ehtim==1.3.2 astropy==8.0.2 numpy==2.4.6
cd "$folder"
venv/bin/python -W ignore - <<'PYTHON'
import sys

import ehtim
import numpy as np
from astropy.io import fits
from astropy.wcs import WCS

UAS = 1 / 3600e6                      # degrees
COLUMN, ROW, SIZE = 20, 18, 32        # of the only pixel with light
USUAL = {"CTYPE1": "RA---SIN", "CTYPE2": "DEC--SIN", "CUNIT1": "deg", "CUNIT2": "deg", "CRVAL1": 187.7, "CRVAL2": 0.0, "CDELT1": -UAS, "CDELT2": UAS,
         "CRPIX1": SIZE / 2 + 0.5, "CRPIX2": SIZE / 2 + 0.5, "OBJECT": "TEST", "FREQ": 230e9, "MJD": 57850.0, "BUNIT": "JY/PIXEL"}


def places(changes):
    """Offset of the light from the reference point to the east and north, microarcseconds: by astropy and by ehtim."""
    header = fits.Header({**USUAL, **changes})
    picture = np.zeros((SIZE, SIZE))
    picture[ROW, COLUMN] = 1
    fits.PrimaryHDU(picture, header).writeto("picture.fits", overwrite=True)
    east, north = WCS(header).wcs_pix2world([[COLUMN, ROW]], 0)[0] - [USUAL["CRVAL1"], USUAL["CRVAL2"]]
    read = ehtim.image.load_fits("picture.fits")
    return np.array([east, north]) / UAS, np.array(read.centroid()) / ehtim.RADPERUAS


usual, _ = places({})
cases = {"east to the right": {"CDELT1": UAS}, "south up": {"CDELT2": -UAS}, "pixels twice as high": {"CDELT2": 2 * UAS},
         "reference in the first pixel": {"CRPIX1": 1.0, "CRPIX2": 1.0}, "turned by 90 degrees": {"CROTA2": 90.0}}
changed = []
exact, read = places({})
print(f"{'as usual':<30} astropy {exact.round(2)}, ehtim {read.round(2)}")
if abs(exact - read).max() > 0.1:
    changed.append("as usual")
for name, changes in cases.items():
    exact, read = places(changes)
    print(f"{name:<30} astropy {exact.round(2)}, ehtim {read.round(2)}")
    if abs(exact - usual).max() < 1 or abs(read - usual).max() > 0.1:
        changed.append(name)
_, read = places({"CUNIT1": "arcsec", "CUNIT2": "arcsec", "CDELT1": -1e-6, "CDELT2": 1e-6, "CRVAL1": 0.0})
print(f"{'a picture in arcseconds':<30} ehtim {read.round(2)}")
if abs(read / usual - 3600).max() > 1:
    changed.append("arcseconds")
sys.exit(f"changed: {', '.join(changed)}" if changed else 0)
PYTHON
