#!/usr/bin/env python3
"""Frames with motion blur in every kind of file, and cameras that go to a table and come back."""
import re
import sys
from pathlib import Path

import support

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "viewer"))
from x_screen import read_png  # noqa: E402
from test_pictures import png_texts  # noqa: E402

FLIGHT = """[camera]
r = 12
[disc]
[picture]
shutter = 0.5
sub_frames = 4
[path]
kind = "keys"
[[path.key]]
[[path.key]]
frame = 10
phi = 300
yaw = 25
r = 9
"""
BALL = '[sky]\nkind = "black"\n[camera]\nr = 15\n[ball]\nposition = [6, 0, 0]\nmotion = "orbit"\n[picture]\nshutter = 1\n'


class Shutter(support.CliTest):
    def capture(self, scene, *options, **how):
        return self.run_nullscope("capture", scene, "--size", support.SMALL, *options, **how)

    def test_every_kind_of_file(self):
        scene = self.write("flight.toml", FLIGHT)
        sharp = self.write("sharp.toml", FLIGHT.replace("shutter = 0.5", "shutter = 0"))
        ran = self.capture(scene, "--frames", "5:6", "-o", "b%d.png")
        self.assertRegex(ran.out, r"^b5\.png: 48x27, .*, 4 sub-frames in [0-9.]+ s\n$")
        self.assertRegex(ran.err, r"^picture\.sub_frames: in frame 5 the camera turns by [0-9.]+ px from one to the next, "
                                  r"bright points leave dots; [0-9]+ would leave none in any frame\n$")
        ran = self.capture(sharp, "--frames", "5:6", "-o", "s%d.png")
        self.assertNotIn("sub-frames", ran.out + ran.err)
        blurred, still = read_png(self.folder / "b5.png"), read_png(self.folder / "s5.png")
        self.assertGreater(sum(a != b for a, b in zip(blurred.data, still.data)), 48 * 27, "no blur")
        # In linear light, in half floats, by the reference, of both halves of a split screen.
        self.capture(scene, "--frames", "5:6", "-o", "b%d.exr")
        self.capture(scene, "--frames", "5:6", "--half", "-o", "h%d.exr")
        self.capture(scene, "--frames", "5:6", "--renderer", "reference", "--samples", "2", "-o", "r%d.exr")
        for other, most in (("h5.exr", 2e-3), ("r5.exr", 0.1)):
            said = self.run_nullscope("compare", "b5.exr", other).out
            self.assertLess(float(re.search(r"median +([0-9.e-]+)", said).group(1)), most, said)
        self.capture(scene, "--frames", "5:6", "--split", "flat", "-o", "two%d.jpg")

    def test_each_eye_of_a_pair_is_blurred(self):
        pair = self.write("pair.toml", FLIGHT.replace("[disc]", 'stereo = "pair"\neye_distance = 0.01\n[disc]'))
        self.capture(pair, "--frames", "5:6", "-o", "pair%d.png")
        self.capture(pair, "--frames", "5:6", "--half", "-o", "pair%d.exr")
        self.capture(self.write("one.toml", FLIGHT), "--frames", "5:6", "-o", "one%d.png")
        two, one = read_png(self.folder / "pair5.png"), read_png(self.folder / "one5.png")
        self.assertEqual(two.width, 2 * one.width)
        for left in (0, one.width):   # nearly the same place
            off = [abs(two.grey(left + x, y) - one.grey(x, y)) for x in range(one.width) for y in range(one.height)]
            self.assertLess(sum(off) / len(off), 4)

    def test_a_frame_is_drawn_again_from_its_own_words(self):
        scene = self.write("flight.toml", FLIGHT)
        self.capture(scene, "--frames", "5:6", "-o", "b%d.png")
        again = self.write("again.toml", png_texts((self.folder / "b5.png").read_bytes())["nullscope.scene_text"])
        self.run_nullscope("capture", again, "--frames", "5:6", "-o", "again%d.png")
        self.assertEqual((self.folder / "b5.png").read_bytes(), (self.folder / "again5.png").read_bytes())

    def test_what_moves_needs_a_frames_time(self):
        scene = self.write("ball.toml", BALL)
        ran = self.capture(scene, "-o", "one.png")
        self.assertEqual(ran.said(), "picture.shutter: no motion blur, as nothing moves without a [path] or --time-step\n")
        self.assertNotIn("sub-frames", ran.out)
        ran = self.capture(scene, "--time-step", "2", "-o", "blurred.png")
        self.assertIn("16 sub-frames", ran.out)
        self.assertNotEqual((self.folder / "one.png").read_bytes(), (self.folder / "blurred.png").read_bytes())
        self.refused("capture", scene, "--raydata", "-o", "rays.exr", says=["picture.shutter"])

    def test_a_path_comes_back_from_its_table(self):
        scene = self.write("flight.toml", FLIGHT)
        ran = self.run_nullscope("path", scene, "-o", "camera.csv")
        self.assertEqual(ran.out, "camera.csv: 11 frames\n")
        again = self.write("again.toml", FLIGHT.split("[[path.key]]")[0] + 'file = "camera.csv"\n')
        for name, file in (("a", scene), ("b", again)):
            self.capture(file, "--frames", "4:5", "-o", name + "%d.exr")
        said = self.run_nullscope("compare", "a4.exr", "b4.exr").out
        self.assertLess(float(re.search(r"max[a-z]* +([0-9.e-]+)", said).group(1)), 1e-4, said)
        self.refused("path", scene, "3:12", "-o", "no.csv", says=["frames 3:12 of a path of 11"])
        self.refused("path", "flat", says=["no [path]"])
        self.write("camera.csv", "r\n9\nfar\n")
        self.refused("capture", again, says=['camera.csv:3: r: "far" is no number; allowed: [-1000000000, 1000000000]'])


if __name__ == "__main__":
    support.main()
