"""OpenImageIO: the colours of every file are the colours, layers keep their names, and what it writes arrives as sky."""
import numpy as np
import OpenImageIO as oiio

import support

PROGRAM = f"OpenImageIO {oiio.VERSION_STRING}"


def pixels(path):
    """(names of the channels, rows of pixels)."""
    image = oiio.ImageBuf(str(path))
    if image.has_error:
        raise AssertionError(image.geterror())
    return list(image.spec().channelnames), image.get_pixels(oiio.FLOAT)


def colours(report, folder):
    for name, options in {"plain": (), "layers": ("--layers",), "rays": ("--raydata",), "st": ("--st-map", "plate")}.items():
        support.nullscope("capture", "kerr-plunge", "--frames", "8:9", "--size", "96x54", *options, "-o", name + "-%d.exr", folder=folder)
        names, found = pixels(folder / (name + "-8.exr"))
        meant = support.exr(folder / (name + "-8.exr"))
        report.add(f"{name}: the first channels are not R, G, B", int([one.split(".")[-1] for one in names[:3]] != ["R", "G", "B"]), 0)
        report.add(f"{name}: names of {len(names)} that differ", len(set(names) ^ set(meant)), 0)
        report.same_bits(f"{name}: all channels", np.stack([found[:, :, i] for i in range(len(names))]), np.stack([meant[one] for one in names]))


def other_formats(report, folder):
    """PNG of 8 and 16 bits and TIFF are one picture, each as exact as it can be: half a step of 8 bits, and the shader's square roots."""
    names, steps = {"eight.png": (), "sixteen.png": ("--bits", "16"), "wide.tiff": ()}, {}
    for name, options in names.items():
        support.nullscope("capture", "first-light", "--size", "96x54", *options, "-o", name, folder=folder)   # without dithering
        _, steps[name] = pixels(folder / name)
    deep = steps["sixteen.png"][:, :, :3]
    for name in ("eight.png", "wide.tiff"):
        off = np.abs(steps[name][:, :, :3] - deep)
        report.add(f"{name} against 16 bits: largest difference", float(off.max() * 255), 0.6, "of 255 ")
    report.add("its light is one value", int(np.ptp(deep) == 0), 0)


def as_sky(report, folder):
    """EXR by OpenImageIO: tiled, prefixed, with a data window; nullscope's picture is that of the plain file."""
    x, y = np.meshgrid(np.linspace(0, 2 * np.pi, 256), np.linspace(0, np.pi, 128))
    light = np.stack([2 + np.sin(x) * np.sin(y), 2 + np.cos(x) * np.sin(y), 2 + np.cos(y)], axis=-1).astype(np.float32)
    specs = {"plain": oiio.ImageSpec(256, 128, 3, oiio.FLOAT), "tiles": oiio.ImageSpec(256, 128, 3, oiio.FLOAT),
             "prefix": oiio.ImageSpec(256, 128, 3, oiio.FLOAT), "window": oiio.ImageSpec(256, 128, 3, oiio.FLOAT)}
    specs["tiles"].tile_width = specs["tiles"].tile_height = 32
    specs["prefix"].channelnames = ("view.R", "view.G", "view.B")
    specs["window"].x = specs["window"].full_x = 17
    specs["window"].y = specs["window"].full_y = -9
    seen = {}
    for name, spec in specs.items():
        out = oiio.ImageOutput.create(str(folder / (name + ".exr")))
        if not out.open(str(folder / (name + ".exr")), spec) or not out.write_image(light):
            raise AssertionError(out.geterror())
        out.close()
        (folder / "sky.toml").write_text(f'[camera]\nr = 20\nsize = [64, 36]\n[sky]\nkind = "image"\nimage = "{name}.exr"\n')
        support.nullscope("capture", "sky.toml", "-o", "seen.exr", folder=folder)
        seen[name] = np.stack([support.exr(folder / "seen.exr")[c] for c in "RGB"])
    for name in ("tiles", "prefix", "window"):
        report.same_bits(f"a sky with {name}", seen[name], seen["plain"])


