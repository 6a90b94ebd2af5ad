#!/usr/bin/env python3
"""How often the 68 % intervals of fits hold the truth: data drawn by the reference, with the noise of each seed.

Usage: fit_coverage.py PATH-OF-NULLSCOPE FIRST LAST    (seeds, both included; some core-second each; by hand)
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

import fit_data


def main():
    binary, first, last = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    held = dict.fromkeys(fit_data.TRUE, 0)
    with tempfile.TemporaryDirectory() as folder:
        scene, drawn, data = (str(Path(folder) / name) for name in ("scene.toml", "drawn.fits", "data.fits"))
        Path(scene).write_text(fit_data.SCENE % (32, 32))
        subprocess.run([binary, "capture", scene, "--renderer", "reference", "--samples", "8", "-o", drawn], check=True, stdout=subprocess.DEVNULL)
        rows = fit_data.rows_of(Path(drawn).read_bytes())
        sigma = fit_data.brightest(rows) / 30
        for seed in range(first, last + 1):
            Path(data).write_bytes(fit_data.fits(fit_data.noisy(rows, sigma, seed)))
            fit = subprocess.run([binary, "fit", data, scene, "--free", "spin=0:0.99,camera.theta=10:80", "--sigma", repr(sigma), "--starts", "1", "--json"],
                                 check=True, capture_output=True)
            for one in json.loads(fit.stdout)["parameters"]:
                held[one["key"]] += abs(one["best"] - fit_data.TRUE[one["key"]]) < one["sigma"]
    for key, count in held.items():
        print(f"{key}: {count} of {last - first + 1}, {100 * count / (last - first + 1):.1f} %")


if __name__ == "__main__":
    main()
