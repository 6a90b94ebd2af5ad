#!/usr/bin/env python3
"""Labels and scale bars are over displayed pictures alone, and a JPEG holds what the PNG does."""
import math
import os
import re
import struct
import sys
from pathlib import Path
from xml.etree import ElementTree

import support
from image_bytes import jpeg_segments, png_chunks

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "viewer"))
from x_screen import read_png  # noqa: E402

SIZE = (320, 180)
SPLIT = '[camera]\nr = 8\n[sky]\nkind = "plain"\n[split]\nmetric = "kerr"\n'
BAR = 'name = "bar"\n[camera]\nr = 1000\nfov = 2\n[sky]\nkind = "plain"\n[object]\nmass_suns = 6.5e9\ndistance_pc = 16.8e6\n[picture]\nscale_bar = "uas"\n'


def jpeg_frame(data, kinds=(0xc0, 0xc1, 0xc2)):
    """Width, height and the sampling byte of each component."""
    for kind, body in jpeg_segments(data):
        if kind in kinds:
            height, width, count = struct.unpack(">HHB", body[1:6])
            return width, height, [body[7 + 3 * i] for i in range(count)]
    return None


def png_texts(data):
    """By keyword; of iTXt chunks that are not compressed."""
    texts = {}
    for kind, body in png_chunks(data):
        if kind == b"iTXt":
            keyword, rest = body.split(b"\0", 1)
            texts[keyword.decode()] = rest[2:].split(b"\0", 2)[2].decode()   # after two flags, language and translated keyword
    return texts


