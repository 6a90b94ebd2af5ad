"""emcee, dynesty and NumPyro sample nullscope.likelihood(): the posterior is the fit's. NumPyro by the code of docs/fit.md. The environment has the
package nullscope too."""
import importlib.metadata
import re
import sys
from pathlib import Path

import dynesty
import emcee
import numpy as np

import nullscope as ns
import support

sys.path.insert(0, str(support.ROOT / "tests" / "cli"))
import fit_data

PROGRAM = ", ".join(f"{name} {importlib.metadata.version(name)}" for name in ("emcee", "dynesty", "numpyro"))


def data():
    """A picture with noise, its scene and standard deviation."""
    scene = ns.scene(fit_data.SCENE % (16, 16))
    light = np.asarray(ns.capture(scene, renderer="reference", samples=5), dtype=float) @ [0.2126, 0.7152, 0.0722]
    sigma = light.max() / 30
    return light + np.random.default_rng(1).normal(0, sigma, light.shape), scene, sigma


def compared(report, name, fit, samples, slack):
    mean, deviation = samples.mean(axis=0), samples.std(axis=0)
    report.add(f"{name}: mean less the fit's best values, its standard deviations", float(np.abs((mean - fit.values) / fit.sigma).max()), slack)
    report.add(f"{name}: standard deviation over the fit's, less 1", float(np.abs(deviation / fit.sigma - 1).max()), slack)


def samplers(report, folder):
    picture, scene, sigma = data()
    fit = ns.fit(picture, scene, {"spin": (0, 0.99), "camera.theta": (10, 80)}, sigma=sigma)
    like = fit.likelihood()
    random = np.random.default_rng(1)
    walkers = fit.values + fit.sigma * random.normal(size=(16, 2))
    np.random.seed(1)
    ensemble = emcee.EnsembleSampler(16, 2, like)
    ensemble.run_mcmc(walkers, 160)
    compared(report, "emcee", fit, ensemble.get_chain(discard=40, flat=True), 0.3)
    nested = dynesty.NestedSampler(like, like.prior_transform, 2, nlive=60, rstate=random)
    nested.run_nested(dlogz=0.5, print_progress=False)
    compared(report, "dynesty", fit, nested.results.samples_equal(rstate=random), 0.4)


def numpyro_of_the_page(report, folder):
    """The page's code, with this picture in the place of its own."""
    picture, scene, sigma = data()
    fit = ns.fit(picture, scene, {"spin": (0, 0.99), "camera.theta": (10, 80)}, sigma=sigma)
    (block,) = [code for code in re.findall(r"^```python\n(.*?)^```$", (support.ROOT / "docs" / "fit.md").read_text(), re.M | re.S) if "numpyro" in code]
    found = {"ns": ns, "np": np, "like": fit.likelihood(), "fit": fit}
    exec(block, found)
    compared(report, "NumPyro", fit, np.array(found["samples"]), 0.4)


if __name__ == "__main__":
    support.main(PROGRAM, samplers, numpyro_of_the_page)
