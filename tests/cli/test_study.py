#!/usr/bin/env python3
"""Studies draw one picture for each combination of values, with the bits of single runs; and --set, which commands of a scene have."""
import csv
import json
import resource
import subprocess

import support
from image_bytes import png_chunks

SCENE = """[spacetime]
metric = "kerr"
spin = 0.4
[camera]
r = 20
theta = 70
fov = 60
[disc]
emission = "thermal"
outer = 8
[sky]
kind = "grid"
"""
SIZE = ("--size", "32x18")
SWEEP = ("--set", "camera.theta=10:80:3", "--set", "spacetime.spin=0,0.5")
CASES = [(theta, spin) for theta in ("10", "45", "80") for spin in ("0", "0.5")]


def spent():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Studies(support.CliTest):
    def setUp(self):
        super().setUp()
        self.write("scene.toml", SCENE)

    def index(self, folder="study"):
        with open(self.folder / folder / "index.csv", newline="") as file:
            return list(csv.reader(file))

    def single(self, name, *sets, size=SIZE):
        self.run_nullscope("capture", "scene.toml", *size, *(word for one in sets for word in ("--set", one)), "-o", name)
        return (self.folder / name).read_bytes()

    def pictures(self, folder="study"):
        return {path.name: path.read_bytes() for path in sorted((self.folder / folder).glob("0*.png"))}

    def test_every_combination_has_the_bits_of_a_single_run(self):
        said = self.run_nullscope("study", "scene.toml", *SWEEP, "--", *SIZE).out
        self.assertIn("study/00003.png: 32x18, camera.theta=45 spacetime.spin=0.5", said)
        self.assertEqual(self.index(), [["case", "file", "camera.theta", "spacetime.spin"]] +
                         [[str(i), f"{i:05d}.png", *case] for i, case in enumerate(CASES)])
        drawn = self.pictures()
        self.assertEqual(len(drawn), len(CASES))
        for (theta, spin), picture in zip(CASES, drawn.values()):
            self.assertEqual(picture, self.single("one.png", f"camera.theta={theta}", f"spacetime.spin={spin}"))
        self.assertEqual(len(set(drawn.values())), len(CASES), "two cases are alike")
        width, height = (int.from_bytes(dict(png_chunks((self.folder / "study" / "contact.png").read_bytes()))[b"IHDR"][i:i + 4], "big")
                         for i in (0, 4))
        self.assertEqual(width, 8 + 2 * (32 + 8))       # a column for each value of the last sweep
        self.assertGreaterEqual(height, 8 + 3 * (18 + 8))

    def test_what_is_there_stays_and_other_studies_are_refused(self):
        self.run_nullscope("study", "scene.toml", *SWEEP, "--", *SIZE)
        before = self.pictures()
        (self.folder / "study" / "00002.png").unlink()
        kept = (self.folder / "study" / "00001.png").stat().st_mtime_ns
        said = self.run_nullscope("study", "scene.toml", *SWEEP, "--", *SIZE).out
        self.assertEqual(said.splitlines()[0].split(":")[0], "study/00002.png")
        self.assertEqual(len(said.splitlines()), 2)
        self.assertEqual(self.pictures(), before)
        self.assertEqual((self.folder / "study" / "00001.png").stat().st_mtime_ns, kept)
        for other in (SWEEP[:3] + ("spacetime.spin=0,0.6",), SWEEP[:2], SWEEP + ("--set", "camera.r=21")):
            self.refused("study", "scene.toml", *other, "--", *SIZE, says=["do not match"])
        self.refused("study", "scene.toml", *SWEEP, "--", "--size", "64x36", says=["do not match", "camera.size"])
        self.assertEqual(self.pictures(), before)

    def test_a_table_and_values_with_commas(self):
        self.write("cases.csv", 'camera.theta,sky.kind\n20,grid\n30,"checker"\n')
        self.run_nullscope("study", "scene.toml", "--table", "cases.csv", "--set", "camera.velocity=[0, 0, 0],[0.1, 0, 0]", "-o", "t/%d.png",
                           "--", *SIZE)
        rows = self.index("t")
        self.assertEqual(rows[0], ["case", "file", "camera.theta", "sky.kind", "camera.velocity"])
        self.assertEqual(rows[2], ["1", "1.png", "20", "grid", "[0.1, 0, 0]"])
        self.assertEqual(rows[3], ["2", "2.png", "30", "checker", "[0, 0, 0]"])
        self.assertEqual((self.folder / "t" / "3.png").read_bytes(),
                         self.single("one.png", "camera.theta=30", "sky.kind=checker", "camera.velocity=[0.1, 0, 0]"))

    def test_linear_light_has_an_index_and_no_sheet(self):
        self.run_nullscope("study", "scene.toml", *SWEEP, "-o", "e/%02d.exr", "--", *SIZE, "--half")
        self.assertFalse((self.folder / "e" / "contact.png").exists())
        self.assertEqual(len(list((self.folder / "e").glob("*.exr"))), 6)

    def test_lines_for_a_farm_draw_it_together(self):
        whole = self.run_nullscope("study", "scene.toml", *SWEEP, "--", *SIZE) and self.pictures()
        lines = self.run_nullscope("study", "scene.toml", *SWEEP, "-o", "farm/%05d.png", "--commands", "--chunk", 4, "--", *SIZE).out.splitlines()
        self.assertEqual(len(lines), 2)
        for line in reversed(lines):
            subprocess.run(["sh", "-c", line.replace("nullscope", str(support.BINARY), 1)], cwd=self.folder, check=True, capture_output=True)
        self.assertEqual(self.pictures("farm"), whole)
        self.assertTrue((self.folder / "farm" / "contact.png").exists())

    def test_a_killed_study_goes_on(self):
        sweep, size = ("--set", "camera.theta=10:80:12", "--set", "spacetime.spin=0.1:0.9:5"), ("--size", "96x54")
        begun = self.started("study", "scene.toml", *sweep, "--", *size)
        self.wait("three pictures", lambda: len(list((self.folder / "study").glob("0*.png"))) >= 3, begun)
        begun.kill()
        begun.wait()
        before = self.pictures()
        self.run_nullscope("study", "scene.toml", *sweep, "--", *size)
        after = self.pictures()
        self.assertEqual({name: after[name] for name in before}, before)
        self.run_nullscope("study", "scene.toml", *sweep, "-o", "whole/%05d.png", "--", *size)
        self.assertEqual(after, self.pictures("whole"))

    @support.costly
    def test_sixty_cases_cost_what_sixty_single_runs_do_less_their_starts(self):
        sweep, size = ("--set", "camera.theta=10:80:12", "--set", "spacetime.spin=0.1:0.9:5"), ("--size", "320x180")
        together, alone, starts = [], 0.0, 0.0
        def draw_together(folder):
            begun = spent()
            self.run_nullscope("study", "scene.toml", *sweep, "-o", folder + "/%05d.png", "--", *size)
            together.append(spent() - begun)
        draw_together("study")
        for i, (_, name, theta, spin) in enumerate(self.index()[1:]):
            if i in (20, 40): draw_together(f"again{i}")   # whoever else runs only adds, and not always as much
            wholes, begins = [], []
            for _ in range(2):   # the lesser counts, for the same reason
                begun = spent()
                picture = self.single("one.png", f"camera.theta={theta}", f"spacetime.spin={spin}", size=size)
                wholes.append(spent() - begun)
                begun = spent()
                self.single("start.png", f"camera.theta={theta}", f"spacetime.spin={spin}", size=("--size", "2x2"))
                begins.append(spent() - begun)
            alone, starts = alone + min(wholes), starts + min(begins)
            self.assertEqual(picture, (self.folder / "study" / name).read_bytes(), name)
        together = min(together)
        print(f"60 cases {together:.2f} core-s, single runs {alone:.2f} of which starts {starts:.2f}")
        self.assertLessEqual(together, 1.1 * (alone - starts) + starts / 60)

    def test_refused(self):
        for words, says in [
                (("--set", "camera.theta=10:800:3"), ["--set camera.theta=405", "[0, 180]"]),
                (("--set", "camera.theta=1:2:1"), ["FROM:TO:COUNT"]),
                (("--set", "camera.theta=1,,2"), ["a value is missing"]),
                (("--set", "camera.theta=1,2", "--set", "camera.theta=3"), ["set twice"]),
                (("--set", "camera.theta=1:2:1000", "--set", "camera.r=10:20:1000"), ["at most 100000"]),
                (("--set", "camera.thetta=1,2"), ["unknown key", "camera.theta"]),
                ((), ["--set KEY=A,B,C"]),
                (("--set", "camera.theta=1,2", "-o", "x.png"), ["placeholder"]),
                (("--set", "camera.theta=1,2", "-o", "x%d.mp4"), ["one picture for each case"]),
                (("--set", "camera.theta=1,2", "--cases", "1:3"), ["0 <= A < B <= 2"]),
                (("--set", "camera.theta=1,2", "--", "--frames", "0:2"), ["one picture for each case"]),
                (("--table", "none.csv"), ["none.csv"])]:
            self.refused("study", "scene.toml", *words, says=says)
        for text, says in [("camera.theta,camera.r\n1\n", ["t.csv:2", "1 fields"]), ("camera.theta\n", ["no values"]),
                           ("camera.theta\n\"1\n", ["t.csv:2", "quote"]), ("camera.theta,\n1,2\n", ["t.csv:1", "empty field"])]:
            self.write("t.csv", text)
            self.refused("study", "scene.toml", "--table", "t.csv", says=says)
        self.assertFalse((self.folder / "study").exists(), "a folder of a study that was refused")

    def test_set_of_every_command(self):
        self.assertEqual(json.loads(self.run_nullscope("landmarks", "scene.toml", "--json", "--set", "spacetime.spin=0").out)["metric"], "kerr")
        effects = lambda *words: {row["effect"] for row in json.loads(self.run_nullscope("plan", "scene.toml", "--json", *words).out)["effects"]}
        self.assertEqual(effects() - effects("--set", "disc.emission=image"), {"thermal-disc", "shift", "beaming"})
        for command in ("capture", "plan", "landmarks", "lightcurve", "profile", "flux", "visibility"):
            self.refused(command, "scene.toml", "--set", "camera.theta=181", says=["--set camera.theta=181", "[0, 180]"])

    def test_set_reads_as_a_file_does(self):
        self.assertEqual(self.single("a.png"), self.single("b.png", "camera.theta=70.0", "disc.emission=thermal"))
        self.assertEqual(self.single("a.png", 'disc.emission="thermal"', "name=Hole"), self.single("b.png", "name=Hole"))
        again = self.run_nullscope("capture", "b.png", "--set", "camera.theta=20", "-o", "c.png") and (self.folder / "c.png").read_bytes()
        self.assertEqual(again, self.single("d.png", "name=Hole", "camera.theta=20"))
        self.write("balls.toml", SCENE + "[[ball]]\nposition = [9, 0, 0]\n[[ball]]\nposition = [0, 9, 0]\n")
        for words, says in [("ball.radius=1", ["ball[1] to ball[2]"]), ("ball[3].radius=1", ["ball[1] to ball[2]"]),
                            ("ball[2].radius=-1", ["--set ball[2].radius=-1"]), ("ball[1].radius=-1", ["--set ball[1].radius=-1"]),
                            ("ball[x].radius=1", ["no key"]), ("sky.kind.x=1", ["kind is no section"]), ("camera.theta", ["KEY=VALUE"]),
                            ("=", ["KEY=VALUE", "KEY= "]), ("camera.theta=1\n[disc]", ["must be a number"]),
                            ("a.b.c.d.e=1", ["no key"])]:
            self.refused("capture", "balls.toml", "--set", words, says=says)

    def test_errors_name_the_words_that_caused_them(self):
        """Whichever key of the file they make wrong, when it is read or later; a file that is wrong by itself is told of itself."""
        given = ["--set", "camera.r=21"]
        self.write("scene.toml", SCENE.replace("outer = 8", "inner = 3\nouter = 8"))
        for words, says in [("disc.outer=2", ["--set disc.outer=2: disc.inner: inner = ", "inner < outer"]),
                            ("spacetime.metric=schwarzschild", ["--set spacetime.metric=schwarzschild: spacetime.spin: ", "--set spacetime.spin= leaves it out"]),
                            ("sky.kind=image", ["--set sky.kind=image: sky.image: missing"]),
                            ("disk.outer=9", ["--set disk.outer=9: disk: unknown key"]),
                            ("disc.emission=image", ["--set disc.emission=image: image: no derivatives"])]:
            ran = self.refused("flux", "scene.toml", "--derivatives", "spacetime.spin", *given, "--set", words, says=says)
            self.assertNotRegex(ran, r"scene\.toml|disk= leaves")
        self.write("broken.toml", SCENE.replace("theta = 70", "theta = 700"))
        self.refused("plan", "broken.toml", *given, says=["broken.toml:", "camera.theta"])
        self.write("light.toml", SCENE.replace('emission = "thermal"', 'emission = "image"'))
        self.refused("flux", "light.toml", "--derivatives", "spacetime.spin", *given, says=["light.toml:", "disc.emission"])

    def test_what_has_no_value_is_left_out(self):
        plan = lambda *words: json.loads(self.run_nullscope("plan", "balls.toml", "--json", *(word for one in words for word in ("--set", one))).out)
        reasons = lambda *words: {row["effect"]: row["reason"] for row in plan(*words)["effects"]}
        self.write("balls.toml", SCENE + "[[ball]]\nposition = [9, 0, 0]\nradius = 2\n[[ball]]\nposition = [0, 9, 0]\n")
        self.assertEqual(plan("spacetime.metric=schwarzschild", "spacetime.spin=")["metric"], "schwarzschild")
        self.assertNotIn("disc", reasons("disc="))
        self.assertIn("and 1 more", reasons()["ball"])
        self.assertIn("[9, 0, 0]", reasons("ball[2]=")["ball"])
        self.assertIn("[0, 9, 0]", reasons("ball[1]=")["ball"])
        self.assertNotIn("ball", reasons("ball="))
        for words, says in [("disc.opactiy=", ["--set disc.opactiy=: the scene has no such key", "outer"]), ("ball[3]=", ["--set ball[3]=", "ball"]),
                            ("spot.r=", ["--set spot.r="]), ("disc[1]=", ["--set disc[1]="])]:
            self.refused("plan", "balls.toml", "--set", words, says=says)


if __name__ == "__main__":
    support.main()
