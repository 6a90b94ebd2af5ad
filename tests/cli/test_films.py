#!/usr/bin/env python3
"""Films and sequences: a run that was killed is resumed without loss, two runs never mix, one run at a time draws.

ffmpeg is replaced by a program that writes down which pictures it was given.
"""
import hashlib
import json
import os
import re
import resource
import shutil
import signal
import struct
import subprocess
import unittest

import support

FAKE_FFMPEG = """#!/usr/bin/env python3
import hashlib, json, os, sys
words = sys.argv[1:]
if "-version" in words:
    sys.exit(0)
value = lambda name: words[words.index(name) + 1]
first, count, pattern = int(value("-start_number")), int(value("-frames:v")), value("-i")
rows = []
for frame in range(first, first + count):
    file = pattern % frame
    rows.append({"hash": hashlib.sha256(open(file, "rb").read()).hexdigest(), "time": os.stat(file).st_mtime_ns})
texts = open(words[words.index("ffmetadata") + 2]).read()
json.dump({"rows": rows, "words": words, "texts": texts}, open(words[-1], "w"))
"""
DYING_FFMPEG = """#!/bin/sh
case "$*" in *-version*) exit ;; esac
for output; do :; done
echo half of a film > "$output"
%s
"""
SIZE = ("--size", "16x9")
FRAMES = 40
MOVING = ("--time-step", "0.25", "--frames", f"0:{FRAMES}")
ENDLESS = ("--time-step", "0.25", "--frames", "0:1000000")   # the same pictures and more: killed long before its end
SCENE = 'time = 1\n[sky]\nkind = "grid"\n[camera]\nr = 9\n'


class FilmTest(support.CliTest):
    def setUp(self):
        super().setUp()
        self.environment = {**os.environ, "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"}
        self.install(FAKE_FFMPEG)
        self.write("scene.toml", SCENE)

    def install(self, ffmpeg):
        (self.folder / "bin").mkdir(exist_ok=True)
        (self.folder / "bin" / "ffmpeg").write_text(ffmpeg)
        (self.folder / "bin" / "ffmpeg").chmod(0o755)

    def capture(self, *words, status=0):
        return self.run_nullscope("capture", "scene.toml", *words, status=status, environment=self.environment)

    def pictures(self, folder="."):
        return sorted(p for p in (self.folder / folder).glob("*.png") if not p.name.startswith("."))

    def begun(self, *words, folder="."):
        """A run that has drawn some pictures and goes on; its process."""
        process = self.started("capture", "scene.toml", *words, env=self.environment, stderr=subprocess.DEVNULL)
        self.wait("three pictures", lambda: len(self.pictures(folder)) >= 3, process, pause_s=0.001)
        return process

    def killed(self, *words, folder="."):
        process = self.begun(*words, folder=folder)
        process.kill()
        process.wait(timeout=support.LONGEST_S)
        pictures = self.pictures(folder)
        return {int(p.stem): p.stat().st_mtime_ns for p in pictures[:FRAMES]} if folder != "." else {}

    def film(self, name):
        return json.loads((self.folder / name).read_text())["rows"]

    def words(self, name):
        return json.loads((self.folder / name).read_text())["words"]

    def texts(self, name):
        """What the film says of itself, as ffmpeg is told."""
        lines = json.loads((self.folder / name).read_text())["texts"].replace("\\\n", "\0").splitlines()
        self.assertEqual(lines[0], ";FFMETADATA1")
        unquoted = lambda text: re.sub(r"\\(.)", r"\1", text).replace("\0", "\n")
        return {key: unquoted(value) for key, value in (re.fullmatch(r"([\w.]+)=(.*)", line).groups() for line in lines[1:])}

    def hashes(self, name):
        return [row["hash"] for row in self.film(name)]


