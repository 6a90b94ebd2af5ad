"""Pictures as images of ehtim, the imaging library of very-long-baseline interferometry."""
import math

import numpy as np

from . import _core
from ._pictures import Picture

_LUMINANCE = (0.2126, 0.7152, 0.0722)   # of Rec. 709


def to_ehtim(picture: Picture, *, ra: float | None = None, dec: float | None = None, frequency: float | None = None,
             mjd: int | None = None, flux: float | None = None, source: str | None = None, band: float | None = None):
    """A picture of capture() as an ehtim.image.Image: what ehtim's load_fits() makes of the picture's FITS file (docs/fits.md).

    The first row is north, the first column east, the pixel's size (psize, rad) that of the file; values are Jy a pixel where the only light
    is matter's at one frequency, else luminance. Where light is polarised it has the planes Q, U and V too, drawn again, position angles
    from north through east. ra: hours, [0, 24); dec: degrees, [-90, 90] (default: the object's place, or 0); frequency: Hz (default: the
    matter's, or 230e9); mjd: a whole day (default: ehtim's own); flux: Jy to which the sum of I is scaled; source: a name (default: the object's).
    band: GHz, one of picture.bands, which is needed where the picture shows several frequencies.
    Error: ehtim is missing, or the picture has no scale on the sky of Earth, is not as capture() drew it in shape, or is changed and polarised.
    """
    try:
        import ehtim.image
    except ImportError as missing:
        raise _core.Error(f"to_ehtim needs the package ehtim (pip install ehtim): {missing}") from missing
    planes, cards = _planes(picture, band)
    place = {"ra": _within("ra", ra, 0, 24, cards["CRVAL1"] / 15), "dec": _within("dec", dec, -90, 90, cards["CRVAL2"]),
             "rf": _within("frequency", frequency, 1, 1e20, cards.get("FREQ", 230e9))}
    if mjd is not None:
        place["mjd"] = int(_within("mjd", mjd, 0, 1e6, None))
    if flux is not None:
        total = planes["I"].sum()
        if not total > 0:
            raise _core.Error(f"flux: a picture whose light adds up to {total:g} cannot be scaled; allowed: above 0")
        planes = {name: plane * (_within("flux", flux, 1e-30, 1e30, None) / total) for name, plane in planes.items()}
    image = ehtim.image.Image(planes["I"], cards["CDELT2"] * math.pi / 180, place.pop("ra"), place.pop("dec"),
                              source=cards["OBJECT"] if source is None else source, **place)
    if "Q" in planes:
        image.add_qu(planes["Q"], planes["U"])
        image.add_v(planes["V"])
    return image


def to_ehtim_movie(pictures, hours, **place):
    """Pictures of capture(), each at its time, as an ehtim.movie.Movie, which ehtim observes with arrays as the source changes.

    hours: of each picture, ascending, from the beginning of the day mjd. place: as of to_ehtim(), the same for all; without ehtim's framedur,
    which stretches the times. A scene's time unit r_s/c is 9.8510e-6 s for each solar mass. Error: as to_ehtim(); fewer than two pictures, or
    of different sizes; times that do not grow.
    """
    pictures, hours = list(pictures), np.asarray(hours, dtype=float)
    if len(pictures) < 2 or hours.shape != (len(pictures),):
        raise _core.Error(f"hours: of shape {hours.shape} for {len(pictures)} pictures; allowed: one for each of two or more")
    if not (np.isfinite(hours).all() and (np.diff(hours) > 0).all()):
        raise _core.Error("hours: they do not grow, or are not finite; allowed: ascending ones")
    images = [to_ehtim(picture, **place) for picture in pictures]
    for image, hour in zip(images, hours):
        if (image.xdim, image.ydim, image.psize) != (images[0].xdim, images[0].ydim, images[0].psize):
            raise _core.Error("pictures: of different sizes; allowed: all of one view")
        image.time = float(hour)
    import ehtim.movie
    return ehtim.movie.merge_im_list(images)


def _planes(picture, band):
    if not isinstance(picture, Picture) or picture.scene is None:
        raise _core.Error(f"picture: {type(picture).__name__} is no picture; allowed: what capture() returned")
    cards = _core.on_sky(picture.scene, picture.asked)
    if not str(cards.get("CTYPE1", "")).startswith("RA--"):
        raise _core.Error("picture: it has no scale on the sky of Earth; allowed: what docs/fits.md says of 'Coordinates'")
    if band is not None or getattr(picture, "bands", None):
        return _band_planes(picture, band, cards)
    light = np.asarray(picture, dtype=float)
    if light.shape != (cards["HEIGHT"], cards["WIDTH"], 3):
        raise _core.Error(f"picture: an array of shape {light.shape}; allowed: the whole picture, ({cards['HEIGHT']}, {cards['WIDTH']}, 3)")
    unit = cards.get("LUMINANC", 1.0)
    intensity = unit * (light @ _LUMINANCE)
    stokes = unit * _core.stokes(picture.scene, picture.asked, None).astype(float)
    if not stokes.size:
        return {"I": cards["JANSKY"] * light[:, :, cards["CHANNEL"]] if "JANSKY" in cards else intensity}, cards
    if not np.allclose(stokes[:, :, 0], intensity, rtol=1e-4, atol=1e-5 * intensity.max()):
        raise _core.Error("picture: its light is polarised and not as capture() drew it; allowed: unchanged, scaled by flux=")
    return {"I": stokes[:, :, 0], "Q": -stokes[:, :, 1], "U": -stokes[:, :, 2], "V": stokes[:, :, 3]}, cards


def _band_planes(picture, band, cards):
    frequencies = [one.frequency for one in picture.bands]
    if band not in frequencies:
        raise _core.Error(f"band: {band!r} is none of the picture's frequencies; allowed: {', '.join(f'{each:g}' for each in frequencies) or 'None'}")
    one = picture.bands[frequencies.index(band)]
    unit = one.jansky if one.jansky is not None else 1.0
    cards = {**cards, "FREQ": 1e9 * one.frequency, **({"JANSKY": one.jansky} if one.jansky is not None else {})}
    if one.stokes is None:
        return {"I": unit * one.light.astype(float)}, cards
    stokes = unit * one.stokes.astype(float)
    return {"I": stokes[:, :, 0], "Q": -stokes[:, :, 1], "U": -stokes[:, :, 2], "V": stokes[:, :, 3]}, cards


def _within(name, value, least, most, otherwise):
    if value is None:
        return otherwise
    if isinstance(value, bool) or not isinstance(value, (int, float, np.integer, np.floating)) or not least <= value <= most:
        raise _core.Error(f"{name}: {value!r} is out of range; allowed: a number from {least:g} to {most:g}")
    return float(value)
