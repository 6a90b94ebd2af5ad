"""Writes docs/gpu/NAME.md of what scripts/gpu_measure.sh has measured: what scenes cost on a GPU, and how exact their pictures are."""

import argparse
import json
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
STAGES = ["fragment", "compute"]


def table(head, lines):
    rule = ["---"] + ["---:"] * (len(head) - 1)
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in [head, rule, *lines]) + "\n"


def lines_of(path):
    return [line.split("\t") for line in path.read_text().splitlines()] if path.exists() else []


class Measured:
    """What is in the folder: rows by (stage, size, scene), in the order in which they were measured."""

    def __init__(self, folder):
        self.steps = lines_of(folder / "steps.tsv")
        self.frames = {}
        for name, *_ in self.steps:
            match = re.fullmatch(r"frames (\w+) (\d+x\d+) (\S+)", name)
            path = match and folder / f"frames-{match[1]}-{match[2]}-{match[3]}.json"
            if match and path.exists():
                self.frames[match.groups()] = json.loads(path.read_text())[0]
        read = lambda name: json.loads((folder / name).read_text()) if (folder / name).exists() else []
        self.hard = read("hard.json")
        self.arithmetic = {row["stage"]: row["operations_a_second"] for row in read("arithmetic.json")}
        self.pictures = [json.loads(path.read_text())[0] for path in sorted(folder.glob("pictures-*.json"))]
        self.films = [(scene, stage, workers, size, int(frames), float(end) - float(begun))
                      for scene, stage, workers, size, frames, begun, end in lines_of(folder / "film.tsv")]
        processor = folder / "processor.txt"
        self.processor = processor.read_text().strip() if processor.exists() else "unknown"
        self.golden = [line for line in (folder / "log.txt").read_text(errors="replace").splitlines() if line.startswith("[doctest]")][-3:]

    def sizes(self):
        return list(dict.fromkeys(size for _, size, _ in self.frames))

    def scenes(self):
        return list(dict.fromkeys(scene for _, _, scene in self.frames))

    def gpu_ms(self, stage, size, scene):
        row = self.frames.get((stage, size, scene))
        return row and row["gpu_ms"]


def times(data):
    """ms of a frame by each stage and size."""
    columns = [(size, stage) for size in data.sizes() for stage in STAGES]
    shown = lambda ms: f"{ms:.3f}" if ms else ""
    return table(["scene", *(f"{size} {stage}" for size, stage in columns)],
                 [[scene, *(shown(data.gpu_ms(stage, size, scene)) for size, stage in columns)] for scene in data.scenes()])


def rays(data):
    lines = []
    for scene in data.scenes():
        for size in data.sizes()[::-1]:
            ms = [data.gpu_ms(stage, size, scene) for stage in STAGES]
            if not all(ms):
                continue
            width, height = map(int, size.split("x"))
            floor = data.frames[STAGES[0], size, scene]["floor_gpu_ms"]
            worth = [f"{data.arithmetic[stage] * 1e-3 * each / (width * height):.0f}" if stage in data.arithmetic else ""
                     for stage, each in zip(STAGES, ms)]
            lines.append([scene, size, *(f"{width * height / each / 1e6:.3f}" for each in ms), f"{ms[0] / ms[1]:.2f}", f"{ms[0] / floor:.2f}", *worth])
            break
    peak = ", ".join(f"{stage} {1e-12 * value:.3g}" for stage, value in data.arithmetic.items()) or "not measured"
    return f"10^12 operations a second that do nothing else (`nullscope bench arithmetic`): {peak}.\n\n" + table(
        ["scene", "size", *STAGES, "fragment over compute", "fragment over flat", *(f"operations in its time, {stage}" for stage in STAGES)], lines)


def before(data):
    lines = []
    for scene in data.scenes():
        rows = [data.frames.get((stage, data.sizes()[0], scene)) for stage in STAGES]
        if rows[0]:
            lines.append([scene, f"{rows[0]['table_ms']:.1f}", f"{rows[0]['prepare_ms']:.1f}", *(f"{row['compile_ms']:.0f}" if row else "" for row in rows)])
    return table(["scene", "tables", "tables and upload", *(f"first frame, {stage}" for stage in STAGES)], lines)


