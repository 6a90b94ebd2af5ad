#!/usr/bin/env bash
# ffmpeg 7.0.2 and 9.0.2, an OpenEXR picture (linear light) into a PNG.
#
# Guessed: light is encoded for a display on the way, as viewers of EXR do; or the option of the EXR decoder for it, -apply_trc, goes on working.
# Seen: without a word, both write the numbers of light as display values: middle grey, 0.18, becomes 46 of 255 instead of 118, and the picture is
# dark. -apply_trc iec61966_2_1 gives 118 in 7.0.2 and is unknown in 9.0.2; the filter that replaces it there, scale=out_transfer=iec61966-2-1 behind
# format=gbrpf32le, is unknown in 7.0.2. zscale=tin=linear:t=iec61966-2-1 gives 118 in both.
# Who makes films of EXR sequences by a script that is to last uses zscale.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet numpy==2.4.6 OpenEXR==3.5.3
for version in 0.6.0 0.8.1; do "$folder/venv/bin/pip" install --quiet --no-deps --target "$folder/$version" "imageio-ffmpeg==$version"; done
cd "$folder"
venv/bin/python - <<'PYTHON'
import pathlib
import subprocess
import sys

import numpy as np
import OpenEXR

grey = np.full((16, 16), 0.18, dtype=np.float32)
with OpenEXR.File({"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}, {channel: grey for channel in "RGB"}) as file:
    file.write("grey.exr")
DARK, RIGHT = round(255 * 0.18), round(255 * (1.055 * 0.18 ** (1 / 2.4) - 0.055))
WAYS = {"as it is": ([], []), "-apply_trc": (["-apply_trc", "iec61966_2_1"], []), "scale=out_transfer": ([], ["-vf", "format=gbrpf32le,scale=out_transfer=iec61966-2-1"]),
        "zscale": ([], ["-vf", "zscale=tin=linear:t=iec61966-2-1,format=gbrp"])}
DESCRIBED = {"7.0.2": (DARK, RIGHT, None, RIGHT), "9.0.2": (DARK, None, RIGHT, RIGHT)}
changed = []
for package in ("0.6.0", "0.8.1"):
    program = str(next(path for path in pathlib.Path(package, "imageio_ffmpeg/binaries").iterdir() if path.name.startswith("ffmpeg")))
    pathlib.Path(program).chmod(0o755)
    version = subprocess.run([program, "-version"], capture_output=True, text=True, check=True).stdout.split()[2].lstrip("n").split("-")[0]
    for (name, (before, behind)), described in zip(WAYS.items(), DESCRIBED[version], strict=True):
        subprocess.run(["rm", "-f", "seen.png"], check=True)
        done = subprocess.run([program, "-v", "error", *before, "-i", "grey.exr", *behind, "-pix_fmt", "rgb24", "seen.png"], capture_output=True)
        seen = None
        if done.returncode == 0:
            out = subprocess.run([program, "-v", "error", "-i", "seen.png", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], capture_output=True, check=True).stdout
            seen = int(np.median(np.frombuffer(out, "u1")))
        print(f"ffmpeg {version}, {name}: {'refused' if seen is None else seen}, described {'refused' if described is None else described}")
        if (seen is None) != (described is None) or seen is not None and abs(seen - described) > 1:
            changed.append(f"{version} {name}")
sys.exit(f"changed: {', '.join(changed)}" if changed else 0)
PYTHON
