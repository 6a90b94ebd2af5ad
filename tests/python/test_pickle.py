"""What is pickled comes back as an equal object: for worker processes, joblib, dask, and to keep."""
import concurrent.futures
import copy
import math
import multiprocessing
import os
import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np
import nullscope as ns

ANGLES = {"camera": {"r": 9.0, "theta": "1.151592972722763 rad", "yaw": "0.7287622212704526 rad", "roll": "1e-17 rad"}}   # of no number of degrees


def again(thing, protocol=pickle.DEFAULT_PROTOCOL):
    return pickle.loads(pickle.dumps(thing, protocol))


def drawn(scene, size):
    """In a worker process: the picture, its scene, and its PNG."""
    picture = ns.capture(scene, size)
    return picture, picture.scene, picture.png()


class Pickles(unittest.TestCase):
    def test_scenes(self):
        for given in (*ns.scenes(), ANGLES, {"name": "Ünï \"quoted\" \\"}, {"spacetime": {"metric": "formula", "A": "1 - 1/r"}}):
            scene = ns.scene(given)
            for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
                there = again(scene, protocol)
                self.assertEqual((there, there.text, hash(there)), (scene, scene.text, hash(scene)), given)
        self.assertNotEqual(again(ns.scene("kerr")), ns.scene("accretion"))
        self.assertEqual(copy.deepcopy(ns.scene("kerr")), ns.scene("kerr"))

    def test_every_number_is_exact(self):
        observer = ns.Observer(ANGLES)
        self.assertEqual(observer.theta, 1.151592972722763)
        for there in (again(observer), ns.Observer(again(ns.scene(ANGLES)))):
            self.assertEqual(there.theta, observer.theta)
            self.assertTrue(np.array_equal(there.tetrad, observer.tetrad))

    def test_files_are_found_from_another_folder(self):
        before = os.getcwd()
        with tempfile.TemporaryDirectory(prefix="nullscope-pickle-") as folder:
            try:
                os.chdir(folder)
                Path("plate.png").write_bytes(ns.capture("sky-only", (16, 8)).png())
                scene = ns.scene({"sky": {"kind": "image", "image": "plate.png"}})
                kept = pickle.dumps(scene)
                os.chdir(before)
                self.assertIn(folder, pickle.loads(kept).text)
            finally:
                os.chdir(before)
        with self.assertRaisesRegex(ns.Error, "pickled scene:.*there is no file"):
            pickle.loads(kept)

    def test_spacetimes(self):
        for made in (ns.Spacetime(), ns.Spacetime("kerr", spin=0.1 + 0.2), ns.Spacetime("formula", A="1 - 1/r", B="1/(1 - 1/r)"),
                     ns.Observer("wormhole").spacetime):
            there = again(made)
            self.assertEqual((there, there.name, hash(there)), (made, made.name, hash(made)))
            self.assertTrue(np.array_equal(there.metric(3.0), made.metric(3.0)))
        self.assertNotEqual(ns.Spacetime("kerr", spin=0.5), ns.Spacetime("kerr", spin=math.nextafter(0.5, 1)))
        self.assertEqual(len({ns.Spacetime("kerr", spin=0.5), ns.Spacetime("kerr", spin=0.5), ns.Spacetime()}), 2)

    def test_observers(self):
        for given in ("kerr", "plunge", "wormhole", "two-spacetimes", ANGLES, {"camera": {"observer": "rain", "r": 0.5}}):
            made = ns.Observer(given)
            there = again(made)
            self.assertEqual((there, hash(there), there.kind, there.spacetime), (made, hash(made), made.kind, made.spacetime))
            self.assertTrue(np.array_equal(there.tetrad, made.tetrad), given)
            self.assertTrue(all(map(np.array_equal, there.critical_curve(), made.critical_curve())), given)
        self.assertNotEqual(ns.Observer("kerr"), ns.Observer(ns.scene("kerr", camera={"r": 9.0})))
        self.assertEqual(ns.Observer("kerr"), ns.Observer(ns.scene("kerr", picture={"samples": 2})))   # which it has no use for

    def check_picture(self, there, made):
        self.assertIs(type(there), ns.Picture)
        self.assertEqual((there.scene, there.options, there.asked), (made.scene, made.options, made.asked))
        self.assertTrue(np.array_equal(there.view(np.uint32), made.view(np.uint32)))
        self.assertEqual(there.png(), made.png())

    def test_pictures(self):
        made = ns.capture("accretion", (64, 36), time=2.0, samples=2)
        self.assertEqual((made.asked["time"], made.options.count("--time 2.0"), made.scene), (2.0, 1, ns.scene("accretion")))
        for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
            self.check_picture(again(made, protocol), made)
        for copied in (copy.copy(made), copy.deepcopy(made), again(made[::2, ::-1])):
            self.check_picture(copied, made if copied.shape == made.shape else made[::2, ::-1])
        buffers = []
        kept = pickle.dumps(made, 5, buffer_callback=buffers.append)
        self.assertEqual([buffer.raw().nbytes for buffer in buffers], [made.nbytes])   # not copied
        self.check_picture(pickle.loads(kept, buffers=buffers), made)
        polarised = ns.capture("m87-swirl", (16, 9))
        there = again(polarised)
        self.assertTrue(np.array_equal(there.stokes, polarised.stokes))
        self.assertEqual(there.polarisation, polarised.polarisation)
        column = again(made[:, 0])
        self.assertEqual((column.shape, column.scene), ((36, 3), made.scene))

    def test_worker_processes(self):
        """Started by spawn: arguments, results and errors go through pickle."""
        scene = ns.scene("kerr", camera={"r": 8.0})
        with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
            picture, there, png = pool.submit(drawn, scene, (32, 18)).result()
            with self.assertRaisesRegex(ns.Error, "nope"):
                pool.submit(ns.scene, "nope").result()
        self.assertEqual(there, scene)
        self.check_picture(picture, ns.capture(scene, (32, 18)))
        self.assertEqual(png, picture.png())

    def test_what_is_no_pickle_of_ours(self):
        state = ns.scene("kerr").__getstate__()
        for wrong in (state.replace("[camera]", "[kamera]"), "a = [\n", ""):
            with self.subTest(wrong[:20]):
                empty = ns.Scene.__new__(ns.Scene)
                if wrong:
                    with self.assertRaisesRegex(ns.Error, "pickled scene"):
                        empty.__setstate__(wrong)
                else:
                    empty.__setstate__(wrong)
                    self.assertEqual(empty.size, ns.scene("\n").size)
        keys = [{"frame": i, "r": 20 + 1e-9 * i} for i in range(40000)]
        large = {"path": {"kind": "keys", "key": keys}}
        with self.assertRaisesRegex(ns.Error, "larger than 1048576 bytes|cannot be pickled"):
            pickle.dumps(ns.scene(large))


if __name__ == "__main__":   # which workers of test_worker_processes are not
    import support
    support.main()
