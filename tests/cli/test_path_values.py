#!/usr/bin/env python3
"""Numbers of a scene that change along its path, and paths that close."""
import csv
import io
import sys
from pathlib import Path

import support

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "viewer"))
from x_screen import read_png  # noqa: E402
from test_pictures import png_texts  # noqa: E402

SPIN = """[spacetime]
metric = "kerr"
spin = 0.3
[camera]
r = 20
theta = 70
[disc]
inner = 4
[path]
kind = "keys"
[[path.key]]
set = { "spacetime.spin" = -0.8, "disc.outer" = 8 }
[[path.key]]
frame = 8
set = { spacetime.spin = 0.8 }
[[path.key]]
frame = 16
"""
CHARGE = """[spacetime]
metric = "reissner-nordstrom"
[camera]
r = 15
[disc]
inner = 3
outer = 8
[path]
kind = "keys"
[[path.key]]
set = { "spacetime.charge" = 0.1 }
[[path.key]]
frame = 4
set = { "spacetime.charge" = 0.9 }
"""
ROUND = """[camera]
theta = 80
[disc]
inner = 3
outer = 8
[picture]
shutter = 1
sub_frames = 4
[path]
kind = "keys"
closed = "{}"
"""
KEYS = ((0, 12), (90, 14), (180, 11), (270, 9))


def round_scene(closed="on", first=0):
    """A way round the hole, whose keys begin at another."""
    text = ROUND.format(closed)
    for i in range(4):
        turns, place = divmod(i + first, 4)
        phi, r = KEYS[place]
        text += f"[[path.key]]\nframe = {30 * i}\nphi = {phi + 360 * (turns - (first > 0))}\nr = {r}\n"
    return text


