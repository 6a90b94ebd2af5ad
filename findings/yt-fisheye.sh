#!/usr/bin/env bash
# yt 4.4.3, volume rendering through lens_type="fisheye", the lens for domes.
#
# Guessed: as through "perspective" and "spherical", what the camera aims at is in the middle of the picture, its north vector points up and its
# right lies on the right; a light at an angle t from the aim is t / (fov / 2) of the circle's radius from the middle.
# Seen: without a word,
#   the aim and the north vector are not used: whatever they are, -z of the box is in the middle and the pictures are equal to the last bit;
#   the picture is mirrored: +x lies on the right and +y below the middle, which is what one sees looking along +z, not -z.
# Only the radius is as guessed. A film in which the camera turns thus stands still, and spirals in it wind the wrong way.
# Who renders domes with it sets lens.rotation_matrix to the columns right, -up and -aim: no rotation but a reflection, which undoes the mirror.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet yt==4.4.3 pillow==13.0.0 numpy==2.4.6
cd "$folder"
venv/bin/python -W ignore - <<'PYTHON'
import sys

import numpy as np
import yt
from PIL import Image

CELLS, SIZE, FOV = 64, 96, 360.0         # of the fisheye, pixels and degrees
AIMS = {"+x": (1, 0, 0), "+y": (0, 1, 0), "slanting": (2, -1, 1.5)}
NORTH = np.array([0.0, 0.0, 1.0])
RIGHT_BY, UP_BY = np.radians(12), np.radians(8)     # where the light is, seen from the camera
yt.set_log_level("error")


def axes(aim):
    """Unit vectors of a camera: forward, right and up."""
    forward = np.array(aim, float) / np.linalg.norm(aim)
    right = np.cross(forward, NORTH)
    right /= np.linalg.norm(right)
    return forward, right, np.cross(right, forward)


def picture(lens, aim, light, resolution, matrix=None):
    """Grey values of the saved picture of a ball of gas in the direction light, seen from the middle of the box."""
    side = (np.arange(CELLS) + 0.5) / CELLS * 2 - 1
    away = sum((where - 0.5 * at) ** 2 for where, at in zip(np.meshgrid(side, side, side, indexing="ij"), light))
    gas = 1e-3 + np.exp(-away / (2 * 0.05**2))
    data = yt.load_uniform_grid({("gas", "density"): (gas, "g/cm**3")}, gas.shape, bbox=np.array([[-1, 1]] * 3), length_unit=1.0)
    scene = yt.create_scene(data, field=("gas", "density"), lens_type=lens)
    colours = yt.ColorTransferFunction((1e-4, 2))
    colours.add_gaussian(0.7, 0.05, [1, 1, 1, 1])
    scene[0].set_log(False)
    scene[0].transfer_function = colours
    camera = scene.camera
    camera.resolution = resolution
    camera.focus = data.arr(0.9 * axes(aim)[0], "code_length")
    camera.set_position(data.arr([0.0, 0.0, 0.0], "code_length"), north_vector=NORTH)
    camera.set_width(data.quan(2, "code_length"))
    if lens == "fisheye":
        camera.lens.fov = FOV
    if matrix is not None:
        camera.lens.rotation_matrix = matrix
    scene.render()
    scene.save("picture.png", sigma_clip=None, render=False)
    return np.asarray(Image.open("picture.png").convert("L")).astype(float)


def place(grey):
    """Middle of the light, to the right of and above the picture's middle, in parts of half its width and height."""
    rows, columns = np.indices(grey.shape)
    column, row = ((at * grey).sum() / grey.sum() for at in (columns, rows))
    return np.array([2 * column / (grey.shape[1] - 1) - 1, 1 - 2 * row / (grey.shape[0] - 1)])


def fisheye(light, forward, right, up):
    """Where an equidistant fisheye with these axes shows the direction light."""
    angle = np.arccos(light @ forward)
    across = np.array([light @ right, light @ up])
    return angle / np.radians(FOV / 2) * across / np.linalg.norm(across)


changed, PIXEL = [], 2 / SIZE
for name, aim in AIMS.items():
    forward, right, up = axes(aim)
    light = np.cos(UP_BY) * (np.cos(RIGHT_BY) * forward + np.sin(RIGHT_BY) * right) + np.sin(UP_BY) * up
    pinhole = place(picture("perspective", aim, light, (SIZE, SIZE)))
    sphere = place(picture("spherical", aim, light, (2 * SIZE, SIZE)))
    plain = place(picture("fisheye", aim, light, (SIZE, SIZE)))
    mended = place(picture("fisheye", aim, light, (SIZE, SIZE), np.column_stack([right, -up, -forward])))
    guessed, described = fisheye(light, forward, right, up), fisheye(light, -NORTH, np.array([1.0, 0, 0]), np.array([0, -1.0, 0]))
    print(f"aim {name:<9} perspective {pinhole.round(3)}, spherical {sphere.round(3)}, fisheye {plain.round(3)}, with a matrix {mended.round(3)}; "
          f"guessed {guessed.round(3)}, as described {described.round(3)}")
    if min(pinhole) < 0.1 or abs(sphere - [RIGHT_BY / np.pi, UP_BY / (np.pi / 2)]).max() > 2 * PIXEL:
        changed.append(f"the other lenses, aim {name}")
    if abs(plain - described).max() > 2 * PIXEL or abs(plain - guessed).max() < 0.2 or abs(mended - guessed).max() > 2 * PIXEL:
        changed.append(f"the fisheye, aim {name}")
light = axes((1, 2, -3))[0]
same = [picture("fisheye", aim, light, (SIZE, SIZE)) for aim in AIMS.values()]
equal = all(np.array_equal(grey, same[0]) for grey in same)
print("one light, three aims: equal pictures", equal)
if not equal:
    changed.append("the aim counts")
sys.exit(f"changed: {', '.join(changed)}" if changed else 0)
PYTHON
