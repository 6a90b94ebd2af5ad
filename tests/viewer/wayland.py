#!/usr/bin/env python3
"""The viewer as a client of Wayland, on screens of usual and of double density: it is whole, drawn in the screen's own pixels, and obeys hands.

Usage: wayland.py VIEWER

The compositor is weston in a window of an Xvfb, where xdotool's mouse and keys are its own; the window is as large as its screen, which it puts at
the corner then. GLFW before 3.4 is one library for X11 and another for Wayland: the latter is fetched by apt where it is not installed, and used by this test alone.

By hand, in no tier: in two of three runs the compositor hands on the first wheel or key not at all, and the test waits. Exit status 0: all is so; 1: it is
not; 77: something is missing, which is printed.
"""
import glob
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from viewer_process import CHANGED, HUNG_S, SCENE, Log
from x_screen import Screen, missing_tools, wait_until

SIZE = (840, 600)   # of screen and window, in units of the window system
PLACE = (320, 360, 820, 560)   # of the screen: the picture, without panels


def glfw_folder(folder):
    """Of a libglfw that speaks Wayland; "" where the installed one does, None where there is none."""
    installed = glob.glob("/usr/lib/*/libglfw.so.3")
    if installed and b"wl_display_connect" in Path(installed[0]).read_bytes():
        return ""
    fetched = subprocess.run("apt-get download -qq libglfw3-wayland && dpkg -x libglfw3-wayland_*.deb .", shell=True, cwd=folder,
                             capture_output=True, text=True)
    found = glob.glob(f"{folder}/usr/lib/*/libglfw.so.3")
    return str(Path(found[0]).parent) if fetched.returncode == 0 and found else None


class Weston:
    def __init__(self, scale, folder):
        self.screen = Screen(scale * SIZE[0], scale * SIZE[1])
        self.folder = Path(folder) / f"weston{scale}"
        self.folder.mkdir(mode=0o700)
        self.environment = {**os.environ, "XDG_RUNTIME_DIR": str(self.folder), "WAYLAND_DISPLAY": "wayland-test"}
        config = self.folder / "weston.ini"
        config.write_text("[shell]\npanel-position=none\n")   # a click on it starts a terminal, before the viewer
        self.server = subprocess.Popen(
            ["weston", "--backend=x11-backend.so", "--use-pixman", f"--config={config}", f"--scale={scale}",
             f"--width={SIZE[0]}", f"--height={SIZE[1]}", "--socket=wayland-test", "--idle-time=0"],
            env={**self.environment, "DISPLAY": self.screen.display}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_until("weston", (self.folder / "wayland-test").exists, HUNG_S)
        del self.environment["WAYLAND_DISPLAY"]

    def client(self, program, scene, glfw):
        paths = {"LD_LIBRARY_PATH": f"{glfw}:{os.environ.get('LD_LIBRARY_PATH', '')}"} if glfw else {}
        environment = {**self.environment, "WAYLAND_DISPLAY": "wayland-test", "XDG_CONFIG_HOME": str(self.folder),
                       "XDG_STATE_HOME": str(self.folder), **paths}
        environment.pop("DISPLAY", None)
        (self.folder / "nullscope").mkdir()
        (self.folder / "nullscope/viewer.toml").write_text("hints_seen = true\n")
        self.log = Log(self.folder / "turns.txt")
        return subprocess.Popen([program, scene, "--size", "%dx%d" % SIZE, "--turns", self.log.path], env=environment, stderr=subprocess.PIPE, text=True)

    def close(self):
        self.server.terminate()
        self.server.wait()
        self.screen.close()


def tried(program, scale, folder, glfw):
    scene = Path(folder) / "scene.toml"
    scene.write_text(SCENE)
    weston = Weston(scale, folder)
    viewer = weston.client(program, scene, glfw)

    def at_rest(since=0):
        def rests():
            assert viewer.poll() is None, f"the viewer ended: {viewer.stderr.read()}"
            return (weston.log.since(since) or [("", {})])[-1][0] == "rest"
        wait_until("the viewer comes to rest", rests, HUNG_S)
        return weston.screen.picture(*(scale * x for x in PLACE))

    def after(what, *words):
        since, before = weston.log.size(), at_rest()
        weston.screen.hands(*words)
        wait_until(what, lambda: weston.log.size() > since and at_rest(since).changed(before, CHANGED), HUNG_S)
    try:
        at_rest()
        time.sleep(1.0)   # weston shows it
        size = weston.log.turns()[-1]["size"]
        assert size == f"{scale * SIZE[0]}x{scale * SIZE[1]}", f"the picture has {size}"
        x, y = scale * 500, scale * 450
        after("a drag turns the view", "mousemove", x, y, "mousedown", 1, "sleep", 0.3, "mousemove", x + scale * 60, y, "sleep", 0.3, "mouseup", 1)
        after("the wheel moves the camera", "click", 4, "sleep", 0.3, "click", 4)
        after("a key flies", "keydown", "w", "sleep", 0.5, "keyup", "w")
        weston.screen.hands("key", "ctrl+q")
        status = viewer.wait(HUNG_S)
        assert status == 0, f"it ended with {status}: {viewer.stderr.read()}"
        print(f"density {scale}: a picture of {size}; drag, wheel, keys, end")
    finally:
        if viewer.poll() is None:
            viewer.kill()
        viewer.communicate()
        weston.close()


def main():
    if missing_tools():
        return 77
    if shutil.which("weston") is None:
        print("skipped: weston not installed")
        return 77
    os.environ["LIBGL_ALWAYS_SOFTWARE"] = "1"
    with tempfile.TemporaryDirectory(prefix="nullscope-wayland.") as folder:
        glfw = glfw_folder(folder)
        if glfw is None:
            print("skipped: this GLFW speaks X11 alone, and apt has no libglfw3-wayland")
            return 77
        for scale in 1, 2:
            tried(os.path.abspath(sys.argv[1]), scale, folder, glfw)
    return 0


if __name__ == "__main__":
    sys.exit(main())
