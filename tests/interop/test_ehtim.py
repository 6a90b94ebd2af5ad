"""ehtim: FITS files, and nullscope.to_ehtim, which is the same image without a file. The environment has the package nullscope too."""
import contextlib
import csv
import importlib.metadata
import io
import json
import math
import re
import sys
from pathlib import Path

import numpy as np

import nullscope as ns
import support

with contextlib.redirect_stdout(io.StringIO()):   # its greeting
    import ehtim

PROGRAM = f"ehtim {importlib.metadata.version('ehtim')}"
SIZE = 96, 72   # not square: rows and columns cannot be mistaken for each other


def loaded(scene, folder):
    """(ehtim's image of the FITS file, what capture said)."""
    said = support.nullscope("capture", scene, "--size", "%dx%d" % SIZE, "-o", scene + ".fits", folder=folder)
    with contextlib.redirect_stdout(io.StringIO()):
        return ehtim.image.load_fits(str(folder / (scene + ".fits"))), said


def both_ways(report, folder):
    for scene in ("m87", "m87-swirl", "sgr-a-synchrotron"):
        file, said = loaded(scene, folder)
        image = ns.to_ehtim(ns.capture(scene, SIZE))
        for plane in ("ivec", "qvec", "uvec", "vvec"):
            here, there = getattr(image, plane), getattr(file, plane)
            if len(here) + len(there):
                off = np.abs(here - there).max() / np.abs(file.ivec).max() if len(here) == len(there) else math.inf
                report.add(f"{scene}: {plane} against load_fits, of the brightest pixel", off, 1e-6)
        numbers = {name: (getattr(image, name), getattr(file, name)) for name in ("psize", "ra", "dec", "xdim", "ydim")}
        numbers["rf"] = (image.rf, file.rf if scene == "sgr-a-synchrotron" else 230e9)   # load_fits has 0 or 1 where the file has none
        report.add(f"{scene}: psize, ra, dec, rf, xdim, ydim against load_fits", max(abs(a - b) / max(abs(b), 1e-300) for a, b in numbers.values()), 1e-12)
        report.add(f"{scene}: another source", int(image.source != file.source), 0)
        if scene == "sgr-a-synchrotron":
            flux = float(re.search(r"([\d.]+) Jy at", said)[1])
            report.add(f"{scene}: total flux {image.total_flux():.5g} Jy against what capture prints", abs(image.total_flux() / flux - 1), 1e-4)
        if scene == "m87-swirl":
            net = float(re.search(r"polarised ([\d.e-]+) % net", said)[1]) / 100
            report.add(f"{scene}: net linear fraction {image.lin_polfrac():.5g} against what capture prints", abs(image.lin_polfrac() / net - 1), 6e-3)


def asked(report, folder):
    image = ns.to_ehtim(ns.capture("m87", SIZE), ra=17.7611, dec=-29.0078, frequency=345e9, mjd=57850, flux=2.5, source="SgrA")
    found = (image.ra, image.dec, image.rf, image.mjd, image.source)
    report.add("ra, dec, frequency, mjd, source are not as asked", int(found != (17.7611, -29.0078, 345e9, 57850, "SgrA")), 0)
    report.add("flux of 2.5 Jy", abs(image.total_flux() / 2.5 - 1), 1e-12)


def point(report, folder):
    """One bright pixel, north-east of the middle: the visibility of a point there."""
    picture = ns.capture("m87", SIZE)
    picture[:] = 0
    row, column = 20, 31
    picture[row, column] = 1
    image = ns.to_ehtim(picture)
    east, north = (SIZE[0] / 2 - column - 0.5) * image.psize, (SIZE[1] / 2 - row - 0.5) * image.psize
    places = np.array([[0.11, 0.0], [0.0, 0.13], [0.07, -0.05]]) / (SIZE[0] * image.psize)
    seen = image.sample_uv(places, ttype="direct", verbose=False)
    seen = np.asarray(seen[0] if isinstance(seen, (list, tuple)) else seen).ravel()
    meant = 2 * np.pi * (places @ [east, north])   # ehtim's sign, with x to the east and y to the north
    report.add("phase of a point in the north-east", float(np.abs(np.angle(seen * np.exp(-1j * meant))).max()), 1e-9, "rad ")


