#!/usr/bin/env python3
"""clang-tidy on src/ and what of web/ this machine compiles too, by the compile commands of preset tidy.

    scripts/tidy.py             all files
    scripts/tidy.py FILE...     only these .cpp files
    scripts/tidy.py --since REV only those that git says have changed since REV, with what is not committed
    scripts/tidy.py --self-test planted faults are found in a group: in its first and its last file

Files of one module are looked at in groups, as one translation unit that includes them: most of the time goes into the headers that
they share (28 files of src/reference, processor seconds: 85 in groups of six, 48 of fourteen, 31 as one). A group in which names clash
is halved until they do not. Of a group bugprone-suspicious-include is left out, for groups include .cpp files. Up to ALONE changed files
are looked at one by one: then a file that does not include what it uses is found, too. Exit status: 0 nothing found, 1 something, 2 it
could not be run.
"""
import json
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from itertools import groupby
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/tidy"
GROUP = 28
ALONE = 20
CHECKS_OF_A_GROUP = "-bugprone-suspicious-include"
FOUND = re.compile(r"^(/[^:]+):(\d+):(\d+): (warning|error): (.*)$")


def commands():
    """Of each .cpp file of src/ and web/: the compiler's words without the file, its output and its module's folder. After generate()."""
    found = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        path = Path(entry["file"])
        if path.suffix == ".cpp" and any(path.is_relative_to(ROOT / name) for name in ("src", "web")):
            # The first of several: some files belong to a program and to its tests.
            found.setdefault(path, (re.sub(r" -o \S+ -c \S+$", "", entry["command"]), entry["directory"]))
    return found


def generate():
    """What the build makes and files include: the shader core's text and uniform block, OpenGL's functions. With it the compile commands
    of files that have come since."""
    if not (BUILD / "compile_commands.json").exists():
        subprocess.run(["cmake", "--preset", "tidy"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    targets = ["nullscope_core_texts", "glad/include/glad/gl.h"]
    subprocess.run(["cmake", "--build", BUILD, "--target", *targets], check=True, stdout=subprocess.DEVNULL)


def groups_of(files, known, most):
    """Files of one folder with the same command, so many at most together."""
    key = lambda file: (str(file.parent), known[file])
    for _, same in groupby(sorted(files, key=lambda file: (*key(file), file)), key):
        same = list(same)
        count = -(-len(same) // most)
        yield from (same[i::count] for i in range(count))


def tidy(folder, files, known):
    """What clang-tidy says of these files, or None where they do not compile as one."""
    command, directory = known[files[0]]
    if len(files) == 1:
        unit = files[0]
    else:
        unit = Path(folder) / (files[0].stem + f"-{len(files)}-{abs(hash(tuple(files))):x}.cpp")
        unit.write_text("".join(f'#include "{file}"\n' for file in files))
    database = Path(tempfile.mkdtemp(dir=folder))
    (database / "compile_commands.json").write_text(json.dumps([{"directory": directory, "command": f"{command} -c {unit}", "file": str(unit)}]))
    words = ["clang-tidy", "-quiet", "-p", database, "--config-file", ROOT / ".clang-tidy", unit]
    if len(files) > 1:
        words[1:1] = [f"--checks={CHECKS_OF_A_GROUP}", f"--header-filter=\\.cpp$|^{ROOT}/(src|tests)/.*\\.h$"]
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, errors="replace")
    lines = [line for line in re.sub(r"\x1b\[[0-9;]*m", "", done.stdout).splitlines() if FOUND.match(line)]
    if len(files) > 1 and any("[clang-diagnostic" in line for line in lines):
        return None
    if done.returncode != 0 and not lines:
        raise RuntimeError(f"clang-tidy failed on {unit}:\n{done.stdout}{done.stderr}")
    return lines


def look(files, known, most):
    """The findings in these files, sorted; each once."""
    with tempfile.TemporaryDirectory(prefix="nullscope-tidy-") as folder, ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        def group(files):
            said = tidy(folder, files, known)
            if said is None:
                print(f"tidy: in two parts, for names clash: {' '.join(file.name for file in files)}", file=sys.stderr)
                said = [line for part in (files[::2], files[1::2]) for line in group(part)]
            return said
        return sorted({line for lines in pool.map(group, groups_of(files, known, most)) for line in lines})


def changed(revision):
    words = ["git", "-c", f"safe.directory={ROOT}", "-C", ROOT, "diff", "--name-only", "--diff-filter=d", revision, "--", "src", "web"]
    return [ROOT / name for name in subprocess.run(words, check=True, capture_output=True, text=True).stdout.split()]


def self_test():
    with tempfile.TemporaryDirectory(prefix="nullscope-tidy-") as folder:
        planted = [Path(folder) / f"{name}.cpp" for name in "abc"]
        for file, text in zip(planted, ["int WrongName() { return 0; }\n", "int right_name() { return 1; }\n",
                                        "#include <string>\nint last(std::string s) { return static_cast<int>(s.size()); }\n"]):
            file.write_text(text)
        known = {file: ("clang++ -std=gnu++20", folder) for file in planted}
        found = [(Path(FOUND.match(line)[1]).name, re.search(r"\[([\w-]+)", line)[1]) for line in tidy(folder, planted, known)]
        wanted = {("a.cpp", "readability-identifier-naming"), ("c.cpp", "performance-unnecessary-value-param")}
        if set(found) != wanted:
            sys.exit(f"tidy: of planted faults {found} was found, not {wanted}")


def main():
    words = sys.argv[1:]
    if words[:1] in (["-h"], ["--help"]):
        print(__doc__)
        return 0
    if words == ["--self-test"]:
        return self_test()
    generate()
    known = commands()
    files = changed(words[1]) if words[:1] == ["--since"] else [Path(word).resolve() for word in words] or list(known)
    chosen = [file for file in files if file in known]
    if words and words[0] != "--since" and len(chosen) < len(files):
        sys.exit(f"tidy: not compiled here: {' '.join(str(file) for file in files if file not in known)}")
    found = look(chosen, known, 1 if words and len(chosen) <= ALONE else GROUP)
    print("\n".join(line.replace(f"{ROOT}/", "") for line in found), end="\n" if found else "")
    print(f"tidy: {len(found)} findings in {len(chosen)} files", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (RuntimeError, subprocess.CalledProcessError, OSError) as error:
        print(f"tidy: {error}", file=sys.stderr)
        sys.exit(2)
