#!/usr/bin/env python3
"""Layers, ST maps and motion vectors, as files: their channels, and what is in them."""
import struct
import zlib

import support


def read_floats(data):
    """The channels of a single-part ZIP EXR of 32-bit floats: name -> rows of values."""
    kinds, (width, height), at = support.exr_header(data)
    names = [name for name, _ in kinds]
    at += 8 * -(-height // 16)
    channels = {name: [] for name in names}
    for top in range(0, height, 16):
        rows = min(16, height - top)
        (length,) = struct.unpack("<i", data[at + 4:at + 8])
        packed = data[at + 8:at + 8 + length]
        at += 8 + length
        whole = 4 * width * rows * len(names)
        if length < whole:   # as OpenEXR's ZIP: differences, of even and odd bytes
            plain = bytearray(zlib.decompress(packed))
            for i in range(1, len(plain)):
                plain[i] = (plain[i - 1] + plain[i] - 128) & 255
            half = (len(plain) + 1) // 2
            packed = bytearray(len(plain))
            packed[0::2], packed[1::2] = plain[:half], plain[half:]
        values = struct.unpack(f"<{whole // 4}f", packed)
        for row in range(rows):
            for number, name in enumerate(names):
                first = (row * len(names) + number) * width
                channels[name].append(values[first:first + width])
    return channels


class Layers(support.CliTest):
    def channels(self, *words):
        self.run_nullscope("capture", *words)
        return read_floats((self.folder / words[words.index("-o") + 1]).read_bytes())

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
        self.assertEqual(max(map(max, got["forward.known"])) if "forward.known" in got else 0, 0)
        depth, hit = got["depth.affine"], got["hit"]
        for y, row in enumerate(hit):
            for x, number in enumerate(row):
                self.assertTrue(5 < depth[y][x] < 40 if number else depth[y][x] == 0, (x, y, depth[y][x]))

    def test_motion_of_a_camera_that_turns(self):
        """By a degree a frame: a pixel in the middle moves by (width/2)/tan(fov/2) of that in rad."""
        self.write("turn.toml", '[spacetime]\nmetric = "minkowski"\n[camera]\nr = 20\ntheta = 90\nfov = 60\n[path]\nkind = "keys"\n'
                   "[[path.key]]\nyaw = 0\n[[path.key]]\nframe = 10\nyaw = 10\n")
        self.run_nullscope("capture", "turn.toml", "--size", "64x36", "--layers", "--frames", "0:1", "-o", "m%d.exr")
        got = read_floats((self.folder / "m0.exr").read_bytes())
        self.assertEqual(got["forward.known"][18][32], 1)
        self.assertAlmostEqual(got["forward.u"][18][32], -32 * 3 ** 0.5 * 3.14159265 / 180, delta=0.01)
        self.assertAlmostEqual(got["forward.v"][18][32], 0, delta=0.01)

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
