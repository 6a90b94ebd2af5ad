"""A headless Chromium, driven through the DevTools protocol over a pipe, and a server of the page's folder. Nothing but Python's library."""
import base64
import functools
import http.server
import itertools
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from machine import spent_with_children_s  # noqa: E402

PROGRAMS = ["chromium-headless-shell", "chromium"]
DRIVERS = {
    "swiftshader": ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    "llvmpipe": ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"],
}


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class Server:
    """Serves a folder on a free port of this machine; counts the bytes of files that were asked for. spoiled: paths that come as other bytes."""

    def __init__(self, folder):
        self.sent, self.spoiled = {}, set()
        server = self

        class Counting(Quiet):
            def end_headers(self):
                if self.path in server.spoiled:
                    self.send_header("Cache-Control", "no-store")
                super().end_headers()

            def copyfile(self, source, to):
                data = source.read()
                if self.path in server.spoiled:
                    data = b"?" * len(data)
                server.sent[self.path] = len(data)
                to.write(data)

        handler = functools.partial(Counting, directory=str(folder))
        self.http = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=self.http.serve_forever, daemon=True).start()
        self.url = f"http://127.0.0.1:{self.http.server_port}/"

    def close(self):
        self.http.shutdown()


class PageError(Exception):
    pass


class Browser:
    def __init__(self, driver="swiftshader", width=640, height=360, options=()):
        program = next((p for p in map(shutil.which, PROGRAMS) if p), None)
        if program is None:
            raise PageError("no Chromium here: scripts/install-packages.sh --web")
        self.profile = tempfile.mkdtemp(prefix="nullscope-web.")
        to_read, self.to = os.pipe()
        self.source, to_write = os.pipe()

        def pipes():  # the protocol's: Chromium reads from 3 and writes to 4
            os.dup2(to_read, 103)
            os.dup2(to_write, 104)
            os.dup2(103, 3)
            os.dup2(104, 4)

        self.process = subprocess.Popen(
            [program, "--remote-debugging-pipe", "--no-sandbox", "--hide-scrollbars", "--mute-audio",
             f"--user-data-dir={self.profile}", f"--window-size={width},{height}", *DRIVERS[driver], *options, "about:blank"],
            preexec_fn=pipes, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        self.numbers = itertools.count(1)
        self.answers, self.events, self.console = {}, [], []
        self.news = threading.Condition()
        threading.Thread(target=self._listen, daemon=True).start()
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.page(f"{domain}.enable")
        self.resize(width, height)

    def _listen(self):
        left = b""
        while True:
            data = os.read(self.source, 1 << 20)
            if not data:
                break
            *whole, left = (left + data).split(b"\0")
            with self.news:
                for text in whole:
                    message = json.loads(text)
                    if "id" in message:
                        self.answers[message["id"]] = message
                    else:
                        self._note(message)
                self.news.notify_all()
        with self.news:
            self.answers = None
            self.news.notify_all()

    def _note(self, message):
        what, params = message["method"], message.get("params", {})
        if what == "Runtime.consoleAPICalled":
            self.console.append(" ".join(str(a.get("value", a.get("description", ""))) for a in params["args"]))
        elif what == "Runtime.exceptionThrown":
            details = params["exceptionDetails"]
            self.console.append("exception: " + details.get("exception", {}).get("description", details["text"]))
        elif what == "Log.entryAdded":
            self.console.append(f"{params['entry']['level']}: {params['entry']['text']} {params['entry'].get('url', '')}")
        self.events.append(message)

    def call(self, method, session=None, timeout_s=120, **params):
        number = next(self.numbers)
        message = {"id": number, "method": method, "params": params}
        if session:
            message["sessionId"] = session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        with self.news:
            if not self.news.wait_for(lambda: self.answers is None or number in self.answers, timeout_s):
                raise PageError(f"{method}: no answer in {timeout_s} s; console: {self.console[-5:]}")
            if self.answers is None:
                raise PageError(f"{method}: the browser has ended")
            answer = self.answers.pop(number)
        if "error" in answer:
            raise PageError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def page(self, method, **params):
        return self.call(method, session=self.session, **params)

    def open(self, url):
        self.page("Page.navigate", url=url)

    def resize(self, width, height, phone=False):
        self.page("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=phone)
        if phone:
            self.page("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=5)

    def run(self, script, timeout_s=120):
        """The value of an expression, awaited."""
        result = self.page("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True, timeout_s=timeout_s)
        if "exceptionDetails" in result:
            details = result["exceptionDetails"]
            raise PageError(details.get("exception", {}).get("description", details["text"]))
        return result["result"].get("value")

    def wait(self, condition, timeout_s=60):
        """Until an expression is true."""
        end = time.monotonic() + timeout_s
        while True:
            try:
                if self.run(condition):
                    return
            except PageError as error:
                if "context" not in str(error):  # of a page that is being loaded
                    raise
            if time.monotonic() > end:
                raise PageError(f"not within {timeout_s} s: {condition}; console: {self.console[-5:]}")
            time.sleep(0.02)

    def screenshot(self):
        """PNG."""
        return base64.b64decode(self.page("Page.captureScreenshot", format="png")["data"])

    def mouse(self, kind, x, y, button="none", buttons=0, **more):
        self.page("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, buttons=buttons, **more)

    def drag(self, path, button="left"):
        """path: [(x, y), ...]"""
        held = {"left": 1, "right": 2, "middle": 4}[button]
        self.mouse("mouseMoved", *path[0])
        self.mouse("mousePressed", *path[0], button=button, buttons=held, clickCount=1)
        for at in path[1:]:
            self.mouse("mouseMoved", *at, button=button, buttons=held)
        self.mouse("mouseReleased", *path[-1], button=button, clickCount=1)

    def touch(self, kind, points):
        """kind: touchStart, touchMove, touchEnd; points: [(x, y), ...] that are down."""
        self.page("Input.dispatchTouchEvent", type=kind,
                  touchPoints=[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)])

    def key(self, code, down=True, **more):
        """code: as KeyboardEvent.code has it, "KeyW"."""
        name = code.removeprefix("Key").lower() if code.startswith("Key") else code
        self.page("Input.dispatchKeyEvent", type="keyDown" if down else "keyUp", code=code, key=more.pop("key", name), **more)

    def spent_s(self):
        """Processor time of the browser's processes so far, s."""
        return spent_with_children_s(self.process.pid)

    def close(self):
        try:
            self.call("Browser.close", timeout_s=10)
        except (PageError, OSError):
            pass
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        for end in (self.to, self.source):
            try:
                os.close(end)
            except OSError:
                pass
        shutil.rmtree(self.profile, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
