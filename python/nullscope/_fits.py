"""Which scene made these data: fits, and likelihoods for samplers."""
import io
import json
import os
from collections.abc import Mapping, Sequence

import numpy as np

from . import _core
from ._rays import Progress
from ._scenes import SceneLike
from ._scenes import scene as _scene

Free = str | Mapping[str, tuple[float, float]]   # "spin=0:0.99,camera.theta=10:80", or {"spin": (0, 0.99), ...}
_LUMINANCE = np.array([0.2126, 0.7152, 0.0722])   # Rec. 709


def _free_words(free):
    if isinstance(free, str):
        return free
    try:
        return ",".join(f"{key}={float(low)!r}:{float(high)!r}" for key, (low, high) in free.items())
    except (AttributeError, TypeError, ValueError):
        raise _core.Error("free: no ranges; allowed: text as of --free, or a dict of keys to (low, high)") from None


def _sigma_words(sigma):
    if sigma is None:
        return ""
    return os.fspath(sigma) if isinstance(sigma, (str, os.PathLike)) else repr(float(sigma))


def _plane(name, values, shape=None):
    try:
        plane = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise _core.Error(f"{name}: no array of numbers; allowed: (height, width), or (height, width, 3)") from None
    if plane.ndim == 3 and plane.shape[2] == 3:
        plane = plane @ _LUMINANCE
    if plane.ndim != 2 or not plane.size or (shape and plane.shape != shape):
        raise _core.Error(f"{name}: an array of shape {plane.shape}; allowed: {shape or '(height, width), or (height, width, 3)'}")
    return np.ascontiguousarray(plane)


def _picture(data, sigma, mask):
    """Light and its standard deviations, 0 where a pixel does not count."""
    light = _plane("data", data)
    counts = np.ones(light.shape, bool) if mask is None else _plane("mask", mask, light.shape) > 0.5
    try:
        if sigma is None:
            raise TypeError
        share = isinstance(sigma, str) and sigma.endswith("%")
        deviation = np.broadcast_to(float(sigma[:-1]) / 100 * np.nanmax(light) if share else np.asarray(sigma, dtype=float), light.shape)
    except (TypeError, ValueError):
        raise _core.Error(f"sigma: {sigma!r:.40}; allowed: a number, \"3%\" of the brightest pixel, or an array of shape {light.shape}") from None
    if not counts.any() or not np.isfinite(light[counts]).all() or not (np.isfinite(deviation[counts]) & (deviation[counts] > 0)).all():
        raise _core.Error("data, sigma: pixels that are not finite, or whose deviation is not above 0; allowed: such numbers, or a mask without these pixels")
    return {"light": np.where(counts, light, 0.0), "deviation": np.where(counts, deviation, 0.0)}


def _table(data, sigma):
    """The text of a CSV file of columns, with a column noise where sigma is an array."""
    columns = {str(key): np.atleast_1d(data[key]) for key in (data.dtype.names if isinstance(data, np.ndarray) else data.keys())}
    if sigma is not None and not isinstance(sigma, str) and np.ndim(sigma):
        unit = "_jy" if any(key.endswith("_jy") for key in columns) else ""
        columns["noise" + unit], sigma = np.asarray(sigma, dtype=float), None
    if len({len(column) for column in columns.values()}) != 1:
        raise _core.Error("data: columns of other lengths; allowed: one length")
    text = io.StringIO()
    text.write(",".join(columns) + "\n")
    for row in zip(*(column.tolist() for column in columns.values())):
        text.write(",".join(value if isinstance(value, str) else repr(value) for value in row) + "\n")
    return {"table": text.getvalue(), "sigma": _sigma_words(sigma)}


def _sources(data, sigma, mask):
    if isinstance(data, (str, os.PathLike)):
        if not (mask is None or isinstance(mask, (str, os.PathLike))) or np.ndim(sigma):
            raise _core.Error("sigma, mask: arrays; allowed: with a file a number, words as of --sigma, or a file")
        return {"data": os.fspath(data), "sigma": _sigma_words(sigma), "mask": "" if mask is None else os.fspath(mask)}
    if hasattr(data, "keys") or getattr(getattr(data, "dtype", None), "names", None):
        if mask is not None:
            raise _core.Error("mask: a table has no pixels; allowed: with a picture")
        return {"data": "data", **_table(data, sigma)}
    return {"data": "data", **_picture(data, sigma, mask)}


def _asked(data, free, sigma, mask, nuisance, samples, context):
    nuisance = nuisance if isinstance(nuisance, str) else ",".join(nuisance)
    return {**_sources(data, sigma, mask), "free": _free_words(free), "nuisance": nuisance, "samples": samples, "context": context}


