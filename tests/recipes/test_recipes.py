#!/usr/bin/env python3
"""The recipes of CONTRIBUTING.md can be followed to the letter.

Usage: test_recipes.py FOLDER           what the tier runs
       test_recipes.py --plant FOLDER   a copy of the tree in which all recipes have been followed, to look at and to build

At quick depth (tests/support/depth.h): each line that a recipe names is found once, each new file's path is free, the promised number
of files is kept, and a recipe that is broken on purpose is refused with its line. With --all the recipes are typed into a copy of the
tree in FOLDER, the program is built there, and what it draws is compared: with the scene without what the recipe adds, and with the
reference. FOLDER stays, so that a second run compiles what has changed.
"""
import csv
import hashlib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "viewer"))

import depth
import panel_list
from x_screen import read_png

ROOT = Path(__file__).resolve().parents[2]
TEXT = ROOT / "CONTRIBUTING.md"
QUICK = not depth.deep()
RECIPES = ["a metric", "an effect", "a body kind", "a medium model", "a projection", "a scene section", "an output format", "a panel"]
OF_SCENES = RECIPES[:5]   # each has one
BUILT = ("build", "out")   # folders that are no part of the tree
SIZE = "160x90"

NEW_FILE = re.compile(r"New file `([^`]+)`:")
INSERTION = re.compile(r"In `([^`]+)`, (after|before|in place of) the line that contains `([^`]+)`:")

# Of colours, 0 to 1, mean over the picture: GL filters by footprint, the reference averages 3 x 3 samples; golden cases of edges and
# grids are off by 0.005 to 0.018 (tests/golden/cases.csv).
PICTURE_TOLERANCE = 0.02
PICTURE_PART = 0.25       # the same, over what the recipe adds: without it in one of the two this would be 1
RAYS_PX = 0.05            # the program's own bound of a method's error (--max-error)
FATES_PART = 0.002        # of pixels: edges, where a ray of the two lies on either side
LEAST_CHANGE = 0.02       # mean over the picture: what a recipe adds is seen
LEAST_LIGHT = 0.01        # mean of the picture, against a black one

# Of each planted scene: what makes it the scene without what the recipe adds.
SCENES = {
    "dilaton-hole": (r'metric = "dilaton-hole"\ncharge = 1\.3\n', 'metric = "schwarzschild"\n'),
    "grey-limb": (r'grey_limb = "on"\n', ""),
    "cube": (r"\[cube\]\n(?:.+\n)+", ""),
    "halo": (r"\[medium\]\n(?:.+\n)+", ""),
    "lambert": (r'projection = "lambert"\nfov = 300\.0\n', ""),
    "target": (r"\[target\]\n(?:.+\n)+", ""),
}
# A ray inward from 20 r_s over the cube's middle.
CUBE_RAY = "r,theta,phi,n_r,n_theta,n_phi\n20,1.5707963267948966,2.677945044588987,-1,0.05,0.02\n"


class Wrong(Exception):
    def __init__(self, line, what):
        super().__init__(f"{TEXT.name}:{line}: {what}")
        self.line = line


class Step:
    """One block: a new file, or lines at a line of one that is there."""

    def __init__(self, line, recipe, path, where, anchor, block):
        self.line, self.recipe, self.path, self.where, self.anchor, self.block = line, recipe, path, where, anchor, block


def steps_of(text):
    steps, recipe, said, block, fence = [], None, (0, ""), None, ""
    for number, line in enumerate(text.splitlines(), 1):
        if block is not None:
            if line != "```":
                block.append(line + "\n")
                continue
            at, words = said
            new, insertion = NEW_FILE.fullmatch(words), INSERTION.fullmatch(words)
            if new:
                steps.append(Step(at, recipe, new[1], "new", None, "".join(block)))
            elif insertion:
                steps.append(Step(at, recipe, insertion[1], insertion[2], insertion[3], "".join(block)))
            else:
                raise Wrong(fence, "a block of a recipe without a line before it that says where it goes")
            block = None
        elif line.startswith("## "):
            recipe = line[len("## Recipe: "):] if line.startswith("## Recipe: ") else None
        elif line.startswith("```") and recipe:
            block, fence = [], number
        elif line:
            said = (number, line)
    missing = [name for name in RECIPES if not any(step.recipe == name for step in steps)]
    if missing or block is not None:
        raise Wrong(fence or 1, f"recipes without blocks: {missing}" if missing else "a block without an end")
    return steps


