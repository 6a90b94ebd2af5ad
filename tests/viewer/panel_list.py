#!/usr/bin/env python3
"""The viewer's panels, as its --help lists them, are those of the table in docs/viewer.md, each with its key and words.

Usage: panel_list.py VIEWER
"""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCUMENT = ROOT / "docs" / "viewer.md"
KEY = r"(?:Ctrl\+|Shift\+)?(?:[A-Z]|F\d+|Tab)"


def panels(program):
    """(name, keys or "", words) of each."""
    text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    listed = text.split("Panels, of the menus View and Help:\n")[1].split("\n\n")[0]
    return [re.fullmatch(rf"  (\S.*?) {{2,}}(?:({KEY}) +)?(\S.*)", line).groups("") for line in listed.splitlines() if line.strip()]


def documented(text):
    table = text.split("| Panel | Key | What it shows |\n|---|---|---|\n")[1].split("\n\n")[0]
    return [tuple(cell.strip() for cell in line.strip("|").split("|")) for line in table.splitlines()]


def faults(known, told):
    rows = [(name.removesuffix("..."), keys, words) for name, keys, words in known]
    missing = [f"docs/viewer.md has no row | {' | '.join(row)} |" for row in rows if row not in told]
    return missing + [f"docs/viewer.md has a row of no panel: {row}" for row in told if row not in rows]


def forgotten(sources):
    """Rows of files that are not in the list."""
    listed = re.findall(r"&(k\w+Panel),", sources["panel_rows.h"])
    rows = [(name, row) for name, text in sources.items() for row in re.findall(r"^const Panel (k\w+)\{", text, re.M)]
    return [f"{name}: {row} is not in panel_rows.h" for name, row in rows if row not in listed]


def main():
    known, told = panels(sys.argv[1]), documented(DOCUMENT.read_text(encoding="utf-8"))
    keys = [key for _, key, _ in known if key]
    wrong = faults(known, told) + [f"{key}: two panels" for key in {key for key in keys if keys.count(key) > 1}]
    assert len(faults(known, told[1:])) == 1 and len(faults(known[1:], told)) == 1, "a row that is missing is not found"
    sources = {path.name: path.read_text(encoding="utf-8") for path in (ROOT / "src/viewer").iterdir()}
    wrong += forgotten(sources)
    assert forgotten(sources | {"new_panel.cpp": "const Panel kNewPanel{"}) == ["new_panel.cpp: kNewPanel is not in panel_rows.h"], "a row that is forgotten"
    print("\n".join(wrong) or f"{len(known)} panels")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