class Films(FilmTest):
    def test_a_killed_film_is_resumed_without_loss(self):
        self.capture(*SIZE, *MOVING, "-o", "whole.mp4")
        kept = self.killed(*SIZE, *ENDLESS, "-o", "film.mp4", folder="film.mp4.frames")
        ran = self.capture(*SIZE, *MOVING, "-o", "film.mp4")
        self.assertNotIn("starting over", ran.err)
        self.assertEqual(self.hashes("film.mp4"), self.hashes("whole.mp4"))
        for frame, when in kept.items():
            self.assertEqual(self.film("film.mp4")[frame]["time"], when, "a whole picture was drawn again")
        self.assertFalse((self.folder / "film.mp4.frames").exists())

    @support.costly
    def test_a_changed_film_is_drawn_anew(self):
        changes = {"camera.r": (SCENE.replace("r = 9", "r = 8"), SIZE, MOVING), "camera.size": (SCENE, ("--size", "18x10"), MOVING),
                   "--time-step": (SCENE, SIZE, ("--time-step", "0.5", *MOVING[2:])),
                   "--renderer": (SCENE, SIZE, (*MOVING[:3], "0:4", "--renderer", "reference", "--samples", "1"))}
        for named, (scene, size, moving) in changes.items():
            with self.subTest(named):
                self.write("scene.toml", SCENE)
                self.killed(*SIZE, *ENDLESS, "-o", "film.mp4", folder="film.mp4.frames")
                self.write("scene.toml", scene)
                ran = self.capture(*size, *moving, "-o", "film.mp4")
                said = [line for line in ran.err.splitlines() if "starting over" in line]
                self.assertEqual(len(said), 1, ran)
                self.assertIn(named, said[0])
                self.capture(*size, *moving, "-o", "whole.mp4")
                self.assertEqual(self.hashes("film.mp4"), self.hashes("whole.mp4"))

    def test_a_shorter_film_of_the_same_pictures(self):
        self.killed(*SIZE, *ENDLESS, "-o", "film.mp4", folder="film.mp4.frames")
        self.capture(*SIZE, "--time-step", "0.25", "--frames", "0:2", "-o", "film.mp4")
        self.assertEqual(len(self.film("film.mp4")), 2)

    def test_one_run_at_a_time(self):
        for output, folder in (("film.mp4", "film.mp4.frames"), ("%d.png", ".")):
            process = self.begun(*SIZE, *ENDLESS, "-o", output, folder=folder)
            process.send_signal(signal.SIGSTOP)
            os.waitpid(process.pid, os.WUNTRACED)   # once it stands still
            short = ("capture", "scene.toml", *SIZE, "--time-step", "0.25", "--frames", "0:9", "-o", output)
            self.refused(*short, status=1, says=["another run is drawing it"], environment=self.environment)
            self.refused(*short, "--resume", status=1, says=["another run is drawing it"], environment=self.environment)
            process.kill()
            process.wait(timeout=support.LONGEST_S)
            self.run_nullscope(*short, "--resume", environment=self.environment)   # the lock went with the process


