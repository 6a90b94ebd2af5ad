#!/usr/bin/env bash
# ehtim 1.3.2, ehtim.image.load_fits: BUNIT is looked at for "JY/BEAM" alone.
#
# Guessed: units that FITS' standard names are converted to Jy a pixel (a brightness temperature by 2 k nu^2/c^2 and the pixel's solid angle), or
# refused where ehtim cannot.
# Seen: numbers in K, mJy/pixel, Jy/sr and W are all taken as Jy a pixel, without a word: 1 K in a pixel of 1 microarcsecond at 230 GHz,
# which is 3.8e-14 Jy, is read as a source of 1 Jy.
# Who hands pictures to ehtim converts to JY/PIXEL first.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet ehtim==1.3.2 astropy==8.0.2 numpy==2.4.6
cd "$folder"
venv/bin/python -W ignore - <<'PYTHON'
import math
import sys

import ehtim
import numpy as np
from astropy.io import fits

UAS, GHZ = 1 / 3600e6, 230.0
jansky_of_a_kelvin = 2 * 1.380649e-23 * (GHZ * 1e9 / 299792458.0) ** 2 * math.radians(UAS) ** 2 * 1e26
flux = {}
for unit in ("JY/PIXEL", "K", "mJy/pixel", "Jy/sr", "W"):
    header = fits.Header({"CTYPE1": "RA---SIN", "CTYPE2": "DEC--SIN", "CRVAL1": 187.7, "CRVAL2": 12.4, "CDELT1": -UAS, "CDELT2": UAS, "CRPIX1": 16.5,
                          "CRPIX2": 16.5, "OBJECT": "TEST", "FREQ": GHZ * 1e9, "MJD": 57850.0, "BUNIT": unit})
    picture = np.zeros((32, 32))
    picture[18, 20] = 1
    fits.PrimaryHDU(picture, header).writeto("picture.fits", overwrite=True)
    flux[unit] = ehtim.image.load_fits("picture.fits").total_flux()
print({unit: float(value) for unit, value in flux.items()}, f"1 K is {jansky_of_a_kelvin:.2g} Jy")
changed = [unit for unit, value in flux.items() if abs(value - 1) > 1e-12]
sys.exit(f"changed: {', '.join(changed)}" if changed else 0)
PYTHON
