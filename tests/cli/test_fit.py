#!/usr/bin/env python3
"""Fits find the scene that drew data, say how sure they are, and say where no scene of theirs did."""
import json
import math
import random
import re
import resource

import fit_data
import support

FREE = "spin=0:0.99,camera.theta=10:80"
SIGNAL_TO_NOISE = 30
SPOT = """[camera]
r = 200
theta = 65
fov = 4
size = [32, 32]
[sky]
kind = "black"
[disc]
emission = "thermal"
inner = 3
outer = 8
opacity = 0
[spot]
r = 4.5
size = 0.6
phase = 30
[light]
band = "bolometric"
"""
STAR = """[camera]
r = 200
theta = 70
fov = 1.6
size = [32, 32]
[sky]
kind = "black"
[object]
mass_suns = 1.4
distance_pc = 1000
[sphere]
radius = 2.5
spin_rate = 0.03
temperature = 6000
colour = [0, 0, 0]
[[cap]]
colatitude = 60
radius = 30
temperature = 6000
[light]
band = "bolometric"
"""


def spent():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Fits(support.CliTest):
    def drawn(self, side, samples):
        """A picture of the scene by the reference, whose rays lie elsewhere than the shader's. The file of the scene has other numbers."""
        self.write("true.toml", fit_data.SCENE % (side, side))
        self.write("scene.toml", (fit_data.SCENE % (side, side)).replace("0.7", "0.2").replace("theta = 50", "theta = 20"))
        self.run_nullscope("capture", "true.toml", "--renderer", "reference", "--samples", samples, "-o", "true.fits")
        return fit_data.rows_of((self.folder / "true.fits").read_bytes())

    def noisy(self, rows, seed=1):
        self.sigma = fit_data.brightest(rows) / SIGNAL_TO_NOISE
        self.write("data.fits", fit_data.fits(fit_data.noisy(rows, self.sigma, seed)))

    def fitted(self, *more, free=FREE, data="data.fits"):
        return json.loads(self.run_nullscope("fit", data, "scene.toml", "--free", free, "--sigma", "%.17g" % self.sigma, "--json", *more).out)

    def holds(self, found, sigmas=4):
        for one in found["parameters"]:
            if one["key"] in fit_data.TRUE:
                self.assertLess(abs(one["best"] - fit_data.TRUE[one["key"]]), sigmas * one["sigma"], one)

    @support.costly
    def test_a_picture_is_fitted_from_any_start(self):
        self.noisy(self.drawn(32, 6))
        found = self.fitted("-o", "best.toml")
        self.assertEqual([one["key"] for one in found["parameters"]], list(fit_data.TRUE))
        self.holds(found)
        self.assertTrue(found["describes_the_data"])
        self.assertEqual(found["degrees_of_freedom"], 32 * 32 - 2)
        self.assertLess(abs(found["chi2"] - 1022), 4 * math.sqrt(2 * 1022))
        (answer,) = found["answers"]
        self.assertEqual(answer["starts"], 4)
        # What is written is the scene of these numbers, in the data's light.
        text = (self.folder / "best.toml").read_text()
        self.assertAlmostEqual(float(re.search(r"spin = (\S+)", text)[1]), found["parameters"][0]["best"], delta=1e-5)
        table = self.run_nullscope("fit", "data.fits", "scene.toml", "--free", FREE, "--sigma", "%.17g" % self.sigma, "--starts", "1").out
        self.assertRegex(table, r"1024 pixels of data.fits, 2 parameters")
        self.assertRegex(table, r"spacetime\.spin +0\.\d+ +0\.\d+ to 0\.\d+ \(\+- [\d.e-]+\)")
        self.assertRegex(table, r"1022 degrees of freedom")

    @support.costly
    def test_noise_moves_the_answer_as_the_interval_says(self):
        rows = self.drawn(32, 6)
        trials = 12
        off = []
        for seed in range(1, trials + 1):
            self.noisy(rows, seed)
            off += [(one["best"] - fit_data.TRUE[one["key"]]) / one["sigma"] for one in self.fitted("--starts", "1")["parameters"]]
        # The sum of squares of 2 x 12 normal numbers: 24 +- 6.9.
        self.assertGreater(sum(x * x for x in off), 24 - 2.5 * 6.9, off)
        self.assertLess(sum(x * x for x in off), 24 + 3.5 * 6.9, off)

    @support.costly
    def test_pictures_that_cannot_be(self):
        side = 24
        blob = [[math.exp(-((x - 11.5) ** 2 + (y - 11.5) ** 2) / 20) for x in range(side)] for y in range(side)]
        self.drawn(side, 1)
        self.noisy(blob)
        ran = self.run_nullscope("fit", "data.fits", "scene.toml", "--free", FREE, "--sigma", "%.17g" % self.sigma, "--nuisance", "flux", "--starts", "1", status=1)
        self.assertIn("this scene does not describe the data: chi^2/dof ", ran.err)
        self.assertNotIn("+-", ran.out)

    @support.costly
    def test_a_mask_leaves_out_and_nuisances_are_found(self):
        rows = self.drawn(32, 4)
        self.noisy(rows)
        data = fit_data.rows_of((self.folder / "data.fits").read_bytes())
        spoiled = [[1e3 if 4 <= x < 8 and y < 8 else 2.5 * value for x, value in enumerate(row)] for y, row in enumerate(data)]
        self.write("spoiled.fits", fit_data.fits(spoiled))
        self.write("mask.fits", fit_data.fits([[0.0 if 4 <= x < 8 and y < 8 else 1.0 for x in range(32)] for y in range(32)]))
        self.sigma *= 2.5
        found = self.fitted("--mask", "mask.fits", "--nuisance", "flux", "--starts", "1", data="spoiled.fits")
        self.assertEqual(found["degrees_of_freedom"], 32 * 32 - 32 - 3)
        self.holds(found)
        self.assertAlmostEqual(found["flux"], 2.5, delta=0.3)

    def with_noise(self, name, columns, share):
        """The table with noise on these columns, a share of the largest number in them, and a column that says so."""
        lines = [line for line in (self.folder / name).read_text().splitlines() if not line.startswith("#")]
        header = lines[0].split(",")
        rows = [line.split(",") for line in lines[1:]]
        at = [header.index(column) for column in columns]
        sigma = share * max(abs(float(row[i])) for row in rows for i in at)
        dice = random.Random(1)
        for row in rows:
            for i in at:
                row[i] = "%.12g" % (float(row[i]) + dice.gauss(0, sigma))
        self.write(name, "".join(",".join([*row, more]) + "\n" for row, more in zip([header, *rows], ["noise"] + ["%.12g" % sigma] * len(rows))))

    @support.costly
    def test_visibilities(self):
        """Of an opaque disc derivatives are differences of pictures, of a transparent one they are exact, and take no predictions."""
        predictions = []
        for opacity in ("", "opacity = 0.005"):
            self.write("true.toml", (fit_data.SCENE % (48, 48)).replace("outer = 10.0", f"outer = 10.0\n{opacity}") + '[object]\nname = "m87"\n')
            self.run_nullscope("visibility", "true.toml", "--size", "96x96", "--renderer", "reference", "--samples", "3", "--radial", "30", "8", "--points", "24", "-o", "seen")
            self.with_noise("seen.csv", ["real", "imaginary"], 0.01)
            found = json.loads(self.run_nullscope("fit", "seen.csv", "true.toml", "--free", FREE, "--starts", "1", "--json").out)
            self.holds(found)
            self.assertEqual(found["degrees_of_freedom"], 2 * 24 - 2)
            self.assertTrue(found["describes_the_data"], found)
            self.assertEqual([one["derivative"] for one in found["parameters"]], 2 * ["exact" if opacity else "differences"])
            self.assertEqual((found["why_differences"] or "").partition(":")[0], "" if opacity else "disc.opacity")
            predictions.append(found["predictions"])
        self.assertLess(predictions[1], predictions[0])

    @support.costly
    def test_grain_is_no_signal(self):
        """Baselines from north to south do not see where a source is from east to west, but a picture's grain changes with it."""
        self.write("true.toml", (fit_data.SCENE % (48, 48)) + '[object]\nname = "m87"\n')
        self.run_nullscope("visibility", "true.toml", "--radial", "0", "8", "--points", "40", "-o", "seen")
        found = json.loads(self.run_nullscope("fit", "seen.csv", "true.toml", "--free", "camera.shift_x=-0.05:0.05,camera.theta=40:60", "--sigma", "0.003", "--starts", "1", "--json").out)
        shift, theta = found["parameters"]
        self.assertIsNone(shift["sigma"], found)
        self.assertLess(abs(theta["best"] - 50), 4 * theta["sigma"])

    @support.costly
    def test_lines(self):
        self.write("true.toml", fit_data.SCENE % (8, 8))
        self.run_nullscope("spectrum", "true.toml", "--bins", "40", "-o", "line")
        self.with_noise("line.csv", ["photons"], 0.01)
        found = json.loads(self.run_nullscope("fit", "line.csv", "true.toml", "--free", "camera.theta=30:70,disc.outer=6:15", "--starts", "1", "--json").out)
        theta, outer = found["parameters"]
        self.assertLess(abs(theta["best"] - 50), 4 * theta["sigma"])
        self.assertLess(abs(outer["best"] - 10), 4 * outer["sigma"])
        self.assertTrue(found["describes_the_data"], found)

    @support.costly
    def test_a_light_curve_of_a_spot(self):
        self.write("true.toml", SPOT)
        self.run_nullscope("lightcurve", "true.toml", "--renderer", "reference", "--samples", "3", "--steps", "25", "-o", "seen")
        self.with_noise("seen.csv", ["flux"], 0.01)
        found = json.loads(self.run_nullscope("fit", "seen.csv", "true.toml", "--free", "spot.r=3.2:6,camera.theta=20:85", "--starts", "2", "--json").out)
        radius, theta = found["parameters"]
        self.assertLess(abs(radius["best"] - 4.5), 4 * radius["sigma"])
        self.assertLess(abs(theta["best"] - 65), 4 * theta["sigma"])
        print("curve of a spot: " + ", ".join("%(key)s %(best).5f +- %(sigma).2g" % one for one in found["parameters"]))
        self.assertLess(radius["sigma"], 0.05)   # the period alone says as much
        self.assertEqual(found["degrees_of_freedom"], 25 - 2)
        self.assertTrue(found["describes_the_data"], found)

    @support.costly
    def test_a_pulse_in_seconds_weighs_the_star(self):
        self.write("true.toml", STAR)
        self.run_nullscope("lightcurve", "true.toml", "--renderer", "reference", "--samples", "3", "--steps", "24", "-o", "seen")
        lines = [line.split(",") for line in (self.folder / "seen.csv").read_text().splitlines() if not line.startswith("#")]
        second = 1.4 * 2 * 1.3271244e20 / 299792458.0 ** 3   # of r_s/c
        rows = ["%.17g,%s" % (float(row[0]) * second, row[1]) for row in lines[1:]]
        self.write("seen.csv", "time_s,flux\n" + "\n".join(rows) + "\n")
        self.with_noise("seen.csv", ["flux"], 0.01)
        found = json.loads(self.run_nullscope("fit", "seen.csv", "true.toml", "--free", "object.mass_suns=1.2:1.6,camera.theta=30:85", "--starts", "2", "--json").out)
        mass, theta = found["parameters"]
        print("pulse in seconds: " + ", ".join("%(key)s %(best).5f +- %(sigma).2g" % one for one in found["parameters"]))
        self.assertLess(abs(mass["best"] - 1.4), 4 * mass["sigma"])
        self.assertLess(mass["sigma"], 0.01)
        self.assertLess(abs(theta["best"] - 70), 4 * theta["sigma"])
        self.assertTrue(found["describes_the_data"], found)

    @support.costly
    def test_another_metric_is_refused(self):
        """A Reissner-Nordstroem hole of charge 0.9 is no Kerr hole, whatever its spin, distance, disc and place in the picture."""
        charged = (fit_data.SCENE % (32, 32)).replace('"kerr"', '"reissner-nordstrom"').replace("spin = 0.7", "charge = 0.9")
        self.write("true.toml", charged)
        self.write("scene.toml", fit_data.SCENE % (32, 32))
        self.run_nullscope("capture", "true.toml", "--renderer", "reference", "--samples", "6", "-o", "true.fits")
        rows = fit_data.rows_of((self.folder / "true.fits").read_bytes())
        self.sigma = fit_data.brightest(rows) / 100
        self.write("data.fits", fit_data.fits(fit_data.noisy(rows, self.sigma, 1)))
        usual = "--sigma", "%.17g" % self.sigma, "--nuisance", "flux"
        ran = self.run_nullscope("fit", "data.fits", "scene.toml", "--free", "spin=-0.99:0.99,camera.theta=10:80,disc.outer=8:12", *usual, status=1)
        self.assertRegex(ran.err, r"this scene does not describe the data: chi\^2/dof \d")
        self.assertNotIn("+-", ran.out)
        # Its own metric does.
        own = self.run_nullscope("fit", "data.fits", "true.toml", "--free", "charge=0:0.99,camera.theta=10:80", *usual)
        self.assertIn("+-", own.out)

    def test_errors_of_light_curves(self):
        self.write("still.toml", fit_data.SCENE % (8, 8))
        self.write("spot.toml", SPOT)

        def refused(table, says, *more, scene="spot.toml", free="spot.r=3.2:6"):
            self.write("data.csv", table)
            self.refused("fit", "data.csv", scene, "--free", free, "-o", "best.toml", *more, says=says)

        curve = "time,flux,noise\n0,0.5,0.1\n"
        refused(curve, ["nothing in the scene changes with time"], scene="still.toml", free=FREE)
        refused(curve.replace("0.5", "inf"), ["data.csv:2: flux"])
        refused(curve.replace("0.1", "0"), ["data.csv:2: noise"])
        refused(curve.replace("flux", "red"), ["no flux that the scene has"])
        refused(curve.replace("flux", "jansky"), ["data.csv:1: jansky", "--nuisance flux"])
        refused(curve.replace("time", "time_s"), ["data.csv:1: time_s", "mass"])
        refused(curve.replace("flux", "flux,time_s").replace("0.5", "0.5,1"), ["data.csv:1: time_s", "one of them"])
        refused(curve.replace("flux", "magnitude"), ["data.csv:1: header", "magnitude"])
        refused("time,flux\n0,0.5\n", ["noise", "--sigma NUMBER"])

    def test_errors_of_tables(self):
        self.write("scene.toml", (fit_data.SCENE % (8, 8)) + '[object]\nname = "m87"\n')

        def refused(table, says, *more):
            self.write("data.csv", table)
            self.refused("fit", "data.csv", "scene.toml", "--free", FREE, "-o", "best.toml", *more, says=says)

        visible, line = "u,v,amplitude,noise\n1e9,0,0.5,0.1\n", "g_from,g_to,photons,noise\n0.5,0.6,0.1,0.1\n"
        refused(visible.replace("0.5", "nan"), ["data.csv:2: amplitude"])
        refused(visible.replace("amplitude", "phase_deg"), ["no visibilities"])
        refused(visible, ["noise", "and --sigma"], "--sigma", "1")
        refused(visible.replace("amplitude,noise", "amplitude_jy,noise_jy"), ["Jy", "--nuisance flux"])
        refused(line + "0.7,0.8,0.1,0.1\n", ["data.csv:3: g_from", "none left out"])
        refused(line.replace("0.1\n", "-1\n"), ["data.csv:2: noise"])
        refused(line, ["--mask"], "--mask", "mask.png")

    def test_what_the_report_says(self):
        """Of data that the scene does not describe: at the range's end, one of each, and why derivatives are differences."""
        self.write("data.csv", "u,v,amplitude,noise\n1e9,0,0.9,1e-3\n2e9,1e9,0.1,1e-3\n")
        self.write("scene.toml", (fit_data.SCENE % (16, 16)) + '[object]\nname = "m87"\n')
        asked = ("fit", "data.csv", "scene.toml", "--free", "camera.theta=78:80", "--starts", "1", "--seed", "1", "--samples", "1")
        ran = self.run_nullscope(*asked, status=1)
        self.assertIn("does not describe the data", ran.err)
        self.assertRegex(ran.out, r"2 visibilities of data.csv, 1 parameter, \d+ predictions")
        self.assertRegex(ran.out, r"camera.theta +(78|80); at the end of its range, 78:80\n")
        self.assertRegex(ran.out, r" of 1 degree of freedom, ")
        self.assertRegex(ran.out, r"\n1 start\n")
        self.assertRegex(ran.out, r"\nderivatives by each parameter: differences \(disc.opacity: .*\)\n")

    def test_errors(self):
        self.write("scene.toml", fit_data.SCENE % (8, 8))
        data = self.write("data.fits", fit_data.fits([[1.0] * 8] * 8))
        usual = {"--free": FREE, "--sigma": "1"}

        def refused(says, picture=data, **changed):
            options = {**usual, **{"--" + name: value for name, value in changed.items()}}
            self.refused("fit", picture, "scene.toml", "-o", "best.toml", *(word for pair in options.items() if pair[1] for word in pair), says=says)

        refused(["--free camera.tehta=10:80: unknown key", "theta"], free="camera.tehta=10:80")
        refused(["--free spin=0:2: 2 is out of range", "[-1, 1]"], free="spin=0:2")
        refused(["--free spacetime.spin=0:2: 2 is out of range"], free="spacetime.spin=0:2")
        refused(["--free spn=0:1: no parameter of metric", "did you mean spin?"], free="spn=0:1")
        refused(["--free thta=0:1: ", "did you mean camera.theta?"], free="thta=0:1")
        refused(["--free disc.emission=0:1: must be a string"], free="disc.emission=0:1")
        refused(["range is empty"], free="spin=0.5:0.5")
        refused(["no range"], free="spin=0.5")
        refused(["spin is there twice"], free="spin=0:0.5,spacetime.spin=0:0.4")
        refused(["--sigma"], sigma="")
        refused(["--sigma -1", "above 0"], sigma="-1")
        refused(["--nuisance", "centre, roll, flux"], nuisance="tilt")
        refused(["4 x 8 pixels", "8 x 8"], sigma=self.write("narrow.fits", fit_data.fits([[1.0] * 4] * 8)))
        refused(["no pixel counts"], mask=self.write("black.fits", fit_data.fits([[0.0] * 8] * 8)))
        refused(["spoiled.fits", "finite"], picture=self.write("spoiled.fits", fit_data.fits([[math.nan] * 8] * 8)))
        refused(["none.fits"], picture="none.fits")

    @support.costly
    def test_large_pictures_as_promised(self):
        self.noisy(self.drawn(128, 7))
        before = spent()
        found = self.fitted()
        self.assertLess(spent() - before, 20 * 2)   # half of that on a machine that is not busy
        self.assertLess(abs(found["parameters"][0]["best"] - 0.7), 0.01)
        self.assertLess(abs(found["parameters"][1]["best"] - 50), 0.3)
        (answer,) = self.fitted("--starts", "20", "--seed", "1")["answers"]
        self.assertEqual(answer["starts"], 20)


if __name__ == "__main__":
    support.main()