class Pictures(support.CliTest):
    def picture(self, scene, name, *options, **how):
        ran = self.run_nullscope("capture", scene, "--size", "%dx%d" % SIZE, "-o", name, *options, **how)
        return (read_png(self.folder / name) if name.endswith(".png") else (self.folder / name).read_bytes()), ran

    def differing(self, one, other):
        """Columns and rows of the pixels that differ."""
        places = [divmod(i // 3, one.width) for i, (a, b) in enumerate(zip(one.data, other.data)) if a != b]
        return {x for _, x in places}, {y for y, _ in places}

    def test_a_split_screen_has_a_line_and_labels_and_plain_has_none(self):
        scene = self.write("split.toml", SPLIT)
        marked, _ = self.picture(scene, "marked.png")
        plain, _ = self.picture(scene, "plain.png", "--plain")
        columns, rows = self.differing(marked, plain)
        self.assertEqual(rows, set(range(SIZE[1])), "no line from top to bottom")
        below = {x for x in range(SIZE[0]) if any(marked.grey(x, y) != plain.grey(x, y) for y in range(60, SIZE[1]))}
        self.assertTrue(below and max(abs(x - SIZE[0] / 2) for x in below) <= 8, f"below the labels: {sorted(below)}")
        self.assertTrue(min(columns) < 120 and max(columns) > 200, "no label on one side")
        self.assertLess(len(columns), SIZE[0])
        off, _ = self.picture(self.write("off.toml", SPLIT + 'labels = "off"\n'), "off.png")
        self.assertEqual(self.differing(off, plain)[0], below)

    def test_a_frame_says_how_it_was_made_and_is_made_again(self):
        self.run_nullscope("capture", "kerr-plunge", "--frames", "3:4", "--size", "64x36", "-o", "a%d.png")
        words = png_texts((self.folder / "a3.png").read_bytes())
        self.assertEqual((words["nullscope.frame"], words["nullscope.scene"], words["Title"]), ("3", "Kerr plunge", "Kerr plunge"))
        self.assertRegex(words["nullscope.scene_hash"], "^[0-9a-f]{16}$")
        again = self.write("again.toml", words["nullscope.scene_text"])
        self.run_nullscope("capture", again, "-o", "b.png")
        one, other = read_png(self.folder / "a3.png"), read_png(self.folder / "b.png")
        self.assertEqual((other.width, other.height), (64, 36))
        self.assertLessEqual(max(abs(a - b) for a, b in zip(one.data, other.data)), 1)

    def test_the_labels_of_a_file_are_not_those_of_another_right_half(self):
        named = self.write("named.toml", SPLIT + 'left_label = "One"\nright_label = "Other"\n')
        unnamed, other = self.write("unnamed.toml", SPLIT), self.write("other.toml", '[spacetime]\nmetric = "minkowski"\n')
        by_file, by_default = self.picture(named, "a.png")[0], self.picture(unnamed, "b.png")[0]
        self.assertNotEqual(by_file.data, by_default.data)
        split = [self.picture(scene, "c.png", "--split", other)[0].data for scene in (named, unnamed)]
        self.assertEqual(*split)

    def test_linear_light_has_no_marks(self):
        for text in (SPLIT, BAR):
            scene = self.write("scene.toml", text)
            self.assertEqual(self.picture(scene, "a.exr")[0], self.picture(scene, "b.exr", "--plain")[0])
        bare = self.write("bare.toml", BAR.replace('"uas"', '"off"'))
        for s, name in ((scene, "c.exr"), (bare, "d.exr")):   # whose attributes hold the scenes' texts
            self.picture(s, name)
        self.assertRegex(self.run_nullscope("compare", "c.exr", "d.exr").out, r"difference +max 0 ")

    def test_a_scale_bar_is_as_long_as_its_number(self):
        """50 µas are 13.09 GM/c^2: 60 px of 2 degrees over 320 px, from 2000 GM/c^2 away."""
        scene = self.write("bar.toml", BAR)
        marked, _ = self.picture(scene, "marked.png")
        plain, _ = self.picture(scene, "plain.png", "--plain")
        _, rows = self.differing(marked, plain)
        self.assertGreater(min(rows), SIZE[1] * 3 // 4)
        white = [sum(marked.grey(x, y) > 600 for x in range(SIZE[0])) for y in range(SIZE[1])]
        self.assertLessEqual(abs(max(white) - 60), 1, "length of the bar, px")

    def test_without_a_font_one_line_says_so(self):
        scene = self.write("split.toml", SPLIT)
        no_font = {"NULLSCOPE_FONT": "/nowhere.ttf"}
        bare, ran = self.picture(scene, "bare.png", environment=no_font)
        self.assertIn("pictures have no labels", ran.err)
        self.assertEqual(ran.err.count("\n"), 1, ran)
        self.assertGreater(len(self.differing(self.picture(scene, "marked.png")[0], bare)[0]), 60)
        self.assertEqual(self.picture(scene, "plain.png", "--plain", environment=no_font)[1].said(), "")
        self.assertEqual(self.picture(scene, "linear.exr", environment=no_font)[1].said(), "")

    def test_frames_of_another_kind_of_marks_do_not_mix(self):
        scene = self.write("split.toml", SPLIT)
        self.run_nullscope("capture", scene, "--size", "64x64", "-o", "f%d.jpg", "--frames", "0:2")
        self.assertEqual((self.folder / "f1.jpg").read_bytes()[:2], b"\xff\xd8")
        self.refused("capture", scene, "--size", "64x64", "-o", "f%d.jpg", "--frames", "0:2", "--resume", "--plain", says=["--plain"])

    @support.costly
    def test_a_jpeg_is_the_png_in_a_small_file(self):
        for name in ("a.jpg", "a.jpeg", "a.png"):
            self.run_nullscope("capture", "first-light", "--size", "%dx%d" % SIZE, "-o", name)
        data = (self.folder / "a.jpg").read_bytes()
        self.assertEqual(data, (self.folder / "a.jpeg").read_bytes())
        self.assertEqual(jpeg_frame(data), (*SIZE, [0x11, 0x11, 0x11]))
        self.assertIn(b"First light\nnullscope ", data)
        self.assertLess(3 * len(data), 2 * len((self.folder / "a.png").read_bytes()))
        out = self.run_nullscope("compare", "a.jpg", "a.png").out
        mean = float(re.search(r"mean\s+([0-9.e-]+)", out).group(1))
        self.assertLess(mean, 0.01, out)
        self.refused("capture", "flat", "-o", "a.gif", says=[".png", ".jpg", ".exr", ".fits", ".mp4"])
        self.run_nullscope("capture", "first-light", "--size", "%dx%d" % SIZE, "-o", "b.jpg", "--quality", "50")
        self.assertLess(2 * (self.folder / "b.jpg").stat().st_size, len(data))
        self.refused("capture", "flat", "--quality", "50", "-o", "c.png", says=["--quality", ".jpg"])
        self.refused("capture", "flat", "--bits", "16", "-o", "c.jpg", says=["--bits", "PNG", "TIFF"])
        self.refused("capture", "flat", "--bits", "8", "-o", "c.tif", says=["--bits 8", "16 bits"])
        self.refused("capture", "flat", "--quality", "101", "-o", "c.jpg", says=["--quality", "100"])
        self.refused("capture", "flat", "--raydata", "-o", "b.jpg", says=["--raydata", ".exr"])
        self.refused("capture", "flat", "--size", "64x36", "-o", "missing/b.jpg", status=1, says=["missing/b.jpg"])

    def test_intensities_of_a_mesh(self):
        """Half of them: of light exactly 0.5, or 0.5^2.2; of displayed values up to half 0.5 to 6 of 255, in both tracers."""
        for name, i in (("one", 1), ("half", 0.5)):
            self.write(name + ".data", f"2\n2 2\n-2 -1 0 0 {i}\n2 -1 1 0 {i}\n-2 1 0 1 {i}\n2 1 1 1 {i}\n")
        def draw(mesh, kind, file, *options):
            self.write("w.toml", f'[camera]\nr = 12\nwarp = "{mesh}.data"\nwarp_intensity = "{kind}"\n[sky]\nkind = "noise"\n[disc]\n[picture]\nrefine = "off"\n')
            self.run_nullscope("capture", "w.toml", "--size", "64x36", *options, "-o", file)
            data = (self.folder / file).read_bytes()
            if file.endswith(".exr"):
                return [v for c in "RGB" for row in support.read_exr(data)[c] for v in row]
            return list(read_png(self.folder / file).data)
        for options in ([], ["--renderer", "reference", "--samples", "1"]):
            whole = draw("one", "linear", "a.exr", *options)
            for kind, factor in (("linear", 0.5), ("display", 0.5 ** 2.2)):
                for one, other in zip(draw("half", kind, "b.exr", *options), whole):
                    self.assertAlmostEqual(one, factor * other, delta=1e-5 * other + 1e-9)
        whole, dimmed = draw("one", "linear", "a.png"), draw("half", "display", "b.png")
        dark = [(v, d) for v, d in zip(whole, dimmed) if v <= 128]
        self.assertGreater(len(dark), 1000)
        self.assertLessEqual(max(abs(d - v / 2) for v, d in dark), 6.5)
        self.assertLessEqual(max(abs(d - v / 2) for v, d in zip(whole, dimmed)), 64.5)

    def sphere(self, name):
        """What the file says in Google's namespace of XMP; None: nothing."""
        data = (self.folder / name).read_bytes()
        if name.endswith(".png"):
            mark = b"XML:com.adobe.xmp\0\0\0\0\0"
            found = [body[len(mark):] for kind, body in png_chunks(data) if kind == b"iTXt" and body.startswith(mark)]
        else:
            mark = b"http://ns.adobe.com/xap/1.0/\0"
            found = [body[len(mark):] for kind, body in jpeg_segments(data) if kind == 0xe1 and body.startswith(mark)]
        self.assertLessEqual(len(found), 1)
        if not found:
            return None
        space = "{http://ns.google.com/photos/1.0/panorama/}"
        return {key[len(space):]: value for node in ElementTree.fromstring(found[0]).iter() for key, value in node.attrib.items() if key.startswith(space)}

    @support.costly
    def test_panoramas_say_which_part_of_the_sphere_they_are(self):
        names = ("FullPanoWidthPixels", "FullPanoHeightPixels", "CroppedAreaImageWidthPixels", "CroppedAreaImageHeightPixels",
                 "CroppedAreaLeftPixels", "CroppedAreaTopPixels")
        view = '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "checker"\n[camera]\nprojection = "equirectangular"\n'
        for number, (keys, size, numbers) in enumerate((
                ("", "64x32", (64, 32, 64, 32, 0, 0)),
                ("", "64x20", (64, 32, 64, 20, 0, 6)),
                ("fov = 90\n", "64x32", (256, 128, 64, 32, 96, 48)),
                ("fov = 90\nshift_y = 0.5\n", "64x32", (256, 128, 64, 32, 96, 32)),   # the horizon is its lower side
                ("fov = 90\nshift_x = 1\n", "64x32", (256, 128, 64, 32, 160, 48)),
                ("shift_x = 0.25\n", "64x32", (64, 32, 64, 32, 0, 0)),
                ("fov = 90\npixel_aspect = 2\n", "64x32", (256, 256, 64, 32, 96, 112)),
                ("fov = 100\n", "63x27", (227, 113, 63, 27, 82, 43)),
                ("", "64x36", None),                                                   # more than 180 degrees high
                ("shift_y = 0.1\n", "64x32", None),
                ('stereo = "pair"\n', "64x32", None))):
            scene = self.write(f"{number}.toml", view + keys)
            for kind in ("png", "jpg"):
                self.run_nullscope("capture", scene, "--size", size, "-o", f"{number}.{kind}")
                got = self.sphere(f"{number}.{kind}")
                want = numbers and {**dict(zip(names, map(str, numbers))), "ProjectionType": "equirectangular", "UsePanoramaViewer": "True"}
                self.assertEqual(got, want, f"{keys} {size} {kind}")
        self.run_nullscope("capture", self.write("flat.toml", view.replace("equirectangular", "pinhole")), "--size", "64x32", "-o", "flat.png")
        self.assertIsNone(self.sphere("flat.png"))
        self.run_nullscope("capture", "0.png", "-o", "again.png")
        self.assertEqual((self.folder / "again.png").read_bytes(), (self.folder / "0.png").read_bytes())

    @support.costly
    def test_streamlines_are_over_displayed_pictures_that_are_not_plain(self):
        text = self.run_nullscope("scenes", "m87-swirl").out.replace('scale_bar = "uas"\n', "").replace('dither = "on"\n', "").replace(
            'ticks = "on"', 'streamlines = "on"')
        self.write("on.toml", text), self.write("off.toml", text.replace('streamlines = "on"', 'streamlines = "off"'))
        capture = ("capture", "--size", "160x90", "--quiet")
        for arguments in (("off.toml", "-o", "off.png"), ("on.toml", "-o", "on.png"), ("on.toml", "--plain", "-o", "plain.png"),
                          ("on.toml", "-o", "on.exr"), ("off.toml", "-o", "off.exr")):
            self.run_nullscope(*capture, *arguments)
        self.run_nullscope(*capture, "on.toml", "-o", "one.png", before=lambda: os.sched_setaffinity(0, list(os.sched_getaffinity(0))[:1]))
        off, on, plain, one = (read_png(self.folder / name).data for name in ("off.png", "on.png", "plain.png", "one.png"))
        self.assertEqual(plain, off)
        self.assertEqual(one, on)
        self.assertTrue(all(lined <= light for lined, light in zip(on, off)))   # they only darken
        self.assertGreater(sum(lined < light - 30 for lined, light in zip(on, off)), len(off) / 50)
        self.assertIn("max 0", self.run_nullscope("compare", "off.exr", "on.exr").out)   # linear light has none

    def test_half_floats_end_somewhere(self):
        """And a line says how many numbers are cut, unless it is quiet."""
        scene = self.write("s.toml", '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "plain"\ncolour = [0.7, 0.7, 0.01]\nbrightness = 1e6\n')
        for words, says in ((("--half",), "a.exr: 288 numbers above 65504, the largest half float, are written as that\n"), ((), ""), (("--half", "--quiet"), "")):
            self.assertEqual(self.run_nullscope("capture", scene, "--size", "16x9", *words, "-o", "a.exr").said(), says)

    @support.costly
    def test_light_of_any_brightness_is_shown(self):
        """With bloom and automatic exposure too, which work on light before its exposure: of 1e-7 and 5e5 as of 1. A sky of one colour."""
        for picture in ("bloom = 0.0", "bloom = 0.3", 'auto_exposure = "on"'):
            for octaves in 0, -23, 19:
                automatic = picture.startswith("auto") and octaves >= 0   # what is darker is not raised any more
                scene = self.write("s.toml", '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "plain"\ncolour = [0.7, 0.7, 0.7]\n'
                                             f"brightness = {2.0**octaves}\n[camera]\nexposure = {0 if automatic else -octaves}\n[picture]\n{picture}\n")
                metered = max(0.7 * 2.0**octaves, 1e-4)
                light = 0.7 * (1 if not picture.startswith("auto") else 2.0**octaves * 0.12 / metered * (1 if automatic else 2.0**-octaves))
                code = 1 - math.exp(-min(light, 1e4))
                code = 255 * (12.92 * code if code < 0.0031308 else 1.055 * code**(1 / 2.4) - 0.055)
                for renderer in "gl", "reference":
                    self.run_nullscope("capture", scene, "--size", "16x9", "--renderer", renderer, "-o", "a.png")
                    for shown in set(read_png(self.folder / "a.png").data):
                        self.assertAlmostEqual(shown, code, delta=1.5, msg=f"{renderer}: {picture}, 2^{octaves}")


if __name__ == "__main__":
    support.main()
