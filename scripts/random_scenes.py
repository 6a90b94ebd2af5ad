#!/usr/bin/env python3
"""Draws scenes that nobody wrote: keys and ranges are those of docs/scenes.md, which a test holds against the program's own table.

Usage: random_scenes.py [--binary NULLSCOPE] [--count N] [--minutes M] [--seed S] [--folder FOLDER]

What a scene rules out is left out, by what the program's refusals say: each must name file, line, key and what is allowed. Then the shader
is held against the reference tracer, ray by ray: no crash, hang, NaN, negative light or OpenGL error, the same things at the same places.
A scene in which something is wrong is made smaller, key by key, and written to FOLDER with what was seen in its first lines.
"""
import argparse
import itertools
import math
import os
import random
import re
import resource
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SLOW_S = 60           # processor seconds of the shader: the clock would blame a scene for what else the machine does
PATIENCE = 4          # times that for the reference
PROGRESS_S = 60       # between lines that say how far it is
FLAT_ZOOM_DEG = 0.1   # fov below which what lies behind the centre of flat space is lost (docs/accuracy.md)
CLUMPS_STEP = 0.1     # medium.step at which clumps of gas are resolved (docs/matter.md)
DEADLOCK = 60         # times the processor seconds, on the clock: it waits for what never comes
PICTURE = "32x18"
NEEDS = re.compile(r'(?:[Nn]eeds|[Ff]or) (\w+) = ((?:"[\w-]+"(?:, | or )?)+)')
NUMBER = r"-?[\d.]+(?:e[+-]?\d+)?"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binary", default=str(ROOT / "build/release/bin/nullscope"))
    parser.add_argument("--count", type=int, default=10 ** 9)
    parser.add_argument("--minutes", type=float, default=1e9)
    parser.add_argument("--seed", type=int, default=int(os.environ.get("NULLSCOPE_SEED") or random.SystemRandom().randrange(10 ** 6)))
    parser.add_argument("--folder", type=Path, default=Path("random-scenes"))
    return parser.parse_args()


def table_of_keys(text):
    """section -> key -> (default, allowed), from the rows of docs/scenes.md; metric -> its parameters likewise; (section,
    key, other key) -> values of the other that it needs."""
    keys, metrics, needs = {}, {}, {}
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        if len(cells) == 5 and (name := re.fullmatch(r"`([\w.]+)`", cells[0])) and cells[3] != "Allowed":
            section, _, key = name[1].rpartition(".")
            keys.setdefault(section, {})[key] = (cells[2].strip("`"), cells[3])
            needs.update({(section, key, other): re.findall(r'"([\w-]+)"', values) for other, values in NEEDS.findall(cells[4])})
        elif len(cells) in (2, 3) and (name := re.fullmatch(r"`([\w-]+)`", cells[0])):
            found = re.findall(r"`spacetime\.(\w+)`: ?([^;,]*, \[[^\]]*\]|a formula of r)", line)
            metrics[name[1]] = {key: ("", allowed.split(", ", 1)[-1]) for key, allowed in found}
    known = keys["spacetime"]["metric"][1].replace(" or ", ", ").split(", ")
    metrics = {name: metrics.get(name, {}) for name in known}
    metrics["dneg-wormhole"].setdefault("throat", metrics["ellis"]["throat"])
    return keys, metrics, needs


FORMULAS = {
    "r": ["1 - 1/r", "1 - 1/r + 0.1/r^2", "1 - r^2/(r^3 + {a})", "1 - 1/r - 0.0001*r^2", "exp(-1/r)", "1 + {a}/r^2", "r + {a}", "r*sqrt(1 + {a}/r)"],
    "x, y, z or t": ["length(x - {a}, y, z - {b}) - {c}", "(length(x, y) - 5)^2 + z^2 - {c}", "length(x - 4*cos(0.1*t), y - 4*sin(0.1*t), z) - {c}",
                     "max(abs(x) - {a}, max(abs(y) - {b}, abs(z) - {c}))", "z - {a}*noise(x, y, z)"],
    "t": ["{a}", "{a} + {b}*sin(0.2*t)", "6*cos(0.1*t)", "6*sin(0.1*t)", "0.3*t"],
    "u, v, x, y or z": ["0.5", "u", "v", "0.5 + 0.5*sin({a}*x)", "noise(x, y, z)", "step(0.5, u)", "smoothstep(0, 1, v)", "{a}*x + y*z", "1/x"],
    "x, y, z, r or t": ["{a}", "exp(-r^2/{c})", "{c}/r", "exp(-((x - 4)^2 + y^2 + z^2)/{c})", "1e6*exp(-r)", "3e10/r", "sin(t) + 1.5",
                        "step(r, {c})", "0.4*noise(x, y, z)"],
}
WORDS = {"an image file": "smooth.png", "a warp mesh file": "bent.data", "a CSV file": "camera.csv", "a grid of matter": "torus.grid"}
CALM = {"samples": 3, "sub_frames": 4, "uniform_stars": 2000, "count": 8, "frames": 20}     # what costs time and shows nothing new
SHARES = {"camera": 1.0, "spacetime": 0.8, "sky": 0.8, "light": 0.4, "picture": 0.3, "disc": 0.35, "ball": 0.3, "surface": 0.2, "sphere": 0.12,
          "cylinder": 0.15, "medium": 0.25, "spot": 0.1, "object": 0.25, "zoom": 0.06, "split": 0.05, "far_sky": 0.15}
