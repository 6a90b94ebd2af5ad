#!/usr/bin/env python3
"""A check that cannot fail is a defect: plants one violation of every rule of check_layers.py in a copy of the tree.

Each plant must be reported, in its own file and with its own reason, and must be all that is reported beyond what the tree
without it already shows. One violation also goes through the command line, for the exit status.
"""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import check_layers  # noqa: E402

ROOT = HERE.parents[1]

# (file, text to append, part of the line that must be reported). Files named planted.* do not exist before.
FORBIDDEN = [
    ("src/base/planted.h", '#include "scene/scene.h"', "does not let base include scene"),
    ("src/reference/planted.h", '#include "shadercore/core.h"', "does not let reference include shadercore"),
    ("src/reference/planted.h", '#include "table/table.h"', "does not let reference include table"),
    ("src/reference/planted.h", '#include "gl/texture.h"', "does not let reference include gl"),
    ("src/render/planted.h", '  #  include <viewer/panels.h>', "does not let render include viewer"),
    ("src/cli/planted.h", '#include "viewer/panels.h"', "does not let cli include viewer"),
    ("src/viewer/planted.h", '#include "cli/capture.h"', "does not let viewer include cli"),
    ("src/scene/planted.h", "#include <png.h>", "PNG is included in"),
    ("src/viewer/planted.h", "#include <ft2build.h>", "FreeType is included in"),
    ("src/sky/planted.h", "#include <jpeglib.h>", "JPEG is included in"),
    ("src/sky/planted.h", "#include <OpenEXR/ImfRgbaFile.h>", "OpenEXR is included in"),
    ("src/cli/planted.h", "#include <ImfHeader.h>", "OpenEXR is included in"),
    ("src/cli/planted.h", "#include <fitsio.h>", "cfitsio is included in"),
    ("src/render/planted.h", '#include "imgui.h"', "Dear ImGui is included in"),
    ("src/cli/planted.h", "#include <imgui/imgui_impl_glfw.h>", "Dear ImGui is included in"),
    ("src/context/planted.h", "#include <GLFW/glfw3.h>", "GLFW is included in"),
    ("src/observer/planted.h", "#include <toml++/toml.h>", "toml++ is included in"),
    ("src/table/planted.h", "#include <boost/math/special_functions/ellint_1.hpp>", "Boost is included in"),
    ("src/render/planted.h", "#include <nlohmann/json.hpp>", "nlohmann-json is included in"),
    ("src/base/planted.h", "#include <CLI/CLI.hpp>", "CLI11 is included in"),
    ("src/cli/planted.h", "#include <CLI11.hpp>", "CLI11 is included in"),
    ("src/cli/planted.h", "#include <unistd.h>", "a header of one system is included in platform"),
    ("src/cli/planted.h", "#include <sys/wait.h>", "a header of one system is included in platform"),
    ("src/render/planted.h", "#ifdef _WIN32\n#endif", "_WIN32 outside of src/platform"),
    ("src/base/planted.h", '#include "/usr/include/math.h"', "absolute path"),
    ("src/base/planted.h", '#include "../scene/scene.h"', "climbs"),
    ("src/base/planted.h", '#include "vec.h"', "names no module"),
    ("src/reference/planted.h", '#include "core/constants.glsl"', "shaders/core is seen by"),
    ("src/planted/planted.h", "", "src/planted: a folder that layers.txt does not list"),
    ("shaders/core/planted.glsl", "float f(float x) { return acos (x); }", "acos() is banned"),
    ("shaders/object/planted.glsl", "float f(float x) { return acos(x); }", "acos() is banned"),
    ("shaders/core/planted.glsl", '#include "object/ball.glsl"', "does not let shaders/core include object"),
    ("shaders/effect/planted.glsl", '#include "generated/method"', "does not let shaders/effect include generated"),
    ("shaders/core/planted.glsl", '#include "core/nowhere.glsl"', "no such file"),
    ("shaders/core/planted.glsl", '#include "core/planted.glsl"', "includes itself"),
    ("shaders/core/planted.glsl", "float f(float x) { return arc_tangent_unit(x); }", "uses arc_tangent_unit( of"),
    ("shaders/effect/planted.glsl", "float f(Trace trace) { return 1.0; }", "uses Trace of shaders/mino/interpolated.glsl, shaders/mino/trace.glsl, shaders/planar/trace.glsl"),
    ("shaders/effect/planted.glsl", "float f() { return float(PLANCK_CELLS); }", "uses PLANCK_CELLS of"),
    ("shaders/effect/planted.glsl", "ivec2 f() { return textureSize(table_texture, 0); }", "uses table_texture of"),
    ("shaders/planted/planted.glsl", "", "shaders/planted: a folder that layers.txt does not list"),
    ("shaders/spacetime/planted.glsl", "float f(float x) { return 1.0 - asin(x); }", "asin() is banned"),
    ("src/CMakeLists.txt", "nullscope_module(extra DEPENDS base)", "extra is not in layers.txt"),
    ("src/CMakeLists.txt", "target_link_libraries(nullscope PRIVATE nullscope_viewer)", "links nullscope_viewer"),
    ("src/CMakeLists.txt", "nullscope_program(nullscope cli nullscope_viewer)", "links nullscope_viewer"),
    ("src/CMakeLists.txt", "target_link_libraries(nullscope_reference PUBLIC nullscope_table)", "links nullscope_table"),
]
# (file, start of the line to change, text to put behind it, part of the line that must be reported)
CHANGED = [
    ("tests/layering/layers.txt", "base:", " viewer", "higher layer"),
    ("tests/layering/layers.txt", "base:", "\nlonely: base", "lonely has no folder"),
    ("tests/layering/layers.txt", "gl:", " scene", "gl links other modules"),
    ("tests/layering/layers.txt", "context:", " nothing", "no module of the list"),
    ("tests/layering/layers.txt", "shadercore:", " table", "cyclic"),
    ("tests/layering/layers.txt", "observer:", " table", "reference reaches table"),
    ("shaders/core/sweep.glsl", "struct Sweep", ' {};\n#include "planar/trace.glsl"\nstruct Other', "by way of others"),
    ("tests/layering/layers.txt", "core:", " nothing", "layers.txt names nothing"),
    ("src/CMakeLists.txt", "nullscope_module(context NO_HOT_LOOPS DEPENDS", " scene", "too many: scene"),
]
ALLOWED = [
    ("src/platform/windows/planted.cpp", "#include <windows.h>\n#ifdef __MINGW64__\n#endif"),
    ("src/image/planted.h", "#include <png.h>\n#include <ImfRgbaFile.h>\n#include <vector>"),
    ("src/viewer/planted.h", '#include <imgui.h>\n#include <GLFW/glfw3.h>\n#include "render/renderer.h"'),
    ("src/reference/planted.h", '#include <boost/math/tools/roots.hpp>\n#include "reference/other.h"'),
    ("src/shadercore/planted.h", '#include "shaders/core/constants.glsl"'),
    ("src/base/planted.h", '// #include "scene/scene.h"\n/*\n#include "scene/scene.h"\n*/'),
    ("src/base/planted.h", 'const char* url = "https://x"; const char* s = R"(\n#include "scene/scene.h"\n)";'),
    ("shaders/object/planted.glsl",
     '#include "core/trig.glsl"\n#include "path/trace"\nfloat f(float x) { return arc_tangent_unit(x); }'),
    ("shaders/core/planted.glsl", "// never acos(x)\nfloat core_acos(float x); float g(float x) { return acosh(x); }"),
]


