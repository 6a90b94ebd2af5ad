#!/usr/bin/env python3
"""Draws every scene that ships by the page in Chromium, Firefox and WebKitGTK (Safari's engine), compares each picture with `nullscope capture`'s,
and writes the table of docs/web.md. All four draw by Mesa's llvmpipe. Standard library, and the packages of scripts/install-packages.sh --web.

    scripts/browsers.py                     every scene in three engines, some twenty minutes
    scripts/browsers.py --scenes kerr flat  these; the others keep what an earlier run measured (build/web/browsers.json)
    scripts/browsers.py --engines webkit    in one engine

A picture that is not drawn is said in the table, and the exit status is 1.
"""
import argparse
import json
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/web"))
from browser import Browser, PageError, Server  # noqa: E402
from other_browsers import Firefox, WebKit  # noqa: E402
from support import SCENES, difference_in, native, read_png  # noqa: E402

SIZE = (192, 108)
ENGINES = {"chromium": lambda: Browser("llvmpipe", *SIZE), "firefox": Firefox, "webkit": WebKit}
TITLES = {"chromium": "Chromium", "firefox": "Firefox", "webkit": "WebKitGTK"}
PAGE, PROGRAMS = ROOT / "build/web/page", ROOT / "build/release/bin"
KEPT, TABLE = ROOT / "build/web/browsers.json", ROOT / "docs/web.md"
BEGIN, END = "<!-- scripts/browsers.py writes from here -->", "<!-- to here -->"


def measure(engine, scenes, folder, kept):
    server = Server(PAGE)
    try:
        with ENGINES[engine]() as browser:
            for scene in scenes:
                if not Path(folder, f"{scene}.png").exists():
                    native(PROGRAMS, scene, SIZE, folder)
                try:
                    found = difference_in(browser, server.url, scene, read_png(f"{folder}/{scene}.png"))._asdict()
                except PageError as error:
                    found = {"failure": str(error).strip().split("\n")[0]}
                kept.setdefault(scene, {})[engine] = found
                print(engine, scene, found, flush=True)
                KEPT.write_text(json.dumps(kept, indent=1))
    finally:
        server.close()


def cells(found):
    if not found:
        return ["not measured", "", ""]
    if "failure" in found:
        return [f"none: {found['failure']}", "", ""]
    return [f"{found['mean']:.3f}", str(found["p999"]), str(found["largest"])]


def table(kept):
    head = "| scene | " + " | ".join(f"{TITLES[engine]}: mean | 99.9 % | largest" for engine in ENGINES) + " |"
    lines = [head, "|---" * (1 + 3 * len(ENGINES)) + "|"]
    for scene in SCENES:
        row = [cell for engine in ENGINES for cell in cells(kept.get(scene, {}).get(engine))]
        lines.append(f"| {scene} | " + " | ".join(row) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", nargs="+", choices=SCENES, default=SCENES, metavar="NAME")
    parser.add_argument("--engines", nargs="+", choices=list(ENGINES), default=list(ENGINES), metavar="ENGINE", help=", ".join(ENGINES))
    asked = parser.parse_args()
    for needed, by in ((PAGE / "index.html", "scripts/web.sh"), (PROGRAMS / "nullscope", "scripts/build.sh")):
        if not needed.exists():
            sys.exit(f"{needed} is not there: {by}")
    kept = json.loads(KEPT.read_text()) if KEPT.exists() else {}
    with tempfile.TemporaryDirectory() as folder:
        for engine in asked.engines:
            measure(engine, asked.scenes, folder, kept)
    text = TABLE.read_text()
    before, after = text.split(BEGIN)[0], text.split(END)[1]
    TABLE.write_text(f"{before}{BEGIN}\n\n{table(kept)}\n\n{END}{after}")
    return int(any("failure" in found for scene in SCENES for found in kept.get(scene, {}).values()))


if __name__ == "__main__":
    sys.exit(main())
