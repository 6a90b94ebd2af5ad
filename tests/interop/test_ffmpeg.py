"""ffmpeg, the system's and a new one: sequences of EXR become films as bright as the pictures, and nullscope's films are read as tagged.

The options are those that docs/command-line.md gives for a sequence of EXR. The system's ffmpeg is Debian's package; the new one is imageio-ffmpeg's.
"""
import re
import shutil
import subprocess

import imageio_ffmpeg
import numpy as np

import support

WIDTH, HEIGHT = 64, 36
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


def srgb(light):
    """Of 255."""
    light = np.clip(light, 0, 1)
    return 255 * np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


def displayed(curve):
    """The options of docs/command-line.md; curve: of a colour's light x, before sRGB."""
    text = (support.ROOT / "docs" / "command-line.md").read_text()
    colour = re.search(r"^C='(.*)'$", text, re.M)[1]
    filters = re.search(r'^ffmpeg .*-i f%05d\.exr -vf "(.*)" ', text, re.M)[1]
    if curve == "none":
        colour = colour.replace("1-exp(-p(X\\,Y))", "clip(p(X\\,Y)\\,0\\,1)")
    return "-vf", filters.replace("$C", colour)


# Of these keys of [picture], and others that change a displayed picture, only the tone curve "shoulder" is among ffmpeg's options of the docs.
OTHER_DISPLAY = re.compile(r"^(bloom|tone|auto_exposure|dither|scale_bar|ticks|exposure)\b|^\[split", re.M)


def sequences(report, folder):
    """Of every scene that ships, as one picture: what ffmpeg makes of its EXR against its light, and against its PNG where that has the plain curve."""
    found = {(version, what): [] for version in programs() for what in ("light", "PNG")}
    for scene in SCENES:
        support.nullscope("capture", scene, "--size", f"{WIDTH}x{HEIGHT}", "-o", "one.exr", folder=folder)
        channels = support.exr(folder / "one.exr")
        light = srgb(np.stack([channels[c] for c in "RGB"], axis=-1))
        if light.shape != (HEIGHT, WIDTH, 3):
            continue   # both eyes, or a cube
        plain = not OTHER_DISPLAY.search(support.nullscope("scenes", scene, folder=folder))
        if plain:
            support.nullscope("capture", scene, "--size", f"{WIDTH}x{HEIGHT}", "--plain", "-o", "one.png", folder=folder)
        for version, path in programs().items():
            for what, curve in (("light", "none"), *((("PNG", "shoulder"),) if plain else ())):
                meant = light if what == "light" else frame_of(path, folder / "one.png")
                off = np.abs(frame_of(path, folder / "one.exr", displayed(curve)) - meant)
                found[version, what].append((off.mean(), np.percentile(off, 99.9), scene))
    for (version, what), rows in found.items():
        report.add(f"ffmpeg {version}: EXR of {len(rows)} scenes against their {what}, worst mean ({max(rows)[2]})", max(rows)[0], 1, "of 255 ")
        worst = max(rows, key=lambda row: row[1])
        report.add(f"ffmpeg {version}: the same, worst 99.9th percentile ({worst[2]})", worst[1], 8, "of 255 ")
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


if __name__ == "__main__":
    support.main("ffmpeg", sequences, films)
