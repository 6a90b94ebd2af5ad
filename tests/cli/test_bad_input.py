#!/usr/bin/env python3
"""Bad input: one line that says file, line, key and allowed range where they exist, status 2 or 1, and no file left."""
import os
import resource
import signal
import unittest

import support

RAYS = "r,theta,phi,n_r,n_theta,n_phi\n"
GOOD = "10,1.5,0,-1,0,0.1\n"


class Usage(support.CliTest):
    def test_a_key_that_is_refused_while_it_is_drawn_has_file_and_line(self):
        """The shader draws what is finer than directions in double; the reference does not."""
        scene = self.write("deep.toml", "name = \"deep\"\n[sky]\nkind = \"plain\"\n[zoom]\n\ndepth = 39.8\n")
        for words in (["capture", scene, "-o", "a.png"], ["profile", scene, "-o", "a"]):
            self.refused(*words, "--renderer", "reference", "--size", "16x9", says=["deep.toml:6: zoom.depth: ", "allowed: at most 25 "])

    def test_commands_and_options(self):
        self.refused("captur", says=["captur", "nearest: capture"])
        self.refused("capture", says=["scene", "capture --help"])
        self.refused("capture", "flat", "--contxt", "egl", says=["--contxt", "nearest: --context"])
        self.refused("capture", "flat", "--context", "vulkan", says=["vulkan", "egl", "osmesa"])
        self.refused("trace", "flat", says=["--rays"])
        self.refused("trace", "flat", "--rays", "x.csv", "--with", "gpu", says=["gpu", "core64"])
        self.refused("trace", "flat", "--rays", "x.csv", "--crossings", "-1", says=["--crossings", "0"])
        self.refused("capture", "a\nb", "c\n\x1b[31md", says=["c?", "not expected"])
        self.refused("capture", "flat", "one", "two", says=["one: not expected"])
        self.refused("bench", "frames", "--frames", "3", says=["--frames 3: out of range; allowed: whole numbers from 9 to 10000"])
        self.refused("help", "captur", says=["nearest: capture"])
        self.refused("bench", says=["frames"])
        escape = "\x1b[2J\n\x7f"    # what a terminal would obey; refused() looks for it in the message
        small = ("--size", "16x9", "-o", "a.png")
        self.refused("capture", "flat", f"--size={escape}", says=["--size", "?[2J??"])
        self.refused("capture", "flat", *small, f"--method={escape}", says=["?[2J??"])
        self.refused("capture", "flat", *small, f"--frames={escape}", says=["?[2J??"])
        self.refused("capture", "flat", "-o", escape, says=["?[2J??"])
        self.refused("plan", "flat", "--xml", says=["--xml"])

    def test_options_that_change_nothing(self):
        self.refused("capture", "flat", "--size", "16x9", "--samples", "17", says=["--samples", "1 to 16"])
        for option, value in ("--method", "strip"), ("--max-error", "1"), ("--context", "egl"), ("--largest-texture", "64"):
            self.refused("capture", "flat", "--size", "16x9", "--renderer", "reference", option, value, says=[option, "--renderer gl"])
        self.refused("lightcurve", "hot-spot", "--size", "16x9", "--samples", "2", says=["--samples", "--renderer reference"])
        small = ("capture", "flat", "--size", "16x9")
        for words, says in ((("--time-step", "1"), ["--time-step", "--frames A:B"]), (("--resume",), ["--resume", "--frames A:B"]),
                            (("--max-error", "1", "--method", "strip"), ["--max-error", "--method strip"]),
                            (("--st-map", "sky", "--samples", "2", "-o", "a.exr"), ["--samples", "ST map"]),
                            (("--dump-shader", "--renderer", "reference"), ["--dump-shader", "--renderer gl"])):
            self.refused(*small, *words, says=says)
        self.write("rays.csv", RAYS + GOOD)
        for words, says in ((("--method", "strip"), ["--method", "--with gl"]), (("--context", "egl"), ["--context", "--with gl"]),
                            (("--with", "core64", "--context", "egl"), ["--context", "--with gl"])):
            self.refused("trace", "sky-only", "--rays", "rays.csv", *words, says=says)
        for command, words, says in (("lightcurve", ("hot-spot", "--renderer", "reference", "--context", "egl"), ["--context", "--renderer gl"]),
                                     ("figure", ("bending", "--rings", "4"), ["--rings", "photon-ring"]),
                                     ("figure", ("isoradials", "--angles", "30"), ["--angles", "photon-ring"]),
                                     ("figure", ("bending", "kerr"), ["kerr", "isoradials"]),
                                     ("spectrum", ("--ring", "5", "--emissivity", "2"), ["--emissivity", "--ring"])):
            self.refused(command, *words, says=says)
        self.refused("bench", "frames", "--effects", "--poses", "2", says=["--effects", "--poses"])
        self.run_nullscope(*small, "-o", "a.png")
        self.refused("compare", "a.png", "a.png", "--scene", "flat", says=["--scene flat", "ray data"])

    def test_a_shader_is_printed_as_its_method_has_it(self):
        strip, table = (self.run_nullscope("capture", "sky-only", "--dump-shader", "--method", method).out for method in ("strip", "table"))
        self.assertNotEqual(strip, table)

    def test_spectra(self):
        for words, says in ((("no-such-scene",), ["no-such-scene"]),
                            (("flat",), ["minkowski", "no disc", "a black hole's metric"]),
                            (("kottler",), ["not flat far out", "A = 1"]),
                            (("s-stars",), ["90 degrees", "0 to 89 degrees"]),
                            (("kerr", "--spin", "0.5"), ["--spin", "a scene or --spin"]),
                            (("--spin", "-1.01"), ["--spin", "-1 to 1"]),
                            (("--inclination", "181"), ["--inclination", "0 to 180"]),
                            (("--inclination", "89.5"), ["89.5 degrees", "0 to 89 degrees"]),
                            (("--inner", "near"), ["--inner near", "isco"]),
                            (("--inner", "0.5"), ["0.5 r_s", "from 1.001"]),
                            (("--outer", "2"), ["2 r_s", "--outer above 3"]),
                            (("--ring", "1"), ["--ring 1", "from 1.001"]),
                            (("--ring", "5", "--outer", "9"), ["--ring", "--outer"]),
                            (("--emissivity", "hot"), ["--emissivity hot", "-20 to 20", "thermal"]),
                            (("--emissivity", "thermal", "--ring", "2"), ["dark", "3 r_s"]),
                            (("--emissivity", "lamp:0.9"), ["0.9", "above 1"]),
                            (("--emissivity", "lamp:5:11"), ["--emissivity lamp:5:11", "lamp:HEIGHT"]),
                            (("--emissivity", "3:5"), ["--emissivity 3:5", "Q:R:Q"]),
                            (("--emissivity", "3:5:2:4:1"), ["--emissivity 3:5:2:4:1", "Q:R:Q"]),
                            (("--emissivity", "none.csv"), ["none.csv"]),
                            (("--limb", "none"), ["--limb none", "isotropic, laor, haardt"]),
                            (("--bins", "0"), ["--bins 0", "1 to 100000"]),
                            (("--line", "0"), ["--line 0", "1e-09"]),
                            (("--from", "2"), ["2 to 1.05", "--to is not above --from"])):
            self.refused("spectrum", *words, says=says)

    def test_profiles(self):
        small = ("profile", "flat", "--size", "16x9")
        for place in ("0,3", "17,3", "3,9", "3", "1,2,3", "a,b", "nan,1", ""):
            if place:
                self.refused(*small, "--through", place, says=["--through", "0 < X < 16 and 0 < Y < 9"])
        self.refused(*small, "--angle", "361", says=["--angle", "-360 to 360"])
        self.refused(*small, "--steps", "1", says=["--steps", "2 to 100000"])
        self.refused(*small, "--samples", "17", says=["--samples", "1 to 16"])
        self.refused(*small, "-o", "nowhere/a", status=1, says=["nowhere/a.csv"])
        self.refused(*small, "--renderer", "reference", "--context", "egl", says=["--context", "--renderer gl"])
        self.refused("profile", "two-spacetimes", says=["one picture", "[split]"])
        self.refused("profile", self.write("pair.toml", '[camera]\nstereo = "pair"\n'), says=["one picture", "camera.stereo"])

    def test_photon_rings(self):
        self.refused("figure", "photon-ring", "flat", says=["minkowski: there is no photon sphere"])
        self.refused("figure", "photon-ring", "neutron-star", says=["r = 1.5, is not outside of the surface, r = 1.6"])
        self.refused("figure", "photon-ring", "long-wormhole", says=["in the tube", "allowed: length = 0"])
        self.refused("figure", "photon-ring", "-o", "ring.csv", says=["ring.csv", ".svg"])
        self.refused("figure", "photon-ring", "--rings", "17", says=["--rings", "2 to 16"])

    def test_names_of_a_sequence(self):
        for name, allowed in (("a.png", "%05d"), ("a%05d%d.png", "%05d"), ("a#b#.png", "%05d"), ("a%020d.png", "%05d"),
                              ("a%s.png", "cube")):
            self.refused("capture", "flat", "--size", "4x2", "--frames", "0:2", "-o", name, says=[name, "allowed", allowed])

    def test_sizes(self):
        for size in ("0x0", "1x", "x1", "-3x4", "99999999x1", "1.5x2", "axb", "10x10x10", "1e400x1", "nanx1"):
            self.refused("capture", "flat", f"--size={size}", "-o", "a.png", says=["--size", "1x1", "65536x65536"])
        self.refused("capture", "flat", "--size", "65536x1", "-o", "a.png", says=["65536x1", "allowed"])

    def test_outputs(self):
        (self.folder / "folder.png").mkdir()
        self.write("file", "")
        small = ("--size", "16x9")
        self.refused("capture", "flat", *small, "-o", "a.bmp", says=["a.bmp", ".png", ".exr", ".fits"])
        self.refused("capture", "flat", *small, "-o", "a.png", "--raydata", says=["--raydata", ".exr"])
        self.refused("capture", "flat", *small, "-o", "nowhere/a.png", status=1, says=["nowhere/a.png", "there is no folder"])
        self.refused("capture", "flat", *small, "-o", "file/a.png", status=1, says=["file/a.png"])
        self.refused("capture", "flat", *small, "-o", "folder.png", status=1, says=["folder.png", "directory"])
        for name in ("nowhere/a.exr", "nowhere/a.fits"):
            self.refused("capture", "flat", *small, "-o", name, status=1, says=[name])
        for option in ("--raydata", "--layers", "--half"):
            self.refused("capture", "flat", *small, "-o", "a.fits", option, says=[option, ".exr"])
        rays = self.write("rays.csv", RAYS + GOOD)
        self.refused("trace", "flat", "--rays", rays, "-o", "nowhere/a.csv", status=1, says=["nowhere/a.csv"])
        self.refused("trace", "flat", "--rays", rays, "-o", "folder.png", status=1, says=["folder.png", "directory"])

    def test_no_room_for_the_file(self):
        def no_room():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))   # bytes: the header of a picture and some rows

        kept = self.write("kept.png", "an older file")
        rays = self.write("rays.csv", RAYS + GOOD * 100)
        small = ("--size", "64x36")
        for output in ("new.png", kept, "new.exr"):
            options = ("capture", "sky-only", *small, "-o", output)
            self.refused(*options, status=1, says=["cannot write", str(output)], before=no_room)
        self.refused("trace", "flat", "--rays", rays, "-o", "new.csv", status=1, says=["new.csv"], before=no_room)
        self.assertEqual((self.folder / "kept.png").read_text(), "an older file")

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_folder_without_permission(self):
        locked = self.folder / "locked"
        locked.mkdir(mode=0o500)
        output = ("-o", locked / "a.png")
        self.refused("capture", "flat", "--size", "16x9", *output, status=1, says=["locked/a.png", "ermission"])


