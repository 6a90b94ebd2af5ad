#!/usr/bin/env bash
# WebKitGTK 2.50.6 (Debian 12), WebGL without a canvas element of the page: in workers, and by OffscreenCanvas.
#
# Guessed: OffscreenCanvas and WebGL2RenderingContext are there, in workers too, and transferControlToOffscreen() succeeds; so
#   getContext("webgl2") gives a context, as in Safari since 17, Chromium and Firefox.
# Seen: null, without an error, for "webgl" and "webgl2", in the page and in a worker, for a new OffscreenCanvas and for a transferred one.
#   "2d" is there. A canvas element has both.
# A test for the names of classes does not tell; and a canvas whose control was transferred is lost for the page: who tries the worker first needs
# another canvas behind it.
#
# Needs webkit2gtk-driver, xvfb, xauth, python3-venv.
# Exit status: 0 as described, 1 something has changed, 2 no WebKitGTK.
set -euo pipefail
browser=$(compgen -G '/usr/lib/*/webkit2gtk-4.*/MiniBrowser' | head -n 1) && command -v WebKitWebDriver >/dev/null || { echo "no WebKitGTK here" >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet selenium==4.27.1
export HOME=$folder LIBGL_ALWAYS_SOFTWARE=1
xvfb-run -a "$folder/venv/bin/python" - "$browser" <<'PYTHON'
import socket
import subprocess
import sys
import time

from selenium import webdriver

TRIAL = """
const done = arguments[0], names = ["2d", "webgl", "webgl2"];
const found = (canvas) => names.filter((name) => canvas().getContext(name) !== null);
const script = `const names = ${JSON.stringify(names)};
    postMessage([typeof WebGL2RenderingContext, ...names.filter((name) => new OffscreenCanvas(8, 8).getContext(name) !== null)]);`;
const worker = new Worker(URL.createObjectURL(new Blob([script])));
worker.onmessage = ({ data: [type, ...there] }) => done({
    classes: [typeof OffscreenCanvas, typeof WebGL2RenderingContext, type],
    element: found(() => document.createElement("canvas")), offscreen: found(() => new OffscreenCanvas(8, 8)),
    transferred: found(() => document.createElement("canvas").transferControlToOffscreen()), worker: there });
"""
EXPECTED = {"classes": 3 * ["function"], "element": ["2d", "webgl", "webgl2"], "offscreen": ["2d"], "transferred": ["2d"], "worker": ["2d"]}
options = webdriver.WebKitGTKOptions()
options.binary_location = sys.argv[1]
options.add_argument("--automation")
with socket.socket() as free:
    free.bind(("127.0.0.1", 0))
    port = free.getsockname()[1]
server = subprocess.Popen(["WebKitWebDriver", f"--port={port}"])
try:
    while socket.socket().connect_ex(("127.0.0.1", port)) != 0:
        time.sleep(0.1)
    with webdriver.Remote(f"http://127.0.0.1:{port}", options=options) as driver:
        driver.get("about:blank")
        driver.set_script_timeout(60)
        found = driver.execute_async_script(TRIAL)
        print(driver.capabilities["browserName"], driver.capabilities["browserVersion"], found)
finally:
    server.terminate()
sys.exit(0 if found == EXPECTED else "changed")
PYTHON
