#!/usr/bin/env python3
"""Fails when a file of the tree holds a path of one machine (somebody's home or work folder).

Usage: check_paths.py [--self-test] [ROOT]

Looks at every file that git tracks or would track, pictures and tables too (their metadata leaks paths); without git at all
files but build/ and out/.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

# Joined here so that this file does not report itself.
FOLDERS = ["work", "root", "home"]
# At the start of a path: not inside a longer path, a URL or a ${variable}/...
MACHINE_PATH = re.compile(rb"(?<![\w.$~})>*/-])/(?:" + "|".join(FOLDERS).encode() + rb")/[\w.-]")


def files_of(root):
    command = ["git", "-c", "safe.directory=*", "-C", str(root), "ls-files", "-z", "-c", "-o", "--exclude-standard"]
    try:
        listed = subprocess.run(command, capture_output=True, check=True).stdout
        return [root / name for name in listed.decode().split("\0") if name]
    except (OSError, subprocess.CalledProcessError):
        skipped = {".git", "build", "out"}
        return [p for p in root.rglob("*") if not skipped & set(p.relative_to(root).parts[:1])]


def check(root):
    found = []
    for path in files_of(root):
        if not path.is_file() or "__pycache__" in path.parts:
            continue
        content = path.read_bytes()
        for match in MACHINE_PATH.finditer(content):
            line = content.count(b"\n", 0, match.start()) + 1
            found.append(f"{path.relative_to(root)}:{line}: a path of one machine: {match[0].decode()}...")
    return found


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        good = root / "good.txt"
        good.write_text("https://example.org/" + FOLDERS[2] + "/page ${x}/" + FOLDERS[0] + "/y src/" + FOLDERS[1] + "/z")
        if check(root):
            print(f"check_paths: reported what is no path of a machine: {check(root)}")
            return 1
        for name in FOLDERS:
            (root / "bad.bin").write_bytes(b"\0\xff\nfile = \"/" + name.encode() + b"/x\"")
            if [line.split(": ")[0] for line in check(root)] != ["bad.bin:2"]:
                print(f"check_paths: did not report a planted /{name}/ path: {check(root)}")
                return 1
    return 0


def main():
    arguments = sys.argv[1:]
    if arguments[:1] == ["--self-test"]:
        return self_test()
    found = check(Path(arguments[0]) if arguments else Path(__file__).resolve().parents[2])
    for line in found:
        print(line)
    print(f"check_paths: {len(found)} paths of one machine", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
