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
    """PNG of 8 and 16 bits, TIFF and JPEG are one picture, each as exact as it can be."""
    names, steps = {"eight.png": (), "sixteen.png": ("--bits", "16"), "wide.tiff": ()}, {}
    for name, options in names.items():
        support.nullscope("capture", "first-light", "--size", "96x54", *options, "-o", name, folder=folder)   # without dithering
        _, steps[name] = pixels(folder / name)
    deep = steps["sixteen.png"][:, :, :3]
    for name in ("eight.png", "wide.tiff"):
        off = np.abs(steps[name][:, :, :3] - deep)
        report.add(f"{name} against 16 bits: largest difference", float(off.max() * 255), 1, "of 255 ")
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


if __name__ == "__main__":
    support.main(PROGRAM, colours, other_formats, as_sky)
