#!/usr/bin/env python3
"""Whatever changes a picture is in its metadata, in every format alike, and a picture is drawn again from itself, bit for bit."""
import array
import hashlib
import math
import re
import shutil
import struct
import subprocess
import sys
import zlib
from pathlib import Path

import support
from image_bytes import attribute, exr_attributes, jpeg_segments, png, png_chunks
from test_astronomy import read_fits
from test_pictures import png_texts

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "viewer"))
from x_screen import read_png  # noqa: E402

KINDS = ("png", "jpg", "exr", "fits", "tif")
# Of no format of their own: what PNG asks for, and what a file is.
OTHERS = {"Title", "Software"}
SIZE = ("--size", "48x27")
SKY = '[camera]\nr = 12\ntheta = 80\n[sky]\nkind = "image"\nimage = "%s"\n'
WARPED = 'name = "warped"\n[camera]\nr = 12\nwarp = "%s"\n[sky]\nkind = "checker"\n'
GRID = '[spacetime]\nmetric = "kerr"\nspin = 0.9\n[camera]\nr = 15\ntheta = 60\n[sky]\nkind = "black"\n[medium]\nkind = "grid"\nfile = "%s"\n[object]\nname = "m87"\n'
KEYS = '[spacetime]\nmetric = "kerr"\nspin = 0.8\n[camera]\nr = 20\n[sky]\nkind = "checker"\n[path]\nkind = "keys"\nfile = "camera.csv"\n'


