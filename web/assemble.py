#!/usr/bin/env python3
"""Puts a page's folder together: assemble.py BUILD OUT. BUILD has core.wasm and reference.wasm; OUT is made anew."""
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
ASSETS = ROOT / "assets"
COPIED = ["gallery/*.jpg", "images/*.png", "images/*.jpg", "sky/*", "warp/*.data", "medium/*.grid", "telescopes/*.csv"]  # fetched when a scene asks for them
TEXTS = ["scenes/*.toml", "gallery/groups.toml", "frontier.csv"]  # all at once


COMMENT = re.compile(r"(?m)^[ \t]*//.*$")   # of a line of its own, a twelfth of the scripts: lines keep their numbers


def packed(content):
    """Servers compress some types and not others: the page unpacks by itself. libdeflate's best is 4 % smaller than zlib's."""
    return subprocess.run(["libdeflate-gzip", "-12", "-c"], input=content, stdout=subprocess.PIPE, check=True).stdout


def main():
    build, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(ROOT / "web/page", out)
    for script in out.glob("*.js"):
        script.write_text(COMMENT.sub("", script.read_text()))
    for name in ("core", "reference"):
        (out / f"{name}.wasm.gz").write_bytes(packed((build / f"{name}.wasm").read_bytes()))
    for pattern in COPIED:
        for file in ASSETS.glob(pattern):
            to = out / "assets" / file.relative_to(ASSETS)
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, to)
    texts = {str(file.relative_to(ASSETS)): file.read_text()
             for pattern in TEXTS for file in sorted(ASSETS.glob(pattern))}
    (out / "assets/scenes.json.gz").write_bytes(packed(json.dumps(texts, separators=(",", ":")).encode()))
    shutil.copyfile(ASSETS / "icon.png", out / "icon.png")
    write_service_worker(out)


def write_service_worker(out):
    """sw.js names every file, and is another one whenever a file is another one."""
    names = sorted(str(file.relative_to(out)) for file in out.rglob("*") if file.is_file() and file.name != "sw.js")
    version = hashlib.sha256()
    for name in names:
        version.update(name.encode() + b"\0" + hashlib.sha256((out / name).read_bytes()).digest())
    script = (out / "sw.js").read_text()
    for before, now in (('VERSION = ""', f'VERSION = "{version.hexdigest()[:16]}"'),
                        ("FILES = []", f"FILES = {json.dumps(['./', *names])}")):
        if before not in script:
            sys.exit(f"sw.js: no {before}")
        script = script.replace(before, now)
    (out / "sw.js").write_text(script)


main()
