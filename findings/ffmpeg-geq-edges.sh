#!/usr/bin/env bash
# ffmpeg 7.0.2, filter geq: r(X,Y), lum(X,Y) and the others, which are the value of a pixel; 9.0.2 to compare.
#
# Guessed: X and Y are whole numbers, and r(X,Y) is the pixel there, so that geq=r='r(X,Y)':g='g(X,Y)':b='b(X,Y)' changes nothing.
# Seen: without a word, with the default interpolation (bilinear) the last column is a copy of the one before it, and the last row of the row above, in
# 8 and 16 bits and in floats: a place is moved until it lies within a square of four pixels, short of its far sides. A mirror, r(W-1-X,Y), has the
# column before the last twice on its left, and the last one nowhere. With interpolation=nearest all is as guessed, and in 9.0.2 with either.
# Who makes exact pictures by geq (masks, test patterns, gains by place) in versions before 9 gives interpolation=nearest.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet numpy==2.4.6
for version in 0.6.0 0.8.1; do "$folder/venv/bin/pip" install --quiet --no-deps --target "$folder/$version" "imageio-ffmpeg==$version"; done
cd "$folder"
venv/bin/python - <<'PYTHON'
import pathlib
import subprocess
import sys

import numpy as np

WIDTH, HEIGHT = 8, 4
KINDS = {"gbrp": ("u1", 2), "gbrp16le": ("<u2", 600), "gbrpf32le": ("<f4", 0.01)}
SAME = "r='r(X,Y)':g='g(X,Y)':b='b(X,Y)'"
MIRROR = "r='r(W-1-X,Y)':g='g(W-1-X,Y)':b='b(W-1-X,Y)'"


def ran(program, kind, words, planes):
    command = [program, "-v", "error", "-f", "rawvideo", "-pix_fmt", kind, "-s", f"{WIDTH}x{HEIGHT}", "-i", "-", "-vf", "geq=" + words,
               "-f", "rawvideo", "-pix_fmt", kind, "-"]
    out = subprocess.run(command, input=planes.tobytes(), capture_output=True, check=True).stdout
    return np.frombuffer(out, planes.dtype).reshape(planes.shape)


changed = []
for package in ("0.6.0", "0.8.1"):
    program = str(next(path for path in pathlib.Path(package, "imageio_ffmpeg/binaries").iterdir() if path.name.startswith("ffmpeg")))
    pathlib.Path(program).chmod(0o755)
    version = subprocess.run([program, "-version"], capture_output=True, text=True, check=True).stdout.split()[2].lstrip("n").split("-")[0]
    for kind, (size, step) in KINDS.items():
        planes = (np.arange(3 * WIDTH * HEIGHT).reshape(3, HEIGHT, WIDTH) * step).astype(size)
        edges = planes.copy()
        edges[:, -1], edges[:, :, -1] = edges[:, -2], edges[:, :, -2]
        edges[:, -1, -1] = planes[:, -2, -2]
        for name, words, meant, described in (("r(X,Y)", SAME, planes, edges), ("r(W-1-X,Y)", MIRROR, planes[:, :, ::-1], edges[:, :, ::-1])):
            for nearest in (False, True):
                seen = ran(program, kind, ("interpolation=nearest:" if nearest else "") + words, planes)
                wanted = meant if nearest or version.startswith("9.") else described
                print(f"ffmpeg {version}, {kind}, {name}{', nearest' if nearest else ''}: {int((seen != meant).sum())} of {planes.size} values are another pixel's")
                if np.abs(seen.astype(float) - wanted).max() > 1e-6 * planes.max():
                    changed.append(f"{version} {kind} {name}")
sys.exit(f"changed: {', '.join(changed)}" if changed else 0)
PYTHON
