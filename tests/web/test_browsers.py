#!/usr/bin/env python3
"""Every scene that ships has its picture in Firefox and in WebKitGTK, Safari's engine: near `nullscope capture`'s, with any driver's arithmetic."""
import tempfile

from browser import PageError, Server
from other_browsers import Firefox, WebKit
from support import SCENES, Difference, WebTest, difference_in, main

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
        worst = (Difference(0.0, 0, 0), "")
        with browser:
            for scene in SCENES:
                with self.subTest(scene):
                    try:
                        found = difference_in(browser, self.server.url, scene, self.wanted[scene])
                    except PageError as error:
                        self.fail(str(error))
                    worst = max(worst, (found, scene), key=lambda one: (one[0].p999, one[0].mean))
                    self.assertLessEqual(found.mean, MEAN)
                    self.assertLessEqual(found.p999, P999)
        print(f"{browser.NAME}: {len(SCENES)} scenes; 99.9 % of the pixels within {worst[0].p999}/255, mean {worst[0].mean:.3f} ({worst[1]})")

    def test_firefox(self):
        self.every_scene(Firefox())

    def test_webkit(self):
        self.every_scene(WebKit())


if __name__ == "__main__":
    main()