SMOOTH = np.stack([2 + np.sin(i + np.linspace(0, 2 * np.pi, 128)[None, :]) * np.sin(np.linspace(0, np.pi, 64))[:, None] for i in range(3)], axis=-1).astype(np.float32)
SCENES = {   # what an image is put on
    "sky": '[camera]\nr = 20\nsize = [48, 27]\n[sky]\nkind = "image"\nimage = "{0}"\n',
    "disc": '[camera]\nr = 20\ntheta = 60\nsize = [48, 27]\n[sky]\nkind = "black"\n[disc]\ntexture = "image"\nimage = "{0}"\n',
    "body": '[camera]\nr = 20\nsize = [48, 27]\n[sky]\nkind = "black"\n[ball]\nposition = [8, 0, 0]\nradius = 3\ntexture = "image"\nimage = "{0}"\n',
}


def drawn(folder, scene, name, layer=""):
    (folder / "scene.toml").write_text(SCENES[scene].format(name) + (f'image_layer = "{layer}"\n' if layer else ""))
    support.nullscope("capture", "scene.toml", "--quiet", "-o", "seen.exr", folder=folder)
    found = support.exr(folder / "seen.exr")
    return np.stack([found[c] for c in "RGB"])


def write(path, pixels, parts=(), **changes):
    """An EXR by OpenImageIO, of one part or several, with the attributes of `changes`."""
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], changes.pop("kind", oiio.FLOAT))
    for name, value in changes.items():
        if name in ("channelnames", "tile_width", "tile_height", "x", "y", "full_x", "full_y", "full_width", "full_height", "alpha_channel"):
            setattr(spec, name, value)
        else:
            spec.attribute(name, *value) if isinstance(value, tuple) else spec.attribute(name, value)
    out = oiio.ImageOutput.create(str(path))
    specs = [spec]
    for name in parts:
        specs.append(oiio.ImageSpec(spec))
        specs[-1].attribute("oiio:subimagename", name)
    if parts:
        spec.attribute("oiio:subimagename", "first")
    opened = out.open(str(path), specs) if parts else out.open(str(path), spec)
    for i in range(len(specs)):
        if i and not out.open(str(path), specs[i], "AppendSubimage") or not opened or not out.write_image(pixels * (1 if i == 0 else 0.25)):
            raise AssertionError(f"{path}: {out.geterror()}")
    out.close()


def exr_matrix(report, folder):
    """Every compression, half and float, tiles and lines, several parts, prefixes, windows, alpha: as sky, disc and body what OpenImageIO reads of the file."""
    clear = np.concatenate([SMOOTH, np.linspace(0, 1, 128, dtype=np.float32)[None, :, None].repeat(64, axis=0)], axis=-1)
    clear[:, :, :3] *= clear[:, :, 3:]   # associated
    cases = {}
    for compression in ("none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"):
        for kind, name in ((oiio.HALF, "half"), (oiio.FLOAT, "float")):
            for tiles in (0, 32):
                cases[f"{compression} {name} {'tiles' if tiles else 'lines'}"] = (SMOOTH, {"compression": compression, "kind": kind, "tile_width": tiles, "tile_height": tiles})
    for scene in ("sky", "disc", "body"):
        cases[f"alpha on {scene}"] = (clear, {"channelnames": ("R", "G", "B", "A"), "alpha_channel": 3})
        cases[f"two parts on {scene}"] = (SMOOTH, {"parts": ("second",)})
        cases[f"prefix on {scene}"] = (SMOOTH, {"channelnames": ("beauty.R", "beauty.G", "beauty.B")})
        cases[f"a window within the picture on {scene}"] = (SMOOTH[8:40, 16:80], {"x": 16, "y": 8, "full_width": 128, "full_height": 64})
        cases[f"a window beyond the picture on {scene}"] = (SMOOTH, {"x": -16, "y": -8, "full_width": 96, "full_height": 48})
    off = {}
    for number, (case, (pixels, changes)) in enumerate(cases.items()):
        scene = case.rsplit(" ", 1)[1] if " on " in case else ("sky", "disc", "body")[number % 3]
        write(folder / "case.exr", pixels, **changes)
        layer = "second" if "parts" in changes else ""
        read = oiio.ImageBuf(str(folder / "case.exr"), 1 if layer else 0, 0)
        spec = read.spec()
        whole = oiio.ROI(spec.full_x, spec.full_x + spec.full_width, spec.full_y, spec.full_y + spec.full_height, 0, 1, 0, spec.nchannels)
        light = read.get_pixels(oiio.FLOAT, whole)   # black where the file has nothing
        support.write_exr(folder / "plain.exr", {c: light[:, :, i] for i, c in enumerate("RGBA"[:light.shape[2]])})
        seen, meant = drawn(folder, scene, "case.exr", layer), drawn(folder, scene, "plain.exr")
        if np.ptp(meant) < (0.1 if layer else 0.3):
            raise AssertionError(f"{case}: nothing is seen")
        off[case] = float(np.abs(seen - meant).max())
    worst = max(off, key=off.get)
    report.add(f"EXR of {len(cases)} kinds on sky, disc and body, worst ({worst})", off[worst], 1e-6)


