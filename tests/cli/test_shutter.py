#!/usr/bin/env python3
"""Frames with motion blur in every kind of file, and cameras that go to a table and come back."""
import math
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


    def test_a_path_by_axes_is_that_by_angles(self):
        """Pictures by yaw, pitch and roll, by look and up, and by a quaternion; of frames between the rows the last two."""
        tables = {"angles": ["yaw,pitch,roll"], "looks": ["look_x,look_y,look_z,up_x,up_y,up_z"], "turns": ["qw,qx,qy,qz"]}
        for row, (x, y, yaw, pitch, roll) in enumerate(((20, 3, 5, 4, 10), (15, 8, -12, -3, 70))):
            r, phi = math.hypot(x, y), math.atan2(y, x)
            out, east, north = (math.cos(phi), math.sin(phi), 0), (-math.sin(phi), math.cos(phi), 0), (0, 0, 1)
            a, b, c = (math.radians(angle) for angle in (yaw, pitch, roll))
            frame = [east, north, out]                                    # right, up and backward of a camera that looks inward
            for one, other, angle in ((2, 0, -a), (2, 1, -b), (0, 1, -c)):   # yaw: forward to the right; pitch: to up; roll: up to the right
                turned = list(frame)
                turned[one] = [math.cos(angle) * p + math.sin(angle) * q for p, q in zip(frame[one], frame[other])]
                turned[other] = [math.cos(angle) * q - math.sin(angle) * p for p, q in zip(frame[one], frame[other])]
                frame = turned
            right, up, back = frame
            w = 0.5 * math.sqrt(1 + right[0] + up[1] + back[2])
            turn = (w, (up[2] - back[1]) / (4 * w), (back[0] - right[2]) / (4 * w), (right[1] - up[0]) / (4 * w))
            for name, numbers in (("angles", (yaw, pitch, roll)), ("looks", [-7 * v for v in back] + list(up)), ("turns", turn)):
                tables[name].append(",".join(repr(v) for v in numbers))
            for name in tables:
                tables[name][-1] += f",{4 * row},{x},{y},0"
        for name, lines in tables.items():
            self.write(f"{name}.csv", "\n".join([lines[0] + ",frame,x,y,z", *lines[1:]]) + "\n")
            self.write(f"{name}.toml", f'[sky]\nkind = "checker"\n[path]\nkind = "keys"\nfile = "{name}.csv"\n')
            for frame in (0, 2, 4):
                self.run_nullscope("capture", f"{name}.toml", "--size", "64x36", "--frames", f"{frame}:{frame + 1}", "-o", name + "%d.exr")

        def apart(one, other):
            return float(re.search(r"max ([0-9.e-]+)", self.run_nullscope("compare", one, other).out).group(1))
        for frame in (0, 4):
            for name in ("looks", "turns"):
                self.assertLess(apart(f"angles{frame}.exr", f"{name}{frame}.exr"), 1e-4, f"{name} {frame}")
        self.assertLess(apart("looks2.exr", "turns2.exr"), 1e-4)
        self.assertGreater(apart("angles2.exr", "turns2.exr"), 1e-2)
        self.assertGreater(apart("turns0.exr", "turns4.exr"), 1e-2)
        self.write("turns.csv", "qw,qx,qy,qz\n1,0,0,0\n0.5,0,0,0\n")
        self.refused("capture", "turns.toml", "--frames", "0:1", "-o", "no%d.png",
                     says=["turns.csv:3: qw: qw, qx, qy, qz have the length 0.5; allowed: [0.999, 1.001]"])


if __name__ == "__main__":
    support.main()
