"""Black holes and other curved spacetimes: pictures and light rays of measured accuracy.

Units are those of scene files' results: lengths in Schwarzschild radii r_s, times in r_s/c, angles in rad, c = 1. A scene is given
as the name of one that ships (scenes()), the path of a file, the text of one, or a dict of its sections. Bad input raises Error, a
ValueError, with the one line that the command line would print. Long calls release the interpreter's lock, can be interrupted, and
call progress(done, total) some 20 times a second if it is given. A tutorial: docs/python.md.
"""
from pathlib import Path as _Path

from . import _core
from ._core import Error, Observer, Scene, Spacetime, Worldline, __version__, forget_session, scenes
from ._ehtim import to_ehtim, to_ehtim_movie
from ._fits import Fit, Likelihood, fit, likelihood
from ._pictures import RAYDATA, Band, Picture, Polarisation, capture, raydata
from ._rays import Fate, deflection, fate_name, gradient, trace, trace_curves, worldline
from ._scenes import scene
from ._telescope import observe, visibility

__all__ = ["RAYDATA", "Band", "Error", "Fate", "Fit", "Likelihood", "Observer", "Picture", "Polarisation", "Scene", "Spacetime", "Worldline", "__version__", "capture",
           "deflection", "fate_name", "fit", "forget_session", "gradient", "likelihood", "observe", "raydata", "scene", "scenes", "to_ehtim", "to_ehtim_movie", "trace", "trace_curves", "visibility",
           "worldline"]

_assets = _Path(__file__).resolve().parent / "assets"
if _assets.is_dir():
    _core.ship_assets(str(_assets))
