"""Firefox and WebKitGTK, which is Safari's engine, driven as browser.py drives Chromium: open, run, wait. Nothing but Python's library, an X server
without a screen (Xvfb), and the packages firefox-esr and webkit2gtk-driver."""
import contextlib
import glob
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

from browser import PageError

START_S = 60
# The value of an expression, awaited; or what it threw.
AWAITED = """const done = arguments[arguments.length - 1];
(async () => (%s))().then((value) => done([value ?? null, null]), (error) => done([null, String(error?.message ?? error)]));"""


def free_port():
    with contextlib.closing(socket.socket()) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Screen:
    """An X server of this test's own."""

    def __init__(self, width=1280, height=800):
        to_read, to_write = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(to_write), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp"],
            pass_fds=[to_write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_write)
        with os.fdopen(to_read) as numbers:
            self.name = ":" + numbers.readline().strip()
        if self.name == ":":
            raise PageError("Xvfb did not start")

    def close(self):
        self.process.terminate()
        self.process.wait()


class Driven:
    """What both have: a screen, a folder for the profile, processes that end with it."""

    def begin(self):
        self.screen = Screen()
        self.profile = tempfile.mkdtemp(prefix="nullscope-web.")
        self.environment = {**os.environ, "DISPLAY": self.screen.name, "HOME": self.profile, "LIBGL_ALWAYS_SOFTWARE": "1"}
        self.environment.pop("WAYLAND_DISPLAY", None)

    def program(self, *command, **more):
        self.process = subprocess.Popen(command, env={**self.environment, **more}, start_new_session=True,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def patiently(self, what, do):
        end = time.monotonic() + START_S
        while True:
            try:
                return do()
            except OSError as error:
                if self.process.poll() is not None or time.monotonic() > end:
                    raise PageError(f"{what} does not answer: {error}") from error
                time.sleep(0.05)

    def run(self, script, timeout_s=120):
        """The value of an expression, awaited."""
        value, error = self.run_awaited(AWAITED % script.strip(), timeout_s)
        if error is not None:
            raise PageError(error)
        return value

    def wait(self, condition, timeout_s=60):
        """Until an expression is true."""
        end = time.monotonic() + timeout_s
        while not self.run(condition):
            if time.monotonic() > end:
                raise PageError(f"not within {timeout_s} s: {condition}")
            time.sleep(0.05)

    def drag(self, path):
        """With the left button; path: [(x, y), ...], px of the window."""
        moves = [{"type": "pointerMove", "x": round(x), "y": round(y), "duration": 30, "origin": "viewport"} for x, y in path]
        self.act({"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"},
                  "actions": [moves[0], {"type": "pointerDown", "button": 0}, *moves[1:], {"type": "pointerUp", "button": 0}]})

    def click(self, x, y):
        self.drag([(x, y)])

    def turn_wheel(self, x, y, down):
        self.act({"type": "wheel", "id": "wheel",
                  "actions": [{"type": "scroll", "x": round(x), "y": round(y), "deltaX": 0, "deltaY": down, "origin": "viewport"}]})

    def hold(self, key):
        """Until let_go(); key: what it types."""
        self.act({"type": "key", "id": "keys", "actions": [{"type": "keyDown", "value": key}]})

    def let_go(self, key):
        self.act({"type": "key", "id": "keys", "actions": [{"type": "keyUp", "value": key}]})

    def close(self):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        self.screen.close()
        shutil.rmtree(self.profile, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


class WebKit(Driven):
    """By WebDriver: a request a command, https://www.w3.org/TR/webdriver2/."""
    NAME = "WebKitGTK"

    def __init__(self):
        driver = shutil.which("WebKitWebDriver")
        browsers = glob.glob("/usr/lib/*/webkit2gtk-4.*/MiniBrowser")
        if driver is None or not browsers:
            raise PageError("no WebKitGTK here: scripts/install-packages.sh --web")
        self.begin()
        self.url = f"http://127.0.0.1:{free_port()}"
        self.program(driver, f"--port={self.url.rpartition(':')[2]}", "--host=127.0.0.1")
        options = {"binary": browsers[0], "args": ["--automation"]}
        self.patiently("WebKitWebDriver", lambda: self.ask("GET", "/status"))
        answer = self.ask("POST", "/session", {"capabilities": {"alwaysMatch": {"webkitgtk:browserOptions": options}}})
        self.url += f"/session/{answer['sessionId']}"
        self.ask("POST", "/timeouts", {"script": 600_000, "pageLoad": 60_000})

    def ask(self, method, path, values=None, timeout_s=120):
        request = urllib.request.Request(self.url + path, method=method, headers={"Content-Type": "application/json"},
                                         data=None if method == "GET" else json.dumps(values or {}).encode())
        try:
            with urllib.request.urlopen(request, timeout=timeout_s) as response:
                return json.load(response)["value"]
        except urllib.error.HTTPError as error:
            raise PageError(json.load(error)["value"].get("message", str(error))) from error
        except TimeoutError as error:
            raise PageError(f"{path}: no answer in {timeout_s} s") from error

    def open(self, url):
        self.ask("POST", "/url", {"url": url})

    def act(self, *sources):
        self.ask("POST", "/actions", {"actions": sources})

    def run_awaited(self, script, timeout_s):
        return self.ask("POST", "/execute/async", {"script": script, "args": []}, timeout_s)

    def close(self):
        with contextlib.suppress(PageError, OSError):
            self.ask("DELETE", "", timeout_s=10)
        super().close()


class Firefox(Driven):
    """By Marionette, the protocol that Firefox itself speaks: [0, number, command, values] behind its length."""
    NAME = "Firefox"

    def __init__(self):
        program = shutil.which("firefox-esr") or shutil.which("firefox")
        if program is None:
            raise PageError("no Firefox here: scripts/install-packages.sh --web")
        self.begin()
        port = free_port()
        settings = {"marionette.port": port, "webgl.force-enabled": True, "webgl.disabled": False, "gfx.webrender.software": True,
                    "datareporting.policy.dataSubmissionEnabled": False, "browser.shell.checkDefaultBrowser": False, "app.update.enabled": False}
        lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in settings.items()]
        pathlib.Path(self.profile, "user.js").write_text("\n".join(lines))
        self.program(program, "--marionette", "--no-remote", "--profile", self.profile, "about:blank")
        self.last, self.left = 0, b""
        self.socket = self.patiently("Firefox", lambda: socket.create_connection(("127.0.0.1", port)))
        self.socket.settimeout(START_S)
        self.message()   # says what it speaks
        self.ask("WebDriver:NewSession", {"capabilities": {"alwaysMatch": {}}})
        self.ask("WebDriver:SetTimeouts", {"script": 600_000, "pageLoad": 60_000})

    def message(self):
        while b":" not in self.left or len(self.left) < self.length():
            data = self.socket.recv(1 << 20)
            if not data:
                raise PageError("Firefox has ended")
            self.left += data
        end = self.length()
        text, self.left = self.left[self.left.index(b":") + 1:end], self.left[end:]
        return json.loads(text)

    def length(self):
        at = self.left.index(b":")
        return at + 1 + int(self.left[:at])

    def ask(self, command, values, timeout_s=120):
        self.last += 1
        text = json.dumps([0, self.last, command, values]).encode()
        self.socket.settimeout(timeout_s)
        try:
            self.socket.sendall(b"%d:%s" % (len(text), text))
            _, _, error, result = self.message()
        except TimeoutError as error:
            raise PageError(f"{command}: no answer in {timeout_s} s") from error
        if error is not None:
            raise PageError(error["message"])
        return result

    def open(self, url):
        self.ask("WebDriver:Navigate", {"url": url})

    def act(self, *sources):
        self.ask("WebDriver:PerformActions", {"actions": sources})

    def run_awaited(self, script, timeout_s):
        return self.ask("WebDriver:ExecuteAsyncScript", {"script": script, "args": [], "newSandbox": False, "sandbox": None}, timeout_s)["value"]

    def close(self):
        self.socket.close()
        super().close()