def follow(steps, read):
    """{path: text} of what the steps change. read(path): the text of a file of the tree, None where there is none."""
    files = {}
    for step in steps:
        text = files.get(step.path, read(step.path))
        if step.where == "new":
            if text is not None:
                raise Wrong(step.line, f"{step.path} is there already")
            files[step.path] = step.block
            continue
        if text is None:
            raise Wrong(step.line, f"there is no {step.path}")
        lines = text.splitlines(keepends=True)
        at = [i for i, line in enumerate(lines) if step.anchor in line]
        if len(at) != 1:
            raise Wrong(step.line, f"{len(at)} lines of {step.path} contain {step.anchor!r}; there must be one")
        first = at[0] + (step.where == "after")
        lines[first:first + (step.where == "in place of")] = [step.block]
        files[step.path] = "".join(lines)
    return files


def check_promises(steps):
    """What the architecture promises of each addition."""
    def touched(recipe, *folders):
        return {step.path for step in steps if step.recipe == recipe and step.path.startswith(folders)}

    def at_most(recipe, most, *folders):
        files = touched(recipe, *folders)
        if len(files) > most:
            line = next(step.line for step in steps if step.recipe == recipe)
            raise Wrong(line, f"{recipe} touches {len(files)} files of {', '.join(folders)}, promised are {most}: {sorted(files)}")

    at_most("an effect", 5, "src/", "shaders/")
    at_most("a metric", 5, "src/")          # its own, the reference's, the registry and the reference's two lists
    at_most("a metric", 0, "shaders/")
    at_most("a body kind", 9, "src/", "shaders/")
    at_most("a medium model", 5, "src/", "shaders/")
    at_most("a projection", 4, "src/", "shaders/")
    at_most("a projection", 6, "")            # with its scene and its closed form; docs/scenes.md makes seven
    at_most("a scene section", 3, "src/", "shaders/")
    at_most("a scene section", 5, "")         # with its scene; docs/scenes.md makes six
    at_most("an output format", 3, "src/", "shaders/")   # with src/CMakeLists.txt where a package writes it
    at_most("an output format", 8, "")
    at_most("a panel", 2, "src/", "shaders/")   # with arithmetic of its own and a test three
    at_most("a panel", 3, "")                   # six
    for recipe in OF_SCENES:
        if not touched(recipe, "assets/scenes/"):
            raise Wrong(next(step.line for step in steps if step.recipe == recipe), f"{recipe} has no scene")


def read_tree(path):
    file = ROOT / path
    return file.read_text(encoding="utf-8") if file.is_file() else None


def self_test(text):
    """Each kind of fault, planted: refused, with its line."""
    insertion = next(step for step in steps_of(text) if step.where == "before")
    new = next(step for step in steps_of(text) if step.where == "new")
    lines = text.splitlines(keepends=True)

    def planted(step, old, by):
        changed = list(lines)
        assert old in changed[step.line - 1]
        changed[step.line - 1] = changed[step.line - 1].replace(old, by)
        return "".join(changed)

    faults = {
        "a line that is nowhere": (planted(insertion, insertion.anchor, "no such text in it"), insertion.line),
        "a line that is there often": (planted(insertion, insertion.anchor, "e"), insertion.line),
        "a file that is there": (planted(new, new.path, "README.md"), new.line),
        "a file that is not there": (planted(insertion, insertion.path, "src/nowhere.cpp"), insertion.line),
        "a block that goes nowhere": (planted(new, "New file", "A file"), new.line + 2),
    }
    for what, (broken, line) in faults.items():
        try:
            follow(steps_of(broken), read_tree)
        except Wrong as wrong:
            if wrong.line == line:
                continue
            raise AssertionError(f"self-test: {what}: reported as {wrong}") from wrong
        raise AssertionError(f"self-test: {what} was not found")