def png_of(colour, width=64, height=32):
    """A PNG of stripes, by hand."""
    rows = b"".join(b"\0" + b"".join(bytes(colour if x // 4 % 2 else (9, 9, 9)) for x in range(width)) for _ in range(height))
    return png(width, height, rows)


def grid_of(density, head=""):
    """A grid of matter of 3 x 3 x 1 nodes."""
    node = struct.pack("<8f", density, 5e10, 1, 1, 10, 0, 0, 0)
    return (f"nullscope-medium 1\ncoordinates kerr-schild\nspin 0.9\nr 0.8 12 3\ntheta 0.1 3.0 3\nphi 0 1\n{head}data\n").encode() + 9 * node


def mesh_of(shift):
    """A warp mesh of 3 x 3 nodes."""
    lines = ["2", "3 3"]
    lines += [f"{1.777 * (x - 1):.4f} {y - 1 + (shift if x == y == 1 else 0):.4f} {x / 2:.3f} {y / 2:.3f} 1" for y in range(3) for x in range(3)]
    return "\n".join(lines) + "\n"


def jpeg_texts(data):
    said = (body.split(b"\n", 1) for kind, body in jpeg_segments(data) if kind == 0xfe and body.startswith(b"nullscope."))
    return {keyword.decode(): text.decode() for keyword, text in said}


def exr_texts(data):
    return {name: body.decode() for name, (kind, body) in exr_attributes(data)[0].items() if kind == "string"}


def whole(texts):
    """Pieces KEYWORD.0, KEYWORD.1, ... put together."""
    out = {}
    for keyword, text in texts.items():
        name, _, number = keyword.rpartition(".")
        if number.isdigit():
            out.setdefault(name, {})[int(number)] = text
        else:
            out[keyword] = {0: text}
    return {name: "".join(text for _, text in sorted(pieces.items())) for name, pieces in out.items()}


def read_tiff(data):
    """By hand: the first directory's tags, and the colours of 16 bits, row by row."""
    assert data[:4] == b"II*\0", "lowest bytes first, not a BigTIFF"
    at = struct.unpack("<I", data[4:8])[0]
    tags = {}
    for entry in range(struct.unpack("<H", data[at:at + 2])[0]):
        tag, kind, count, place = struct.unpack("<HHII", data[at + 2 + 12 * entry:at + 14 + 12 * entry])
        size = count * {2: 1, 3: 2, 4: 4, 7: 1}[kind]
        value = data[place:place + size] if size > 4 else data[at + 10 + 12 * entry:][:size]
        tags[tag] = (value.rstrip(b"\0").decode() if kind == 2 else value if kind == 7 else
                     list(struct.unpack(f"<{count}{'H' if kind == 3 else 'I'}", value)))
    (width,), (height,) = tags[256], tags[257]
    assert (tags[258], tags[277], tags[262], tags[259], tags[317], tags[284], tags[274]) == ([16] * 3, [3], [2], [8], [2], [1], [1])
    plain = b"".join(zlib.decompress(data[place:place + size]) for place, size in zip(tags[273], tags[279]))
    codes = array.array("H", plain)
    for y in range(height):
        for i in range(3 * width * y + 3, 3 * width * (y + 1)):
            codes[i] = codes[i] + codes[i - 3] & 0xffff   # the predictor: differences from the pixel before
    return tags, width, height, codes


def words_of_png(data):
    """Colours of 16 bits; rows of filter 0, or 1: differences of bytes from the pixel before."""
    chunks = list(png_chunks(data))
    width, height, bits, kind = struct.unpack(">IIBB", dict(chunks)[b"IHDR"][:10])
    assert (bits, kind) == (16, 2)
    plain, words = zlib.decompress(b"".join(body for name, body in chunks if name == b"IDAT")), []
    for y in range(height):
        row = bytearray(plain[y * (6 * width + 1):(y + 1) * (6 * width + 1)])
        assert row[0] in (0, 1)
        for i in range(7, len(row) if row[0] else 0):
            row[i] = row[i] + row[i - 6] & 255
        words += struct.unpack(f">{3 * width}H", row[1:])
    return words


def fits_texts(data):
    history, at = [], 0
    while not data[at:at + 80].startswith(b"END "):
        card = data[at:at + 80].decode("ascii").rstrip()
        at += 80
        if card.startswith("HISTORY "):
            history.append(card[8:])
    return card_texts(history)


def card_texts(cards):
    texts, keyword = {}, None
    for words in cards:
        if words.startswith("nullscope."):
            keyword = words
            texts[keyword] = []
        elif words.startswith("|"):
            texts[keyword].append(words[2:])
        else:
            texts[keyword][-1] += words[2:]
    return {keyword: re.sub("((?:%[0-9A-F]{2})+)", lambda m: bytes.fromhex(m.group(1).replace("%", "")).decode(), "\n".join(lines))
            for keyword, lines in texts.items()}


def texts_of(path):
    data = path.read_bytes()
    texts = {".png": png_texts, ".jpg": jpeg_texts, ".exr": exr_texts, ".fits": fits_texts, ".tif": lambda d: card_texts(read_tiff(d)[0][270].split("\n"))}[path.suffix](data)
    return {keyword: text for keyword, text in whole(texts).items() if keyword not in OTHERS}


def kinds_of(number):
    """At quick depth one format for each case, in turn: test_every_format_says_the_same holds the others."""
    return [KINDS[number % len(KINDS)]] if support.QUICK else KINDS


class Provenance(support.CliTest):
    def capture(self, scene, name, *options):
        self.run_nullscope("capture", scene, "-o", name, *options)
        return texts_of(self.folder / name)

    def apart(self, number, one, other, keyword):
        """Two runs whose pictures say different things under this keyword."""
        for kind in kinds_of(number):
            a, b = (self.capture(words[0], f"a.{kind}", *SIZE, *words[1:]) for words in (one, other))
            self.assertNotEqual(a[keyword], b[keyword], f"{kind}: {keyword}")

    def test_every_format_says_the_same(self):
        scene = self.write("größe.toml", 'name = "Größe 50 % und\\\\ mehr "\n' + KEYS.split("[path]")[0] + "[disc]\n")
        said = {kind: self.capture(scene, f"a.{kind}", *SIZE, "--plain") for kind in KINDS}
        for kind in KINDS:
            said[kind]["nullscope.options"] = re.sub(" ?--(quality 92|plain)", "", said[kind]["nullscope.options"])
            self.assertEqual(said[kind], said["png"], kind)
        self.assertEqual(said["png"]["nullscope.scene"], "Größe 50 % und\\ mehr ")
        self.assertEqual(set(said["png"]), {"nullscope." + word for word in ("scene", "scene_text", "scene_hash", "options", "renderer", "version")})
        for kind in KINDS:   # no date, no name of a machine or a folder; the same bytes again
            data = (self.folder / f"a.{kind}").read_bytes()
            self.assertNotIn(str(self.folder).encode(), data)
            self.capture(scene, f"b.{kind}", *SIZE, "--plain")
            self.assertEqual(data, (self.folder / f"b.{kind}").read_bytes(), kind)

    def test_two_files_of_other_bytes_are_told_apart(self):
        self.write("warm.png", png_of((200, 80, 0)))
        self.write("cold.png", png_of((0, 80, 200)))
        self.write("thin.grid", grid_of(1e3))
        self.write("dense.grid", grid_of(4e3))
        self.write("flat.mesh", mesh_of(0))
        self.write("bent.mesh", mesh_of(0.05))
        for number, (scene, one, other) in enumerate(((SKY, "warm.png", "cold.png"), (GRID, "thin.grid", "dense.grid"),
                                                      (WARPED, "flat.mesh", "bent.mesh"))):
            kept = {}
            for name in (one, other):   # under one name: the scene's text is the same
                shutil.copy(self.folder / name, self.folder / "input")
                path = self.write("scene.toml", scene % "input")
                for kind in kinds_of(number):
                    texts = self.capture(path, f"{name}.{kind}", *SIZE)
                    self.assertEqual(texts["nullscope.files"], hashlib.sha256((self.folder / name).read_bytes()).hexdigest() + "  input")
                    kept.setdefault(kind, []).append(texts)
            for kind, (a, b) in kept.items():
                self.assertEqual(a["nullscope.scene_text"], b["nullscope.scene_text"])
                self.assertNotEqual(a["nullscope.files"], b["nullscope.files"], f"{scene}: {kind}")

    def test_a_grid_s_head_is_shown(self):
        head = self.capture("grid-torus", "a.png", *SIZE)["nullscope.grid_head"]
        self.assertTrue(head.startswith("nullscope-medium 1\ncoordinates "), head)

    @support.costly
    def test_options_are_told_apart(self):
        pairs = {
            "nullscope.scene_text": [(("kerr",), ("kerr", "--time", "3")), (("kerr",), ("kerr", "--samples", "2"))],
            "nullscope.options": [(("flat",), ("flat", "--renderer", "reference", "--samples", "1")),
                                  (("flat", "--renderer", "reference", "--samples", "1"), ("flat", "--renderer", "reference", "--samples", "2")),
                                  (("first-light",), ("first-light", "--method", "table")),
                                  (("flat",), ("flat", "--largest-texture", "64"))],
            "nullscope.split_text": [(("flat", "--split", "kerr"), ("flat", "--split", "first-light"))]}
        for number, (keyword, (one, other)) in enumerate((keyword, case) for keyword, cases in pairs.items() for case in cases):
            self.apart(number, one, other, keyword)
        for kind, one, other in (("jpg", ["--quality", "50"], ["--quality", "60"]), ("exr", [], ["--half"]), ("exr", [], ["--raydata"]),
                                 ("exr", [], ["--layers"]), ("exr", ["--st-map", "sky"], ["--st-map", "plate"])):
            a, b = (self.capture("flat", f"a.{kind}", *SIZE, *words)["nullscope.options"] for words in (one, other))
            self.assertNotEqual(a, b)
        split = self.write("split.toml", '[camera]\nr = 8\n[sky]\nkind = "plain"\n[split]\nmetric = "kerr"\n')
        self.assertIn("--plain", self.capture(split, "a.png", *SIZE, "--plain")["nullscope.options"])
        for tiles in ("traced", "bodies"):   # of a disc, which they draw otherwise
            self.assertIn(f"--tiles {tiles}", self.capture("accretion", "a.png", *SIZE, "--tiles", tiles)["nullscope.options"])
            self.assertNotIn("--tiles", self.capture("flat", "a.png", *SIZE, "--tiles", tiles)["nullscope.options"])

    def drawn_again(self, name, *options):
        """The very same file, from nothing but it."""
        data = (self.folder / name).read_bytes()
        ran = self.run_nullscope("capture", name, "-o", "again" + Path(name).suffix, *options)
        self.assertEqual(ran.said(), "")
        self.assertEqual(data, (self.folder / ("again" + Path(name).suffix)).read_bytes(), f"{name}\n{texts_of(self.folder / name)}")

    @support.costly
    def test_a_picture_is_drawn_again_from_itself(self):
        self.write("sky.png", png_of((200, 80, 0)))
        sky = self.write("scene.toml", SKY % "sky.png")
        turned = self.write("turned.toml", SKY.replace("theta = 80", "theta = 71.3\nyaw = 0.7\nroll = 33") % "sky.png")
        for number, (scene, *options) in enumerate(((sky,), (turned, "--samples", "2", "--time", "1.5"), ("flat", "--split", "sky-only"),
                                                    ("kerr", "--renderer", "reference", "--samples", "1"), ("m87",))):
            for kind in kinds_of(number):
                self.run_nullscope("capture", scene, "--size", "32x18", *options, "-o", f"a.{kind}")
                self.drawn_again(f"a.{kind}")
        for words in (["--half"], ["--raydata"], ["--layers"], ["--st-map", "sky"]):
            self.run_nullscope("capture", "kerr", "--size", "16x9", *words, "-o", "a.exr")
            self.drawn_again("a.exr")
            if support.QUICK and words != ["--half"]:
                continue
            # What is given goes before what cannot stand beside it.
            self.run_nullscope("capture", "a.exr", "--raydata" if words == ["--half"] else "--half", "-o", "b.exr")
            self.run_nullscope("capture", "a.exr", "--renderer", "reference", "--samples", "1", "--size", "8x8", "-o", "b.exr")
            self.run_nullscope("capture", "b.exr", "--context", "auto", "-o", "c.exr")
            self.assertIn("--tiles bodies", texts_of(self.folder / "c.exr")["nullscope.options"])
        ran = self.run_nullscope("capture", "a.exr", "-o", "b.png")
        self.assertRegex(ran.err, "^a.exr: recorded options are left out, only an .exr has them: --st-map\n$")
        # In another format, of another size: what is given overrides.
        self.run_nullscope("capture", "a.exr", "--size", "40x20", "-o", "b.png")
        picture = read_png(self.folder / "b.png")
        self.assertEqual((picture.width, picture.height), (40, 20))

    @support.costly
    def test_frames_are_drawn_again(self):
        rows = ["frame,r,theta,phi"] + [f"{10 * k},{20 - k},{70 + 3 * k},{7 * k}" for k in range(4)]
        self.write("camera.csv", "\n".join(rows) + "\n")
        keys = self.write("keys.toml", KEYS)
        blurred = self.write("blurred.toml", KEYS + "[picture]\nshutter = 0.5\nsub_frames = 3\n")
        moving = self.write("moving.toml", '[camera]\nr = 20\n[sky]\nkind = "checker"\n[ball]\nposition = [8, 0, 0]\nmotion = "orbit"\n')
        for number, (scene, *options) in enumerate(((keys, "--frames", "7:8"), (blurred, "--frames", "7:8"), ("kerr-plunge", "--frames", "3:4"),
                                                    (moving, "--frames", "2:3", "--time-step", "4", "--time-frame", "0"))):
            for kind in kinds_of(number):
                self.run_nullscope("capture", scene, "--size", "32x18", *options, "-o", f"f%d.{kind}")
                name = next(path.name for path in self.folder.glob(f"f*.{kind}"))
                self.assertIn("nullscope.frame", texts_of(self.folder / name))
                self.drawn_again(name)
                (self.folder / name).unlink()
        self.run_nullscope("capture", moving, "--size", "32x18", "--layers", "--frames", "2:3", "--time-step", "4", "-o", "m%d.exr")
        self.drawn_again("m2.exr")   # with its motion vectors

    def test_recorded_options_give_way_to_what_excludes_them(self):
        """The number of samples is of a picture's colours: a map of where its pixels look has none."""
        scene = self.write("s.toml", '[sky]\nkind = "checker"\n')
        self.capture(scene, "a.png", "--size", "16x9", "--renderer", "reference", "--samples", "2")
        self.assertIn("--samples 2", texts_of(self.folder / "a.png")["nullscope.options"])
        options = self.capture("a.png", "map.exr", "--st-map", "sky")["nullscope.options"]
        self.assertIn("--st-map sky", options)
        self.assertIn("--samples 2", self.capture("map.exr", "b.png", "--samples", "2")["nullscope.options"])

    def test_files_are_looked_for_beside_the_picture_and_here(self):
        (self.folder / "scenes").mkdir()
        (self.folder / "out").mkdir()
        sky = png_of((200, 80, 0))
        self.write("scenes/sky.png", sky)
        scene = self.write("scenes/s.toml", SKY % "sky.png")
        self.run_nullscope("capture", scene, *SIZE, "-o", "out/a.png")
        self.assertIn('image = "sky.png"', texts_of(self.folder / "out/a.png")["nullscope.scene_text"])
        self.refused("capture", "out/a.png", "-o", "b.png", says=["out/a.png", "sky.image", "sky.png"])
        for place in ("sky.png", "out/sky.png"):
            self.write(place, sky)
            self.run_nullscope("capture", "out/a.png", "-o", "b.png")
            self.assertEqual((self.folder / "out/a.png").read_bytes(), (self.folder / "b.png").read_bytes())
        self.write("out/sky.png", png_of((0, 80, 200)))   # another one: said
        ran = self.run_nullscope("capture", "out/a.png", "-o", "b.png")
        self.assertRegex(ran.err, 'out/a.png: "out/sky.png" is not the file that the picture was drawn from')
        self.assertEqual(ran.err.count("\n"), 1)

    @support.costly
    def test_every_command_opens_a_picture(self):
        for kind in KINDS:
            name = f"a.{kind}"
            self.run_nullscope("capture", "first-light", "--size", "32x18", "-o", name)
            text = self.write("s.toml", texts_of(self.folder / name)["nullscope.scene_text"])
            self.assertEqual(self.run_nullscope("plan", name).out, self.run_nullscope("plan", text).out)
            self.assertIn('name = "First light"', self.run_nullscope("scenes", name).out)

    @support.costly
    def test_what_holds_no_scene_is_refused(self):
        self.write("plain.png", png_of((1, 2, 3)))
        self.refused("capture", "plain.png", "-o", "b.png", says=["plain.png", "holds no scene"])
        self.refused("plan", "plain.png", says=["plain.png", "holds no scene"])
        self.run_nullscope("capture", "first-light", "--size", "32x18", "-o", "a.png")
        data = (self.folder / "a.png").read_bytes()
        at = data.index(b"iTXtnullscope.scene_text")
        self.write("cut.png", data[:at + 100])
        self.refused("capture", "cut.png", "-o", "b.png", says=["cut.png", "cut off"])
        self.write("huge.png", data[:at - 4] + struct.pack(">I", 0x7fffffff) + data[at:])
        self.refused("capture", "huge.png", "-o", "b.png", says=["huge.png", "metadata are longer"])
        self.write("flipped.png", data[:at + 60] + bytes([data[at + 60] ^ 1]) + data[at + 61:])
        self.refused("capture", "flipped.png", "-o", "b.png", says=["flipped.png", "CRC"])
        for kind in KINDS[1:]:
            self.run_nullscope("capture", "first-light", "--size", "32x18", "-o", f"a.{kind}")
            data = (self.folder / f"a.{kind}").read_bytes()
            self.write(f"cut.{kind}", data[:data.index(b"nullscope.scene_text") + 90])
            self.refused("capture", f"cut.{kind}", "-o", "b.png", says=[f"cut.{kind}", "cut off"])
        # Options that nobody may have written.
        self.run_nullscope("capture", "kerr", "--size", "32x18", "-o", "a.exr")
        words = self.write("a.exr", (self.folder / "a.exr").read_bytes().replace(b"--tiles bodies", b"--tiles bodiez"))
        self.refused("capture", words, "-o", "b.png", says=["a.exr", "nullscope.options", "bodiez"])

    def test_an_exr_has_short_attributes_and_ffmpeg_draws_it(self):
        long = self.write("long.toml", 'name = "%s"\n[sky]\nkind = "plain"\n' % ("ä" * 90) +
                          "".join(f'[[ball]]\nname = "ball-{i}"\nposition = [{20 + i}.123456789, 3.25, {i}]\n' for i in range(30)))
        self.capture(long, "a.exr", *SIZE)
        attributes = exr_texts((self.folder / "a.exr").read_bytes())
        self.assertLessEqual(max(len(text.encode()) for text in attributes.values()), 240)
        self.assertGreater(len(texts_of(self.folder / "a.exr")["nullscope.scene_text"]), 1500)
        if shutil.which("ffmpeg") is None:
            self.skipTest("ffmpeg is not installed")
        for name, options in (("a.exr", []), ("b.exr", ["--half"])):
            self.capture(long, name, *SIZE, *options)
            done = subprocess.run(["ffmpeg", "-v", "error", "-i", name, "-f", "rawvideo", "-pix_fmt", "gbrpf32le", "-"], cwd=self.folder,
                                  capture_output=True, check=True)
            values = array.array("f", done.stdout)
            self.assertEqual(len(values), 3 * 48 * 27)
            self.assertGreater(max(values), 0.1, "black")

    def test_a_picture_of_an_older_version_is_opened(self):
        """One attribute, however long."""
        self.run_nullscope("capture", "m87", "--size", "32x18", "-o", "a.exr")
        data = (self.folder / "a.exr").read_bytes()
        text = whole(exr_texts(data))["nullscope.scene_text"].encode()
        self.assertGreater(len(text), 240)
        others = {name: value for name, value in exr_attributes(data)[0].items() if not name.startswith("nullscope.")}
        head = b"".join(attribute(name, *value) for name, value in {"nullscope.scene_text": ("string", text), **others}.items())
        self.write("old.exr", data[:8] + head + b"\0")
        self.run_nullscope("capture", "old.exr", "-o", "b.exr")
        self.assertEqual(texts_of(self.folder / "b.exr"), texts_of(self.folder / "a.exr"))


class Tiff(support.CliTest):
    @support.costly
    def test_a_tiff_is_the_png_in_16_bits(self):
        """Read by hand, and by ffmpeg's own decoder; marks over it too. 0.6: half a step of 8 bits, half floats and the shader's square roots, 0.51 where measured."""
        split = self.write("split.toml", '[camera]\nr = 8\n[sky]\nkind = "stars"\n[split]\nmetric = "kerr"\n[picture]\nbloom = 0.2\n')
        eyes = self.write("eyes.toml", '[camera]\nr = 8\nstereo = "pair"\n[sky]\nkind = "stars"\n[disc]\n')
        for scene, options in (("first-light", []), (split, []), (eyes, []), ("first-light", ["--renderer", "reference", "--samples", "1"])):
            for name in ("a.tif", "a.tiff", "a.png"):
                self.run_nullscope("capture", scene, "--size", "96x54", *options, "-o", name)
            data, shown = (self.folder / "a.tif").read_bytes(), read_png(self.folder / "a.png")
            self.assertEqual(data, (self.folder / "a.tiff").read_bytes())
            tags, width, height, codes = read_tiff(data)
            self.assertEqual((width, height), (shown.width, shown.height))
            self.assertLess(max(abs(code / 257 - byte) for code, byte in zip(codes, shown.data)), 0.6, scene)
            self.assertGreater(len({code % 257 for code in codes}), 30, "8 bits only")
            if shutil.which("ffmpeg"):
                decoded = subprocess.run(["ffmpeg", "-v", "error", "-i", "a.tif", "-f", "rawvideo", "-pix_fmt", "rgb48le", "-"],
                                         cwd=self.folder, capture_output=True, check=True).stdout
                self.assertEqual(decoded, codes.tobytes())
        self.assertEqual(tags[269], "First light")
        self.assertRegex(tags[305], r"^nullscope \d")

    def test_a_png_of_16_bits_is_the_tiff(self):
        for options in ([], ["--renderer", "reference", "--samples", "1"]):
            self.run_nullscope("capture", "first-light", "--size", "48x27", *options, "-o", "a.tif")
            self.run_nullscope("capture", "first-light", "--size", "48x27", *options, "--bits", "16", "-o", "a.png")
            parts = dict(png_chunks((self.folder / "a.png").read_bytes()))
            self.assertEqual(struct.unpack(">IIBB", parts[b"IHDR"][:10]), (48, 27, 16, 2))
            self.assertEqual(words_of_png((self.folder / "a.png").read_bytes()), list(read_tiff((self.folder / "a.tif").read_bytes())[3]))
        self.run_nullscope("capture", "a.png", "-o", "again.png")   # it holds the option too
        self.assertEqual(dict(png_chunks((self.folder / "again.png").read_bytes()))[b"IHDR"][8], 16)
        self.run_nullscope("capture", "first-light", "--size", "48x27", "-o", "b.png")
        self.run_nullscope("capture", "first-light", "--size", "48x27", "--bits", "8", "-o", "c.png")
        self.assertEqual((self.folder / "b.png").read_bytes(), (self.folder / "c.png").read_bytes())

    def test_a_tiff_says_srgb(self):
        """The profile's curve and primaries, by the numbers of IEC 61966-2-1; D50's Y of the primaries is 1 in all."""
        self.run_nullscope("capture", "flat", "--size", "8x8", "-o", "a.tif")
        profile = read_tiff((self.folder / "a.tif").read_bytes())[0][34675]
        self.assertEqual((struct.unpack(">I", profile[:4])[0], profile[12:24], profile[36:40]), (len(profile), b"mntrRGB XYZ ", b"acsp"))
        parts = {}
        for i in range(struct.unpack(">I", profile[128:132])[0]):
            name, at, size = struct.unpack(">4sII", profile[132 + 12 * i:144 + 12 * i])
            parts[name] = profile[at:at + size]

        def numbers(part, start):
            return [v / 65536 for v in struct.unpack(f">{(len(part) - start) // 4}i", part[start:])]
        power, a, b, c, d = numbers(parts[b"gTRC"], 12)
        for code in (0.02, 0.04, 0.1, 0.5, 1.0):
            meant = code / 12.92 if code <= 0.04045 else ((code + 0.055) / 1.055)**2.4
            self.assertAlmostEqual(c * code if code < d else (a * code + b)**power, meant, delta=2e-5)
        columns = [numbers(parts[name], 8) for name in (b"rXYZ", b"gXYZ", b"bXYZ")]
        for sum_, white in zip((sum(column) for column in zip(*columns)), (0.9642, 1.0, 0.8249)):
            self.assertAlmostEqual(sum_, white, delta=2e-4)

    def test_a_damaged_tiff_is_refused(self):
        self.run_nullscope("capture", "flat", "--size", "8x8", "-o", "a.tif")
        data = (self.folder / "a.tif").read_bytes()
        at = struct.unpack("<I", data[4:8])[0]
        entry = next(at + 2 + 12 * i for i in range(64) if data[at + 2 + 12 * i:at + 4 + 12 * i] == struct.pack("<H", 270))
        for name, broken, says in (("far", data[:4] + b"\xff" * 4 + data[8:], "cut off"), ("long", data[:entry + 4] + b"\xff" * 4 + data[entry + 8:], "longer than"),
                                   ("short", data[:6], "short.tif"), ("none", data[:entry] + struct.pack("<H", 271) + data[entry + 2:], "holds no scene"),
                                   ("away", data[:entry + 8] + b"\xff" * 4 + data[entry + 12:], "cut off")):
            self.write(f"{name}.tif", broken)
            self.refused("capture", f"{name}.tif", "-o", "b.png", says=[f"{name}.tif", says])
        self.refused("capture", "flat", "--size", "8x8", "--half", "-o", "c.tif", says=["--half", ".exr"])
        self.assertFalse((self.folder / "c.tif").exists())


class Fits(support.CliTest):
    def test_the_spin_axis_has_a_position_angle(self):
        """A camera that rolls turns the axis towards the east, which is left."""
        scene = '[spacetime]\nmetric = "kerr"\nspin = 0.5\n[camera]\nr = %s\ntheta = %s\nroll = %s\nfov = 1\n[sky]\nkind = "black"\n[object]\nname = "m87"\n'
        for r, theta, roll in ((1000, 60, 0), (1000, 60, 30), (1000, 163, 108), (1000, 60, -45), (10, 60, 30)):
            path = self.write("s.toml", scene % (r, theta, roll))
            self.run_nullscope("capture", path, "--size", "32x32", "-o", "a.fits")
            cards, _ = read_fits((self.folder / "a.fits").read_bytes())
            self.assertAlmostEqual(cards["SPIN_PA"], roll % 360, places=9)
            self.assertEqual(cards["CTYPE1"], "RA---TAN" if r > 20 else "CALN-TAN")
        # Seen, in flat space: a ball on the axis lies there from the centre of coordinates, east to the left.
        seen = scene.replace("kerr", "minkowski").replace("spin = 0.5\n", "") + "[ball]\nposition = [0, 0, 5]\nradius = 1\n"
        self.run_nullscope("capture", self.write("s.toml", seen % (1000, 50, 70)), "--size", "64x64", "-o", "a.fits")
        cards, planes = read_fits((self.folder / "a.fits").read_bytes())
        light = [(x, 63 - y, value) for y, row in enumerate(planes[0]) for x, value in enumerate(row)]
        total = sum(value for _, _, value in light)
        east, north = (sum(place[axis] * place[2] for place in light) / total + 1 - cards[f"CRPIX{axis + 1}"] for axis in (0, 1))
        angle = math.degrees(math.atan2(east * cards["CDELT1"], north * cards["CDELT2"])) % 360
        self.assertAlmostEqual(angle, cards["SPIN_PA"], delta=0.5)
        self.run_nullscope("capture", self.write("on.toml", scene % (1000, 0, 0)), "--size", "32x32", "-o", "a.fits")
        cards, _ = read_fits((self.folder / "a.fits").read_bytes())
        self.assertNotIn("SPIN_PA", cards, "on the axis")


if __name__ == "__main__":
    support.main()
