"""What the tests of the page share: how they are called, when they run, and the engine without the page's controls.

Usage: test_X.py PAGE PROGRAMS       PAGE: the page's folder (scripts/web.sh), PROGRAMS: that of nullscope and native_answers

They run at depth all (tests/support/depth.h), for which scripts/test.sh installs a browser and builds the page; else they are skipped.
"""
import base64
import json
import pathlib
import subprocess
import sys
import unittest
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = sorted(file.stem for file in (ROOT / "assets/scenes").glob("*.toml"))
SKIPPED = 77
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "tests/viewer")]

import depth  # noqa: E402
from x_screen import read_png  # noqa: E402

BEGIN = """
(async () => {
  document.body.replaceChildren(document.createElement("canvas"));
  const { Engine } = await import("./engine.js");
  window.events = [];
  window.engine = new Engine((event, values) => events.push([event, values, performance.now()]));
  const base64 = (bytes) => {
    let text = "";
    for (let at = 0; at < bytes.length; at += 32768) text += String.fromCharCode(...bytes.subarray(at, at + 32768));
    return btoa(text);
  };
  const failed = () => new Promise((_, fail) => {
    const looks = setInterval(() => {
      const found = events.find(([event]) => event === "failed");
      if (found) clearInterval(looks), fail(new Error(found[1].message));
    }, 20);
  });
  window.picture = async () => {
    const { width, height, pixels } = await Promise.race([engine.picture(), failed()]);
    return [width, height, base64(pixels)];
  };
  window.rays = async (...how) => {
    const { line, pixels } = await engine.rays(...how);
    return [line, base64(pixels)];
  };
  window.began = performance.now();
  const info = await engine.start(document.querySelector("canvas"), new URL("./", location.href), WIDTH, HEIGHT);
  engine.fix(true);
  return info;
})()
"""


def open_folder(browser, url):
    """A page of the folder's that runs nothing: one of its files."""
    browser.open(url + "engine.js")
    browser.wait(f"location.href.startsWith({json.dumps(url)}) && document.readyState === 'complete'")


class Engine:
    """The page's engine, begun anew: nothing is left of what was drawn before."""

    def __init__(self, browser, url, width, height):
        self.browser = browser
        open_folder(browser, url)
        self.info = browser.run(BEGIN.replace("WIDTH", str(width)).replace("HEIGHT", str(height)))

    def open(self, what):
        self.browser.run(f"engine.open({json.dumps(what)})")

    def picture(self, timeout_s=120):
        """Width, height and RGBA, top row first."""
        width, height, data = self.browser.run("picture()", timeout_s)
        return width, height, base64.b64decode(data)

    def rays(self, width, height, row_step, timeout_s=120):
        """The scene's line, and RayPixel of every row_step-th row as bytes."""
        line, data = self.browser.run(f"rays({width}, {height}, {row_step})", timeout_s)
        return line, base64.b64decode(data)

    def as_a_visitor(self):
        """Edges get their rays in the second picture, not in the first."""
        self.browser.run("engine.fix(false)")

    def first_drawn(self):
        """Of the first picture since the events were cleared: ms after `began`, width."""
        self.browser.wait("events.some(([event]) => event === 'drawn')")
        return self.browser.run("""(([, { width }, at]) => [at - began, width])(events.find(([event]) => event === "drawn"))""")

    def line(self):
        return self.browser.run("engine.sceneLine()")


def native(programs, scene, size, folder):
    """The picture that `nullscope capture` gives."""
    file = f"{folder}/{scene}.png"
    subprocess.run([programs / "nullscope", "capture", scene, "--plain", "--size", "%dx%d" % size, "-o", file], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return read_png(file)


def differences(picture, wanted):
    """Of a picture of an Engine from a native one: a number a pixel, the largest of its three colours', of 255."""
    width, height, pixels = picture
    assert (width, height) == (wanted.width, wanted.height)
    return [max(abs(pixels[4 * i + c] - wanted.data[3 * i + c]) for c in range(3)) for i in range(width * height)]


class Difference(NamedTuple):
    """Of a picture from a native one: a pixel's is the largest of its three colours', of 255."""
    mean: float
    p999: int     # 99.9 % of the pixels differ by no more
    largest: int

    @classmethod
    def of(cls, pixels):
        off = sorted(pixels)
        return cls(sum(off) / len(off), off[len(off) - 1 - len(off) // 1000], off[-1])


def difference_in(browser, url, scene, wanted):
    """Of the scene's picture in a browser from a native one, which has its size; PageError where it draws none."""
    engine = Engine(browser, url, wanted.width, wanted.height)
    engine.open(scene)
    return Difference.of(differences(engine.picture(), wanted))


class WebTest(unittest.TestCase):
    page = programs = None   # paths

    @classmethod
    def native(cls, scene, size, folder):
        return native(cls.programs, scene, size, folder)

    def differences(self, picture, wanted):
        return differences(picture, wanted)


def begin():
    """The page's and the programs' folders; ends where the tests are not asked for."""
    if not depth.deep():
        print("skipped: the page is built and tested by scripts/test.sh --all")
        sys.exit(SKIPPED)
    return [pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2)]


def main():
    WebTest.page, WebTest.programs = begin()
    unittest.main()
