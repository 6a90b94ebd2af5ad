#!/usr/bin/env python3
"""Every kind of scene with every other: the rows are a covering array of matrix_scenes.FACTORS, in which each pair of their values occurs,
and of each row every output is drawn. So thing x switch x output are there in threes. What the shader draws is held against the reference
tracer, ray by ray; what lies beside a picture against the picture. NULLSCOPE_SEED gives other rows, cameras and times.

At quick depth a few rows, at depth all a sixth of them, and with NULLSCOPE_TESTS=everything all.
"""
import itertools
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import support
import matrix_judge as judge
import matrix_scenes as scenes

sys.path.append("/usr/lib/python3/dist-packages")   # python3-allpairspy, where this is another Python than the system's
from allpairspy import AllPairs  # noqa: E402

ASSETS = Path(__file__).resolve().parents[2] / "assets"
MATTER_HIT = 9
ROWS = 1 if support.QUICK else 10 ** 6 if support.depth.EVERYTHING else 40
BASE = {"metric": "schwarzschild", "thing": "none", "switch": "on", "camera": "static", "projection": "pinhole", "sky": "black", "extra": "none"}

# In every run: kinds that went together wrongly once, or that scripts/mutate.py plants.
KNOWN = [{**BASE, **row} for row in [
    {"thing": "ball-orbit", "switch": "delay", "projection": "fisheye"}, {"thing": "disc-thermal", "switch": "beaming", "metric": "kerr"},
    {"thing": "spot", "sky": "plain", "projection": "fisheye"}, {"extra": "zoom", "sky": "points"}, {"thing": "gas", "sky": "formula"}, {"thing": "surface"},
    {"thing": "disc-flow", "switch": "delay", "metric": "hayward"}]]


def any_row(random, row):
    """A row with the chosen values that is not refused; none where there is none: value by value, going back where none is left."""
    left = [name for name in scenes.FACTORS if name not in row]
    if not left:
        return row
    name = left[0]
    for value in random.sample(sorted(scenes.FACTORS[name]), len(scenes.FACTORS[name])):
        more = {**row, name: value}
        if not scenes.refusals(more) and (whole := any_row(random, more)):
            return whole
    return None


def missing_pairs(rows):
    """Pairs of values, as parts of rows, that are in no row, though no rule refuses them."""
    for a, b in itertools.combinations(scenes.FACTORS, 2):
        there = {(row[a], row[b]) for row in rows}
        for pair in itertools.product(scenes.FACTORS[a], scenes.FACTORS[b]):
            if pair not in there and not scenes.refusals({a: pair[0], b: pair[1]}):
                yield {a: pair[0], b: pair[1]}


def covering_rows(random):
    """Rows in which every pair of values that is not refused occurs. The package gives up pairs that it cannot complete in its order."""
    names = sorted(scenes.FACTORS, key=lambda name: -len(scenes.FACTORS[name]))
    values = [random.sample(sorted(scenes.FACTORS[name]), len(scenes.FACTORS[name])) for name in names]
    rows = [dict(zip(names, row)) for row in AllPairs(values, filter_func=lambda row: not scenes.refusals(dict(zip(names, row))))]
    hopeless = []
    while left := [pair for pair in missing_pairs(rows) if pair not in hopeless]:
        row = any_row(random, left[0])
        (hopeless if row is None else rows).append(left[0] if row is None else row)
    return random.sample(rows, len(rows))


def any_place(random):
    """r, theta, phi of the camera, and the time."""
    return random.uniform(10, 12), random.uniform(55, 80), random.uniform(-30, 30), random.uniform(0, 15)


