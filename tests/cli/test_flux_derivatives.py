#!/usr/bin/env python3
"""nullscope flux --derivatives: what is known without a difference, and what it refuses."""
import csv
import io

import support

# Sharp rims, whose motion is most of what turning the picture does.
DISC = """[camera]
r = 20.0
theta = 50.0
fov = 50.0
size = [32, 24]
[sky]
kind = "black"
[disc]
emission = "thermal"
texture = "plain"
emissivity = "power-law"
inner = 2.5
outer = 6.0
brightness = 2.0
opacity = 0.7
"""


class FluxDerivatives(support.CliTest):
    @support.costly
    def test_known_ones(self):
        """Turned about the axis and about the line of sight a picture has the light that it had; brightness is a factor."""
        keys = ("camera.phi", "camera.roll", "disc.brightness", "disc.outer", "disc.temperature")
        ran = self.run_nullscope("flux", self.write("disc.toml", DISC), "--derivatives", ",".join(keys), "--error", "0.1")
        rows = {row["key"]: {name: float(row[name]) for name in ("value", "relative", "error")} for row in csv.DictReader(io.StringIO(ran.out))}
        self.assertEqual(list(rows), ["flux", *(f"d_{key}" for key in keys)])
        self.assertGreater(rows["flux"]["value"], 0)
        self.assertLess(abs(rows["d_camera.phi"]["relative"]), 1e-9)
        self.assertLess(abs(rows["d_camera.roll"]["relative"]), 1e-3)
        self.assertAlmostEqual(rows["d_disc.brightness"]["relative"], 0.5, delta=1e-8)
        self.assertGreater(rows["d_disc.outer"]["relative"], 0.01)   # the ring that is added: the light within is what it was
        self.assertIn("within", ran.err)

    def test_refused(self):
        disc = self.write("disc.toml", DISC)
        away = self.write("away.toml", DISC.replace("fov = 50.0", "fov = 10.0\nyaw = 30.0"))
        for scene, options, says in ((disc, ("--derivatives", "spin"), ['--derivatives: no derivatives by "spin" of this scene; allowed: camera.r']),
                                     (disc, ("--derivatives", "camera.r", "--target", "1"), ["--derivatives: not with --target"]),
                                     (disc, ("--derivatives", "camera.r", "-o", "a.toml"), ["-o"]),
                                     (away, ("--derivatives", "camera.r"), ["not in the picture"]),
                                     ("first-light", ("--derivatives", "camera.r"), ["disc.emission: image: no derivatives of its light; allowed: thermal"]),
                                     ("sky-only", ("--derivatives", "camera.r"), ["[disc]"]),
                                     ("soft-disc", ("--derivatives", "camera.r"), ["medium.kind", "gas: no derivatives of its flux; allowed: flow or formula"]),
                                     ("hot-flow", ("--derivatives", "disc.outer"), ['no derivatives by "disc.outer"']),
                                     ("saturn", ("--derivatives", "camera.r"), ["no derivatives of its light"])):
            self.refused("flux", scene, *options, says=says)


if __name__ == "__main__":
    support.main()
