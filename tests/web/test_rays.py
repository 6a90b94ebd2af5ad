#!/usr/bin/env python3
"""Rays that SwiftShader traced for the page, against the reference: of a 1920x1080 picture of every scene that ships, some of its rows."""
import json
import subprocess
import tempfile

from browser import Browser, PageError, Server
from support import ROOT, SCENES, Engine, WebTest, main

SIZE, ROW_STEP = (1920, 1080), 270
BOUND_PX = 0.05
# Scenes without ray data, and what the page says.
REFUSED = {"charged-hole": "one spacetime"}


class Rays(WebTest):
    def judged(self, line, pixels, folder):
        for name, content in (("line", line.replace("/assets/", f"{ROOT}/assets/").encode()), ("pixels", pixels)):
            with open(f"{folder}/{name}", "wb") as file:
                file.write(content)
        done = subprocess.run([self.programs / "native_answers", "rays", f"{folder}/line", f"{folder}/pixels", *map(str, SIZE), str(ROW_STEP)],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_every_scene(self):
        server = Server(self.page)
        worst = (0.0, "")
        with Browser("swiftshader") as browser, tempfile.TemporaryDirectory() as folder:
            for scene in SCENES:
                with self.subTest(scene):
                    engine = Engine(browser, server.url, 64, 36)
                    self.assertIn("SwiftShader", engine.info["device"])
                    browser.run("engine.turning = true")   # no picture is drawn meanwhile
                    engine.open(scene)
                    try:
                        line, pixels = engine.rays(*SIZE, ROW_STEP)
                    except PageError as error:
                        self.assertIn(REFUSED.get(scene, "ray data of every other scene"), str(error))
                        continue
                    self.assertNotIn(scene, REFUSED)
                    errors = self.judged(line, pixels, folder)
                    px = max(errors["sky_px"], errors["place_px"])
                    print(f"{scene}: {px:.4f} px, {errors['fate_errors']} wrong fates, {errors['forgiven']} next to an edge")
                    worst = max(worst, (px, scene))
                    self.assertLessEqual(px, BOUND_PX)
                    self.assertEqual((errors["fate_errors"], errors["not_finite"]), (0, 0))
        server.close()
        print(f"the largest error is {worst[0]:.4f} px of 1080p ({worst[1]})")


if __name__ == "__main__":
    main()