class Matrix(support.CliTest):
    def setUp(self):
        super().setUp()
        scenes.write_files(self.folder, ASSETS)
        self.numbers = itertools.count()

    def capture(self, row, place, *words, ending="exr"):
        """Channels of the file, or the refusal's line."""
        number = next(self.numbers)
        scene, words = self.folder / f"{number}.toml", [*scenes.OPTIONS.get(row["extra"], []), *words]
        scene.write_text(scenes.text_of(scenes.compose(row, place)))
        name = f"{number}-%d" if "--frames" in words else str(number)
        done = subprocess.run([support.BINARY, "capture", scene, *words, "-o", self.folder / f"{name}.{ending}"],
                              capture_output=True, timeout=support.LONGEST_S)
        said = done.stderr.decode("utf-8", "replace").strip()
        if done.returncode != 0:
            return f"status {done.returncode}, {said}"
        return support.read_exr((self.folder / f"{name.replace('%d', '0')}.{ending}").read_bytes())

    def drawn(self, row, place, *words):
        got = self.capture(row, place, *words)
        if isinstance(got, str):
            raise AssertionError(f"{' '.join(words)} refused: {got}")
        return got

    def exact(self, row, place, *words):
        samples = "2" if row["extra"] in ("samples", "refine") and row["metric"] not in scenes.FORMULAS else "1"
        return self.drawn(row, place, "--renderer", "reference", "--samples", samples, *words)

    def beside(self, row, place, picture, exact):
        """What is wrong with each output beside a picture."""
        def rays(*words):
            got, what = self.drawn(row, place, *words), " ".join(words)
            if "--layers" in words and row["thing"] in scenes.MATTER_THINGS:   # they tell matter too, which ray data do not know
                got["hit"] = [[b if a == MATTER_HIT else a for a, b in zip(*lines)] for lines in zip(got["hit"], exact["hit"])]
            return (judge.finite(got, what) + judge.same(got, picture, what) + (judge.layers_add_up(got, what) if "--layers" in words else []) +
                    judge.rays_agree(got, exact, what))

        def half():
            return judge.halves(self.drawn(row, place, "--half"), picture)

        def map_of(of):
            return judge.maps_agree(self.drawn(row, place, "--st-map", of),
                                    self.drawn(row, place, "--st-map", of, "--renderer", "reference"), f"--st-map {of}")
        wrong = []
        for output, words in [(rays, ["--raydata"]), (rays, ["--layers"]), (rays, ["--layers", "--raydata"]), (half, []), (map_of, ["sky"]),
                              (map_of, ["plate"])]:
            try:
                wrong += output(*words)
            except AssertionError as refused:
                wrong.append(str(refused))
        return wrong

    def wrong_of(self, row, place):
        """What is wrong, and whether the row counts: its thing is seen."""
        alone = row["extra"] in scenes.ALONE
        try:
            picture, exact = self.drawn(row, place), self.exact(row, place, *(() if alone else ("--raydata",)))
            seen = row["thing"] == "none" or judge.is_seen(picture, self.drawn({**row, "thing": "none"}, place))
        except AssertionError as refused:
            return [str(refused)], True
        wrong = judge.finite(picture, "picture")
        if row["sky"] in scenes.COARSE or row["extra"] == "zoom":   # next to the ring all is edges
            wrong += judge.sums_agree(picture, exact, "picture")
        elif alone or scenes.is_rough(row):
            wrong += judge.pictures_agree(picture, exact, "picture", rough=scenes.is_rough(row))
        else:
            inner = judge.inner_pixels(exact, row["sky"] not in scenes.ROUGH_SKIES)
            wrong += judge.pictures_agree(picture, exact, "picture", inner)
        if not alone:
            wrong += self.beside(row, place, picture, exact)
        return wrong, seen

    @support.costly
    def test_rows(self):
        random = support.dice("matrix")
        rows = KNOWN + covering_rows(random)[:ROWS]
        places = [any_place(random) for _ in rows]
        failures, unseen = [], []
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for row, place, (wrong, seen) in zip(rows, places, pool.map(self.wrong_of, rows, places)):
                text = " ".join(f"{name}={value}" for name, value in row.items()) + f" place={place}"
                failures += [f"{text}: {line}" for line in wrong]
                unseen += [] if seen else [text]
        print(f"    {len(rows)} rows, in {len(unseen)} the thing is not seen", flush=True)
        self.assertEqual(failures, [], "\n" + "\n".join(failures))
        self.assertLessEqual(len(unseen), max(1, 0.05 * len(rows)), unseen)

    @support.costly
    def test_every_pair_is_in_a_row(self):
        random = support.dice("pairs")
        rows = covering_rows(random)
        missing = list(missing_pairs(rows))
        self.assertEqual([pair for pair in missing if any_row(random, pair)], [])
        print(f"    {len(rows)} rows; pairs that are refused with every third value: {missing}", flush=True)

    def test_refusals(self):
        """What is refused by a rule alone is refused by one line with file, line, key and what is allowed."""
        random, wrong = support.dice("refusals"), []
        for values, _ in scenes.REFUSED:
            choices = [dict(zip(values, chosen)) for chosen in itertools.product(*map(sorted, values.values()))]
            for chosen in random.sample(choices, min(len(choices), 1 if support.QUICK else 20)):
                row = {**BASE, **chosen}
                got, words = self.capture(row, any_place(random)), "|".join(scenes.refusals(row))
                if not isinstance(got, str):
                    wrong.append(f"{chosen} is drawn, though {words}")
                elif not re.search(rf"^status 2, nullscope: \S*\.toml:\d+: [\w.]+.*({words}).*; allowed: [^\n]+$", got):
                    wrong.append(f"{chosen}: {got}")
        self.assertEqual(wrong, [], "\n".join(wrong))

    @support.costly
    def test_random_scenes_are_drawn(self):
        """scripts/random_scenes.py makes scenes, settles what they rule out, and judges them."""
        seed, count = ("13", "2") if not support.depth.EVERYTHING else (str(support.dice("scenes").randrange(10 ** 6)), "50")
        done = subprocess.run([sys.executable, "-B", ASSETS.parent / "scripts/random_scenes.py", "--binary", support.BINARY, "--count", count,
                               "--seed", seed, "--folder", self.folder / "scenes"], capture_output=True, text=True, timeout=support.LONGEST_S)
        self.assertEqual((done.returncode, done.stdout.splitlines()[-1]), (0, f"{count} scenes, 0 with something wrong"), done.stdout + done.stderr)

    @support.costly
    def test_the_judge_sees(self):
        """A switch that is ignored, a thing that is left out, a layer that is missing."""
        place, few = (11.0, 70.0, 10.0, 7.0), 2 if support.QUICK else None
        for thing, switch, metric in [("disc-thermal", "shift", "kerr"), ("ball-orbit", "delay", "schwarzschild"), ("disc-thermal", "beaming", "kerr"),
                                      ("disc-thermal", "doppler", "schwarzschild"), ("disc-thermal", "gravity", "schwarzschild"),
                                      ("disc", "lensing", "schwarzschild"), ("disc-flow", "delay", "kerr"),
                                      ("disc-thermal", "bolometric", "kerr")][:few]:
            row = {**BASE, "thing": thing, "metric": metric}
            exact = self.exact(row, place, "--raydata")
            inner = judge.inner_pixels(exact)
            self.assertEqual(judge.pictures_agree(self.drawn(row, place), exact, "", inner), [], row)
            self.assertTrue(judge.pictures_agree(self.drawn({**row, "switch": switch}, place), exact, "", inner), f"{row}: without {switch}")
        row = {**BASE, "sky": "plain"}
        nothing = self.drawn(row, place, "--raydata")
        for thing in ["ball", "matter", "spot", "surface", "gas", "cylinder", "disc-clear"][:few]:
            exact = self.exact({**row, "thing": thing}, place, "--raydata")
            self.assertTrue(judge.pictures_agree(nothing, exact, ""), f"{thing}: left out of the picture")
            self.assertTrue(judge.rays_agree(nothing, exact, "") or thing in scenes.MATTER_THINGS, f"{thing}: left out of ray data")
        layers = self.drawn({**row, "thing": "disc-clear"}, place, "--layers")
        layers["disc1.R"] = [[0.0] * len(line) for line in layers["disc1.R"]]
        self.assertTrue(judge.layers_add_up(layers, ""), "a layer that is left out")


if __name__ == "__main__":
    support.main()
