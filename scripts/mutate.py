#!/usr/bin/env python3
"""Plants deliberate faults, one at a time, and says which test catches each.

    scripts/mutate.py                 all of them, as a Markdown table; some fifteen minutes on two cores
    scripts/mutate.py --list          their names
    scripts/mutate.py NAME...         only these
    --build FOLDER                    the build folder (default build/release), configured before

A fault is a replacement of one piece of text in one file of shaders/ or src/. The file is changed in place, the one program
that holds the test is built and the test is run; then the file is as it was. Files with changes that are not committed are
not touched. Before that, every test has to pass without a fault. Ends with 1 if a fault survives: a test is missing.
"""
import argparse
import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

HARD = ("gpu_tests", "hard cases*")
GOLDEN = ("golden_tests", "every case is*")
RANDOM = ("proof_tests", "random views: the*")

# name, what the fault is, file, text, what stands in its place, (program, test case)
FAULTS = [
    ("sign", "a sign: sin(delta) of the ray", "shaders/core/strip.glsl",
     "float sine = tangent * factor - strip.x", "float sine = tangent * factor + strip.x", HARD),
    ("root", "a missing square root: |n x e|", "shaders/core/trace.glsl",
     "trace.s = sqrt(dot(trace.side, trace.side));", "trace.s = dot(trace.side, trace.side);", HARD),
    ("half-angle", "the half-angle formula that cancels", "shaders/core/strip.glsl",
     "float half_tan = cosine > 0.0 ? a / b : b / max(a, 1.0e-30);", "float half_tan = a / b;", HARD),
    ("axes-disc", "swapped texture axes: the disc's image", "shaders/object/disc_colour.glsl",
     "vec2(0.5 + turned.x, 0.5 - turned.y)", "vec2(0.5 - turned.y, 0.5 + turned.x)", GOLDEN),
    ("axes-orbit", "swapped table axes: the orbit map", "shaders/core/orbit.glsl",
     "vec4 t10 = orbit_fetch(column + 1, base);\n    vec4 t01 = orbit_fetch(column, base + 1);",
     "vec4 t01 = orbit_fetch(column + 1, base);\n    vec4 t10 = orbit_fetch(column, base + 1);", HARD),
    ("float-fan", "float for double: the camera's place in the table", "src/table/ray_fan.cpp",
     "chi0_ = spacetime_->chi_from_zeta(zeta0_);", "chi0_ = static_cast<float>(spacetime_->chi_from_zeta(zeta0_));", HARD),
    ("float-frame", "float for double: the boost's stretch", "src/render/frame_tables.cpp",
     "std::sqrt((1.0 + speed) / (1.0 - speed))",
     "std::sqrt((1.0f + static_cast<float>(speed)) / (1.0f - static_cast<float>(speed)))", HARD),
    ("orders", "dropped image orders: two crossings and no more", "shaders/object/disc.glsl",
     "#define DISC_MOST_CROSSINGS 12", "#define DISC_MOST_CROSSINGS 2", HARD),
    ("first-crossing", "the first crossing dropped", "shaders/object/disc.glsl",
     ">= trace.s ? 0 : 1;", ">= trace.s ? 1 : 1;", HARD),
    ("order-number", "image orders counted in quarter turns", "shaders/stage/raydata.frag",
     "floor(data.angle * 0.31830988618379067154)", "floor(data.angle * 0.63661977236758134308)", HARD),
    ("doppler", "the frequency without the motion's part", "shaders/core/raydata.glsl",
     "frame.shift.x * trace.doppler", "frame.shift.x", HARD),
    ("dragging", "the dragging with the wrong sign of L", "shaders/core/kerr.glsl",
     "(ray.energy - ray.a * ray.momentum * zeta)", "(ray.energy + ray.a * ray.momentum * zeta)", ("unit_tests", "kerr: the shader core*")),
    ("mino", "half of the mass in the orbit of 1/r about a spinning hole", "shaders/core/kerr.glsl",
     "1.5 * ray.k - 2.0", "0.75 * ray.k - 2.0", ("gpu_tests", "kerr: the shadow*")),
    ("sixth-order", "one weight of the sixth-order step about a spinning hole", "shaders/core/kerr.glsl",
     "f3 * (275.0 / 252.0) -", "f3 * (276.0 / 252.0) -", ("gpu_tests", "kerr methods: half*")),
    ("spin-dips", "bodies about a spinning hole that a ray just touches, missed", "src/reference/spin_bodies.cpp",
     "if (dip <= 0) return", "if (dip <= -1) return", ("unit_tests", "kerr bodies*")),
    ("spin-azimuth", "the azimuth of what a ray meets about a spinning hole, in the chart", "src/reference/kerr_ray.cpp",
     "boyer_lindquist(azimuth, r), late(there, r)};", "phi_ - sense_ * (azimuth - std::atan2(chart_.a, r)), late(there, r)};",
     ("unit_tests", "kerr bodies*")),
    ("thin-rings", "thin rings met by the pixel's middle only", "shaders/object/disc_thin.glsl",
     "ring.thin = phi > frame.critical.w", "ring.thin = phi < 0.0", ("gpu_tests", "thin rings*")),
    ("handedness", "a left-handed frame", "src/render/frame_tables.cpp",
     "cross(radial, meridian)", "cross(meridian, radial)", HARD),
    ("through", "light behind a translucent disc not dimmed", "shaders/stage/trace.frag",
     "through -= over.a;", "through -= 0.0 * over.a;", GOLDEN),
    ("display", "a missing square root in the display's curve", "shaders/effect/display.glsl",
     "vec3 s1 = sqrt(c);", "vec3 s1 = c;", GOLDEN),
    ("stale", "tables kept when the camera moves", "src/render/frame_tables.cpp",
     "radius_ != scene.camera.r || (orbits && !had_orbits) ||\n                 (fan_ && fan_->w0() != fan_for(scene).w0());",
     "(orbits && !had_orbits);", HARD),   # the radius alone is no fault: another radius is another w0
    ("stale-zoom", "tables kept when the view narrows", "src/render/frame_tables.cpp",
     "(fan_ && fan_->w0() != fan_for(scene).w0());", "false;", HARD),
    ("nystrom", "a wrong coefficient of the integrator", "src/table/orbit_map.cpp",
     "25. / 522", "25. / 525", RANDOM),
    ("cube", "a mirrored face of the sky", "src/sky/cube.cpp",
     "case 2: return {s, 1, t};", "case 2: return {-s, 1, t};", ("unit_tests", "cube_direction*")),
    ("roll", "a camera that rolls the wrong way", "src/camera/pose.cpp",
     "{{cr, -sr, 0}, {sr, cr, 0}, {0, 0, 1}}", "{{cr, sr, 0}, {-sr, cr, 0}, {0, 0, 1}}", ("unit_tests", "yaw turns*")),
    ("float-reference", "float for double: the reference's roots", "src/reference/schwarzschild_orbit.cpp",
     "const double psi = std::atan2(q, std::sqrt(-delta2));",
     "const double psi = static_cast<double>(static_cast<float>(std::atan2(q, std::sqrt(-delta2))));",
     ("unit_tests", "the reference meets every row*")),
    ("root-reference", "a missing square root in the reference", "src/reference/schwarzschild_orbit.cpp",
     "sinh_third(std::sqrt(start.delta2) / kCritical)", "sinh_third(start.delta2 / kCritical)",
     ("unit_tests", "the reference meets every row*")),
    ("channels", "two channels of the ray data exchanged", "src/compare/ray_channels.cpp",
     '{"sky.x", [](const RayPixel& p) { return p.sky.x; }', '{"sky.x", [](const RayPixel& p) { return p.sky.y; }',
     ("unit_tests", "compare: every channel*")),
]


