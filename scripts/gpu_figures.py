"""Writes docs/gpu/NAME.md (scripts/gpu-figures.sh): what every scene costs on this machine's GPU, and how exact its pictures are."""

import argparse
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SIZES = ["1280x720", "1920x1080", "3840x2160", "7680x4320"]


def run(*words, check=True):
    print("gpu-figures:", *words[1:], file=sys.stderr, flush=True)
    done = subprocess.run([str(w) for w in words], stdout=subprocess.PIPE, text=True)
    if check and done.returncode != 0:
        sys.exit(f"gpu-figures: {words[0]} {words[1]} failed ({done.returncode})")
    return done


def rows_of(programs, *words):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "rows.json"
        run(programs / "nullscope", "bench", *words, "--json", path, check=words[0] != "hard")   # which says so where a bound is not kept
        return json.loads(path.read_text())


def table(head, lines):
    rule = ["---"] + ["---:"] * (len(head) - 1)
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in [head, rule, *lines]) + "\n"


def frame_times(programs, scenes, sizes, frames, context):
    """By scene: GPU milliseconds at each size, and the rows themselves."""
    rows = {}
    for size in sizes:
        for row in rows_of(programs, "frames", *scenes, "--size", size, "--frames", frames, "--context", context):
            rows.setdefault(row["scene"], []).append(row)
    return rows


def golden(programs):
    """Of the golden pictures' test: the line that says how many checks passed."""
    done = run(programs / "golden_tests", "--no-version", check=False)
    return [line for line in done.stdout.splitlines() if line.startswith("[doctest]")][-3:], done.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("name", help="of the file: docs/gpu/NAME.md; letters, digits, - and _")
    parser.add_argument("--scenes", nargs="+", help="only these; all built-in scenes without")
    parser.add_argument("--sizes", nargs="+", default=SIZES)
    parser.add_argument("--frames", type=int, default=21, help="of each measurement, at least 9")
    parser.add_argument("--only", default="", help="hard cases with this text in their names; without: all")
    parser.add_argument("--context", default="egl", help="egl or osmesa")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "docs/gpu")
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--without-golden", action="store_true", help="leave the golden pictures out")
    given = parser.parse_args()
    if not re.fullmatch(r"[A-Za-z0-9_-]+", given.name):
        parser.error(f"NAME: {given.name!r}; letters, digits, - and _ only")
    listed = run(given.programs / "nullscope", "scenes").stdout
    scenes = given.scenes or [line.split()[0] for line in listed.splitlines() if line[:1].isalnum()]

    rows = frame_times(given.programs, scenes, given.sizes, given.frames, given.context)
    hard = rows_of(given.programs, "hard", "--only", given.only)
    golden_lines, golden_passed = (["not asked for"], True) if given.without_golden else golden(given.programs)

    golden_text = "".join(f"    {line}\n" for line in golden_lines)
    any_row = next(iter(rows.values()))[0]
    pixels = [int(w) * int(h) for w, h in (size.split("x") for size in given.sizes)]
    times, rays, tables = [], [], []
    for scene, by_size in rows.items():
        times.append([scene] + [f"{row['gpu_ms']:.3f}" for row in by_size] + [f"{by_size[-1]['gpu_ms'] / by_size[-1]['floor_gpu_ms']:.2f}"])
        rays.append([scene] + [f"{count / row['gpu_ms'] / 1e6:.3f}" for count, row in zip(pixels, by_size)])
        first = by_size[0]
        tables.append([scene, f"{first['table_ms']:.1f}", f"{first['prepare_ms']:.1f}", f"{first['compile_ms']:.0f}"])
    drivers = [key for key, value in hard[0].items() if isinstance(value, dict) and "error_over_bound" in value]
    errors = [[case["case"], *(f"{case[by]['error_over_bound']:.2f}" if by in case else "" for by in drivers),
               sum(case[by]["fate_errors"] for by in drivers if by in case)] for case in hard]
    text = f"""# Figures of {any_row['renderer']}

Written by `scripts/gpu-figures.sh {shlex.join(sys.argv[1:])}`; context {any_row['context']}, {given.frames} frames a measurement, medians.
Processor: {processor()}.

## Time of a frame

GPU time by timer queries, ms; the last column is the frame's time over that of flat space at {given.sizes[-1]}.

{table(['scene', *given.sizes, 'over flat'], times)}
## Rays

10^9 rays a second, one a pixel.

{table(['scene', *given.sizes], rays)}
## Before the first frame

ms: tables on the processor; tables, pictures and their upload together; the first frame, which compiles the shaders.

{table(['scene', 'tables', 'tables and upload', 'first frame'], tables)}
## Errors against the reference

`nullscope bench hard`: of each hard case the largest error over its bound, of the shader core on the processor in double and in float and
of the drivers, and how many rays end elsewhere.

{table(['case', *drivers, 'wrong ends'], errors)}
## Golden pictures

{golden_text}"""
    path = given.folder / f"{given.name}.md"
    path.parent.mkdir(exist_ok=True)
    part = path.with_suffix(".md.part")
    part.write_text(text)
    os.replace(part, path)
    print(path)
    return 0 if golden_passed else 1


def processor():
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return f"{len(names)} x {names[0]}" if names else "unknown"


if __name__ == "__main__":
    sys.exit(main())
