#!/usr/bin/env python3
"""The manual says what help says: man pages without a warning, and completion that bash runs."""
import re
import shutil
import subprocess
import unittest

import support


VIEWER = support.Path(support.BINARY).parent / "nullscope-viewer"


class Manual(support.CliTest):
    def setUp(self):
        super().setUp()
        self.run_nullscope("manual", "m")
        if VIEWER.exists():
            subprocess.run([VIEWER, "--manual", "m"], cwd=self.folder, check=True)
        self.pages = {path.stem: path for path in (self.folder / "m" / "man1").glob("*.1")}

    def commands(self, path=()):
        """Every command, as words."""
        yield path
        listed = self.run_nullscope(*path, "--help").out.partition("Subcommands:\n")[2]
        for name in re.findall(r"^  (\S+) ", listed, re.M):
            yield from self.commands((*path, name))

    def test_every_command_has_a_page_with_its_options(self):
        commands = list(self.commands())
        self.assertGreater(len(commands), 15)
        self.assertEqual(set(self.pages) - {"nullscope-viewer"}, {"-".join(("nullscope", *path)) for path in commands})
        for path in commands:
            page = self.pages["-".join(("nullscope", *path))].read_text().replace("\\-", "-")
            for option in re.findall(r"^  (?:-\w,)?(--[\w-]+)", self.run_nullscope(*path, "--help").out, re.M):
                self.assertIn(option, page, path)

    @unittest.skipUnless(VIEWER.exists(), "built without the viewer")
    def test_the_viewer_has_a_page_with_its_options_and_what_hands_do(self):
        page = self.pages["nullscope-viewer"].read_text().replace("\\-", "-")
        said = subprocess.run([VIEWER, "--help"], capture_output=True, text=True, check=True).stdout
        options = re.findall(r"^  (?:-\w,)?(--[\w-]+)", said, re.M)
        self.assertGreater(len(options), 8)
        for word in [*options, "Ctrl+S saves"]:
            self.assertIn(word, page)

    def test_pages_are_without_a_warning(self):
        if shutil.which("man") is None:
            if not support.QUICK:
                self.fail("man is missing: scripts/install-packages.sh --all installs it")
            self.skipTest("with --all")
        for page in self.pages.values():
            ran = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page], capture_output=True, text=True,
                                 env={"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8", "MANROFFSEQ": "", "MANWIDTH": "80"})
            self.assertEqual((ran.returncode, ran.stderr), (0, ""), page)

    def completed(self, *words):
        function = "_" + words[0].replace("-", "_")
        script = f"source m/{words[0]}.bash; COMP_WORDS=({' '.join(map(repr, words))}); COMP_CWORD={len(words) - 1}; {function}; printf '%s\\n' \"${{COMPREPLY[@]}}\""
        ran = subprocess.run(["bash", "-c", script], cwd=self.folder, capture_output=True, text=True,
                             env={"PATH": f"{support.Path(support.BINARY).parent}:/usr/bin:/bin"})
        self.assertEqual(ran.stderr, "")
        return ran.stdout.split()

    def test_completion(self):
        self.assertEqual(self.completed("nullscope", "cap"), ["capture"])
        self.assertEqual(self.completed("nullscope", "capture", "--rend"), ["--renderer"])
        self.assertEqual(self.completed("nullscope", "capture", "flat", "--renderer", ""), ["gl", "reference"])
        self.assertEqual(self.completed("nullscope", "bench", "fr"), ["frames"])
        self.write("first.toml", "")
        self.assertEqual(self.completed("nullscope", "plan", "fir"), ["first-light", "first.toml"])
        if VIEWER.exists():
            self.assertEqual(self.completed("nullscope-viewer", "--scr"), ["--screenshot"])
            self.assertEqual(self.completed("nullscope-viewer", "fir"), ["first-light", "first.toml"])

    def test_bad_input(self):
        self.write("file", "")
        self.refused("manual", "file/m", status=1, says=["file/m"])


if __name__ == "__main__":
    support.main()
