#!/usr/bin/env python3
"""Sequences as people ask for them: names without --frames, folders that are not there, and what is said of a path before it is drawn."""
import support

PATH = """[camera]
r = 20
size = [32, 18]
[sky]
kind = "grid"
[path]
kind = "keys"
frames = 4
[[path.key]]
[[path.key]]
frame = 3
%s
"""


class Sequences(support.CliTest):
    def test_a_name_with_a_number_asks_for_all_frames(self):
        self.write("path.toml", PATH % "yaw = 3")
        self.run_nullscope("capture", "path.toml", "-o", "f%d.png")
        self.assertEqual(sorted(p.name for p in self.folder.glob("f*.png")), [f"f{i}.png" for i in range(4)])
        self.refused("capture", "flat", "--size", support.SMALL, "-o", "g%02d.png", says=["g%02d.png", "--frames A:B"])
        self.run_nullscope("capture", "flat", "--size", support.SMALL, "-o", "no#1.png")
        self.assertTrue((self.folder / "no#1.png").exists())

    def test_all_there_is_said(self):
        self.write("path.toml", PATH % "yaw = 3")
        self.run_nullscope("capture", "path.toml", "--frames", "0:2", "--resume", "-o", "f%d.png")
        self.assertIn("all 2 frames were there", self.run_nullscope("capture", "path.toml", "--frames", "0:2", "--resume", "-o", "f%d.png").err)

    def test_a_missing_folder_is_seen_first(self):
        self.write("path.toml", PATH % "yaw = 3")
        for name in ("a.png", "a%d.png", "a.mp4", "a.exr"):
            self.refused("capture", "path.toml", "-o", f"nowhere/{name}", status=1, says=[f"nowhere/{name}", "there is no folder 'nowhere'"])
        self.assertFalse((self.folder / "nowhere").exists())

    def test_a_cube_has_square_faces(self):
        self.write("cube.toml", '[camera]\nprojection = "cube"\nsize = [96, 64]\n')
        self.refused("capture", "cube.toml", "--size", "64x64", "-o", "a.png", says=["--size 64x64", "square faces", "192x128"])

    def test_the_worst_frame_is_named_once(self):
        self.write("path.toml", PATH % "yaw = 40" + '[picture]\nshutter = 1\nsub_frames = 2\n')
        self.write("eased.toml", (PATH % "yaw = 40").replace('frames = 4', 'frames = 4\neasing = "smooth"') + '[picture]\nshutter = 1\nsub_frames = 2\n')
        for name in ("path.toml", "eased.toml"):
            said = self.run_nullscope("capture", name, "-o", "f%d.png", "--workers", 2).err
            self.assertEqual(said.count("picture.sub_frames"), 1, said)
            most = said.split("leave dots; ")[1].split()[0]
            self.write("more.toml", (self.folder / name).read_text().replace("sub_frames = 2", f"sub_frames = {most}"))
            self.assertNotIn("picture.sub_frames", self.run_nullscope("capture", "more.toml", "-o", "g%d.png").err)

    def test_time_that_runs_backwards_is_said(self):
        keys = "[[path.key]]\nframe = 10\n[[path.key]]\nframe = 20\ntime = 20\n"
        self.write("back.toml", (PATH % "yaw = 3").replace("frames = 4", "frames = 21") + keys)
        self.assertIn("time runs backwards", self.run_nullscope("capture", "back.toml", "--frames", "0:21", "-o", "b%d.png").err)
        self.write("on.toml", (PATH % "yaw = 3\ntime = 3").replace("frames = 4", "frames = 21") + keys.replace("frame = 10", "frame = 10\ntime = 10"))
        self.assertNotIn("backwards", self.run_nullscope("capture", "on.toml", "--frames", "0:21", "-o", "o%d.png").err)

    def test_a_built_in_scene_is_printed(self):
        for name in ("first-light",) if support.QUICK else ("first-light", "kerr-plunge"):
            self.write("mine.toml", self.run_nullscope("scenes", name).out)
            drawn = [self.run_nullscope("capture", scene, "--size", support.SMALL, "-o", "a.png").out and (self.folder / "a.png").read_bytes()[-64:]
                     for scene in (name, "mine.toml")]
            self.assertEqual(*drawn)
        self.refused("scenes", "nothing", says=["nothing"])


if __name__ == "__main__":
    support.main()