LISTS = ("ball", "surface", "sphere", "cylinder", "spot")
LEFT_OUT = {"format", "name", "description", "left_label", "right_label", "labels", "size", "catalogue", "stereo", "eye_distance", "shutter",
            "sub_frames", "refine", "warp", "scale_bar"}


class Generator:
    def __init__(self, dice):
        self.dice = dice
        self.keys, self.metrics, self.needs = table_of_keys((ROOT / "docs/scenes.md").read_text(encoding="utf-8"))

    def number(self, default, low, high):
        dice, kind = self.dice, self.dice.random()
        if kind < 0.12:
            return dice.choice((low, high))
        if kind < 0.2:
            return dice.choice((low + 1e-6 * max(1e-3, abs(low)), high - 1e-6 * max(1e-3, abs(high))))
        if kind < 0.7 and default not in ("", "-"):
            value = float(default) * dice.uniform(0.4, 1.6) if float(default) else dice.uniform(-1, 1)
        elif low >= 0 and high > 1e3 * max(low, 1e-6):
            value = math.exp(dice.uniform(math.log(max(low, 1e-3)), math.log(min(high, 1e4))))
        else:
            value = dice.uniform(max(low, -360), min(high, 360))
        return min(max(value, low), high)

    def value(self, key, default, allowed):
        dice = self.dice
        if formula := re.match(r"a formula of (.*)", allowed):
            numbers = {name: round(dice.uniform(0.1, 3), 2) for name in "abc"}
            return dice.choice(FORMULAS.get(formula[1], ["1"])).format(**numbers)
        for words, file in WORDS.items():
            if allowed.startswith(words):
                return file
        if integer := re.match(rf"an integer from ({NUMBER}) to ({NUMBER})", allowed):
            return int(self.number(default, float(integer[1]), min(float(integer[2]), CALM.get(key, 1e9))))
        if array := re.match(rf"three numbers from ({NUMBER}) to ({NUMBER})", allowed):
            low, high = max(float(array[1]), -8.0), min(float(array[2]), 8.0)
            return [round(dice.uniform(low, high), 3) for _ in range(3)]
        if "speed below 1" in allowed:
            return [round(dice.uniform(-0.55, 0.55), 3) for _ in range(3)]
        if ends := re.match(rf"([\[(])({NUMBER}), ({NUMBER})([\])])", allowed):
            low, high = float(ends[2]), float(ends[3])
            tiny = 1e-9 * max(1.0, abs(high))
            if "in ascending order" in allowed and dice.random() < 0.3:
                return sorted({self.number(default, low, high) for _ in range(dice.randint(2, 5))})
            return self.number(default, low + (tiny if ends[1] == "(" else 0), high - (tiny if ends[4] == ")" else 0))
        return dice.choice([word for word in re.split(r", | or ", allowed) if word not in ("tycho-2",)])

    def section(self, section, share=0.3):
        rows = self.keys[section]
        table = {key: self.value(key, *row) for key, row in rows.items() if key not in LEFT_OUT and self.dice.random() < share}
        for (place, key, other), values in self.needs.items():
            if place == section and key in table and other in rows and table.get(other, rows[other][0]) not in values:
                del table[key]
        return table

    def scene(self):
        dice = self.dice
        scene = {"": {"time": round(dice.uniform(-50, 50), 2)}}
        for section, share in SHARES.items():
            if dice.random() >= share:
                continue
            table = self.section(section)
            if section in ("spacetime", "split"):
                metric = dice.choice(sorted(self.metrics))
                table = {**table, "metric": metric, **{key: self.value(key, *row) for key, row in self.metrics[metric].items() if dice.random() < 0.7}}
            scene[section] = [table] if section in LISTS else table
        scene["camera"].setdefault("r", round(dice.uniform(6, 30), 2))
        if scene["camera"].get("projection") == "cube":
            scene["camera"]["size"] = [48, 32]
        scene["picture"] = {**scene.get("picture", {}), "refine": "off"}
        if dice.random() < 0.8:   # the default sky takes seconds
            scene.setdefault("sky", {}).setdefault("kind", dice.choice(["black", "plain", "formula", "checker", "grid"]))
        if scene.get("spacetime", {}).get("metric") in ("ellis", "dneg-wormhole"):
            scene.setdefault("far_sky", {}).setdefault("kind", "black")
        return scene


