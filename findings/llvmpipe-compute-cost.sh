#!/usr/bin/env bash
# Mesa 22.3.6 (Debian 12), llvmpipe's compute shaders: what barrier() and groups that return at once cost.
#
# Guessed: barrier() costs where it stands, and a group of threads that returns in the shader's first line costs next to nothing; both are so on GPUs.
# Seen: a shader with one barrier(), called once behind its loop or before it, takes 1.4 times the processor time for that loop (what lives in
#   loops stays in memory); the same statements without a loop take 1.1 times at most. Groups that all return at once, on a condition that is the
#   same for all threads, take more than 0.8 times the time of groups that do all the work, unless the work is in a loop.
# Who draws parts of a picture by a compute shader each lists the parts and dispatches the list; threads that only ask their neighbours of a block
# of 2 x 2, which are one vector here, need memoryBarrierShared() alone.
#
# Exit status: 0 as described, 1 something has changed. Needs amd64, and the libraries that Mesa's packages of Debian 12 depend on.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet moderngl==5.12.0 glcontext==3.1.0
cd "$folder"
version=22.3.6-1+deb12u2
apt-get download --quiet=2 {libgl1-mesa-dri,libegl-mesa0,libglapi-mesa,libgbm1}=$version
for package in *.deb; do dpkg -x "$package" mesa; done
libraries=$folder/mesa/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$libraries LIBGL_DRIVERS_PATH=$libraries/dri LIBGL_ALWAYS_SOFTWARE=1 venv/bin/python - <<'PYTHON'
import sys
import time

import moderngl

SIDE, TIMES = 512, 9
STEP = "{ float t = z.x * z.x - z.y * z.y + 0.3 * x.x; z.y = 2.0 * z.x * z.y - 0.2 * x.y; z.x = t; z *= 0.5; z += fract(1.7 * z); }"
WORK = {"a loop": f"for (int i = 0; i < 100; ++i) {STEP}", "no loop": 100 * STEP}
context = moderngl.create_context(standalone=True, backend="egl", require=430)
print(context.info["GL_RENDERER"], context.info["GL_VERSION"])
if "llvmpipe" not in context.info["GL_RENDERER"] or "Mesa 22.3.6" not in context.info["GL_VERSION"]:
    sys.exit("changed: this is not llvmpipe of Mesa 22.3.6")


def shader(first, work, last):
    return context.compute_shader(f"""#version 430
layout(local_size_x = 64) in;
layout(rgba32f, binding = 0) writeonly uniform image2D picture;
uniform int none;
shared float all_of_group[64];
void main() {{
    ivec2 place = 8 * ivec2(gl_WorkGroupID.xy) + ivec2(gl_LocalInvocationIndex % 8u, gl_LocalInvocationIndex / 8u);
    {first}
    vec2 x = (vec2(place) + 0.5) / {SIDE}.0, z = x;
    {work}
    {last}
    imageStore(picture, place, vec4(z, 0.0, 1.0));
}}""")


def cost(program):
    """Processor time of a dispatch, the least of several."""
    texture = context.texture((SIDE, SIDE), 4, dtype="f4")
    texture.bind_to_image(0, read=False, write=True)
    seen = []
    for _ in range(TIMES):
        begun = time.process_time()
        program.run(SIDE // 8, SIDE // 8)
        context.finish()
        seen.append(time.process_time() - begun)
    return min(seen)


HAND_OVER = "all_of_group[gl_LocalInvocationIndex] = {}; barrier(); z.y += 0.0 * all_of_group[gl_LocalInvocationIndex ^ 1u];"
changed = []
for name, work in WORK.items():
    plain = cost(shader("", work, ""))
    behind = cost(shader("", work, HAND_OVER.format("z.x"))) / plain
    before = cost(shader("vec2 y = vec2(0.0); " + HAND_OVER.format("1.0").replace("z.y", "y.y"), work.replace("z.x = t;", "z.x = t + y.y;"), "")) / plain
    fenced = cost(shader("", work, HAND_OVER.format("z.x").replace("barrier()", "memoryBarrierShared()"))) / plain
    returning = shader("if (none == 1) return;", work, "")
    returning["none"] = 1
    back = cost(returning) / plain
    print(f"{name}: {1e3 * plain:.1f} core-ms; a barrier behind {behind:.2f} times, before {before:.2f}, memoryBarrierShared() {fenced:.2f}; all groups return {back:.2f}")
    looped = name == "a loop"
    if looped != (behind > 1.25) or looped != (before > 1.25) or fenced > 1.2:
        changed.append(f"barriers, {name}")
    if looped == (back > 0.8):
        changed.append(f"groups that return, {name}")
sys.exit(f"changed: {', '.join(changed)}" if changed else 0)
PYTHON
