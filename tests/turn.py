#!/usr/bin/env python3
"""The turns of continuous integration: the quick tier, and at depth all an eighth of what scripts/test.sh --all measures beyond it.

Usage: turn.py            the list for NULLSCOPE_TESTS of this turn (support/depth.h): the rows of turns.csv with its number, and those
                          whose code the change touches
       turn.py --base     the commit that the change is measured from
       turn.py --list     what each turn adds, with its base seconds
       turn.py --check    whether every test file with a depth is in turns.csv, once, and the turns are of one size
       turn.py --self-test

The turn is the number in .ci/turn (or NULLSCOPE_TURN), which every submission advances by one: eight in a row run everything. The
change is what differs from the commit that set the number before.
"""
import csv
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TESTS = Path(__file__).resolve().parent
ROOT = TESTS.parent
TURNS = 8
# Base seconds that touched code may add to a turn: what is beyond it waits for its turn, and is named. A change of everything would
# otherwise run everything.
MOST_TOUCHED = 60
PAGE = 300             # what building the page for browsers takes; a row of web/test_answers.py and web/test_browsers.py has it
UNEVEN = 1.15          # the largest turn over the mean: the limit of a turn is set for the largest
DEPTH = re.compile(r"\b(by_depth|costly|Selection|on_every_context|tries)\b|\bdepth\(\)|\bQUICK\b")


def number():
    text = os.environ.get("NULLSCOPE_TURN") or (ROOT / ".ci/turn").read_text(encoding="utf-8")
    return int(text)


def read_rows(file=TESTS / "turns.csv"):
    with open(file, encoding="utf-8") as lines:
        return [{"turn": int(row["turn"]), "what": row["what"], "seconds": float(row["base_seconds"]), "code": row["code"].split()}
                for row in csv.DictReader(line for line in lines if not line.startswith("#"))]


def git(*words):
    return subprocess.run(["git", "-c", "safe.directory=*", "-C", ROOT, *words], capture_output=True, text=True, check=True).stdout.split("\n")


def base():
    """The commit before the one that set the turn, which is the first of a change; or nothing where git does not say."""
    try:
        set_by = git("log", "--first-parent", "--format=%H", "-1", "--", ".ci/turn")[0]
        return git("rev-parse", f"{set_by}^")[0]
    except (OSError, IndexError, subprocess.CalledProcessError):
        return None


def changed():
    before = base()
    return [] if before is None else [line for line in git("diff", "--name-only", before) if line]


def chosen(rows, turn, files):
    """The turn's rows, those that the files touch as far as MOST_TOUCHED goes, and the touched ones left to their turns."""
    own = [row for row in rows if row["turn"] == turn % TURNS]
    touched = [row for row in rows if row not in own and any(file == f"tests/{row['what']}" or file.startswith(tuple(row["code"]))
                                                            for file in files)]
    # Tests of the page have it built, which the turn's own may have asked for.
    page = 0 if any(row["what"].startswith("web/") for row in own) else PAGE
    more, left, sum_s = [], [], 0.0
    for row in sorted(touched, key=lambda row: row["seconds"]):
        seconds = row["seconds"] + (page if row["what"].startswith("web/") else 0)
        if sum_s + seconds <= MOST_TOUCHED:
            sum_s += seconds
            more.append(row)
        else:
            left.append(row)
    return own, more, left


def check(rows, tests=TESTS):
    wrong = []
    names = [row["what"] for row in rows]
    wrong += [f"{name}: in turns.csv twice" for name in sorted({name for name in names if names.count(name) > 1})]
    wrong += [f"{name}: no such file" for name in names if not name.startswith("check/") and not (tests / name).exists()]
    wrong += [f"{row['what']}: turn {row['turn']}, not 0 to {TURNS - 1}" for row in rows if not 0 <= row["turn"] < TURNS]
    for folder in ("unit", "contract", "gpu", "golden", "proof", "cli", "web"):
        for file in sorted((tests / folder).glob("test_*.*")):
            name = f"{folder}/{file.name}"
            if name not in names and (folder == "web" or DEPTH.search(file.read_text(encoding="utf-8"))):
                wrong.append(f"{name}: has a depth and no row in turns.csv")
    sums = [sum(row["seconds"] for row in rows if row["turn"] == turn) for turn in range(TURNS)]
    if max(sums) > UNEVEN * sum(sums) / TURNS:
        wrong.append(f"turns of {', '.join(f'{s:.0f}' for s in sums)} base seconds: the largest is over {UNEVEN} of the mean")
    return wrong


