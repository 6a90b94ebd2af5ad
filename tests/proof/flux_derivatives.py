#!/usr/bin/env python3
"""Derivatives of a scene's flux by spin and inclination, its sky black, against differences of pictures by the reference. Fails above 0.5 %.

Usage: flux_derivatives.py PATH-OF-NULLSCOPE [SPIN | SCENE [RAYS]]
SPIN: of the scene accretion, its gas even (0); SCENE: hot-flow, m87-synchrotron. RAYS x RAYS rays a pixel of 32 x 18, of matter 16 x 9 (64); by hand: some
ten core-minutes, of matter twenty
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

SCENES = Path(__file__).resolve().parents[2] / "assets/scenes"
STEPS = {"spin": ("spacetime.spin", 0.02, 1.0), "camera.theta": ("camera.theta", 0.3, math.radians(1))}   # key, step and unit of scene files
WEIGHTS = {"R": 0.2126390059, "G": 0.7151686788, "B": 0.0721923154}
MOST = 0.5   # %: the differences' own error and that of the picture's rays


def accretion(spin):
    """Its text, values to begin with, pixels."""
    text = re.sub(r'\[sky\].*?\n\n', '[sky]\nkind = "black"\n\n', (SCENES / "accretion.toml").read_text(), flags=re.S)
    text = text.replace('texture = "gas"', 'texture = "plain"').replace('flow = "kepler"\n', "").replace("gas_winding = 3.0\n", "")
    return text, {"spacetime.metric": "kerr", "spacetime.spin": spin, "camera.theta": 81.0}, (32, 18)


def matter(name):
    text = (SCENES / f"{name}.toml").read_text()
    spin, theta = (float(re.search(rf"^{key} = (\S+)", text, re.M)[1]) for key in ("spin", "theta"))
    return text, {"spacetime.spin": spin, "camera.theta": theta}, (16, 9)


def main():
    binary, of = ARGUMENTS[0], ARGUMENTS[1] if len(ARGUMENTS) > 1 else "0"
    size = int(ARGUMENTS[2]) // 16 if len(ARGUMENTS) > 2 else 4
    text, base, (width, height) = matter(of) if (SCENES / f"{of}.toml").exists() else accretion(float(of))
    worst = 0.0
    with tempfile.TemporaryDirectory() as folder:
        scene, picture = str(Path(folder) / "scene.toml"), str(Path(folder) / "picture.exr")
        Path(scene).write_text(text)

        def run(command, values, *options):
            sets = [word for key, value in values.items() for word in ("--set", f"{key}={value}")]
            return subprocess.run([binary, command, scene, *sets, *options], check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout

        def flux(values):
            run("capture", values, "--renderer", "reference", "--size", f"{width * size}x{height * size}", "--samples", "16", "-o", picture)
            channels = support.read_exr(Path(picture).read_bytes())
            return sum(weight * sum(map(sum, channels[name])) for name, weight in WEIGHTS.items()) / size ** 2

        rows = csv.DictReader(io.StringIO(run("flux", base, "--size", f"{width}x{height}", "--derivatives", ",".join(STEPS))))
        found = {row["key"]: float(row["value"]) for row in rows}
        print(f"flux {found['flux']:.6g}, of the picture {flux(base):.6g}", flush=True)
        for name, (key, step, unit) in STEPS.items():
            down, up = (flux({**base, key: base[key] + side * step}) for side in (-1, 1))
            slope = (up - down) / (2 * step * unit)
            off = 100 * (found['d_' + name] / slope - 1)
            worst = max(worst, abs(off))
            print(f"{name}: {found['d_' + name]:.6g}, by pictures {slope:.6g}: {off:+.3f} %", flush=True)
    sys.exit(worst > MOST)


if __name__ == "__main__":
    main()
