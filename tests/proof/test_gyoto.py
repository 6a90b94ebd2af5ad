#!/usr/bin/env python3
"""Discs about rotating holes, ray by ray, against gyoto: F. H. Vincent, T. Paumard, E. Gourgoulhon, G. Perrin, Class. Quantum Grav. 28,
225011 (2011).

Usage: test_gyoto.py PATH-OF-NULLSCOPE. Ends with 77 where there is no gyoto (scripts/install-packages.sh --all installs it). With
NULLSCOPE_TESTS=quick one view, else four.
"""
import csv
import io
import math
import os
import shutil
import statistics
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
QUICK = os.environ.get("NULLSCOPE_TESTS", "quick") == "quick" and "NULLSCOPE_EVERYTHING" not in os.environ   # as support/depth.h
PIXELS = 32                 # a side; gyoto's screens are squares
CROSSINGS = 8               # of the equatorial plane that are looked through for the first on the disc
LEAST_HITS = 200            # of a view
STEP_TOLERANCE = 1e-14      # of gyoto's integrator, absolute and relative; 1e-12 is seen in what is compared
LATE = 200                  # M; gyoto lets go of rays that are out for longer than there and back by so much
# gyoto looks for the plane down to 1e-4 M of time; from there on its rays are taken for straight, which leaves some 1e-10 of r. Of cameras
# at 1000 M the reference's own steps are seen. Measured: 4.4e-10 of r (1.3e-10 from nearer), 3.6e-10 rad, 1.6e-10 of the shift;
# medians below 1e-11.
AGREEMENT = {"radius": 1e-9, "azimuth": 1e-9, "shift": 1e-9}


class Hole:
    """Kerr at Boyer and Lindquist's r and theta, in units of M."""

    def __init__(self, a, r, theta=math.pi / 2):
        self.sine = math.sin(theta)
        self.sigma = r * r + (a * math.cos(theta)) ** 2
        self.delta = r * r - 2 * r + a * a
        self.area = (r * r + a * a) ** 2 - self.delta * (a * self.sine) ** 2
        self.drag = 2 * a * r / self.area
        self.lapse = math.sqrt(self.delta * self.sigma / self.area)
        self.girth = math.sqrt(self.area / self.sigma) * self.sine


class View:
    """A camera without angular momentum that looks at the hole, and a disc from the last stable orbit on. Lengths in M."""

    def __init__(self, a, r, degrees, outer, across):
        self.a, self.r, self.theta, self.outer, self.across = a, r, math.radians(degrees), outer, across
        self.inner = last_stable_orbit(a)
        self.name = f"a = {a}, camera at r = {r} M, theta = {degrees} degrees"

    def rays(self):
        """View directions along (e_r, e_theta, e_phi), in the order of gyoto's pixels: rows from below, columns against phi."""
        step, middle = 2 * math.tan(self.across / 2) / PIXELS, (PIXELS - 1) / 2
        for row in range(PIXELS):
            for column in range(PIXELS):
                yield -1.0, -step * (row - middle), -step * (column - middle)


def last_stable_orbit(a):
    """Bardeen, Press and Teukolsky (1972)."""
    z1 = 1 + (1 - a * a) ** (1 / 3) * ((1 + a) ** (1 / 3) + (1 - a) ** (1 / 3))
    z2 = math.sqrt(3 * a * a + z1 * z1)
    return 3 + z2 - math.sqrt((3 - z1) * (3 + z1 + 2 * z2))


def shift_at(a, r, l_z):
    """Frequency at infinity over frequency in matter on a circular orbit."""
    omega = 1 / (r ** 1.5 + a)
    u_t = (1 + a / r ** 1.5) / math.sqrt(1 - 3 / r + 2 * a / r ** 1.5)
    return 1 / (u_t * (1 - omega * l_z))


def scene_of_gyoto(view):
    here = Hole(view.a, view.r, view.theta)
    vector = lambda *parts: " ".join(repr(float(part)) for part in parts)
    return f"""<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<Scenery>
  <Metric kind="KerrBL"><Spin>{view.a}</Spin></Metric>
  <Screen>
    <Position>{vector(0, view.r, view.theta, 0)}</Position>
    <ObserverKind>FullySpecified</ObserverKind>
    <FourVelocity>{vector(1 / here.lapse, 0, 0, here.drag / here.lapse)}</FourVelocity>
    <ScreenVector1>{vector(0, 0, 0, 1 / here.girth)}</ScreenVector1>
    <ScreenVector2>{vector(0, 0, -1 / math.sqrt(here.sigma), 0)}</ScreenVector2>
    <ScreenVector3>{vector(0, -math.sqrt(here.delta / here.sigma), 0, 0)}</ScreenVector3>
    <AngleKind>Rectilinear</AngleKind>
    <FieldOfView>{view.across!r}</FieldOfView>
    <Resolution>{PIXELS}</Resolution>
  </Screen>
  <Astrobj kind="ThinDisk">
    <InnerRadius>{view.inner!r}</InnerRadius>
    <OuterRadius>{view.outer!r}</OuterRadius>
  </Astrobj>
  <Integrator>runge_kutta_fehlberg78</Integrator>
  <AbsTol>{STEP_TOLERANCE}</AbsTol>
  <RelTol>{STEP_TOLERANCE}</RelTol>
  <MinimumTime>{-view.r - view.outer - LATE}</MinimumTime>
  <Quantities>ImpactCoords Redshift</Quantities>
</Scenery>
"""


