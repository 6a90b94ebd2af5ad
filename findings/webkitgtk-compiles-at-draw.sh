#!/usr/bin/env bash
# WebKitGTK 2.50.6 and Mesa 22.3.6's llvmpipe (Debian 12): when a WebGL2 program is compiled where KHR_parallel_shader_compile is offered.
#
# Guessed: what takes long is what COMPLETION_STATUS_KHR tells of. A page that asks for it from time to time, and draws once it is true, runs on.
# Seen: it is true at once, in the task that linked. The first drawArrays() then compiles, and the page stands still for all of it: more than
#   five times as long as compiling, linking and a second draw together. It does so again where the same program is first drawn with blending, and
#   to a texture of half floats.
# Who wants such a page to run on draws one program a task, into the kind of target and with the state that it will have, and lets the page have a
# turn after each; what one of them takes cannot be divided.
#
# Needs webkit2gtk-driver, xvfb, xauth, python3-venv.
# Exit status: 0 as described, 1 something has changed, 2 no WebKitGTK.
set -euo pipefail
browser=$(compgen -G '/usr/lib/*/webkit2gtk-4.*/MiniBrowser' | head -n 1) && command -v WebKitWebDriver >/dev/null || { echo "no WebKitGTK here" >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet selenium==4.27.1
export HOME=$folder LIBGL_ALWAYS_SOFTWARE=1 MESA_SHADER_CACHE_DISABLE=true
xvfb-run -a "$folder/venv/bin/python" - "$browser" <<'PYTHON'
import socket
import subprocess
import sys
import time

from selenium import webdriver

TRIAL = """
const done = arguments[0];
const gl = document.createElement("canvas").getContext("webgl2"), parallel = gl.getExtension("KHR_parallel_shader_compile");
gl.getExtension("EXT_color_buffer_float");
let text = "#version 300 es\\nprecision highp float; uniform vec4 u; out vec4 colour; void main() { vec4 v = u + gl_FragCoord;";
for (let i = 1; i <= 100; ++i)
    text += `{ float s = sin(v.x * ${i}.25) + sqrt(abs(v.y)) / (${i}.0 + v.z * v.z);
               if (s > 0.3) v = v.yzwx * s + exp(-v.w * v.w); else v += pow(abs(v), vec4(0.${i % 9 + 1})) * s; }`;
let last = performance.now(), gap = 0, begun = last;
setInterval(() => { const now = performance.now(); gap = Math.max(gap, now - last); last = now; }, 5);
const lap = () => { const now = performance.now(), ms = Math.round(now - begun); begun = now; return ms; };
const draw = () => { gl.drawArrays(gl.TRIANGLES, 0, 3); gl.readPixels(0, 0, 1, 1, gl.RGBA, half ? gl.FLOAT : gl.UNSIGNED_BYTE, half ? new Float32Array(4) : new Uint8Array(4)); return lap(); };
let half = false;
setTimeout(() => {
    const program = gl.createProgram();
    lap();
    for (const [kind, source] of [[gl.VERTEX_SHADER, "#version 300 es\\nvoid main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0, 1); }"],
                                  [gl.FRAGMENT_SHADER, text + "colour = v; }"]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, source), gl.compileShader(shader), gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    const found = { offered: Boolean(parallel), complete: gl.getProgramParameter(program, parallel.COMPLETION_STATUS_KHR) };
    found.links = gl.getProgramParameter(program, gl.LINK_STATUS), found.linking = lap();
    gl.useProgram(program);
    found.first = draw(), found.second = draw();
    gl.enable(gl.BLEND), gl.blendFunc(gl.ONE, gl.ONE);
    found.blended = draw(), found.again = draw();
    gl.disable(gl.BLEND);
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA16F, 300, 150, 0, gl.RGBA, gl.HALF_FLOAT, null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    half = true;
    found.halves = draw();
    setTimeout(() => done({ ...found, gap: Math.round(gap) }), 100);
}, 300);
"""
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
beside = found["linking"] + found["second"]
slow = min(found["first"], found["blended"], found["halves"])
as_described = found["offered"] and found["complete"] and found["links"] and slow > 5 * beside and found["gap"] > found["first"]
sys.exit(0 if as_described else "changed")
PYTHON
