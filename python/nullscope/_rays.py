"""Lists of rays, worldlines: arrays in, arrays out."""
import enum
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from . import _core
from ._scenes import SceneLike
from ._scenes import scene as _scene

Progress = Callable[[int, int], object] | None   # called with what is done and what there is in all

_COLUMNS = ("r", "theta", "phi", "n_r", "n_theta", "n_phi", "frame", "q", "zeta0", "l0", "s", "at_angle", "alpha", "beta",
            "lambda", "eta", "up", "unit")
_NUMBERS = ("theta_inf", "phi_inf", "angle", "delay", "g", "turn", "at")
_CURVE = ("lambda", "r", "theta", "phi", "t", "r_rate", "theta_rate", "phi_rate", "t_rate")


class Fate(enum.IntEnum):
    """Where a ray ends, traced backward in time from the camera."""
    UNSUPPORTED = -1  # the shader cannot trace it
    LEFT_OUT = -1     # its name before, the same value
    ESCAPED = 0       # the sky
    CAPTURED = 1      # the horizon
    OTHER_SIDE = 2    # through a wormhole, the sky there
    NO_SKY = 3        # it never came from a sky
    HIT = 4           # an opaque object: field hit says which


def fate_name(scene: SceneLike, ray: np.void) -> str:
    """The word of `nullscope trace` for one row of what trace() gives: "escaped", "captured", ..., "hit:disc"."""
    try:
        fate, hit = Fate(int(ray["fate"])), int(ray["hit"])
    except (KeyError, IndexError, TypeError, ValueError):
        raise _core.Error("ray must be a row of the array that trace() returns; allowed: with fields fate and hit") from None
    return f"hit:{_core.object_name(_scene(scene), hit)}" if fate is Fate.HIT else fate.name.lower()


def _array(name, values):
    try:
        if name in ("frame", "unit"):
            return np.char.encode(np.asarray(values, dtype=np.str_), "ascii", "replace")
        return np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise _core.Error(f"{name}: no numbers; allowed: an array of numbers") from error


def _columns(rays):
    names = rays.dtype.names if isinstance(rays, np.ndarray) else list(rays) if isinstance(rays, Mapping) else None
    if not names:
        raise _core.Error("rays: no columns; allowed: a structured array, or a dict of arrays")
    found = {str(name): _array(name, rays[name]) for name in names if name in _COLUMNS}
    try:
        shape = np.broadcast_shapes(*(column.shape for column in found.values()))
    except ValueError as error:
        raise _core.Error("rays: columns of different lengths") from error
    if len(shape) > 1:
        raise _core.Error(f"rays: columns of {len(shape)} dimensions; allowed: one")
    count = shape[0] if shape else 1
    return {name: np.broadcast_to(column, (count,)) for name, column in found.items()}, count


def _check_whole(name, value, low, high):
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)):
        raise _core.Error(f"{name}: {type(value).__name__} is of another kind; allowed: a whole number from {low} to {high}")
    if not low <= value <= high:
        raise _core.Error(f"{name}: {value} is out of range; allowed: [{low}, {high}]")


def trace(scene: SceneLike, rays: np.ndarray | Mapping, with_: str = "reference", *, crossings: int = 0, method: str = "auto",
          context: str = "auto", progress: Progress = None) -> np.ndarray:
    """Traces light rays backward in time from where cameras are, as `nullscope trace` does (docs/ray-data.md).

    rays: a structured array, shape (n,), or a dict of arrays, shape (n,) or scalars. Columns r (r_s), theta, phi (rad) of the camera and
    n_r, n_theta, n_phi, the view direction in its local frame, optionally frame ("static" or "rain"); or alpha, beta (r_s, to
    the right of the centre and up, as an observer at infinity sees it), theta and optionally phi and unit ("r_s" or "M"); or lambda, eta, theta
    and optionally up; or, without rotation, q, zeta0 (l0 in
    wormholes) and s; optionally at_angle (rad; NaN where nothing is asked). Arrays of float64 are read where they are.
    with_: "reference" (double precision, closed forms), "core64" or "core32" (the shader's code as C++), "gl" (the shader itself).
    crossings: how many crossings of the equatorial plane to list.
    Returns a structured array, shape (n,): fate (see Fate), hit (see fate_name), theta_inf, phi_inf, angle (rad), delay (r_s/c), g, turn,
    at, then r_1, phi_1, ... (with a thermal disc g_1, ..., with a polarised one chi_1, p_1, ...: angle of the electric vector from the right
    towards up, rad, and polarised fraction). NaN where a value does not exist.
    """
    given = _scene(scene)
    columns, count = _columns(rays)
    _check_whole("crossings", crossings, 0, 1000)
    words = {"with_": with_, "method": method, "context": context}
    for name, word in words.items():
        if not isinstance(word, str):
            raise _core.Error(f"{name}: {type(word).__name__} is of another kind; allowed: text")
    each = _core.crossing_columns(given)
    fields = [("fate", "i4"), ("hit", "i4")] + [(name, "f8") for name in _NUMBERS]
    fields += [(f"{name}_{k}", "f8") for k in range(1, crossings + 1) for name in each]
    out = np.empty(count, dtype=fields)
    _core.trace(given, columns, out.view(np.uint8), with_, method, context, int(crossings), progress)
    return out


