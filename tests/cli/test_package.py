#!/usr/bin/env python3
"""The Debian package: made from what is built, unpacked somewhere, and used from there."""
import os
import subprocess
from pathlib import Path

import support

BUILD = Path(support.BINARY).parent.parent


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
        self.assertIn(f"Version: {version}", fields)
        # With the assets that are in it, not those of the sources.
        (usr / "share" / "nullscope" / "scenes" / "only-here.toml").write_text((usr / "share" / "nullscope" / "scenes" / "flat.toml").read_text())
        self.ran(usr / "bin" / "nullscope", "capture", "only-here", "--size", support.SMALL, "-o", "a.png")
        self.assertTrue((self.folder / "a.png").exists())
        pages = sorted(path.name for path in (usr / "share" / "man" / "man1").iterdir())
        self.assertIn("nullscope-capture.1.gz", pages)
        self.assertTrue(all(name.endswith(".1.gz") for name in pages))
        for file in ("bash-completion/completions/nullscope", "doc/nullscope/copyright", "doc/nullscope/README.md"):
            self.assertTrue((usr / "share" / file).is_file(), file)
        if (BUILD / "bin" / "nullscope-viewer").exists():
            self.assertIn(version, self.ran(usr / "bin" / "nullscope-viewer", "--version"))
            for file in ("applications/nullscope.desktop", "icons/hicolor/128x128/apps/nullscope.png", "metainfo/nullscope.metainfo.xml"):
                self.assertTrue((usr / "share" / file).is_file(), file)


if __name__ == "__main__":
    support.main()
