#!/usr/bin/env python3
"""Matter that is seen at several frequencies: channels of an EXR, a FITS for each, columns of a light curve, what capture prints."""
import math
import re
from pathlib import Path

import support
from test_astronomy import read_parts

SCENES = Path(__file__).resolve().parents[2] / "assets/scenes"
SIZE = ("--size", "32x18")
BANDS = (86, 230, 345)
THICK = 1e-3   # of a flux, of which four digits are printed
SHARP = ("[picture]\n", '[picture]\nrefine = "off"\n')   # which pixels have more rays depends on the picture's colours


def total(rows):
    return sum(map(math.fsum, rows))


class Bands(support.CliTest):
    def scene(self, name, frequency, *changes):
        text = (SCENES / f"{name}.toml").read_text()
        text = re.sub(r"(?m)^frequency = .*\n", "", text).replace("[medium]\n", f"[medium]\nfrequency = {frequency}\n")
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        return self.write(f"{name}.toml", text)

    def exr(self, scene, *options):
        said = self.run_nullscope("capture", scene, *SIZE, *options, "-o", "a.exr").out
        return support.read_exr((self.folder / "a.exr").read_bytes()), said

    def test_what_is_of_one_frequency(self):
        scene = self.scene("m87-synchrotron", list(BANDS))
        for command in ("flux", "visibility"):
            self.refused(command, scene, *SIZE, *(("--radial", "0", "10") if command == "visibility" else ()), says=["medium.frequency", "shown_band"])
        shown = self.scene("m87-synchrotron", list(BANDS), ("[medium]\n", "[medium]\nshown_band = 2\n"))
        self.assertEqual(self.run_nullscope("flux", shown, *SIZE).out, self.run_nullscope("flux", "m87-synchrotron", *SIZE).out)

    def test_each_band_is_the_picture_at_its_frequency(self):
        channels, said = self.exr(self.scene("sgr-a-synchrotron", list(BANDS), SHARP))
        self.assertEqual([name for name in channels if name.startswith("band.")], sorted(f"band.{each}GHz.I" for each in BANDS))
        told = dict(re.findall(r"([\d.e-]+) Jy at (\d+) GHz", said))
        self.assertEqual(sorted(told.values()), sorted(map(str, BANDS)))
        told = {int(frequency): float(flux) for flux, frequency in told.items()}
        self.run_nullscope("capture", self.folder / "sgr-a-synchrotron.toml", *SIZE, "-o", "a.fits")
        self.assertFalse((self.folder / "a.fits").exists())
        for each in BANDS:
            cards, planes = read_parts((self.folder / f"a-{each}GHz.fits").read_bytes())[0]
            self.assertEqual((cards["FREQ"], cards["BUNIT"], len(planes)), (1e9 * each, "Jy/pixel", 1))
            flux = total(planes[0])
            self.assertAlmostEqual(flux, told[each], delta=1e-3 * flux)
            light = total(channels[f"band.{each}GHz.I"])
            self.assertTrue(all(abs(value / flux - i / light) < 1e-7 for rows in zip(planes[0], channels[f"band.{each}GHz.I"]) for value, i in zip(*rows)))
            _, alone = self.exr(self.scene("sgr-a-synchrotron", each, SHARP))
            self.assertAlmostEqual(told[each], float(re.search(r"([\d.]+) Jy at", alone)[1]), delta=THICK * told[each])

    def test_more_bands_than_colours_and_a_shown_one(self):
        several = [43, 86, 150, 230, 345]
        scene = self.scene("sgr-a-synchrotron", f"{several}\nshown_band = 4")
        channels, said = self.exr(scene)
        _, alone = self.exr(self.scene("sgr-a-synchrotron", 230))
        self.assertEqual(len([name for name in channels if name.startswith("band.")]), 5)
        self.assertIn(re.search(r"[\d.]+ Jy at 230 GHz", alone)[0][:4], said)
        self.assertEqual(said.count("Jy at"), 5)
        self.run_nullscope("capture", self.scene("sgr-a-synchrotron", "[86.25, 230]"), *SIZE, "-o", "b.exr")
        self.assertIn("band.86,25GHz.I", support.read_exr((self.folder / "b.exr").read_bytes()))

    def test_the_reference_has_the_same(self):
        scene = self.scene("sgr-a-synchrotron", list(BANDS))
        fluxes = [re.findall(r"([\d.]+) Jy at", self.exr(scene, *how)[1]) for how in ((), ("--renderer", "reference", "--samples", "1"))]
        for ours, exact in zip(*fluxes):
            self.assertAlmostEqual(float(ours), float(exact), delta=0.02 * float(exact))   # of 32x18 pixels, refined here alone

    def test_polarised_bands_and_the_rotation_measure(self):
        channels, said = self.exr(self.scene("m87-polarimetry", [228, 232]))
        self.assertTrue({f"band.{each}GHz.{c}" for each in (228, 232) for c in "IQUV"} | {"rm"} <= set(channels))
        net = [complex(total(channels[f"band.{each}GHz.Q"]), total(channels[f"band.{each}GHz.U"])) for each in (228, 232)]
        square = [(299792458 / (1e9 * each)) ** 2 for each in (228, 232)]
        turn = 0.5 * math.atan2((net[0] * net[1].conjugate()).imag, (net[0] * net[1].conjugate()).real)
        found = re.search(r"RM 228-232 GHz (\S+) rad/m\^2 \(\+ n (\S+)\)", said)
        self.assertAlmostEqual(float(found[1]), turn / (square[0] - square[1]), delta=2e-3 * abs(float(found[1])))
        self.assertAlmostEqual(float(found[2]), math.pi / (square[0] - square[1]), delta=2e-3 * float(found[2]))
        x, y = 14, 8
        pixel = [complex(channels[f"band.{each}GHz.Q"][y][x], channels[f"band.{each}GHz.U"][y][x]) for each in (228, 232)]
        product = pixel[0] * pixel[1].conjugate()
        slope = 0.5 * math.atan2(product.imag, product.real) / (square[0] - square[1])
        self.assertAlmostEqual(channels["rm"][y][x], slope, delta=1e-3 * abs(slope))
        self.run_nullscope("capture", self.folder / "m87-polarimetry.toml", *SIZE, "-o", "a.fits")
        for each in (228, 232):
            cards, planes = read_parts((self.folder / f"a-{each}GHz.fits").read_bytes())[0]
            self.assertEqual((cards["FREQ"], cards["CTYPE3"], len(planes)), (1e9 * each, "STOKES", 4))
            self.assertAlmostEqual(total(planes[1]) / total(planes[0]),
                                   -total(channels[f"band.{each}GHz.Q"]) / total(channels[f"band.{each}GHz.I"]), delta=1e-5)

    def test_a_light_curve_has_a_column_for_each(self):
        clump = "1e7 * exp(-((x - 4 * cos(0.25 * t))^2 + (y - 4 * sin(0.25 * t))^2 + z^2))"
        scene = self.scene("sgr-a-synchrotron", "[86, 230]", ('density = "', f'density = "{clump} + '))
        self.run_nullscope("lightcurve", scene, *SIZE, "--from", "1000", "--to", "1010", "--steps", "2", "-o", "curve")
        header, *rows = (self.folder / "curve.csv").read_text().split()
        self.assertEqual(header, "time,flux,red,green,blue,jansky_86GHz,jansky_230GHz")
        for row in rows:
            time, *_, low, high = map(float, row.split(","))
            fluxes = re.findall(r"([\d.]+) Jy at", self.run_nullscope("capture", scene, *SIZE, "--time", str(time), "-o", "a.exr").out)
            for ours, told in zip((low, high), map(float, fluxes)):
                self.assertAlmostEqual(ours, told, delta=0.02 * told)   # the curve's pictures are not refined

    def test_what_cannot_have_bands_says_so(self):
        scene = self.scene("sgr-a-synchrotron", "[86, 230]")
        said = self.run_nullscope("capture", scene, *SIZE, "--half", "-o", "a.exr").said()
        self.assertIn("with --half no frequency has a channel of its own", said)
        self.refused("capture", scene, *SIZE, "--frames", "0:2", "--resume", "-o", "a%02d.fits", says=["a FITS of several frequencies is a file for each"])
        said = self.run_nullscope("capture", scene, *SIZE, "--split", "sgr-a-synchrotron", "-o", "a.exr").said()
        self.assertIn("of two pictures side by side no band is written by itself", said)


if __name__ == "__main__":
    support.main()
