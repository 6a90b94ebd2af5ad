#!/usr/bin/env bash
# WebKitGTK 2.50.6 (Debian 12): what a page can know of device and browser, by WEBGL_debug_renderer_info and navigator.userAgent.
#
# Guessed: UNMASKED_RENDERER_WEBGL names the driver (llvmpipe) as in Chromium, or a class of devices as in Firefox ("llvmpipe, or similar"), and
#   "Version/" in the user agent is Safari's version whose WebKit this is.
# Seen: renderer "Apple GPU", vendor "Apple Inc.", on Linux, on llvmpipe, with the extension offered and asked for; "Version/60.5", while
#   Safari's own versions are 26 and lower; "AppleWebKit/605.1.15", the same for years. navigator.platform does say Linux.
# A protocol of measurements that takes these words is wrong about the device: on WebKit say that it is not known.
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
const gl = document.createElement("canvas").getContext("webgl2"), info = gl.getExtension("WEBGL_debug_renderer_info");
arguments[0]([gl.getParameter(info.UNMASKED_RENDERER_WEBGL), gl.getParameter(info.UNMASKED_VENDOR_WEBGL),
    navigator.userAgent.match(/Version.[0-9.]+/)[0], navigator.userAgent.match(/AppleWebKit.[0-9.]+/)[0], navigator.platform]);
"""
EXPECTED = ["Apple GPU", "Apple Inc.", "Version/60.5", "AppleWebKit/605.1.15", "Linux x86_64"]
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
