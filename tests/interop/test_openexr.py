"""OpenEXR's own library: what nullscope writes is whole, and what that library writes arrives."""
import numpy as np
import OpenEXR

import support

PROGRAM = f"OpenEXR {OpenEXR.__version__}"


def written(report, folder):
    """Layers, ray data and plain pictures: kinds, names, windows, texts; the picture is the same in each."""
    pictures = {}
    for name, options in {"plain": (), "layers": ("--layers",), "rays": ("--raydata",), "half": ("--half",)}.items():
        support.nullscope("capture", "kerr", "--size", "96x54", *options, "-o", name + ".exr", folder=folder)
        with OpenEXR.File(str(folder / (name + ".exr")), separate_channels=True) as file:
            channels, header = file.channels(), file.header()
            pictures[name] = np.stack([channels[c].pixels.astype(np.float32) for c in "RGB"])
            kind = np.float16 if name == "half" else np.float32
            report.add(f"{name}: channels of another kind", sum(channel.pixels.dtype != kind for channel in channels.values()), 0)
            window = [tuple(map(int, corner)) for corner in header["dataWindow"]]
            report.add(f"{name}: its window is another", int(window != [(0, 0), (95, 53)]), 0)
            report.add(f"{name}: words without the scene", int("nullscope.scene" not in header), 0)
            report.add(f"{name}: values that are not finite", sum(int((~np.isfinite(channel.pixels)).sum()) for channel in channels.values()), 0)
    for name in ("layers", "rays"):
        report.same_bits(f"{name}: the picture beside the data", pictures[name], pictures["plain"])
    off = np.abs(pictures["half"] - pictures["plain"]) / np.maximum(pictures["plain"], 2 ** -14)
    report.add("half: relative rounding", float(off.max()), 2 ** -11)


def read(report, folder):
    """A panorama of each compression, half and float, as a sky: the same picture. As nullscope's test of this kind by its own writer."""
    kinds = {name.removesuffix("_COMPRESSION"): getattr(OpenEXR, name) for name in
             ("NO_COMPRESSION", "RLE_COMPRESSION", "ZIPS_COMPRESSION", "ZIP_COMPRESSION", "PIZ_COMPRESSION")}
    x, y = np.meshgrid(np.linspace(0, 6, 256), np.linspace(0, 3, 128))
    light = {c: (np.exp2(np.round(4 * np.sin((i + 1) * x) * np.sin(y))) * (1 + i / 4)).astype(np.float16) for i, c in enumerate("RGB")}
    (folder / "sky.toml").write_text('[camera]\nr = 20\nsize = [64, 36]\n[sky]\nkind = "image"\nimage = "sky.exr"\n')
    first, differing = None, 0
    for kind in (np.float16, np.float32):
        for compression in kinds.values():
            with OpenEXR.File({"compression": compression, "type": OpenEXR.scanlineimage}, {c: rows.astype(kind) for c, rows in light.items()}) as file:
                file.write(str(folder / "sky.exr"))
            support.nullscope("capture", "sky.toml", "-o", "seen.exr", folder=folder)
            seen = np.stack([support.exr(folder / "seen.exr")[c] for c in "RGB"])
            first = seen if first is None else first
            differing += int((seen != first).sum())
    report.add(f"skies of {len(kinds)} compressions, half and float: values of the picture that differ", differing, 0)
    report.add("and that are all the same", int(np.ptp(first) == 0), 0)


if __name__ == "__main__":
    support.main(PROGRAM, written, read)