def changed(path):
    return subprocess.run(["git", "diff", "--quiet", "HEAD", "--", path], cwd=ROOT).returncode != 0


def build(folder, target):
    return subprocess.run(["cmake", "--build", folder, "--target", target], cwd=ROOT, capture_output=True, text=True)


def run_test(folder, program, case):
    """True if the test failed, as it ought to."""
    environment = {**os.environ, "MESA_SHADER_CACHE_DISABLE": "true"}
    if program == "cli":
        command = [sys.executable, "-B", str(ROOT / "tests/cli" / case), str(Path(folder) / "bin/nullscope")]
        return subprocess.run(command, cwd=ROOT, capture_output=True, env=environment).returncode != 0
    done = subprocess.run([str(Path(folder) / "bin" / program), f"-tc={case}", "--abort-after=1"], cwd=ROOT, capture_output=True,
                          env=environment, timeout=900)
    return done.returncode != 0


def plant(folder, fault):
    name, what, file, old, new, (program, case) = fault
    path = ROOT / file
    text = path.read_text()
    if text.count(old) != 1:
        return f"NOT PLANTED: its text occurs {text.count(old)} times"
    if changed(file):
        return "NOT PLANTED: the file has changes that are not committed"
    try:
        path.write_text(text.replace(old, new))
        built = build(folder, "nullscope" if program == "cli" else program)
        if built.returncode != 0:
            return "NOT BUILT: " + built.stdout.strip().splitlines()[-1]
        return "caught" if run_test(folder, program, case) else "SURVIVED"
    finally:
        path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--build", default=str(ROOT / "build/release"))
    options = parser.parse_args()
    names = [fault[0] for fault in FAULTS]
    if options.list:
        print("\n".join(names))
        return 0
    unknown = [name for name in options.names if name not in names]
    if unknown:
        print(f"mutate: no such fault: {', '.join(unknown)}", file=sys.stderr)
        return 2
    chosen = [fault for fault in FAULTS if not options.names or fault[0] in options.names]
    for program, case in sorted({fault[5] for fault in chosen}):
        built = build(options.build, "nullscope" if program == "cli" else program)
        if built.returncode != 0 or run_test(options.build, program, case):
            print(f"mutate: {program}: {case} fails without any fault", file=sys.stderr)
            return 1
    bad = 0
    print("| fault | where | test | |\n|---|---|---|---|", flush=True)
    for fault in chosen:
        started = time.monotonic()
        verdict = plant(options.build, fault)
        bad += verdict != "caught"
        print(f"| {fault[1]} | {fault[2]} | {fault[5][0]}: {fault[5][1]} | {verdict} |", flush=True)
        print(f"mutate: {fault[0]}: {verdict} ({time.monotonic() - started:.0f} s)", file=sys.stderr, flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