def primaries(report, folder):
    """Light that OpenColorIO, in OpenImageIO, has made ACEScg, in a file whose chromaticities say so, is the same light."""
    write(folder / "plain.exr", SMOOTH)
    aces = oiio.ImageBufAlgo.colorconvert(oiio.ImageBuf(str(folder / "plain.exr")), "lin_rec709", "ACEScg").get_pixels(oiio.FLOAT)
    ap1 = (0.713, 0.293, 0.165, 0.83, 0.128, 0.044, 0.32168, 0.33767)
    write(folder / "aces.exr", aces, chromaticities=("float[8]", ap1))
    meant = drawn(folder, "sky", "plain.exr")
    report.add("a sky in ACEScg, by its chromaticities: largest difference", float(np.abs(drawn(folder, "sky", "aces.exr") - meant).max()), 1e-5)
    write(folder / "unsaid.exr", aces)
    report.add("    without them it is another picture: not so", int(np.abs(drawn(folder, "sky", "unsaid.exr") - meant).max() < 0.01), 0)


def composited(report, folder):
    """A plate bent by st_plate where A hides nothing or part of it: at the edges of what covers the sky, too, the picture of that sky."""
    width, height, wide = 480, 270, 2 * float(np.tan(np.radians(50) / 2))
    formula = f"0.2 + 0.3*(0.5 - y/x/{wide!r}) + 0.4*(0.5 - z/x/{wide * height / width!r})"   # the camera looks along -x
    (folder / "s.toml").write_text(f'[camera]\nr = 20\ntheta = 90\nfov = 50\nsize = [{width}, {height}]\n[sky]\nkind = "formula"\nformula = "{formula}"\n'
                                   'colour = [1, 1, 1]\nsecond_colour = [0, 0, 0]\n[ball]\nposition = [8, 4, 1]\nradius = 2\n[picture]\nsamples = 4\n')
    support.nullscope("capture", "s.toml", "--layers", "-o", "s.exr", folder=folder)
    layers = support.exr(folder / "s.exr")
    s, t = np.meshgrid((np.arange(1920) + 0.5) / 1920, (np.arange(1080) + 0.5) / 1080)
    light = 0.2 + 0.3 * s + 0.4 * (1 - t)
    support.write_exr(folder / "plate.exr", {c: light for c in "RGB"})
    support.write_exr(folder / "st.exr", {"R": layers["st_plate.x"], "G": layers["st_plate.y"]})
    warped = oiio.ImageBufAlgo.st_warp(oiio.ImageBuf(str(folder / "plate.exr")), oiio.ImageBuf(str(folder / "st.exr")), "triangle", 0.0, 0, 1, False, True, oiio.ROI(0, width, 0, height, 0, 1, 0, 3))
    if warped.has_error:
        raise AssertionError(warped.geterror())
    bent = warped.get_pixels(oiio.FLOAT)[:, :, 0]
    a = layers["A"]
    result = layers["R"] - layers["sky.R"] + (1 - a) * bent
    known = layers["st_plate.z"] == 1
    inside = known & (np.abs(layers["st_plate.x"] - 0.5) < 0.49) & (np.abs(layers["st_plate.y"] - 0.5) < 0.49)
    cover = layers["bodies.A"]   # not the shadow's edge, where a pixel has all of the sky in it
    edges = inside & (cover > 0.02) & (cover < 0.98) & (a - cover < 1e-3)
    report.add(f"pixels of {edges.sum()} at edges that are fewer than", 100 - int(edges.sum()), 0)
    report.add(f"a plate by st_warp over {edges.sum()} edges of a ball, against nullscope's picture: largest difference", float(np.abs(result - layers["R"])[edges].max()), 2e-3)
    report.add("    and elsewhere, 99.9th percentile", float(np.percentile(np.abs(result - layers["R"])[inside & ~edges], 99.9)), 2e-3)


if __name__ == "__main__":
    support.main(PROGRAM, colours, other_formats, as_sky, exr_matrix, primaries, composited)