class Judge:
    def __init__(self, options):
        sys.argv = [sys.argv[0], options.binary]
        sys.path.insert(0, str(ROOT / "tests/cli"))
        import matrix_judge
        import matrix_scenes
        import support
        self.support, self.judge, self.scenes, self.binary, self.folder = support, matrix_judge, matrix_scenes, str(Path(options.binary).resolve()), options.folder
        self.folder.mkdir(parents=True, exist_ok=True)
        matrix_scenes.write_files(self.folder, ROOT / "assets")
        (self.folder / "camera.csv").write_text("frame,r,theta\n0,15,80\n10,12,70\n")

    def run(self, scene, *words, limit=SLOW_S):
        """Exit status (None: too long) and what it said; the picture is self.folder/now.exr."""
        (self.folder / "now.toml").write_text(self.scenes.text_of(scene))
        size = [] if "size" in scene["camera"] else ["--size", PICTURE]
        try:
            done = subprocess.run([self.binary, *words[:1], "now.toml", *words[1:], *(size if words[0] == "capture" else [])], cwd=self.folder,
                                  capture_output=True, timeout=DEADLOCK * limit,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5)))
        except subprocess.TimeoutExpired:
            return None, ""
        if done.returncode == -signal.SIGXCPU:
            return None, ""
        return done.returncode, done.stderr.decode("utf-8", "replace").strip()

    def channels(self):
        return self.support.read_exr((self.folder / "now.exr").read_bytes())

    def wrong(self, scene):
        """What is wrong, each with a word of its kind first."""
        status, said = self.run(scene, "capture", "--raydata", "-o", "now.exr")
        if status == 2 and "for one spacetime only" in said:
            return []
        if status != 0 or "GL error" in said:
            return [f"hang: more than {SLOW_S} processor seconds" if status is None else f"failed: status {status}, {said}"]
        got = self.channels()
        if wrong := [f"values: {line}" for line in self.judge.finite(got, "gl")]:
            return wrong
        if self.run(scene, "capture", "-o", "now.exr")[0] == 0 and (wrong := self.judge.same(self.channels(), got, "")):
            return [f"bits: {wrong[0]}"]
        if self.run(scene, "capture", "--layers", "-o", "now.exr")[0] == 0:
            layers = self.channels()
            if wrong := self.judge.finite(layers, "--layers") + self.judge.layers_add_up(layers, "--layers"):
                return [f"layers: {wrong[0]}"]
        status, said = self.run(scene, "capture", "--renderer", "reference", "--samples", "1", "--raydata", "-o", "now.exr", limit=PATIENCE * SLOW_S)
        if status is None or (status == 2 and CLEAR.match(said)):   # too deep a zoom for directions in double
            return []
        if status != 0:
            return [f"reference: status {status}, {said}"]
        exact = self.channels()
        if wrong := self.judge.finite(exact, "reference"):
            return [f"exact: {wrong[0]}"]
        if is_flat(scene) and scene["camera"].get("fov", 60.0) < FLAT_ZOOM_DEG:
            return []
        wrong = [f"rays: {line}" for line in self.judge.rays_agree(got, exact, "ray data")]
        return wrong or ([] if finer_than_pixels(scene) else [f"picture: {line}" for line in self.judge.pictures_agree(got, exact, "")])


CLEAR = re.compile(r"^nullscope: now\.toml:\d+: ([\w.\[\]-]+)(?::| =) (.*); allowed: .+$")


def is_flat(scene):
    return scene.get("light", {}).get("lensing") == "off" or scene.get("spacetime", {}).get("metric") == "minkowski"


