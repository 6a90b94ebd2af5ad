#!/usr/bin/env python3
"""Makes docs/gallery.md and its pictures: every scene that ships, with its sentence, command, cost and error. Standard library only.

    scripts/gallery.py             every scene; 450 core-seconds with llvmpipe
    scripts/gallery.py NAME...     these scenes anew; the others stay as they are on the page
    scripts/gallery.py --errors    the errors alone, of all scenes or of those named
    scripts/gallery.py --page      the page alone, from the figures of the last run

Pictures: assets/gallery/NAME.jpg, which the viewer shows too. Figures: docs/gallery.json, of one driver. A scene belongs to a group of
assets/gallery/groups.toml.
"""
import argparse
import html
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# Of a film: the frame that is shown, as a part of its length. Others: half of it.
FRAMES = {}

WIDTH, HEIGHT = 480, 270     # px of a picture
SAMPLES = 3                  # rays along a side of a pixel
QUALITY = 78                 # of the JPEG
MOST_BYTES = 2_000_000       # all pictures together
COST_SIZE, COST_FRAMES = "1280x720", 9
ERROR_SIZE = "160x90"

SLOW_REFERENCE = {"wormhole-saturn"}   # bodies by formula in the dneg-wormhole: a tenth of a second a ray
ERROR_WORDS = (f"the largest error of a ray's place on the sky or the disc at {ERROR_SIZE}, in pixels of that size, against the "
               "double-precision reference tracer")

PAGE = """# Gallery

Every scene that ships, as `nullscope` draws it. `scripts/gallery.py` makes this page and its pictures ({width} x {height} px,
{samples} x {samples} rays a pixel). Below each picture: the command that draws it in full size; its cost, core-seconds of a frame of
{cost_size} (`nullscope bench frames`; of a split screen that of a picture of the left half's spacetime); its error,
{error}. Driver: {driver}.
"""


class Refused(Exception):
    """One line for the caller."""


