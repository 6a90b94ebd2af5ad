#!/usr/bin/env python3
"""What the documentation says can be done: links lead somewhere, figures can be drawn again, commands run.

Every line of a page that begins with nullscope (or build/release/bin/nullscope, or is in a block marked sh) is looked at: its options are
those that --help lists. Blocks and lines are then run, page by page and in order, in an empty folder, but for `bench` outside of blocks, which
measures for minutes. Pictures are drawn with at most 64 px a side and sequences have two frames: small_program(). At quick depth those of
docs/tutorial.md and docs/command-line.md are run (LONG_PAGES), with --all those of every page.
"""
import functools
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import support
from image_bytes import png

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted([*(ROOT / "docs").rglob("*.md"), *ROOT.glob("*.md")])
DRAWN_BY = [ROOT / "scripts/figures.sh", ROOT / "scripts/gallery.py"]
PICTURES = {".png", ".jpg", ".svg"}
# Long pages whose commands are run at quick depth: all, or one of them where NULLSCOPE_RUN numbers the runs.
LONG_PAGES = ["tutorial.md", "command-line.md"]
QUICKLY_RUN = LONG_PAGES if "NULLSCOPE_RUN" not in os.environ else LONG_PAGES[int(os.environ["NULLSCOPE_RUN"]) % 2:][:1]
COMMAND = re.compile(r"(?:build/release/bin/)?nullscope(?:-viewer)? ")


def short(path):
    return str(path.relative_to(ROOT))


@functools.cache
def blocks(page):
    """[(kind, text), ...]: "sh" and the like for fenced blocks, "" for indented ones, "text" for all between."""
    found, kind, lines = [], "text", []

    def end(next_kind):
        nonlocal kind, lines
        if lines:
            found.append((kind, "\n".join(lines)))
        kind, lines = next_kind, []

    fenced = False
    for line in page.read_text().splitlines():
        if line.lstrip().startswith("```"):
            fenced = not fenced
            end(line.strip()[3:] or "none" if fenced else "text")
        elif fenced:
            lines.append(line)
        else:
            indented = "" if line.startswith("    ") and not line.lstrip().startswith(("- ", "* ")) else "text"
            if indented != kind and line.strip():
                end(indented)
            lines.append(line[4:] if kind == "" else line)
    end("text")
    return found


def prose(page):
    return "\n".join(text for kind, text in blocks(page) if kind == "text")


def slugs(page):
    """What GitHub calls a page's headings, which is what mkdocs calls them too, or the test says which it does not."""
    names = set()
    for heading in re.findall(r"^#{1,6} (.*)$", prose(page), re.M):
        github = re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-")
        mkdocs = re.sub(r"[-\s]+", "-", re.sub(r"[^\w\s-]", "", heading).strip().lower())
        if github == mkdocs:
            names.add(github)
    return names


def faulty_links(page):
    for target in re.findall(r"\]\(([^)\s]+)\)|src=\"([^\"]+)\"", re.sub(r"`[^`]*`", "", prose(page))):
        target = target[0] or target[1]
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (page.parent / path).resolve() if path else page
        if not file.exists():
            yield f"{page.name}: no file {target}"
        elif anchor and anchor not in slugs(file):
            yield f"{page.name}: no heading {target}"


def command_lines(page):
    """Of all blocks, without what follows them in a pipe."""
    for kind, text in blocks(page):
        if kind not in ("sh", ""):
            continue
        for line in text.replace("\\\n", " ").splitlines():
            if COMMAND.match(line):
                words = shlex.split(line, comments=True)
                end = min([i for i, word in enumerate(words) if re.match(r"[|<>;&]|[12]>", word)], default=len(words))
                yield line, [Path(words[0]).name, *words[1:end]]


def scripts_of(page):
    """What is run of a page, one after the other."""
    for kind, text in blocks(page):
        if kind == "sh":
            yield text
        elif kind == "":
            yield from (line for line in text.splitlines()
                        if (COMMAND.match(line) or line.startswith(("printf ", "mkdir "))) and " bench " not in line)