def tracked_files():
    """What git knows and what it would take; without git everything but hidden folders and what was built."""
    command = ["git", "-c", "safe.directory=*", "-C", str(ROOT), "ls-files", "-z", "-c", "-o", "--exclude-standard"]
    try:
        names = subprocess.run(command, capture_output=True, check=True).stdout.decode().split("\0")
    except (OSError, subprocess.CalledProcessError):
        names = []
        for folder, inside, files in os.walk(ROOT):
            here = Path(folder).relative_to(ROOT)
            inside[:] = [name for name in inside if name != "__pycache__" and not (here == Path() and (name in BUILT or name[0] == "."))]
            names += [str(here / name) for name in files]
    return [name for name in names if name and (ROOT / name).is_file()]


def plant(folder, changed):
    """The tree with these changes, in folder. What is the same there keeps its time, so that little is compiled again."""
    wanted = set(changed) | set(tracked_files())
    for at, inside, files in os.walk(folder):
        here = Path(at).relative_to(folder)
        inside[:] = [name for name in inside if here != Path() or name not in BUILT]
        for name in files:
            if str(here / name) not in wanted:
                (folder / here / name).unlink()
    for path in sorted(wanted):
        content = changed[path].encode() if path in changed else (ROOT / path).read_bytes()
        file = folder / path
        if not file.is_file() or file.read_bytes() != content:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)
            if path not in changed:
                shutil.copymode(ROOT / path, file)


def run(*command, cwd=None):
    done = subprocess.run([str(word) for word in command], cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace")
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}: status {done.returncode}\n{done.stdout[-6000:]}")
    return done.stdout


def build(folder):
    cache_of = hashlib.md5(str(ROOT).encode()).hexdigest()   # CMakeLists.txt: what this checkout has compiled is not compiled again
    run("cmake", "--preset", "release", "-DNULLSCOPE_VIEWER=ON", "-DNULLSCOPE_TESTS=OFF", f"-DNULLSCOPE_CACHE_OF={cache_of}", cwd=folder)
    run("cmake", "--build", folder / "build/release", "-j2", "--target", "nullscope")
    return folder / "build/release/bin/nullscope"


class Pictures:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def draw(self, scene, name, *options):
        file = self.folder / name
        run(self.program, "capture", scene, "--size", SIZE, *options, "-o", file)
        return file

    def difference(self, a, b):   # mean
        return float(re.search(r"^mean\s+(\S+)", run(self.program, "compare", a, b), re.M)[1])


def check(said, value, holds):
    print(f"  {said}: {value:g}")
    if not holds:
        raise AssertionError(f"{said}: {value:g}")


def judge(pictures, scenes, name):
    print(name)
    scene, (pattern, by) = scenes / f"{name}.toml", SCENES[name]
    without, count = re.subn(pattern, by, scene.read_text(encoding="utf-8"))
    assert count == 1, f"{scene.name}: what the recipe adds is not found in it"
    bare = pictures.folder / f"{name}-without.toml"
    bare.write_text(without, encoding="utf-8")
    black = pictures.folder / "black.toml"
    black.write_text('[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "black"\n', encoding="utf-8")
    drawn = pictures.draw(scene, f"{name}.png")
    light = pictures.difference(drawn, pictures.draw(black, "black.png"))
    check(f"its mean light, at least {LEAST_LIGHT}", light, light >= LEAST_LIGHT)
    change = pictures.difference(drawn, pictures.draw(bare, f"{name}-without.png"))
    check(f"what the recipe adds to it, at least {LEAST_CHANGE}", change, change >= LEAST_CHANGE)
    off = pictures.difference(drawn, pictures.draw(scene, f"{name}-reference.png", "--renderer", "reference"))
    most = min(PICTURE_TOLERANCE, PICTURE_PART * change)
    check(f"its difference from the reference's, at most {most:g}", off, off <= most)
    gl = pictures.draw(scene, f"{name}.exr", "--raydata")
    exact = pictures.draw(scene, f"{name}-reference.exr", "--raydata", "--renderer", "reference", "--samples", "1")
    said = run(pictures.program, "compare", gl, exact, "--scene", scene)
    rays = [float(px) for px in re.findall(r"^(?:screen error|place on disc|swept angle)\s+max \S+\s+99\.9 % (\S+)", said, re.M)]
    check(f"99.9 % of its rays, px, at most {RAYS_PX}", max(rays), max(rays) <= RAYS_PX)
    fates, of = re.search(r"^fate differs\s+(\d+) of (\d+)", said, re.M).groups()
    check(f"fates that differ, part of pixels, at most {FATES_PART}", int(fates) / int(of), int(fates) <= FATES_PART * int(of))


