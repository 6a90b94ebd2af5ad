#!/usr/bin/env python3
"""Writes the tables of docs/devices.md from what scripts/devices.sh measured: devices_table.py NULLSCOPE FOLDER DEVICES.MD

FOLDER has a folder for each driver, with the output of `nullscope devices --measure --json` and its pictures.
"""
import json
import os
import re
import subprocess
import sys
from pathlib import Path

ORDER = ["llvmpipe-256", "llvmpipe-128", "llvmpipe-512", "osmesa", "zink", "trixie", "forky", "softpipe"]
BEGIN, END = "<!-- scripts/devices.sh writes from here -->", "<!-- to here -->"


def picture_of(folder, scene):
    return next(iter(sorted(folder.glob(f"{scene}-*.png"))), None)


def difference(program, a, b):
    """Largest of a pixel's colours, of 255."""
    said = subprocess.run([program, "compare", a, b], check=True, capture_output=True, text=True).stdout
    return f"{255 * float(re.search(r'difference +max ([0-9.e+-]+)', said)[1]):.0f}"


def position(row):
    wrong = f" ({row['wrong_fates']} wrong)" if row["wrong_fates"] else ""
    return f"{row['position_px']:.1g}{wrong}" if row["position_px"] is not None else f"not finite{wrong}"


def table(title, drivers, cell):
    scenes = [row["scene"] for row in next(iter(drivers.values()))["scenes"]]
    lines = [title, "", "| driver | " + " | ".join(scenes) + " |", "|---|" + "---|" * len(scenes)]
    for name, device in drivers.items():
        cells = [short(row["failure"]) if "failure" in row else cell(name, row) for row in device["scenes"]]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def short(failure):
    return failure.replace("the driver ended its process: no end within ", "over ").replace("the driver ended its process: ", "dies: ")


def tables(program, folder):
    drivers = {name: json.loads((folder / name / "devices.json").read_text())[0]
               for name in ORDER if (folder / name / "devices.json").exists() and (folder / name / "devices.json").stat().st_size > 0}
    what = ["| driver | as it names itself | OpenGL | compute |", "|---|---|---|---|"]
    what += [f"| {name} | {d['renderer']} | {d['version']} | {'yes' if d['compute'] else 'no'} |" for name, d in drivers.items()]
    pixels = table("Largest error of rays' places against the reference, px:", drivers, lambda _, row: position(row))
    against = folder / ORDER[0]
    pictures = table(f"Largest difference of a colour to the picture of {ORDER[0]}, of 255:", drivers,
                     lambda name, row: difference(program, picture_of(folder / name, row["scene"]), picture_of(against, row["scene"])))
    times = table("Processor milliseconds a frame of 320x180, of all threads (*: of the first picture, with all that is made for it):", drivers,
                  lambda _, row: f"{row['frame_core_ms']:.0f}" + ("*" if row["frame_ms"] == row["first_ms"] else ""))
    return "\n\n".join(["\n".join(what), pixels, pictures, times])


def main():
    program, folder, page = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    text = page.read_text()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    part = page.with_suffix(".part")
    part.write_text(f"{text[:begin]}\n\n{tables(program, folder)}\n\n{text[end:]}")
    os.replace(part, page)


if __name__ == "__main__":
    main()
