"""Fits and likelihoods from Python: the command's numbers, gradients against differences of finer pictures, errors."""
import json
import pickle
import re
import sys
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np
import nullscope as ns

import support

sys.path.insert(0, str(support.ROOT / "tests" / "cli"))
import fit_data

FREE = {"spin": (0, 0.99), "camera.theta": (10, 80)}
TRUE = list(fit_data.TRUE.values())


def scene(side):
    return ns.scene(fit_data.SCENE % (side, side))


def drawn(side, samples=5, signal_to_noise=30, seed=1):
    """A picture by the reference with noise, and its standard deviation."""
    light = np.asarray(ns.capture(scene(side), renderer="reference", samples=samples), dtype=float) @ [0.2126, 0.7152, 0.0722]
    sigma = light.max() / signal_to_noise
    return light + np.random.default_rng(seed).normal(0, sigma, light.shape), sigma


class Fits(unittest.TestCase):
    def test_the_command_finds_the_same(self):
        data, sigma = drawn(24)
        found = ns.fit(data, scene(24), FREE, sigma=sigma, starts=1)
        self.assertEqual(found.keys, ("spacetime.spin", "camera.theta"))
        self.assertTrue(found.describes_the_data)
        self.assertTrue((np.abs(found.values - TRUE) < 4 * found.sigma).all(), found)
        np.testing.assert_allclose(np.sqrt(np.diag(found.covariance)), found.sigma)
        self.assertAlmostEqual(float(re.search(r"theta = (\S+)", found.scene.text)[1]), found.values[1], places=8)
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "data.fits").write_bytes(fit_data.fits(data.tolist()))
            Path(folder, "scene.toml").write_text(fit_data.SCENE % (24, 24))
            said = support.command_line("fit", f"{folder}/data.fits", f"{folder}/scene.toml", "--free", "spin=0:0.99,camera.theta=10:80", "--sigma", repr(float(sigma)),
                                        "--starts", "1", "--json")
            again = ns.fit(f"{folder}/data.fits", scene(24), FREE, sigma=float(sigma), starts=1)
        # FITS files have floats of 32 bits in the scene's unit; the array is luminance: of this scene the same numbers.
        for fit in (found, again):
            np.testing.assert_allclose(fit.values, [one["best"] for one in json.loads(said)["parameters"]], rtol=1e-3)
        self.assertEqual(again.json.keys(), json.loads(said).keys())
        np.testing.assert_allclose(again.covariance, json.loads(said)["covariance"], rtol=1e-5)

    def test_a_likelihood_is_of_normal_errors(self):
        data, sigma = drawn(16)
        like = ns.likelihood(data, scene(16), FREE, sigma=sigma)
        self.assertEqual(like.bounds.tolist(), [[0, 0.99], [10, 80]])
        here = [0.6, 45.0]
        off = (like.data - like.predict(here)) / like.sigma
        self.assertAlmostEqual(like(here), float(-0.5 * off @ off - np.log(like.sigma * np.sqrt(2 * np.pi)).sum()), places=8)
        self.assertEqual(like([0.6, 81]), -np.inf)
        self.assertEqual(like.gradient([1.1, 45]).tolist(), [0, 0])
        self.assertEqual(like.prior_transform([0.5, 1]).tolist(), [0.495, 80])
        np.testing.assert_allclose(like.gradient(here), like.derivatives(here) @ (off / like.sigma))
        self.assertEqual(pickle.loads(pickle.dumps(like))(here), like(here))
        elsewhere = []
        worker = threading.Thread(target=lambda: elsewhere.append(like(here)))
        worker.start(), worker.join()
        self.assertEqual(elsewhere, [like(here)])
        ns.capture("first-light", (16, 9))   # in the same context
        self.assertEqual(elsewhere, [like(here)])

    def test_a_mask_and_a_free_flux(self):
        data, sigma = drawn(16)
        counts = np.ones_like(data)
        counts[:4] = 0
        spoiled = np.where(counts > 0, 3 * data, np.nan)
        like = ns.likelihood(spoiled, scene(16), FREE, sigma=3 * sigma, mask=counts, nuisance="flux")
        self.assertEqual(len(like.data), 12 * 16)
        prediction = like.predict(TRUE)
        off = (like.data - prediction) / like.sigma
        self.assertLess(abs(off @ prediction), 1e-9 * abs(prediction @ prediction))   # no scale is better
        self.assertLess(off @ off, 12 * 16 + 5 * np.sqrt(2 * 12 * 16))

    def test_derivatives_of_few_rays_are_those_of_many(self):
        """Lengths of the derivative by the spin, of 128 x 128 pixels at a signal to noise of 30: docs/fit.md has the numbers that this prints."""
        data, sigma = drawn(128, samples=3)
        few, many = (ns.likelihood(data, scene(128), FREE, sigma=sigma, samples=n, around=TRUE) for n in (4, 16))
        half = 10 / np.linalg.norm(few.derivatives(TRUE)[0] / sigma)   # of the spin: as far as few goes, src/fit/problem.h
        exact = (many.predict([0.7 + half, 50]) - many.predict([0.7 - half, 50])) / (2 * half)
        found = few.derivatives(TRUE)[0]
        short = 0.05 * half
        grainy = (few.predict([0.7 + short, 50]) - few.predict([0.7 - short, 50])) / (2 * short)
        off, far = (abs(np.linalg.norm(a) / np.linalg.norm(exact) - 1) for a in (found, grainy))
        along = found @ exact / (np.linalg.norm(found) * np.linalg.norm(exact))
        print(f"derivative by the spin, by differences of {half:.2g} to either side: length off by {100 * off:.2f} %, direction by {np.degrees(np.arccos(along)):.1f} degrees; of {short:.2g} length off by {100 * far:.1f} %")
        self.assertLess(off, 0.01)
        self.assertGreater(far, 5 * off)

    def test_visibilities_and_a_line_by_columns(self):
        disc = ns.scene(scene(32), object={"name": "m87"})
        u = np.linspace(1e9, 8e9, 12)
        seen = ns.visibility(ns.capture(disc, (64, 64), samples=3), u, 0 * u, pixel="square")
        like = ns.likelihood({"u": u, "v": 0 * u, "real": seen.real, "imaginary": seen.imag}, disc, FREE, sigma=0.01)
        self.assertEqual(len(like.data), 24)
        self.assertLess(np.abs(like.predict(TRUE) - like.data).max(), 0.01)
        self.assertLess(like(TRUE) - like.sigma.size * np.log(100 / np.sqrt(2 * np.pi)), 0)
        edges = np.linspace(0.2, 1.4, 13)
        columns = {"g_from": edges[:-1], "g_to": edges[1:], "photons": np.full(12, 1 / 12)}
        line = ns.likelihood(columns, disc, {"camera.theta": (30, 70)}, sigma=np.full(12, 0.01))
        self.assertAlmostEqual(line.predict([50]).sum(), 1, delta=0.02)

    def test_what_cannot_be(self):
        blob = np.exp(-((np.arange(16) - 7.5) ** 2)[:, None] / 10 - ((np.arange(16) - 7.5) ** 2) / 10)
        found = ns.fit(blob, scene(16), FREE, sigma="2%", nuisance=["flux"], starts=1)
        self.assertFalse(found.describes_the_data)
        self.assertIsNone(found.covariance)
        self.assertTrue(np.isnan(found.sigma).all())
        with self.assertRaisesRegex(ns.Error, "no errors"):
            found.corner()

    def test_errors(self):
        data = np.ones((8, 8))
        for words, call in {"no ranges": lambda: ns.likelihood(data, scene(8), {"spin": 3}, sigma=1),
                            "unknown key": lambda: ns.likelihood(data, scene(8), "camera.tehta=1:2", sigma=1),
                            "sigma: None": lambda: ns.likelihood(data, scene(8), FREE),
                            "sigma: array": lambda: ns.likelihood(data, scene(8), FREE, sigma=np.ones(3)),
                            "sigma: '3 %%'": lambda: ns.likelihood(data, scene(8), FREE, sigma="3 %%"),
                            "with a file": lambda: ns.likelihood("data.fits", scene(8), FREE, sigma=1, mask=data),
                            "shape": lambda: ns.likelihood(data[0], scene(8), FREE, sigma=1),
                            "not finite": lambda: ns.likelihood(data * np.nan, scene(8), FREE, sigma=1),
                            "above 0": lambda: ns.likelihood(data, scene(8), FREE, sigma=0.0),
                            "data:1: noise": lambda: ns.likelihood({"u": [1e9], "v": [0.0], "amplitude": [1.0]}, scene(8), FREE),
                            "other lengths": lambda: ns.likelihood({"u": [1e9], "v": []}, scene(8), FREE, sigma=1),
                            "around: 1": lambda: ns.likelihood(data, scene(8), FREE, sigma=1, around=[0.5]),
                            "values: 3": lambda: ns.likelihood(data, scene(8), FREE, sigma=1)([1, 2, 3]),
                            "loss": lambda: ns.fit(data, scene(8), FREE, sigma=1, loss="l1")}.items():
            with self.subTest(words), self.assertRaisesRegex(ns.Error, words):
                call()

    def test_a_corner_plot(self):
        data, sigma = drawn(16)
        found = ns.fit(data, scene(16), FREE, sigma=sigma, starts=1)
        import matplotlib
        matplotlib.use("Agg")
        self.assertEqual(len(found.corner().axes), 4)


if __name__ == "__main__":
    support.main()
