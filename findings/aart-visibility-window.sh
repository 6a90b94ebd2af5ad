#!/usr/bin/env bash
# aart 2.1.10, aart.visamp.cvisibility: the visibility of a picture of a disc, by the Fourier transform of its projection.
#
# Guessed: V at baseline 0 is the picture's flux, the same for every `limits` (the half width of the picture) that holds all of the light; the phase of a picture
# about the hole is counted from the hole, so that of a nearly symmetrical ring is near 0 on short baselines.
# Seen: without a word,
#   the projection is multiplied by a Tukey window whose tapers begin at half of `limits`: of a ring of 6 M radius seen at 17 degrees (all light within 9 M)
#       limits = 10 keeps 89 % of the flux that limits = 20 has, and short baselines see a smaller ring;
#   the phase is counted from the edge of the picture at -limits: with limits = 20 it turns as that of a source 20 M farther off than the light is.
# Who compares amplitudes gives `limits` of twice the radius of the light; who takes phases or closure phases of cvisibility multiplies by exp(2 pi i u limits).
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet aart==2.1.10 numpy==1.26.4 scipy==1.14.1 scikit-image==0.24.0 matplotlib==3.11.2 h5py==3.16.0 imageio==2.38.1 mpmath==1.4.1
cd "$folder"
venv/bin/python -W ignore - <<'PYTHON'
import contextlib
import glob
import io
import sys

import h5py
import numpy as np

import aart
import aart.lensingbands
import aart.parameters
import aart.radialintensity
import aart.raytracing
import aart.rprofs_f
import aart.visamp

aart.rprofs_f.profile = lambda r, *others: np.exp(-0.5 * ((r - 6) / 0.6) ** 2)   # of the disc: a ring
METRES, DISTANCE = 6.67e-11 * 6.2e9 * 1.07473555940836 * 1.988435e30 / 2.99792458e8 ** 2, 5.214795112e23   # M, and the distance, of its defaults


def seen(limits):
    """Baselines in wavelengths, complex V."""
    given = aart.parameters.generate_dict([0.5], [17], [1.0], limits=limits, dx0=0.1, dx1=0.1, dx2=0.1, radonangles=[0], path=f"of-{limits}/", maxbaseline=5, npointsS=12)
    with contextlib.redirect_stdout(io.StringIO()):
        aart.lensingbands.clb(**given)
        aart.raytracing.raytrace(**given)
        aart.radialintensity.cintensity(**given)
        aart.visamp.cvisibility(**given)
    with h5py.File(glob.glob(f"of-{limits}/Intensity*")[0]) as file:
        far = np.abs(np.linspace(-limits, limits, file["bghts0"].shape[0]))[:, None]
        light = sum(file[f"bghts{n}"][:] for n in range(3))   # rows: beta
        middle = (light.sum(axis=0) * np.linspace(-limits, limits, light.shape[1])).sum() / light.sum()
        outside = light[np.broadcast_to((far > 9) | (far.T > 9), light.shape)].sum() / light.sum()
    with h5py.File(glob.glob(f"of-{limits}/Visibility_0*")[0]) as file:
        return file["freqs"][:] * 1e9, file["visibility"][:], outside, middle


changed = []
u, wide, outside, middle = seen(20)
_, narrow, outside_narrow, _ = seen(10)
kept = abs(narrow[0]) / abs(wide[0])
print(f"light beyond 9 M: {outside:.1e} with limits = 20, {outside_narrow:.1e} with 10, expected none; flux with limits = 10 over that with 20: {kept:.3f}, expected 1")
if not (outside < 1e-3 and outside_narrow < 1e-3 and 0.85 < kept < 0.93):
    changed.append("the flux")
place = -np.angle(wide[1] / wide[0]) / (2 * np.pi * u[1]) * DISTANCE / METRES   # of a source with this phase on the shortest baseline
print(f"phase as of a source at alpha = {place:.2f} M, expected {middle:.2f} M, the middle of the light")
if not 19.5 < place - middle < 20.5:
    changed.append("the phase")
print("changed:", changed or "nothing")
sys.exit(bool(changed))
PYTHON