def self_test():
    rows = [{"turn": i, "what": what, "seconds": s, "code": code.split()} for i, (what, s, code) in enumerate(   # one a turn
        [("unit/test_a.cpp", 10, ""), ("unit/test_b.cpp", 10, ""), ("check/c", 10, "src/c/ x.sh"), ("unit/test_d.cpp", 10, "src/d/")]
        + [(f"check/{i}", 10, "") for i in range(4, TURNS)])]
    names = lambda some: [row["what"] for row in some]
    own, more, left = chosen(rows, TURNS + 1, ["tests/unit/test_a.cpp", "src/c/file.h", "src/dd/file.h"])
    assert (names(own), names(more), left) == (["unit/test_b.cpp"], ["unit/test_a.cpp", "check/c"], []), (own, more, left)
    dear = [*rows, {"turn": 3, "what": "unit/test_e.cpp", "seconds": MOST_TOUCHED + 1.0, "code": ["src/"]}]
    assert names(chosen(dear, 0, ["src/x.h"])[2]) == ["unit/test_e.cpp"]
    page = [*rows, {"turn": 5, "what": "web/test_f.py", "seconds": 1.0, "code": ["web/"]}, {"turn": 6, "what": "web/test_g.py", "seconds": 1.0, "code": []}]
    assert names(chosen(page, 0, ["web/x.js"])[2]) == ["web/test_f.py"], "the page is built for nothing else"
    assert names(chosen(page, 6, ["web/x.js"])[1]) == ["web/test_f.py"], "the page is there"
    assert sorted(name for turn in range(7, 7 + TURNS) for name in names(chosen(rows, turn, [])[0])) == sorted(names(rows)), "turns in a row are all"
    with tempfile.TemporaryDirectory() as folder:
        tests = Path(folder)
        (tests / "unit").mkdir()
        for name in "abd":
            (tests / f"unit/test_{name}.cpp").write_text("int n = by_depth(1, 2, 3);")
        assert check(rows, tests) == [], check(rows, tests)
        (tests / "unit/test_new.cpp").write_text("Selection selection(2);")
        assert len(check(rows, tests)) == 1
        (tests / "unit/test_a.cpp").unlink()
        assert len(check([*rows, rows[1]], tests)) == 4   # no file, twice, new, uneven
    return 0


def main():
    words = sys.argv[1:]
    if words == ["--self-test"]:
        return self_test()
    if words == ["--base"]:
        print(base() or "HEAD")
        return 0
    rows = read_rows()
    if words == ["--check"]:
        wrong = check(rows)
        print("\n".join(wrong) or f"turn: {len(rows)} rows in {TURNS} turns")
        return 1 if wrong else 0
    if words == ["--list"]:
        for turn in range(TURNS):
            own = [row for row in rows if row["turn"] == turn]
            print(f"turns {TURNS} n + {turn}: {sum(row['seconds'] for row in own):.0f} base seconds\n  " + "\n  ".join(row["what"] for row in own))
        return 0
    own, more, left = chosen(rows, number(), changed())
    print(f"turn {number()}: {len(own)} rows of turns.csv; touched by the change since {base() or '(git does not say)'}: "
          f"{' '.join(row['what'] for row in more) or 'none'}"
          + (f"; touched, but left to their turns: {' '.join(row['what'] for row in left)}" if left else ""), file=sys.stderr)
    print(",".join(row["what"] for row in own + more))
    return 0


if __name__ == "__main__":
    sys.exit(main())
