#!/usr/bin/env python3
"""Films of a simulation's dumps (medium.file with a placeholder): pictures, light curves, workers, what they say of themselves, memory, errors."""
import hashlib
import json
import math
import os
import struct
import subprocess

import support

FILM = """time = 10
[camera]
r = 30
fov = 26
size = [16, 9]
[spacetime]
metric = "schwarzschild"
[object]
mass_suns = 4.3e6
[sky]
kind = "black"
[medium]
kind = "grid"
file = "flow-%05d.grid"
outer = 8
emissivity = 1e-18
steps = 32
"""
TIMES = "cadence = 2.5\nstart = 10\n"
DUMPS = 6


def grid(dump, nodes=(8, 5, 8), head=""):
    """A spot that moves, as a file."""
    rings, polar, around = nodes
    data = bytearray()
    for i in range(rings):
        r = 1.1 * (8.5 / 1.1) ** (i / (rings - 1))
        for j in range(polar):
            theta = 0.1 + 2.9 * j / (polar - 1)
            for k in range(around):
                off = math.sin(theta) * math.cos(2 * math.pi * k / around - 0.7 * dump) * r - 4
                data += struct.pack("<8f", math.exp(-0.2 * off * off), 1e4, 0, 0, 0, 0, 0, 0.3)
    return (f"nullscope-medium 1\ncoordinates kerr-schild\nspin 0\nr 1.1 8.5 {rings}\ntheta 0.1 3.0 {polar}\nphi 0 {around}\n{head}data\n"
            .encode() + bytes(data))


