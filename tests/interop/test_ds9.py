"""SAOImage ds9, on a screen of its own and asked through XPA: its pixels, extensions and places on the sky are those of the file."""
import os
import shutil
import subprocess
import time

import numpy as np
from astropy.io import fits
from astropy.wcs import WCS

import support

SIZE = 96, 72
PLACES = (20, 30), (60, 11), (77, 50)   # as FITS counts pixels
NAME = "nullscope-interop"
DIGITS = "17 15 12 12 17 15 12 12 17"   # of numbers; of degrees there are 7 else, and all of a picture of M87* is in one


class Ds9:
    def __init__(self, folder):
        (folder / "xpa").mkdir()
        self.environment = {**os.environ, "XPA_METHOD": "local", "XPA_TMPDIR": str(folder / "xpa"), "HOME": str(folder)}
        self.process = subprocess.Popen(["xvfb-run", "-a", "-s", "-screen 0 1024x768x24", "ds9", "-title", NAME], env=self.environment, cwd=folder,
                                        start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + 120
        while self.ran("xpaaccess", "-n", NAME).strip() in ("", "0"):
            if time.monotonic() > end or self.process.poll() is not None:
                raise AssertionError("ds9 does not answer")
            time.sleep(0.2)
        self.tell("prefs", "precision", DIGITS)

    def ran(self, *words):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, timeout=60).stdout

    def ask(self, *words):
        return self.ran("xpaget", NAME, *map(str, words)).strip()

    def tell(self, *words):
        done = subprocess.run(["xpaset", "-p", NAME, *map(str, words)], env=self.environment, capture_output=True, text=True, timeout=60)
        if done.returncode != 0 or "ERROR" in done.stderr:
            raise AssertionError(f"ds9: {' '.join(map(str, words))}: {done.stderr.strip()}")

    def pixels(self, file, shape, folder):
        """All that it has of a file (or of one of its extensions), from the bottom up."""
        self.tell("file", file)
        self.tell("export", "array", folder / "pixels.arr", "little")
        return np.fromfile(folder / "pixels.arr", dtype="<f4").reshape(shape)

    def close(self):
        subprocess.run(["xpaset", "-p", NAME, "exit"], env=self.environment, capture_output=True, timeout=60)
        try:
            self.process.wait(30)
        except subprocess.TimeoutExpired:
            os.killpg(self.process.pid, 15)   # of its own session: xvfb-run and what it started


def opened(report, folder):
    scenes = ("m87", "m87-swirl", "sgr-a-synchrotron")
    for scene in scenes:
        support.nullscope("capture", scene, "--size", "%dx%d" % SIZE, "-o", scene + ".fits", folder=folder)
    ds9 = Ds9(folder)
    try:
        program = report.program = f"ds9 {ds9.ask('version').split()[-1]}"
        for scene in scenes:
            with fits.open(folder / (scene + ".fits")) as file:
                parts = {part.name: part.data.astype(np.float32) for part in file}
                header = file[0].header
            first = parts.pop("PRIMARY")
            report.same_bits(f"{scene}: all pixels", ds9.pixels(folder / (scene + ".fits"), first.shape, folder), first)
            places(report, scene, ds9, header, first)
            for name, light in parts.items():
                report.same_bits(f"{scene}: extension {name}", ds9.pixels(f"{folder / (scene + '.fits')}[{name}]", light.shape, folder), light)
        saved(report, ds9, folder)
        print(f"{program}: xpaget {NAME} data image 20 30 1 1 yes; crosshair wcs icrs degrees")
    finally:
        ds9.close()


def places(report, scene, ds9, header, light):
    wcs, off, values = WCS(header).celestial, [], []
    for x, y in PLACES:
        ds9.tell("crosshair", x, y, "image")
        found = np.array([float(word) for word in ds9.ask("crosshair", "wcs", "icrs", "degrees").split()])
        off.append(np.abs(found - np.array(wcs.pixel_to_world_values(x - 1, y - 1))).max() / abs(header["CDELT2"]))
        value, meant = float(ds9.ask("data", "image", x, y, 1, 1, "yes")), float(light.reshape(-1, *light.shape[-2:])[0, y - 1, x - 1])
        values.append(abs(value - meant) / max(abs(meant), 1e-30))
        print(f"     {scene} at {x}, {y}: {found[0]:.15f} {found[1]:.15f} deg, {value:g}; file {meant:.7g}")
    report.add(f"{scene}: right ascension and declination of three pixels against astropy's", max(off), 1e-3, "px ")
    report.add(f"{scene}: values of three pixels, 6 digits", max(values), 1e-5)


def saved(report, ds9, folder):
    """What ds9 writes is still a scene."""
    ds9.tell("file", folder / "m87.fits")
    ds9.tell("save", "fits", folder / "saved.fits", "image")
    ours, theirs = (support.nullscope("scenes", name, folder=folder) for name in ("m87.fits", "saved.fits"))
    report.add("m87 saved by it: another scene", int(ours != theirs), 0)


if __name__ == "__main__":
    for tool in ("ds9", "xpaget", "xvfb-run"):
        if not shutil.which(tool):
            raise SystemExit(f"{tool} is not here")
    support.main("ds9", opened)
