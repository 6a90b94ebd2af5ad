#!/usr/bin/env python3
"""What frames cost by two builds, drawn in turn, in floors: frames of the same sky in flat space, by the older build.

    scripts/floors.py OLD                    OLD: the older build's nullscope; nine turns
    scripts/floors.py OLD --runs 2 sky kerr  these rows, two turns
    scripts/floors.py OLD --poses 50         and so many random cameras: the dearest over the cheapest

Times are processor seconds of all threads by `nullscope bench frames`, frames as in the viewer while the camera moves; of each turn the median of
its frames, of the turns the least. All runs on one core; who begins changes from turn to turn.
"""
import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SCENES = ROOT / "assets/scenes"

ROWS = {   # row: (scene, what it is over: "floor" or another row)
    "flat": ("flat", "floor"),
    "sky": ("sky-only", "floor"),
    "pattern-disc": ("pattern-disc", "floor"),
    "image-disc": ("first-light", "floor"),
    "kerr-sky": ("kerr-sky", "floor"),
    "kerr-planet": ("kerr-planet", "floor"),
    "torus": ("torus", "floor"),
    "kerr-in-flat-space": ("kerr-flat", "floor"),
    "kerr": ("kerr", "kerr-in-flat-space"),
    "ball": ("balls-1", "floor"),
    "balls": ("balls-32", "ball"),
    "swarm": ("swarm", "floor"),
}


def section(text, name):
    """The lines of a scene's section, its head included."""
    lines = text.splitlines()
    begin = lines.index(f"[{name}]")
    end = next((i for i in range(begin + 1, len(lines)) if lines[i].startswith("[")), len(lines))
    return "\n".join(lines[begin:end]) + "\n"


def balls(number):
    """Balls on two circular orbits, as those of tests/gpu/test_tiles.cpp."""
    text = 'name = "Balls"\n[camera]\nr = 26.0\ntheta = 73.9\nfov = 46.0\n[sky]\nkind = "stars"\n'
    for i in range(number):
        turn, r = math.pi / 8 * (i // 2), 7.0 if i % 2 == 0 else 10.0
        text += f'[[ball]]\nposition = [{r * math.cos(turn):.6f}, {r * math.sin(turn):.6f}, 0]\nradius = 0.4\nmotion = "orbit"\n'
    return text


def write_scenes(folder):
    """Those that do not ship."""
    kerr = (SCENES / "kerr.toml").read_text()
    image = (SCENES / "first-light.toml").read_text()
    written = {
        "kerr-sky": kerr.replace(section(kerr, "disc"), ""),
        "kerr-flat": kerr.replace(section(kerr, "spacetime"), '[spacetime]\nmetric = "minkowski"\n').replace('observer = "zamo"', 'observer = "static"'),
        "pattern-disc": image.replace(section(image, "disc"), '[disc]\ninner = 3.0\nouter = 12.0\ntexture = "grid"\n'),
        "balls-1": balls(1),
        "balls-32": balls(32),
    }
    for name, text in written.items():
        (folder / f"{name}.toml").write_text(text)
    return {name: str(folder / f"{name}.toml") for name in written}


def frame(binary, scene, folder, options, *more):
    out = folder / "frames.json"
    command = [binary, "bench", "frames", scene, "--size", options.size, "--frames", str(options.frames), "--json", str(out), *more]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"floors: {' '.join(map(str, command))}: {done.stderr.strip()}")
    return json.loads(out.read_text())[0]


def measure(rows, scenes, folder, options):
    times = {row: {"old": [], "new": []} for row in rows}
    for turn in range(options.runs):
        for row in rows:
            scene = scenes.get(ROWS[row][0], ROWS[row][0])
            for build in ("old", "new") if turn % 2 == 0 else ("new", "old"):
                times[row][build].append(frame(options.builds[build], scene, folder, options)["core_seconds"])
        print(f"floors: turn {turn + 1} of {options.runs}", file=sys.stderr, flush=True)
    return {row: {build: min(values) for build, values in both.items()} for row, both in times.items()}


def table(least):
    floor = least["flat"]["old"]
    print(f"{'row':<20} {'core-ms old':>12} {'new':>9} {'over':<20} {'old':>7} {'new':>7}   new over old")
    for row, both in least.items():
        over = ROWS[row][1]
        by = {build: floor if over == "floor" else least[over][build] for build in both}
        print(f"{row:<20} {1e3 * both['old']:12.2f} {1e3 * both['new']:9.2f} {over:<20} {both['old'] / by['old']:7.2f} "
              f"{both['new'] / by['new']:7.2f}   {both['new'] / both['old']:.3f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=Path, metavar="OLD")
    parser.add_argument("rows", nargs="*", metavar="ROW", help=f"rows (default: all): {', '.join(ROWS)}")
    parser.add_argument("--new", type=Path, default=ROOT / "build/release/bin/nullscope")
    parser.add_argument("--runs", type=int, default=9, help="turns (9)")
    parser.add_argument("--frames", type=int, default=11, help="frames of each turn, at least 9 (11)")
    parser.add_argument("--core", type=int, help="the core that all run on (the first that is allowed)")
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--poses", type=int, default=0, help="random cameras of kerr and of its sky")
    options = parser.parse_intermixed_args()
    if unknown := [row for row in options.rows if row not in ROWS]:
        parser.error(f"{', '.join(unknown)}: no such row; there are {', '.join(ROWS)}")
    if options.runs < 1 or options.frames < 9:
        parser.error("--runs: at least 1; --frames: at least 9")
    options.builds = {"old": options.old.resolve(), "new": options.new.resolve()}
    allowed = os.sched_getaffinity(0)
    if options.core is not None and options.core not in allowed:
        parser.error(f"--core {options.core}: this process may run on {sorted(allowed)}")
    os.sched_setaffinity(0, {min(allowed) if options.core is None else options.core})
    wanted = set(options.rows or ROWS) | {"flat"}
    wanted |= {ROWS[row][1] for row in wanted} - {"floor"}
    with tempfile.TemporaryDirectory(prefix="nullscope-floors.") as folder:
        folder = Path(folder)
        scenes = write_scenes(folder)
        table(measure([row for row in ROWS if row in wanted], scenes, folder, options))
        for scene in ("kerr", "kerr-sky") if options.poses > 0 else ():
            ratios = [frame(options.builds[build], scenes.get(scene, scene), folder, options, "--poses", str(options.poses))["pose_ratio"] for build in ("old", "new")]
            print(f"{scene}: the dearest of {options.poses} cameras over the cheapest: old {ratios[0]:.1f}, new {ratios[1]:.1f}")


if __name__ == "__main__":
    main()
