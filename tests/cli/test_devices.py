#!/usr/bin/env python3
"""OpenGL devices: what is listed, which one draws, and that a driver which dies takes nothing with it and is named."""
import json
import shutil
import signal
import subprocess
import unittest
from pathlib import Path

import support
from test_failures import NO_EGL, OLD_OPENGL, SANITIZED

SMALL = ("--size", "48x27")
# Stands for a driver that dies: OSMesa's functions, one of which ends the process.
DYING = """#include <stdlib.h>
void* OSMesaCreateContextAttribs(const int* attributes, void* shared) { abort(); }
void OSMesaDestroyContext(void* context) {}
unsigned char OSMesaMakeCurrent(void* context, void* buffer, unsigned type, int width, int height) { return 0; }
void* OSMesaGetProcAddress(const char* name) { return 0; }
"""


class Devices(support.CliTest):
    def devices(self, *options, environment=None, status=0):
        return json.loads(self.run_nullscope("devices", *options, "--json", environment=environment, status=status).out)

    def test_the_list_says_what_draws(self):
        listed = self.devices()
        self.assertEqual([device["number"] for device in listed], list(range(len(listed))))
        working = [device for device in listed if "failure" not in device]
        self.assertEqual([device["taken"] for device in working], [True] + [False] * (len(working) - 1))
        text = self.run_nullscope("devices").out
        for device in working:
            self.assertIn(device["renderer"], text)
            self.assertGreaterEqual(device["largest_texture"], 1024)
            self.assertTrue(device["float_targets"])
            if "llvmpipe (" in device["renderer"]:
                self.assertTrue(device["software"])
                self.assertIn(f"{device['vector_bits']} bits", device["renderer"])
            said = self.run_nullscope("capture", "flat", *SMALL, "--device", device["number"], "-o", "a.png").out
            self.assertIn(f"{device['kind']}, {device['renderer']}", said)
        self.assertFalse(any(device["compute"] for device in
                             self.devices(environment={"MESA_GL_VERSION_OVERRIDE": "3.3"}) if device.get("software")))

    def test_a_number_that_no_device_has(self):
        count = len(self.devices())
        said = self.refused("capture", "flat", *SMALL, "--device", count, "-o", "a.png",
                            says=[f"--device {count}", "nullscope devices", f"{count - 1} ("])
        self.assertNotIn(f"{count} (", said)
        self.refused("devices", "--device", count, says=[f"--device {count}", f"0 to {count - 1}"])
        self.refused("capture", "flat", *SMALL, "--device", "0", "--context", "egl", "-o", "a.png", says=["--device 0", "without --context"])
        self.refused("capture", "flat", *SMALL, "--device", "0", "--renderer", "reference", "-o", "a.png", says=["--device", "--renderer gl"])
        self.refused("lightcurve", "hot-spot", "--device", "0", "--renderer", "reference", says=["--device", "--renderer gl"])
        self.refused("plan", "flat", "--device", "0", says=["--device", "--measure"])
        self.refused("devices", "--pictures", self.folder, says=["--pictures", "--measure"])

    def test_nothing_here(self):
        listed = self.devices(environment={**NO_EGL, **OLD_OPENGL}, status=1)
        self.assertTrue(listed)
        self.assertTrue(all("failure" in device for device in listed), listed)

    @support.costly
    def test_measured_against_the_reference(self):
        first = next(device["number"] for device in self.devices() if device.get("taken"))
        (measured,) = self.devices("--measure", "first-light", "zoom", *SMALL, "--device", first, "--pictures", self.folder)
        for row, bound in zip(measured["scenes"], (0.01, 1.0)):   # zoom: pixels are narrower than floats can say
            self.assertEqual(row["wrong_fates"], 0)
            self.assertGreater(row["position_px"], 0.0)
            self.assertLess(row["position_px"], bound, row)
            self.assertGreater(row["first_ms"], row["frame_ms"])
            self.assertTrue((self.folder / f"{row['scene']}-{first}.png").exists())
        # What is compared as files says the same.
        for renderer in ("gl", "reference"):
            self.run_nullscope("capture", "zoom", *SMALL, "--raydata", "--renderer", renderer, "-o", f"{renderer}.exr")
        said = self.run_nullscope("compare", "gl.exr", "reference.exr", "--scene", "zoom").out
        self.assertIn("narrower than 1.2e-07 rad", said)
        self.assertLess(float(said.split("screen error")[1].split()[1]), 1.0, said)

    @unittest.skipIf(SANITIZED, "deaths have words of the sanitizer's own")
    def test_a_driver_that_dies(self):
        if shutil.which("cc") is None:
            self.skipTest("no cc to make a driver with")
        source = Path(self.write("dying.c", DYING))
        subprocess.run(["cc", "-shared", "-fPIC", "-w", "-o", self.folder / "libOSMesa.so.8", source], check=True)
        dying = {"LD_LIBRARY_PATH": str(self.folder), **NO_EGL}
        listed = self.devices(environment=dying, status=1)
        self.assertEqual(listed[-1], {"number": len(listed) - 1, "kind": "osmesa", "place": "", "file": "",
                                      "failure": "the driver ended its process: Aborted"})
        beside = self.devices(environment={"LD_LIBRARY_PATH": str(self.folder)})
        self.assertTrue(any(device.get("taken") for device in beside), beside)

    @unittest.skipIf(shutil.which("parallel") is None, "GNU parallel is not installed")
    def test_a_line_of_a_farm_for_each_device(self):
        self.write("lines.txt", "sleep 0.5; echo 'one two' drawn\nsleep 0.5; echo 'three' drawn\n")
        script = Path(__file__).resolve().parents[2] / "scripts/farm/parallel.sh"
        done = subprocess.run([script, "--devices", "2", "-f", "lines.txt"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        words = [line.split(" drawn --device ") for line in sorted(done.stdout.splitlines())]
        self.assertEqual([word[0] for word in words], ["one two", "three"])
        self.assertEqual(sorted(word[1] for word in words), ["0", "1"])

    @unittest.skipIf(SANITIZED, "deaths have words of the sanitizer's own")
    def test_a_death_names_the_driver(self):
        process = self.started("capture", "flat", *SMALL, "--frames", "0:100000", "-o", "f%05d.png", stderr=subprocess.PIPE)
        self.wait("the first picture", lambda: (self.folder / "f00000.png").exists(), process)
        process.send_signal(signal.SIGSEGV)
        said = process.communicate(timeout=support.LONGEST_S)[1].decode()
        self.assertEqual(process.returncode, -signal.SIGSEGV)
        (line,) = [line for line in said.splitlines() if line.startswith("nullscope: ended by a segmentation fault")]
        renderer = next(device["renderer"] for device in self.devices() if device.get("taken"))
        self.assertIn(f"OpenGL driver was in use: {renderer}, OpenGL ", line)


if __name__ == "__main__":
    support.main()
