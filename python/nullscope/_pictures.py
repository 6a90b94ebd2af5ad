"""Pictures and the ray data of frames."""
from typing import NamedTuple

import numpy as np

from . import _core
from ._rays import Progress
from ._scenes import SceneLike
from ._scenes import scene as _scene

Size = tuple[int, int] | str | None

# docs/ray-data.md, "Channels of a frame". A field is found by either name: rays["g"] is rays["ray.shift"].
RAYDATA = np.dtype([("fate", "f8"), ("sky.x", "f8"), ("sky.y", "f8"), ("sky.z", "f8"), (("ray.shift", "g"), "f8"), ("delay", "f8"),
                    ("angle", "f8"), ("order", "f8"), ("hit", "f8"), (("ray.hit_u", "u"), "f8"), (("ray.hit_v", "v"), "f8"),
                    (("ray.hit_w", "w"), "f8")])


class Polarisation(NamedTuple):
    """What observers measure of a picture's linear polarisation (docs/light.md)."""
    net: float        # |sum of Q + iU| over the sum of I, [0, 1]
    resolved: float   # sum of |Q + iU| over the sum of I, [0, 1]
    beta_2: complex   # sum of (Q + iU) e^(-2i phi) over the sum of I, phi about the line of sight


class Band(NamedTuple):
    """One of several frequencies at which matter is seen (medium.frequency = [86, 230], docs/matter.md)."""
    frequency: float            # GHz
    light: np.ndarray           # brightness temperature in 1e9 K, float32, shape (height, width)
    stokes: np.ndarray | None   # I, Q, U, V likewise, shape (height, width, 4), of polarised light; angles as Picture.stokes
    jansky: float | None        # Jy a pixel of light 1, where the object's mass and distance and the picture's scale are known


class Picture(np.ndarray):
    """Linear light, Rec. 709, float32, shape (height, width, 3), top row first; notebooks show it as a display would.

    An array like any other; what is computed from it is one too, with the same scene.
    """
    scene = None   # that it is of: its exposure, bloom and tone curve
    options = ""   # of the command line, with which capture() drew it
    asked = {}     # the same as capture() has them
    # Of pictures as capture() drew them; None of what is computed or copied from one, of light that is not polarised, of the reference tracer, of the pair of a
    # [split] or stereo scene, and of pictures that are drawn in bands for their size:
    stokes: np.ndarray | None = None   # I, Q, U, V, float32, shape (height, width, 4): I the luminance, angles from the picture's right towards up; V is 0
    polarisation: Polarisation | None = None
    bands: tuple[Band, ...] = ()       # of matter seen at several frequencies, ascending, whatever of them the picture shows
    rotation_measure: np.ndarray | None = None   # of each pixel between polarised bands, rad/m^2, float32, shape (height, width)

    def __array_finalize__(self, source):
        self.scene = getattr(source, "scene", None)
        self.options = getattr(source, "options", "")
        self.asked = getattr(source, "asked", {})

    def __reduce__(self):
        return _picture, (self.view(np.ndarray), self.scene, self.options, self.asked, self.stokes, self.polarisation, self.bands,
                          self.rotation_measure)

    def display(self) -> np.ndarray:
        """Display-encoded (bloom, exposure, tone curve, sRGB): uint8, shape (height, width, 3)."""
        return _core.displayed(*self._shown())

    def png(self) -> bytes:
        """The bytes of a PNG file of display(), which holds the scene and the options of capture(): scene() opens it again.

        Viewers of panoramas read in it which part of the sphere an equirectangular picture of capture()'s size is."""
        return _core.png(*self._shown(), self.options, self.asked)

    def _shown(self):
        if self.scene is None or self.ndim != 3 or self.shape[2] != 3 or not self.size:
            raise _core.Error(f"an array of shape {self.shape} is no picture; allowed: (height, width, 3), of capture()")
        return self.scene, np.ascontiguousarray(self, dtype=np.float32).view(np.ndarray)

    def _repr_png_(self):
        return self.png() if self.ndim == 3 and self.shape[2] == 3 and self.size and self.scene is not None else None


def _picture(light, scene, options, asked, stokes=None, polarisation=None, bands=(), rotation_measure=None):
    picture = light.view(Picture)
    picture.scene, picture.options, picture.asked = scene, options, asked
    picture.stokes, picture.polarisation = stokes, polarisation
    picture.bands, picture.rotation_measure = tuple(bands), rotation_measure
    return picture


def _words(options):
    """The options of capture() as the command line has them."""
    frame = options["frame"]
    given = {**options, "frame": None, "context": None, "frames": None if frame is None else f"{frame}:{frame + 1}"}
    if options["renderer"] == "reference":
        given["method"] = None
    return " ".join(f"--{name.replace('_', '-')} {value}" for name, value in given.items() if value is not None)


def _options(size, **options):
    if size is not None and not isinstance(size, str):
        try:
            width, height = size
        except (TypeError, ValueError):
            raise _core.Error(f"size: {type(size).__name__} is no size; allowed: (width, height), px") from None
        size = f"{width}x{height}"
    return {"size": size, **options}


def capture(scene: SceneLike, size: Size = None, *, renderer: str = "gl", method: str = "auto", max_error: float | None = None,
            samples: int | None = None, time: float | None = None, frame: int | None = None, context: str = "auto",
            progress: Progress = None) -> Picture:
    """Draws a scene's picture: the numbers of the EXR that `nullscope capture` writes, bit for bit. Needs no display.

    size: (width, height), px; None: the scene's. renderer: "gl", the shader, or "reference", in double precision and slow. method,
    max_error (px), samples (a side of a pixel), time (r_s/c), context: as of the command. frame: of the scene's [path], from 0.
    Returns a Picture: float32, shape (height, width, 3), linear light. Of polarised light it has picture.stokes and picture.polarisation; the
    shader draws it two times more for these. Of matter seen at several frequencies it has picture.bands.
    The first picture of a thread opens an OpenGL context, which the next ones find; forget_session() closes it.
    """
    given = _scene(scene)
    options = _options(size, renderer=renderer, method=method, max_error=max_error, samples=samples, time=time, frame=frame, context=context)
    light, stokes, measures, bands, rotation = _core.capture(given, options, progress)
    bands = [Band(frequency, plane[:, :, 0], planes, jansky) for frequency, plane, planes, jansky in bands]
    return _picture(light, given, _words(options), options, stokes, measures and Polarisation(*measures), bands,
                    None if rotation is None else rotation[:, :, 0])


def raydata(scene: SceneLike, size: Size = None, *, renderer: str = "gl", method: str = "auto", max_error: float | None = None,
            time: float | None = None, frame: int | None = None, context: str = "auto", progress: Progress = None) -> np.ndarray:
    """Where the ray of each pixel ends: the channels of `nullscope capture --raydata` (docs/ray-data.md).

    Options as of capture(). Returns a structured array RAYDATA, shape (height, width), of float64.
    """
    values = _core.raydata(_scene(scene), _options(size, renderer=renderer, method=method, max_error=max_error, time=time, frame=frame,
                                                   context=context), progress)
    return values.view(RAYDATA)[:, :, 0]
