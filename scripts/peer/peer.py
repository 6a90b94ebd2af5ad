#!/usr/bin/env python3
"""What a frame costs here and in the best comparable program, drawn in turn by the same OpenGL driver.

    scripts/peer/peer.py                     every row, nine turns: `nullscope bench frames` and the other program, one after the other
    scripts/peer/peer.py --runs 2 sky image  these rows, two turns
    scripts/peer/peer.py --png FOLDER        no times: a picture of each row by both, to see that they show the same; where they
                                             have the same light, too, they are compared, and the exit status is 1 where they differ

The other program is Eric Bruneton's black_hole_shader (https://github.com/ebruneton/black_hole_shader, BSD-3-Clause; arXiv:2010.08735): a hole
without rotation, rays by tables, for WebGL 2. It is cloned at a fixed commit into a temporary folder and stays there; its tables are made by
its own programs and its shaders are drawn by harness.cpp, full-screen, at the scene's camera. Rows, and what its picture is in each, are in rows.py.

Times are processor seconds of all threads, of one frame with glFinish; of each turn the median of its frames. All runs on one core. Favours to
the other program: no bloom and no tone curve, which its demo draws in passes of their own; 8 bits a colour; stars off; trilinear fetches, where
its demo asks for the most of anisotropic ones (llvmpipe may take minutes over such a frame); shifts only where nullscope's scene has them
(--doppler: everywhere, as its demo begins); what it does not show is compiled out. Its sky has seamless edges, which WebGL 2 prescribes; --seams
draws without. nullscope's frames are as in the viewer while the camera moves, with tone curve.

Needs git, g++, make, libegl-dev, libgl-dev, libpng-dev (scripts/install-packages.sh). NULLSCOPE_PEER and NULLSCOPE_PEER_TYPES, or --from and
--types-from, name other places to clone from: it and https://github.com/ebruneton/dimensional_types.
"""
import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
import checkouts
import rows

ROOT = rows.ROOT
SAME_LIGHT = ("--set", "picture.refine=off", "--set", "picture.tone=shoulder")   # one ray a pixel, and the tone curve of the harness
ALIKE_DB = 30.0   # of pictures with the same light: 35.8 to 37.7; with a field of view 1 % wider 23.2 to 25.3


def parsed():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rows", nargs="*", metavar="ROW", help=f"rows to measure (default: all): {', '.join(row.name for row in rows.ROWS)}")
    parser.add_argument("--binary", type=Path, default=ROOT / "build/release/bin/nullscope")
    parser.add_argument("--from", dest="source", default=os.environ.get("NULLSCOPE_PEER", checkouts.SOURCE))
    parser.add_argument("--types-from", default=os.environ.get("NULLSCOPE_PEER_TYPES", checkouts.TYPES_SOURCE))
    parser.add_argument("--runs", type=int, default=9, help="turns (9)")
    parser.add_argument("--frames", type=int, default=11, help="frames of each turn, at least 9 (11)")
    parser.add_argument("--warm-up", type=int, default=3, help="its frames before those (3); nullscope's bench draws one")
    parser.add_argument("--core", type=int, help="the core that both run on (the first that is allowed)")
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--seams", action="store_true", help="its sky without seamless edges")
    parser.add_argument("--doppler", action="store_true", help="its shifts in every row")
    parser.add_argument("--png", type=Path, metavar="FOLDER", help="pictures instead of times")
    parser.add_argument("--work", type=Path, metavar="FOLDER", help="keep the checkout there, and use one that is there")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write all figures there")
    options = parser.parse_args()
    known = {row.name: row for row in rows.ROWS}
    unknown = [name for name in options.rows if name not in known]
    if unknown:
        parser.error(f"{', '.join(unknown)}: no such row; there are {', '.join(known)}")
    if options.runs < 1 or options.frames < 9 or options.warm_up < 1:
        parser.error("--runs and --warm-up: at least 1; --frames: at least 9")
    allowed = os.sched_getaffinity(0)
    if options.core is not None and options.core not in allowed:
        parser.error(f"--core {options.core}: this process may run on {sorted(allowed)}")
    if not options.binary.exists():
        parser.error(f"{options.binary} is not there: scripts/build.sh nullscope, or --binary")
    options.binary = options.binary.resolve()
    options.core = min(allowed) if options.core is None else options.core
    options.rows = [known[name] for name in options.rows] or list(rows.ROWS)
    return options


