#!/usr/bin/env python3
"""Rays that SwiftShader traced for the page, against the reference: of a 1920x1080 picture of every scene that ships, some of its rows."""
import json
import os
import subprocess
import tempfile

from browser import Browser, PageError, Server
from support import ROOT, SCENES, Engine, WebTest, main

EVERYTHING = "NULLSCOPE_EVERYTHING" in os.environ
SIZE, ROW_STEP = (1920, 1080), 270 if EVERYTHING else 540
BOUND_PX = 0.05
FLOAT_RAD = 2.0 ** -22   # half a digit of a swept angle of 4 to 8: more than a pixel's twentieth where the lens is long (photon-ring)
# Rays that pass a corner of a surface which is thinner than a march step may miss it (docs/scenes.md, surface.steps), on every driver.
THIN = {"saturn": 8, "wormhole-saturn": 8}
REFUSED = {"zoom": "zoom.depth"}   # deeper than the reference traces (tests/proof judges such views)
SLOW = ["swarm", "wormhole-saturn"]  # 64 bodies, and a surface through a wormhole, take the reference minutes


class Rays(WebTest):
    def judged(self, line, pixels, folder):
        for name, content in (("line", line.replace("/assets/", f"{ROOT}/assets/").encode()), ("pixels", pixels)):
            with open(f"{folder}/{name}", "wb") as file:
                file.write(content)
        done = subprocess.run([self.programs / "native_answers", "rays", f"{folder}/line", f"{folder}/pixels", *map(str, SIZE), str(ROW_STEP)],
                              capture_output=True, text=True)
        return json.loads(done.stdout) if done.returncode == 0 else done.stderr

    def test_every_scene(self):
        server = Server(self.page)
        worst = (0.0, "")
        with Browser("swiftshader") as browser, tempfile.TemporaryDirectory() as folder:
            for scene in SCENES:
                with self.subTest(scene):
                    if scene in SLOW and not EVERYTHING:
                        print(f"{scene}: only with NULLSCOPE_EVERYTHING")
                        continue
                    engine = Engine(browser, server.url, 64, 36)
                    self.assertIn("SwiftShader", engine.info["device"])
                    browser.run("engine.turning = true")   # no picture is drawn meanwhile
                    engine.open(scene)
                    try:
                        line, pixels = engine.rays(*SIZE, ROW_STEP)
                    except PageError as error:
                        self.assertIn("ray data are of one spacetime", str(error))
                        self.assertIn("[split", (ROOT / f"assets/scenes/{scene}.toml").read_text())
                        continue
                    errors = self.judged(line, pixels, folder)
                    if isinstance(errors, str):
                        self.assertIn(REFUSED.get(scene, "what a reference of every other scene says"), errors)
                        continue
                    px = max(errors["sky_px"], errors["place_px"])
                    print(f"{scene}: {px:.4f} px, {errors['fate_errors']} wrong fates, {errors['forgiven']} next to an edge", flush=True)
                    worst = max(worst, (px, scene))
                    self.assertLessEqual(px, max(BOUND_PX, FLOAT_RAD / errors["pixel_rad"]))
                    self.assertLessEqual(errors["fate_errors"], THIN.get(scene, 0))
                    self.assertEqual(errors["not_finite"], 0)
        server.close()
        print(f"the largest error is {worst[0]:.4f} px of 1080p ({worst[1]})")


if __name__ == "__main__":
    main()