class Likelihood:
    """ln of the likelihood of data as a function of a scene's free numbers, with its gradient; likelihood() makes it.

    Called with values, in the units of scene files and the order of `keys`, it returns a number, as emcee and dynesty want; -inf outside of `bounds` and
    where no such scene can be. Can be pickled, and used in any thread, one call at a time.
    """

    def __init__(self, scene, asked, around):
        self._made = scene, asked, around
        self._core = _core.likelihood(scene, asked, around)
        self.keys: tuple[str, ...] = tuple(self._core.keys)   # "spacetime.spin", nuisances last
        self.bounds = np.array(self._core.bounds)             # of each, shape (n, 2)

    def __reduce__(self):
        return Likelihood, self._made

    def __call__(self, values: Sequence[float]) -> float:
        """ln L = -chi^2/2 - sum of ln(sigma sqrt(2 pi)); with nuisance "flux" the largest of any flux. One prediction."""
        return self._core.at(_values(values), False)[0]

    def value_and_gradient(self, values: Sequence[float]) -> tuple[float, np.ndarray]:
        """ln L, and its derivative by each value; zeros where it is -inf. 1 + 2 n predictions."""
        return self._core.at(_values(values), True)

    def gradient(self, values: Sequence[float]) -> np.ndarray:
        """The derivative of ln L by each value."""
        return self.value_and_gradient(values)[1]

    def predict(self, values: Sequence[float]) -> np.ndarray:
        """What the scene of these values has in the place of each of `data`, without noise."""
        return self._core.predict(_values(values))

    def derivatives(self, values: Sequence[float]) -> np.ndarray:
        """Derivatives of predict() by each value, shape (n, data): D @ (D / sigma**2).T is the Fisher matrix."""
        return self._core.derivatives(_values(values))

    def prior_transform(self, unit: Sequence[float]) -> np.ndarray:
        """Values from numbers in [0, 1]: a prior that is uniform within the bounds, as dynesty wants it."""
        low, high = self.bounds.T
        return low + np.asarray(unit, dtype=float) * (high - low)

    @property
    def data(self) -> np.ndarray:
        """The data that are compared, one after the other: of visibilities real and imaginary part of each."""
        return self._core.data()

    @property
    def sigma(self) -> np.ndarray:
        """The standard deviation of each."""
        return self._core.sigma()


def _values(values):
    try:
        return np.asarray(values, dtype=float).ravel().tolist()
    except (TypeError, ValueError):
        raise _core.Error("values: no numbers; allowed: one for each of keys") from None


def likelihood(data, scene: SceneLike, free: Free, *, sigma=None, mask=None, nuisance: str | Sequence[str] = "", samples: int = 4,
               around: Sequence[float] | None = None, context: str = "auto") -> Likelihood:
    """The likelihood of data, by scenes whose numbers are free, with the gradient that fits have.

    data: a file, as of `nullscope fit` (picture or CSV); a dict (or DataFrame, or structured array) of the columns of such a table; or a picture,
    shape (height, width) or (height, width, 3). free: "spin=0:0.99,camera.theta=10:80" or {"spin": (0, 0.99)}. sigma: standard deviation, a
    number, "3%" of the largest, or of arrays an array; mask: pixels above one half count. nuisance: of centre, roll, flux. samples: N x N rays
    a pixel. around: values where steps of differences are chosen (default: the middle of the ranges). docs/fit.md
    """
    return Likelihood(_scene(scene), _asked(data, free, sigma, mask, nuisance, samples, context), [] if around is None else _values(around))


class Fit:
    """What fit() found."""

    def __init__(self, found, scene, given, asked):
        self.json: dict = found                                             # all of `nullscope fit --json`, with all digits
        self.scene: _core.Scene = scene                                     # the best
        parameters = found["parameters"]
        self.keys: tuple[str, ...] = tuple(one["key"] for one in parameters)
        self.values = np.array([one["best"] for one in parameters])         # in the units of scene files
        self.sigma = np.array([np.nan if one["sigma"] is None else one["sigma"] for one in parameters])   # nan: not determined
        self.covariance: np.ndarray | None = None if found["covariance"] is None else np.array(found["covariance"])
        self.flux: float = found["flux"]
        self.chi2: float = found["chi2"]
        self.degrees: int = found["degrees_of_freedom"]
        self.probability: float = found["probability"]                      # of such a chi^2 by noise alone
        self.describes_the_data: bool = found["describes_the_data"]         # where not, there are no errors
        self.samples: int | None = found["samples"]                         # rays along a side of a pixel that it took
        self._given, self._asked = given, asked

    def __repr__(self):
        words = ", ".join(f"{key} {value:.6g} +- {sigma:.2g}" for key, value, sigma in zip(self.keys, self.values, self.sigma))
        return f"<nullscope.Fit {words}; chi^2 {self.chi2:.5g} of {self.degrees}>"

    def likelihood(self) -> Likelihood:
        """Of the same data, as finely drawn as the fit was, with steps for its best values."""
        asked = {**self._asked, "samples": self.samples or 4}
        return Likelihood(self._given, asked, self.values.tolist())

    def corner(self, samples=None, **options):
        """A corner plot, a matplotlib Figure: of samples, shape (many, n), as samplers give them; default: of the normal distribution of the covariance.

        Lines are the best values. options: those of corner.corner(). Error: corner is not installed; no samples and no covariance.
        """
        try:
            import corner
        except ImportError:
            raise _core.Error("corner: the package corner is not installed; allowed: pip install corner") from None
        if samples is None:
            if self.covariance is None:
                raise _core.Error("corner: this fit has no errors; allowed: samples")
            samples = np.random.default_rng(1).multivariate_normal(self.values, self.covariance, 20000)
        return corner.corner(np.asarray(samples), **{"labels": list(self.keys), "truths": self.values, "quantiles": (0.16, 0.5, 0.84), **options})


def fit(data, scene: SceneLike, free: Free, *, sigma=None, mask=None, nuisance: str | Sequence[str] = "", loss: str = "huber", starts: int = 4,
        seed: int | None = None, samples: int | None = None, context: str = "auto", progress: Progress = None) -> Fit:
    """The numbers of a scene that describe data best, with their errors: `nullscope fit`. Arguments as of likelihood() and of the command.

    Unlike the command it returns where no such scene describes the data: describes_the_data is False then, sigma nan, covariance None.
    """
    given, asked = _scene(scene), _asked(data, free, sigma, mask, nuisance, samples, context)
    found, best = _core.fit(given, {**asked, "loss": loss, "starts": starts, "seed": seed}, progress)
    return Fit(json.loads(found), best, given, asked)
