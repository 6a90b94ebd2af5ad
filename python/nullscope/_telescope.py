"""What telescopes see of pictures: visibilities, and observations by ehtim."""
import csv
from pathlib import Path

import numpy as np

from . import _core
from ._ehtim import _planes, to_ehtim
from ._pictures import Picture


def visibility(picture: Picture, u, v, *, pixel: str = "point", stokes: bool = False, band: float | None = None) -> np.ndarray:
    """Visibilities of a picture of capture() at (u, v), wavelengths: numbers or arrays of one shape.

    V = sum of I e^(2 pi i (u l + v m)), l to the east and m to the north from the picture's middle, rad: the sign of ehtim. pixel: what stands for a
    pixel's light, "point", "square" or "triangle", which is ehtim's own. In Jy where the only light is matter's at one frequency, else
    fractions of the whole light. Returns complex128 of the shape of u; with stokes those of I, Q, U, V as a last axis of 4, angles from north
    through east; 0 where light is not polarised. band: GHz, as to_ehtim's. A sum over all pixels for each: 0.1 ms for 256 x 256 on a core.
    Error: the picture has no scale on the sky of Earth, is changed and polarised, or is dark; numbers that are not finite.
    """
    u, v = (np.asarray(waves, dtype=float) for waves in (u, v))
    if u.shape != v.shape or not (np.isfinite(u).all() and np.isfinite(v).all()):
        raise _core.Error(f"u, v: arrays of shape {u.shape} and {v.shape}, or numbers that are not finite; allowed: finite ones of one shape")
    planes, cards = _planes(picture, band)
    light = np.ascontiguousarray(np.stack(list(planes.values()), axis=-1), dtype=float)
    whole = light[:, :, 0].sum()
    if not whole > 0:
        raise _core.Error(f"picture: its light adds up to {whole:g}; allowed: above 0")
    found = _core.visibilities(light if "JANSKY" in cards else light / whole, np.radians(cards["CDELT2"]), u.ravel(), v.ravel(), pixel)
    return found.reshape((*u.shape, 4)) if stokes else found[:, 0].reshape(u.shape)


def observe(picture: Picture, array: str | Path = "eht-2017", *, hours: tuple[float, float, float] = (0, 24, 1 / 6), elevation: float = 10,
            bandwidth: float = 2e9, integration: float = 60, noise: int | None = None, **place):
    """A picture of capture() as an ehtim.obsdata.Obsdata: ehtim's own observation of to_ehtim(picture, **place), with which its other tools go on.

    array: stations that ship ("eht-2017"), or the path of a table of stations on Earth (docs/telescope.md). hours: from, to, step of
    Greenwich sidereal time; elevation: least, degrees; bandwidth, Hz, integration, s, and noise, a seed, of thermal noise (default: none).
    Error: ehtim is missing; the table has other columns or stations in space; as to_ehtim().
    """
    image = to_ehtim(picture, **place)
    import ehtim.array
    import ehtim.const_def

    with open(_table(array), encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    stations = np.zeros(len(rows), dtype=ehtim.const_def.DTARR)
    for to, row in zip(stations, rows):
        try:
            to["site"], sefd = row["station"], float(row["sefd_jy"])
            to["x"], to["y"], to["z"] = (float(row[name]) for name in ("x_m", "y_m", "z_m"))
        except (KeyError, TypeError, ValueError) as wrong:
            raise _core.Error(f"array: {array}: {wrong!r}; allowed: station, x_m, y_m, z_m, sefd_jy of stations on Earth") from None
        to["sefdr"] = to["sefdl"] = sefd
    begin, end, step = hours
    return image.observe(ehtim.array.Array(stations), integration, 3600 * step, begin, end, bandwidth, timetype="GMST", elevmin=elevation,
                         elevmax=90, ttype="direct", add_th_noise=noise is not None, ampcal=True, phasecal=True, seed=noise or False,
                         verbose=False)


def _table(array):
    shipped = Path(_core.assets()) / "telescopes" / f"{array}.csv"
    path = shipped if shipped.is_file() else Path(array)
    if not path.is_file():
        raise _core.Error(f"array: {array}: there is no such array; allowed: {', '.join(sorted(p.stem for p in shipped.parent.glob('*.csv')))}, or a file")
    return path