def nullscope(binary, *arguments):
    done = subprocess.run([binary, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise Refused(f"nullscope {' '.join(map(str, arguments))}: {done.stderr.strip().splitlines()[-1:]}")
    return done.stdout


def load_groups():
    """Their titles, and the names of their scenes."""
    groups = tomllib.loads((ROOT / "assets/gallery/groups.toml").read_text())["group"]
    return {group["title"]: group["scenes"] for group in groups}


def load_scenes(groups):
    """The scenes that ship, by name; and that each is in one group."""
    scenes = {path.stem: tomllib.loads(path.read_text()) for path in sorted((ROOT / "assets/scenes").glob("*.toml"))}
    grouped = [name for names in groups.values() for name in names]
    twice = {name for name in grouped if grouped.count(name) > 1}
    for words, names in (("in no group", set(scenes) - set(grouped)), ("in two groups", twice),
                         ("in a group, but no scene", set(grouped) - set(scenes))):
        if names:
            raise Refused(f"{words} of groups.toml: {', '.join(sorted(names))}")
    return scenes


def draw(binary, name, scene, to, folder):
    how = ["--size", f"{WIDTH}x{HEIGHT}", "--samples", SAMPLES, "--quality", QUALITY]
    path = scene.get("path")
    if path is None:
        nullscope(binary, "capture", name, *how, "-o", folder / "picture.jpg")
        drawn = folder / "picture.jpg"
    else:
        keys = path.get("key", [])
        frames = path.get("frames", int(keys[-1].get("frame", len(keys) - 1)) + 1 if keys else 240)
        frame = min(int(FRAMES.get(name, 0.5) * frames), frames - 1)
        nullscope(binary, "capture", name, *how, "-o", folder / "picture%d.jpg", "--frames", f"{frame}:{frame + 1}")
        drawn = folder / f"picture{frame}.jpg"
    shutil.move(drawn, to)  # also to another file system


def cost(binary, name, folder):
    """Core-seconds of a frame, and the driver that drew it."""
    nullscope(binary, "bench", "frames", name, "--size", COST_SIZE, "--frames", COST_FRAMES, "--json", folder / "cost.json")
    row = json.loads((folder / "cost.json").read_text())[0]
    version = re.search(rf'^{row["context"]}: OpenGL (.*)$', nullscope(binary, "info"), re.M).group(1)
    return row["core_seconds"], f'{row["renderer"]}, OpenGL {version}'


def error(binary, name, scene, folder):
    """As ERROR_WORDS says; None where it is not measured.

    `nullscope bench pictures` will compare displayed pictures with the reference's: its call goes here, its words into ERROR_WORDS, the
    words of a number into error_words().
    """
    if "split" in scene or "beside" in scene or "zoom" in scene or name in SLOW_REFERENCE:
        return None  # ray data are of one spacetime; in a zoom no screen error tells what is off along the ring
    for renderer, more in (("gl", ()), ("reference", ("--samples", 1))):
        nullscope(binary, "capture", name, "--size", ERROR_SIZE, "--raydata", "--renderer", renderer, *more, "-o", folder / f"{renderer}.exr")
    said = nullscope(binary, "compare", folder / "gl.exr", folder / "reference.exr", "--scene", name)
    found = [float(number) for number in re.findall(r"^(?:screen error|place on disc)\s+max (\S+)", said, re.M)]
    fates = int(re.search(r"^fate differs\s+(\d+)", said, re.M).group(1))
    return {"px": max(found), "fates": fates}


def error_words(found):
    if found is None:
        return "error not measured"
    words = f"error {found['px']:.2g} px"
    return words + (f", {found['fates']} rays end elsewhere" if found["fates"] else "")


def card(name, scene, figures):
    title, sentence = (html.escape(scene.get(key, ""), quote=False) for key in ("name", "description"))
    film = ".mp4" if "path" in scene else ".png"
    return (f'<td width="50%" valign="top"><img src="../assets/gallery/{name}.jpg" width="{WIDTH}" alt="{html.escape(title)}"><br>'
            f"<b>{title}</b>. {sentence}<br><code>nullscope capture {name} -o {name}{film}</code><br>"
            f"{figures['core_s']:.2g} core-s; {error_words(figures['error'])}</td>\n")


def page(groups, scenes, figures):
    text = PAGE.format(width=WIDTH, height=HEIGHT, samples=SAMPLES, cost_size=COST_SIZE, error=ERROR_WORDS, driver=figures["driver"])
    for group, names in groups.items():
        cards = [card(name, scenes[name], figures["scenes"][name]) for name in names if name in figures["scenes"]]
        if not cards:
            continue
        rows = ["<tr>\n" + "".join(cards[i:i + 2]) + "</tr>\n" for i in range(0, len(cards), 2)]
        text += f"\n## {group}\n\n<table>\n{''.join(rows)}</table>\n"
    return text


def update(binary, scenes, names, figures, pictures, kept, only_errors):
    """Scene by scene: what is done is kept if a later one fails."""
    with tempfile.TemporaryDirectory(prefix="nullscope-gallery-") as folder:
        for i, name in enumerate(names):
            print(f"gallery: {name} ({i + 1} of {len(names)})", file=sys.stderr)
            if only_errors and name in figures["scenes"]:
                figures["scenes"][name]["error"] = error(binary, name, scenes[name], Path(folder))
                kept.write_text(json.dumps(figures, indent=1, sort_keys=True) + "\n")
                continue
            core_s, driver = cost(binary, name, Path(folder))
            if figures["scenes"] and driver != figures["driver"]:
                raise Refused(f"the page's other figures are of another driver, {figures['driver']}: make all of it anew")
            figures["driver"] = driver
            draw(binary, name, scenes[name], pictures / f"{name}.jpg", Path(folder))
            figures["scenes"][name] = {"core_s": core_s, "error": error(binary, name, scenes[name], Path(folder))}
            kept.write_text(json.dumps(figures, indent=1, sort_keys=True) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scenes", nargs="*", metavar="NAME", help="scenes to make anew (default: all)")
    parser.add_argument("--page", action="store_true", help="only the page, from the figures that are there")
    parser.add_argument("--errors", action="store_true", help="only the errors anew, not costs and pictures")
    parser.add_argument("--into", type=Path, default=ROOT, metavar="FOLDER",
                        help="where docs/gallery.md and assets/gallery go (default: this tree)")
    parser.add_argument("--binary", default=str(ROOT / "build/release/bin/nullscope"), metavar="FILE", help="the program that draws")
    options = parser.parse_args()
    groups = load_groups()
    scenes = load_scenes(groups)
    unknown = [name for name in options.scenes if name not in scenes]
    if unknown:
        raise Refused(f"no scene that ships: {', '.join(unknown)}")
    pictures, docs = options.into / "assets/gallery", options.into / "docs"
    for folder in (pictures, docs):
        folder.mkdir(parents=True, exist_ok=True)
    kept = docs / "gallery.json"
    figures = json.loads(kept.read_text()) if kept.exists() and (options.scenes or options.page or options.errors) else {"driver": "", "scenes": {}}
    figures["scenes"] = {name: row for name, row in figures["scenes"].items() if name in scenes}
    if not options.page:
        update(options.binary, scenes, options.scenes or list(scenes), figures, pictures, kept, options.errors)
    for picture in pictures.glob("*.jpg"):
        if picture.stem not in scenes:
            picture.unlink()
    kept.write_text(json.dumps(figures, indent=1, sort_keys=True) + "\n")
    (docs / "gallery.md").write_text(page(groups, scenes, figures))
    size = sum(picture.stat().st_size for picture in pictures.glob("*.jpg"))
    print(f"gallery: {len(figures['scenes'])} scenes, {size / 1e6:.2f} MB of pictures", file=sys.stderr)
    if size > MOST_BYTES:
        raise Refused(f"the pictures take more than {MOST_BYTES / 1e6:.0f} MB: lower QUALITY")


if __name__ == "__main__":
    try:
        main()
    except Refused as refused:
        sys.exit(f"gallery: {refused}")
