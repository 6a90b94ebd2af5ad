#!/usr/bin/env python3
"""docs/gallery.md shows every scene that ships, as it is now; scripts/gallery.py makes it by one command."""
import html
import json
import re
import subprocess
import sys
from pathlib import Path

import support
from test_pictures import jpeg_frame

ROOT = Path(support.__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts/gallery.py"
MOST_BYTES = 2_000_000
AGAIN = "run scripts/gallery.py"


def faults(page, scenes, pictures):
    """What is wrong with a page. scenes: name -> sentence; pictures: the folder that it names."""
    found = []
    for name, sentence in scenes.items():
        card = re.search(rf'<img src="../assets/gallery/{re.escape(name)}\.jpg".*?</td>', page, re.S)
        if card is None:
            found.append(f"{name} is not on the page")
            continue
        for words, what in ((html.escape(sentence, quote=False), "sentence"), (f"nullscope capture {name} -o ", "command"),
                            (" core-s; ", "cost"), ("error ", "error")):
            if words not in card.group(0):
                found.append(f"{name}: its {what} is not that of the page")
        picture = pictures / f"{name}.jpg"
        if not picture.exists() or (jpeg_frame(picture.read_bytes(), kinds=(0xc0,)) or ())[:2] != (480, 270):
            found.append(f"{name}: no picture of 480x270")
    shown = set(re.findall(r'<img src="../assets/gallery/(.*?)\.jpg"', page))
    found += [f"{name} ships no more" for name in sorted(shown - set(scenes))]
    if sum(picture.stat().st_size for picture in pictures.glob("*.jpg")) > MOST_BYTES:
        found.append("the pictures take more than 2 MB")
    return found


class Gallery(support.CliTest):
    def scenes(self):
        return dict(line.split(None, 1) for line in self.run_nullscope("scenes").out.splitlines())

    def make(self, *arguments, status=0):
        done = subprocess.run([sys.executable, "-B", SCRIPT, "--into", self.folder, "--binary", support.BINARY, *arguments],
                              capture_output=True, text=True, timeout=support.LONGEST_S)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stderr

    def test_every_scene_is_on_the_page_and_has_its_picture(self):
        page = ROOT / "docs/gallery.md"
        self.assertTrue(page.exists(), f"docs/gallery.md is not there: {AGAIN}")
        found = faults(page.read_text(), self.scenes(), ROOT / "assets/gallery")
        self.assertFalse(found, f"{AGAIN}: " + "; ".join(found))

    @support.costly
    def test_the_script_makes_a_page_of_single_scenes(self):
        scenes = {name: sentence for name, sentence in self.scenes().items() if name in ("flat", "two-spacetimes")}
        self.make(*scenes)
        page = (self.folder / "docs/gallery.md").read_text()
        self.assertEqual(faults(page, scenes, self.folder / "assets/gallery"), [])
        self.assertNotRegex(page, r"20\d\d-|/tmp|/home")
        figures = json.loads((self.folder / "docs/gallery.json").read_text())
        self.assertLess(figures["scenes"]["flat"]["error"]["px"], 0.05)
        self.assertIsNone(figures["scenes"]["two-spacetimes"]["error"])
        before = (self.folder / "assets/gallery/two-spacetimes.jpg").stat().st_mtime_ns
        self.make("flat")
        self.assertEqual((self.folder / "assets/gallery/two-spacetimes.jpg").stat().st_mtime_ns, before)
        self.assertEqual(faults((self.folder / "docs/gallery.md").read_text(), scenes, self.folder / "assets/gallery"), [])
        self.assertEqual(self.make("no-such-scene", status=1), "gallery: no scene that ships: no-such-scene\n")

    def test_faults_are_found(self):
        card = '<td><img src="../assets/gallery/{}.jpg"> {} <code>nullscope capture {} -o x</code> 1 core-s; error 0 px</td>'
        self.assertEqual(faults("", {"a": "A."}, self.folder), ["a is not on the page"])
        self.assertEqual(faults(card.format("a", "B.", "a"), {"a": "A."}, self.folder),
                         ["a: its sentence is not that of the page", "a: no picture of 480x270"])
        self.assertIn("b ships no more", faults(card.format("b", "", "b"), {}, self.folder))
        (self.folder / "large.jpg").write_bytes(b"x" * (MOST_BYTES + 1))
        self.assertEqual(faults("", {}, self.folder), ["the pictures take more than 2 MB"])


if __name__ == "__main__":
    support.main()
