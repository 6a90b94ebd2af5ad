"""aart (Cardenas-Avendano, Lupsasca and Zhu 2023), which traces thin discs about Kerr holes by closed forms: the same picture, the same visibilities of
1000 baselines, and what a likelihood of them costs. The environment has the package nullscope too."""
import contextlib
import io
import sys
import time
from pathlib import Path

import h5py
import numpy as np

import aart
import aart.lensingbands
import aart.parameters
import aart.radialintensity
import aart.raytracing
import aart.rprofs_f
import aart.visamp
import nullscope as ns
import support

PROGRAM = "aart 2.1.10"
SPIN, INCLINATION = 0.7, 50.0
RADIUS, WIDTH = 8.0, 1.5            # M, of the ring of light, a Gaussian
ANGLES = [18 * k for k in range(10)]    # degrees, of baselines
WAVES = np.linspace(0.2e9, 20e9, 100)   # wavelengths, of each
SIGMA = 0.002                           # of the whole light
LIMIT = 25                              # M, half of aart's picture
METRES, DISTANCE = 6.67e-11 * 6.2e9 * 1.07473555940836 * 1.988435e30 / 2.99792458e8 ** 2, 5.214795112e23   # its M, and its distance
SCENE = """[spacetime]
metric = "kerr"
spin = %r
[camera]
r = 5000
theta = %r
plane_width = 0.003
focal_distance = 1
size = [%d, %d]
[sky]
kind = "black"
[light]
band = "bolometric"
[object]
mass_suns = %r
distance_pc = %r
[disc]
emission = "thermal"
emissivity = "table"
emissivity_file = "%s"
inner = 1.0
outer = 7.5
opacity = 0.001
"""


aart.rprofs_f.profile = lambda r, *others: np.exp(-0.5 * ((r - RADIUS) / WIDTH) ** 2)


def amplitudes_of_aart(spin, inclination, folder, dx, points):
    """|V| over V(0), shape (angles, waves); light is g^4 times the ring."""
    given = aart.parameters.generate_dict([spin], [inclination], [1.0], limits=LIMIT, dx0=dx, dx1=dx, dx2=dx, gfactor=4, mup=[RADIUS], radonangles=ANGLES,
                                          path=f"{folder}/", maxbaseline=25, npointsS=points, p_image=0)
    with contextlib.redirect_stdout(io.StringIO()):
        aart.lensingbands.clb(**given)
        aart.raytracing.raytrace(**given)
        aart.radialintensity.cintensity(**given)
        aart.visamp.cvisamp(**given)
    found = []
    for angle in ANGLES:
        (path,) = Path(folder).glob(f"Visamp_{angle}_a_{spin}_i_{inclination}_*")
        with h5py.File(path) as file:
            waves, amplitude = file["freqs"][:] * 1e9, file["visamp"][:]
        found.append(np.interp(WAVES, waves, amplitude / amplitude[0]))
        path.unlink()
    return np.array(found)


def scene(folder, size=128):
    radii = np.linspace(1.0, 7.5, 400)   # r_s = 2 M
    Path(folder, "ring.csv").write_text("r,emissivity\n" + "".join(f"{r!r},{np.exp(-0.5 * ((2 * r - RADIUS) / WIDTH) ** 2)!r}\n" for r in radii.tolist()))
    suns, parsecs = METRES / 1476.6250385, DISTANCE / 3.0856775814913673e16
    return ns.scene(SCENE % (SPIN, INCLINATION, size, size, suns, parsecs, Path(folder, "ring.csv")))


def columns():
    """(u, v) of the baselines: an angle of 0 is along the picture's rows."""
    turn = np.radians(ANGLES)[:, None]
    return (np.cos(turn) * WAVES).ravel(), (np.sin(turn) * WAVES).ravel()


def core_seconds(call):
    before = time.process_time()
    call()
    return time.process_time() - before


def cost(report, folder):
    seen = amplitudes_of_aart(SPIN, INCLINATION, folder, 0.1, 100)
    u, v = columns()
    data = seen.ravel() + np.random.default_rng(1).normal(0, SIGMA, seen.size)
    like = ns.likelihood({"u": u, "v": v, "amplitude": data}, scene(folder), {"spin": (0.5, 0.9), "camera.theta": (40, 60)}, sigma=SIGMA)
    ours = like.predict([SPIN, INCLINATION])
    report.add("|V| of 1000 baselines to 20 Gλ, less aart's with a grid of 0.1 M, of the whole light", np.abs(ours - seen.ravel()).max(), 2e-3)

    def theirs(spin, inclination, dx, points):
        off = (data - amplitudes_of_aart(spin, inclination, folder, dx, points).ravel()) / SIGMA
        return -0.5 * off @ off

    rough = amplitudes_of_aart(SPIN, INCLINATION, folder, 0.2, 20).ravel()
    print(f"grid of 0.2 M, 20 points of the critical curve: aart is {np.abs(rough - seen.ravel()).max():.2g} off that of 0.1 M and 100", flush=True)
    for dx, points, turns in ((0.1, 100, 1), (0.2, 20, 2)):
        a, b = [], []
        for turn in range(turns):   # in turn, each at a place where neither was before
            place = SPIN + 0.002 * (turn + 1), INCLINATION + 0.1 * (turn + 1) + (0.01 if points == 20 else 0)
            a.append(core_seconds(lambda: theirs(*place, dx, points)))
            b.append(core_seconds(lambda: like.value_and_gradient(place)))
        print(f"grid of {dx} M, core-seconds: aart, the likelihood alone {min(a):.2f} to {max(a):.2f}; nullscope, with its gradient {min(b):.3f} to {max(b):.3f}", flush=True)
        report.add("core-seconds, ours with the gradient over aart's without", max(b) / min(a), 0.1)
    # Derivatives are a sum over the disc's images; pictures tell the same when their pixels, here of 0.006 M with their rays, are finer than those images.
    step = 1e-2
    finer = ns.likelihood({"u": u, "v": v, "amplitude": data}, scene(folder, 512), {"spin": (0.5, 0.9), "camera.theta": (40, 60)}, sigma=SIGMA, samples=16)
    exact = (finer.predict([SPIN + step, INCLINATION]) - finer.predict([SPIN - step, INCLINATION])) / (2 * step)
    found = like.derivatives([SPIN, INCLINATION])[0]
    report.add("derivatives by the spin, less differences of 8192 x 8192 rays, over their length", np.linalg.norm(found - exact) / np.linalg.norm(exact), 0.02)


if __name__ == "__main__":
    support.main(PROGRAM, cost)
