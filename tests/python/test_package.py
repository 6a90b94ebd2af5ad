"""The package against the command line: the same numbers and words, what it costs, how it is stopped, what it leaves behind."""
import csv
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import types
import unittest
import unittest.mock
import warnings
from pathlib import Path

import numpy as np
import nullscope as ns
import OpenEXR

import support

KERR = ns.Spacetime("kerr", spin=0.5)


def some_rays(count, r=None):
    random = np.random.default_rng(7)
    n = random.normal(size=(3, count))
    return {"r": random.uniform(2, 30, count) if r is None else np.full(count, r), "theta": random.uniform(0.1, 3, count),
            "phi": random.uniform(0, 6, count), "n_r": n[0], "n_theta": n[1], "n_phi": n[2]}


def write_csv(path, rays):
    with open(path, "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(rays)
        out.writerows(zip(*(map(repr, column.tolist()) for column in rays.values())))


class Test(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="nullscope-python-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def exr(self, *options):
        """The channels of the EXR that `nullscope capture` writes."""
        support.command_line("capture", *options, "-o", self.folder / ("picture-%d.exr" if "--frames" in options else "picture.exr"))
        path = next(self.folder.glob("*.exr"))
        with OpenEXR.File(str(path), separate_channels=True) as file:
            channels = {name: channel.pixels.copy() for name, channel in file.channels().items()}
        path.unlink()
        return channels


class Pictures(Test):
    def check(self, scene, *options, size=(96, 54), **asked):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            picture = ns.capture(scene, size, **asked)
        channels = self.exr(scene, "--size", "%dx%d" % size, *options)
        there = np.stack([channels[c] for c in "RGB"], axis=-1)
        self.assertEqual(picture.dtype, np.float32)
        self.assertTrue(np.array_equal(picture.view(np.uint32), there.view(np.uint32)), f"{scene} {options}")
        return picture

    def test_equal_to_the_command_line(self):
        # One after another: what was drawn before must not matter.
        for scene in ("accretion", "kerr", "first-light", "two-spacetimes", "swarm", "starlight", "wormhole", "accretion"):
            self.check(scene)
        self.check("first-light", "--renderer", "reference", "--samples", "2", size=(32, 18), renderer="reference", samples=2)
        self.check("plunge", "--frames", "20:21", size=(48, 27), frame=20)
        self.check("hot-spot", "--time", "30", time=30)
        self.check("sky-only", "--method", "table:64", method="table:64")

    def test_stokes_parameters_equal_to_the_command_line(self):
        picture = self.check("m87-swirl", size=(64, 36))
        channels = self.exr("m87-swirl", "--size", "64x36")
        there = np.stack([channels["stokes." + c] for c in "IQUV"], axis=-1)
        self.assertEqual((picture.stokes.dtype, picture.stokes.shape), (np.float32, (36, 64, 4)))
        self.assertTrue(np.array_equal(picture.stokes.view(np.uint32), there.view(np.uint32)))
        # What observers measure, by its definition.
        i, q, u, _ = np.moveaxis(picture.stokes.astype(float), 2, 0)
        y, x = np.mgrid[:36, :64]
        linear, phi = q + 1j * u, np.arctan2(18 - (y + 0.5), x + 0.5 - 32)
        found = picture.polarisation
        self.assertIsInstance(found, ns.Polarisation)
        self.assertAlmostEqual(found.net, abs(linear.sum()) / i.sum(), delta=1e-6)
        self.assertAlmostEqual(found.resolved, abs(linear).sum() / i.sum(), delta=1e-6)
        self.assertAlmostEqual(found.beta_2, (linear * np.exp(-2j * phi)).sum() / i.sum(), delta=1e-6)
        self.assertGreater(abs(found.beta_2), 0.1)

    def test_pictures_without_stokes_parameters(self):
        plain = ns.capture("kerr", (16, 9))
        exact = ns.capture("m87-swirl", (16, 9), renderer="reference", samples=1)
        computed = 2 * ns.capture("m87-swirl", (16, 9))[::2]
        for picture in (plain, exact, computed):
            self.assertIsNone(picture.stokes)
            self.assertIsNone(picture.polarisation)

    def test_ray_data_equal_to_the_command_line(self):
        for renderer in ("gl", "reference"):
            rays = ns.raydata("kerr", (48, 27), renderer=renderer)
            channels = self.exr("kerr", "--size", "48x27", "--raydata", "--renderer", renderer,
                                *(["--samples", "1"] if renderer == "reference" else []))
            self.assertEqual(set(channels) - set("RGB"), set(ns.RAYDATA.fields) - set("guvw"))
            for name in set(channels) - set("RGB"):
                self.assertTrue(np.array_equal(rays[name].astype(np.float32), channels[name]), f"{renderer} {name}")
            for name, channel in zip("guvw", ("ray.shift", "ray.hit_u", "ray.hit_v", "ray.hit_w")):
                self.assertTrue(np.array_equal(rays[name], rays[channel]), name)

    def test_a_png_holds_what_it_was_drawn_from(self):
        file = self.folder / "drawn.png"
        for scene, options in (("kerr", {"time": 2.0, "samples": 2}), ("sky-only", {"renderer": "reference", "samples": 1}), ("plunge", {"frame": 20})):
            picture = ns.capture(scene, (48, 27), **options)
            file.write_bytes(picture.png())
            self.assertEqual(ns.scene(file), ns.scene(scene))
            channels = self.exr(file)
            self.assertTrue(np.array_equal(np.stack([channels[c] for c in "RGB"], axis=-1), picture), scene)
        file.write_bytes(b"\x89PNG\r\n\x1a\n")
        with self.assertRaisesRegex(ns.Error, "drawn.png.*cut off"):
            ns.scene(file)

    def test_ehtim_gets_what_is_in_the_fits_file(self):
        """ehtim itself, which is not light: scripts/interop.sh ehtim. Here a class in its place."""
        class Image:
            def __init__(self, light, psize, ra, dec, **more):
                self.planes, self.numbers, self.more = [light], (psize, ra, dec), more

            def add_qu(self, q, u):
                self.planes += [q, u]

            def add_v(self, v):
                self.planes.append(v)
        absent = unittest.mock.patch.dict(sys.modules, {"ehtim": None, "ehtim.image": None})
        with absent, self.assertRaisesRegex(ns.Error, "to_ehtim needs the package ehtim \\(pip install ehtim\\)"):
            ns.to_ehtim(ns.capture("m87", (32, 24)))
        place = types.ModuleType("ehtim.image")
        place.Image = Image
        with unittest.mock.patch.dict(sys.modules, {"ehtim": types.ModuleType("ehtim"), "ehtim.image": place}):
            sys.modules["ehtim"].image = place
            for scene, channels in (("m87-swirl", 4), ("m87", 1)):
                picture = ns.capture(scene, (32, 24))
                image = ns.to_ehtim(picture, mjd=57850, ra=12.5)
                self.assertEqual((len(image.planes), image.more["mjd"], image.more["rf"], image.numbers[1]), (channels, 57850, 230e9, 12.5))
                exr = self.exr(scene, "--size", "32x24", *(["--layers"] if channels == 4 else []))
                if channels == 4:
                    for plane, name, sign in zip(image.planes, "IQUV", (1, -1, -1, 1)):
                        self.assertTrue(np.array_equal(plane, sign * exr["stokes." + name].astype(float)), name)
                else:
                    np.testing.assert_allclose(image.planes[0], 0.2126 * exr["R"] + 0.7152 * exr["G"] + 0.0722 * exr["B"], rtol=1e-6)
            self.assertAlmostEqual(ns.to_ehtim(picture, flux=2.5).planes[0].sum(), 2.5, delta=1e-12)
            for call in (lambda: ns.to_ehtim(picture[1:]), lambda: ns.to_ehtim(np.zeros((24, 32, 3))), lambda: ns.to_ehtim(picture, dec=91),
                         lambda: ns.to_ehtim(picture, flux=True), lambda: ns.to_ehtim(ns.capture("kerr", (32, 24)))):
                with self.assertRaisesRegex(ns.Error, "; allowed: "):
                    call()

    def test_frequencies(self):
        """The light of each is that of the picture at it alone; what is of one frequency asks which."""
        bands, matter = (86.0, 230.0, 345.0), {"colour": [1.0, 1.0, 1.0], "brightness": 1.0}
        picture = ns.capture(ns.scene("m87-synchrotron", medium={**matter, "frequency": list(bands)}, picture={"refine": "off"}), (32, 24))
        self.assertEqual(tuple(band.frequency for band in picture.bands), bands)
        for band in picture.bands:
            alone = ns.capture(ns.scene("m87-synchrotron", medium={**matter, "frequency": band.frequency}, picture={"refine": "off"}), (32, 24))
            np.testing.assert_allclose(band.light, np.asarray(alone)[:, :, 0], rtol=0, atol=2e-3 * band.light.max())
            self.assertAlmostEqual(ns.visibility(picture, 0, 0, band=band.frequency).real / ns.visibility(alone, 0, 0).real, 1, delta=1e-3)
        for call in (lambda: ns.visibility(picture, 0, 0), lambda: ns.visibility(picture, 0, 0, band=100), lambda: ns.to_ehtim(picture)):
            with self.assertRaises(ns.Error):
                call()

    def test_visibilities_equal_to_the_command_line(self):
        u, v = np.array([[0, 1e9], [-3e9, 2e9]]), np.array([[0, 2e9], [5e9, 0]])
        (self.folder / "uv.csv").write_text("u,v\n" + "".join(f"{a},{b}\n" for a, b in zip(u.ravel(), v.ravel())))
        for scene, unit in (("m87-polarimetry", "_jy"), ("m87", "")):
            support.command_line("visibility", scene, "--size", "48x36", "--baselines", self.folder / "uv.csv", "--pixel", "square", "-o", self.folder / "v")
            with open(self.folder / "v.csv", encoding="utf-8", newline="") as file:
                rows = list(csv.DictReader(file))
            picture = ns.capture(scene, (48, 36))
            found = ns.visibility(picture, u, v, pixel="square")
            self.assertEqual((found.shape, found.dtype), ((2, 2), complex))
            there = np.array([float(row["real" + unit]) + 1j * float(row["imaginary" + unit]) for row in rows]).reshape(2, 2)
            np.testing.assert_allclose(found, there, rtol=1e-6, atol=1e-6 * abs(there[0, 0]))
            stokes = ns.visibility(picture, u, v, pixel="square", stokes=True)
            self.assertTrue(np.array_equal(stokes[..., 0], found))
            if unit:
                q = np.array([float(row["stokes_q_real_jy"]) + 1j * float(row["stokes_q_imaginary_jy"]) for row in rows]).reshape(2, 2)
                np.testing.assert_allclose(stokes[..., 1], q, atol=1e-6 * abs(there[0, 0]))
            else:
                self.assertFalse(stokes[..., 1:].any())
            for call in (lambda: ns.visibility(picture, u, v[0]), lambda: ns.visibility(picture, np.nan, 0), lambda: ns.visibility(picture, 0, 0, pixel="round"),
                         lambda: ns.visibility(picture[1:], 0, 0), lambda: ns.visibility(0 * picture, 0, 0), lambda: ns.visibility(ns.capture("kerr", (32, 24)), 0, 0)):
                with self.assertRaisesRegex(ns.Error, "; allowed: "):
                    call()

    def test_a_png_says_which_part_of_the_sphere_it_is(self):
        """As the command line's does, of the size and frame that were drawn; not of an array of another size, nor of both eyes."""
        scene, file = self.folder / "sphere.toml", self.folder / "sphere.png"
        packet = lambda png: re.findall(rb'GPano:(\w+)="(\w+)"', png)
        for more, options, words in (("", {}, ()), ("fov = 180\n", {}, ()),
                                     ('[path]\nkind = "keys"\n[[path.key]]\nfov = 180\n[[path.key]]\nframe = 9\nfov = 90\n', {"frame": 9},
                                      ("--frames", "9:10"))):
            scene.write_text('[sky]\nkind = "grid"\n[camera]\nr = 9\nprojection = "equirectangular"\n' + more)
            picture = ns.capture(str(scene), (64, 32), **options)
            support.command_line("capture", scene, "--size", "64x32", *words, "-o", self.folder / "%d.png" if words else file)
            meant = packet((self.folder / "9.png" if words else file).read_bytes())
            self.assertEqual(len(meant), 8)
            self.assertEqual(packet(picture.png()), meant, more)
            self.assertEqual(packet(picture[:, 1:].png()), [])
        scene.write_text('[camera]\nr = 9\nprojection = "equirectangular"\nstereo = "all-round"\n')
        self.assertEqual(packet(ns.capture(str(scene), (64, 32)).png()), [])

    def test_dumps_at_a_time(self):
        for dump in range(3):
            node = struct.pack("<8f", 4.0 ** dump, 1e4, 0, 0, 0, 0, 0, 0)
            (self.folder / f"flow-{dump}.grid").write_bytes(
                b"nullscope-medium 1\ncoordinates kerr-schild\nspin 0\nr 1.1 10 3\ntheta 0.1 3 2\nphi 0 1\ndata\n" + 6 * node)
        file = self.folder / "film.toml"
        file.write_text('[object]\nmass_suns = 4e6\n[medium]\nkind = "grid"\nfile = "flow-%d.grid"\ncadence = 2\nouter = 9\nemissivity = 3e-21\n')
        pictures = [self.check(str(file), "--time", str(time), time=time) for time in (0.0, 3.0, 4.0)]
        self.assertFalse(np.array_equal(pictures[0], pictures[2]))
        for picture, there in zip(pictures, ([0], [1, 2], [2])):
            self.assertEqual([dump for dump in range(3) if f"flow-{dump}.grid".encode() in picture.png()], there)
        with self.assertRaisesRegex(ns.Error, r"time: 4.1 is not between the dumps of medium.file; allowed: \[0, 4\] r_s/c"):
            ns.capture(str(file), (48, 27), time=4.1)

    def test_shown_as_png(self):
        picture = ns.capture("accretion", (64, 36))
        self.assertEqual(picture._repr_png_()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(picture.display().shape, (36, 64, 3))
        self.assertGreater(picture.display().max(), 100)
        self.assertIsNone(picture[0]._repr_png_())
        self.assertGreater((2 * picture).display().mean(), picture.display().mean())


class Rays(Test):
    def test_equal_to_the_command_line(self):
        rays, path, out = some_rays(300, r=9.0), self.folder / "rays.csv", self.folder / "out.csv"
        rays["at_angle"] = np.full(300, 0.5)
        write_csv(path, rays)
        structured = np.rec.fromarrays(list(rays.values()), names=list(rays))
        for scene in ("accretion", "kerr"):
            for tracer in ("reference", "core64", "core32", "gl"):
                found = ns.trace(scene, structured, tracer, crossings=2)
                support.command_line("trace", scene, "--rays", path, "--with", tracer, "--crossings", 2, "-o", out)
                with open(out, newline="") as file:
                    rows = list(csv.DictReader(file))
                for name in found.dtype.names[2:]:
                    there = np.array([float(row[name] or "nan") for row in rows])
                    self.assertTrue(np.array_equal(found[name], there, equal_nan=True), f"{scene} {tracer} {name}")
                self.assertEqual([ns.fate_name(scene, ray) for ray in found], [row["fate"] for row in rows])

    def test_curves_are_those_of_the_command_line(self):
        path, out = self.folder / "rays.csv", self.folder / "out.csv"
        for scene, rays in (("kerr", some_rays(5, r=9.0)), ("kerr", {"lambda": np.array([2.0, -3.0]), "eta": np.array([20.0, 18.0]), "theta": np.ones(2)}),
                            ("wormhole", some_rays(3, r=9.0))):
            write_csv(path, rays)
            found = ns.trace_curves(scene, rays, 40, far=50)
            self.assertEqual(found.shape, (len(next(iter(rays.values()))), 40))
            support.command_line("trace", scene, "--rays", path, "--points", 40, "--far", 50, "--rates", "-o", out)
            with open(out, newline="") as file:
                rows = list(csv.DictReader(file))
            for name in found.dtype.names:
                self.assertTrue(np.array_equal(found[name].ravel(), [float(row[name] or "nan") for row in rows], equal_nan=True), f"{scene} {name}")
        with self.assertRaisesRegex(ns.Error, "points: 1 is out of range"):
            ns.trace_curves("kerr", some_rays(2), 1)
        with self.assertWarnsRegex(UserWarning, "1 of 1 rays have no curve"):
            self.assertTrue(np.isnan(ns.trace_curves("kerr", {**some_rays(1), "r": 200.0, "n_r": 1.0}, 3)["r"]).all())

    def test_gradients_are_those_of_the_command_line(self):
        path, out, rays = self.folder / "rays.csv", self.folder / "out.csv", some_rays(20, r=9.0)
        write_csv(path, rays)
        for scene, names in (("kerr", ["spin", "camera.theta"]), ("accretion", ["camera.r"])):
            found = ns.gradient(scene, rays, names, crossings=1)
            support.command_line("trace", scene, "--rays", path, "--crossings", 1, "--derivatives", ",".join(names), "-o", out)
            with open(out, newline="") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual(found["state"].tolist(), [row["derivatives"] for row in rows])
            for name in found.dtype.names[1:]:
                self.assertTrue(np.array_equal(found[name], [float(row[name] or "nan") for row in rows], equal_nan=True), f"{scene} {name}")
            self.assertEqual(len(found.dtype.names), 1 + 8 * len(names))   # x, y, z, g, delay; of the crossing r, phi, g
        for call, words in ((lambda: ns.gradient("kerr", rays, ["charge"]), "no derivatives by .charge. of this scene; allowed: spacetime.spin"),
                            (lambda: ns.gradient("kerr", rays, "spin"), "parameters: of another kind; allowed: a list of texts"),
                            (lambda: ns.gradient("wormhole", rays, ["camera.r"]), "no derivatives in metric"),
                            (lambda: ns.gradient("sky-only", {**rays, "frame": "rain"}, ["camera.r"]), r"rays\[0\].*of an observer that falls")):
            with self.assertRaisesRegex(ns.Error, words):
                call()

    def test_columns_are_read_where_they_are(self):
        rays = some_rays(1000)
        packed = np.zeros(1000, dtype=[("tag", "u1")] + [(name, "f8") for name in rays])   # unaligned
        for name, column in rays.items():
            packed[name] = column
        self.assertTrue(np.array_equal(ns.trace("kerr", packed)["delay"], ns.trace("kerr", rays)["delay"], equal_nan=True))
        reverse = {name: column[::-1] for name, column in rays.items()}
        self.assertTrue(np.array_equal(ns.trace("kerr", reverse)["delay"][::-1], ns.trace("kerr", rays)["delay"], equal_nan=True))

    def test_rays_that_the_shader_leaves_out(self):
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            found = ns.trace("sky-only", {**some_rays(2), "r": np.array([5.0, 2e9])}, "core64")
        self.assertEqual(found["fate"].tolist()[1], ns.Fate.UNSUPPORTED)
        self.assertIn("1 of 2 rays left empty", str(said[0].message))

    def test_deflection(self):
        impact = np.array([2.5, 10.0, 1e6])
        found = ns.deflection(ns.Spacetime(), impact)
        self.assertTrue(np.isnan(found[0]))
        first = 2.0 / impact
        self.assertLess(abs(found[2] / first[2] - 1 - 15 * np.pi / 32 / impact[2]), 1e-9)   # 4M/b (1 + 15 pi M/(16 b)), M = 1/2
        self.assertAlmostEqual(ns.deflection("sky-only", 10.0), found[1], places=15)


class Numbers(Test):
    def test_textbook_values(self):
        hole = ns.Spacetime()
        self.assertEqual(hole.horizon, 1.0)
        self.assertAlmostEqual(hole.isco, 3.0, places=13)
        self.assertAlmostEqual(hole.photon_orbit, 1.5, places=14)
        self.assertAlmostEqual(hole.critical_impact, 1.5 * 3 ** 0.5, places=14)
        self.assertAlmostEqual(hole.circular_orbit(3.0)["energy"], (8 / 9) ** 0.5, places=14)
        orbit = hole.circular_orbit(3.0)
        self.assertAlmostEqual(orbit["ut_up"], 2 ** 0.5, places=14)   # u^t = 1/sqrt(1 - 3 M/r), M = 1/2
        self.assertEqual(orbit["u_t"], orbit["ut_up"])                # its name before
        self.assertAlmostEqual(hole.shadow(10.0), np.arcsin(1.5 * 3 ** 0.5 / 10 * 0.9 ** 0.5), places=14)
        self.assertAlmostEqual(ns.Spacetime("kerr", spin=0.9).horizon, 0.5 + (0.25 - 0.45 ** 2) ** 0.5, places=14)
        product = KERR.metric(3.0, 1.0) @ KERR.inverse_metric(3.0, 1.0)
        self.assertLess(abs(product - np.eye(4)).max(), 1e-14)

    def test_tetrad_is_orthonormal(self):
        for kind in ("static", "rain", "orbit"):
            one = ns.Observer({"camera": {"r": 6.0, "theta": 90.0, "observer": kind, "velocity": [0.1, 0.2, 0.3]}})
            lapse2, r = 1 - 1 / 6, 6.0
            g = np.array([[-lapse2, 1, 0, 0], [1, 0, 0, 0], [0, 0, r * r, 0], [0, 0, 0, r * r]])   # ingoing (v, r, theta, phi)
            self.assertLess(abs(one.tetrad @ g @ one.tetrad.T - np.diag([-1, 1, 1, 1])).max(), 1e-12)

    def test_worldline(self):
        line = ns.Observer({"camera": {"r": 1.0 + 1e-9, "observer": "rain"}}).fall(10.0)
        self.assertEqual(line.end, "singularity")
        self.assertAlmostEqual(line.end_time, 2 / 3, places=7)   # 4M/3 from the horizon
        places = ns.worldline({"camera": {"r": 6.0, "observer": "orbit", "theta": 90.0}}, 30.0, 3)
        self.assertLess(abs(places["r"] - 6.0).max(), 1e-9)

    def test_worldlines_keep_their_turns(self):
        for metric in ({"metric": "kerr", "spin": 0.9}, {"metric": "schwarzschild"}):
            camera = {"r": 6.0, "observer": "orbit", "theta": 60.0, "phi": 170.0}
            phi = ns.worldline({"spacetime": metric, "camera": camera}, 600.0, 3000)["phi"]
            self.assertAlmostEqual(phi[0], np.radians(170.0), delta=0.2)   # ingoing about a rotating hole
            self.assertLess(abs(np.diff(phi)).max(), 0.1)   # no jump
            self.assertGreater(abs(phi[-1] - phi[0]), 4 * np.pi)
            few = ns.worldline({"spacetime": metric, "camera": camera}, 600.0, 3)["phi"]
            self.assertLess(abs(few - phi[::1000]).max(), 1e-9)   # however few the times

    def test_scenes_take_numbers_of_numpy(self):
        given = {"camera": {"r": np.float32(8), "size": np.array([64, 36])}, "picture": {"samples": np.int64(2)},
                 "object": {"name": np.str_("m87")}, "time": np.array(3.0)}
        plain = {"camera": {"r": 8.0, "size": [64, 36]}, "picture": {"samples": 2}, "object": {"name": "m87"}, "time": 3.0}
        self.assertEqual(ns.scene(given).text, ns.scene(plain).text)

    def test_booleans_are_neither_numbers_nor_on_and_off(self):
        one = {"q": 1.0, "zeta0": 0.1, "s": 1}
        calls = [(lambda true: ns.scene({"camera": {"r": true}}), "scene: camera.r: must be a number, not a boolean; allowed: .*"),
                 (lambda true: ns.scene({"light": {"delay": true}}), "scene: light.delay: must be a string, not a boolean; allowed: off or on"),
                 (lambda true: ns.scene("kerr", light={"delay": true}), "scene: light.delay: must be a string, not a boolean; allowed: off or on"),
                 (lambda true: ns.Spacetime("kerr", spin=true), "spin: .* of another kind; allowed: a number"),
                 (lambda true: KERR.metric(true), "r: .* of another kind; allowed: a number"),
                 (lambda true: ns.worldline("kerr", true), "duration: .* of another kind; allowed: a number"),
                 (lambda true: ns.worldline("kerr", 1.0, true), "steps: .* of another kind; allowed: a whole number from 1 to 10000000"),
                 (lambda true: ns.trace("sky-only", one, crossings=true), "crossings: .* of another kind; allowed: a whole number from 0 to 1000")]
        for name, allowed in (("time", "number"), ("max_error", "number"), ("samples", "whole number"), ("frame", "whole number")):
            calls.append((lambda true, name=name: ns.capture("kerr", (8, 8), **{name: true}), f"{name}: .* of another kind; allowed: a {allowed}"))
        for call, words in calls:
            for true in (True, np.bool_(True), np.array(True)):
                with self.assertRaisesRegex(ns.Error, f"^{words}$"):
                    call(true)
        self.assertEqual(ns.worldline("kerr", np.float64(1.0), np.int64(3)).shape, (4,))


def errors():
    """Calls with something wrong, of every function."""
    hole, one = ns.Spacetime(), {"q": 1.0, "zeta0": 0.1, "s": 1}
    capture, size = ns.capture, (8, 8)
    general = {"r": 5.0, "theta": 1.0, "phi": 0.0, "n_r": 1.0, "n_theta": 0.0, "n_phi": 0.0}
    for given in ("nope", 3, None, "a = [\n", "[camera]\nr = 0.5", {"camera": {"r": 0.5}}, {"camera": {"r": object()}},
                  {"ca\nmera": 1}, {"camera": 3}, Path("/nowhere"), "x" * 300, "a\0b", "="):
        yield lambda: ns.scene(given)
        yield lambda: capture(given, size)
        yield lambda: ns.raydata(given, size)
        yield lambda: ns.trace(given, one)
        yield lambda: ns.deflection(given, 1.0)
        yield lambda: ns.Observer(given)
        yield lambda: ns.worldline(given, 1.0)
        yield lambda: ns.fate_name(given, {"fate": 4, "hit": 1})
    yield lambda: ns.scene("kerr", camera=3)
    yield lambda: ns.scene("kerr", nonsense={"a": 1})
    for draw in (capture, ns.raydata):
        for wrong in ({"size": (0, 3)}, {"size": 5}, {"size": "x"}, {"renderer": "x"}, {"renderer": 3}, {"method": "euler"},
                      {"time": float("nan")}, {"time": "x"}, {"frame": 3}, {"frame": 0.5}, {"context": "x"}, {"progress": 3},
                      {"max_error": -1.0}, {"renderer": "reference", "method": "strip"}):
            yield lambda: draw("kerr", **{"size": size, **wrong})
    yield lambda: capture("kerr", size, samples=99)
    yield lambda: ns.raydata("two-spacetimes", size)
    for rays in (3, None, {}, np.zeros(3), {"q": [1.0, 2.0], "zeta0": [1.0, 2.0, 3.0], "s": 1}, {"r": 3.0}, {**one, "q": "x"},
                 {**one, "q": np.nan}, {**one, "q": 1e-3}, {**general, "r": 0.5}, {**general, "n_r": 0.0}, {**general, "frame": "räin\n"},
                 {**general, "theta": 4.0}, {**one, "q": np.ones((2, 2))}, {**one, "at_angle": -1.0}, {**one, **general}):
        yield lambda: ns.trace("sky-only", rays)
    for wrong in ({"with_": "x"}, {"with_": 3}, {"crossings": -1}, {"crossings": 0.5}, {"with_": "core64", "method": "integrate"},
                  {"progress": 5}, {"context": "x"}):
        yield lambda: ns.trace("sky-only", one, **wrong)
    yield lambda: ns.trace("kerr", one)
    for arguments, wrong in ((("x",), {}), ((3,), {}), ((None,), {}), (("kerr",), {"spin": 3}), (("kerr",), {"spin": "a"}),
                             (("kerr",), {"spin": None}), (("kerr",), {"x": 1}), (("formula",), {"A": "1-"})):
        yield lambda: ns.Spacetime(*arguments, **wrong)
    for wrong in ("x", None, -1, float("nan"), [1]):
        for method in (hole.metric, hole.inverse_metric, hole.circular_orbit, hole.shadow):
            yield lambda: method(wrong)
        yield lambda: hole.metric(3.0, wrong)
        yield lambda: hole.spherical_photon_orbit(wrong)
        yield lambda: hole.spherical_photon_orbit(1.0, wrong)
        yield lambda: ns.Observer("kerr").fall(wrong)
        yield lambda: ns.Observer("kerr").fall(3.0).places(wrong if wrong == "x" or wrong is None else np.array([-1.0]))
        yield lambda: ns.worldline("kerr", wrong)
    yield lambda: ns.Spacetime("minkowski").spherical_photon_orbit()
    for impact in ("x", None, [-1.0], [[1.0]], float("nan")):
        yield lambda: ns.deflection(hole, impact)
    yield lambda: ns.deflection(KERR, 3.0)
    yield lambda: ns.deflection(hole, 3.0, progress=2)
    yield lambda: ns.Observer({"camera": {"theta": 0.0}}).tetrad
    yield lambda: ns.worldline("kerr", 3.0, 0)
    for ray in (3, None, {"fate": 99, "hit": 0}):
        yield lambda: ns.fate_name("kerr", ray)
    yield lambda: ns.capture("sky-only", size)[0].display()
    yield lambda: ns.capture("sky-only", size)[0].png()


class Errors(Test):
    def test_one_line_each(self):
        count = 0
        for call in errors():
            with self.assertRaises(ns.Error) as caught:
                call()
            self.assertIsInstance(caught.exception, ValueError)
            self.assertTrue(str(caught.exception).isprintable() and str(caught.exception), repr(caught.exception))
            count += 1
        self.assertGreater(count, 200)

    def test_the_words_of_the_command_line(self):
        scene = self.folder / "bad.toml"
        scene.write_text("[camera]\nr = 0.5\n")
        for file in (str(scene), "nope"):
            done = subprocess.run([support.BINARY, "capture", file], capture_output=True, text=True)
            with self.assertRaises(ns.Error) as caught:
                ns.capture(file)
            self.assertEqual(done.stderr, f"nullscope: {caught.exception}\n")


class Long(Test):
    def test_progress(self):
        calls = []
        ns.trace("kerr", some_rays(3000), progress=lambda done, total: calls.append((done, total)))
        self.assertEqual(calls[-1], (3000, 3000))
        self.assertEqual(calls, sorted(calls))
        ns.capture("kerr", (64, 36), renderer="reference", samples=1, progress=lambda *told: calls.append(told))
        self.assertEqual(calls[-1], (64 * 36, 64 * 36))

    def test_what_the_callback_raises_ends_the_call(self):
        def stop(done, total):
            raise KeyError("enough")
        with self.assertRaisesRegex(KeyError, "enough"):
            ns.capture("kerr", (640, 360), renderer="reference", progress=stop)

    def test_interrupted(self):
        for call in ('ns.capture("kerr", (3840, 2160), renderer="reference")', 'ns.trace("kerr", rays)', 'ns.trace("sky-only", rays, "core64")'):
            text = ("import numpy as np, nullscope as ns, signal\n"
                    "signal.signal(signal.SIGINT, signal.default_int_handler)\n"   # which shells switch off in the background
                    "rays = {'r': np.linspace(3, 30, 2000000), 'theta': 1., 'phi': 0., 'n_r': -1., 'n_theta': .2, 'n_phi': .3}\n"
                    "print('go', flush=True)\ntry:\n    " + call + "\nexcept KeyboardInterrupt:\n    print('stopped')\n")
            with subprocess.Popen([sys.executable, "-c", text], stdout=subprocess.PIPE, text=True) as child:
                child.stdout.readline()
                time.sleep(1.0)
                child.send_signal(signal.SIGINT)
                try:
                    out, _ = child.communicate(timeout=60)
                except subprocess.TimeoutExpired:
                    child.kill()
                    self.fail(f"not stopped: {call}")
            self.assertEqual((out, child.returncode), ("stopped\n", 0), call)

    def test_other_threads_run(self):
        counted, over = [0], threading.Event()

        def count():
            while not over.is_set():
                counted[0] += 1
                time.sleep(0.001)
        thread = threading.Thread(target=count)
        thread.start()
        begun = time.perf_counter()
        ns.capture("kerr", (160, 90), renderer="reference", samples=1)
        seconds, ticks = time.perf_counter() - begun, counted[0]
        over.set()
        thread.join()
        self.assertGreater(ticks, 20 * seconds)   # of 1000 a second on an idle machine

    def test_two_threads_draw(self):
        pictures = {}
        threads = [threading.Thread(target=lambda i=i: pictures.update({i: ns.capture("accretion", (64, 36))})) for i in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(np.array_equal(pictures[0], pictures[1]))


class Cost(Test):
    def test_import(self):
        """The processor time of an interpreter that imports the package, less one that does not; the least of five."""
        def seconds(text):
            before = support.core_seconds(support.resource.RUSAGE_CHILDREN)
            subprocess.run([sys.executable, "-c", text], check=True, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
            return support.core_seconds(support.resource.RUSAGE_CHILDREN) - before
        least = min(seconds("import nullscope") for _ in range(5)) - min(seconds("") for _ in range(5))
        print(f"import nullscope: {least:.3f} core-seconds")
        self.assertLess(least, 0.3)

    def test_a_million_rays(self):
        rays, path = some_rays(1_000_000), self.folder / "rays.csv"
        write_csv(path, rays)
        before = support.core_seconds()
        ns.trace("sky-only", rays)
        here = support.core_seconds() - before
        before = support.core_seconds(support.resource.RUSAGE_CHILDREN)
        support.command_line("trace", "sky-only", "--rays", path, "-o", self.folder / "out.csv")
        there = support.core_seconds(support.resource.RUSAGE_CHILDREN) - before
        print(f"1e6 rays: {here:.2f} core-seconds, {there:.2f} by the command line")
        self.assertLess(here, 1.5 * there)

    def test_calls_leave_nothing_behind(self):
        rays = some_rays(100)

        def calls():
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                picture = ns.capture("accretion", (16, 9))
                picture.png()
                ns.raydata("kerr", (16, 9))
                ns.trace("kerr", rays, crossings=2)
                ns.trace("sky-only", {**rays, "r": 9.0}, "core64")
                ns.deflection("sky-only", np.array([5.0]))
                ns.worldline("kerr", 1.0, 10)
                observer = ns.Observer(ns.scene("kerr", camera={"r": 8.0}))
                observer.tetrad, observer.critical_curve(), ns.Spacetime("kerr", spin=0.3).metric(3.0)
                try:
                    ns.scene("nope")
                except ns.Error:
                    pass
        for _ in range(60):   # until programs have settled; the heap does so in steps of some 0.6 %, the last after 200
            calls()
        sizes = [support.resident_bytes()]
        for _ in range(3):
            for _ in range(50):   # of ten calls each and more
                calls()
            sizes.append(support.resident_bytes())
        grown = [after / before - 1 for before, after in zip(sizes, sizes[1:])]
        print(f"each 500 calls: {sizes[0] / 1e6:.0f} MB grow by {', '.join(f'{100 * part:.2f} %' for part in grown)}")
        self.assertLess(min(grown), 0.005)   # what is left behind is so each time


if __name__ == "__main__":
    support.main()
