"""ImageMagick: what it writes arrives pixel for pixel, and what nullscope writes is the same picture there."""
import re
import shutil
import struct
import subprocess

import numpy as np

import patterns
import support

CONVERT = "/usr/bin/convert"
PROGRAM = "ImageMagick " + re.search(r"ImageMagick (\S+)", subprocess.run([CONVERT, "-version"], capture_output=True, text=True, check=True).stdout)[1]
IS_SIX = PROGRAM.startswith("ImageMagick 6.")   # Debian 12's; 7.1.2 has none of the faults below
# Name, source and options. TGA: see upside_down.
FILES = (
    ("plain.tga", "eight", "-orient TopLeft"), ("runs.tga", "eight", "-orient TopLeft -compress RLE"), ("three.bmp", "eight", "-define bmp:format=bmp3"),
    ("four.bmp", "eight", "-define bmp:format=bmp4"), ("two.bmp", "eight", "-define bmp:format=bmp2"), ("eight.pnm", "eight", ""), ("deep.pnm", "sixteen", "-depth 16"),
    ("runs.psd", "eight", ""), ("plain.psd", "eight", "-compress none"), ("deep.psd", "sixteen", "-depth 16 -compress none"),
    ("eight.png", "eight", ""), ("woven.png", "eight", "-interlace PNG"), ("deep.png", "sixteen", "-depth 16"), ("lzw.tif", "eight", "-compress LZW"),
    ("tiles.tif", "eight", "-compress Zip -define tiff:tile-geometry=16x16"), ("deep.tif", "sixteen", "-depth 16"), ("big.tif", "eight", "-define tiff:endian=msb"),
)


def convert(folder, *words):
    done = subprocess.run([CONVERT, *map(str, words)], cwd=folder, capture_output=True, text=True, timeout=120)
    if done.returncode != 0:
        raise AssertionError(f"convert {' '.join(map(str, words))}: {done.stderr}")
    return done.stdout


def read(report, folder):
    patterns.write_source(folder)
    for name, source, options in FILES:
        convert(folder, source + ".ppm", *options.split(), name)
        report.add(f"{name} ({options or 'as it is'}): largest difference from its light", patterns.difference(folder, name, source + ".exr"), 1e-6)
    for name, options in (("few.tga", "-orient TopLeft -colors 64 -type Palette"), ("few.bmp", "-colors 64 -type Palette -compress none"), ("few.png", "-colors 64 -type Palette"),
                          ("few.tif", "-colors 64 -type Palette"), ("grey.pgm", "-colorspace gray"), ("grey.png", "-colorspace gray")):
        convert(folder, "eight.ppm", *options.split(), "-depth", "8", name)
        convert(folder, name, "-auto-orient", "-type", "TrueColor", "-depth", "8", "again.ppm")
        shown = patterns.read_pnm(folder / "again.ppm")
        patterns.write_light(folder / "again.exr", np.broadcast_to(shown, (*shown.shape[:2], 3)) / 255)
        report.add(f"{name} ({options}): largest difference from what it reads itself", patterns.difference(folder, name, "again.exr"), 1e-6)


def upside_down(report, folder):
    """Without -orient version 6 writes rows from the top, and a head that says from the bottom; its HDR holds what a display shows."""
    patterns.write_source(folder)
    convert(folder, "eight.ppm", "rows.tga")
    if not IS_SIX:
        report.add("TGA without -orient: largest difference from its light", patterns.difference(folder, "rows.tga", "eight.exr"), 1e-6)
        return
    patterns.write_light(folder / "turned.exr", patterns.codes(8)[::-1] / 255)
    report.known_fault("TGA without -orient TopLeft stands on its head in every other program", patterns.difference(folder, "rows.tga", "turned.exr") < 1e-6)
    convert(folder, "eight.ppm", "light.hdr")
    (folder / "sky.toml").write_text('[camera]\nr = 20\nsize = [32, 18]\n[sky]\nkind = "image"\nimage = "light.hdr"\n')
    said = support.nullscope("capture", "sky.toml", "-o", "seen.exr", folder=folder)
    report.known_fault("HDR holds display values, by a GAMMA that nullscope says it leaves", "GAMMA=" in said)


def turned(report, folder):
    """JPEG of each Exif orientation, which ImageMagick puts upright by -auto-orient."""
    patterns.write_source(folder)
    convert(folder, "eight.ppm", "-resize", "320x160!", "-blur", "0x3", "wide.ppm")
    worst, upright = 0.0, None
    for orientation in range(1, 9):
        convert(folder, "wide.ppm", "-quality", "100", "-sampling-factor", "1x1", "plain.jpg")
        data = (folder / "plain.jpg").read_bytes()
        exif = b"Exif\0\0MM\0*" + struct.pack(">IHHHIHHI", 8, 1, 0x112, 3, 1, orientation, 0, 0)
        (folder / "turned.jpg").write_bytes(data[:2] + b"\xff\xe1" + struct.pack(">H", len(exif) + 2) + exif + data[2:])
        convert(folder, "turned.jpg", "-auto-orient", "-depth", "8", "upright.ppm")
        seen = []
        for name in ("turned.jpg", "upright.ppm"):
            (folder / "sky.toml").write_text(f'[camera]\nr = 20\nsize = [64, 36]\n[sky]\nkind = "image"\nimage = "{name}"\n')
            support.nullscope("capture", "sky.toml", "--quiet", "-o", "seen.png", folder=folder)
            convert(folder, "seen.png", "-strip", "-depth", "8", "seen.ppm")
            seen.append(patterns.read_pnm(folder / "seen.ppm"))
        worst = max(worst, np.abs(seen[0] - seen[1]).max())
        upright = seen[0] if upright is None else upright
        report.add(f"orientation {orientation}: the same as 1", int(orientation > 1 and np.abs(seen[0] - upright).max() < 9), 0)
    report.add("JPEG of 8 orientations as skies, against -auto-orient: largest difference", float(worst), 2, "of 255 ")


def written(report, folder):
    """PNG and TIFF of 16 bits are one picture there, that of the PNG of 8 bits."""
    for name, options in {"deep.png": ("--bits", "16"), "deep.tif": (), "eight.png": ()}.items():
        support.nullscope("capture", "first-light", "--size", "96x54", *options, "-o", name, folder=folder)
        convert(folder, name, "-strip", "-depth", "16" if name.startswith("deep") else "8", name + ".ppm")
    deep, tiff, eight = (patterns.read_pnm(folder / (name + ".ppm")) for name in ("deep.png", "deep.tif", "eight.png"))
    report.add("PNG and TIFF of 16 bits: values that differ", int((deep != tiff).sum()), 0)
    report.add("PNG of 8 bits against that of 16: largest difference", float(np.abs(deep / 257 - eight).max()), 0.6, "of 255 ")
    report.add("and it is one value", int(np.ptp(eight) == 0), 0)
    convert(folder, "eight.png", "-resize", "50%", "copy.png")
    if IS_SIX:
        report.known_fault("a copy of a PNG has lost its texts in Unicode, the scene among them", b"nullscope" not in (folder / "copy.png").read_bytes())
    else:
        report.add("a copy made by it holds another scene", int(support.nullscope("scenes", "copy.png", folder=folder) != support.nullscope("scenes", "eight.png", folder=folder)), 0)


if __name__ == "__main__":
    if not shutil.which(CONVERT):
        raise SystemExit("ImageMagick is not here")
    support.main(PROGRAM, read, upside_down, turned, written)