class Encoders(FilmTest):
    SHORT = (*SIZE, "--time-step", "0.25", "--frames", "0:3")

    def test_ffmpeg_fails_in_the_middle(self):
        """One line, the pictures stay, and the next run makes the film of them."""
        for how, says in (("kill -9 $$", "Killed"), ("echo no space >&2; echo left >&2; exit 3", "exit status 3: no space)"),
                          ("exit 127", "not installed")):
            self.install(DYING_FFMPEG % how)
            ran = self.capture(*self.SHORT, "-o", "film.mp4", status=1)
            self.assertEqual((ran.out, ran.err.count("\n")), ("", 1), ran)
            self.assertIn(says, ran.err)
            self.assertIn("the pictures are in film.mp4.frames", ran.err)
            self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["bin", "film.mp4.frames", "scene.toml"])
            times = [p.stat().st_mtime_ns for p in self.pictures("film.mp4.frames")]
        self.install(FAKE_FFMPEG)
        self.capture(*self.SHORT, "-o", "film.mp4")
        self.assertEqual([row["time"] for row in self.film("film.mp4")], times)

    def test_ffmpeg_is_missing(self):
        """Nothing is drawn for nothing."""
        self.refused("capture", "scene.toml", *self.SHORT, "-o", "film.mov", status=1, says=["ffmpeg is not installed"],
                     environment={"PATH": str(self.folder)})

    def test_each_ending_has_its_codec_unless_one_is_named(self):
        for ending, codec in ((".mp4", "libx264"), (".mov", "prores_ks"), (".mkv", "ffv1"), (".webm", "libvpx-vp9")):
            self.capture(*self.SHORT, "-o", f"film{ending}", "--", "-metadata", "title=A  fall")
            words = self.words(f"film{ending}")
            self.assertEqual(words[words.index("-c:v") + 1], codec)
            self.assertEqual(words[-3:-1], ["-metadata", "title=A  fall"])
        self.capture(*self.SHORT, "-o", "film.mp4", "--", "-c:v", "libx265")
        words = self.words("film.mp4")
        self.assertEqual((words.count("-c:v"), words[words.index("-c:v") + 1], "-crf" in words), (1, "libx265", False))

    def test_a_film_says_what_it_was_made_from(self):
        """As its pictures do, of all of them: the scene's text is a scene, and draws them again."""
        title = 'Film; = # \\\\ größe'
        self.write("scene.toml", f'name = "{title}"\n' + SCENE)
        self.capture(*SIZE, "--time-step", "0.25", "--frames", "2:5", "-o", "film.mkv", "--", "-crf", "9")
        said = self.texts("film.mkv")
        self.assertEqual(said["title"], title.replace("\\\\", "\\"))
        for word in ("scene_hash", "renderer", "version"):
            self.assertTrue(said[f"nullscope.{word}"], word)
        self.assertEqual(said["nullscope.options"], "--method strip --time-step 0.25 --frames 2:5 --time-frame 2 -- -crf 9")
        self.write("again.toml", said["nullscope.scene_text"])
        self.run_nullscope("capture", "again.toml", *said["nullscope.options"].split(" -- ")[0].split(), "-o", "again%d.png")
        self.assertEqual([hashlib.sha256((self.folder / f"again{n}.png").read_bytes()).hexdigest() for n in (2, 3, 4)], self.hashes("film.mkv"))

    def test_films_of_the_sphere_that_cannot_be_marked(self):
        """Where ffmpeg wrote something else there is one line, the pictures stay and no film; films with a filter of one's own, .mkv with any
        option, and those with a changing field of view are not marked."""
        self.write("scene.toml", SCENE + 'projection = "equirectangular"\nfov = 180\n')
        for ending in (".mp4", ".mov", ".mkv", ".webm"):
            ran = self.capture(*self.SHORT, "-o", "film" + ending, status=1)
            self.assertEqual((ran.out, ran.err.count("\n")), ("", 1), ran)
            self.assertIn(f"film{ending} could not be marked as a film of the sphere (not an MP4 or QuickTime film", ran.err)
            self.assertIn(f"the pictures are in film{ending}.frames", ran.err)
            self.assertEqual([p.name for p in self.folder.glob(f"*film{ending}*") if p.is_file()], [])
            self.assertEqual(list((self.folder / f"film{ending}.frames").glob("*film*")), [])
        self.capture(*self.SHORT, "-o", "film.mp4", "--", "-vf", "v360=e:c3x2")
        self.capture(*self.SHORT, "-o", "film.mkv", "--", "-level", "3")
        self.write("zoom.csv", "frame,r,fov\n0,9,180\n1,9,170\n")
        self.write("scene.toml", SCENE + 'size = [16, 9]\nprojection = "equirectangular"\n[path]\nkind = "keys"\nfile = "zoom.csv"\n')
        self.capture("-o", "zoom.mov")

    def test_words_for_ffmpeg_without_a_film(self):
        for words in (("-o", "a.png", "--", "-crf", "12"), ("more", "-o", "film.mp4"), ("more",)):
            self.refused("capture", "scene.toml", *self.SHORT, *words, says=["not expected here", "after --"],
                         environment=self.environment)