class Scenes(support.CliTest):
    COMMANDS = (("capture", "-o", "a.png"), ("capture", "--dump-shader"), ("plan",), ("trace", "--rays", "none.csv"))

    def everywhere(self, scene, says):
        for command, *options in self.COMMANDS:
            self.refused(command, scene, *options, says=says)

    def test_no_such_scene(self):
        self.everywhere("first-lihgt", ["first-lihgt", "nearest: first-light; see: nullscope scenes"])
        self.everywhere("nowhere/scene.toml", ["nowhere/scene.toml"])
        self.everywhere(".", ["folder"])
        self.everywhere("a\x1b[2Jb\nc", ["no such file"])

    def test_broken_files(self):
        self.everywhere(self.write("broken.toml", "[camera\nr = 3\n"), ["broken.toml:1"])
        self.everywhere(self.write("binary.toml", bytes(range(256)) * 40), ["binary.toml:1"])
        self.everywhere(self.write("deep.toml", "a" + ".a" * 5000 + " = 1\n"), ["deep.toml:1", "dots"])

    def test_keys_and_values(self):
        cases = {
            "[camera]\n\nfoov = 60\n": [":3:", "camera.foov", "unknown key", "nearest known key: camera.fov"],
            "[camera]\nr = 0.5\n": [":2:", "camera.r", "0.5", "allowed: r > 1"],
            "[camera]\nr = 1\n": [":2:", "camera.r", "allowed: r > 1"],
            "[camera]\nvelocity = [0.0, 0.6, 0.8]\n": [":2:", "camera.velocity", "below 1"],
            "[camera]\nvelocity = [2.0, 0.0, 0.0]\n": [":2:", "camera.velocity", "below 1"],
            "[camera]\nfov = 180\n": [":2:", "camera.fov", "(0, 180)"],
            "[camera]\nsize = [0, 10]\n": [":2:", "camera.size", "65536"],
            "[camera]\ntheta = nan\n": [":2:", "camera.theta", "[0, 180]"],
            "[camera]\nr = \"far\"\n": [":2:", "camera.r"],
            "[spacetime]\nmetric = \"schwarzshild\"\n": [":2:", "spacetime.metric", "schwarzschild"],
            "[sky]\nkind = \"image\"\nimage = \"none.png\"\n": [":3:", "sky.image", "none.png"],
            "[disc]\ninner = 5\nouter = 4\n": [":2:", "disc.inner", "inner < outer"],
        }
        for text, says in cases.items():
            self.everywhere(self.write("bad.toml", text), ["bad.toml"] + says)

    def test_methods_of_spinning_holes(self):
        for scene, method, says in (("kerr", "strip", ["strip", "allowed: auto, mino"]), ("kerr", "mino:4", ["mino:4:0.6", "allowed: auto, mino"]),
                                    ("kerr", "mino:5", ["mino:5", "ORDER 4 or 6"]), ("sky-only", "mino", ["mino:6:0.6", "rotating holes only"])):
            self.refused("capture", scene, "--size", "16x9", "--method", method, "-o", "a.png", says=says)

    def test_images_that_are_none(self):
        self.write("fake.png", b"this is no image" * 100)
        self.write("cut.png", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x10")
        self.write("fake.exr", b"\x76\x2f\x31\x01" + bytes(200))
        for image in ("fake.png", "cut.png", "fake.exr"):
            sky = self.write("sky.toml", f'[sky]\nkind = "image"\nimage = "{image}"\n')
            disc = self.write("disc.toml", f'[disc]\nimage = "{image}"\n')
            for scene in (sky, disc):
                for renderer in ("gl", "reference"):
                    options = ("--size", "16x9", "--renderer", renderer, "-o", "a.png")
                    self.refused("capture", scene, *options, says=[image])
            self.refused("plan", disc, says=[image])


class Rays(support.CliTest):
    def bad_rays(self, text, *says, scene="sky-only"):
        rays = self.write("rays.csv", text)
        for tracer in ("reference", "core64"):
            self.refused("trace", scene, "--rays", rays, "--with", tracer, "-o", "out.csv", says=["rays.csv", *says])

    def test_files(self):
        self.refused("trace", "flat", "--rays", "none.csv", says=["none.csv", "no such file"])
        self.refused("trace", "flat", "--rays", ".", says=["directory"])
        self.bad_rays("", ":1: header", "allowed: r,theta,phi")
        self.bad_rays("# only a comment\n\n", ":1: header")
        self.bad_rays(bytes(range(256)) * 40, ": header: missing")
        self.bad_rays(b"\x1b[2J\x07\0" * 5, ": header: missing")
        self.bad_rays("x" * 1000000, ":1: header: missing")

    def test_headers(self):
        self.bad_rays("r,theta,phi,n_r,n_phi\n", ":1: header: missing: n_theta;", "or q,zeta0,s")
        self.bad_rays("# a\n\nq,zeta0\n0.5,0.1\n", ":3: header: missing: s;")
        self.bad_rays("r,r,theta,phi,n_r,n_theta,n_phi\n", ":1: r:", "twice")
        self.bad_rays("r,theta,phi,n_r,n_theta,n_phi,q,zeta0,s\n", ":1: header: columns of several forms")
        self.bad_rays("alpha,theta\n", ":1: header: missing: beta;", "alpha,beta,theta")
        self.bad_rays("alpha,beta,theta,r\n", ":1: header: columns of several forms")
        self.bad_rays("alpha,beta,theta\n1e5,0,1\n", ":2: alpha:", "[-1e4, 1e4] r_s")
        self.bad_rays('"r,theta,phi\n', ":1: header: a quote is not closed")

    def test_values(self):
        cases = {
            "nan,1.5,0,-1,0,0": ["r: \"nan\" is not a finite number", "allowed: r from"],
            "inf,1.5,0,-1,0,0": ["r: \"inf\" is not a finite number"],
            "1e400,1.5,0,-1,0,0": ["r: \"1e400\" is not a finite number"],
            "-5,1.5,0,-1,0,0": ["r: \"-5\" is out of range"],
            "0.5,1.5,0,-1,0,0": ["r: \"0.5\" is not outside the horizon", "allowed: r > 1, or frame = rain"],
            "10,1.5,0,0,0,0": ["n_r: the view direction is zero", "not all zero"],
            "10,4,0,-1,0,0": ["theta: \"4\" is out of range", "[0, pi]"],
            "10,1.5,zero,-1,0,0": ["phi: \"zero\" is not a finite number"],
            "10,1.5,0,-1,0,": ["n_phi: \"\" is not a finite number"],
            "10,1.5,0,-1,0,0x10": ["n_phi"],
            "10,1.5,0,-1,0,1 2": ["n_phi: \"1 2\""],
            "10,1.5,0,-1,0": ["row: 5 fields", "allowed: 6", "line 1"],
            "10,1.5,0,-1,0,0,0": ["row: 7 fields"],
            "10;1.5;0;-1;0;0": ["row: 1 fields"],
            '10,1.5,0,-1,0,"1': ["row: a quote is not closed"],
            '10,1.5,0,-1,0,"1"2': ["row: a quote is not closed, or something follows it"],
            "10,1.5,0,-1,0," + "9" * 100000: ["n_phi"],
            "10,1.5,0,-1,0,\x1b[31m": ["n_phi: \"?[31m\""],
        }
        for row, says in cases.items():
            self.bad_rays(RAYS + GOOD + "# comment\n" + row + "\n", ":4: ", *says)

    def test_other_columns(self):
        with_frame = RAYS.replace("n_phi", "n_phi,frame,at_angle")
        self.bad_rays(with_frame + "10,1.5,0,-1,0,0,moving,\n", ":2: frame: \"moving\"", "static, rain")
        self.bad_rays(with_frame + "10,1.5,0,-1,0,0,,-1\n", ":2: at_angle: \"-1\" is out of range")
        self.bad_rays(with_frame + "10,1.5,0,-1,0,0,,nan\n", ":2: at_angle: \"nan\"")
        self.bad_rays("q,zeta0,s\n0,0.1,1\n", ":2: q: \"0\" is out of range")
        self.bad_rays("q,zeta0,s\n0.5,-1,1\n", ":2: zeta0: \"-1\" is out of range")
        self.bad_rays("q,zeta0,s\n0.5,0.1,0\n", ":2: s: \"0\" is no direction", "1 (towards the hole) or -1 (away)")
        self.bad_rays("q,zeta0,s\n0.5,0.1,2\n", ":2: s: \"2\"")
        self.bad_rays("q,zeta0,s\n0.05,0.1,1\n", ":2: q: \"0.05\" is too small", "q >= 0.09")


if __name__ == "__main__":
    support.main()
