#!/usr/bin/env python3
"""Closes the viewer's window at moments of its start, and finds that the process ends at once.

Usage: close_while_starting.py VIEWER

What the process still does is stated in its own processor time after the close, divided by the machine's slowness (tests/machine.py);
the time on the wall is printed. The moments are stages of the start, told by the processor time that the process has spent: the same
on busy machines. Other ones in each run: NULLSCOPE_SEED=n repeats those of a run that printed n. With all tests there are more of them.

Exit status 0: all ended; 1: one did not; 77: Xvfb or xdotool is missing.
"""
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from viewer_process import EVERYTHING, HUNG_S, Log, dice, slowness, spent_s
from x_screen import Screen, WindowCloser, missing_tools, wait_until

MOMENTS = 30 if "NULLSCOPE_EVERYTHING" in os.environ else 4 if EVERYTHING else 2   # of each scene
# Processor time from the close to the end: what is promised, 0.3 s, on two cores. Before its first look at events the
# window's thread makes its context and its first frame, some 0.2 s; the painter's threads go on beside it meanwhile.
BOUND_S = 2 * 0.3
# Until here: torus has its whole picture after some 6 s of processor time, accretion after some 1.7 s.
LATEST_S = {"torus": 5.0, "accretion": 2.0}


def close_at(program, scene, moment_s, screen, folder):
    """(exit status, processor time from the close to the end, wall time of the same, what was on the screen)."""
    env = {**os.environ, "DISPLAY": screen.display}
    log = Log(folder / "turns.txt")
    log.path.unlink(missing_ok=True)
    process = subprocess.Popen([program, scene, "--size", "1280x720", "--turns", log.path], cwd=folder, env=env)
    closer = WindowCloser(screen.display)
    try:
        find = ["xdotool", "search", "--onlyvisible", "--name", "nullscope"]
        found = lambda: subprocess.run(find, env=env, capture_output=True, text=True).stdout.split()
        window = wait_until("the window", found, HUNG_S, 0.005)
        rests = lambda: any(word == "rest" for word, _ in log.since())   # it may be done before the moment comes
        wait_until("the moment", lambda: spent_s(process.pid) >= moment_s or rests(), HUNG_S, 0.002)
        before, begun = spent_s(process.pid), time.monotonic()
        closer.close(int(window[0]))
        _, status, usage = os.wait4(process.pid, 0)     # a hang ends with the test's own time limit
        process.returncode = os.waitstatus_to_exitcode(status)
        after = usage.ru_utime + usage.ru_stime - before
        shown = [values["picture"] for word, values in log.since() if word == "turn"][-1:]
        return process.returncode, after, time.monotonic() - begun, shown[0] if shown else "no frame"
    finally:
        closer.leave()
        if process.returncode is None:
            process.kill()
            process.wait()


def main():
    if missing_tools():
        return 77
    program, good = str(Path(sys.argv[1]).resolve()), True
    os.environ.update(LIBGL_ALWAYS_SOFTWARE="1", MESA_SHADER_CACHE_DISABLE="true")
    chance = dice()
    screen, folder = Screen(1300, 740), Path(tempfile.mkdtemp(prefix="nullscope-close."))
    os.environ.update(XDG_CONFIG_HOME=str(folder), XDG_STATE_HOME=str(folder))
    try:
        for scene, latest_s in LATEST_S.items():
            # One in each part of the start, the first as soon as there is a window.
            for i in range(MOMENTS):
                moment_s = latest_s * (i + chance.random()) / MOMENTS if i > 0 else 0.0
                status, cpu, wall, shown = close_at(program, scene, moment_s, screen, folder)
                if cpu > BOUND_S:
                    cpu /= slowness()
                ended = status == 0 and cpu <= BOUND_S
                good = good and ended
                print(f"{'passed' if ended else 'FAILED'} {scene} closed after {moment_s:.2f} s of processor time "
                      f"({shown}): status {status}, {cpu:.2f} s of it to the end (divided by the slowness where it is long), {wall:.2f} s by the clock", flush=True)
    finally:
        screen.close()
        shutil.rmtree(folder, ignore_errors=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