def judge_hit(pictures, scenes):
    rays = pictures.folder / "rays.csv"
    rays.write_text(CUBE_RAY, encoding="utf-8")
    for tracer in ("reference", "gl"):
        out = pictures.folder / f"traced-{tracer}.csv"
        run(pictures.program, "trace", scenes / "cube.toml", "--rays", rays, "--with", tracer, "-o", out)
        with open(out, encoding="utf-8", newline="") as lines:
            fates = [row["fate"] for row in csv.DictReader(line for line in lines if not line.startswith("#"))]
        if fates != ["hit:cube"]:
            raise AssertionError(f"a ray onto the cube, traced with {tracer}: {fates}")


def judge_format(pictures):
    """A pixmap has the bytes of the PNG, and is drawn again from itself."""
    first, again = (pictures.folder / name for name in ("first.ppm", "again.ppm"))
    run(pictures.program, "capture", "first-light", "--size", "64x36", "-o", first)
    run(pictures.program, "capture", first, "-o", again)
    png = pictures.folder / "first.png"
    run(pictures.program, "capture", "first-light", "--size", "64x36", "-o", png)
    data, shown = first.read_bytes(), read_png(png)
    if data[-3 * 64 * 36:] != bytes(shown.data) or data != again.read_bytes():
        raise AssertionError("a .ppm is not the .png, or not drawn again from itself")


def judge_panel(folder):
    """The panel's file and the list compile as the viewer's do (all of the viewer would take two base minutes), and docs/viewer.md says of it
    what its row says."""
    commands = json.loads((folder / "build/release/compile_commands.json").read_text())
    command = next(shlex.split(each["command"]) for each in commands if "nullscope-viewer.dir" in each["command"])
    flags = command[:command.index("-o")] + ["-fsyntax-only"]
    for name in ("caption_panel.cpp", "panel.cpp"):
        run(*flags, folder / "src/viewer" / name, cwd=folder / "build/release")
    sources = {path.name: path.read_text(encoding="utf-8") for path in (folder / "src/viewer").iterdir()}
    words = re.search(r'\.words = "([^"]+)"', sources["caption_panel.cpp"])[1]
    wrong = panel_list.forgotten(sources)
    if ("Caption", "", words) not in panel_list.documented((folder / "docs/viewer.md").read_text(encoding="utf-8")):
        wrong.append("docs/viewer.md does not have the panel's row")
    if wrong:
        raise AssertionError("\n".join(wrong))


def main():
    arguments = sys.argv[1:]
    only_plant = arguments[:1] == ["--plant"]
    folder = Path(arguments[-1]).resolve()
    text = TEXT.read_text(encoding="utf-8")
    steps = steps_of(text)
    changed = follow(steps, read_tree)
    check_promises(steps)
    self_test(text)
    print(f"{len(steps)} blocks, {len(changed)} files: every line is found once")
    if QUICK and not only_plant:
        return
    plant(folder, changed)
    if only_plant:
        return
    if shutil.which("clang-format"):
        run("scripts/format.sh", "--check", *[path for path in changed if path.endswith((".h", ".cpp"))], cwd=folder)
    program = build(folder)
    with tempfile.TemporaryDirectory(prefix="nullscope-recipes-") as temporary:
        pictures = Pictures(program, Path(temporary))
        for name in SCENES:
            judge(pictures, folder / "assets/scenes", name)
        judge_hit(pictures, folder / "assets/scenes")
        judge_format(pictures)
        judge_panel(folder)


if __name__ == "__main__":
    try:
        main()
    except (Wrong, AssertionError) as wrong:
        sys.exit(f"FAILED: {wrong}")
