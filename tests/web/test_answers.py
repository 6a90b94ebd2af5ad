#!/usr/bin/env python3
"""The page's module answers as this machine's own code does: random scene texts and broken ones, the same messages, plans, uniforms, tables.
"""
import json
import re
import struct
import subprocess

from browser import Browser, Server
from support import ROOT, WebTest, main, open_folder

TEXTS, TEXELS = 1000, 200   # random texts; values of each table
TABLE = 1e-12               # rad, of the deflection table
AT_ONCE = 50                # texts a call of the page

# Sines, exponentials and the like of the two C libraries differ in the last digit of a double. A float of a table is the same, a
# neighbour where the number lies next to the middle between two, or, where terms cancel, differs by at most one digit of a float of the
# table's largest value. OTHER: so many of all are not the same. Uniforms are the same bit by bit.
FLOAT_DIGIT, OTHER = 2.0 ** -23, 0.01
# Rays of a zoom wind about the hole, and what they are told apart by grows with each turn: 21 neighbouring camera.r of one at a depth of 20 changed the
# table by up to 1.26 digits of a float of its largest.
ZOOM_DIGITS = 2
# What two doubles of order 1 leave that cancel: 0 but for their last digits.
RESIDUE = 1e-15
# A picture's width is written as a field of view where one of at most 17 digits gives it exactly: that depends on the last digit of tan.
LENS = re.compile(r"\b(?:fov|plane_width) = [^,}]*, ")

BEGIN = """
(async () => {
  const { Module, fetched } = await import("./module.js"), { glFunctions } = await import("./webgl.js");
  const core = await Module.load(new URL("core.wasm", location.href), { env: glFunctions({ getExtension: () => null }, () => core) });
  const files = JSON.parse(new TextDecoder().decode(await fetched(new URL("assets/scenes.json", location.href))));
  for (const [path, text] of Object.entries(files)) core.call("put_file", "/assets/" + path, text);
  // As a page does: files that a scene names are fetched.
  const open = async (text) => {
    for (const tried = new Set(); ;) {
      const opened = Boolean(core.call("open_scene", text, "scene.toml")), why = core.answer();
      const missed = core.json("missed_files").filter((path) => path.startsWith("/assets/") && !tried.has(path));
      if (opened || missed.length === 0) return [opened, why];
      for (const path of missed) {
        tried.add(path);
        const response = await fetch(path.slice(1));
        if (response.ok) core.call("put_file", path, new Uint8Array(await response.arrayBuffer()));
      }
    }
  };
  const ask = (name, ...values) => [Boolean(core.call(name, ...values)), core.answer()];
  window.answersOf = async (texts, texels) => {
    const all = [];
    for (const text of texts) {
      const opened = await open(text);
      all.push(opened[0] ? [opened, ask("scene_as_line"), ask("plan"), ask("numbers", texels)] : [opened]);
    }
    return all;
  };
})()
"""


def floats(digits):
    return struct.unpack(f">{len(digits) // 8}f", bytes.fromhex(digits))


def place(value):
    """Of a float among all floats: neighbours differ by 1."""
    bits = struct.unpack("<i", struct.pack("<f", value))[0]
    return bits if bits >= 0 else -(bits & 0x7fffffff)


class Floats:
    """Counts those that are not the same bits."""

    def __init__(self):
        self.count = self.neighbours = self.cancelled = 0
        self.wrong = []

    def compare(self, name, one, two, text, most):
        """most: by which others than neighbours may differ."""
        if len(one) != len(two):
            self.wrong.append(f"{name}: {len(one)} and {len(two)} numbers of\n{text}")
        self.count += len(one)
        for at, (a, b) in enumerate(zip(one, two)):
            if a == b or (a != a and b != b):
                continue
            if abs(place(a) - place(b)) <= 1:
                self.neighbours += 1
            elif abs(a - b) <= most:
                self.cancelled += 1
            else:
                self.wrong.append(f"{name}[{at}]: {a!r} and {b!r} of\n{text}")

    def check(self, test, what):
        print(f"{what}: {self.count} floats, {self.neighbours} are neighbours, {self.cancelled} more differ by what cancels, "
              f"{len(self.wrong)} by more, the others are the same")
        test.assertFalse(self.wrong, f"{len(self.wrong)}, the first: {self.wrong[:1]}")
        test.assertLessEqual(self.neighbours + self.cancelled, OTHER * self.count)