def ours(row, folder, options):
    """Processor seconds of a frame, and the driver."""
    out = folder / "frames.json"
    checkouts.ran(options.binary, "bench", "frames", row.path, "--size", options.size, "--frames", options.frames, "--json", out)
    bench = json.loads(out.read_text())[0]
    return bench["core_seconds"] / (bench["fetch_ratio"] if row.fetch else 1.0), bench["renderer"]


def theirs(harness, settings):
    drawn = json.loads(checkouts.ran(harness, settings))
    return statistics.median(drawn["core_seconds"]), drawn["renderer"]


def turns(prepared, harness, folder, options):
    """{row: (nullscope's, its)}, a time each turn; who begins changes from turn to turn."""
    times, driver = {row: ([], []) for row in prepared}, None
    for turn in range(options.runs):
        for row, settings in prepared.items():
            for side in (0, 1) if turn % 2 == 0 else (1, 0):
                seconds, drawn_by = ours(row, folder, options) if side == 0 else theirs(harness, settings)
                if drawn_by != (driver := driver or drawn_by):
                    raise SystemExit(f"peer: two drivers: {driver} and {drawn_by}")
                times[row][side].append(seconds)
        print(f"peer: turn {turn + 1} of {options.runs}", file=sys.stderr, flush=True)
    print(f"\n{driver}, {options.size}, core {options.core}; turns: {options.runs}, of {options.frames} frames; core-ms a frame, least and median of the turns")
    return times


def table(times):
    print(f"\n{'row':<14} {'scene':<12} {'nullscope':>15} {'the other':>15} {'ratio of the least':>19}   the other draws")
    figures = []
    for row, (mine, its) in times.items():
        ratio = min(mine) / min(its)
        pair = lambda values: f"{1e3 * min(values):7.2f} {1e3 * statistics.median(values):7.2f}"
        print(f"{row.name:<14} {row.scene:<12} {pair(mine)} {pair(its)} {ratio:19.3f}   {row.peer}")
        figures.append({"row": row.name, "scene": row.scene, "peer": row.peer, "nullscope_core_s": mine, "peer_core_s": its, "ratio": ratio})
    return figures


def likeness(binary, mine, its):
    """Peak signal-to-noise ratio of two pictures, dB."""
    return float(re.search(r"PSNR +([\d.]+) dB", checkouts.ran(binary, "compare", mine, its))[1])


def pictures(prepared, harness, options):
    options.png.mkdir(parents=True, exist_ok=True)
    differing = []
    for row, settings in prepared.items():
        if row.fetch:
            continue
        mine, its = options.png / f"{row.name}-nullscope.png", options.png / f"{row.name}-peer.png"
        checkouts.ran(options.binary, "capture", row.path, "--size", options.size, "--quiet", "-o", mine, *SAME_LIGHT)
        with settings.open("a") as file:
            file.write(f"png\t{its.resolve()}\n")
        theirs(harness, settings)
        said = ""
        if row.alike:
            db = likeness(options.binary, mine, its)
            said = f"; {db:.1f} dB"
            if db < ALIKE_DB:
                differing.append(f"{row.name} ({db:.1f} dB)")
        print(f"{mine} {its}: {row.peer}{said}", flush=True)
    if differing:
        raise SystemExit(f"peer: the two pictures differ, below {ALIKE_DB} dB: {', '.join(differing)}")


def main():
    options = parsed()
    with tempfile.TemporaryDirectory(prefix="nullscope-peer-") as temporary:
        folder = options.work.resolve() if options.work else Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        peer = checkouts.made(folder, options.source, options.types_from)
        harness = checkouts.harness(folder)
        prepared = {row: rows.settings(row, peer, folder, options) for row in options.rows}
        if options.png:
            return pictures(prepared, harness, options)
        os.sched_setaffinity(0, {options.core})   # what is started inherits it
        figures = table(turns(prepared, harness, folder, options))
        if options.json:
            options.json.write_text(json.dumps(figures, indent=1) + "\n")


if __name__ == "__main__":
    main()
