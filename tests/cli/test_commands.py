#!/usr/bin/env python3
"""Every subcommand answers --help, and good runs give complete, valid files."""
import csv
import json
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import unittest
import zlib
from pathlib import Path
from xml.etree import ElementTree

import support
from image_bytes import png, png_chunks

COMMANDS = ["capture", "trace", "compare", "bench", "bench frames", "bench hard", "bench metrics", "bench pictures", "bench rays", "bench soak", "plan", "scenes", "info", "devices", "figure", "fit", "path", "study", "flux", "lightcurve", "light-time", "profile", "spectrum", "visibility", "landmarks", "manual"]


def png_size(data):
    """Width and height of a PNG whose chunks are whole and whose pixels are all there."""
    pixels = b""
    for kind, body in png_chunks(data):
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
            channels = {2: 3, 6: 4}[body[9]]
        pixels += body if kind == b"IDAT" else b""
    if kind != b"IEND" or len(zlib.decompress(pixels)) != size[1] * (1 + channels * size[0]):
        raise ValueError("pixels are missing")
    return size


def read_exr(data):
    """Channels (name -> kind), data window's size and the blocks of pixels of a single-part ZIP EXR."""
    channels, size, at = support.exr_header(data)
    blocks = -(-size[1] // 16)   # ZIP packs 16 rows together; a table of their places goes before them
    return dict(channels), size, data[at + 8 * blocks:]


class Commands(support.CliTest):
    def test_help(self):
        for command in [""] + COMMANDS:
            ran = self.run_nullscope(*command.split(), "--help")
            self.assertIn("Usage: nullscope", ran.out)
            self.assertEqual(ran.err, "")

    def test_help_of_a_command_and_alone(self):
        alone = self.run_nullscope().out
        self.assertEqual(alone, self.run_nullscope("--help").out)
        self.assertEqual(alone, self.run_nullscope("help").out)
        self.assertIn("nullscope-viewer", alone)
        self.assertEqual(self.run_nullscope("help", "bench", "frames").out, self.run_nullscope("bench", "frames", "--help").out)

    @support.costly
    def test_names_of_a_sequence(self):
        for pattern, name in (("a%05d.png", "a00002.png"), ("b%d.png", "b2.png"), ("c%03d.png", "c002.png"), ("d##.png", "d02.png")):
            self.run_nullscope("capture", "flat", "--size", "4x2", "--frames", "2:3", "--time", "-5", "-o", pattern)
            self.assertTrue((self.folder / name).exists(), pattern)

    def test_version(self):
        self.assertRegex(self.run_nullscope("--version").out, r"^\d+\.\d+\.\d+( \([0-9a-f]{12}(, changed)?\))?$")

    def test_credits(self):
        for name in ("Axel Mellinger", "proper credit", "Hipparcos", "d3-celestial"):
            self.assertIn(name, self.run_nullscope("--credits").out)

    TABLES = ("deflection table", "strip", "ray ends", "orbit table", "light-time table", "star lens", "ball paths", "black body", "disc flow", "disc warp", "medium grid")

    @support.costly
    def test_scenes_are_listed_and_planned(self):
        lines = self.run_nullscope("scenes").out.splitlines()
        self.assertGreaterEqual(len(lines), 3)
        for line in lines:
            name, sentence = line.split(None, 1)
            self.assertTrue(sentence.endswith("."), line)
            plan = json.loads(self.run_nullscope("plan", name, "--json").out)
            self.assertEqual(plan["table_bytes"], sum(t["bytes"] for t in plan["tables"]))
            self.assertGreater(plan["shader"]["bytes"], 1000)
            self.assertTrue(plan["passes"])
            there = {table["name"] for table in plan["tables"]}
            self.assertEqual([table["name"] for table in plan["tables"] if not table["reason"]], [], name)
            for effect in plan["effects"]:
                self.assertEqual({table for table in self.TABLES if table in effect["cost"]} - there, set(), (name, effect["effect"]))

    @support.costly
    def test_plan_measures_what_each_effect_takes(self):
        scene = self.write("seen.toml", '[camera]\nsize = [320, 180]\n[spacetime]\nmetric = "ellis"\n[picture]\nbloom = 0.1\n')
        effects = json.loads(self.run_nullscope("plan", scene, "--measure", "--frames", "3", "--json").out)["effects"]
        measured = {e["effect"] for e in effects if "core_seconds" in e}
        self.assertEqual({e["effect"] for e in effects} - measured, {"inner"})   # it cannot go alone
        for effect in (e for e in effects if e["effect"] in measured):
            self.assertGreater(effect["core_seconds"], 0)
            self.assertGreater(effect["without_core_seconds"], 0)
        if not support.QUICK:   # the same, measured again
            text = self.run_nullscope("plan", scene, "--measure", "--frames", "3").out
            self.assertEqual(text.count("measured: no, it cannot be removed by itself"), 1)
            self.assertEqual(text.count(" core-s ("), len(measured))
        self.assertNotIn("core_seconds", self.run_nullscope("plan", scene, "--json").out)

    @support.costly
    def test_a_path_is_drawn_frame_by_frame_and_as_a_film(self):
        fall = ["capture", "plunge", "--size", "32x18"]
        self.run_nullscope(*fall, "-o", "p%05d.png", "--frames", "198:201")
        pictures = {n: (self.folder / f"p{n:05d}.png").read_bytes() for n in (198, 199, 200)}
        self.assertEqual(len(set(pictures.values())), 3)
        (self.folder / "p00199.png").write_bytes(b"kept")
        self.run_nullscope(*fall, "-o", "p%05d.png", "--frames", "198:201", "--resume")
        self.assertEqual((self.folder / "p00199.png").read_bytes(), b"kept")
        self.run_nullscope(*fall, "-o", "q%05d.png", "--frames", "199:200")   # of its number alone
        self.assertEqual((self.folder / "q00199.png").read_bytes(), pictures[199])
        self.refused(*fall, "-o", "p%05d.png", "--frames", "299:301", says=["300 frames", "0:300"])
        self.refused("capture", "flat", "-o", "flat.mp4", says=["[path]"])
        if shutil.which("ffmpeg"):
            self.run_nullscope(*fall, "-o", "film.mp4", "--frames", "198:204")
            self.assertEqual((self.folder / "film.mp4").read_bytes()[4:8], b"ftyp")
            self.assertFalse((self.folder / "film.mp4.frames").exists())
        else:
            self.refused(*fall, "-o", "film.mp4", status=1, says=["ffmpeg"])
        keys = self.write("keys.toml", '[path]\nkind = "keys"\nframes = 5\n[[path.key]]\nframe = 0\nr = 9\n[[path.key]]\nframe = 4\nr = 6\nyaw = 20\n')
        self.run_nullscope("capture", keys, "--size", "32x18", "-o", "k%05d.png", "--frames", "0:5")
        for text, says in {'[path]\nkind = "keys"\n': ["path.key", "two"], "[path]\nkey = 3\n": ["path.key", "list of sections"],
                           '[path]\nkind = "keys"\n[[path.key]]\nr = 0.5\n[[path.key]]\n': ["3", "camera.r"],
                           "[[path.key]]\nr = 5\n": ["path.key", "kind is not keys"]}.items():
            self.refused("plan", self.write("broken.toml", text), says=says)

    def test_capture_says_what_it_promises_next_to_a_rotating_ring(self):
        for spin, promised in (0.9, "at most 0.05 px across it"), (0.9995, "at most 0.5 px across the ring"):
            scene = self.write("ring.toml", f'[spacetime]\nmetric = "kerr"\nspin = {spin}\n[zoom]\ndepth = 8\nangle = 180\n')
            said = self.run_nullscope("capture", scene, "--size", support.SMALL, "-o", os.path.join(self.folder, "ring.png")).err
            self.assertIn(promised, said)
        self.refused("capture", scene, "--size", support.SMALL, "--max-error", "0.1", says=["--max-error 0.1", "0.5 px and more"])

    def test_landmarks(self):
        def of(text, *options):
            return self.run_nullscope("landmarks", self.write("there.toml", text), *options).out

        still = json.loads(of('[spacetime]\nmetric = "schwarzschild"\n[camera]\nr = 10\n', "--json"))
        root = math.sqrt(0.9)
        for key, value in {"horizon": 1, "photon_orbit": 1.5, "isco": 3, "critical_impact": math.sqrt(6.75), "lapse": root, "clock_rate": root,
                           "shadow_radius": math.degrees(math.asin(math.sqrt(6.75) * root / 10)), "orbit_period": 2 * math.pi * math.sqrt(2000)}.items():
            self.assertAlmostEqual(still[key], value, delta=1e-9 * value)
        self.assertIsNone(still["retrograde_isco"])
        # Bardeen, Press and Teukolsky 1972 (ApJ 178, 347): 2.32088 and 8.71735 GM/c^2 where a = 0.9; light at 2 (1 + cos(2/3 acos(-+a))).
        text = '[spacetime]\nmetric = "kerr"\nspin = 0.9\n'
        turning = json.loads(of(text, "--json"))
        self.assertAlmostEqual(turning["isco"], 2.32088 / 2, delta=1e-5)
        self.assertAlmostEqual(turning["retrograde_isco"], 8.71735 / 2, delta=1e-5)
        for key, sign in (("photon_orbit", -1), ("retrograde_photon_orbit", 1)):
            self.assertAlmostEqual(turning[key], 1 + math.cos(2 / 3 * math.acos(sign * 0.9)), delta=1e-9)
        lines = of(text)
        self.assertIn("retrograde ISCO", lines)
        self.assertNotIn("critical", lines)   # there is none
        bare = self.run_nullscope("landmarks", "scalar-mass").out
        self.assertIn("singularity", bare)
        self.assertNotIn("horizon", bare)   # Janis, Newman and Winicour's has none
        self.refused("landmarks", "no-such-scene", says=["no-such-scene"])

    def test_flux(self):
        def jansky(scene):
            said = self.run_nullscope("flux", scene, "--size", "32x18").out
            self.assertRegex(said, r"^[0-9.e+-]+ Jy at 230 GHz\n$")
            return float(said.split()[0])

        there = str(self.folder / "there.toml")
        shipped = jansky("m87-synchrotron")
        for factor in (0.3, 4):   # the second by matter that is opaque at places: 73 times the density
            goal = "%.9g" % (factor * shipped)
            found = self.run_nullscope("flux", "m87-synchrotron", "--size", "32x18", "--target", goal, "-o", there)
            scale = float(found.out.split()[2])
            self.assertEqual(factor < 1, scale < 1)
            self.assertAlmostEqual(float(re.search(r"density_scale = (\S+)", Path(there).read_text())[1]) / scale, 1, delta=1e-8)
            self.assertAlmostEqual(jansky(there) / float(goal), 1, delta=2e-4)
            self.assertLessEqual(int(re.search(r"(\d+) pictures", found.out)[1]), 15)
        beyond = self.run_nullscope("flux", "m87-synchrotron", "--size", "8x8", "--target", "1e12", status=2).err.splitlines()[-1]
        self.assertRegex(beyond, "^nullscope: .*density_scale = 1e\\+12 .*a lesser flux$")
        self.refused("flux", "m87-synchrotron", "-o", "same.toml", says=["-o", "--target"])
        self.refused("flux", "gargantua", says=["no flux in Jy", "sky.kind"])

    def test_plan_says_why(self):
        text = '[camera]\nvelocity = [0.0, 0.0, 0.5]\n[sky]\nkind = "black"\n[disc]\nopacity = 0.5\n'
        plan = self.write("two.toml", text)
        found = json.loads(self.run_nullscope("plan", plan, "--json").out)
        reasons = {e["effect"]: e["reason"] for e in found["effects"]}
        self.assertEqual(list(reasons), ["lensing", "aberration", "disc", "disc-image", "translucent-disc", "refine"])
        self.assertIn("0.5", reasons["aberration"])
        left_out = [e["effect"] for e in found["left_out"]]
        self.assertEqual([left_out.pop() for _ in range(4)], ["disc-warp", "caps", "sphere-turn", "disc-lean"])
        media = [effect for effect in left_out if effect.startswith("medium-")]   # models of matter, and what they have
        self.assertEqual(left_out[-len(media):], media)
        self.assertLessEqual({"medium-gas", "medium-flow", "medium-formula", "medium-grid", "medium-motion", "medium-black-body", "medium-synchrotron", "medium-polarisation", "medium-bands"}, set(media))
        projections = left_out[left_out.index("spin-near") + 1:left_out.index("warp")]
        self.assertLessEqual({"fisheye", "equirectangular", "cylindrical", "cube-faces"}, set(projections))
        self.assertEqual([effect for effect in left_out[:-len(media)] if effect not in projections],
                         ["spin", "spin-fall", "disc-pattern", "thermal-disc", "shift", "beaming", "bolometric", "sphere", "cylinder", "ball", "surface", "pattern", "noise", "formula",
                          "body-image", "glow", "point-stars", "sky", "sky-shift", "sky-pattern", "inner", "bounce", "far-sky", "star",
                          "bloom", "auto-exposure", "tone-film", "tone-neutral", "dither", "sides", "delay", "light-times", "disc-flow", "ring-rates", "spot", "ball-path", "pulse", "inner-horizon",
                          "limb-darkening", "samples", "disc-gas", "narrow-disc", "polarisation", "polariser", "zoom", "spin-ring", "spin-near", "warp"])
        self.assertTrue(all(e["cost"] for e in found["effects"]))
        tables = {t["name"] for t in found["tables"]}
        self.assertLessEqual({"deflection table", "strip", "orbit table", "disc image"}, tables)
        self.assertNotIn("sky", tables)
        self.assertNotIn("warp mesh", tables)
        self.assertNotIn("medium grid", tables)
        text = self.run_nullscope("plan", plan).out
        for word in ("aberration", "camera.velocity = [0, 0, 0.5]", "orbit table", "Left out"):
            self.assertIn(word, text)

    @unittest.skipIf(support.QUICK, "ten seconds of compiling shaders: with --all")
    def test_bench_adds_every_effect(self):
        self.run_nullscope("bench", "frames", "--effects", "--size", support.SMALL, "--frames", "9", "--json", "effects.json")
        rows = json.loads((self.folder / "effects.json").read_text())
        plan = json.loads(self.run_nullscope("plan", "flat", "--json").out)
        every = [e["effect"] for e in plan["effects"] + plan["left_out"]]
        self.assertEqual(sorted(r["effect"] for r in rows), sorted(every))
        for row in rows:
            self.assertGreater(row["empty_core_seconds"], 0)

    @support.costly
    def test_bench_times_a_scene_in_a_place_that_flat_space_has_not(self):
        self.run_nullscope("bench", "frames", "in-the-throat", "--size", support.SMALL, "--frames", "9", "--json", "m.json")
        (row,) = json.loads((self.folder / "m.json").read_text())
        self.assertGreater(row["floor_core_seconds"], 0)

    def test_bench_times_a_camera_that_moves(self):
        self.run_nullscope("bench", "frames", "--moving", "first-light", "--size", support.SMALL, "--frames", "9", "--json", "m.json")
        (row,) = json.loads((self.folder / "m.json").read_text())
        self.assertGreater(row["host_core_ms"], 2 * row["host_at_rest_core_ms"])
        self.assertGreater(row["frame_core_ms"], row["host_core_ms"])

    def test_bench_counts_operations(self):
        self.run_nullscope("bench", "arithmetic", "--size", "64x64", "--frames", "9", "--json", "a.json")
        rows = json.loads((self.folder / "a.json").read_text())
        self.assertEqual(rows[0]["stage"], "fragment")
        for row in rows:   # 64 rounds of 8 x 4 multiplications and additions of four numbers
            self.assertAlmostEqual(row["operations_a_second"] * row["gpu_ms"] * 1e-3 / (64 * 8 * 4 * 8 * 64 * 64), 1.0, delta=1e-4)

    @unittest.skipIf(support.QUICK, "six processor seconds: with --all")
    def test_figures_of_a_gpu(self):
        scripts, programs = Path(__file__).resolve().parents[2] / "scripts", self.folder / "programs"
        programs.mkdir()
        (programs / "nullscope").symlink_to(Path(support.BINARY).resolve())   # and no golden pictures
        small = {"SIZES": "48x27 96x54", "SCENES": "sky-only no-such-scene", "LARGE_SCENES": "", "PICTURES": "first-light", "ONLY": "horizon, inwards",
                 "FILM": "sky-only", "FILM_FRAMES": "2", "FILM_SIZE": "96x54", "CONTEXT": self.contexts()[0], "PROGRAMS": str(programs)}
        subprocess.run([scripts / "gpu_measure.sh", self.folder / "measured"], env={**os.environ, **small}, capture_output=True, check=True)
        done = subprocess.run([sys.executable, "-B", scripts / "gpu_figures.py", "trial", self.folder / "measured", "--folder", self.folder],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 1, done.stderr)   # one scene cannot be measured, all others are
        text = (self.folder / "trial.md").read_text()
        self.assertIn("| frames fragment 48x27 no-such-scene | exit status 2 |", text)
        (renderer,) = re.findall(r"^# Figures of (.+)$", text, re.MULTILINE)
        self.assertIn(renderer, self.run_nullscope("info").out)
        (times,) = re.findall(r"\| sky-only \| ([0-9.]+) \| ([0-9.]*) \| ([0-9.]+) \| ([0-9.]*) \|\n\n## Rays", text)
        self.assertGreater(float(times[0]), 0.0)
        self.assertRegex(text, r"do nothing else \(`nullscope bench arithmetic`\): fragment [0-9.]+")
        self.assertRegex(text, r"\| sky-only \| fragment \| 4 \| 96x54 \| [0-9.]+ \| [0-9]+ % \|")
        self.assertRegex(text, r"\| First light \| 2000 \| 0\.")
        self.assertIn("1e-4 above the horizon, inwards", text)
        self.assertFalse(list(self.folder.glob("*.part")))

    def test_figures(self):
        for name in ("bending", "ray-types", "isoradials"):
            self.run_nullscope("figure", name, "-o", name + ".svg")
            text = (self.folder / (name + ".svg")).read_text()
            self.assertGreater(text.count("<polyline") + text.count("<polygon"), 3)
            self.assertTrue(text.rstrip().endswith("</svg>"))

    def spectrum(self, *words):
        """What it printed, the comments of its table and the table."""
        out = self.run_nullscope("spectrum", *words, "-o", "line").out
        lines = (self.folder / "line.csv").read_text().splitlines()
        columns = self.said("line.svg")["nullscope.columns"].splitlines()
        return out, columns, [{key: float(value) for key, value in row.items()} for row in csv.DictReader(lines)]

    def test_spectrum_from_below(self):
        """A disc seen from below has the line that is seen from above, and is said to be seen from below."""
        below, _, line = self.spectrum("kerr", "--inclination", "150", "--bins", "20")
        self.assertIn("inclination 150 degrees", below)
        above, _, same = self.spectrum("kerr", "--inclination", "30", "--bins", "20")
        self.assertIn("inclination 30 degrees", above)
        self.assertEqual(line, same)

    def said(self, name):
        """What a diagram says of itself and of the table beside it."""
        texts = ElementTree.parse(self.folder / name).findall(".//{nullscope}text")
        return {text.get("keyword"): text.text for text in texts}

    def test_tables_begin_with_their_header(self):
        """As readers expect; the diagram beside them says what both were made from."""
        self.write("s.toml", 'name = "A < B & C"\n[sky]\nkind = "grid"\n[[ball]]\nmotion = "path"\nx = "9 + t"\ny = "0"\nz = "0"\n')
        for columns, options, words in (
                ("time,flux,red,green,blue", "--steps 2 --size 16x9 --region 0 0 8 9", ("lightcurve", "s.toml", "--size", "16x9", "--steps", "2",
                                                                                     "--region", "0", "0", "8", "9", "-o", "t")),
                ("x,y,px,luminance,red,green,blue", "--angle 30.25 --size 16x9", ("profile", "s.toml", "--size", "16x9", "--angle", "30.25", "-o", "t")),
                ("g_from,g_to,g,photons,energy", "--inclination 20 --bins 5", ("spectrum", "s.toml", "--inclination", "20", "--bins", "5", "-o", "t")),
                ("psi_deg,n,inner_rad", "--rings 2", ("figure", "photon-ring", "s.toml", "--rings", "2", "-o", "t.svg"))):
            self.run_nullscope(*words)
            lines = (self.folder / "t.csv").read_text().splitlines()
            self.assertTrue(lines[0].startswith(columns), lines[0])
            self.assertEqual({line.count(",") for line in lines}, {lines[0].count(",")})
            said = self.said("t.svg")
            self.assertEqual((said["nullscope.scene"], said["nullscope.options"]), ("A < B & C", options))
            self.write("again.toml", said["nullscope.scene_text"])
            self.run_nullscope("plan", "again.toml")
            for word in ("scene_hash", "version", "columns"):
                self.assertTrue(said[f"nullscope.{word}"], word)

    def test_spectrum_of_a_disc(self):
        before = os.times()
        out, comments, rows = self.spectrum("--spin", "0.998", "--inclination", "30", "--limb", "laor", "--line", "6.4")
        after = os.times()
        most_core_s = 1.0    # of 1000 bins; 0.1 on the machine where it was written
        self.assertLess(after.children_user + after.children_system - before.children_user - before.children_system, most_core_s)
        self.assertEqual(len(rows), 1000)
        self.assertIn("disc from 0.6184853276 to 200 r_s", comments[1])
        change = float(re.search(r"no bin by more than (\S+) %", out).group(1))
        self.assertLess(change, 0.5)
        for column in "photons", "energy":
            self.assertAlmostEqual(sum(row[column] for row in rows), 1, delta=1e-6)
        for row, after in zip(rows, rows[1:]):
            self.assertEqual(row["g_to"], after["g_from"])
            self.assertAlmostEqual(row["energy_kev"], 6.4 * row["g"], delta=1e-6)
        # Laor 1991: a broad red wing, a peak at the blue edge, nothing beyond it.
        peak = max(rows, key=lambda row: row["photons"])
        self.assertAlmostEqual(peak["energy_kev"], 6.70, delta=0.01)
        self.assertGreater(sum(row["photons"] for row in rows if row["energy_kev"] < 4), 0.1)
        self.assertTrue((self.folder / "line.svg").read_text().rstrip().endswith("</svg>"))

    def test_spectrum_of_a_ring(self):
        for words, least, most in ((("--spin", "0.9", "--inclination", "60", "--ring", "1.1604415208809435"), 0.20257396, 1.00124795),
                                   (("--spin", "0.9", "--inclination", "150", "--ring", "3"), 0.60441306, 0.95583071),
                                   (("--inclination", "60", "--ring", "3"), 0.49707695, 1.22449057)):
            out, comments, rows = self.spectrum(*words, "--bins", "50")
            for text in out, comments[2]:
                found = re.search(r"from (\S+) to ([0-9.]+)", text[text.index("g ="if text is comments[2] else "g from"):])
                self.assertAlmostEqual(float(found.group(1)), least, delta=1e-6)
                self.assertAlmostEqual(float(found.group(2)), most, delta=1e-6)
            self.assertEqual(sorted(rows[0]), ["energy", "g", "g_from", "g_to", "photons"])

    def test_spectrum_of_a_scene(self):
        out, _, rows = self.spectrum("kerr", "--from", "0.5", "--to", "1", "--bins", "10", "--limb", "laor")
        self.assertIn("spin 0.9\ndisc from 1.161 to 7 r_s, inclination 80 degrees, emissivity r^-3, limb laor", out)
        self.assertLess(sum(row["photons"] for row in rows), 0.9)
        self.assertEqual((rows[0]["g_from"], rows[-1]["g_to"]), (0.5, 1))
        for emissivity, words in (("lamp:3", "a lamp at 3 r_s,"), ("lamp:3:2.4", "a lamp at 3 r_s, index 2.4,"), ("7:4:2.5", "r^-7 to 4 r_s, r^-2.5,")):
            self.assertIn(f"emissivity {words} limb", self.spectrum("--spin", "0.5", "--emissivity", emissivity)[0])
        table = self.write("table.csv", "r,epsilon\n4,1\n8,0.2\n")
        self.assertIn("disc from 4 to 8 r_s", self.spectrum("--emissivity", table)[0])
        lit = self.write("lit.toml", '[disc]\nemission = "thermal"\nemissivity = "lamp"\nlamp_height = 2.5\n')
        self.assertIn("emissivity a lamp at 2.5 r_s,", self.spectrum(lit, "--inclination", "20")[0])
        out, _, _ = self.spectrum("accretion", "--emissivity", "thermal", "--inclination", "20")
        self.assertIn("disc from 3 to 11 r_s, inclination 20 degrees, emissivity thermal", out)

    def test_figure_of_a_photon_ring(self):
        def rows(*words):
            self.run_nullscope("figure", "photon-ring", *words, "-o", "ring.svg")
            self.assertTrue((self.folder / "ring.svg").read_text().rstrip().endswith("</svg>"))
            return list(csv.DictReader((self.folder / "ring.csv").read_text().splitlines()))
        rings = rows()
        self.assertEqual([int(row["n"]) for row in rings], list(range(1, 9)))
        self.assertEqual(rings[0]["ratio"], "")
        for row in rings[5:]:
            self.assertAlmostEqual(float(row["ratio_theory"]), math.exp(-math.pi), delta=1e-15)
            self.assertLess(abs(float(row["ratio_off"])), 3e-5)
            self.assertLess(abs(float(row["ratio_off_limit"])), 1e-8 if row["n"] == "6" else 1e-9)
            self.assertAlmostEqual(float(row["delay"]), math.pi * 1.5 * math.sqrt(3), delta=3e-5)
        (first, *_, last) = rows("kerr", "--angles", "60", "--rings", "5")
        self.assertEqual(float(first["psi_deg"]), 60)
        self.assertLess(abs(float(last["ratio_off"])), 1e-3)
        self.assertLess(abs(float(last["azimuth"]) - float(last["azimuth_theory"])), 1e-2)

    def test_the_smallest_scene(self):
        scene = self.write("least.toml", '[spacetime]\nmetric = "schwarzschild"\n')
        self.run_nullscope("capture", scene, "--size", support.SMALL, "-o", "least.png")
        self.assertEqual(png_size((self.folder / "least.png").read_bytes()), (48, 27))

    def test_exr_with_ray_data(self):
        self.run_nullscope("capture", "first-light", "--size", support.SMALL, "--raydata", "-o", "rays.exr")
        channels, size, pixels = read_exr((self.folder / "rays.exr").read_bytes())
        wanted = "R G B fate sky.x sky.y sky.z ray.shift delay angle order hit ray.hit_u ray.hit_v ray.hit_w".split()
        self.assertEqual(set(channels), set(wanted))
        self.assertEqual(set(channels.values()), {2}, "32-bit float")
        self.assertEqual(size, (48, 27))
        self.assertTrue(pixels)

    def test_reference_picture(self):
        options = ("--size", "16x9", "--renderer", "reference", "--samples", "1")
        self.run_nullscope("capture", "first-light", *options, "-o", "r.png")
        self.assertEqual(png_size((self.folder / "r.png").read_bytes()), (16, 9))

    @support.costly
    def test_light_curves_of_both_renderers_have_all_that_shines(self):
        """Images on discs and bodies, stars, and the sky behind a wormhole."""
        moving = '[[ball]]\nradius = 1\nposition = [0, 4, 0]\nbrightness = 2\ntexture = "image"\nimage = "white.png"\n'
        self.run_nullscope("capture", self.write("white.toml", '[sky]\nkind = "plain"\ncolour = [9, 9, 9]\n[spacetime]\nmetric = "minkowski"\n'),
                           "--size", "16x9", "-o", "white.png")
        scenes = {"stars": '[sky]\nkind = "points"\nuniform_stars = 300\nmagnitude_limit = -2\n[disc]\n' + moving +
                           'motion = "path"\nx = "0"\ny = "5 + sin(t)"\nz = "0"\n',
                  "far": '[spacetime]\nmetric = "ellis"\nthroat = 3\n[sky]\nkind = "black"\n[far_sky]\nkind = "image"\nimage = "white.png"\n[light]\ndelay = "off"\n'
                         '[[surface]]\nshape = "length(x - 6, y - 4, z - 0.1*t) - 0.5"\n'}
        for name, text in scenes.items():
            self.write(f"{name}.toml", text)
            sums = {}
            for renderer in "gl", "reference":
                self.run_nullscope("lightcurve", f"{name}.toml", "--size", "64x36", "--from", "0", "--to", "5", "--steps", "2", "--renderer", renderer,
                                   "-o", renderer)
                lines = (self.folder / f"{renderer}.csv").read_text().split("\n")
                sums[renderer] = sum(float(line.split(",")[1]) for line in lines[1:3])
            self.assertAlmostEqual(sums["gl"] / sums["reference"], 1, delta=0.05, msg=name)

    @support.costly
    def test_contexts_give_one_picture(self):
        kinds = self.contexts()
        pictures, rays = [], []
        for kind in kinds:
            options = ("--size", support.SMALL, "--context", kind)
            self.run_nullscope("capture", "first-light", *options, "-o", "p.png")
            self.run_nullscope("capture", "first-light", *options, "--raydata", "-o", "p.exr")
            pictures.append((self.folder / "p.png").read_bytes())
            rays.append(read_exr((self.folder / "p.exr").read_bytes())[2])   # the header names the context
        self.assertTrue(all(p == pictures[0] for p in pictures), f"PNG: {kinds} differ")
        self.assertTrue(all(r == rays[0] for r in rays), f"EXR: {kinds} differ")
        if len(kinds) < 2:
            self.skipTest(f"only {kinds} here")

    @support.costly
    def test_two_spacetimes_beside_each_other(self):
        pictures = {}
        for name, other in (("same", "flat"), ("again", "flat"), ("other", "wormhole")):
            self.run_nullscope("capture", "flat", "--split", other, "--size", "64x32", "-o", f"{name}.png")
            pictures[name] = (self.folder / f"{name}.png").read_bytes()
            self.assertEqual(png_size(pictures[name]), (64, 32))
        self.assertEqual(pictures["same"], pictures["again"])
        self.assertNotEqual(pictures["same"], pictures["other"])
        self.refused("capture", "flat", "--split", "no such scene", says=["no such scene"])
        self.refused("capture", "flat", "--split", "flat", "--raydata", "-o", "a.exr", says=["--split"])

    def test_samples_are_the_scene_s_or_the_option_s_in_both_halves(self):
        pictures = []
        for text, more in (('', ()), ('[picture]\nsamples = 2\n', ()), ('', ("--samples", "2"))):
            scene = self.write("samples.toml", '[sky]\nkind = "grid"\n' + text)
            self.run_nullscope("capture", scene, "--split", scene, "--size", "64x32", *more, "-o", "samples.png")
            pictures.append((self.folder / "samples.png").read_bytes())
        self.assertEqual(pictures[1], pictures[2])
        self.assertNotEqual(pictures[0], pictures[1])

    @support.costly
    def test_a_scene_asks_for_a_split_screen(self):
        text = '[camera]\nr = 8\n[split]\nmetric = "{}"\n'
        pictures = []
        for metric in ("schwarzschild", "ellis"):
            scene = self.write("split.toml", text.format(metric))
            self.run_nullscope("capture", scene, "--size", "65x32", "-o", "split.png")
            pictures.append((self.folder / "split.png").read_bytes())
            self.assertEqual(png_size(pictures[-1]), (65, 32))
        self.assertNotEqual(*pictures)
        self.refused("capture", scene, "--raydata", "-o", "a.exr", says=["[split]"])
        for line, says in (("charge = -1", ["split.charge", "[0, 3]"]), ("throat = 1", ["no parameter", "charge"]),
                           ("radius = 2", ["reissner-nordstrom"])):
            broken = self.write("broken.toml", text.format("reissner-nordstrom") + line + "\n")
            self.refused("capture", broken, says=["broken.toml:5", *says])

    @support.costly
    def test_bench_metrics_has_every_spacetime(self):
        self.run_nullscope("bench", "metrics", "flat", "--size", support.SMALL, "--frames", "9", "--json", "metrics.json")
        rows = json.loads((self.folder / "metrics.json").read_text())
        self.assertIn("dneg-wormhole", [row["spacetime"] for row in rows])
        self.assertTrue(all(row["ratio"] > 0 for row in rows))

    def test_bench_hard_judges_its_rows(self):
        said = self.run_nullscope("bench", "hard", "--only", "flat, sky", "--json", "hard.json").out
        self.assertIn("1 of 1 rows within their bounds", said)
        self.assertTrue(json.loads((self.folder / "hard.json").read_text())[0]["within"])
        outside = self.write("reference.tsv", "flat, sky\t2e-3\t1e-3\n")
        said = self.run_nullscope("bench", "hard", "--only", "flat, sky", "--reference", outside, status=1).out
        self.assertIn("0 of 1 rows within their bounds", said)
        self.refused("bench", "hard", "--only", "no such case", says=["no such case"])
        broken = self.write("broken.tsv", "flat, sky\n")
        self.refused("bench", "hard", "--only", "flat, sky", "--reference", broken, says=["broken.tsv:1"])

    @support.costly
    def test_bench_pictures_judges_what_is_displayed(self):
        self.run_nullscope("bench", "pictures", "luminet", "--size", "480x270", "--pixels", "200", "--samples", "8", "--json", "p.json")
        (row,) = json.loads((self.folder / "p.json").read_text())
        self.assertEqual((row["pixels"], row["within"]), (200, True))
        self.assertLess(row["difference"]["mean"], 2)
        coarse = self.write("coarse.toml", '[camera]\nr = 15\n[picture]\nrefine = "off"\n[sky]\nbrightness = 20.0\n')
        said = self.run_nullscope("bench", "pictures", coarse, "--size", support.SMALL, "--pixels", "2000", "--samples", "8", status=1).out
        self.assertIn("too much", said)
        self.refused("bench", "pictures", "flat", "--samples", "3", says=["even"])

    @unittest.skipIf(support.QUICK, "18 processor seconds: measured by scripts/test.sh --all")
    def test_bench_soak_counts(self):
        self.run_nullscope("bench", "soak", "--frames", "1000", "--size", "16x9", "--json", "soak.json")
        self.assertEqual(json.loads((self.folder / "soak.json").read_text())[0]["not_finite"], 0)

    def test_a_large_image_is_made_smaller_while_it_is_read(self):
        width, height = 9000, 4500     # 121 MB of bytes, 486 MB of floats: never held
        row = b"\x01" + bytes(v for x in range(width) for v in (1 if x == 0 else 0, 0, 0))   # left differences: all alike
        packer = zlib.compressobj(1)
        pixels = b"".join(packer.compress(row) for _ in range(height)) + packer.flush()
        self.write("large.png", png(width, height, None, packed=pixels))
        scene = self.write("large.toml", '[sky]\nkind = "black"\n[sphere]\ntexture = "image"\nimage = "large.png"\n')
        peaks = []
        for most in ["64", "1024"]:
            done = subprocess.Popen([support.BINARY, "capture", scene, "--size", "48x27", "--largest-texture", most, "-o", "x.png"],
                                    cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
            said = done.stderr.read()
            _, status, used = os.wait4(done.pid, 0)
            done.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(done.returncode, 0, said)
            self.assertIn(f"9000x4500 px, read as {most}x{int(most) // 2} px: textures are limited to {most} px here", said)
            peaks.append(used.ru_maxrss / 1024)
        self.assertLess(peaks[1], 350, f"peaks of {peaks} MB: the whole image would be 600 MB more")

    def test_an_older_file_is_replaced_whole(self):
        old = self.write("frame.png", "old")
        self.run_nullscope("capture", "flat", "--size", "16x9", "-o", old)
        self.assertEqual(png_size((self.folder / "frame.png").read_bytes()), (16, 9))
        self.assertEqual([p.name for p in self.folder.iterdir()], ["frame.png"])


if __name__ == "__main__":
    support.main()
