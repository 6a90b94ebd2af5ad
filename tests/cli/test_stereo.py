#!/usr/bin/env python3
"""Each eye's half of a stereo picture is the picture of a camera that is there, and a cube's faces are six pinhole pictures."""
import math
import sys
import unittest
from pathlib import Path

import support

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "viewer"))
from test_pictures import png_texts  # noqa: E402
from x_screen import read_png  # noqa: E402

WIDTH, HEIGHT = 160, 90
APART = 2.0     # r_s: much more than a person would want
R = 10.0
REFERENCE = "--renderer", "reference", "--samples", "2"
THINGS = '''[sky]
kind = "checker"
[[ball]]
position = [6, 0.8, 0.5]
radius = 0.5
colour = [1, 0, 0]
second_colour = [1, 0, 0]
'''


def scene(camera, things=THINGS, metric="schwarzschild"):
    return f'[spacetime]\nmetric = "{metric}"\n[camera]\ntheta = 90\n{camera}\n{things}'


def redness(picture):
    """Mean column of what is red."""
    columns = [i % picture.width for i in range(picture.width * picture.height)
               if picture.data[3 * i] > 60 and picture.data[3 * i + 1] < 0.5 * picture.data[3 * i]]
    return sum(columns) / len(columns)


def eye_place(metric, side):
    """r, phi and yaw of an eye, deg: at the end of a geodesic that begins across the radius; with r = R + x^2 all is smooth."""
    def lapse(r):
        return 1 - 1 / r if metric == "schwarzschild" else 1.0

    def to(end):
        way = angle = 0.0
        for i in range(400):
            x = (i + 0.5) * end / 400
            r = R + x * x
            ds = 2 * r * end / 400 / math.sqrt(lapse(r) * (r + R))
            way, angle = way + ds, angle + R * ds / r ** 2
        return way, angle
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if to(middle)[0] < 0.5 * APART else (low, middle)
    r = R + low * low
    return r, side * math.degrees(to(low)[1]), side * math.degrees(math.acos(R / r))


