#!/usr/bin/env python3
"""Files of at most 400 lines, functions of at most 60, main() of at most 150, as CONTRIBUTING.md states them; exceptions by name, with the reason.
The viewer's class, which everything in its window meets in, has at most 35 data members.

Usage: check_sizes.py [--self-test]

C++ and GLSL: a function is what begins in the first column and ends with a brace there. Python: as its parser has it.
"""
import ast
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("src", "shaders", "web/core", "python", "scripts", "tests/support")
FILE, FUNCTION, MAIN = 400, 60, 150
MEMBERS = {"src/viewer/viewer.h": ("Viewer", 35)}   # of that class, at most
# What is longer, its lines, and why.
ROWS = "rows of a table"
EXCEPTIONS = {
    "src/scenefile/scene_keys.cpp": (415, ROWS),
    "src/viewer/scene_editor.cpp": (440, "fields of the kinds of keys, and the panel of them"),
    "src/plan/bodies_features.cpp:bodies_features": (70, ROWS),
    "src/plan/disc_features.cpp:disc_features": (130, ROWS),
    "src/plan/light_features.cpp:light_features": (190, ROWS),
    "src/plan/picture_features.cpp:picture_features": (185, ROWS),
    "src/shaderlib/body_text.cpp:march_text": (85, "a text from its first line to its last"),
    "python/module/spacetime.cpp:add_spacetime": (65, "a class of Python, as rows"),
}
BEGINS = re.compile(r"^(?!namespace|struct|class|enum|union|extern|constexpr|const |static const|inline const|#|//|\}|using|template)\w.*?(\w+)\([^;]*$")


def braced_functions(text):
    """(name, lines) of each."""
    name, first = None, 0
    for number, line in enumerate(text.split("\n"), 1):
        if name is None:
            found = BEGINS.match(line)
            if found:
                name, first = found[1], number
        if name is not None and (line.startswith("}") or line.endswith(("; }", "{}")) and number == first):
            yield name, number - first + 1
            name = None
        elif name is not None and line and not line[0].isspace() and number > first and not line.startswith(("}", ":", "//", "#", "{")) and \
                not BEGINS.match(line) and line.endswith(";"):
            name = None   # a declaration


def python_functions(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.name, node.end_lineno - node.lineno + 1


def limit(name):
    """Of NAME or NAME:FUNCTION."""
    return FILE if ":" not in name else MAIN if name.endswith(":main") else FUNCTION


def all_lengths(name, text):
    """(NAME or NAME:FUNCTION, its lines) of a file and its functions."""
    yield name, text.count("\n")
    for function, length in (python_functions if name.endswith(".py") else braced_functions)(text):
        yield f"{name}:{function}", length


def too_long(lengths):
    for what, length in lengths:
        most = EXCEPTIONS.get(what, (limit(what),))[0]
        if length > most:
            yield f"{what}: {length} lines, more than {most}"


def data_members(text, name):
    """Of a class: its names that end with an underscore and are declared, not used."""
    body = re.search(rf"^class {name}\b[^;{{]*{{\n(.*?)^}};", text, re.M | re.S)[1]
    body = re.sub(r"//[^\n]*|\b(?:public|private|protected):", "", body)
    for pair, mark in ((r"\{[^{}]*\}", "@"), (r"\([^()]*\)", "#"), (r"<[^<>]*>", " ")):
        while (shorter := re.sub(pair, mark, body)) != body:
            body = shorter
    statements = [re.sub(r"=[^,]*", "", each) for each in re.split(r";|@\s*\n", body)]
    return [word for each in statements if "#" not in each for word in re.findall(r"\b[a-z]\w*_\b", each)]


def too_many(name, text, kind, most):
    members = data_members(text, kind)
    if len(members) > most:
        yield f"{name}: {kind} has {len(members)} data members, more than {most}"


def main():
    if sys.argv[1:] == ["--self-test"]:
        long = "int f(int a) {\n" + "    ++a;\n" * 70 + "}\n"
        assert [line.split(" ")[0] for line in too_long(all_lengths("a.cpp", long + "int g() {\n}\n"))] == ["a.cpp:f:"]
        assert [line.split(" ")[0] for line in too_long(all_lengths("a.py", "def f():\n" + "    pass\n" * 500))] == ["a.py:", "a.py:f:"]
        kind = "class A {\npublic:\n    int f() const { return a_ + b_; }\n    explicit A(int a) : a_(a), b_{} {}\nprivate:\n" \
               "    int a_ = 1, b_{2};  // c_\n    std::map<int, int> d_;\n    void g(int e_);\n};\n"
        assert data_members(kind, "A") == ["a_", "b_", "d_"], data_members(kind, "A")
        assert list(too_many("a.h", kind, "A", 2)) == ["a.h: A has 3 data members, more than 2"] and not list(too_many("a.h", kind, "A", 3))
        return 0
    files = subprocess.run(["git", "-c", "safe.directory=*", "-C", ROOT, "ls-files", *FOLDERS], capture_output=True, text=True, check=True).stdout.split("\n")
    lengths = [each for name in files if name.endswith((".cpp", ".h", ".inl", ".glsl", ".frag", ".vert", ".py"))
               for each in all_lengths(name, (ROOT / name).read_text(encoding="utf-8"))]
    wrong, lengths = list(too_long(lengths)), dict(lengths)   # of overloads the last: no exception has one
    wrong += [f"{name}: {lengths.get(name, 'no')} lines, no exception any more" for name in EXCEPTIONS if lengths.get(name, 0) <= limit(name)]
    wrong += [line for name, (kind, most) in MEMBERS.items() for line in too_many(name, (ROOT / name).read_text(encoding="utf-8"), kind, most)]
    print("\n".join(wrong) or f"check_sizes: {len(files)} files, {len(EXCEPTIONS)} exceptions")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