def observed(report, folder):
    """Baselines of an observation of another picture of the same source, as of real data: docs/fits.md's six lines."""
    truth = ns.to_ehtim(ns.capture("sgr-a-synchrotron", SIZE), ra=17.7611225, dec=-29.0078106, frequency=228.1e9, mjd=57854)
    places = {"AA": (2225061.164, -5440057.37, -2481681.15), "PV": (5088967.9, -301681.6, 3825015.8), "LM": (-768713.9637, -5988541.7982, 2063275.9472)}
    sites = np.zeros(3, dtype=ehtim.const_def.DTARR)
    for i, (name, place) in enumerate(places.items()):
        sites[i]["site"], sites[i]["sefdr"], sites[i]["sefdl"] = name, 100, 100
        sites[i]["x"], sites[i]["y"], sites[i]["z"] = place
    quiet = contextlib.redirect_stdout(io.StringIO())
    with quiet:
        array = ehtim.array.Array(sites)
        data = truth.observe(array, 60, 600, 0, 24, 2e9, ttype="direct", add_th_noise=False, ampcal=True, phasecal=True)
        # The six lines; data: an observation that ehtim has loaded, as by ehtim.obsdata.load_uvfits.
        picture = ns.capture("sgr-a-synchrotron", SIZE)
        image = ns.to_ehtim(picture, ra=data.ra, dec=data.dec, frequency=data.rf, mjd=data.mjd)
        model = image.observe_same_nonoise(data, ttype="direct")
    off = np.abs(model.data["vis"] - data.data["vis"]).max() / np.abs(data.data["vis"]).max()
    report.add(f"{len(data.data)} visibilities of the same picture, of the largest", float(off), 1e-9)
    report.add("and there are fewer than ten", int(len(data.data) < 10), 0)


# A source in the east, flat: the camera is at phi = 0, its right is +y.
EAST = """[spacetime]
metric = "minkowski"
[camera]
r = 1000
fov = 1.5
size = [96, 72]
[sky]
kind = "black"
[[ball]]
position = [0, -5, 1]
radius = 1
texture = "plain"
[object]
name = "m87"
"""
HOURS = 0, 24, 2


def table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def sampled(image, places):
    seen = image.sample_uv(places, ttype="direct", verbose=False)
    return np.asarray(seen[0] if isinstance(seen, (list, tuple)) else seen).ravel()


def visibilities(report, folder):
    """`nullscope visibility` against sample_uv on the FITS file of the same scene: the same pixels, triangles on both sides."""
    scene, size = "m87-synchrotron", "192x192"
    support.nullscope("capture", scene, "--size", size, "-o", "m87.fits", folder=folder)
    support.nullscope("visibility", scene, "--size", size, "--array", "eht-2017", "--hours", *HOURS, "--pixel", "triangle", "-o", "v", folder=folder)
    with contextlib.redirect_stdout(io.StringIO()):
        image = ehtim.image.load_fits(str(folder / "m87.fits"))
    rows, there = table(folder / "v.csv"), {}
    seen = sampled(image, np.array([[float(row["u"]), float(row["v"])] for row in rows]))
    report.add(f"{scene}: amplitudes of {len(rows)} baselines, relative",
               max(abs(float(row["amplitude_jy"]) / abs(light) - 1) for row, light in zip(rows, seen)), 1e-4)
    for row, light in zip(rows, seen):
        there[row["time_h"], row["station_1"], row["station_2"]] = light
    triangles = table(folder / "v-closure-phases.csv")
    off = 0.0
    for row in triangles:
        a, b, c = (row[f"station_{k}"] for k in (1, 2, 3))
        closed = np.angle(there[row["time_h"], a, b] * there[row["time_h"], b, c] * np.conj(there[row["time_h"], a, c]), deg=True)
        off = max(off, abs(math.remainder(float(row["phase_deg"]) - closed, 360)))
    report.add(f"{scene}: closure phases of {len(triangles)} triangles", off, 0.01, "degrees ")
    python = ns.visibility(ns.capture(scene, (192, 192)), [float(row["u"]) for row in rows], [float(row["v"]) for row in rows], pixel="triangle")
    here = np.array([float(row["real_jy"]) + 1j * float(row["imaginary_jy"]) for row in rows])
    report.add("nullscope.visibility against the command, of the flux", float(np.abs(python - here).max() / image.total_flux()), 1e-8)


def east(report, folder):
    (folder / "east.toml").write_text(EAST)
    places = [(2e8, 0.0), (-1e8, 3e8), (4e8, -2e8), (0.0, 5e8)]
    (folder / "uv.csv").write_text("u,v\n" + "".join(f"{u},{v}\n" for u, v in places))
    support.nullscope("capture", "east.toml", "-o", "east.fits", folder=folder)
    support.nullscope("visibility", "east.toml", "--baselines", "uv.csv", "--pixel", "triangle", "-o", "v", folder=folder)
    with contextlib.redirect_stdout(io.StringIO()):
        image = ehtim.image.load_fits(str(folder / "east.fits"))
    here = np.radians([float(row["phase_deg"]) for row in table(folder / "v.csv")])
    seen = sampled(image, np.array(places))
    report.add("phases of a source in the east", float(np.abs(np.angle(seen * np.exp(-1j * here))).max()), 1e-6, "rad ")
    image.imvec = np.fliplr(image.imarr()).ravel()
    mirrored = np.abs(np.angle(sampled(image, np.array(places)) * np.exp(-1j * here)))
    report.add("of 4 phases, those that a mirrored copy has too", int((mirrored < 1e-3).sum()), 1)   # that along the mirror's axis


