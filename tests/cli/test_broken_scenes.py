#!/usr/bin/env python3
"""Every broken scene file of tests/broken gives one clear line (file, line, key, what is allowed) and status 2; so do files too
large to commit."""
import pathlib
import re
import subprocess
import sys

import support

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import random_scenes  # noqa: E402

BROKEN = pathlib.Path(__file__).resolve().parent.parent / "broken"


def expected():
    for line in (BROKEN / "expected.tsv").read_text().splitlines():
        if not line.startswith("#"):
            name, number, key, *says = line.split("\t")
            yield name, number, key, says


NUMBER = r"([\[(])(-?[\d.]+(?:e[+-]?\d+)?), (-?[\d.]+(?:e[+-]?\d+)?)([\])])"


def wrong_values(allowed):
    """Values, as scene files write them, that a key with these allowed ones cannot have."""
    if ends := re.fullmatch(NUMBER, allowed):
        low, high = float(ends[2]), float(ends[3])
        beyond = max(1.0, abs(low), abs(high))
        at = ([repr(low)] if ends[1] == "(" else []) + ([repr(high)] if ends[4] == ")" else [])
        return [repr(low - beyond), repr(high + beyond), "nan", "inf", "-inf", '"a word"', "[1, 2]", "true", *at]
    if ends := re.fullmatch(NUMBER + r", or up to (\d+) of these in ascending order", allowed):
        low, high = float(ends[2]), float(ends[3])
        return [repr(low - 1.0), repr(2 * high), "[]", f"[{high}, {low}]", f"[{high}, {high}]", str(list(range(1, int(ends[5]) + 2))), '["a"]', '"a word"', "[1, nan]"]
    if ends := re.fullmatch(r"an integer from (\d+) to (\d+)", allowed):
        return [str(int(ends[1]) - 1), str(int(ends[2]) + 1), "9223372036854775807", "1.5", "nan", '"one"', "[1]"]
    if ends := re.fullmatch(r"three numbers from (\S+) to (\S+)", allowed):
        return [f"[{float(ends[1]) - 1}, 1, 1]", f"[1, 1, {float(ends[2]) + 1}]", "[1, 1]", "[1, 1, 1, 1]", "1", "[1, nan, 1]", '["a", 1, 1]', "[]"]
    if allowed.startswith("three numbers, speed"):
        return ["[1, 0, 0]", "[0.6, 0.6, 0.6]", "[0, 0]", "0.5", "[inf, 0, 0]"]
    if allowed.startswith("a formula of"):
        return ['"1 +"', '"q"', '"sin("', '""', "1", '"1 1"']
    if " file" in allowed:
        return ['"none-there"', "3", '""']
    if re.fullmatch(r"[\w-]+(, [\w-]+)* or [\w-]+", allowed):
        return ['"no such word"', '""', "1", '["%s"]' % allowed.split(" or ")[-1]]
    return []


class BrokenScenes(support.CliTest):
    def test_every_key_refuses_what_it_does_not_allow(self):
        """By the key's own row of docs/scenes.md, which a test holds against the program's table."""
        keys, _, _ = random_scenes.table_of_keys((BROKEN.parents[1] / "docs/scenes.md").read_text(encoding="utf-8"))
        cases = [(section, key, allowed, value) for section, rows in keys.items() for key, (_, allowed) in rows.items()
                 for value in wrong_values(allowed)]
        self.assertGreater(len(cases), 1000)
        random, failed = support.dice("broken keys"), []
        for section, key, allowed, value in random.sample(cases, 60) if support.QUICK else cases:
            head = f"[[{section}]]\n" if section in random_scenes.LISTS else f"[{section}]\n" if section else "\n"
            done = subprocess.run([support.BINARY, "plan", self.write("broken.toml", f"{head}{key} = {value}\n")], capture_output=True, text=True)
            name = re.escape(f"{section}.{key}" if section else key)
            if done.returncode != 2 or not re.fullmatch(rf"nullscope: \S*broken\.toml:2: {name}: .*; allowed: .*\n", done.stderr) or \
                    value in ('"a word"', "[1, 2]", "nan") and f"; allowed: {allowed}\n" not in done.stderr:
                failed.append(f"{section}.{key} = {value} (allowed: {allowed}): status {done.returncode}, {done.stderr.strip()}")
        self.assertEqual(failed, [], "\n" + "\n".join(failed))

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
