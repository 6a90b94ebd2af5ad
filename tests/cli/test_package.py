#!/usr/bin/env python3
"""The Debian package: made from what is built, unpacked somewhere, and used from there."""
import os
import re
import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import support

BUILD = Path(support.BINARY).parent.parent
ROOT = Path(__file__).resolve().parents[2]


class Package(support.CliTest):
    def ran(self, *words, **environment):
        env = {key: value for key, value in os.environ.items() if key != "NULLSCOPE_ASSETS"}
        done = subprocess.run(list(map(str, words)), cwd=self.folder, env={**env, **environment}, capture_output=True, text=True,
                              timeout=support.LONGEST_S)
        self.assertEqual(done.returncode, 0, f"{words}\n{done.stdout}{done.stderr}")
        return done.stdout

    def test_the_package_is_whole_and_its_programs_run_from_it(self):
        if support.QUICK:
            self.skipTest("with --all")
        self.ran("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", self.folder / "out")
        (package,) = (self.folder / "out").glob("nullscope_*.deb")
        self.assertLess(package.stat().st_size, 16e6)
        self.ran("dpkg-deb", "-x", package, self.folder / "root")
        usr = self.folder / "root" / "usr"
        fields = self.ran("dpkg-deb", "-f", package)
        for name in ("libc6", "libegl1", "libfmt", "libtbb", "libopenexr", "libcfitsio"):
            self.assertIn(name, fields)
        version = self.ran(usr / "bin" / "nullscope", "--version").strip()
        self.assertIn(f"Version: {version.split()[0]}-1~", fields)
        # With the assets that are in it, not those of the sources.
        (usr / "share" / "nullscope" / "scenes" / "only-here.toml").write_text((usr / "share" / "nullscope" / "scenes" / "flat.toml").read_text())
        self.ran(usr / "bin" / "nullscope", "capture", "only-here", "--size", support.SMALL, "-o", "a.png")
        self.assertTrue((self.folder / "a.png").exists())
        pages = sorted(path.name for path in (usr / "share" / "man" / "man1").iterdir())
        self.assertIn("nullscope-capture.1.gz", pages)
        self.assertTrue(all(name.endswith(".1.gz") for name in pages))
        for file in ("bash-completion/completions/nullscope", "doc/nullscope/copyright", "doc/nullscope/README.md", "doc/nullscope/changelog.gz"):
            self.assertTrue((usr / "share" / file).is_file(), file)
        if (BUILD / "bin" / "nullscope-viewer").exists():
            self.assertEqual(version, self.ran(usr / "bin" / "nullscope-viewer", "--version").strip())
            self.assertIn("nullscope-viewer.1.gz", pages)
            for file in ("applications/nullscope.desktop", "icons/hicolor/128x128/apps/nullscope.png", "metainfo/nullscope.metainfo.xml",
                         "mime/packages/nullscope.xml", "bash-completion/completions/nullscope-viewer"):
                self.assertTrue((usr / "share" / file).is_file(), file)
            self.scene_files_open_with_the_viewer(usr / "share")
        if shutil.which("lintian") is None:
            self.fail("lintian is missing: scripts/install-packages.sh --all installs it")
        # With what debian/overrides explains.
        self.assertEqual(self.ran("lintian", "-I", "--suppress-tags", "unused-override", "--fail-on", "error,warning,info", package), "")

    def scene_files_open_with_the_viewer(self, share):
        entry = (share / "applications" / "nullscope.desktop").read_text()
        (kind,) = ElementTree.parse(share / "mime" / "packages" / "nullscope.xml").getroot()
        self.assertIn(f"MimeType={kind.get('type')};", entry)
        self.assertIn("Exec=nullscope-viewer %f", entry)
        globs = [glob.get("pattern") for glob in kind if glob.tag.endswith("glob")]
        self.assertIn("*.nullscope.toml", globs)
        self.assertNotIn("*.toml", globs)   # of editors

    def test_the_version_has_one_place(self):
        version = re.search(r"project\(nullscope VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
        for file, line in (("CITATION.cff", f"version: {version}"), ("CHANGELOG.md", f"## {version}")):
            self.assertRegex((ROOT / file).read_text(), rf"(?m)^{re.escape(line)}\b", file)


if __name__ == "__main__":
    support.main()