def finer_than_pixels(scene):
    """Whether there are patterns, of which the shader has the mean over a pixel and the reference one place, or clumps within a step."""
    tables = itertools.chain.from_iterable(table if isinstance(table, list) else [table] for table in scene.values())
    kinds = {table.get("texture") for table in tables} | {scene.get("sky", {}).get("kind", "stars"), scene.get("disc", {}).get("texture", "image")
                                                          if "disc" in scene else None}
    gas = scene.get("medium", {})
    clumps = "medium" in scene and gas.get("kind", "gas") == "gas" and gas.get("gas_contrast", 0.7) > 0
    return not kinds <= {None, "plain", "black"} or clumps and gas.get("step", 1.0) > CLUMPS_STEP


def without(scene, section, key=None, index=0):
    """A copy without a key, or a section."""
    less = {name: [dict(each) for each in table] if isinstance(table, list) else dict(table) for name, table in scene.items()}
    if key is None:
        del less[section]
    else:
        table = less[section][index] if isinstance(less[section], list) else less[section]
        del table[key]
    return less


def settled(generator, judge, scene):
    """The scene less what its own values rule out; or what is wrong with a refusal."""
    refused = Counter()
    for _ in range(100):
        status, said = judge.run(scene, "plan")
        if status == 0:
            return scene, None
        told = CLEAR.match(said)
        if status != 2 or told is None or "\n" in said:
            return scene, f"refusal: status {status}, {said}"
        section, _, key = re.sub(r"\[\d+\]", "", told[1]).rpartition(".")
        if section == "" and key in scene:
            section, key = key, None
        if section not in scene:
            if section in generator.keys and "missing" in told[2]:
                scene = {**scene, section: {}}
            else:
                return scene, f"refusal: names {told[1]}, which is not in the scene: {said}"
        if "[split]" in told[2] and "split" in scene:
            scene = without(scene, "split")
            continue
        refused[told[1]] += 1
        tables = scene[section] if isinstance(scene[section], list) else [scene[section]]
        if refused[told[1]] > 3:   # what was changed is refused by another key, and back
            scene = {**scene, "spacetime": {}} if section in ("camera", "spacetime") else without(scene, section)
        elif key is not None and key in tables[0]:
            scene = without(scene, section, key)
        elif key is not None and "missing" in told[2] and key in generator.keys.get(section, {}):
            tables[0][key] = generator.value(key, *generator.keys[section][key])
        elif section in ("camera", "") and scene["camera"] != {"r": 15.0}:
            scene = {**scene, "camera": {"r": 15.0}}
        elif section in ("camera", ""):
            scene = {**scene, "spacetime": {}}
        elif section == "spacetime":
            scene = {**scene, "spacetime": {}}
        else:
            scene = without(scene, section)
    return scene, "refusal: no end of refusals"


def shrunk(judge, scene, kind):
    """Without every section and key that it takes not."""
    again = lambda less: judge.run(less, "plan")[0] == 0 and any(line.startswith(kind) for line in judge.wrong(less))
    for section in [name for name in scene if name not in ("", "camera")]:
        if section in scene and again(less := without(scene, section)):
            scene = less
    for section, tables in list(scene.items()):
        for index, table in enumerate(tables if isinstance(tables, list) else [tables]):
            for key in list(table):
                if again(less := without(scene, section, key, index)):
                    scene = less
    return scene


def main():
    options = parse_arguments()
    judge, dice = Judge(options), random.Random(options.seed)
    generator, end, found = Generator(dice), time.time() + 60 * options.minutes, 0
    print(f"NULLSCOPE_SEED={options.seed}", flush=True)
    told = time.time()
    for number in itertools.count():
        if number >= options.count or time.time() > end:
            break
        if time.time() > told + PROGRESS_S:
            told = time.time()
            print(f"{number} scenes, {found} with something wrong so far", file=sys.stderr, flush=True)
        scene, wrong = settled(generator, judge, generator.scene())
        lines = [wrong] if wrong else judge.wrong(scene)
        if not lines:
            continue
        found += 1
        kind = lines[0].split(":")[0]
        if kind not in ("refusal", "hang"):
            scene = shrunk(judge, scene, kind)
            lines = judge.wrong(scene) or lines
        text = "".join(f"# {line}\n" for line in lines) + judge.scenes.text_of(scene)
        (judge.folder / f"{options.seed}-{number}-{kind}.toml").write_text(text)
        print(f"--- {number}\n{text}", flush=True)
    print(f"{number} scenes, {found} with something wrong")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