class PathValues(support.CliTest):
    def capture(self, scene, *options):
        return self.run_nullscope("capture", scene, "--size", support.SMALL, *options)

    def pixels(self, name):
        return read_png(self.folder / name).data

    @support.costly
    def test_frames_are_the_scenes_with_these_values(self):
        """Two keys: evenly between. The picture is that of --set, and is drawn again from its own metadata."""
        for text, key, cases in ((SPIN, "spacetime.spin", ((2, -0.4), (4, 0.0), (6, 0.4))), (CHARGE, "spacetime.charge", ((1, 0.3), (2, 0.5)))):
            text = text.replace("[[path.key]]\nframe = 16\n", "")
            scene = self.write("scene.toml", text)
            still = self.write("still.toml", text[:text.index("[path]")])
            for frame, value in cases:
                self.capture(scene, "--frames", f"{frame}:{frame + 1}", "-o", "f%d.png")
                self.capture(still, "--set", f"{key}={value!r}", *(("--set", "disc.outer=8") if "outer\" = 8" in text else ()), "-o", "s.png")
                drawn = self.pixels(f"f{frame}.png")
                self.assertEqual(drawn, self.pixels("s.png"), (key, frame))
                self.run_nullscope("capture", f"f{frame}.png", "-o", "again.png")
                self.assertEqual(drawn, self.pixels("again.png"))
                self.assertIn(f"{key.split('.')[1]} = ", png_texts((self.folder / f"f{frame}.png").read_bytes())["nullscope.scene_text"])

    def test_a_value_stays_between_its_keys(self):
        """From -0.8 to 0.8, which the third key keeps: a cubic by parabolas would go to 0.9."""
        scene = self.write("scene.toml", SPIN)
        self.run_nullscope("capture", scene, "--size", "8x8", "--frames", "0:17", "-o", "f%d.png")
        spins = []
        for frame in range(17):
            text = png_texts((self.folder / f"f{frame}.png").read_bytes())["nullscope.scene_text"]
            spins.append(float(next(line for line in text.splitlines() if line.startswith("spin")).split("=")[1]))
        self.assertEqual((spins[0], *spins[8:]), (-0.8, *[0.8] * 9))
        self.assertEqual(spins, sorted(spins))

    def test_blur_has_values_between(self):
        scene = self.write("scene.toml", SPIN.replace("[path]", "[picture]\nshutter = 1\nsub_frames = 4\n[path]"))
        self.assertIn("4 sub-frames", self.capture(scene, "--frames", "3:4", "-o", "b%d.png").out)
        self.capture(self.write("sharp.toml", SPIN), "--frames", "3:4", "-o", "a%d.png")
        self.assertNotEqual(self.pixels("a3.png"), self.pixels("b3.png"))

    def test_resumed_frames_know_their_values(self):
        """A sequence whose values have changed is another."""
        scene = self.write("scene.toml", SPIN)
        self.capture(scene, "--frames", "0:2", "-o", "r%d.png", "--resume")
        self.write("scene.toml", SPIN.replace("spin = 0.8", "spin = 0.7"))
        self.refused("capture", scene, "--size", support.SMALL, "--frames", "0:2", "-o", "r%d.png", "--resume", says=["path.key[1].set.spacetime.spin"])

    def test_what_is_refused(self):
        line = next(i for i, text in enumerate(SPIN.splitlines(), 1) if text.startswith("set"))
        for change, says in ((("spacetime.spin\" = -0.8", "spacetime.spin\" = -1.8"), [f":{line}: path.key.set.spacetime.spin", "[-1, 1]"]),
                             (("disc.outer\" = 8", "disc.outter\" = 8"), [f":{line}: path.key.set.disc.outter", "SECTION.KEY"]),
                             (("disc.outer\" = 8", "camera.r\" = 8"), [f":{line}: path.key.set.camera.r"]),
                             (("disc.outer\" = 8", "ball.radius\" = 8"), [f":{line}: path.key.set.ball.radius", "the scene has 0"]),
                             (("disc.outer\" = 8", "disc.outer\" = \"wide\""), [f":{line}: path.key.set.disc.outer"])):
            self.assertIn(change[0], SPIN)
            self.refused("capture", self.write("scene.toml", SPIN.replace(*change)), "-o", "x.png", says=says)
        between = SPIN[:SPIN.index("[[path.key]]")] + (
            '[[path.key]]\nset = { "disc.inner" = 3, "disc.outer" = 4 }\n[[path.key]]\nframe = 10\nset = { "disc.outer" = 4.5 }\n'
            '[[path.key]]\nframe = 11\nset = { "disc.outer" = 12, "disc.inner" = 9 }\n')
        self.run_nullscope("capture", self.write("good.toml", between.replace("frame = 11", "frame = 10.5").replace("4.5", "9.5")), "--size", "8x8", "--frames", "0:1", "-o", "g%d.png")
        self.refused("capture", self.write("scene.toml", between.replace('"disc.outer" = 4.5', '"disc.outer" = 4.5, "disc.inner" = 4.45').replace(
            "frame = 11", "frame = 20")), "-o", "x.png", says=["in frame 11 of the path", "disc.outer"])

    def rows(self, text):
        self.run_nullscope("path", self.write("scene.toml", text), "-o", "path.csv")
        return list(csv.DictReader(line for line in io.StringIO((self.folder / "path.csv").read_text()) if not line.startswith("#")))

    def test_closed_paths_join(self):
        """Evenly round, and with one slope at the seam; open, the same keys end with a turn of less than a circle."""
        rows = self.rows(round_scene())
        self.assertEqual(len(rows), 120)
        phi, r = ([float(row[name]) for row in rows] for name in ("phi", "r"))
        for k, value in enumerate(phi):
            self.assertAlmostEqual(value, 3.0 * k, delta=1e-9)
        after, before = r[1] - r[0], r[0] - r[-1]
        self.assertLess(abs(after - before), 0.02)   # of a slope of 0.083 a frame
        self.assertGreater(after, 0.05)
        self.assertEqual(len(self.rows(round_scene("off"))), 91)

    def test_blur_joins(self):
        """The first frame is what it is in the middle of the same way begun a key earlier."""
        self.capture(self.write("a.toml", round_scene()), "--frames", "0:1", "-o", "a%d.png")
        self.capture(self.write("b.toml", round_scene(first=3)), "--frames", "30:31", "-o", "b%d.png")
        a, b = self.pixels("a0.png"), self.pixels("b30.png")
        self.assertEqual(len(a), len(b))
        self.assertLessEqual(max(abs(x - y) for x, y in zip(a, b)), 1)

    def test_closed_is_checked(self):
        self.refused("capture", self.write("x.toml", round_scene().replace('closed = "on"', 'closed = "on"\nframes = 90')), "-o", "x.png",
                     says=["path.frames", "comes again"])
        self.refused("capture", self.write("x.toml", round_scene().replace('closed = "on"', 'closed = "on"\neasing = "smooth"')), "-o", "x.png",
                     says=["path.easing"])


if __name__ == "__main__":
    support.main()
