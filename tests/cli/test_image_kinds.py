#!/usr/bin/env python3
"""TGA, BMP, PNM and PSD files, written here byte by byte, arrive as the pixels of a PNG of the same codes; cut off or odd, they are refused."""
import struct

import support
import test_image_files
import test_image_light
from test_image_light import coloured_png, linear

W, H = 37, 21


def code(x, y):
    return (7 * x + y) % 256, 11 * y % 256, x * y % 256


def clear(x, y):
    return (*code(x, y), (6 * x + y) % 255 + 1)


def runs(values):
    """TGA's: of equal neighbours, else one by one."""
    out, at = b"", 0
    while at < len(values):
        count = 1
        while at + count < len(values) and count < 128 and values[at + count] == values[at]:
            count += 1
        out += bytes((127 + count if count > 1 else 0,)) + values[at]
        at += count
    return out


def tga(value=code, kind=2, bits=24, flags=0x20, packed=False, palette=b"", first=0):
    """flags: 0x20 from the top, 0x10 from the right. value: red, green, blue (, alpha), or a number."""
    places = [(x, y) for y in (range(H) if flags & 0x20 else reversed(range(H))) for x in (reversed(range(W)) if flags & 0x10 else range(W))]
    def stored(v):
        return bytes((v,)) if isinstance(v, int) else bytes((v[2], v[1], v[0], *v[3:]))
    values = [stored(value(x, y)) for x, y in places]
    head = struct.pack("<BBBHHBHHHHBB", 2, 1 if palette else 0, kind + (8 if packed else 0), first, len(palette) // 3, 24 if palette else 0, 0, 0, W, H, bits, flags)
    return head + b"id" + palette + (runs(values) if packed else b"".join(values))


def bmp(value=code, bits=24, from_top=False, palette=b"", space=None):
    lines = []
    for y in range(H) if from_top else reversed(range(H)):
        line = b"".join(bytes((v,)) if isinstance(v, int) else bytes((v[2], v[1], v[0], *v[3:])) for v in (value(x, y) for x in range(W)))
        lines.append(line + bytes(-len(line) % 4))
    head = struct.pack("<iiHHIIiiII", W, -H if from_top else H, 1, bits, 0, 0, 0, 0, len(palette) // 4, 0)
    if space:   # version 4: masks, the space's name, its end points and gamma
        head += struct.pack("<IIII", 0xff0000, 0xff00, 0xff, 0) + space + bytes(48)
    head = struct.pack("<I", len(head) + 4) + head
    at = 14 + len(head) + len(palette)
    body = b"".join(lines)
    return b"BM" + struct.pack("<IHHI", at + len(body), 0, 0, at) + head + palette + body


def pnm(kind, most, value, blank=b"\n"):
    size = ">H" if most > 255 else ">B"
    body = b"".join(struct.pack(size, v) for y in range(H) for x in range(W) for v in value(x, y))
    return f"P{kind}\n# by hand\n{W} {H}#\n {most}".encode() + blank + body


def packbits(line):
    """Runs where four or more bytes are equal, the others as one piece each."""
    out, at = b"\x80", 0   # which is nothing
    while at < len(line):
        same = next((n for n in range(1, min(128, len(line) - at)) if line[at + n] != line[at]), min(128, len(line) - at))
        if same >= 4:
            out, at = out + bytes((257 - same, line[at])), at + same
            continue
        end = at + 1
        while end < len(line) and end - at < 128 and len(set(line[end:end + 4])) > 1:
            end += 1
        out, at = out + bytes((end - at - 1,)) + line[at:end], end
    return out


def psd(value=code, bits=8, channels=3, packed=False, mode=3, resources=b""):
    head = b"8BPS" + struct.pack(">H6xHIIHH", 1, channels, H, W, bits, mode) + struct.pack(">I", 0) + struct.pack(">I", len(resources)) + resources + struct.pack(">I", 0)
    lines = [b"".join(struct.pack(">B" if bits == 8 else ">H", value(x, y)[c]) for x in range(W)) for c in range(channels) for y in range(H)]
    if not packed:
        return head + struct.pack(">H", 0) + b"".join(lines)
    lines = [packbits(line) for line in lines]
    return head + struct.pack(">H", 1) + b"".join(struct.pack(">H", len(line)) for line in lines) + b"".join(lines)


def grey(x, y):
    return (code(x, y)[0],) * 3


class ImageKinds(support.CliTest):
    drawn, near, middle = test_image_light.ImageLight.drawn, test_image_light.ImageLight.near, test_image_files.ImageFiles.middle
    grey_is, refused_image = test_image_files.ImageFiles.grey_is, test_image_files.ImageFiles.refused_image

    def is_png(self, name, data, value=code, bits=8):
        """To a millionth of the way from black to white."""
        self.write(name, data)
        self.write("same.png", coloured_png(W, H, value, bits))
        out = self.run_nullscope("compare", name, "same.png").out
        self.assertLess(float(out.split("difference      max ")[1].split()[0]), 1e-6, f"{name}: {out}")

    def test_tga(self):
        table = bytes(v for i in range(256) for v in (i, 255 - i, 3 * i % 256))   # blue, green, red
        index = lambda x, y: (x + 2 * y) % 256
        for packed in (False, True):
            for flags in (0, 0x10, 0x20, 0x30):
                self.is_png("a.tga", tga(flags=flags, packed=packed))
            self.is_png("g.tga", tga(lambda x, y: code(x, y)[0], 3, 8, packed=packed), grey)
            self.is_png("p.tga", tga(index, 1, 8, packed=packed, palette=table), lambda x, y: (3 * index(x, y) % 256, 255 - index(x, y), index(x, y)))
        self.write("alpha.tga", tga(lambda x, y: (200, 200, 200, 128), bits=32))
        self.grey_is("alpha.tga", 128 / 255 * linear(200 / 255))
        self.write("late.tga", tga(index, 1, 8, palette=table, first=3))
        self.refused_image("late.tga", ["palette"])
        self.write("woven.tga", tga(flags=0x60))
        self.refused_image("woven.tga", ["interleaved"])

    def test_bmp(self):
        table = bytes(v for i in range(256) for v in (i, 255 - i, 3 * i % 256, 0))
        index = lambda x, y: (x + 2 * y) % 256
        for from_top in (False, True):
            self.is_png("a.bmp", bmp(from_top=from_top))
        self.is_png("b.bmp", bmp(lambda x, y: (*code(x, y), 0), 32))
        self.is_png("p.bmp", bmp(index, 8, palette=table), lambda x, y: (3 * index(x, y) % 256, 255 - index(x, y), index(x, y)))
        for space, notes in ((b"BGRs", ()), (b"\0\0\0\0", ["s.bmp", "colour space"])):
            self.write("s.bmp", bmp(lambda x, y: (77, 77, 77), space=space))
            self.grey_is("s.bmp", linear(77 / 255), notes)
        for head in (struct.pack("<i", -2**31), struct.pack("<i", 2**31 - 1)):
            self.write("huge.bmp", bmp()[:22] + head + bmp()[26:])
            self.refused_image("huge.bmp", ["pixels"])
        self.write("packed.bmp", bmp()[:30] + struct.pack("<I", 1) + bmp()[34:])
        self.refused_image("packed.bmp", ["BMP", "not compressed"])

    def test_pnm(self):
        self.is_png("a.ppm", pnm(6, 255, code))
        self.is_png("b.ppm", pnm(6, 255, code, b" "))
        self.is_png("a.pgm", pnm(5, 255, lambda x, y: code(x, y)[:1]), grey)
        wide = lambda x, y: [251 * v + 3 for v in code(x, y)]
        self.is_png("w.ppm", pnm(6, 65535, wide), wide, 16)
        tens = lambda x, y: [v // 26 for v in code(x, y)]   # of 10: 1/10 is 6553.5 of 65535
        self.is_png("few.ppm", pnm(6, 15, tens), lambda x, y: [17 * v for v in tens(x, y)])
        for name, data in (("over.pgm", pnm(5, 200, lambda x, y: (201,))), ("wide.pgm", pnm(5, 65536, lambda x, y: (1,))), ("long.pgm", b"P5 99999999999 1 255\n ")):
            self.write(name, data)
            self.refused_image(name, ["PNM"])
        for kind, most, value, meant in ((3, 255, code, code), (2, 255, lambda x, y: code(x, y)[:1], grey), (3, 15, tens, lambda x, y: [17 * v for v in tens(x, y)])):
            text = f"P{kind} {W} {H} # as text\n{most}\n" + "\n# a line\n".join(" ".join(str(v) for x in range(W) for v in value(x, y)) for y in range(H))
            self.is_png("text.pnm", text.encode(), meant)
            self.write("text.pnm", text.encode()[:-3])
            self.refused_image("text.pnm", ["PNM's number"])
        for name, numbers in (("minus.pgm", b"-1 2"), ("over.pgm", b"7 256"), ("word.pgm", b"7 x"), ("short.pgm", b"7")):
            self.write(name, b"P2 2 1 255\n" + numbers)
            self.refused_image(name, [])
        self.write("bits.pbm", b"P1 2 1\n0 1\n")
        self.refused_image("bits.pbm", ["not a PNG"])

    def test_psd(self):
        for packed in (False, True):
            self.is_png("a.psd", psd(packed=packed))
            self.write("four.psd", psd(lambda x, y: (77, 99, 11, 3), channels=4, packed=packed))
            self.near(self.middle("four.psd"), [linear(v / 255) for v in (77, 99, 11)])
            self.assertIn("channels beside", self.notes)
        wide = lambda x, y: [251 * v + 3 for v in code(x, y)]
        self.is_png("w.psd", psd(wide, 16), wide, 16)
        self.write("i.psd", psd(lambda x, y: (77, 77, 77), resources=b"8BIM" + struct.pack(">HHI", 0x40f, 0, 4) + b"wide"))
        self.grey_is("i.psd", linear(77 / 255), ["i.psd", "colour profile"])
        self.write("inks.psd", psd(lambda x, y: (9, 9, 9, 9), channels=4, mode=4))
        self.refused_image("inks.psd", ["PSD", "RGB"])
        self.is_png("deep.psd", psd(wide, 16, packed=True), wide, 16)
        same = lambda x, y: [251 * (v // 64) for v in code(x // 8, y)]
        self.is_png("runs.psd", psd(same, 16, packed=True), same, 16)
        self.write("more.psd", psd(lambda x, y: (20000, 30000, 40000, 9), 16, channels=4, packed=True))
        self.near(self.middle("more.psd"), [linear(v / 65535) for v in (20000, 30000, 40000)])
        whole, at = psd(wide, 16, packed=True), 40 + 2 * 3 * H   # of the first row
        for name, data in (("short.psd", whole[:-1]), ("table.psd", whole[:60]), ("row.psd", whole[:at] + b"\x05" + whole[at + 1:]),
                           ("wide.psd", whole[:18] + struct.pack(">I", W + 1) + whole[22:])):
            self.write(name, data)
            self.refused_image(name, [])
        zipped = psd()
        self.write("zip.psd", zipped[:38] + b"\0\2" + zipped[40:])
        self.refused_image("zip.psd", ["ZIP"])

    def test_what_is_cut_off_or_too_large_is_refused(self):
        for name, data in (("a.tga", tga()), ("r.tga", tga(packed=True)), ("a.bmp", bmp()), ("a.ppm", pnm(6, 255, code)), ("a.psd", psd()), ("r.psd", psd(packed=True))):
            for size in (len(data) - 1, len(data) // 2):
                self.write(name, data[:size])
                self.refused_image(name, [])
        self.write("big.tga", tga()[:12] + struct.pack("<HH", 65535, 65535) + tga()[16:])
        self.refused_image("big.tga", ["65535 x 65535"])
        self.write("big.psd", psd()[:14] + struct.pack(">II", 20000, 20000) + psd()[22:])
        self.refused_image("big.psd", ["20000 x 20000"])
        self.write("big.ppm", b"P6 900000 900000 255\n")
        self.refused_image("big.ppm", ["900000 x 900000"])


if __name__ == "__main__":
    support.main()