def errors(data):
    if not data.hard:
        return "Not measured.\n"
    drivers = [key for key, value in data.hard[0].items() if isinstance(value, dict) and "error_over_bound" in value]
    return table(["case", *drivers, "wrong ends"],
                 [[case["case"], *(f"{case[by]['error_over_bound']:.2f}" if by in case else "" for by in drivers),
                   sum(case[by]["fate_errors"] for by in drivers if by in case)] for case in data.hard])


def pictures(data):
    if not data.pictures:
        return "Not measured.\n"
    of_both = ["difference", "reference"]
    return table(["scene", "pixels", "mean", "99 %", "99.9 %", "the reference's own mean", "99 %", "99.9 %"],
                 [[row["scene"], row["pixels"], *(f"{row[of][key]:.3g}" for of in of_both for key in ("mean", "p99", "p99.9"))]
                  for row in data.pictures])


def films(data):
    lines = []
    for scene, stage, workers, size, frames, seconds in data.films:
        ms = data.gpu_ms(stage, size, scene)
        lines.append([scene, stage, workers, size, f"{frames / seconds:.2f}", f"{100 * frames * ms / 1e3 / seconds:.0f} %" if ms else ""])
    return table(["scene", "stage", "processes", "size", "frames a second", "GPU busy"], lines) if lines else "Not measured.\n"


def left_out(data):
    lines = [[name, "no time was left" if status == "-" else "the time was over" if status == "124" else f"exit status {status}"]
             for name, status, _ in data.steps if status != "0"]
    return table(["step", "why"], lines) if lines else "Nothing.\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("name", help="of the file: docs/gpu/NAME.md; letters, digits, - and _")
    parser.add_argument("results", type=pathlib.Path, help="folder that gpu_measure.sh has filled")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "docs/gpu")
    given = parser.parse_args()
    if not re.fullmatch(r"[A-Za-z0-9_-]+", given.name):
        parser.error(f"NAME: {given.name!r}; letters, digits, - and _ only")
    data = Measured(given.results)
    if not data.frames:
        sys.exit(f"gpu-figures: {given.results}: no frame was measured; see its log.txt")
    row = next(iter(data.frames.values()))
    golden = "".join(f"    {line}\n" for line in data.golden) or "Not measured.\n"
    text = f"""# Figures of {row['renderer']}

Written by `scripts/gpu-figures.sh`; context {row['context']}, {row['frames']} frames a measurement, medians, {sum(int(step[2]) for step in data.steps)} s in all.
Processor: {data.processor}.

## Time of a frame

GPU time by timer queries, ms, of a frame in flight, whose edges have no more rays.

{times(data)}
## Rays

10^9 rays a second, one a pixel, at the largest size that was measured; and how many operations the stage could have done in a ray's time.

{rays(data)}
## Before the first frame

ms: tables on the processor; tables, pictures and their upload together; the first frame, which compiles the shaders.

{before(data)}
## A sequence of pictures

PNG files by `nullscope capture --frames --workers`, with what comes before the first; GPU busy: time of its frames by the table above over the clock's.

{films(data)}
## Errors against the reference

`nullscope bench hard`: of each hard case the largest error over its bound, of the shader core on the processor in double and in float and
of the drivers, and how many rays end elsewhere.

{errors(data)}
## Pictures against the reference

`nullscope bench pictures`: differences, of 255, of pixels chosen at random to 16 x 16 rays of the reference, whose own are those to other rays.

{pictures(data)}
## Golden pictures

{golden}
## Not measured

{left_out(data)}"""
    path = given.folder / f"{given.name}.md"
    path.parent.mkdir(exist_ok=True)
    part = path.with_suffix(".md.part")
    part.write_text(text)
    os.replace(part, path)
    print(path)
    return 1 if any(status not in ("0", "-", "124") for _, status, _ in data.steps) else 0


if __name__ == "__main__":
    sys.exit(main())
