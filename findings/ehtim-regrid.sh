#!/usr/bin/env bash
# ehtim 1.3.2, Image.regrid_image(targetfov, npix): a picture on another grid of pixels.
#
# Guessed: places and sizes on the sky stay, and so does the flux of a source that pixels resolve and the new field holds.
# Seen: without a word, both grids are laid from edge to edge of their fields, first and last pixel centres on the edges, whereas everything else in
# ehtim has centres half a pixel inside. From N to n pixels, whatever the fields and the interpolation,
#   every distance from the middle, and so a ring's diameter, is s = (1 - 1/n) / (1 - 1/N) times as large;
#   flux is s^2 times as large: from 640 to 64 pixels a ring is 1.4 % narrower and 2.8 % fainter, to 32 pixels 3.0 % and 5.9 %;
#       from 32 to 640 pixels it is 3.1 % wider and 6.2 % brighter;
#   there and back again gives the first values: errors of the two ways cancel, so that a round trip shows nothing.
# Who coarsens a simulated picture for ehtim averages blocks of pixels, which keeps places and flux, and scales where regrid_image is needed.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet ehtim==1.3.2 astropy==8.0.2 numpy==2.4.6 scipy==1.17.1
cd "$folder"
venv/bin/python -W ignore - <<'PYTHON'
import sys

import ehtim
import numpy as np

UAS, FIELD, DIAMETER, WIDTH, EAST = ehtim.RADPERUAS, 160.0, 42.0, 12.0, 9.0      # microarcseconds; EAST: of the ring's middle


def ring(pixels):
    """A smooth ring of 1 Jy on a grid of pixels."""
    side = ((pixels - 1) / 2 - np.arange(pixels)) * FIELD / pixels
    radius = np.hypot(side[None] - EAST, side[:, None])
    light = np.exp(-4 * np.log(2) * ((radius - DIAMETER / 2) / WIDTH) ** 2)
    return ehtim.image.Image(light / light.sum(), FIELD / pixels * UAS, 0.0, 0.0)


def measured(picture):
    """Flux in Jy, place of the middle to the east and twice the root mean square radius about it, microarcseconds."""
    light = picture.imarr()
    columns, rows = (((count - 1) / 2 - np.arange(count)) * picture.psize / UAS for count in (picture.xdim, picture.ydim))
    east, north = (light.sum(0) * columns).sum() / light.sum(), (light.sum(1) * rows).sum() / light.sum()
    square = (light * ((columns[None] - east) ** 2 + (rows[:, None] - north) ** 2)).sum() / light.sum()
    return np.array([light.sum(), east, 2 * np.sqrt(square)])


def blocks(picture, pixels):
    """The picture on fewer pixels: sums over blocks."""
    each = picture.xdim // pixels
    return ehtim.image.Image(picture.imarr().reshape(pixels, each, pixels, each).sum((1, 3)), each * picture.psize, 0.0, 0.0)


changed = []


def compare(name, before, after, factor, tolerance):
    seen, expected = measured(after) / measured(before), np.array([factor**2, factor, factor])
    print(f"{name:<38} flux, place and size times {seen.round(4)}, described {expected.round(4)}")
    if abs(seen - expected).max() > tolerance:
        changed.append(name)


fine = ring(640)
print("the ring itself: flux, place, size", measured(fine).round(4))
for start, count, field, kind in ((640, 64, FIELD, "linear"), (640, 64, FIELD, "cubic"), (640, 64, 200.0, "cubic"), (640, 32, FIELD, "cubic"),
                                  (32, 640, FIELD, "cubic")):
    before = ring(start)
    compare(f"{start} to {count}, field {field:.0f}, {kind}", before, before.regrid_image(field * UAS, count, interp=kind),
            (1 - 1 / count) / (1 - 1 / start), 2e-3)
there = fine.regrid_image(FIELD * UAS, 64, interp="cubic")
compare("640 to 64 to 640", fine, there.regrid_image(FIELD * UAS, 640, interp="cubic"), 1.0, 2e-3)
for count in (64, 32):
    compare(f"640 to {count} by blocks", fine, blocks(fine, count), 1.0, 6e-3)
sys.exit(f"changed: {', '.join(changed)}" if changed else 0)
PYTHON
