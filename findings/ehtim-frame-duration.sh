#!/usr/bin/env bash
# ehtim 1.3.2, ehtim.movie.merge_im_list(images, framedur): "duration of a movie frame in seconds".
#
# Guessed: n images become frames that are framedur apart, and the movie lasts n framedur, or (n - 1) framedur from the first frame to the last.
# Seen: without a word they are n/(n - 1) framedur apart: two images with framedur = 60 s are 120 s apart, eleven 66 s. The frame that was drawn for one
# minute is what the movie shows for another; of a source that turns once in an hour, ten frames of six minutes turn by 324 degrees in an hour.
# Who makes movies for ehtim gives each image its own time and no framedur (which is right).
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet ehtim==1.3.2 astropy==8.0.2 numpy==2.4.6 scipy==1.17.1
cd "$folder"
venv/bin/python -W ignore - <<'PYTHON'
import sys

import ehtim
import numpy as np

SECONDS = 60.0
changed = []
for count in (2, 6, 11):
    images = []
    for number in range(count):
        image = ehtim.image.Image(np.eye(8), ehtim.RADPERUAS, 12.0, 12.0)
        image.time = number * SECONDS / 3600
        images.append(image)
    own = 3600 * np.diff(ehtim.movie.merge_im_list(images).times)
    told = 3600 * np.diff(ehtim.movie.merge_im_list(images, framedur=SECONDS).times)
    print(f"{count} images {SECONDS:g} s apart: by their own times {own[0]:.6g} s apart, by framedur = {SECONDS:g} s {told[0]:.6g} s")
    if abs(own - SECONDS).max() > 1e-6 or abs(told - SECONDS * count / (count - 1)).max() > 1e-6:
        changed.append(count)
print("changed:", changed or "nothing")
sys.exit(bool(changed))
PYTHON