def tracks(report, folder):
    """Baselines of an array as the Earth turns, and Python's observe()."""
    support.nullscope("visibility", "m87-synchrotron", "--size", "64x64", "--array", "eht-2017", "--hours", *HOURS, "-o", "v", folder=folder)
    with contextlib.redirect_stdout(io.StringIO()):
        data = ns.observe(ns.capture("m87-synchrotron", (64, 64)), "eht-2017", hours=HOURS)
    there = {}
    for row in data.data:
        there[round(float(row["time"]), 6), row["t1"], row["t2"]] = row["u"], row["v"], row["vis"]
        there[round(float(row["time"]), 6), row["t2"], row["t1"]] = -row["u"], -row["v"], np.conj(row["vis"])
    rows = [row for row in table(folder / "v.csv") if float(row["time_h"]) < HOURS[1]]   # ehtim leaves the last one out
    report.add(f"baselines that ehtim has and we have not, of {len(data.data)}", abs(len(data.data) - len(rows)), 0)
    off = max(math.hypot(float(row["u"]) - u, float(row["v"]) - v) / math.hypot(u, v) for row in rows
              for u, v, _ in [there[round(float(row["time_h"]), 6), row["station_1"], row["station_2"]]])
    report.add(f"(u, v) of {len(rows)} baselines, relative", off, 1e-6)


def movie(report, folder):
    """Frames of a flare at their times, and between them as ehtim interpolates."""
    times = [0.0, 5.0, 10.0]
    pictures = [ns.capture("sgr-a-flare", SIZE, time=time) for time in times]
    hours = [10 + time * 9.8510e-6 * 4.297e6 / 3600 for time in times]
    with contextlib.redirect_stdout(io.StringIO()):
        made = ns.to_ehtim_movie(pictures, hours, flux=2.4)
        frames = [made.get_image(hour) for hour in hours]
        meant = [ns.to_ehtim(picture, flux=2.4) for picture in pictures]
    report.add("times of a movie's frames, h", float(np.abs(np.asarray(made.times) - hours).max()), 1e-12)
    worst = max(float(np.abs(np.asarray(getattr(frame, plane)) - np.asarray(getattr(image, plane))).max() / image.imvec.max())
                for frame, image in zip(frames, meant) for plane in ("imvec", "qvec", "uvec"))
    report.add("a movie's frames with Q and U, of the brightest", worst, 1e-12)
    report.add("a movie whose frames are alike", int(np.allclose(frames[0].imvec, frames[1].imvec, rtol=1e-3)), 0)


def ring_fit(report, folder):
    """The notebook's code, and what it finds."""
    import matplotlib
    matplotlib.use("Agg")
    notebook = json.loads((Path(__file__).resolve().parents[2] / "python" / "examples" / "ring_fit.ipynb").read_text())
    found = {}
    with contextlib.redirect_stdout(io.StringIO()):
        for cell in notebook["cells"]:
            if cell["cell_type"] == "code":
                exec("".join(cell["source"]), found)
    report.add("fitted ring's diameter less the light's mean, µas", abs(float(found["fit"].x[1] - found["mean_diameter"])), 1.5)
    report.add("chi^2 less 1", abs(float(found["chi2"]) - 1), 0.15)


def wrong_is_said(report, folder):
    calls = {"one frame": lambda: ns.to_ehtim_movie([ns.capture("m87", SIZE)], [1.0]),
             "hours": lambda: ns.to_ehtim_movie([ns.capture("m87", SIZE)] * 2, [1.0, 1.0]),
             "sizes": lambda: ns.to_ehtim_movie([ns.capture("m87", SIZE), ns.capture("m87", (32, 32))], [1.0, 2.0]),
             "no picture": lambda: ns.to_ehtim(np.zeros((3, 3, 3))), "no scale": lambda: ns.to_ehtim(ns.capture("kerr", (32, 18))),
             "a part": lambda: ns.to_ehtim(ns.capture("m87", SIZE)[3:]), "changed": lambda: ns.to_ehtim(ns.capture("m87-swirl", SIZE) ** 2),
             "ra": lambda: ns.to_ehtim(ns.capture("m87", SIZE), ra=25.0), "mjd": lambda: ns.to_ehtim(ns.capture("m87", SIZE), mjd=math.nan)}
    unsaid = 0
    for call in calls.values():
        try:
            call()
            unsaid += 1
        except ns.Error as error:
            unsaid += "allowed: " not in str(error)
    report.add(f"errors without what is allowed, of {len(calls)}", unsaid, 0)
    sys.modules["ehtim.image"], kept = None, sys.modules["ehtim.image"]
    try:
        ns.to_ehtim(ns.capture("m87", SIZE))
        said = ""
    except ns.Error as error:
        said = str(error)
    sys.modules["ehtim.image"] = kept
    report.add("ehtim missing: not said", int("pip install ehtim" not in said), 0)


if __name__ == "__main__":
    support.main(PROGRAM, both_ways, asked, point, observed, visibilities, east, tracks, movie, ring_fit, wrong_is_said)
