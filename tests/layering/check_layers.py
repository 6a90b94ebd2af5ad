#!/usr/bin/env python3
"""The layering test: fails on an #include, a link or a shader built-in that the architecture does not allow.

Usage: check_layers.py [ROOT]    (ROOT: the source tree, by default the one this file is in)

Prints one line per violation, FILE:LINE: what and why; exit status 0 (none), 1 (some), 2 (the list itself is unreadable).
"""
import fnmatch
import functools
import re
import sys
from pathlib import Path



def stated_packages():
    """Those whose line of third_party/CMakeLists.txt ends in the one module that uses them and their headers: ... image <png*.h>."""
    file = Path(__file__).resolve().parents[2] / "third_party/CMakeLists.txt"
    for line in file.read_text(encoding="utf-8").splitlines() if file.is_file() else []:
        found = re.match(r"\w+\((\w+) .*#.* (\w+) <([^<>]+)>$", line)
        if found:
            headers = "|".join(fnmatch.translate(glob) for glob in found[3].split())
            yield found[1], re.compile(f"^(?:{headers})"), {found[2]}


# A package of others may be included by these modules (or single files) of src/ and nowhere else.
PACKAGES = [
    *stated_packages(),
    ("a header of one system", re.compile(r"^(?:dlfcn|fcntl|io|malloc|poll|pwd|signal|spawn|unistd|windows|psapi|bcrypt)\.h$|^sys/"), {"platform"}),
    ("FreeType", re.compile(r"^(ft2build\.h|freetype/.*)$"), {"annotate"}),
    ("libcrypto", re.compile(r"^openssl/"), {"platform/posix/sha256.cpp"}),
    ("Dear ImGui", re.compile(r"^(imgui/)?(backends/)?imgui\w*\.h$"), {"viewer"}),
    ("GLFW", re.compile(r"^GLFW/"), {"viewer", "context/glfw.cpp"}),
    ("toml++", re.compile(r"^toml(\+\+|plusplus)?/|^toml\.hpp$|^toml\+\+$"), {"scenefile", "studio/user_files.cpp"}),
    ("CLI11", re.compile(r"^CLI/|^CLI11\.hpp$"), {"base/command_line.cpp"}),
    ("nlohmann-json", re.compile(r"^nlohmann/"), {"cli", "command", "bench"}),
    ("Boost", re.compile(r"^boost/"), {"fit", "reference"}),
]
# Macros of one system: what differs between systems is in src/platform.
SYSTEM_MACRO = re.compile(r"\b(_WIN32|__MINGW\d+__|__linux__|__unix__|__APPLE__)\b")
# The reference shares no geodesic code with what it judges, not even through a third module.
REFERENCE, REFERENCE_AVOIDS = "reference", {"shadercore", "table", "gl", "shaderlib", "render"}
# Shader files may be seen by C++ in these modules only.
SHADER_READERS = {"shared": {"shadercore", "gl", "render"}, "*": {"shadercore"}}
# asin and acos of Mesa's software driver are off by up to 3.9e-4 rad: use atan(sqrt((1 - x) * (1 + x)), x).
BANNED_BUILT_IN = re.compile(r"\b(asin|acos)\s*\(")

