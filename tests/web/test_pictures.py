#!/usr/bin/env python3
"""Every scene that ships has the picture in a browser that `nullscope capture` gives, both drawn by Mesa's llvmpipe."""
import subprocess
import sys
import tempfile

from browser import Browser, PageError, Server
from support import ROOT, SCENES, Engine, WebTest, main

sys.path.insert(0, str(ROOT / "tests/viewer"))
from x_screen import read_png  # noqa: E402

SIZE = (192, 108)
CODES, SHARE = 2, 0.001   # of 255: what a colour may differ by, at all pixels but this share of them


class Pictures(WebTest):
    def native(self, scene, folder):
        file = f"{folder}/{scene}.png"
        subprocess.run([self.programs / "nullscope", "capture", scene, "--plain", "--size", "%dx%d" % SIZE, "-o", file], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return read_png(file)

    def test_every_scene(self):
        server = Server(self.page)
        worst = (0.0, "")
        with Browser("llvmpipe", *SIZE) as browser, tempfile.TemporaryDirectory() as folder:
            for scene in SCENES:
                with self.subTest(scene):
                    wanted = self.native(scene, folder)
                    engine = Engine(browser, server.url, *SIZE)
                    self.assertIn("llvmpipe", engine.info["device"])
                    engine.open(scene)
                    try:
                        width, height, pixels = engine.picture()
                    except PageError as error:
                        self.fail(str(error))
                    self.assertEqual((width, height), (wanted.width, wanted.height))
                    off = [max(abs(pixels[4 * i + c] - wanted.data[3 * i + c]) for c in range(3)) for i in range(width * height)]
                    share = sum(x > CODES for x in off) / len(off)
                    worst = max(worst, (share, scene))
                    self.assertLessEqual(share, SHARE, f"{100 * share:.3f} % of the pixels differ by more than {CODES}/255, at most {max(off)}")
        server.close()
        print(f"{len(SCENES)} scenes; at most {100 * worst[0]:.3f} % of the pixels differ by more than {CODES}/255 ({worst[1]})")


if __name__ == "__main__":
    main()