@unittest.skipIf(support.QUICK, "ffmpeg itself: with --all")
class RealFfmpeg(support.CliTest):
    MOVING = ("--size", "65x37", "--time-step", "0.25", "--frames", "0:5")

    def setUp(self):
        super().setUp()
        for program in ("ffmpeg", "ffprobe"):
            self.assertTrue(shutil.which(program), f"{program} is not here: scripts/install-packages.sh --all installs it")
        self.write("scene.toml", SCENE)

    def probe(self, name):
        out = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-of", "json", "-show_entries",
                              "stream=codec_name,profile,pix_fmt,width,height,r_frame_rate,nb_read_frames,"
                              "color_space,color_primaries,color_transfer,color_range", name],
                             cwd=self.folder, capture_output=True, check=True).stdout
        return json.loads(out)["streams"][0]

    def frame(self, name, kind, *words):
        """The samples of its first frame, in a format of ffmpeg's."""
        return subprocess.run(["ffmpeg", "-v", "error", *words, "-i", name, "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", kind, "-"],
                              cwd=self.folder, capture_output=True, check=True).stdout

    def test_films(self):
        self.run_nullscope("capture", "scene.toml", "--size", "64x36", "-o", "one.png")
        for ending, codec, kind in ((".mp4", "h264", "yuv420p"), (".mov", "prores", "yuv422p10le"), (".mkv", "ffv1", "bgr0"),
                                    (".webm", "vp9", "yuv420p")):
            name = "film" + ending
            self.run_nullscope("capture", "scene.toml", *self.MOVING, "-o", name, "--workers", "2")
            film = self.probe(name)
            self.assertEqual((film["codec_name"], film["pix_fmt"], film["width"], film["height"], film["nb_read_frames"]),
                             (codec, kind, 64, 36, "5"), film)
            self.assertEqual(film["r_frame_rate"], "24/1")
            if codec == "prores":
                self.assertEqual(film["profile"], "HQ")
            self.assertEqual([film.get(f"color_{of}") for of in ("space", "range", "primaries", "transfer")],
                             [*(("gbr", "pc") if codec == "ffv1" else ("bt709", "tv")), "bt709", "iec61966-2-1"], name)
        self.run_nullscope("capture", "scene.toml", *self.MOVING, "-o", "film.mp4", "--", "-c:v", "mpeg4", "-q:v", "2")
        self.assertEqual(self.probe("film.mp4")["codec_name"], "mpeg4")

    def test_what_films_say(self):
        """Of any length, by ffprobe; Matroska has its keywords in capitals."""
        way = "9" + " + 0.1*t" * 60
        balls = "".join(f'[[ball]]\nmotion = "path"\nx = "{way}"\ny = "{i}"\nz = "0"\nradius = 0.3\n' for i in range(20))
        self.write("scene.toml", SCENE + balls)
        for ending in (".mp4", ".mov", ".mkv", ".webm"):
            self.run_nullscope("capture", "scene.toml", "--size", "16x10", "--time-step", "0.25", "--frames", "0:2", "-o", "film" + ending)
            out = subprocess.run(["ffprobe", "-v", "error", "-of", "json", "-show_entries", "format_tags", "film" + ending],
                                 cwd=self.folder, capture_output=True, check=True).stdout
            said = {key.lower(): value for key, value in json.loads(out)["format"]["tags"].items()}
            self.assertGreater(len(said["nullscope.scene_text"]), 10000)
            self.write("again.toml", said["nullscope.scene_text"])
            self.run_nullscope("plan", "again.toml")

    def test_colours(self):
        """A plain saturated sky: a player shows the colour of the picture."""
        self.write("scene.toml", '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "plain"\ncolour = [0.8, 0.1, 0.05]\n')
        self.run_nullscope("capture", "scene.toml", *self.MOVING, "-o", "f%d.png")
        middle = 3 * (18 * 64 + 32)
        for name in ("film.mp4", "film.mov", "film.mkv", "film.webm"):
            self.run_nullscope("capture", "scene.toml", *self.MOVING, "-o", name)
            shown = self.frame(name, "rgb24")[middle:middle + 3]
            meant = self.frame("f0.png", "rgb24")[middle:middle + 3]
            for a, b in zip(shown, meant):
                self.assertLessEqual(abs(a - b), 0 if name.endswith(".mkv") else 4, (name, list(shown), list(meant)))

    def test_films_of_the_sphere(self):
        """Which part it is, and of which eyes, by ffprobe; the pictures are found where the file says."""
        camera = SCENE + 'projection = "equirectangular"\n'
        quarter = 1 << 30   # of 2^32
        for words, eyes, projection, bounds in (
                ("size = [64, 32]", None, "equirectangular", (0, 0, 0, 0)),
                ('size = [64, 32]\nstereo = "all-round"', "top and bottom", "equirectangular", (0, 0, 0, 0)),
                ("size = [64, 64]\nfov = 180", None, "tiled equirectangular", (0, 0, quarter, quarter))):
            self.write("scene.toml", camera + words)
            self.run_nullscope("capture", "scene.toml", *self.MOVING[2:], "-o", "f%d.png")
            for name in ("film.mp4", "film.mov", "film.mkv", "film.webm"):
                self.run_nullscope("capture", "scene.toml", *self.MOVING[2:], "-o", name)
                out = subprocess.run(["ffprobe", "-v", "error", "-of", "json", "-show_streams", name], cwd=self.folder, capture_output=True,
                                     check=True).stdout
                said = {data.pop("side_data_type"): data for data in json.loads(out)["streams"][0]["side_data_list"]}
                self.assertEqual(said.get("Stereo 3D", {}).get("type"), eyes, said)
                self.assertEqual(said["Spherical Mapping"]["projection"], projection)
                self.assertIn("scene_text", "".join(self.tags(name)))
                head = b"equi" if name in ("film.mp4", "film.mov") else b"\x76\x72\x94"   # Matroska's ProjectionPrivate, of 20 bytes
                box = (self.folder / name).read_bytes().split(head + bytes(4))[1]   # ffprobe rounds to whole px
                self.assertEqual(struct.unpack(">4I", box[:16]), bounds)
                shown, meant = (self.frame(file, "gray") for file in (name, "f0.png"))
                off = sum(abs(a - b) for a, b in zip(shown, meant, strict=True)) / len(meant)
                self.assertLessEqual(off, 0 if name == "film.mkv" else 6, name)
            self.are_tagged_rgb("film.mkv", "bgr0")

    def are_tagged_rgb(self, name, kind):
        """As a .mkv that is not of the sphere."""
        film = self.probe(name)
        self.assertEqual([film.get(of) for of in ("codec_name", "pix_fmt", "color_space", "color_range", "color_primaries", "color_transfer")],
                         ["ffv1", kind, "gbr", "pc", "bt709", "iec61966-2-1"])

    def tags(self, name):
        out = subprocess.run(["ffprobe", "-v", "error", "-of", "json", "-show_entries", "format_tags", name], cwd=self.folder,
                             capture_output=True, check=True).stdout
        return {key.lower(): value for key, value in json.loads(out)["format"]["tags"].items()}

    def test_films_of_ten_bits(self):
        """A dark gradient has more levels than 8 bits have; tags as of others; redrawn from 16-bit pictures."""
        self.write("scene.toml", '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "plain"\ncolour = [0.02, 0.02, 0.02]\n[disc]\ninner = 3\nouter = 60\n'
                                 'texture = "formula"\nformula = "0.01 + 0.02 * u"\n[camera]\ntheta = 60\nr = 30\n')
        for name, codec, kind in (("film.mp4", "hevc", "yuv420p10le"), ("film.mov", "prores", "yuv422p10le"), ("film.mkv", "ffv1", "gbrp10le"),
                                  ("film.webm", "vp9", "yuv420p10le")):
            self.run_nullscope("capture", "scene.toml", *self.MOVING, "--bits", "10", "-o", name)
            film = self.probe(name)
            self.assertEqual((film["codec_name"], film["pix_fmt"], film["nb_read_frames"]), (codec, kind, "5"), film)
            self.assertEqual([film.get(f"color_{of}") for of in ("space", "range", "primaries", "transfer")],
                             [*(("gbr", "pc") if codec == "ffv1" else ("bt709", "tv")), "bt709", "iec61966-2-1"], name)
            self.assertIn("--bits 10", self.tags(name)["nullscope.options"])
        self.run_nullscope("capture", "scene.toml", *self.MOVING, "-o", "eight.mkv")
        count = {name: len(set(struct.unpack(f"<{64 * 36}H", self.frame(name, "gbrp16le")[:2 * 64 * 36]))) for name in ("film.mkv", "eight.mkv")}
        self.assertGreater(count["film.mkv"], 1.5 * count["eight.mkv"], count)
        self.write("scene.toml", SCENE + 'projection = "equirectangular"\n')
        self.run_nullscope("capture", "scene.toml", *self.MOVING, "--bits", "10", "-o", "sphere.mkv")
        self.are_tagged_rgb("sphere.mkv", "gbrp10le")

    def test_a_film_of_exr_files_is_that_of_the_pictures(self):
        """By docs/vfx.md's command: within 2 of 255."""
        self.write("scene.toml", SCENE + "[picture]\nbloom = 0.2\n[disc]\n")
        self.run_nullscope("capture", "scene.toml", *self.MOVING, "--colour", "display", "-o", "f%05d.exr")
        self.run_nullscope("capture", "scene.toml", *self.MOVING, "-o", "p%05d.png")
        subprocess.run(["ffmpeg", "-v", "error", "-framerate", "24", "-i", "f%05d.exr", "-vf", "zscale=tin=linear:t=iec61966-2-1,format=gbrp10",
                        "-c:v", "ffv1", "shot.mkv"], cwd=self.folder, check=True)
        self.assertEqual(self.probe("shot.mkv")["nb_read_frames"], "5")
        shown, meant = self.frame("shot.mkv", "rgb24"), self.frame("p00000.png", "rgb24")
        apart = [abs(a - b) for a, b in zip(shown, meant, strict=True)]
        self.assertLessEqual(max(apart), 2)
        self.assertLess(sum(apart) / len(apart), 1)
        self.assertGreater(max(meant), 100)

    def test_ffmpeg_refuses(self):
        words = ("capture", "scene.toml", *self.MOVING, "-o", "film.mp4")
        for more, says in ((("-c:v", "no-such-codec"), "no-such-codec"), (("-no-such-option", "1"), "no-such-option")):
            ran = self.run_nullscope(*words, "--", *more, status=1)
            self.assertEqual(ran.err.count("\n"), 1, ran)
            self.assertIn(says, ran.err)

    def test_no_room_for_the_film(self):
        def little():
            resource.setrlimit(resource.RLIMIT_FSIZE, (8000, 8000))   # a picture, and no film

        words = ("capture", "scene.toml", *self.MOVING, "-o", "film.mkv")
        ran = self.run_nullscope(*words, status=1, before=little)
        self.assertEqual(ran.err.count("\n"), 1, ran)
        self.assertIn("File too large", ran.err)
        self.assertEqual(len(list((self.folder / "film.mkv.frames").glob("[0-9]*.png"))), 5)
        self.assertFalse(list(self.folder.glob(".*")))
        self.run_nullscope(*words)
        self.assertEqual(self.probe("film.mkv")["nb_read_frames"], "5")

    def test_exr_files_are_read(self):
        """A stored sequence, by ffmpeg, which writes the same values."""
        self.run_nullscope("capture", "scene.toml", *self.MOVING, "-o", "colours%d.exr")
        for words, meant in (((), "colours1.exr"), (("--half",), "f1.exr"), (("--raydata",), "colours1.exr")):
            self.run_nullscope("capture", "scene.toml", *self.MOVING, *words, "-o", "f%d.exr")
            subprocess.run(["ffmpeg", "-v", "error", "-y", "-start_number", "1", "-i", "f%d.exr", "-frames:v", "1", "-c:v", "exr", "read.exr"],
                           cwd=self.folder, check=True, timeout=support.LONGEST_S)
            self.assertIn("max 0 ", self.run_nullscope("compare", meant, "read.exr").out, words)


