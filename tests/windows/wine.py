"""The programs that scripts/windows.sh builds, under Wine on a screen of its own: what the tests of this folder share."""
import atexit
import fcntl
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "build/windows"
PROGRAM, VIEWER, LIBRARY = (FOLDER / "build/bin" / name for name in ("nullscope.exe", "nullscope-viewer.exe", "nullscope-programs.dll"))
COMPILER = "x86_64-w64-mingw32-g++-posix"
SKIPPED = 77   # ctest's SKIP_RETURN_CODE

sys.path[:0] = [str(ROOT / "tests" / folder) for folder in ("cli", "viewer")]

import x_screen  # noqa: E402

# Of what Windows 10 brings. msvcrt.dll: its C library of before 2015.
SYSTEM = {f"{name}.dll" for name in ("kernel32", "msvcrt", "user32", "gdi32", "opengl32", "bcrypt", "advapi32", "shell32", "ole32", "ws2_32", "imm32",
                                     "psapi", "comdlg32")}


def leave_if_missing(*programs):
    """Ends with the status of a skipped test, and says why, where nothing can be tested."""
    reason = next((f"there is no {program.relative_to(ROOT)}: scripts/windows.sh makes it" for program in (*programs, LIBRARY) if not program.is_file()), None) or \
        next((f"{tool} is not installed" for tool in ("wine", "Xvfb", "xdotool", "x86_64-w64-mingw32-objdump", COMPILER) if shutil.which(tool) is None), None)
    if reason:
        print(f"left out: {reason}")
        sys.exit(SKIPPED)


def screen_for_wine(width=1280, height=800):
    """An X server of this test's own, which Wine's windows use, those too that are never shown."""
    # One server of Wine serves all programs of a prefix, those of another test's screen too, and the first test's end would be its end.
    alone = open(FOLDER / "wine.lock", "w")
    try:
        fcntl.flock(alone, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        print("another test uses Wine: waiting for its end", flush=True)
        fcntl.flock(alone, fcntl.LOCK_EX)
    screen = x_screen.Screen(width, height)
    os.environ.update(DISPLAY=screen.display, LIBGL_ALWAYS_SOFTWARE="1", WINEDEBUG="-all", WINEPREFIX=str(FOLDER / "wine"))
    os.environ.pop("WAYLAND_DISPLAY", None)
    # By its character set Wine reads the names of files here; in that of C it finds none with other letters than English has.
    os.environ.update(LC_ALL="C.UTF-8")
    subprocess.run(["wine", "wineboot", "--init"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=600, check=True)

    def close():
        subprocess.run(["wineserver", "--kill"], check=False) if shutil.which("wineserver") else None
        screen.close()
        alone.close()
    atexit.register(close)
    return screen


def imports_of(program):
    """Names of the libraries that Windows loads with it."""
    said = subprocess.run(["x86_64-w64-mingw32-objdump", "-p", str(program)], capture_output=True, text=True, check=True).stdout
    return {name.lower() for name in re.findall(r"DLL Name: (\S+)", said)}


def foreign_imports(program):
    """Of a program and the library beside it: what neither that library nor the system is; how many libraries of the system it needs."""
    names = imports_of(program)
    assert LIBRARY.name in names and "kernel32.dll" in names, f"{program.name} imports {sorted(names)}"
    names = names - {LIBRARY.name} | imports_of(LIBRARY)
    return names - SYSTEM, len(names)


class Table:
    """What was checked, a line each, printed as it comes: a run that is cut off has said what it found."""

    def row(self, what, measured, bound):
        print(f"{what:46}  {measured}{'  (' + bound + ')' if bound else ''}", flush=True)