class Answers(WebTest):
    @classmethod
    def setUpClass(cls):
        broken = sorted(str(file) for file in (ROOT / "tests/broken").glob("*.toml"))
        out = subprocess.run([cls.programs / "native_answers", "texts", str(TEXTS), str(TEXELS), *broken], stdout=subprocess.PIPE, check=True,
                             env={"NULLSCOPE_ASSETS": str(ROOT / "assets")}).stdout
        # Broken texts need not be UTF-8; the page gets what a browser makes of them, and so does nobody else.
        rows = [json.loads(line) for line in out.decode(errors="replace").splitlines()]
        cls.native = [row for row in rows if "\ufffd" not in row["text"]]
        texts = [row["text"] for row in cls.native]
        server = Server(cls.page)
        with Browser("swiftshader") as browser:
            open_folder(browser, server.url)
            browser.run(BEGIN)
            cls.page = []
            for at in range(0, len(texts), AT_ONCE):
                cls.page += browser.run(f"answersOf({json.dumps(texts[at:at + AT_ONCE])}, {TEXELS})", timeout_s=300)
        server.close()

    def pairs(self, which):
        for row, page in zip(self.native, self.page):
            if len(row["answers"]) > which and len(page) > which:
                yield row["text"], row["answers"][which], page[which]

    def numbers(self):
        for text, native, page in self.pairs(3):
            if native[0] and page[0]:
                yield text, json.loads(native[1]), json.loads(page[1])

    def test_there_are_many(self):
        opened = sum(len(row["answers"]) > 1 for row in self.native)
        print(f"{len(self.native)} texts, {opened} of them scenes")
        self.assertGreaterEqual(opened, 0.8 * TEXTS)
        self.assertGreaterEqual(len(self.native) - opened, 200)

    def test_same_message(self):
        lenses = 0
        for which in range(4):
            for text, native, page in self.pairs(which):
                if native[0] and which == 3:
                    continue
                message, lens = native[1].replace(str(ROOT / "assets"), "/assets"), LENS if which == 1 else None
                if lens and message != page[1]:
                    lenses += 1
                    message, page = lens.sub("", message), [page[0], lens.sub("", page[1])]
                self.assertEqual([native[0], message], page, text)
        self.assertEqual([len(row["answers"]) for row in self.native], [len(page) for page in self.page])
        print(f"{lenses} lines say the lens by other numbers")
        self.assertLessEqual(lenses, OTHER * len(self.native))

    def test_same_uniforms(self):
        uniforms = Floats()
        for text, native, page in self.numbers():
            self.assertEqual(native["members"], page["members"], text)
            for name in ("frame", "objects"):
                uniforms.compare(name, floats(native[name]), floats(page[name]), text, RESIDUE)
        uniforms.check(self, "uniforms")
        self.assertEqual(uniforms.neighbours, 0)

    def test_same_tables(self):
        tables, sweeps, worst = Floats(), 0, 0.0
        for text, native, page in self.numbers():
            self.assertEqual(len(native["table"]), len(page["table"]), text)
            sweeps += len(native["table"])
            for a, b in zip(native["table"], page["table"]):
                worst = max(worst, abs(a - b) / max(1.0, abs(a)))
            self.assertEqual(native["texels"].keys(), page["texels"].keys(), text)
            for name, (width, height, values) in native["texels"].items():
                self.assertEqual([width, height], page["texels"][name][:2], text)
                digits = 1
                if name == "orbit table":
                    digits = ZOOM_DIGITS if "[zoom]" in text else 1
                most = digits * FLOAT_DIGIT * max(map(abs, values), default=0.0)
                tables.compare(name, values, page["texels"][name][2], text, most)
        print(f"deflection tables: {sweeps} values, the largest difference {worst:.2g}")
        self.assertLessEqual(worst, TABLE)
        tables.check(self, "tables")


if __name__ == "__main__":
    main()
