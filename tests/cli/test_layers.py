#!/usr/bin/env python3
"""Layers, ST maps and motion vectors, as files: their channels, and what is in them."""
import itertools
import math

import support


class Layers(support.CliTest):
    def channels(self, *words):
        self.run_nullscope("capture", *words)
        return support.read_exr((self.folder / words[words.index("-o") + 1]).read_bytes())

    def test_layers_add_up(self):
        got = self.channels("first-light", "--size", support.SMALL, "--layers", "-o", "a.exr")
        layers = ("disc0", "disc1", "disc2", "sky")
        for channel in "RGB":
            for y, row in enumerate(got[channel]):
                for x, value in enumerate(row):
                    self.assertAlmostEqual(value, sum(got[f"{layer}.{channel}"][y][x] for layer in layers), delta=1e-5 * max(1, value))
        for y, row in enumerate(got["A"]):
            for x, value in enumerate(row):
                self.assertAlmostEqual(1 - value, got["sky.A"][y][x], delta=1e-6)
        self.assertEqual(max(map(max, got["forward_known"])) if "forward_known" in got else 0, 0)
        depth, hit = got["depth.affine"], got["hit"]
        for y, row in enumerate(hit):
            for x, number in enumerate(row):
                self.assertTrue(5 < depth[y][x] < 40 if number else depth[y][x] == 0, (x, y, depth[y][x]))

    def test_other_programs_can_tell_the_channels_apart(self):
        """What OpenImageIO and Blender make of names: the last part is R, G, B or A in either case, X to Z, or a whole word; four to a layer."""
        self.write("moves.toml", '[disc]\n[camera]\nr = 20\n[path]\nkind = "keys"\n[[path.key]]\nyaw = 0\n[[path.key]]\nyaw = 1\n')
        self.run_nullscope("capture", "moves.toml", "--size", "16x9", "--layers", "--frames", "0:1", "-o", "l%d.exr")
        self.run_nullscope("capture", "moves.toml", "--size", "16x9", "--raydata", "-o", "r.exr")
        self.assertIn("0 of 144 pixels", self.run_nullscope("compare", "l0.exr", "r.exr").out)
        got = {name: support.read_exr((self.folder / name).read_bytes()) for name in ("l0.exr", "r.exr")}
        for file, channels in got.items():
            layers = {}
            for name in channels:
                layer, _, component = name.rpartition(".")
                layers.setdefault(layer, []).append(component)
            self.assertEqual({name for name in layers.pop("") if len(name) == 1}, set("RGBA") & set(channels), file)
            for layer, components in layers.items():
                self.assertLessEqual(len(components), 4, f"{file} {layer}")
                self.assertEqual(len({c.lower() for c in components}), len(components), f"{file} {layer}")
                if file == "l0.exr" and len(components) > 2:
                    self.assertIn(sorted(components), (["A", "B", "G", "R"], ["x", "y", "z"]), layer)
        self.assertEqual(len(got["l0.exr"]), 43)
        for name, rows in got["r.exr"].items():
            self.assertEqual(got["l0.exr"][support.BESIDE_LAYERS.get(name, name)], rows, name)
        for y, row in enumerate(got["l0.exr"]["fate"]):   # Map UV shows what has 1 in the third channel
            for x, fate in enumerate(row):
                self.assertLessEqual(fate == 0, got["l0.exr"]["st_sky.z"][y][x])

    def test_light_and_shares_keep_their_bounds(self):
        """A disc's cover that is 1 to rounding left -1e-7 of the stars behind it."""
        self.write("stars.toml", """[camera]
r = 11.336443604688101
theta = 61.20945557683343
phi = -6.43954511985649
projection = "cylindrical"
fov = 160.0
[sky]
kind = "points"
uniform_stars = 300
magnitude_limit = 0.0
[disc]
inner = 3.2
outer = 7.0
[picture]
refine = "off"
""")
        got = self.channels("stars.toml", "--size", "64x36", "--layers", "-o", "s.exr")
        for name, rows in got.items():
            if name[-2:] in (".R", ".G", ".B", ".A"):
                self.assertGreaterEqual(min(map(min, rows)), 0, name)
            if name.endswith(".A"):
                self.assertLessEqual(max(map(max, rows)), 1, name)

    @support.costly
    def test_matter_has_a_layer_and_a_depth(self):
        got = self.channels("soft-disc", "--size", support.SMALL, "--layers", "-o", "m.exr")
        for channel in "RGB":
            for y, row in enumerate(got[channel]):
                for x, value in enumerate(row):
                    self.assertAlmostEqual(value, got[f"medium.{channel}"][y][x] + got[f"sky.{channel}"][y][x], delta=1e-5 * max(1, value))
        self.assertGreater(max(map(max, got["medium.R"])), 1)
        shown = 0
        for y, row in enumerate(got["hit"]):
            for x, number in enumerate(row):
                self.assertIn(number, (0, 9))
                depth, matter = got["depth.affine"][y][x], got["depth.medium"][y][x]
                self.assertEqual(depth, matter if number else 0)
                self.assertTrue(matter == 0 or 26 - 11.6 < matter < 26 + 15, matter)
                shown += number == 9
        self.assertGreater(shown, 300)

    @support.costly
    def test_light_without_delay(self):
        """A ball that moves is where the picture has it, in ray data, layers and motion vectors; the same numbers as a ball at rest there."""
        text = ('[camera]\nr = 30\ntheta = 60\n[sky]\nkind = "black"\n[light]\ndelay = "off"\n'
                '[ball]\nposition = [8, 0, 0]\nradius = 1\n')
        self.write("moves.toml", text + 'motion = "orbit"\n')
        self.write("rests.toml", text)
        rests = self.channels("rests.toml", "--size", "160x90", "--raydata", "-o", "r.exr")
        picture = self.channels("moves.toml", "--size", "160x90", "-o", "p.exr")
        self.assertGreater(sum(map(lambda row: sum(v > 0 for v in row), picture["R"])), 150)
        for number, words in enumerate((("--raydata",), ("--layers",), ("--layers", "--time-step", "0.5", "--frames", "0:1"))):
            name = f"m{number}_%d.exr" if "--frames" in words else f"m{number}.exr"
            self.run_nullscope("capture", "moves.toml", "--size", "160x90", *words, "-o", name)
            got = support.as_ray_data(support.read_exr((self.folder / name.replace("%d", "0")).read_bytes()))
            for channels, same in (("RGB", picture), (("hit", "fate"), rests)):
                for channel in channels:
                    self.assertTrue(got[channel] == same[channel], f"{words}: {channel}")
            self.assertGreater(sum(map(lambda row: sum(h == 4 for h in row), got["hit"])), 100)
            for channel in support.PLACE:
                for a, b in zip(got[channel], rests[channel]):
                    for one, other in zip(a, b):
                        self.assertAlmostEqual(one, other, delta=1e-4)
        # In 0.5 r_s/c on an orbit at 8 r_s: by 0.5 sqrt(1/2/8^3) rad, to the ball's position of then.
        angle = 0.5 * (0.5 / 8 ** 3) ** 0.5
        self.write("later.toml", text.replace("[8, 0, 0]", f"[{8 * math.cos(angle)}, {8 * math.sin(angle)}, 0]"))
        later = self.channels("later.toml", "--size", "160x90", "--raydata", "-o", "l.exr")
        known = 0
        for y, row in enumerate(got["hit"]):
            for x, number in enumerate(row):
                if number != 4 or not got["forward_known"][y][x]:
                    continue
                known += 1
                to_x, to_y = x + got["forward.u"][y][x], y - got["forward.v"][y][x]
                self.assertEqual(later["hit"][round(to_y)][round(to_x)], 4)
                # About one pixel is 0.3 r_s: places there, as seen from the ball's middle, are those here.
                off = [later[c][round(to_y)][round(to_x)] - got[c][y][x] - step
                       for c, step in zip(support.PLACE, (8 * math.cos(angle) - 8, 8 * math.sin(angle), 0))]
                self.assertLess(math.hypot(*off), 0.5)
        self.assertGreater(known, 30)

    def test_motion_of_a_camera_that_turns(self):
        """By a degree a frame: a pixel in the middle moves by (width/2)/tan(fov/2) of that in rad."""
        self.write("turn.toml", '[spacetime]\nmetric = "minkowski"\n[camera]\nr = 20\ntheta = 90\nfov = 60\n[path]\nkind = "keys"\n'
                   "[[path.key]]\nyaw = 0\n[[path.key]]\nframe = 10\nyaw = 10\n")
        self.run_nullscope("capture", "turn.toml", "--size", "64x36", "--layers", "--frames", "0:1", "-o", "m%d.exr")
        got = support.read_exr((self.folder / "m0.exr").read_bytes())
        self.assertEqual(got["forward_known"][18][32], 1)
        self.assertAlmostEqual(got["forward.u"][18][32], -32 * 3 ** 0.5 * 3.14159265 / 180, delta=0.01)
        self.assertAlmostEqual(got["forward.v"][18][32], 0, delta=0.01)

    @support.costly
    def test_motion_of_what_changes_its_shape(self):
        """A pulsating sphere moves along its radii; where the places of a surface with t go is not known."""
        view = '[spacetime]\nmetric = "minkowski"\n[camera]\nr = 20\ntheta = 90\nfov = 60\n[sky]\nkind = "black"\n[light]\ndelay = "off"\n'
        self.write("pulse.toml", view + "[sphere]\nradius = 4\namplitude = 0.3\nperiod = 20\n")
        self.write("surface.toml", view + '[surface]\nshape = "length(x, y, z) - 4 - 0.1 * t"\n')
        for name in ("pulse", "surface"):
            self.run_nullscope("capture", f"{name}.toml", "--size", "128x72", "--layers", "--time-step", "0.5", "--frames", "0:1", "-o", f"{name}%d.exr")
        got = support.read_exr((self.folder / "surface0.exr").read_bytes())
        self.assertGreater(sum(h >= 4 for row in got["hit"] for h in row), 500)
        self.assertEqual(sum(known for row, hits in zip(got["forward_known"], got["hit"]) for known, h in zip(row, hits) if h >= 4), 0)
        got = support.read_exr((self.folder / "pulse0.exr").read_bytes())
        grows, scale, errors = 1 + 0.3 * math.sin(2 * math.pi * 0.5 / 20), 64 * 3 ** 0.5, []
        for y, row in enumerate(got["forward_known"]):
            for x, known in enumerate(row):
                if not known or not got["hit"][y][x]:
                    continue
                place = [got[f"place.{c}"][y][x] for c in "xyz"]
                self.assertAlmostEqual(math.hypot(*place), 4, delta=1e-4)
                across = [scale * grows * place[i] / (20 - grows * place[0]) for i in (1, 2)]     # seen from (20, 0, 0): y to the right, z up
                errors.append(max(abs(64 - 0.5 + across[0] - x - got["forward.u"][y][x]), abs(36 - 0.5 - across[1] - y + got["forward.v"][y][x])))
        self.assertGreater(len(errors), 500)
        self.assertLess(max(errors), 0.02)

    @support.costly
    def test_st_maps_go_on_behind_what_covers_the_sky(self):
        """They are those of the scene without disc and ball, which has a hole's shadow only."""
        sky = '[camera]\nr = 20\nfov = 40\ntheta = 80\n'
        things = {"disc": "[disc]\n", "ball": "[ball]\nposition = [6, 3, 1]\nradius = 1.5\n"}
        self.write("sky.toml", sky)
        bare = self.channels("sky.toml", "--size", "32x18", "--layers", "-o", "bare.exr")
        for name, section in things.items():
            self.write(f"{name}.toml", sky + section)
            got = self.channels(f"{name}.toml", "--size", "32x18", "--layers", "-o", f"{name}.exr")
            covered = sum(a > 0.999 and z == 1 for a, z in zip(itertools.chain(*got["A"]), itertools.chain(*got["st_sky.z"])))
            self.assertGreater(covered, 5, name)
            for of in ("sky", "plate"):
                alone = self.channels(f"{name}.toml", "--size", "32x18", "--st-map", of, "-o", "st.exr")
                for c, rgb in zip("xyz", "RGB"):
                    self.assertEqual(got[f"st_{of}.{c}"], alone[rgb], (name, of, c))
                    self.assertEqual(got[f"st_{of}.{c}"], bare[f"st_{of}.{c}"], (name, of, c))
            self.assertEqual(bare["st_sky.z"], [tuple(float(fate == 0) for fate in row) for row in bare["fate"]])

    def test_a_plate_without_a_hole_is_the_picture(self):
        got = self.channels("flat", "--size", "64x36", "--st-map", "plate", "-o", "st.exr")
        for y, row in enumerate(got["B"]):
            for x, sky in enumerate(row):
                self.assertAlmostEqual(got["R"][y][x], (x + 0.5) / 64 * sky, delta=1e-4)
                self.assertAlmostEqual(got["G"][y][x], (1 - (y + 0.5) / 36) * sky, delta=1e-4)
        by_reference = self.channels("kerr", "--size", "16x9", "--st-map", "sky", "--renderer", "reference", "-o", "r.exr")
        by_shader = self.channels("kerr", "--size", "16x9", "--st-map", "sky", "-o", "s.exr")
        for channel in "RGB":
            for a, b in zip(by_reference[channel], by_shader[channel]):
                for one, other in zip(a, b):
                    self.assertAlmostEqual(one, other, delta=1e-3)

    def test_bad_input(self):
        for words, says in [(("--layers", "-o", "a.png"), "--layers"), (("--st-map", "sky", "-o", "a.png"), "--st-map"),
                            (("--st-map", "floor", "-o", "a.exr"), "plate"), (("--layers", "--half", "-o", "a.exr"), "--half"),
                            (("--layers", "--renderer", "reference", "-o", "a.exr"), "--layers"),
                            (("--st-map", "sky", "--layers", "-o", "a.exr"), "--st-map")]:
            self.refused("capture", "flat", "--size", support.SMALL, *words, says=[says])


if __name__ == "__main__":
    support.main()
