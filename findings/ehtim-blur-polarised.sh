#!/usr/bin/env bash
# ehtim 1.3.2, Image.blur_circ(fwhm_i, fwhm_pol, filttype) of an image with Q, U and V.
#
# Guessed: I is blurred by a beam of fwhm_i, and each of Q, U and V by one of fwhm_pol, whichever filter is chosen; flux is kept.
# Seen: without a word,
#   "gauss": fwhm_pol is a switch. 0 leaves Q, U and V sharp; any other value blurs them by fwhm_i, be it smaller or larger;
#   "butter": each of Q, U and V is replaced by the filtered I. A source with Q = 0.3 I, U = 0.1 I, V = 0.05 I ends with Q = U = V, each with the
#       flux of I: polarised by 173 %.
# Who compares polarised pictures at a telescope's resolution uses "gauss" with fwhm_pol = fwhm_i (which is right), and blurs Q, U and V as images
# of their own where another beam or filter is wanted.
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

UAS, SIZE = ehtim.RADPERUAS, 96         # pixels of 1 microarcsecond
PARTS = {"I": 1.0, "Q": 0.3, "U": 0.1, "V": 0.05}
point = np.zeros((SIZE, SIZE))
point[SIZE // 2, SIZE // 2] = 1
source = ehtim.image.Image(point, UAS, 0.0, 0.0)
source.add_qu(PARTS["Q"] * point, PARTS["U"] * point)
source.add_v(PARTS["V"] * point)


def blurred(fwhm_i, fwhm_pol, kind):
    """Stokes parameters of the point source behind ehtim's beams, microarcseconds."""
    picture = source.blur_circ(fwhm_i * UAS, fwhm_pol * UAS, filttype=kind)
    return {"I": picture.imvec, "Q": picture.qvec, "U": picture.uvec, "V": picture.vvec}


def peak(fwhm):
    """Of a unit source behind a Gaussian beam: 4 ln 2 / (pi FWHM^2) of it in the brightest pixel, all of it without a beam."""
    return 4 * np.log(2) / (np.pi * fwhm**2) if fwhm else 1.0


changed = []
for fwhm_pol in (0, 2, 5, 10):
    seen = {name: values.max() / PARTS[name] for name, values in blurred(5, fwhm_pol, "gauss").items()}
    print(f"gauss, I by 5, the others by {fwhm_pol:>2}: peaks", {name: round(float(value), 4) for name, value in seen.items()},
          f"expected {peak(5):.4f} and {peak(fwhm_pol):.4f}")
    described = {name: peak(5 if name == "I" or fwhm_pol else 0) for name in PARTS}
    if any(abs(seen[name] / described[name] - 1) > 0.02 for name in PARTS):
        changed.append(f"gauss {fwhm_pol}")
for fwhm_pol in (0, 5, 10):
    seen = blurred(5, fwhm_pol, "butter")
    flux = {name: round(float(values.sum()), 4) for name, values in seen.items()}
    print(f"butter, I by 5, the others by {fwhm_pol:>2}: flux", flux, "expected", PARTS)
    if any(abs(flux[name] - (1 if fwhm_pol else part)) > 1e-3 for name, part in PARTS.items()):
        changed.append(f"butter {fwhm_pol}")
    if fwhm_pol == 5 and any(abs(seen[name] - seen["I"]).max() > 1e-12 for name in "QUV"):
        changed.append("butter: no copies of I")
sys.exit(f"changed: {', '.join(changed)}" if changed else 0)
PYTHON
