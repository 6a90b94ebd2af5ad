#!/usr/bin/env python3
"""An image file is what its header says: parts and layers, windows, alpha, primaries, orientation, gamma; what is not used is told of in
one line."""
import struct
import zlib

import support
import test_image_light
from image_bytes import attribute, exr_head, png
from test_image_light import coloured_png, exr, grey, hdr, linear, plain_exr, rgb

WHOLE = (0, 0, 63, 31)
REC2020 = (0.708, 0.292, 0.17, 0.797, 0.131, 0.046, 0.3127, 0.329)
# ITU-R BT.2407, annex 2: linear Rec. 2020 to linear Rec. 709.
TO_709 = ((1.6605, -0.5876, -0.0728), (-0.1246, 1.1329, -0.0083), (-0.0182, -0.1006, 1.1187))


def layer(prefix, value):
    return {prefix + c: lambda x, y: value for c in "RGB"}


def chromaticities(numbers):
    return attribute("chromaticities", "chromaticities", struct.pack("<8f", *numbers))


def to_709(pixel):
    return [sum(m * v for m, v in zip(row, pixel)) for row in TO_709]


def exif(orientation, order):
    return ((b"II" if order == "<" else b"MM") + struct.pack(order + "HI", 42, 8) + struct.pack(order + "HHHIHHI", 1, 0x112, 3, 1, orientation, 0, 0))

