#!/usr/bin/env python3
"""Every scene that ships has the picture in a browser that `nullscope capture` gives, both drawn by Mesa's llvmpipe."""
import tempfile

from browser import Browser, PageError, Server
from support import SCENES, Engine, WebTest, main

SIZE = (192, 108)
CODES, SHARE = 2, 0.001   # of 255: what a colour may differ by, at all pixels but this share of them


class Pictures(WebTest):
    def test_every_scene(self):
        server = Server(self.page)
        worst = (0.0, "")
        with Browser("llvmpipe", *SIZE) as browser, tempfile.TemporaryDirectory() as folder:
            for scene in SCENES:
                with self.subTest(scene):
                    wanted = self.native(scene, SIZE, folder)
                    engine = Engine(browser, server.url, *SIZE)
                    self.assertIn("llvmpipe", engine.info["device"])
                    engine.open(scene)
                    try:
                        off = self.differences(engine.picture(), wanted)
                    except PageError as error:
                        self.fail(str(error))
                    share = sum(x > CODES for x in off) / len(off)
                    worst = max(worst, (share, scene))
                    self.assertLessEqual(share, SHARE, f"{100 * share:.3f} % of the pixels differ by more than {CODES}/255, at most {max(off)}")
        server.close()
        print(f"{len(SCENES)} scenes; at most {100 * worst[0]:.3f} % of the pixels differ by more than {CODES}/255 ({worst[1]})")


if __name__ == "__main__":
    main()
