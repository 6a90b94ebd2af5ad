#!/usr/bin/env python3
"""Derivatives of a scene's flux by spin and inclination, its sky black, against differences of pictures by the reference. Fails above 0.5 %.

Usage: flux_derivatives.py PATH-OF-NULLSCOPE [SPIN | SCENE [RAYS [KEY [STEP]]]]
SPIN: of the scene accretion, its gas even (0); SCENE: hot-flow, m87-synchrotron. RAYS x RAYS rays a pixel (64) of 32 x 18, of matter 16 x 9; KEY: this
alone, without the picture between; STEP: of what steps are without it. By hand: some ten core-minutes, of m87-synchrotron twenty.
PICTURES=gl: pictures by the shader, of which 256 x 256 rays a pixel take a minute: they share no code with the derivatives either.
"""
import csv
import io
import math
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

ARGUMENTS = sys.argv[1:]   # support takes its own of them

import support  # noqa: E402

SCENES = Path(__file__).resolve().parents[2] / "assets/scenes"
KEYS = {"spin": "spacetime.spin", "camera.theta": "camera.theta"}
THETA = 0.3   # degrees
BY_SHADER = os.environ.get("PICTURES") == "gl"
# Rays next to the critical curve, where light has a logarithm, are a picture's grain. Where the curve is small the middle half of the view is a picture of its
# own, of as many pixels, and what is around it has 16 x 16 rays.
MIDDLE = ("hot-flow",)
WEIGHTS = {"R": 0.2126390059, "G": 0.7151686788, "B": 0.0721923154}
MOST = 0.5   # %: the differences' own error and that of the picture's rays


def steps(name, value, turn, share):
    """Values of a key on either side, and how far apart they are in its unit."""
    turn *= share
    if name == "camera.theta":
        theta = THETA * share
        return value - theta, value + theta, math.radians(2 * theta)
    # Next to spin 1 fluxes change as sqrt(1 - spin^2) does: steps are of the spin's arcsine, and spins are 2 turn cos(angle) apart.
    angle = math.asin(value)
    return math.sin(angle - turn), math.sin(angle + turn), 2 * turn * math.sqrt(1 - value ** 2)


def accretion(spin):
    """Its text, values to begin with, pixels, steps of the spin's arcsine."""
    text = re.sub(r'\[sky\].*?\n\n', '[sky]\nkind = "black"\n\n', (SCENES / "accretion.toml").read_text(), flags=re.S)
    text = text.replace('texture = "gas"', 'texture = "plain"').replace('flow = "kepler"\n', "").replace("gas_winding = 3.0\n", "")
    return text, {"spacetime.metric": "kerr", "spacetime.spin": spin, "camera.theta": 81.0}, (32, 18), 0.02


def matter(name):
    text = (SCENES / f"{name}.toml").read_text()
    spin, theta = (float(re.search(rf"^{key} = (\S+)", text, re.M)[1]) for key in ("spin", "theta"))
    return text, {"spacetime.spin": spin, "camera.theta": theta}, (16, 9), 0.06


def main():
    binary, of = ARGUMENTS[0], ARGUMENTS[1] if len(ARGUMENTS) > 1 else "0"
    size = int(ARGUMENTS[2]) // 16 if len(ARGUMENTS) > 2 else 4
    text, base, (width, height), turn = matter(of) if (SCENES / f"{of}.toml").exists() else accretion(float(of))
    names = ARGUMENTS[3:4] or list(KEYS)
    share = float(ARGUMENTS[4]) if len(ARGUMENTS) > 4 else 1.0
    worst = 0.0
    with tempfile.TemporaryDirectory() as folder:
        scene, picture = str(Path(folder) / "scene.toml"), str(Path(folder) / "picture.exr")
        Path(scene).write_text(text)

        def run(command, values, *options):
            sets = [word for key, value in values.items() for word in ("--set", f"{key}={value}")]
            return subprocess.run([binary, command, scene, *sets, *options], check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout

        def rows_of(values, size, samples):
            """Of luminance, a pixel is size x size of them, each of samples x samples rays."""
            run("capture", values, "--renderer", "gl" if BY_SHADER else "reference", "--size", f"{width * size}x{height * size}", "--samples", str(samples), "-o", picture)
            channels = support.read_exr(Path(picture).read_bytes())
            parts = [[[weight * value for value in row] for row in channels[name]] for name, weight in WEIGHTS.items()]
            return [[sum(of_pixel) for of_pixel in zip(*rows)] for rows in zip(*parts)]

        def flux(values):
            if of not in MIDDLE or BY_SHADER:
                return sum(map(sum, rows_of(values, size, 16))) / size ** 2
            fov = float(re.search(r"^fov = (\S+)", text, re.M)[1])
            half = 2 * math.degrees(math.atan(0.5 * math.tan(math.radians(0.5 * fov))))
            middle = sum(map(sum, rows_of({**values, "camera.fov": half}, size, 16))) / (2 * size) ** 2
            whole = rows_of(values, 4, 4)
            around = sum(map(sum, whole)) - sum(sum(row[width:3 * width]) for row in whole[height:3 * height])
            return middle + around / 16

        rows = csv.DictReader(io.StringIO(run("flux", base, "--size", f"{width}x{height}", "--derivatives", ",".join(names))))
        found = {row["key"]: float(row["value"]) for row in rows}
        print(f"flux {found['flux']:.6g}" + ("" if ARGUMENTS[3:] else f", of the picture {flux(base):.6g}"), flush=True)
        for name in names:
            *sides, apart = steps(name, base[KEYS[name]], turn, share)
            down, up = (flux({**base, KEYS[name]: side}) for side in sides)
            slope = (up - down) / apart
            off = 100 * (found['d_' + name] / slope - 1)
            worst = max(worst, abs(off))
            print(f"{name}: {found['d_' + name]:.6g}, by pictures {slope:.6g}: {off:+.3f} %", flush=True)
    sys.exit(worst > MOST)


if __name__ == "__main__":
    main()
