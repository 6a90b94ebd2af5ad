#!/usr/bin/env python3
"""capture --colour: the colours of an EXR in ACEScg's primaries, or as they are displayed; against formulas written here."""
import struct

import support
from image_bytes import exr_attributes
from test_image_light import linear
from test_provenance import words_of_png

SIZE = ("--size", "48x27")
REC709 = ((0.64, 0.33), (0.30, 0.60), (0.15, 0.06), (0.3127, 0.3290))
AP1 = ((0.713, 0.293), (0.165, 0.830), (0.128, 0.044), (0.32168, 0.33767))
BRADFORD = ((0.8951, 0.2664, -0.1614), (-0.7502, 1.7135, 0.0367), (0.0389, -0.0685, 1.0296))


def times(m, n):
    return [[sum(m[i][k] * n[k][j] for k in range(3)) for j in range(len(n[0]))] for i in range(3)]


def inverse(m):
    """By Cramer's rule."""
    minor = lambda i, j: (m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] - m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3])
    whole = sum(m[0][j] * minor(0, j) for j in range(3))
    return [[minor(j, i) / whole for j in range(3)] for i in range(3)]


def diagonal(column):
    return [[column[i][0] if i == j else 0 for j in range(3)] for i in range(3)]


def xyz(primaries):
    columns = [(x / y, 1, (1 - x - y) / y) for x, y in primaries]
    unit = [[c[i] for c in columns[:3]] for i in range(3)]
    white = [[v] for v in columns[3]]
    return times(unit, diagonal(times(inverse(unit), white))), times(BRADFORD, white)


def to_ap1():
    """SMPTE RP 177 for the primaries, Bradford's cones for the whites."""
    (one, white), (other, other_white) = xyz(REC709), xyz(AP1)
    adapted = times(inverse(BRADFORD), times(diagonal([[b[0] / a[0]] for a, b in zip(white, other_white)]), BRADFORD))
    return times(inverse(other), times(adapted, one))


class Colour(support.CliTest):
    def drawn(self, name, *words, scene="kerr"):
        self.run_nullscope("capture", scene, *SIZE, *words, "-o", name)
        return support.read_exr((self.folder / name).read_bytes())

    def is_converted(self, got, plain, layer="", tolerance=1e-6):
        for rows in zip(*(got[layer + c] for c in "RGB"), *(plain[layer + c] for c in "RGB")):
            for pixel in zip(*rows):
                wanted = [v[0] for v in times(to_ap1(), [[v] for v in pixel[3:]])]
                for one, other in zip(pixel, wanted):
                    self.assertAlmostEqual(one, other, delta=tolerance * max(1, *map(abs, wanted)))

    def test_the_matrix_is_the_one_that_is_published(self):
        """As in ACES' own configuration of OpenColorIO, to its seven digits."""
        published = ((0.6130974, 0.3395231, 0.0473795), (0.0701937, 0.9163539, 0.0134524), (0.0206156, 0.1095698, 0.8698146))
        for row, wanted in zip(to_ap1(), published):
            for one, other in zip(row, wanted):
                self.assertAlmostEqual(one, other, delta=1e-7)

    @support.costly
    def test_acescg(self):
        plain, got = self.drawn("plain.exr", "--layers"), self.drawn("a.exr", "--layers", "--colour", "acescg")
        layers = [name[:-1] for name in plain if name == "R" or name.endswith(".R")]
        self.assertIn("disc0.", layers)
        for layer in layers:
            self.is_converted(got, plain, layer)
        for name in plain:
            if name.split(".")[-1] not in ("R", "G", "B"):
                self.assertEqual(got[name], plain[name], name)
        kind, body = exr_attributes((self.folder / "a.exr").read_bytes())[0]["chromaticities"]
        self.assertEqual((kind, struct.unpack("<8f", body)), ("chromaticities", struct.unpack("<8f", struct.pack("<8f", *(v for p in AP1 for v in p)))))
        self.assertNotIn("chromaticities", exr_attributes((self.folder / "plain.exr").read_bytes())[0])
        self.drawn("b.exr", "--colour", "acescg"), self.drawn("c.exr")
        said = self.run_nullscope("compare", "b.exr", "c.exr").out   # a reader that looks at the primaries
        self.assertLess(float(said.split("difference      max ")[1].split()[0]), 1e-5, said)
        self.run_nullscope("capture", "a.exr", "-o", "again.exr")
        self.assertEqual((self.folder / "again.exr").read_bytes(), (self.folder / "a.exr").read_bytes())
        self.is_converted(self.drawn("h.exr", "--half", "--colour", "acescg"), plain, tolerance=1e-3)

    @support.costly
    def test_display(self):
        """What a PNG of 16 bits shows: exposure, tone curve, bloom, labels; of the reference too."""
        self.write("split.toml", '[camera]\nr = 8\n[sky]\nkind = "stars"\n[split]\nmetric = "kerr"\n[picture]\nbloom = 0.2\n')
        for scene, words in (("first-light", []), ("split.toml", []), ("flat", ["--renderer", "reference", "--samples", "1"])):
            got = self.drawn("d.exr", "--colour", "display", *words, scene=scene)
            self.run_nullscope("capture", scene, *SIZE, *words, "--bits", "16", "-o", "d.png")
            shown = [linear(word / 65535) for word in words_of_png((self.folder / "d.png").read_bytes())]
            flat = [v for rows in zip(got["R"], got["G"], got["B"]) for pixel in zip(*rows) for v in pixel]
            for one, other in zip(flat, shown, strict=True):
                self.assertAlmostEqual(one, other, delta=1e-6)
            self.assertGreater(max(flat), 0.1)
        self.drawn("d.exr", "--colour", "display", scene="split.toml")
        self.run_nullscope("capture", "d.exr", "-o", "again.exr")
        self.assertEqual((self.folder / "again.exr").read_bytes(), (self.folder / "d.exr").read_bytes())

    def test_what_has_no_such_colours(self):
        for words, says in ((("--colour", "acescg", "-o", "a.png"), "-o FILE.exr"), (("--colour", "acescg", "--st-map", "sky", "-o", "a.exr"), "--st-map"),
                            (("--colour", "display", "--layers", "-o", "a.exr"), "acescg"), (("--colour", "display", "--raydata", "-o", "a.exr"), "acescg"),
                            (("--colour", "srgb", "-o", "a.exr"), "display")):
            self.refused("capture", "kerr", *SIZE, *words, says=["--colour", says])


if __name__ == "__main__":
    support.main()