def small_program(binary):
    """A nullscope that draws small pictures and short sequences; and a viewer that only reads what it is told to open."""
    return f"""#!{sys.executable}
import os, re, subprocess, sys
binary, words = {str(binary)!r}, sys.argv[1:]
own, ffmpeg = (words[:words.index("--")], words[words.index("--"):]) if "--" in words else (words, [])
if {"viewer" in binary.name}:
    scenes = [word for word in own if not word.startswith("-")][:1]
    sys.exit(subprocess.run([{str(binary.parent / "nullscope")!r}, "plan", *scenes], stdout=subprocess.DEVNULL).returncode if scenes else 0)
if own[:1] in (["capture"], ["lightcurve"], ["profile"], ["visibility"]) and "--image" not in own or "--measure" in own[1:2]:
    if "--size" in own:
        at = own.index("--size") + 1
        sides = [int(side) for side in own[at].split("x")]
        own[at] = "x".join(str(max(2, side * 64 // max(max(sides), 64))) for side in sides)
    elif "--dump-shader" not in own:
        own += ["--size", "64x36"]
    name = own[own.index("-o") + 1] if "-o" in own else ""
    if "--frames" in own:
        at = own.index("--frames") + 1
        first, last = map(int, own[at].split(":"))
        own[at] = f"{{first}}:{{min(last, first + 2)}}"
    elif re.search(r"%0?\\d*d|#|\\.(mp4|mov|mkv|webm)$", name):
        own += ["--frames", "0:2"]
os.execv(binary, [binary, *own, *ffmpeg])
"""