def with_plant(copy, before, path, content):
    """What check reports beyond `before` when path holds content; the file is restored afterwards."""
    target = copy / path
    old = target.read_text() if target.exists() else None
    made_folder = not target.parent.exists()
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(content)
    try:
        return [line for line in check_layers.check(copy) if line not in before]
    finally:
        if old is None:
            target.unlink()
        else:
            target.write_text(old)
        if made_folder:
            target.parent.rmdir()


def main():
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder)
        for part in ("src", "shaders", "tests/layering", "third_party"):
            if (ROOT / part).exists():
                shutil.copytree(ROOT / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
        before = check_layers.check(copy)

        for path, text, expected in FORBIDDEN:
            old = (copy / path).read_text() + "\n" if (copy / path).exists() else ""
            found = with_plant(copy, before, path, old + text + "\n")
            places = (path, "layers.txt", "src/planted:", "shaders/planted:")
            stray = [line for line in found if not line.startswith(places)]
            if not any(expected in line for line in found) or stray:
                failures.append(f"{path} with '{text}': expected '{expected}', reported {found}")
        for path, start, addition, expected in CHANGED:
            old = (copy / path).read_text()
            if "\n" + start not in old:
                failures.append(f"{path} has no line that starts with '{start}': bring this self-test up to date")
                continue
            found = with_plant(copy, before, path, old.replace("\n" + start, "\n" + start + addition, 1))
            if not any(expected in line for line in found):
                failures.append(f"{path} with '{start}{addition}': expected '{expected}', reported {found}")
        for path, text in ALLOWED:
            found = with_plant(copy, before, path, text + "\n")
            if found:
                failures.append(f"{path}: allowed, but reported {found}")

        (copy / "src/base/planted.h").write_text('#include "viewer/panels.h"\n')
        run = subprocess.run([sys.executable, str(copy / "tests/layering/check_layers.py")], capture_output=True, text=True)
        if run.returncode != 1 or "src/base/planted.h:1:" not in run.stdout:
            failures.append(f"the command line gave status {run.returncode} and '{run.stdout}' for a forbidden include")

    for failure in failures:
        print(failure)
    print(f"check_layers_selftest: {len(FORBIDDEN) + len(CHANGED)} plants, {len(ALLOWED)} allowed cases,"
          f" {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
