#!/usr/bin/env python3
"""Puts a page's folder together: assemble.py BUILD OUT. BUILD has core.wasm and reference.wasm; OUT is made anew."""
import gzip
import json
import pathlib
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
ASSETS = ROOT / "assets"
COPIED = ["gallery/*.jpg", "images/*.png", "images/*.jpg", "sky/*", "warp/*.data"]  # fetched when a scene asks for them
TEXTS = ["scenes/*.toml", "gallery/groups.toml"]  # all at once


def main():
    build, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(ROOT / "web/page", out)
    for name in ("core", "reference"):
        # Servers compress some types and not others: the page unpacks by itself.
        (out / f"{name}.wasm.gz").write_bytes(gzip.compress((build / f"{name}.wasm").read_bytes(), 9, mtime=0))
    for pattern in COPIED:
        for file in ASSETS.glob(pattern):
            to = out / "assets" / file.relative_to(ASSETS)
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, to)
    texts = {str(file.relative_to(ASSETS)): file.read_text()
             for pattern in TEXTS for file in sorted(ASSETS.glob(pattern))}
    (out / "assets/scenes.json").write_text(json.dumps(texts, separators=(",", ":")))


main()
