#!/usr/bin/env bash
# Unsigned 16-bit FITS (BITPIX = 16, BZERO = 32768: what cameras of telescopes write, and the standard's own way of storing them) in readers of
# pictures: OpenImageIO 3.2.2.0 and Pillow 13.0.0.
#
# Guessed: pixels are BZERO + BSCALE x the stored number, as astropy has them; a reader that does not scale says so.
# Seen: both ignore BZERO and BSCALE, without a word, and differ from each other.
#   OpenImageIO gives the stored signed numbers: values below 32768 are negative, those above positive;
#   Pillow gives the stored bits as unsigned numbers ("I;16"): everything is off by 32768, modulo 65536, so that dark and bright halves of the
#   range change places.
# A picture of a telescope's camera as a sky goes through astropy, or is stored as 32-bit floats, which both read right.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet OpenImageIO==3.2.2.0 pillow==13.0.0 astropy==8.0.2 numpy==2.4.6
cd "$folder"
venv/bin/python - <<'PYTHON'
import sys

import numpy as np
import OpenImageIO as oiio
from astropy.io import fits
from PIL import Image

values = np.array([[100, 30000, 32768, 60000]])


def read(name):
    """The numbers of the file's only row by each reader."""
    picture = oiio.ImageInput.open(name)
    own = picture.spec().format     # integers as they are stored, not as parts of the largest
    return fits.getdata(name)[0].tolist(), np.ravel(picture.read_image(own)).tolist(), np.asarray(Image.open(name))[0].tolist()


fits.PrimaryHDU(values.astype("uint16")).writeto("unsigned.fits")
fits.PrimaryHDU(values.astype("float32")).writeto("float.fits")
(exact, by_oiio, by_pillow), floats = read("unsigned.fits"), read("float.fits")
print("unsigned 16 bits: astropy", exact, "OpenImageIO", by_oiio, "Pillow", by_pillow)
print("float: astropy, OpenImageIO, Pillow", *floats)
good = exact == values[0].tolist() and all(row == values[0].tolist() for row in floats)
as_described = by_oiio == (values[0] - 32768).tolist() and by_pillow == ((values[0] + 32768) % 65536).tolist()
sys.exit(0 if good and as_described else "changed: the readers no longer do what this file says")
PYTHON
