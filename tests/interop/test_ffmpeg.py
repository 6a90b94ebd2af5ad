"""ffmpeg, the system's and a new one: sequences of EXR become films as bright as the pictures, and nullscope's films are read as tagged.

The options are those that docs/vfx.md gives for a sequence of EXR. The system's ffmpeg is Debian's package; the new one is imageio-ffmpeg's.
"""
import re
import shutil
import subprocess

import imageio_ffmpeg
import numpy as np

import support

WIDTH, HEIGHT = 64, 36
# Of films of EXR: codec and other options in place of docs/vfx.md's -> largest mean and 99.9th percentile, of 255. The first two keep the bound that
# films are asked for; the others, whose colours are coarser, are measured.
FILMS = {("ffv1", ()): (1, 8), ("libx264rgb", ()): (1, 8), ("libx264", ()): (9, 80), ("libx264", (("yuv420p", "yuv444p"), ("16", "1"))): (2, 12)}
SCENES = [line.split()[0] for line in support.nullscope("scenes", folder=support.ROOT).splitlines() if line.strip()]


def programs():
    """Name -> program of each."""
    found = {}
    for path in (shutil.which("ffmpeg"), imageio_ffmpeg.get_ffmpeg_exe()):
        if path:
            version = subprocess.run([path, "-version"], capture_output=True, text=True, check=True).stdout
            found[re.search(r"version n?(\d+\.\d+)", version)[1]] = path
    return found


def ran(*arguments):
    done = subprocess.run([*map(str, arguments)], capture_output=True)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, arguments))}: {done.stderr.decode()[-400:]}")
    return done.stdout


def frame_of(program, path, options=()):
    """The first frame, as 8 bits a colour; without these flags colours of films are a step or two too dark."""
    raw = ran(program, "-v", "error", "-i", path, *options, "-frames:v", "1", "-sws_flags", "accurate_rnd+full_chroma_int+full_chroma_inp", "-f", "rawvideo", "-pix_fmt", "rgb24", "-")
    return np.frombuffer(raw, dtype=np.uint8).reshape(-1, WIDTH, 3).astype(float)


def documented(codec, others):
    """The options of docs/vfx.md for a film of this codec. others: (word, what is put in its place)."""
    (words,) = re.findall(rf"^ffmpeg .*-i shot-%05d\.exr (-vf \S+ -c:v {codec}\b.*) \S+$", (support.ROOT / "docs" / "vfx.md").read_text(), re.M)
    for old, new in others:
        words, count = re.subn(rf"(?<=[ =]){old}\b", new, words)
        if count != 1:
            raise AssertionError(f"{words}: {count} times {old}")
    return words.split()


def sequences(report, folder):
    """Of every scene that ships, as one picture: docs/vfx.md's films of its EXR against its PNG."""
    found = {(version, film): [] for version in programs() for film in FILMS}
    for scene in SCENES:
        shot = ("capture", scene, "--size", f"{WIDTH}x{HEIGHT}")
        support.nullscope(*shot, "--colour", "display", "-o", "one.exr", folder=folder)
        support.nullscope(*shot, "-o", "one.png", folder=folder)
        if support.exr(folder / "one.exr")["R"].shape != (HEIGHT, WIDTH):
            continue   # both eyes, or a cube
        for version, path in programs().items():
            meant = frame_of(path, folder / "one.png")
            for film in FILMS:
                ran(path, "-v", "error", "-y", "-i", folder / "one.exr", *documented(*film), folder / "one.mkv")
                off = np.abs(frame_of(path, folder / "one.mkv") - meant)
                found[version, film].append((off.mean(), np.percentile(off, 99.9), scene))
    for (version, film), rows in found.items():
        name = f"ffmpeg {version}, {' '.join((film[0], *(new for _, new in film[1])))}"
        report.add(f"{name}: EXR of {len(rows)} scenes against their PNG, worst mean ({max(rows)[2]})", max(rows)[0], FILMS[film][0], "of 255 ")
        worst = max(rows, key=lambda row: row[1])
        report.add(f"{name}: the same, worst 99.9th percentile ({worst[2]})", worst[1], FILMS[film][1], "of 255 ")
    report.add("scenes that were left out", len(SCENES) - len(found[next(iter(found))]), 3)


def films(report, folder):
    """Films of every container: the mean colour is that of the PNG of the same frame, where they are lossless every one; and they are tagged."""
    (folder / "smooth.toml").write_text('[camera]\nr = 20\n[sky]\nkind = "formula"\nformula = "0.5 + 0.5*x*y"\n'
                                        'colour = [0.9, 0.3, 0.1]\nsecond_colour = [0.05, 0.2, 0.6]\n')
    shot = ("capture", "smooth.toml", "--size", f"{WIDTH}x{HEIGHT}", "--time-step", "1", "--frames", "0:2", "-o")
    support.nullscope(*shot, "f-%d.png", folder=folder)
    for ending in ("mp4", "mov", "mkv", "webm"):
        support.nullscope(*shot, "f." + ending, folder=folder)
        for version, path in programs().items():
            off = frame_of(path, folder / ("f." + ending)) - frame_of(path, folder / "f-0.png")
            report.add(f"ffmpeg {version}: {ending} against PNG, largest mean of a colour", float(np.abs(off.mean(axis=(0, 1))).max()), 1, "of 255 ")
            if ending == "mkv":
                report.add(f"ffmpeg {version}: {ending} against PNG, largest difference", float(np.abs(off).max()), 0, "of 255 ")
            told = subprocess.run([path, "-i", folder / ("f." + ending)], capture_output=True, text=True).stderr
            report.add(f"ffmpeg {version}: {ending} without its colours' tags", int("bt709" not in told and "iec61966" not in told), 0)


def spheres(report, folder):
    """Films of the sphere say so, in every container and of both eyes, and their pictures stay what they are."""
    for eyes, words in ((None, ""), ("top and bottom", 'stereo = "all-round"\n')):
        (folder / "round.toml").write_text(f'[camera]\nr = 20\nprojection = "equirectangular"\nsize = [{WIDTH}, {WIDTH // 2}]\n{words}[sky]\nkind = "formula"\nformula = "0.5 + 0.5*x*y"\n')
        shot = ("capture", "round.toml", "--time-step", "1", "--frames", "0:2", "-o")
        support.nullscope(*shot, "r-%d.png", folder=folder)
        for ending in ("mp4", "mov", "mkv", "webm"):
            support.nullscope(*shot, "r." + ending, folder=folder)
            for version, path in programs().items():
                told = subprocess.run([path, "-i", folder / ("r." + ending)], capture_output=True, text=True).stderr
                report.add(f"ffmpeg {version}: {ending} is no sphere", int(not re.search(r"spherical( mapping)?: equirectangular", told, re.I)), 0)
                report.add(f"ffmpeg {version}: {ending}, eyes: not {eyes}", int(bool(re.search(f"stereo ?3d: .*{eyes or ''}", told, re.I)) != bool(eyes)), 0)
                off = np.abs(frame_of(path, folder / ("r." + ending)) - frame_of(path, folder / "r-0.png")).mean()
                report.add(f"ffmpeg {version}: {ending} against PNG, mean difference", float(off), 0 if ending == "mkv" else 1.5, "of 255 ")


if __name__ == "__main__":
    support.main("ffmpeg", sequences, films, spheres)
