#!/usr/bin/env python3
"""Derivatives of the flux of the scene accretion, its gas even and its sky black, against differences of pictures by the reference.

Usage: flux_derivatives.py PATH-OF-NULLSCOPE [SPIN [RAYS]]    (0; RAYS x RAYS rays a pixel of 32 x 18: 64; some ten core-minutes; by hand)
"""
import csv
import io
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

ARGUMENTS = sys.argv[1:]   # support takes its own of them

import support  # noqa: E402

ACCRETION = Path(__file__).resolve().parents[2] / "assets/scenes/accretion.toml"
STEPS = {"spin": ("spacetime.spin", 0.02, 1.0), "camera.theta": ("camera.theta", 0.3, math.radians(1))}   # key, step and unit of scene files
WEIGHTS = {"R": 0.2126390059, "G": 0.7151686788, "B": 0.0721923154}


def main():
    binary, spin = ARGUMENTS[0], float(ARGUMENTS[1]) if len(ARGUMENTS) > 1 else 0.0
    size = int(ARGUMENTS[2]) // 16 if len(ARGUMENTS) > 2 else 4
    text = re.sub(r'\[sky\].*?\n\n', '[sky]\nkind = "black"\n\n', ACCRETION.read_text(), flags=re.S)
    text = text.replace('texture = "gas"', 'texture = "plain"').replace('flow = "kepler"\n', "").replace("gas_winding = 3.0\n", "")
    base = {"spacetime.spin": spin, "camera.theta": 81.0}
    with tempfile.TemporaryDirectory() as folder:
        scene, picture = str(Path(folder) / "scene.toml"), str(Path(folder) / "picture.exr")
        Path(scene).write_text(text)

        def run(command, values, *options):
            sets = [word for key, value in {"spacetime.metric": "kerr", **values}.items() for word in ("--set", f"{key}={value}")]
            return subprocess.run([binary, command, scene, *sets, *options], check=True, capture_output=True, text=True).stdout

        def flux(values):
            run("capture", values, "--renderer", "reference", "--size", f"{32 * size}x{18 * size}", "--samples", "16", "-o", picture)
            channels = support.read_exr(Path(picture).read_bytes())
            return sum(weight * sum(map(sum, channels[name])) for name, weight in WEIGHTS.items()) / size ** 2

        rows = csv.DictReader(io.StringIO(run("flux", base, "--size", "32x18", "--derivatives", ",".join(STEPS))))
        found = {row["key"]: float(row["value"]) for row in rows}
        print(f"flux {found['flux']:.6g}, of the picture {flux(base):.6g}")
        for name, (key, step, unit) in STEPS.items():
            down, up = (flux({**base, key: base[key] + side * step}) for side in (-1, 1))
            slope = (up - down) / (2 * step * unit)
            print(f"{name}: {found['d_' + name]:.6g}, by pictures {slope:.6g}: {100 * (found['d_' + name] / slope - 1):+.3f} %")


if __name__ == "__main__":
    main()