class Dumps(support.CliTest):
    def setUp(self):
        super().setUp()
        for dump in range(DUMPS):
            self.write(f"flow-{dump + 3:05d}.grid", grid(dump, head=f"source dump {dump}\n"))
        self.write("film.toml", FILM + TIMES)

    def picture_texts(self, file):
        """The texts of a PNG."""
        data, texts, at = (self.folder / file).read_bytes(), {}, 8
        while at < len(data):
            length, = struct.unpack(">I", data[at:at + 4])
            kind, body = data[at + 4:at + 8], data[at + 8:at + 8 + length]
            if kind == b"iTXt":
                keyword, rest = body.split(b"\0", 1)
                texts[keyword.decode()] = rest[2:].split(b"\0", 2)[2].decode()
            elif kind == b"tEXt":
                keyword, text = body.split(b"\0", 1)
                texts[keyword.decode()] = text.decode("latin-1")
            at += 12 + length
        return texts

    def pixels(self, file):
        return support.read_exr((self.folder / file).read_bytes())

    def test_frames_are_those_of_the_files(self):
        self.run_nullscope("capture", "film.toml", "--frames", f"0:{DUMPS}", "--time-step", 2.5, "-o", "f%d.exr")
        for dump in range(DUMPS):
            self.write("one.toml", FILM.replace("%05d", f"{dump + 3:05d}"))
            self.run_nullscope("capture", "one.toml", "-o", "one.exr")
            self.assertEqual(self.pixels(f"f{dump}.exr"), self.pixels("one.exr"))
            self.assertGreater(max(max(row) for row in self.pixels("one.exr")["R"]), 0)
        self.assertNotEqual(self.pixels("f0.exr"), self.pixels("f1.exr"))
        self.run_nullscope("capture", "film.toml", "--renderer", "reference", "--samples", 1, "--frames", "1:2", "--time-frame", 0, "--time-step", 2.5, "-o", "r%d.exr")
        self.write("one.toml", FILM.replace("%05d", "00004"))
        self.run_nullscope("capture", "one.toml", "--renderer", "reference", "--samples", 1, "-o", "one.exr")
        self.assertEqual(self.pixels("r1.exr"), self.pixels("one.exr"))

    def test_workers_and_machines_draw_the_same(self):
        range_of = ["--frames", f"0:{2 * DUMPS - 1}", "--time-step", 1.25]
        self.run_nullscope("capture", "film.toml", *range_of, "-o", "a%d.png")
        self.run_nullscope("capture", "film.toml", *range_of, "--workers", 2, "-o", "b%d.png")
        for line in self.run_nullscope("frames", "film.toml", f"0:{2 * DUMPS - 1}", "--chunk", 4, "-o", "c%d.png", "--commands", "--", "--time-step", 1.25).out.splitlines():
            self.run_nullscope(*line.split()[1:])
        for frame in range(2 * DUMPS - 1):
            wanted = (self.folder / f"a{frame}.png").read_bytes()
            self.assertEqual((self.folder / f"b{frame}.png").read_bytes(), wanted)
            self.assertEqual((self.folder / f"c{frame}.png").read_bytes(), wanted)
        # Another dump, and what was drawn of the one before is not continued.
        self.run_nullscope("capture", "film.toml", "--frames", "0:1", "--time-step", 1.25, "--resume", "-o", "d%d.png")
        self.write("flow-00005.grid", grid(9))
        self.refused("capture", "film.toml", "--frames", "0:2", "--time-step", 1.25, "--resume", "-o", "d%d.png", says=["different medium.file"])

    def test_a_picture_names_the_dumps_about_its_time(self):
        def line(dump):
            name = f"flow-{dump:05d}.grid"
            return f"{hashlib.sha256((self.folder / name).read_bytes()).hexdigest()}  {name}"
        self.run_nullscope("capture", "film.toml", "--time", 13.75, "-o", "a.png")
        texts = self.picture_texts("a.png")
        self.assertEqual(texts["nullscope.files"].splitlines(), [line(4), line(5)])
        self.assertIn("source dump 2", texts["nullscope.grid_head"])
        for wanted in ('file = "flow-%05d.grid"', "first = 3", "last = 8", "cadence = 2.5", "start = 10", "time = 13.75"):
            self.assertIn(wanted, texts["nullscope.scene_text"])
        self.run_nullscope("capture", "film.toml", "--time", 15, "-o", "b.png")
        self.assertEqual(self.picture_texts("b.png")["nullscope.files"].splitlines(), [line(5)])
        # The scene again, of the picture; a dump that has changed since is said, and one that does not count is not.
        self.run_nullscope("capture", "a.png", "-o", "again.png")
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "again.png").read_bytes())
        self.write("flow-00005.grid", grid(9))
        self.write("flow-00008.grid", grid(9))
        said = self.run_nullscope("capture", "a.png", "-o", "again.png").said()
        self.assertIn("flow-00005.grid\" is not the file that the picture was drawn from", said)
        self.assertNotIn("flow-00008", said)
        # Sub-frames: all that they show.
        self.write("blur.toml", FILM + TIMES + "[picture]\nshutter = 1\nsub_frames = 4\n")
        self.run_nullscope("capture", "blur.toml", "--time", 16.25, "--time-step", 5, "-o", "c.png")
        self.assertEqual([each.split("  ")[1] for each in self.picture_texts("c.png")["nullscope.files"].splitlines()],
                         [f"flow-0000{dump}.grid" for dump in (4, 5, 6, 7)])

    def test_paths_layers_halves_and_eyes(self):
        self.write("path.toml", FILM + TIMES + '[path]\nkind = "keys"\n[[path.key]]\n[[path.key]]\nframe = 2\ntime = 12.5\n')
        self.run_nullscope("capture", "path.toml", "-o", "p%d.exr")
        self.write("late.toml", (self.folder / "path.toml").read_text().replace("time = 12.5", "time = 13"))
        self.refused("capture", "late.toml", "-o", "q%d.exr", says=["late.toml: frame 2: time 23 is not between"])
        # After the last dump there is no next frame to move to.
        self.run_nullscope("capture", "film.toml", "--layers", "--frames", "4:6", "--time-frame", 0, "--time-step", 2.5, "-o", "l%d.exr")
        self.run_nullscope("capture", "film.toml", "--time", 22.5, "-o", "last.exr")
        self.assertEqual(self.pixels("p2.exr"), self.pixels("last.exr"))
        for more in ('[split]\nmetric = "minkowski"\n', ""):
            self.write("two.toml", (FILM + TIMES + more).replace("fov = 26", "fov = 26" if more else 'fov = 26\nstereo = "pair"'))
            self.run_nullscope("capture", "two.toml", "--time", 12, "-o", "two.png")
            self.refused("capture", "two.toml", "--time", 23, "-o", "three.png", says=["time 23 is not between"])

    def test_a_light_curve_goes_to_the_last_dump(self):
        out = self.run_nullscope("lightcurve", "film.toml", "--steps", DUMPS, "-o", "curve").out
        self.assertIn(f"{DUMPS} times from 10 to 22.5 r_s/c", out)
        rows = [[float(word) for word in row.split(",")] for row in (self.folder / "curve.csv").read_text().splitlines()[1:]]
        self.assertEqual([row[0] for row in rows], [10 + 2.5 * dump for dump in range(DUMPS)])
        self.assertEqual(len({row[1] for row in rows}), DUMPS)
        self.assertIn(f"flow-0000{DUMPS + 2}.grid", (self.folder / "curve.svg").read_text())
        self.refused("lightcurve", "film.toml", "--from", 10, "--to", 23, "-o", "other", says=["time 23 is not between", "[10, 22.5] r_s/c"])

    def test_a_plan_says_how_many(self):
        out = self.run_nullscope("plan", "film.toml").out
        self.assertIn('"flow-%05d.grid": 6 dumps, 3 to 8, at times [10, 22.5] r_s/c', out)
        self.assertNotIn("EFFECT_DELAY", out)
        self.assertRegex(out, r"\n  medium dumps +\S+ x +\d+ x +\d+ +30\.0 KiB +host  6 dumps")
        effects = {each["effect"] for each in json.loads(self.run_nullscope("plan", "film.toml", "--json").out)["effects"]}
        self.assertIn("medium-grid", effects)
        self.assertTrue(effects.isdisjoint({"delay", "light-times", "medium-motion"}), effects)

    def test_what_is_refused(self):
        capture = ["capture", "film.toml", "-o", "f%d.png"]
        self.refused(*capture, "--frames", "0:7", "--time-step", 2.5, says=["frame 6: time 25 is not between the dumps of medium.file", "allowed: [10, 22.5] r_s/c, of dumps 3 to 8"])
        self.refused("capture", "film.toml", "--time", 9, "-o", "a.png", says=["time 9 is not between", "[10, 22.5]"])
        self.write("late.toml", FILM.replace("time = 10", "time = 23") + TIMES)
        self.refused("plan", "late.toml", says=["late.toml:1: time: 23 is not between", "[10, 22.5]"])
        self.write("blur.toml", FILM + TIMES + "[picture]\nshutter = 1\n")
        self.refused("capture", "blur.toml", "--frames", "0:2", "--time-step", 2.5, "-o", "f%d.png", says=["frame 0: time ", "is not between"])
        (self.folder / "flow-00006.grid").rename(self.folder / "aside")
        self.refused(*capture, "--frames", "0:2", "--time-step", 2.5,
                     says=["film.toml:", "medium.file: there is no file \"flow-00006.grid\"", "allowed: all of \"flow-00003.grid\" to \"flow-00008.grid\""])
        self.write("flow-00006.grid", grid(3, nodes=(8, 5, 4)))
        self.refused(*capture, "--frames", "0:2", "--time-step", 2.5, says=["medium.file", "\"flow-00006.grid\" has other nodes of phi than \"flow-00003.grid\""])

    @support.costly
    def test_memory_does_not_grow_with_the_number_of_dumps(self):
        """Twice the dumps, and no more at once."""
        nodes = (96, 64, 64)   # 12.6 MB
        for dump in range(12):
            self.write(f"large-{dump}.grid", self.large(dump, nodes))
        self.write("large.toml", FILM.replace("time = 10", "time = 0").replace("flow-%05d", "large-%d") + "cadence = 1\n")

        def most(frames):
            """Bytes."""
            arguments = [support.BINARY, "capture", "large.toml", "--renderer", "reference", "--samples", "1", "--size", "2x2", "--frames",
                         f"0:{frames}", "--time-step", "0.5", "-o", f"m{frames}-%d.png"]
            process = subprocess.Popen(arguments, cwd=self.folder, stdout=subprocess.DEVNULL)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(process.returncode, 0)
            return 1024 * usage.ru_maxrss
        few, many, dump = most(4), most(23), 32 * math.prod(nodes)
        self.assertLess(many - few, 1.5 * dump, f"{few} bytes for 3 dumps, {many} for 12, of {dump} each")

    def large(self, dump, nodes):
        rings, polar, around = nodes
        return (f"nullscope-medium 1\ncoordinates kerr-schild\nspin 0\nr 1.1 8.5 {rings}\ntheta 0.1 3.0 {polar}\nphi 0 {around}\ndata\n".encode()
                + struct.pack("<8f", 1 + dump, 1e4, 0, 0, 0, 0, 0, 0.3) * math.prod(nodes))


if __name__ == "__main__":
    support.main()
