#!/usr/bin/env python3
"""Files of one module give different names to what is theirs alone, for several of them are compiled as one (NULLSCOPE_UNITY).

Usage: check_names.py [--self-test] [FOLDER...]     folders of .cpp files; by default every module of src/, and every folder of tests/

Looks at what begins in the first column inside an anonymous namespace. Functions of one name may differ in their parameters, but not only in which kind of
text or of number these are: a word in quotes would call another file's function. Types and constants there have no name of a type or constant of
the module's headers either.
"""
import re
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TYPE = re.compile(r"(?:struct|class|enum class|enum|using) (\w+)\b(?!.*\);)")
ALONE = {"core32.cpp", "core64.cpp", "stokes_transfer.cpp"}   # compiled with options of their own: shader text in a precision
VALUE = re.compile(r"[A-Za-z][\w:<>,&*\[\] ]*[ &*](\w+)(\(.*|\{| =|\[|;)")
TEXT, NUMBER = re.compile(r"(?:const )?(?:std::string_view|std::string|char)\b ?[&*]?"), re.compile(r"\b(?:long |unsigned )*(?:double|float|int|long|unsigned|char|bool|std::size_t)\b")
ALIAS = re.compile(r"namespace \w+ =|using namespace|using \w+::")   # the same in each file


def own_names(text):
    """(name, its parameters, or nothing for what has none) of a file."""
    names, inside = set(), False
    joined = re.sub(r"^const[^;{]*;", lambda constants: re.sub(r"\n +", " ", constants[0]), text, flags=re.MULTILINE)   # several lines of them
    for line in joined.split("\n"):
        if line == "namespace {":
            inside = True
        elif line.startswith("}  // namespace") and line.strip() == "}  // namespace":
            inside = False
        elif inside and line[:1].isalpha() and not ALIAS.match(line):
            found = TYPE.match(line) or VALUE.match(line)
            if found:
                rest = found[2] if found.re is VALUE else ""
                if line.startswith("const"):   # several in a line
                    names.update((name, "") for name in re.findall(r", (\w+) = ", line))
                names.add((found[1], re.sub(r"\s*\w+\s*([,)])", r"\1", rest.split("{")[0]).strip() if rest.startswith("(") else ""))
    return names


def alike(parameters):
    """Parameters, of each number that a call may give, so that what a call may take for each other is written the same."""
    words = re.findall(r"[^,<(]*(?:<[^>]*>|\([^)]*\))?[^,<]*", parameters.strip()[1:].removesuffix(")"))
    words = [NUMBER.sub("number", TEXT.sub("text", re.sub(r" \w* ?=.*", " =", word.strip()))) for word in words if word.strip()]
    least = next((i for i, word in enumerate(words) if word.endswith(" =")), len(words))
    return {", ".join(word.removesuffix(" =") for word in words[:count]) for count in range(least, len(words) + 1)}


def header_names(text):
    """Types and constants of a header."""
    found = re.findall(r"^(?:struct|class|enum class|enum) (\w+)|^using (\w+) =|^inline constexpr [\w:<>* ]*?(\w+)(?:\[[^\n]*\])? =", text, re.MULTILINE)
    return {name for names in found for name in names if name}


def clashes(folder):
    owners = defaultdict(list)
    for file in sorted(file for file in folder.glob("*.cpp") if file.name not in ALONE):
        for name, parameters in own_names(file.read_text(encoding="utf-8")):
            for written in alike(parameters) if parameters else {""}:
                if file.name not in owners[name, written]:   # its own overloads are its own affair
                    owners[name, written].append(file.name)
    for header in sorted(folder.glob("*.h")):
        for name in header_names(header.read_text(encoding="utf-8")):
            if (name, "") in owners:
                owners[name, ""].append(header.name)
    return [f"{folder.name}: {name} is a name in {' and in '.join(files)}" for name, files in sorted({(name, tuple(files)) for (name, _), files in owners.items() if len(files) > 1})]


def self_test():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "a.cpp").write_text("namespace {\nconstexpr int kA = 1, kC = 2;\nstruct Row {\n};\nint of(int a) { return a; }\nint of(char a) { return a; }\ndouble f(double x) {\n}\nint word(const char* text, int a) {\n}\nint sum(const Row& a) {\n}\n}  // namespace\nint g() {}\n")
        (folder / "b.cpp").write_text("namespace {\nconstexpr int kB = kA,\n              kD = 4,\n              kC = 3;\nstruct Row;\nint of(int b) {\n}\ndouble f(float x) {\n}\nint word(const std::string& text, int a) {\n}\nint sum(const Far& a) {\n}\nvoid g() {}\n}  // namespace\n")
        (folder / "c.h").write_text("struct Wide;\ninline constexpr double kFar = 3;\n")
        (folder / "c.cpp").write_text("namespace {\nconstexpr double kFar = 2;\nstruct Wide {\n};\n}  // namespace\n")
        found = [line.split()[1] for line in clashes(folder)]
        assert found == ["Row", "Wide", "f", "kC", "kFar", "of", "word"], found
    return 0


def main():
    words = sys.argv[1:]
    if words == ["--self-test"]:
        return self_test()
    found = [line for folder in ([Path(word) for word in words] or sorted([*(ROOT / "src").iterdir(), *(ROOT / "src/platform").iterdir(), *(ROOT / "tests").iterdir()])) if folder.is_dir() for line in clashes(folder)]
    print("\n".join(found) or "check_names: no two files of a module share a name")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