def gradient(scene: SceneLike, rays: np.ndarray | Mapping, parameters: Sequence[str], *, crossings: int = 0, progress: Progress = None) -> np.ndarray:
    """Derivatives of what trace() gives, as `nullscope trace --derivatives` writes them (docs/ray-data.md, "Derivatives").

    rays: as trace() takes them, of observers at rest. parameters: of "spin", "charge", "camera.r", ... (per rad, r_s or 1). crossings: of the disc's plane.
    Returns a structured array, shape (n,): state ("yes", "edge": within 0.1 px of the scene's camera from the critical curve or a rim, "lost": none), then
    for each parameter d_NAME.x, .y, .z (of the unit vector towards the sky), .g, .delay (r_s/c), .r_1, .phi_1 (and of a thermal disc .g_1), ... NaN where a value does not exist.
    Half a millisecond a ray. Errors: an unknown parameter (with those that are known), a metric without derivatives, a ray of a falling observer.
    """
    given = _scene(scene)
    columns, count = _columns(rays)
    _check_whole("crossings", crossings, 0, 1000)
    if isinstance(parameters, str) or not all(isinstance(name, str) for name in parameters):
        raise _core.Error("parameters: of another kind; allowed: a list of texts")
    names = _core.gradient_columns(given, list(parameters), int(crossings))
    values, states = np.empty((count, len(names))), np.empty(count, dtype=np.int32)
    _core.gradient(given, columns, list(parameters), int(crossings), values, states, progress)
    out = np.empty(count, dtype=[("state", "U4")] + [(name, "f8") for name in names])
    out["state"] = np.array(_core.gradient_states())[states] if count else ""
    for i, name in enumerate(names):
        out[name] = values[:, i]
    return out


def trace_curves(scene: SceneLike, rays: np.ndarray | Mapping, points: int = 200, *, far: float = 100.0, to_r: float | None = None, to_theta: float | None = None,
                 to_mino: float | None = None, progress: Progress = None) -> np.ndarray:
    """Light rays as curves of `points` points each, by the reference, as `nullscope trace --points` writes them (docs/ray-data.md, "Curves").

    rays: as trace() takes them. far: radius beyond which curves are left out, r_s (wormholes: the throat's radius).
    to_r, to_theta, to_mino: a curve ends where it first has this r (r_s; wormholes: l), polar angle (rad), or Mino's time after its first
    point (1/r_s), if it comes there.
    Returns a structured array, shape (n, points): lambda (affine parameter), r (r_s), theta, phi (rad), t (r_s/c) and their derivatives by
    lambda, r_rate, theta_rate, phi_rate, t_rate. NaN, and a warning, where a ray has no curve.
    """
    given = _scene(scene)
    columns, count = _columns(rays)
    _check_whole("points", points, 2, 100_000)
    if isinstance(far, bool) or not isinstance(far, (int, float, np.number)) or not 1e-3 <= far <= 1e9:
        raise _core.Error(f"far: {far} is no radius; allowed: a number from 0.001 to 1e9")
    if count * points > 50_000_000:
        raise _core.Error(f"{count} rays of {points} points are too many; allowed: 5e+07 points in all")
    ends = []
    for name, value, low, high in (("to_r", to_r, -1e9, 1e9), ("to_theta", to_theta, 0.0, np.pi), ("to_mino", to_mino, 1e-9, 1e9)):
        if value is not None and (isinstance(value, bool) or not isinstance(value, (int, float, np.number)) or not low <= value <= high):
            raise _core.Error(f"{name}: {value} is out of range; allowed: None, or a number from {low:.6g} to {high:.6g}")
        ends.append(None if value is None else float(value))
    out = np.empty((count, int(points), len(_CURVE)))
    _core.curves(given, columns, out, float(far), tuple(ends), progress)
    return out.view([(name, "f8") for name in _CURVE])[:, :, 0]


def deflection(spacetime: "_core.Spacetime | SceneLike", impact: np.ndarray | float, *,
               progress: Progress = None) -> np.ndarray | float:
    """The angle by which light from infinity is bent, rad, by the reference; NaN where it is captured.

    spacetime: a Spacetime without rotation, or a scene. impact: impact parameter, r_s (of wormholes: the throat's radius), shape (n,) or a
    number. Returns the same shape. Through a wormhole: the angle swept, less pi.
    """
    if not isinstance(spacetime, _core.Spacetime):
        spacetime = _core.spacetime_of(_scene(spacetime))
    given = _array("impact", impact)
    if given.ndim > 1:
        raise _core.Error(f"impact: {given.ndim} dimensions; allowed: a number, or one")
    found = _core.deflection(spacetime, np.atleast_1d(given), progress)
    return found if given.ndim else float(found[0])


def worldline(scene: SceneLike, duration: float, steps: int = 200) -> np.ndarray:
    """A scene's camera in free fall, at `steps` + 1 equal proper times from 0 to `duration` (r_s/c) or its end.

    Returns a structured array, shape (steps + 1,): tau, time (r_s/c), r (r_s), theta, phi (rad). phi keeps whole turns: it is continuous.
    About a hole, time is v - r of ingoing coordinates and phi, if it rotates, their azimuth, which stay finite at the horizon; where there is
    no hole, time is t. Observer.fall() has more.
    """
    _check_whole("steps", steps, 1, 10_000_000)
    line = _core.Observer(_scene(scene)).fall(duration)
    places = line.places(np.linspace(0.0, min(float(duration), line.last), steps + 1))
    return places.view([(name, "f8") for name in ("tau", "time", "r", "theta", "phi")])[:, 0]
