"""GIMP, without a window: what it saves arrives pixel for pixel, and what nullscope writes is the same picture there."""
import os
import re
import shutil
import subprocess

import numpy as np

import patterns
import support

VERSION = re.search(r"version (\S+)", subprocess.run(["gimp", "--version"], capture_output=True, text=True, check=True).stdout)[1]
KINDS = ("psd", "tga", "bmp", "png", "tif", "exr", "ppm")   # ppm: as text


def batch(folder, *lines):
    """Runs lines of Script-Fu; TGA's plug-in wants a screen even so."""
    environment = {**os.environ, "HOME": str(folder)}
    words = ["xvfb-run", "-a", "gimp", "-i", "-d", "-f", "-b", f"(begin {' '.join(lines)})", "-b", "(gimp-quit 0)"]
    done = subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
    if "executed successfully" not in done.stdout + done.stderr:
        raise AssertionError(f"GIMP: {done.stdout}{done.stderr}")


def saved(source, names, before=""):
    """A line that opens a file and saves it by other names. before: what is done to the image."""
    return (f'(let* ((image (car (gimp-file-load RUN-NONINTERACTIVE "{source}" "{source}")))) {before} '
            "(let* ((layer (car (gimp-image-get-active-drawable image)))) " +
            " ".join(f'(gimp-file-save RUN-NONINTERACTIVE image layer "{name}" "{name}")' for name in names) + "))")


def read(report, folder):
    patterns.write_source(folder)
    batch(folder, saved("eight.ppm", [f"eight.{kind}" for kind in KINDS]), saved("sixteen.ppm", [f"sixteen.{kind}" for kind in ("png", "tif", "psd")]),
          saved("eight.ppm", ["few.png", "few.tga", "few.bmp"], '(gimp-image-convert-indexed image CONVERT-DITHER-NONE CONVERT-PALETTE-GENERATE 64 FALSE FALSE "")'),
          saved("few.png", ["few.tif"], "(gimp-image-convert-rgb image)"))
    for kind in KINDS:
        report.add(f"eight.{kind}: largest difference from its light", patterns.difference(folder, f"eight.{kind}", "eight.exr"), 1e-6)
    for kind in ("png", "tif", "psd"):
        report.add(f"sixteen.{kind}: largest difference from its light", patterns.difference(folder, f"sixteen.{kind}", "sixteen.exr"), 1e-6)
    for name in ("few.png", "few.tga", "few.bmp"):
        report.add(f"{name} of 64 colours: largest difference from the same in RGB", patterns.difference(folder, name, "few.tif"), 1e-6)


def written(report, folder):
    """PNG of 16 bits and TIFF: one picture there too, by the PNM that it makes of them."""
    for name, options in {"deep.png": ("--bits", "16"), "deep.tif": (), "eight.png": ()}.items():
        support.nullscope("capture", "first-light", "--size", "96x54", *options, "-o", name, folder=folder)
    raw = "(file-ppm-save RUN-NONINTERACTIVE image (car (gimp-image-get-active-drawable image)) \"{0}\" \"{0}\" 1)"
    batch(folder, *(saved(name, [], raw.format(name + ".ppm")) for name in ("deep.png", "deep.tif", "eight.png")))
    deep, tiff, eight = (patterns.read_pnm(folder / (name + ".ppm")) for name in ("deep.png", "deep.tif", "eight.png"))
    report.add("PNG and TIFF of 16 bits: values that differ", int((deep != tiff).sum()), 0)
    report.add("PNG of 8 bits against that of 16: largest difference", float(np.abs(deep / 257 - eight).max()), 0.6, "of 255 ")
    report.add("its light is one value", int(np.ptp(deep) == 0), 0)


if __name__ == "__main__":
    if not shutil.which("xvfb-run"):
        raise SystemExit("xvfb-run is not here")
    support.main(f"GIMP {VERSION}", read, written)
