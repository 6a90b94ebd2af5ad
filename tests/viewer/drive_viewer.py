#!/usr/bin/env python3
"""Uses nullscope-viewer as a person would, on a screen of its own, and looks at the pixels.

Usage: drive_viewer.py VIEWER [CASE...]     (VIEWER: the program; CASE: names of test functions without "test_",
                                            or "window": those that share one viewer, or "apart": those that run
                                            their own; without any: all)

No case bounds a time by the clock on the wall, so that they pass on busy machines. NULLSCOPE_EVERYTHING:
longer cases too.
Exit status 0: all passed; 1: some failed; 77: Xvfb or xdotool is missing.
"""
import os
import shutil
import subprocess
import sys
import tempfile
import time
import traceback
from pathlib import Path

import cases_apart
import cases_overlays
import cases_window
import depth
from viewer_process import HEIGHT, UNDER_STARS, WIDTH, Viewer, keep_programs
from x_screen import Screen, missing_tools


def attempt(test, *arguments):
    start = time.monotonic()
    try:
        test(*arguments)
    except (AssertionError, subprocess.SubprocessError, OSError) as error:
        print(f"FAILED {test.__name__}: {error}", flush=True)
        if not isinstance(error, AssertionError):
            traceback.print_exc()
        return False
    print(f"passed {test.__name__} ({time.monotonic() - start:.1f} s)", flush=True)
    return True


def main():
    if missing_tools():
        return 77
    program = str(Path(sys.argv[1]).resolve())
    words = sys.argv[2:] or ["window", "apart"]
    groups = {"window": cases_window.CASES, "apart": cases_apart.CASES + cases_overlays.CASES}
    known = {"window", "apart"} | {t.__name__.removeprefix("test_") for group in groups.values() for t in group}
    if set(words) - known:
        sys.exit(f"no such case (without test_; some need NULLSCOPE_EVERYTHING=1): {' '.join(sorted(set(words) - known))}")
    if "apart" in words:   # each starts a viewer
        groups["apart"] = [test for test in groups["apart"] if not depth.left_to_another_run()]
    chosen = lambda group: [t for t in groups[group] if group in words or t.__name__.removeprefix("test_") in words]
    screen, folder, good = Screen(WIDTH + 100, HEIGHT + 100), Path(tempfile.mkdtemp(prefix="nullscope-drive.")), True
    keep_programs(folder)
    viewers = []
    try:
        if chosen("window"):
            def test_start():
                viewers.append(Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", scene=UNDER_STARS))
                viewers[0].start()
            good = attempt(test_start)
        for test in chosen("window") if good else []:
            good = attempt(test, viewers[0]) and good
        for test in chosen("apart"):
            good = attempt(test, screen, program, folder) and good
    finally:
        for viewer in viewers:
            viewer.kill()
        screen.close()
        shutil.rmtree(folder, ignore_errors=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
