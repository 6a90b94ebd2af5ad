#!/usr/bin/env python3
"""How often the 68 % intervals of fits hold the truth: data drawn by the reference, with the noise of each seed.

Usage: fit_coverage.py PATH-OF-NULLSCOPE FIRST LAST    (seeds, both included; some core-seconds each; by hand; ended early it counts those that were done)
"""
import json
import signal
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
        done = 0
        try:
            for seed in range(first, last + 1):
                Path(data).write_bytes(fit_data.fits(fit_data.noisy(rows, sigma, seed)))
                fit = subprocess.run([binary, "fit", data, scene, "--free", "spin=0:0.99,camera.theta=10:80", "--sigma", repr(sigma), "--starts", "1", "--json"],
                                     check=True, capture_output=True)
                off = {one["key"]: (one["best"] - fit_data.TRUE[one["key"]]) / one["sigma"] for one in json.loads(fit.stdout)["parameters"]}
                for key, deviations in off.items():
                    held[key] += abs(deviations) < 1
                done += 1
                print(f"seed {seed}:", *(f"{key} off by {deviations:+.2f} sigma" for key, deviations in off.items()), flush=True)
        except (KeyboardInterrupt, subprocess.CalledProcessError) as early:   # the program ends by the signal too
            print(f"ended at seed {first + done}: {early!r}")
    for key, count in held.items():
        print(f"{key}: {count} of {done}, {100 * count / max(done, 1):.1f} %")


def interrupt(*_):
    raise KeyboardInterrupt


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, interrupt)
    main()