def tiled_exr(width, height, value, kind=2, mipmaps=False):
    """In tiles of 32 px; of mip levels the coarser ones hold 9. kind of the channels: 0 whole numbers, 1 half, 2 float."""
    side, form = 32, "Ief"[kind]
    levels = max(width, height).bit_length() if mipmaps else 1
    window = (0, 0, width - 1, height - 1)
    head = exr_head("BGR", window, window, kind, [attribute("tiles", "tiledesc", struct.pack("<IIB", side, side, 1 if mipmaps else 0))])
    start, blocks = b"\x76\x2f\x31\x01" + struct.pack("<I", 2 | 0x200) + head, []
    for level in range(levels):
        w, h = max(width >> level, 1), max(height >> level, 1)
        for ty in range((h + side - 1) // side):
            for tx in range((w + side - 1) // side):
                across, down = min(side, w - side * tx), min(side, h - side * ty)
                body = struct.pack(f"<{3 * across * down}{form}", *[value(side * tx + x, side * ty + y) if level == 0 else 9
                                                                    for y in range(down) for _ in range(3) for x in range(across)])
                blocks.append(struct.pack("<5i", tx, ty, level, level, len(body)) + body)
    at, offsets = len(start) + 8 * len(blocks), []
    for block in blocks:
        offsets.append(at)
        at += len(block)
    return start + struct.pack(f"<{len(offsets)}Q", *offsets) + b"".join(blocks)


def tiff(width, height, channels, bits, value, order="<", tile=0, extra=None, orientation=1):
    """Uncompressed; value(x, y) of every channel, floats where they have 32 bits; None: no pixels. tile: side of one, px."""
    form = {8: "B", 16: "H", 32: "f"}.get(bits)
    def block(left, top, across, down):
        return struct.pack(f"{order}{across * down * channels}{form}", *[value(min(left + x, width - 1), min(top + y, height - 1))
                                                                         for y in range(down) for x in range(across) for _ in range(channels)])
    blocks = ([] if value is None else [block(x, y, tile, tile) for y in range(0, height, tile) for x in range(0, width, tile)] if tile
              else [block(0, 0, width, height)])
    data = b"".join(blocks)
    places = [8 + sum(map(len, blocks[:i])) for i in range(len(blocks))] or [8]
    tags = [(256, 4, [width]), (257, 4, [height]), (258, 3, [bits] * channels), (259, 3, [1]), (262, 3, [2 if channels > 2 else 1]), (274, 3, [orientation]),
            (277, 3, [channels]), (284, 3, [1]), (339, 3, [3 if bits == 32 else 1] * channels)]
    tags += [(338, 3, [extra])] if extra else []
    sizes = [len(b) for b in blocks] or [8]
    tags += [(322, 4, [tile]), (323, 4, [tile]), (324, 4, places), (325, 4, sizes)] if tile else [(273, 4, places), (278, 4, [height]), (279, 4, sizes)]
    at, rows, more = 8 + len(data) + 6 + 12 * len(tags), b"", b""
    for tag, kind, numbers in sorted(tags):
        body = struct.pack(f"{order}{len(numbers)}{'H' if kind == 3 else 'I'}", *numbers)
        if len(body) > 4:
            body, more = struct.pack(order + "I", at + len(more)), more + body
        rows += struct.pack(order + "HHI", tag, kind, len(numbers)) + body.ljust(4, b"\0")
    head = (b"II" if order == "<" else b"MM") + struct.pack(order + "HI", 42, 8 + len(data))
    return head + data + struct.pack(order + "H", len(tags)) + rows + bytes(4) + more


def flat_jpeg(width, height, codes, adobe=None):
    """One colour, a code for each component, as stored. adobe: the transform that Adobe's marker names."""
    count = len(codes)

    def marker(kind, body):
        return b"\xff" + bytes((kind,)) + struct.pack(">H", len(body) + 2) + body
    tables = marker(0xdb, b"\0" + b"\x01" * 64)
    tables += marker(0xc4, b"\0" + bytes([0, 0, 0, 12] + [0] * 12) + bytes(range(12)))   # DC: each of 12 categories in 4 bits
    tables += marker(0xc4, b"\x10" + bytes([1] + [0] * 15) + b"\0")                       # AC: the block's end in one
    frame = marker(0xc0, struct.pack(">BHHB", 8, height, width, count) + b"".join(bytes((c + 1, 0x11, 0)) for c in range(count)))
    scan = marker(0xda, bytes((count,)) + b"".join(bytes((c + 1, 0)) for c in range(count)) + b"\0\x3f\0")
    bits, last = "", [0] * count
    for _ in range(((width + 7) // 8) * ((height + 7) // 8)):
        for c, code in enumerate(codes):
            step = 8 * (code - 128) - last[c]
            last[c] += step
            size = abs(step).bit_length()
            bits += f"{size:04b}" + (f"{step if step > 0 else step + (1 << size) - 1:0{size}b}" if size else "") + "0"
    bits += "1" * (-len(bits) % 8)
    data = bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8)).replace(b"\xff", b"\xff\0")
    named = marker(0xee, b"Adobe" + struct.pack(">HHHB", 100, 0, 0, adobe)) if adobe is not None else b""
    return b"\xff\xd8" + named + tables + frame + scan + data + b"\xff\xd9"


class ImageFiles(support.CliTest):
    drawn, near = test_image_light.ImageLight.drawn, test_image_light.ImageLight.near

    def middle(self, name, **how):
        got = self.drawn(name, size="8x4", **how)
        return got[1][3]

    def grey_is(self, name, value, notes=(), **how):
        self.near(self.middle(name, **how), (value,) * 3)
        self.assertEqual(self.notes.count("\n"), 1 if notes else 0, self.notes)
        for word in notes:
            self.assertIn(word, self.notes)

    def refused_image(self, name, says):
        self.write("s.toml", f'[sky]\nkind = "image"\nimage = "{name}"\n')
        for command in (["capture", "s.toml", "--size", "8x4", "-o", "s.png"],
                        ["capture", "s.toml", "--size", "8x4", "--renderer", "reference", "-o", "s.png"]):
            self.refused(*command, says=[name, *says])

    def test_layers_of_an_exr(self):
        self.write("a.exr", plain_exr(64, 32, layer("ViewLayer.Combined.", 0.7)))
        self.grey_is("a.exr", 0.7)
        self.write("b.exr", plain_exr(64, 32, {**layer("ViewLayer.Combined.", 0.7), **layer("ViewLayer.Diffuse.", 9), "ViewLayer.Depth.Z": lambda x, y: 1}))
        self.grey_is("b.exr", 0.7, ["b.exr", "ViewLayer.Diffuse.R", "ViewLayer.Depth.Z"])
        self.write("c.exr", plain_exr(64, 32, {**layer("", 0.7), **layer("spec.", 9)}))
        self.grey_is("c.exr", 0.7, ["spec.R"])
        self.write("d.exr", plain_exr(64, 32, {**layer("diffuse.", 0.7), **layer("spec.", 9)}))
        self.refused_image("d.exr", ["several pictures", "diffuse.R", "spec.B"])
        self.drawn("c.exr", "--quiet", size="8x4")
        self.assertEqual(self.notes, "")
        self.write("e.exr", plain_exr(64, 32, {"Z": lambda x, y: 1, "beauty.R": lambda x, y: 1}))
        self.refused_image("e.exr", ["Z", "beauty.R"])
        self.write("f.exr", plain_exr(64, 32, {"beauty.Y": lambda x, y: 0.3}))
        self.grey_is("f.exr", 0.3)

    def test_a_layer_is_chosen(self):
        """By sky, disc and ball, in both tracers."""
        self.write("d.exr", plain_exr(64, 32, {**layer("diffuse.", 0.7), **layer("spec.", 9), **{"n." + c: lambda x, y: 1 for c in "XYZ"}}))
        self.near(self.drawn("d.exr", size="8x4", sky='image_layer = "diffuse"')[1][3], (0.7,) * 3)
        self.near(self.drawn("d.exr", size="8x4", sky='image_layer = "spec"')[1][3], (9,) * 3)
        self.write("b.exr", exr(("beauty", grey(0.7), WHOLE, WHOLE, []), ("diffuse", grey(9), WHOLE, WHOLE, [])))
        self.near(self.drawn("b.exr", size="8x4", sky='image_layer = "diffuse"')[1][3], (9,) * 3)
        ball = '[ball]\nposition = [10, 0, 0]\nradius = 8\ntexture = "image"\nimage = "d.exr"\nimage_layer = "diffuse"\n'
        disc = '[disc]\ninner = 0.5\nouter = 12\ntexture = "image"\nimage = "d.exr"\nimage_layer = "spec"\n'
        for body, theta, value in ((ball, 90, 0.7), (disc, 5, 9)):
            for options in ([], ["--renderer", "reference"]):
                self.write("b.toml", test_image_light.FLAT.format(fov=10).replace("90.0", f"{theta}.0") + '[sky]\nkind = "black"\n' + body)
                self.run_nullscope("capture", "b.toml", "--size", "8x4", *options, "-o", "drawn.exr")
                got = support.read_exr((self.folder / "drawn.exr").read_bytes())
                self.near((got["R"][0][0],), (value,), 2e-3)
        self.write("s.toml", '[sky]\nkind = "image"\nimage = "d.exr"\nimage_layer = "gloss"\n')
        self.refused("capture", "s.toml", "--size", "8x4", "-o", "s.png", says=["d.exr", "gloss", '"diffuse"', '"spec"'])
        self.write("s.toml", '[sky]\nkind = "black"\nimage_layer = "gloss"\n')
        self.refused("capture", "s.toml", "--size", "8x4", "-o", "s.png", says=["s.toml:3", "sky.image_layer"])

    def test_tiff(self):
        value = lambda x, y: 20000 + 300 * min(x, 63 - x) + 100 * y   # the view's middle is where both ends meet
        for name, data in (("lines", tiff(64, 32, 3, 16, value)), ("big end", tiff(64, 32, 3, 16, value, order=">")), ("tiles", tiff(64, 32, 3, 16, value, tile=16)),
                           ("grey", tiff(64, 32, 1, 16, value)), ("floats", tiff(64, 32, 3, 32, lambda x, y: linear(value(x, y) / 65535)))):
            self.write("a.tif", data)
            got = self.drawn("a.tif", size="9x5", fov=20)
            wanted = wanted if name != "lines" else got
            self.near(got[2][4], (linear((value(0, 15) + value(0, 16)) / 2 / 65535),) * 3, 0.01)
            for row, same in zip(got, wanted):
                for one, other in zip(row, same):
                    self.near(one, other)
            self.assertEqual(self.notes, "", name)
        self.write("b.tif", tiff(64, 32, 3, 8, lambda x, y: 77))
        self.grey_is("b.tif", linear(77 / 255))
        self.write("m.tif", tiff(64, 32, 4, 16, lambda x, y: 30000, extra=1))   # associated alpha: codes are multiplied by it
        self.grey_is("m.tif", 30000 / 65535 * linear(1.0))
        self.write("u.tif", tiff(64, 32, 4, 16, lambda x, y: 30000, extra=2))
        self.grey_is("u.tif", 30000 / 65535 * linear(30000 / 65535))
        self.write("turned.tif", tiff(32, 64, 3, 16, value, orientation=6))
        self.drawn("turned.tif", size="8x4")
        whole = tiff(64, 32, 3, 16, value)
        self.write("cut.tif", whole[:5000])
        self.refused_image("cut.tif", ["libtiff"])
        self.write("huge.tif", tiff(60000, 60000, 3, 16, None))
        self.refused_image("huge.tif", ["60000 x 60000"])
        self.write("odd.tif", tiff(64, 32, 3, 64, None))
        self.refused_image("odd.tif", ["64 bits"])

    def test_parts_of_an_exr(self):
        depth = ("depth", {"Z": lambda x, y: 1}, WHOLE, WHOLE, [])
        self.write("a.exr", exr(depth, ("beauty", grey(0.7), WHOLE, WHOLE, [])))
        self.grey_is("a.exr", 0.7, ["Z (part 1)"])
        self.write("b.exr", exr(("beauty", grey(0.7), WHOLE, WHOLE, []), ("diffuse", grey(9), WHOLE, WHOLE, [])))
        self.refused_image("b.exr", ["several pictures", "part 1 (beauty)", "part 2 (diffuse)"])
        self.write("c.exr", exr(("beauty", grey(0.7), WHOLE, WHOLE, []), ("diffuse", layer("diffuse.", 9), WHOLE, WHOLE, [])))
        self.grey_is("c.exr", 0.7, ["diffuse.R (part 2)"])

    def test_windows_of_an_exr(self):
        self.write("a.exr", exr(("", grey(0.7), (0, 0, 63, 15), WHOLE, [])))       # the northern half
        got = self.drawn("a.exr", size="8x4")
        self.near(got[0][3], (0.7,) * 3)
        self.assertEqual(got[3][3], (0, 0, 0))
        self.write("b.exr", exr(("", rgb(*[lambda x, y: 0.7 if 0 <= y < 32 else 9] * 3), (-5, -9, 68, 40), WHOLE, [])))
        for row in self.drawn("b.exr", size="8x4", fov=140):
            for pixel in row:
                self.near(pixel, (0.7,) * 3)
        self.assertIn("outside of its display window", self.notes)
        self.write("c.exr", exr(("", grey(0.7), (100, 0, 120, 9), WHOLE, [])))
        self.refused_image("c.exr", ["display window"])

    def test_alpha(self):
        self.write("a.exr", plain_exr(64, 32, {**grey(0.4), "A": lambda x, y: 0.5}))
        self.grey_is("a.exr", 0.4)   # colours of an EXR are multiplied by it
        half = 32896 / 65535
        self.write("a.png", coloured_png(64, 32, lambda x, y: (40000, 40000, 40000, 32896), alpha=True))
        self.grey_is("a.png", half * linear(40000 / 65535))
        disc = '[disc]\ninner = 0.5\nouter = 12\ntexture = "image"\nimage = "{}"\nopacity = 1.0\n'
        self.write("black.exr", plain_exr(16, 8, grey(0)))
        for name, value in (("a.exr", 0.4), ("a.png", half * linear(40000 / 65535))):
            self.write("d.toml", '[spacetime]\nmetric = "minkowski"\n[camera]\nr = 30.0\ntheta = 5.0\nfov = 10\n[sky]\nkind = "black"\n' + disc.format(name))
            self.run_nullscope("capture", "d.toml", "--size", "8x4", "-o", "d.exr")
            got = support.read_exr((self.folder / "d.exr").read_bytes())
            self.near([got[c][0][0] for c in "RGB"], (value,) * 3)
        ball = '[ball]\nposition = [10, 0, 0]\nradius = 8\ntexture = "image"\nimage = "a.png"\n'
        self.grey_is("black.exr", linear(40000 / 65535), ["a.png", "alpha"], more=ball)
        self.write("lost.exr", plain_exr(64, 32, {**grey(0.4), "A": lambda x, y: 0.0 if x < 3 else 1.0}))
        self.grey_is("lost.exr", 0.4)   # a sky is over black

    def test_primaries(self):
        pixel = (0.5, 0.4, 0.3)
        wide = rgb(*[lambda x, y, v=v: v for v in pixel])
        self.write("a.exr", plain_exr(64, 32, wide, [chromaticities(REC2020)]))
        self.near(self.middle("a.exr"), to_709(pixel))
        self.assertEqual(self.notes, "")
        self.write("b.exr", plain_exr(64, 32, rgb(lambda x, y: 0.1, lambda x, y: 0.9, lambda x, y: 0.1), [chromaticities(REC2020)]))
        self.assertEqual(self.middle("b.exr")[0], 0)
        self.assertIn("below 0", self.notes)
        c = [round(100000 * v) for v in (*REC2020[6:], *REC2020[:6])]
        self.write("a.png", coloured_png(64, 32, lambda x, y: [round(65535 * v) for v in pixel],
                                chunks=[(b"cHRM", struct.pack(">8I", *c)), (b"gAMA", struct.pack(">I", 100000))]))
        self.near(self.middle("a.png"), to_709(pixel))
        self.write("a.hdr", hdr(64, 32, lambda x, y: (128, 102, 77, 128), "PRIMARIES=" + " ".join(map(str, REC2020)) + "\n"))
        self.near(self.middle("a.hdr"), to_709((128 / 256, 102 / 256, 77 / 256)))

    def test_png_says_what_its_codes_are(self):
        code = 30000
        for name, chunks, value, notes in (
                ("linear", [(b"gAMA", struct.pack(">I", 100000))], code / 65535, ()),
                ("usual", [(b"gAMA", struct.pack(">I", 45455))], linear(code / 65535), ()),
                ("srgb", [(b"gAMA", struct.pack(">I", 45455)), (b"sRGB", b"\0")], linear(code / 65535), ()),
                ("pq", [(b"cICP", bytes((9, 16, 0, 1)))], linear(code / 65535), ("cICP", "transfer 16")),
                ("mac", [(b"gAMA", struct.pack(">I", 55556))], (code / 65535) ** 1.8, ())):
            self.write(name + ".png", coloured_png(64, 32, lambda x, y: (code,) * 3, chunks=chunks))
            self.grey_is(name + ".png", value, notes)
        profile = bytearray(144) + bytes(range(156))   # one tag
        profile[0:4] = struct.pack(">I", len(profile))
        profile[8:24] = bytes((4, 0, 0, 0)) + b"mntrRGB XYZ "
        profile[36:40] = b"acsp"
        profile[68:80] = struct.pack(">3I", 0xf6d6, 0x10000, 0xd32d)
        profile[128:144] = struct.pack(">I4sII", 1, b"desc", 144, 156)
        body = b"Wide\0\0" + zlib.compress(bytes(profile))
        self.write("icc.png", coloured_png(64, 32, lambda x, y: (code,) * 3, chunks=[(b"iCCP", body)]))
        self.grey_is("icc.png", linear(code / 65535), ("iCCP", "Wide"))

    @support.costly
    def test_orientation(self):
        """Of a picture that is bright in its upper left quarter, stored in every way."""
        def at(orientation, x, y):   # of the stored picture, 64 x 32 or 32 x 64: the place in the one that is seen
            w, h = 64, 32
            return {1: (x, y), 2: (w - 1 - x, y), 3: (w - 1 - x, h - 1 - y), 4: (x, h - 1 - y),
                    5: (y, x), 6: (w - 1 - y, x), 7: (w - 1 - y, h - 1 - x), 8: (y, h - 1 - x)}[orientation]

        def value(orientation):
            def pixel(x, y):
                column, row = at(orientation, x, y)
                return ((60000 if column < 32 and row < 16 else 20000) + 100 * column + 10 * row,) * 3
            return pixel
        wanted = None
        for orientation in range(1, 9):
            size = (64, 32) if orientation < 5 else (32, 64)
            for order in "<>":
                self.write("o.png", coloured_png(*size, value(orientation), chunks=[(b"eXIf", exif(orientation, order))]))
                got = self.drawn("o.png", size="8x4", fov=150)
                wanted = wanted or got
                self.assertEqual(got, wanted, orientation)
        for flip, signs in ((1, "-Y 32 +X 64"), (2, "-Y 32 -X 64"), (3, "+Y 32 -X 64"), (4, "+Y 32 +X 64")):
            self.write("o.hdr", hdr(64, 32, lambda x, y: (200 if at(flip, x, y)[0] < 32 and at(flip, x, y)[1] < 16 else 90,) * 3 + (129,), size=signs))
            got = self.drawn("o.hdr", size="8x4", fov=150)
            wanted = got if flip == 1 else wanted
            self.assertEqual(got, wanted, flip)
        self.assertGreater(len({p for row in wanted for p in row}), 1)

    def test_orientation_of_a_jpeg(self):
        self.write("left.png", coloured_png(64, 32, lambda x, y: ((60000 if x < 32 else 9000) if y < 16 else 30000,) * 3))
        self.write("j.toml", '[spacetime]\nmetric = "minkowski"\n[camera]\nr = 30\ntheta = 90\nfov = 120\n[sky]\nkind = "image"\nimage = "left.png"\nyaw = 180.0\n')
        self.run_nullscope("capture", "j.toml", "--size", "64x64", "-o", "as.jpg", "--quality", "100")
        plain = (self.folder / "as.jpg").read_bytes()
        seen = self.drawn("as.jpg", size="16x8", fov=150)
        for orientation in (3, 6):
            body = b"Exif\0\0" + exif(orientation, ">")
            marked = plain[:2] + b"\xff\xe1" + struct.pack(">H", len(body) + 2) + body + plain[2:]
            self.write("o.jpg", marked)
            self.assertNotEqual(self.drawn("o.jpg", size="16x8", fov=150), seen)
            if orientation == 3:   # by half a turn: seen from behind and head over
                got = self.drawn("o.jpg", size="16x8", fov=150, sky="yaw = 0.0")
                for y in range(8):
                    for x in range(16):
                        self.near(got[y][x], seen[7 - y][15 - x], 0.02)
        profile = b"ICC_PROFILE\0\x01\x01" + b"Display P3" * 20
        self.write("p3.jpg", plain[:2] + b"\xff\xe2" + struct.pack(">H", len(profile) + 2) + profile + plain[2:])
        self.drawn("p3.jpg", size="8x4")
        self.assertIn("colour profile", self.notes)
        for across, said in ((4000, False), (2000, True)):
            words = "".join(f'GPano:{key}="{n}" ' for key, n in (("FullPanoWidthPixels", 4000), ("FullPanoHeightPixels", 2000),
                                                                   ("CroppedAreaImageWidthPixels", across), ("CroppedAreaImageHeightPixels", 2000)))
            body = b"http://ns.adobe.com/xap/1.0/\0" + words.encode()
            self.write("part.jpg", plain[:2] + b"\xff\xe1" + struct.pack(">H", len(body) + 2) + body + plain[2:])
            self.drawn("part.jpg", size="8x4")
            self.assertEqual("2000x2000 px of a panorama of 4000x2000 px" in self.notes, said, self.notes)

    def test_header_of_a_radiance_picture(self):
        pixel = lambda x, y: (128, 128, 128, 129)
        self.write("a.hdr", hdr(64, 32, pixel, "EXPOSURE=1.0\nSOFTWARE=x\n"))
        self.grey_is("a.hdr", 1.0)
        self.write("b.hdr", hdr(64, 32, pixel, "EXPOSURE=4.0\n"))
        self.grey_is("b.hdr", 1.0, ["b.hdr", "EXPOSURE=4.0"])

    def test_what_is_no_light(self):
        self.write("n.exr", plain_exr(64, 32, rgb(lambda x, y: -0.5 if x == 0 and y == 0 else 0.7, lambda x, y: float("nan") if y == 0 else 0.7,
                                                  lambda x, y: float("inf") if y == 31 else 0.7)))
        self.near(self.middle("n.exr"), (0.7,) * 3)
        for words in ("1 numbers below 0", "64 numbers that are NaN", "64 infinite numbers"):
            self.assertIn(words, self.notes)

    def test_kinds_of_exr(self):
        half = lambda x, y: 0.5 + (x + y) / 256
        wanted = None
        for name, data in (("lines", plain_exr(64, 32, rgb(half, half, half))), ("tiles", tiled_exr(64, 32, half)),
                           ("mips", tiled_exr(64, 32, half, mipmaps=True)), ("half", tiled_exr(64, 32, half, kind=1, mipmaps=True))):
            self.write("k.exr", data)
            got = self.drawn("k.exr", size="8x4", fov=150)
            wanted = wanted or got
            self.assertEqual(got, wanted, name)
            self.assertEqual(self.notes, "", name)
        self.write("whole.exr", tiled_exr(64, 32, lambda x, y: 3, kind=0))
        self.grey_is("whole.exr", 3.0)

    @support.costly
    def test_codes_of_a_png_of_few_bits(self):
        """A grey of 1, 2, 4 bits, of a palette, with a colour that is clear, interlaced."""
        def few(bits, kind, code, chunks=(), interlaced=0):
            passes = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)) if interlaced else ((0, 0, 1, 1),)
            rows = b""
            for x, y, across, down in passes:
                for _ in range(y, 32, down):
                    text = f"{code:0{bits}b}" * len(range(x, 64, across))
                    rows += b"\0" + bytes(int(text[i:i + 8].ljust(8, "0"), 2) for i in range(0, len(text), 8))
            return png(64, 32, rows, bits, kind, chunks, interlaced)
        for interlaced in (0, 1):
            for bits, code in ((1, 1), (2, 1), (4, 7), (8, 99), (16, 12345)):
                self.write("f.png", few(bits, 0, code, interlaced=interlaced))
                self.grey_is("f.png", linear(code / (2**bits - 1)))
            for bits in (1, 2, 4, 8):
                colours = [(b"PLTE", bytes((9, 9, 9, 77, 77, 77)))]
                self.write("f.png", few(bits, 3, 1, colours, interlaced))
                self.grey_is("f.png", linear(77 / 255))
                self.write("f.png", few(bits, 3, 1, [*colours, (b"tRNS", bytes((255, 128)))], interlaced))
                self.grey_is("f.png", 128 / 255 * linear(77 / 255))
            self.write("f.png", few(4, 0, 7, [(b"tRNS", struct.pack(">H", 7))], interlaced))
            self.grey_is("f.png", 0)

    def test_inks_of_a_jpeg(self):
        """Grey and colours; cyan, magenta, yellow and black as Adobe has them, 255 for none, and as the standard has."""
        self.write("g.jpg", flat_jpeg(64, 32, [99]))
        self.near(self.middle("g.jpg"), (linear(99 / 255),) * 3, 0.02)
        for name, codes, adobe, wanted in (("rgb", (200, 100, 50), 0, (200, 100, 50)), ("adobe", (200, 100, 50, 204), 0, (160, 80, 40)),
                                           ("plain", (55, 155, 205, 51), None, (160, 80, 40))):
            self.write(name + ".jpg", flat_jpeg(64, 32, codes, adobe))
            self.near(self.middle(name + ".jpg"), [linear(v / 255) for v in wanted], 0.02)
        whole = flat_jpeg(64, 32, (200, 100, 50), 0)
        self.write("cut.jpg", whole[:-20] + whole[-2:])   # and an end all the same
        self.refused_image("cut.jpg", [])

    def test_runs_of_an_old_radiance_picture(self):
        """A pixel of (1, 1, 1, n) stands for the one before it n times, several of them in a row for digits to the base of 256."""
        def row(y):
            return bytes((128, 100 + y, 64, 129)) + bytes((1, 1, 1, 44, 1, 1, 1, 1))   # 1 + 44 + 256 = 301 px
        self.write("old.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 301\n" + b"".join(row(y) for y in range(32)))
        for x, pixel in enumerate(self.drawn("old.hdr", size="8x4")[1]):
            self.near(pixel[::2], (1.0, 0.5))
            self.assertTrue(100 / 128 < pixel[1] < 132 / 128, pixel)
        for cut in (b"\x01\x01\x01\x05" * 32, bytes((128, 128, 128, 129)) + b"\x01\x01\x01\xff\x01\x01\x01\xff"):
            self.write("bad.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 301\n" + cut)
            self.refused_image("bad.hdr", ["cut off or damaged"])


if __name__ == "__main__":
    support.main()
