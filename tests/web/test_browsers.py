#!/usr/bin/env python3
"""Every scene that ships has its picture in Firefox and in WebKitGTK, Safari's engine: near `nullscope capture`'s, with any driver's arithmetic."""
import tempfile

from browser import PageError, Server
from other_browsers import Firefox, WebKit
from support import SCENES, Engine, WebTest, main

SIZE = (192, 108)
MEAN, P999 = 2.0, 24   # of 255: what the pixels may differ by on average, and 99.9 % of them


class Browsers(WebTest):
    @classmethod
    def setUpClass(cls):
        cls.server = Server(cls.page)
        cls.addClassCleanup(cls.server.close)
        with tempfile.TemporaryDirectory() as folder:
            cls.wanted = {scene: cls.native(scene, SIZE, folder) for scene in SCENES}

    def every_scene(self, browser):
        worst = (0, 0.0, "")
        with browser:
            for scene in SCENES:
                with self.subTest(scene):
                    try:
                        engine = Engine(browser, self.server.url, *SIZE)
                        engine.open(scene)
                        picture = engine.picture()
                    except PageError as error:
                        self.fail(str(error))
                    off = sorted(self.differences(picture, self.wanted[scene]))
                    mean, p999 = sum(off) / len(off), off[len(off) - 1 - len(off) // 1000]
                    worst = max(worst, (p999, mean, scene))
                    self.assertLessEqual(mean, MEAN)
                    self.assertLessEqual(p999, P999)
        print(f"{browser.NAME}: {len(SCENES)} scenes; 99.9 % of the pixels within {worst[0]}/255, mean {worst[1]:.3f} ({worst[2]})")

    def test_firefox(self):
        self.every_scene(Firefox())

    def test_webkit(self):
        self.every_scene(WebKit())


if __name__ == "__main__":
    main()
