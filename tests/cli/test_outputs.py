#!/usr/bin/env python3
"""What is written beside a picture is of that picture and does not change it: every pair of the options that say what is written (at depth
all every three) either gives one whole file or is refused in one line."""
import itertools

import support

# Something of every layer, in a space where shaders are soon compiled.
SCENE = """[spacetime]
metric = "minkowski"
[camera]
r = 15
theta = 70
fov = 80
size = [32, 18]
[sky]
kind = "plain"
[light]
delay = "off"
[disc]
texture = "plain"
inner = 2
outer = 4
[ball]
position = [7, 0, 0]
radius = 1.5
motion = "path"
x = "7 * cos(t / 9)"
y = "7 * sin(t / 9)"
z = "0"
[medium]
kind = "formula"
emission = "black-body"
density = "exp(-((x + 5)^2 + y^2 + z^2))"
outer = 8
"""
OPTIONS = (("--raydata",), ("--layers",), ("--st-map", "sky"), ("--st-map", "plate"), ("--half",), ("--colour", "display"), ("--plain",), ("--samples", "2"),
           ("--renderer", "reference"))
RAY_DATA = {"fate", "sky.x", "sky.y", "sky.z", "ray.shift", "delay", "angle", "order", "hit", *support.PLACE}
LAYERS = ("disc0", "disc1", "disc2", "bodies", "medium", "sky")


class Outputs(support.CliTest):
    def colours(self, options, number):
        """Of the picture that these options are beside of."""
        key = tuple(o for o in options if o[0] in ("--samples", "--renderer"))
        if key not in self.plain:
            self.plain[key] = self.capture(key, f"plain{number}.exr")
        return self.plain[key]

    def capture(self, options, name):
        self.run_nullscope("capture", "scene.toml", *(word for option in options for word in option), "-o", name)
        data = (self.folder / name).read_bytes()
        names = [n for n, _ in support.exr_header(data)[0]]
        self.assertEqual(len(names), len(set(names)), names)
        return support.read_exr(data)

    def check_exr(self, options, number):
        given = {option[0] for option in options}
        plain = self.colours(options, number) if "--colour" not in given else None
        got = self.capture(options, f"{number}.exr")
        wanted = set("RGB")
        if given & {"--raydata", "--layers"}:
            wanted |= {support.BESIDE_LAYERS.get(name, name) for name in RAY_DATA} if "--layers" in given else RAY_DATA
        for channel in "RGB" if "--st-map" not in given and plain else "":
            self.assertEqual(got[channel], plain[channel], f"{options} change {channel}")
        self.assertTrue(set(got) >= wanted, f"{options}: {sorted(got)}")
        if not given & {"--raydata", "--layers"}:
            self.assertEqual(set(got), wanted, options)
        if "--layers" in given:
            self.check_layers(got)

    def check_layers(self, got):
        for channel in "RGB":
            for y, row in enumerate(got[channel]):
                for x, value in enumerate(row):
                    self.assertAlmostEqual(value, sum(got[f"{layer}.{channel}"][y][x] for layer in LAYERS), delta=1e-5 * max(1, value))

    @support.costly
    def test_every_pair(self):
        self.plain = {}
        self.write("scene.toml", SCENE)
        drawn = refused = 0
        for count in (1, 2) if support.QUICK else (1, 2, 3):
            for options in itertools.combinations(OPTIONS, count):
                given = [option[0] for option in options]
                number = drawn + refused
                words = [word for option in options for word in option]
                together = set(given)
                impossible = (
                    len(given) != len(together)
                    or ("--st-map" in together and together & {"--raydata", "--layers", "--samples"})
                    or ("--half" in together and together & {"--raydata", "--layers", "--st-map", "--renderer"})
                    or ("--colour" in together and together & {"--raydata", "--layers", "--st-map"})
                    or {"--layers", "--renderer"} <= together)
                if impossible:
                    self.refused("capture", "scene.toml", *words, "-o", f"{number}.exr", says=["--"])
                    refused += 1
                elif "--half" not in together:
                    self.check_exr(options, number)
                    drawn += 1
                for kind in ("png", "jpg", "fits") if together & {"--raydata", "--layers", "--st-map", "--half", "--colour"} else ():
                    self.refused("capture", "scene.toml", *words, "-o", f"{number}.{kind}", says=["--"])
        self.assertGreater(drawn, 10)
        self.assertGreater(refused, 10)


if __name__ == "__main__":
    support.main()