class Docs(support.CliTest):
    maxDiff = None

    def test_links_and_anchors(self):
        self.assertGreater(len(PAGES), 25)
        self.assertEqual([fault for page in PAGES for fault in faulty_links(page)], [])

    def test_a_broken_link_is_found(self):
        self.write("page.md", "# A\n\n[a](#a) [b](#b) [c](none.md) `[d](none.md)`\n")
        self.assertEqual(list(faulty_links(self.folder / "page.md")), ["page.md: no heading #b", "page.md: no file none.md"])

    def test_places_in_the_code_exist(self):
        lost = set()
        for page in PAGES:
            to_write = re.findall(r"^New file `([^`]+)`", prose(page), re.M)   # of recipes
            for place in re.findall(r"`((?:src|shaders|tests|scripts|web|assets|packaging|third_party|docs)/[\w./-]+)`", prose(page)):
                if not (ROOT / place).exists() and place not in to_write and "NAME" not in place:
                    lost.add(f"{short(page)}: {place}")
        self.assertEqual(sorted(lost), [])

    def test_every_figure_is_shown_and_can_be_drawn_again(self):
        drawn = "\n".join(script.read_text() for script in DRAWN_BY)
        commands = "\n".join(line for page in PAGES for line, _ in command_lines(page))
        shown = {(page.parent / target).resolve() for page in PAGES
                 for target in re.findall(r"!\[[^]]*\]\(([^)\s]+)\)", prose(page))}
        for figure in sorted(path for path in (ROOT / "docs").rglob("*") if path.suffix in PICTURES):
            with self.subTest(short(figure)):
                self.assertIn(figure, shown, "no page shows it")
                name = str(figure.relative_to(ROOT / "docs"))
                self.assertTrue(re.search(rf"\b{re.escape(name)}\b", drawn) or f"docs/{name}" in commands, "no script or command draws it")

    def test_the_menu_has_every_page(self):
        menu = (ROOT / "mkdocs.yml").read_text()
        listed = set(re.findall(r": ([\w./-]+\.md)$", menu, re.M))
        pages = {str(page.relative_to(ROOT / "docs")) for page in PAGES if (ROOT / "docs") in page.parents}
        self.assertEqual(pages - listed, set(), "in no menu of mkdocs.yml")
        self.assertEqual(listed - pages, {"CONTRIBUTING.md", "CHANGELOG.md", "versions.md"})

    def test_the_command_line_page_has_every_option(self):
        page = (ROOT / "docs" / "command-line.md").read_text()
        lost, count = [], 0
        for command in re.findall(r"^  (\S+) ", self.run_nullscope("--help").out.partition("Subcommands:\n")[2], re.M):
            text = self.run_nullscope(command, "--help").out
            for sub in re.findall(r"^  (\S+) ", text.partition("Subcommands:\n")[2], re.M):
                text += self.run_nullscope(command, sub, "--help").out
            options = set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", text, re.M)) - {"--help", "--output"}
            lost += [f"{command} {option}" for option in sorted(options) if not re.search(rf"(?<![\w-]){option}(?![\w-])", page)]
            count += len(options)
        self.assertEqual(lost, [])
        self.assertGreater(count, 60)

    @functools.cache
    def help_of(self, *command):
        program = Path(support.BINARY).parent / command[0]
        return subprocess.run([program, *command[1:], "--help"], capture_output=True, text=True, check=True, timeout=support.LONGEST_S).stdout

    def test_options_in_commands_exist(self):
        count = 0
        for page in PAGES:
            for line, words in command_lines(page):
                if not (Path(support.BINARY).parent / words[0]).exists():
                    continue   # built without the viewer
                command, rest = [words[0]], words[1:]
                while rest and re.search(rf"^  {re.escape(rest[0])} ", self.help_of(*command).partition("Subcommands:\n")[2], re.M):
                    command.append(rest.pop(0))
                for option in rest[:rest.index("--")] if "--" in rest else rest:
                    if re.match(r"--?[a-z]", option) and command[-1] != "help":
                        with self.subTest(f"{short(page)}: {line}"):
                            self.assertRegex(self.help_of(*command) + "--version --credits", rf"(?<![\w-]){re.escape(option)}(?![\w-])")
                count += 1
        self.assertGreater(count, 60)

    def test_commands_run(self):
        if shutil.which("ffmpeg") is None and not support.QUICK:
            self.fail("ffmpeg is missing: scripts/install-packages.sh --all installs it")
        programs = self.folder / "programs"
        programs.mkdir()
        for name in ("nullscope", "nullscope-viewer"):
            (programs / name).write_text(small_program(Path(support.BINARY).with_name(name)))
            (programs / name).chmod(0o755)
        environment = {**os.environ, "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}", "NULLSCOPE_ASSETS": str(ROOT / "assets")}
        for page in PAGES:
            if support.QUICK and page.name not in QUICKLY_RUN:
                continue
            place = self.folder / short(page).replace("/", "-")
            place.mkdir()
            (place / "galactic.png").write_bytes(png(64, 32, (b"\0" + b"\x40\x80\xc0" * 64) * 32))   # what a reader brings
            for script in scripts_of(page):
                if shutil.which("ffmpeg") is None and re.search(r"\.(mp4|mov)\b", script):
                    script = "\n".join(line for line in script.splitlines() if not re.search(r"\.(mp4|mov)\b", line))
                with self.subTest(f"{short(page)}:\n{script}"):
                    script = re.sub(r"^build/release/bin/", "", script, flags=re.M)
                    done = subprocess.run(["sh", "-ec", script], cwd=place, env=environment, capture_output=True, text=True, timeout=support.LONGEST_S)
                    self.assertEqual(done.returncode, 0, done.stderr)
            if page.name == "command-line.md":
                json.loads((place / "bench.json").read_text())

    def test_the_site_is_built_without_a_warning(self):
        if support.QUICK:
            self.skipTest("with --all")
        done = subprocess.run([ROOT / "scripts/docs.sh"], capture_output=True, text=True, timeout=support.LONGEST_S)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        site = ROOT / "build/site"
        text = (site / "index.html").read_text()
        self.assertIn('href="tutorial.html"', text)
        scripts = set(re.findall(r'<script src="([^"]+)"', re.sub(r"<!--.*?-->", "", text, flags=re.S)))
        lost = {script for script in scripts if not (site / script).exists()}   # one of another server is none of the site
        self.assertLessEqual(lost, {"js/theme_extra.js"})   # which Debian's theme lacks, and which only adds a class to tables


if __name__ == "__main__":
    support.main()