SOURCE_SUFFIXES = {".h", ".hpp", ".cpp", ".c", ".inl"}
# What a shader file defines: a function, whose uses have a bracket behind them; a struct, macro or uniform.
GLSL_FUNCTION = re.compile(r"^\w[\w ]* (\w+\()[^;{}]*\) *\{", re.M)
GLSL_NAME = re.compile(r"^(?:struct|#define|uniform [\w ]+) (\w+)", re.M)
GLSL_WORD = re.compile(r"\w+\(?")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"\n]+)"|<([^>\n]+)>)', re.M)
# What must not be read as code: raw strings, comments; ordinary strings are matched so that "//" in one starts no comment.
# The names of #include "..." are kept by the function that uses this.
NOT_CODE = re.compile(
    r'R"([^()\\ \n]*)\((?:.|\n)*?\)\1"|//[^\n]*|/\*(?:.|\n)*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'')


class ListError(Exception):
    """layers.txt or src/CMakeLists.txt cannot be understood."""


@functools.cache   # the self-test asks for the same texts again and again
def without_comments(text):
    """text with comments and raw strings blanked; line numbers stay."""
    def blank(match):
        found = match.group(0)
        if found.startswith(("//", "/*", "R\"")):
            return re.sub(r"[^\n]", " ", found)
        return found
    return NOT_CODE.sub(blank, text)


def read(path):
    return path.read_text(encoding="utf-8", errors="replace")


def read_layers(path):
    """({module: layer}, {module: set of modules it may include}, the same of folders of shaders)."""
    layer_of, allowed, of_shaders, layer = {}, {}, {}, None
    for number, line in enumerate(read(path).splitlines(), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        heading = re.fullmatch(r"layer (\d+)", line)
        edge = re.fullmatch(r"([\w/]+):((?: +[\w/]+)*)", line)
        if heading:
            layer = int(heading[1])
        elif line == "shaders":
            layer = line
        elif edge and layer == "shaders" and edge[1] not in of_shaders:
            of_shaders[edge[1]] = set(edge[2].split())
        elif edge and layer is not None and edge[1] not in allowed:
            layer_of[edge[1]] = layer
            allowed[edge[1]] = set(edge[2].split())
        else:
            raise ListError(f"{path}:{number}: expected 'layer N' or one new 'module: others', found '{line}'")
    if not allowed:
        raise ListError(f"{path}: no module is listed")
    return layer_of, allowed, of_shaders


def reachable(allowed, start):
    seen, todo = set(), [start]
    while todo:
        for other in allowed.get(todo.pop(), ()):
            if other not in seen:
                seen.add(other)
                todo.append(other)
    return seen


def check_list(layer_of, allowed):
    """The list by itself: known names, no edge upwards, no cycle, the reference apart."""
    for module in sorted(allowed):
        for other in sorted(allowed[module]):
            if other not in allowed:
                yield f"layers.txt: {module} names {other}, which is no module of the list"
            elif layer_of[other] > layer_of[module]:
                yield f"layers.txt: {module} (layer {layer_of[module]}) names {other} of the higher layer {layer_of[other]}"
        if module in reachable(allowed, module):
            yield f"layers.txt: {module} reaches itself: the list is cyclic"
    for other in sorted(reachable(allowed, REFERENCE) & REFERENCE_AVOIDS):
        yield f"layers.txt: {REFERENCE} reaches {other}, but it is the independent reference"


def check_folders(root, allowed):
    present = {p.name for p in (root / "src").iterdir() if p.is_dir()}
    for name in sorted(present - set(allowed)):
        yield f"src/{name}: a folder that layers.txt does not list"
    for name in sorted(set(allowed) - present):
        yield f"layers.txt: {name} has no folder in src/"


def cmake_commands(text, name):
    """(line number, words) of every call of a CMake command."""
    text = re.sub(r"#[^\n]*", "", text)
    for match in re.finditer(rf"\b{name}\s*\(([^()]*)\)", text):
        yield text.count("\n", 0, match.start()) + 1, match[1].split()


def check_cmake(root, allowed):
    """src/CMakeLists.txt links a module to exactly what the list allows, and a program to no more than that."""
    path = root / "src" / "CMakeLists.txt"
    if not path.exists():
        raise ListError("src/CMakeLists.txt is missing")
    text, seen = read(path), set()
    for line, words in cmake_commands(text, "nullscope_module"):
        if words[0].startswith("$") or words[0] == "name":
            continue    # the definition
        name, links, keyword = words[0], set(), None
        for word in words[1:]:
            if word in ("DEPENDS", "PACKAGES"):
                keyword = word
            elif keyword == "DEPENDS":
                links.add(word)
        seen.add(name)
        if name not in allowed:
            yield f"src/CMakeLists.txt:{line}: module {name} is not in layers.txt"
        elif links != allowed[name]:
            more, less = " ".join(sorted(links - allowed[name])), " ".join(sorted(allowed[name] - links))
            yield (f"src/CMakeLists.txt:{line}: {name} links other modules than layers.txt allows"
                   + (f"; too many: {more}" if more else "") + (f"; missing: {less}" if less else ""))
    programs = {"nullscope": "cli", "nullscope-viewer": "viewer", "nullscope_coretexts": "coretexts"}
    for line, words in [*cmake_commands(text, "target_link_libraries"), *cmake_commands(text, "nullscope_program")]:
        module = programs.get(words[0]) or re.sub(r"^nullscope_", "", words[0]).split("_")[0]
        if module not in allowed:
            continue
        if module in programs.values():
            seen.add(module)
        for word in words[1:]:
            linked = re.fullmatch(r"nullscope_([a-z]+)(?:_\w+)?", word)
            if linked and linked[1] not in allowed[module] | {module, "options"}:
                yield f"src/CMakeLists.txt:{line}: {words[0]} links {word}, which layers.txt does not allow {module}"
    has_sources = {m for m in allowed if any(f.suffix == ".cpp" for f in (root / "src" / m).glob("*"))}
    for name in sorted(has_sources - seen):
        yield f"src/CMakeLists.txt: nothing builds src/{name}"


def check_include(where, module, target, quoted, allowed):
    """Why a file of a module may not include target, or None. where: its path below src/."""
    if target.startswith("/") or re.match(r"^[A-Za-z]:", target):
        return "an absolute path; includes start at src/"
    if ".." in target.split("/"):
        return "climbs with '..'; includes start at src/"
    for package, pattern, homes in PACKAGES:
        if pattern.search(target):
            if module in homes or where in homes:
                return None
            return f"{package} is included in {' and '.join(sorted(homes))} and nowhere else"
    parts = target.split("/")
    if target.endswith(".glsl"):
        folder = parts[parts.index("shaders") + 1] if "shaders" in parts else parts[0]
        homes = SHADER_READERS.get(folder, SHADER_READERS["*"])
        return None if module in homes else f"shaders/{folder} is seen by {' and '.join(sorted(homes))} alone"
    if len(parts) > 1 and parts[0] in allowed:
        if parts[0] == module or parts[0] in allowed[module]:
            return None
        return f"layers.txt does not let {module} include {parts[0]}"
    if quoted:
        return "names no module; write \"module/file.h\", or <...> for a package"
    return None


def check_includes(root, allowed):
    for path in sorted((root / "src").rglob("*")):
        where = path.relative_to(root / "src").as_posix()
        module = where.split("/")[0]
        if path.suffix not in SOURCE_SUFFIXES or module not in allowed:
            continue
        code = without_comments(read(path))
        for match in INCLUDE.finditer(code):
            target = match[1] or match[2]
            reason = check_include(where, module, target, match[1] is not None, allowed)
            if reason:
                yield f"src/{where}:{code.count(chr(10), 0, match.start()) + 1}: #include {target}: {reason}"
        for match in SYSTEM_MACRO.finditer(code):
            if module != "platform":
                yield f"src/{where}:{code.count(chr(10), 0, match.start()) + 1}: {match[1]} outside of src/platform"


def check_shader_includes(codes, allowed):
    """Every #include names a file that is there and allowed, none leads back, and a file reaches what it uses."""
    includes = {name: {f"shaders/{match[1] or match[2]}" for match in INCLUDE.finditer(code)}
                for name, code in codes.items()}
    # "path/NAME" is NAME of the kind of path that a frame's light takes.
    paths = {target for targets in includes.values() for target in targets if target.startswith("shaders/path/")}
    for target in paths:
        includes[target] = {target.replace("/path/", f"/{kind}/") + ".glsl" for kind in allowed.get("path", ())}
    for name, code in codes.items():
        folder = name.split("/")[1]
        for match in INCLUDE.finditer(code):
            target = match[1] or match[2]
            where = f"{name}:{code.count(chr(10), 0, match.start()) + 1}: #include {target}"
            home = target if target.startswith("generated/") else target.split("/")[0]
            lacking = includes.get("shaders/" + target, set()) - set(codes) if home == "path" else set()
            if lacking or (home not in (target, "path") and "shaders/" + target not in codes):
                yield f"{where}: no such file in shaders/"
            elif home not in allowed.get(folder, ()):
                yield f"{where}: layers.txt does not let shaders/{folder} include {home}"
        if name in reachable(includes, name):
            yield f"{name}: includes itself, by way of others"
    # A generated text may name every file of its folders.
    for part in (part for part in allowed if part.startswith("generated/")):
        includes["shaders/" + part] = {name for name in codes if name.split("/")[1] in allowed[part]}
    homes = {}   # of what is defined: files
    for file, code in codes.items():
        for name in GLSL_FUNCTION.findall(code) + GLSL_NAME.findall(code):
            if not name.startswith("BODY"):   # of templates
                homes.setdefault(name, set()).add(file)
    for file, code in codes.items():
        seen = reachable(includes, file) | {file}
        for match in GLSL_WORD.finditer(code):
            name = match[0] if match[0] in homes else match[0].rstrip("(")
            if name in homes and not homes[name] & seen:
                line = code.count("\n", 0, match.start()) + 1
                yield f"{file}:{line}: uses {name} of {', '.join(sorted(homes[name]))} and includes none of it"


def check_shaders(root, allowed):
    codes = {path.relative_to(root).as_posix(): without_comments(read(path))
             for path in sorted((root / "shaders").rglob("*")) if path.is_file()}
    for other in sorted(set().union(*allowed.values()) - set(allowed)):
        yield f"layers.txt names {other}, which is neither a folder of shaders/ nor a generated text"
    for folder in sorted({name.split("/")[1] for name in codes} - set(allowed)):
        yield f"shaders/{folder}: a folder that layers.txt does not list"
    yield from check_shader_includes(codes, allowed)
    for name, code in codes.items():
        for match in BANNED_BUILT_IN.finditer(code):
            line = code.count("\n", 0, match.start()) + 1
            yield f"{name}:{line}: {match[1]}() is banned here; use atan(sqrt((1 - x) * (1 + x)), x)"


def check(root):
    """All violations in the tree at root, as a list of lines."""
    layer_of, allowed, of_shaders = read_layers(root / "tests" / "layering" / "layers.txt")
    found = list(check_list(layer_of, allowed))
    found += check_folders(root, allowed)
    found += check_cmake(root, allowed)
    found += check_includes(root, allowed)
    found += check_shaders(root, of_shaders)
    return found


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
    try:
        found = check(root)
    except (ListError, OSError) as error:
        print(f"check_layers: {error}", file=sys.stderr)
        return 2
    for line in found:
        print(line)
    print(f"check_layers: {len(found)} violations", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