class Sequences(FilmTest):
    def test_another_scene_is_refused(self):
        words = (*SIZE, *MOVING, "-o", "f%05d.png")
        self.killed(*SIZE, *ENDLESS, "-o", "f%05d.png")
        for scene, changed, says in ((SCENE.replace("grid", "checker"), words, "sky.kind"),
                                     (SCENE, ("--size", "8x8", *words[2:]), "camera.size"),
                                     (SCENE, (*SIZE, "--time-step", "0.5", *words[4:]), "--time-step")):
            self.write("scene.toml", scene)
            self.refused("capture", "scene.toml", *changed, "--resume", says=["--resume", says, "start over"],
                         environment=self.environment)
        self.write("scene.toml", SCENE)
        stamp = self.folder / "f.png.stamp"
        text = stamp.read_text()
        stamp.unlink()
        self.refused("capture", "scene.toml", *words, "--resume", says=["they have no stamp"], environment=self.environment)
        stamp.write_text(text[:100])
        self.refused("capture", "scene.toml", *words, "--resume", says=["do not match"], environment=self.environment)

    def test_pictures_of_an_older_run_are_not_kept(self):
        """A fresh run of another scene ends early; what it had not reached is drawn again, not taken from before."""
        words = ("--time-step", "1", "-o", "f%d.png")
        self.capture(*SIZE, "--frames", "0:12", *words)
        old = {p.name: p.read_bytes() for p in self.pictures()}
        self.write("scene.toml", SCENE.replace("grid", "checker"))
        self.capture(*SIZE, "--frames", "0:4", *words)
        drawn = self.capture(*SIZE, "--frames", "0:12", *words, "--resume").out.count("\n")
        self.assertEqual(drawn, 8)
        for picture in self.pictures():
            self.assertNotEqual(picture.read_bytes(), old[picture.name], picture.name)

    def test_a_run_that_draws_nothing_leaves_nothing(self):
        self.refused("capture", "scene.toml", *SIZE, "--frames", "0:2", "-o", "nowhere/f%d.png", status=1, says=["nowhere"])
        self.refused("capture", "flat", "--size", "32768x32768", "--raydata", "--frames", "0:2", "-o", "f%d.exr", says=["32768x32768"])


if __name__ == "__main__":
    support.main()
