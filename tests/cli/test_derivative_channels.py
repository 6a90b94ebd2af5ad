"""nullscope capture --raydata --derivatives: channels of an EXR against differences of the reference's ray data, and against a closed form."""
import math
import unittest

import support

SIZE = ("--size", "32x18")
NAMES = ("x", "y", "z", "shift", "delay", "right", "down")
OF_RAY = {"x": "sky.x", "y": "sky.y", "z": "sky.z", "shift": "ray.shift", "delay": "delay"}
STEPS = {"spacetime.spin": 2e-3, "camera.theta": 2e-3}   # rad
# Of channels in floats, read as differences of both: 1e-7 of the size, over 2 steps; and of the third derivative, a millionth of it.
OF_FLOATS, RELATIVE = 2e-4, 2e-3
LEAST_JUDGED = 0.5  # of the pixels that see the sky, at least: whose derivatives do not change by a quarter from one pixel to the next, as next to the critical curve


class DerivativeChannels(support.CliTest):
    def channels(self, *words):
        self.run_nullscope("capture", *words, "-o", "a.exr")
        return support.read_exr((self.folder / "a.exr").read_bytes())

    def scene(self, spin=0.7, theta=math.radians(75)):
        return self.write("scene.toml", f'[spacetime]\nmetric = "kerr"\nspin = {spin!r}\n[camera]\nr = 15\ntheta = {math.degrees(theta)!r}\nfov = 50\n'
                                        'observer = "static"\n[sky]\nkind = "checker"\n')

    def test_they_are_differences_of_the_reference(self):
        plain = ("--renderer", "reference", "--samples", "1", *SIZE, "--raydata")
        found = self.channels(self.scene(), *SIZE, "--raydata", "--derivatives", ",".join(STEPS))
        fates = self.channels(self.scene(), *plain)["fate"]
        for key, step in STEPS.items():
            of = (lambda by: {"spin": 0.7 + by}) if key.endswith("spin") else (lambda by: {"theta": math.radians(75) + by})
            less, more = (self.channels(self.scene(**of(by)), *plain) for by in (-step, step))
            for name, of_ray in OF_RAY.items():
                judged = sky = 0
                for y in range(18):
                    for x in range(1, 31):
                        mine = [found[f"d_{key}.{name}"][y][i] for i in (x - 1, x, x + 1)]
                        if any(fates[y][i] != 0 or less["fate"][y][i] != 0 or more["fate"][y][i] != 0 for i in (x - 1, x, x + 1)):
                            continue
                        sky += 1
                        size = max(1.0, abs(mine[1]))
                        if max(mine) - min(mine) > 0.25 * size:
                            continue
                        judged += 1
                        known = (more[of_ray][y][x] - less[of_ray][y][x]) / (2 * step)
                        scale = max(1.0, abs(more[of_ray][y][x]))   # floats of delays of tens
                        self.assertAlmostEqual(mine[1], known, delta=OF_FLOATS * scale + RELATIVE * size, msg=f"{key} {name} at {x}, {y}")
                self.assertGreater(sky, 250)
                self.assertGreater(judged, LEAST_JUDGED * sky, f"{key} {name}")

    def test_a_roll_moves_all_about_the_middle(self):
        found = self.channels(self.scene(), *SIZE, "--raydata", "--derivatives", "camera.roll")
        turned = 0
        for y in range(18):
            for x in range(32):
                right, down = (found[f"d_camera.roll.{name}"][y][x] for name in ("right", "down"))
                if found["fate"][y][x] != 0:
                    self.assertEqual([found[f"d_camera.roll.{name}"][y][x] for name in NAMES], [0] * 7)
                    continue
                across, below = x + 0.5 - 16, y + 0.5 - 9
                self.assertAlmostEqual(abs(right), abs(below), delta=2e-5)
                self.assertAlmostEqual(abs(down), abs(across), delta=2e-5)
                self.assertLessEqual(right * below * down * across, 0)   # about the middle, one way
                turned += 1
        self.assertGreater(turned, 400)

    def test_a_file_is_drawn_again_from_itself_and_in_other_formats_without(self):
        self.run_nullscope("capture", "kerr", *SIZE, "--raydata", "--derivatives", "spin", "-o", "a.exr")
        self.run_nullscope("capture", "a.exr", "-o", "b.exr")
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())
        ran = self.run_nullscope("capture", "a.exr", "-o", "b.png")
        self.assertRegex(ran.err, "recorded options are left out, only an .exr has them: --raydata, --derivatives")

    def test_what_cannot_be_is_refused(self):
        rays = ("kerr", *SIZE, "--raydata", "-o", "a.exr", "--derivatives")
        self.refused("capture", *rays, "spn", says=["--derivatives", "spn", "spacetime.spin"])
        self.refused("capture", *rays, "spin,spin", says=["--derivatives", "twice"])
        self.refused("capture", "kerr", "-o", "a.exr", "--derivatives", "spin", says=["--derivatives", "--raydata"])
        self.refused("capture", "kerr", "-o", "a.exr", "--raydata", "--layers", "--derivatives", "spin", says=["--derivatives", "--layers"])
        self.refused("capture", "wormhole", *SIZE, "-o", "a.exr", "--raydata", "--derivatives", "camera.r", says=["ellis", "kerr"])


if __name__ == "__main__":
    unittest.main()