class Stereo(support.CliTest):
    def picture(self, text, name, *options):
        self.run_nullscope("capture", self.write("scene.toml", text), "-o", name, *options)
        return read_png(self.folder / name)

    def assert_same(self, one, other, most, mean):
        """most, mean: difference of colours of 8 bits; most 0: any."""
        self.assertEqual((one.width, one.height), (other.width, other.height))
        steps = [abs(a - b) for a, b in zip(one.data, other.data)]
        self.assertLessEqual((max(steps) if most else 0), most)
        self.assertLess(sum(steps) / len(steps), mean)

    @support.costly
    def test_a_pair_is_two_cameras_pictures_left_eye_first(self):
        for metric in ("minkowski", "schwarzschild"):
            size = f"size = [{WIDTH}, {HEIGHT}]"
            camera = f'r = {R}\n{size}\nstereo = "pair"\neye_distance = {APART}'
            pair = self.picture(scene(camera, metric=metric), "pair.png")
            self.assertEqual((pair.width, pair.height), (2 * WIDTH, HEIGHT))
            eyes = [pair.crop(i * WIDTH, 0, (i + 1) * WIDTH, HEIGHT) for i in range(2)]
            self.assertGreater(redness(eyes[0]), redness(eyes[1]) + 10, "the eyes are swapped")
            for side, eye in zip((-1, 1), eyes):
                r, phi, yaw = eye_place(metric, side)
                alone = scene(f"r = {r!r}\nphi = {phi!r}\nyaw = {yaw!r}\n{size}", metric=metric)
                self.assert_same(eye, self.picture(alone, "eye.png"), 3, 0.01)
                if metric != "minkowski" and not support.QUICK:
                    width, height = 48, 27
                    exact = self.picture(alone, "exact.png", "--size", f"{width}x{height}", *REFERENCE)
                    both = self.picture(scene(camera), "both.png", "--size", f"{width}x{height}", *REFERENCE)
                    left = width if side > 0 else 0
                    self.assert_same(both.crop(left, 0, left + width, height), exact, 3, 0.01)

    @unittest.skipIf(support.QUICK, "the reference draws: with --all")
    def test_the_reference_and_files_of_linear_light(self):
        plain = THINGS.replace("checker", "plain")
        pair = scene(f'r = {R}\nsize = [48, 27]\nstereo = "pair"\neye_distance = {APART}', plain)
        whole = scene('r = 10\nsize = [64, 32]\nprojection = "equirectangular"\nstereo = "all-round"', plain)
        for text, size in ((pair, (96, 27)), (whole, (64, 64))):
            drawn, exact = self.picture(text, "gl.png"), self.picture(text, "exact.png", *REFERENCE)
            self.assertEqual((drawn.width, drawn.height), size)
            self.assert_same(drawn, exact, 0, 2)   # edges of the ball
            self.assertAlmostEqual(redness(drawn), redness(exact), delta=0.5)
            path = self.write("scene.toml", text)
            self.run_nullscope("capture", path, "-o", "a.exr")
            self.run_nullscope("capture", path, "-o", "b.exr", "--half")
            self.assertRegex(self.run_nullscope("compare", "a.exr", "b.exr").out, r"difference +max (0 |\d\.\d+e-0[4-9]|0\.000)")

    def test_all_round_eyes_turn_with_the_columns(self):
        """Red balls ahead, behind and at the right: seen by the left eye farther to the right, everywhere."""
        for position, longitude in (("[7, 0, 0]", -60), ("[13, 0, 0]", 120), ("[10, 3, 0]", 30)):
            things = THINGS.replace("[6, 0.8, 0.5]", position)
            text = scene('r = 10\nyaw = 60\nsize = [256, 128]\nprojection = "equirectangular"\nstereo = "all-round"\neye_distance = 0.6',
                         things, "minkowski")
            both = self.picture(text, "round.png")
            left, right = (redness(both.crop(0, 128 * i, 256, 128 * (i + 1))) for i in range(2))
            apart_px = 2 * math.asin(0.3 / 3) * 256 / (2 * math.pi)
            self.assertAlmostEqual(left - right, apart_px, delta=0.3)
            self.assertAlmostEqual(0.5 * (left + right) + 0.5, 128 + longitude / 360 * 256, delta=0.2)

    def test_frames_do_not_depend_on_those_before(self):
        text = scene('r = 8\nsize = [64, 32]\nprojection = "equirectangular"\nstereo = "all-round"') + '[path]\nkind = "fall"\nframes = 40\n'
        path = self.write("scene.toml", text)
        self.run_nullscope("capture", path, "--frames", "0:3", "-o", "a%d.png")
        self.run_nullscope("capture", path, "--frames", "2:3", "-o", "b%d.png")
        self.assertEqual((self.folder / "a2.png").read_bytes(), (self.folder / "b2.png").read_bytes())
        self.refused("capture", path, "--frames", "0:40", "-o", "c%d.png", says=("eye_distance", "frame 39"))
        for option in (["--raydata", "-o", "d.exr"], ["--split", "flat", "-o", "d.png"]):
            self.refused("capture", path, *option, says=("camera.stereo", option[0]))

    def test_the_size_of_a_cube(self):
        """Is the scene's, 1536x1024 where it says none, or --size: three columns and two rows of squares."""
        for size in "", "size = [192, 128]":
            path = self.write("scene.toml", scene(f'r = 10\n{size}\nprojection = "cube"'))
            self.run_nullscope("capture", path, "--size", "48x32", "-o", "small.png")
            self.assertEqual(read_png(self.folder / "small.png").width, 48)
            for wrong, right in (("64x64", "192x128"), ("50x33", "51x34"), ("1x1", "3x2"), ("48x31", "48x32")):
                self.refused("capture", path, "--size", wrong, "-o", "small.png", says=(f"--size {wrong}", right, "three columns and two rows"))
        self.refused("plan", self.write("scene.toml", scene('r = 10\nsize = [64, 64]\nprojection = "cube"')),
                     says=("scene.toml:", "camera.size", "[192, 128]"))

    @support.costly
    def test_faces_of_a_cube(self):
        camera = 'r = 10\nyaw = 20\npitch = 10\nsize = [192, 128]\nprojection = "cube"'
        path = self.write("scene.toml", scene(camera))
        self.run_nullscope("capture", path, "-o", "all.png")
        for kind in "png", "exr":
            self.run_nullscope("capture", path, "-o", f"face-%s.{kind}")
        together = read_png(self.folder / "all.png")
        for i, name in enumerate(("left", "front", "right", "down", "back", "up")):
            face = read_png(self.folder / f"face-{name}.png")
            left, top = i % 3 * 64, i // 3 * 64
            self.assert_same(face, together.crop(left, top, left + 64, top + 64), 0, 0.3)   # but for edges where faces meet
            texts = png_texts((self.folder / f"face-{name}.png").read_bytes())   # a pinhole camera of its own
            self.assertNotIn("cube", texts["nullscope.scene_text"])
            for kind in "png", "exr":   # drawn again from itself
                self.run_nullscope("capture", f"face-{name}.{kind}", "-o", f"again.{kind}")
                self.assertEqual((self.folder / f"again.{kind}").read_bytes(), (self.folder / f"face-{name}.{kind}").read_bytes(), name)
        for text, options, says in ((scene("r = 10"), ["-o", "f%s.png"], "cube"),
                                    (scene(camera), ["-o", "f%s-%s.png"], "one place"),
                                    (scene(camera) + '[picture]\nauto_exposure = "on"\n', ["-o", "f%s.png"], "auto_exposure"),
                                    (scene(camera), ["--frames", "0:2", "-o", "f%s%d.png"], "one picture")):
            self.refused("capture", self.write("scene.toml", text), *options, says=(says,))


if __name__ == "__main__":
    support.main()
