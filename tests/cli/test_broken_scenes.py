#!/usr/bin/env python3
"""Every broken scene file of tests/broken gives one clear line (file, line, key, what is allowed) and status 2; so do files too
large to commit."""
import pathlib

import support

BROKEN = pathlib.Path(__file__).resolve().parent.parent / "broken"


def expected():
    for line in (BROKEN / "expected.tsv").read_text().splitlines():
        if not line.startswith("#"):
            name, number, key, *says = line.split("\t")
            yield name, number, key, says


class BrokenScenes(support.CliTest):
    def test_every_file_is_refused_in_one_line(self):
        cases = list(expected())
        self.assertGreaterEqual(len(cases), 200)
        self.assertEqual({c[0] for c in cases}, {f.stem for f in BROKEN.glob("*.toml")}, "files and expected.tsv differ")
        for name, number, key, says in cases:
            with self.subTest(name):
                wanted = [f"{name}.toml:{number}:" if number else f"{name}.toml:", *says]
                if key:
                    wanted += [f": {key}:", "allowed: "]
                self.refused("plan", BROKEN / f"{name}.toml", says=wanted)

    def test_large_files(self):
        self.refused("plan", self.write("ten.toml", b"# ten megabytes\n" * 650_000), says=["ten.toml", "1048576 bytes"])
        self.refused("plan", self.write("line.toml", b"name = \"" + b"x" * 10_000_000 + b"\"\n"), says=["line.toml", "1048576 bytes"])
        self.refused("plan", self.write("keys.toml", b"".join(b"k%d = 1\n" % i for i in range(60_000))), says=["keys.toml:1:", "unknown key"])

    def test_paths_that_are_no_files(self):
        (self.folder / "folder.toml").mkdir()
        self.refused("plan", "folder.toml", says=["folder"])
        self.refused("plan", "none.toml", says=["none.toml"])
        self.refused("plan", "/dev/null", says=["not a regular file"])
        (self.folder / "loop.toml").symlink_to("loop.toml")
        self.refused("plan", "loop.toml", says=["loop.toml"])

    def test_a_good_file_is_not_refused(self):
        self.run_nullscope("plan", self.write("good.toml", "[sphere]\n"))


if __name__ == "__main__":
    support.main()