def images(path):
    """The images of doubles in a FITS file."""
    raw, at = path.read_bytes(), 0
    while at < len(raw):
        keys = {}
        while "END" not in keys:
            block = raw[at:at + 2880].decode("ascii")
            keys.update((block[i:i + 8].strip(), block[i + 10:i + 80].split("/")[0]) for i in range(0, 2880, 80))
            at += 2880
        count = math.prod(int(keys[f"NAXIS{axis + 1}"]) for axis in range(int(keys["NAXIS"])))
        yield struct.unpack(f">{count}d", raw[at:at + 8 * count])
        at += -(-8 * count // 2880) * 2880


def traced_by_gyoto(view, folder):
    """Of every ray the place on the disc (r, phi) and the shift there, or nothing."""
    (folder / "scene.xml").write_text(scene_of_gyoto(view))
    run(["gyoto", "--silent", "scene.xml", "!found.fits"], folder)
    shifts, hits = images(folder / "found.fits")
    for pixel, shift in enumerate(shifts):
        # Place (t, r, theta, phi) and velocity of the matter, then of the photon.
        _, r, theta, phi, t_dot, r_dot, theta_dot, phi_dot = hits[16 * pixel + 8:16 * pixel + 16]
        if r > 1e300:
            yield None
            continue
        # On to the plane, and to the matter there.
        there, rest = Hole(view.a, r), (math.pi / 2 - theta) / theta_dot
        momentum = there.girth ** 2 * (phi_dot - there.drag * t_dot)
        energy = there.lapse ** 2 * t_dot + there.drag * momentum
        r_there = r + rest * r_dot
        shift *= shift_at(view.a, r_there, momentum / energy) / shift_at(view.a, r, momentum / energy)
        yield r_there, phi + rest * phi_dot, shift


def traced_by_nullscope(view, folder, binary):
    (folder / "scene.toml").write_text(f'[spacetime]\nmetric = "kerr"\nspin = {view.a}\n[disc]\nemission = "thermal"\n')
    rows = [",".join(map(repr, (view.r / 2, view.theta, 0.0, *look))) for look in view.rays()]
    (folder / "rays.csv").write_text("\n".join(["r,theta,phi,n_r,n_theta,n_phi", *rows]) + "\n")
    out = run([binary, "trace", "scene.toml", "--rays", "rays.csv", "--crossings", str(CROSSINGS)], folder)
    for row in csv.DictReader(io.StringIO(out)):
        crossings = ((2 * float(row[f"r_{k}"]), float(row[f"phi_{k}"]), float(row[f"g_{k}"]))
                     for k in range(1, CROSSINGS + 1) if row[f"r_{k}"])
        yield next((c for c in crossings if view.inner <= c[0] <= view.outer), None)


def run(command, folder):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=600)
    if done.returncode:
        sys.exit(f"{' '.join(command)} ended with {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def compare(view, binary):
    """Prints one line; whether all is as close as it should be."""
    with tempfile.TemporaryDirectory(prefix="nullscope-gyoto-") as name:
        ours, theirs = list(traced_by_nullscope(view, Path(name), binary)), list(traced_by_gyoto(view, Path(name)))
    hits = [(a, b) for a, b in zip(ours, theirs, strict=True) if a and b]
    fates = sum((a is None) != (b is None) for a, b in zip(ours, theirs))
    apart = {"radius": [abs(b[0] / a[0] - 1) for a, b in hits],
             "azimuth": [abs(math.remainder(b[1] - a[1], 2 * math.pi)) for a, b in hits],
             "shift": [abs(b[2] / a[2] - 1) for a, b in hits]}
    words = "; ".join(f"{what} {max(all_of):.2g}, median {statistics.median(all_of):.2g}" for what, all_of in apart.items() if all_of)
    good = fates == 0 and len(hits) >= LEAST_HITS and all(x <= AGREEMENT[what] for what, all_of in apart.items() for x in all_of)
    print(f"{view.name}: {'' if good else 'NOT AS CLOSE AS IT SHOULD BE, '}{len(hits)} of {len(ours)} rays meet the disc, "
          f"{fates} in one program only; apart: {words}")
    return good


VIEWS = [View(0.9, 20, 80, outer=30, across=1.2), View(0.5, 1000, 80, outer=30, across=0.06), View(0.998, 6, 60, outer=20, across=1.5),
         View(0.0, 20, 80, outer=30, across=1.2)]


def main():
    if shutil.which("gyoto") is None:
        print("skipped: gyoto is not installed (apt-get install gyoto-bin)")
        return SKIPPED
    binary = str(Path(sys.argv[1]).resolve())
    return 0 if all([compare(view, binary) for view in VIEWS[:1 if QUICK else None]]) else 1


if __name__ == "__main__":
    sys.exit(main())
