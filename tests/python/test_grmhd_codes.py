"""The converter of GRMHD files: one known flow in the layout of each code becomes the grid that is known."""
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

import grmhd_files as files
from grmhd_files import SPIN, TURN

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONVERTER = ROOT / "scripts" / "convert_grmhd.py"
PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 else None
UNIT = 1e-18     # g/cm^3
OPTIONS = ("--density-unit", UNIT, "--sigma-cut", 1e9)

AT_CELLS = 1e-6       # nodes at middles of cells: 32-bit numbers of file and grid (measured 2.5e-7)
BETWEEN = 0.02        # nodes elsewhere, of cells of 0.08 to 0.13 in ln r and theta: quadratic terms, an eighth of the step's square times second derivatives

BETWEEN_CUBES = 0.02  # of cubes of 0.1 to 0.25 r


def convert(*arguments):
    return subprocess.run([sys.executable, "-B", CONVERTER, *map(str, arguments)], capture_output=True, text=True)


def read(path):
    head, data = path.read_bytes().split(b"data\n", 1)
    lines = dict(line.split(" ", 1) for line in head.decode().splitlines())
    (r0, r1, nr), (t0, t1, nt), (p0, n) = (lines[key].split() for key in ("r", "theta", "phi"))
    r, theta, phi = np.geomspace(float(r0), float(r1), int(nr)), np.linspace(float(t0), float(t1), int(nt)), float(p0) + TURN * np.arange(int(n)) / int(n)
    return lines, 2 * r, theta, phi, np.frombuffer(data, "<f4").reshape(int(nr), int(nt), int(n), 8).astype(float)


class Codes(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="nullscope-codes-")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def known(self, name, path, *arguments, bound=BETWEEN, electrons="", silent=False, outer=12, spin=SPIN):
        """Converts, and compares all nodes with the flow: density and temperature relative to themselves, vectors to the largest at the same radius."""
        grid = self.folder / f"{name}.grid"
        done = convert(path, "-o", grid, *OPTIONS, "--outer", outer, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        if silent:
            self.assertEqual(done.stderr, "")
        lines, r, theta, phi, numbers = read(grid)
        self.assertAlmostEqual(float(lines["spin"]), abs(spin), places=12)
        flow = files.expected(r[:, None, None], (theta if spin >= 0 else math.pi - theta)[None, :, None], phi if spin >= 0 else -phi, spin, UNIT, electrons)
        if spin < 0:
            flow[..., [3, 4, 6, 7]] *= -1
        scale = np.abs(flow).copy()
        for first in (2, 5):
            scale[..., first:first + 3] = np.linalg.norm(flow[..., first:first + 3], axis=-1).max(axis=(1, 2))[:, None, None, None]
        error = np.abs(numbers - flow) / scale
        print(f"{name}: {' x '.join(map(str, numbers.shape[:3]))} nodes from {r[0]:.3f} M, largest errors {' '.join(f'{n:.1e}' for n in error.max(axis=(0, 1, 2)))}")
        self.assertLess(error.max(), bound, (name, np.unravel_index(error.argmax(), error.shape)))
        return numbers

    def outside(self, r_in, r_out, cells, a=SPIN):
        """How many middles of cells even in ln r are outside the horizon."""
        middles = r_in * (r_out / r_in) ** ((np.arange(cells) + 0.5) / cells)
        return int((middles >= 1.01 * (1 + math.sqrt(1 - a * a))).sum())

    def test_iharm3d_and_its_electrons(self):
        path = self.folder / "flow.h5"
        nodes = ("--nodes", self.outside(1.2, 60, 48), 32)
        files.write_iharm(path)
        self.known("iharm3d", path, *nodes, outer=100, bound=AT_CELLS, silent=True)
        for names in (("KEL", "KTOT"), ("KTOT", "KEL")):
            files.write_iharm(path, names=names)
            self.known("-".join(names), path, *nodes, outer=100, bound=AT_CELLS, electrons="entropy")
            self.known("-".join(names), path, *nodes, "--electrons", "r-high", outer=100, bound=AT_CELLS)

    def test_kharma_in_all_transforms(self):
        x1 = (0.18, 4.1)
        zero = 0.3
        charts = (("null", files.plain, "null", "", ((1.2, 40.0), (0, math.pi), (0, TURN)), (256, 32, 16)),
                  ("eks", files.eks, "exponential", "", (x1, (0, math.pi), (0, TURN)), None), ("mks", files.mks, "mks", "hslope = 0.3", None, None),
                  ("fmks", lambda x1, x2: files.fmks(x1, x2, zero=0.18), "funky", "", None, (32, 56, 16)),
                  ("fmks-zero", lambda x1, x2: files.fmks(x1, x2, zero=zero), "fmks", f"fmks_zero_point = {zero}", None, (32, 56, 16)),
                  ("superexp", files.superexp, "superexponential", "r_br = 10.0\nnpow = 2\ncpow = 0.4", ((0.18, 3.5), (0, math.pi), (0, TURN)), None),
                  ("widepole", files.widepole, "widepole", "smoothness = 0.1", None, None))
        for name, chart, word, more, domain, root in charts:
            with self.subTest(name):
                keys = {"domain": domain} if domain else {}
                path = self.folder / f"{name}.phdf"
                files.write_kharma(path, chart, word, more, root=root or (32, 32, 16), size=(16, 8, 8), **keys)
                self.known(name, path, "--nodes", 40, 30, 24)

    def test_kharma_in_all_versions_with_ghosts_and_as_a_restart(self):
        eks = {"chart": files.eks, "transform": "eks", "domain": ((0.18, 4.1), (0.0, math.pi), (0.0, TURN))}
        nodes = ("--nodes", self.outside(math.exp(0.18), math.exp(4.1), 32), 16, 16)
        path, grids = self.folder / "flow.phdf", []
        for version in (None, 2, 3, 4):
            files.write_kharma(path, **eks, version=version, ghosts=0 if version == 2 else 2)
            grids.append(self.known(f"version {version}", path, *nodes, outer=100, bound=AT_CELLS))
        files.write_kharma(path, **eks, restart=True, dtype="<f8")
        grids.append(self.known("rhdf", path, *nodes, outer=100, bound=AT_CELLS))
        for grid in grids[1:]:
            np.testing.assert_allclose(grid, grids[0], rtol=1e-4, atol=1e-5)
        files.write_kharma(path, **eks, kel=("Howes",))
        self.known("Kel_Howes", path, *nodes, outer=100, bound=AT_CELLS, electrons="entropy")
        files.write_kharma(path, **eks, kel=("Howes", "Werner"))
        self.known("Kel_Howes of two", path, *nodes, "--electrons", "Kel_Howes", outer=100, bound=AT_CELLS, electrons="entropy")
        self.refused(path, "--electrons Kel_Howes, Kel_Werner or r-high")

    def test_levels_meet_without_a_gap(self):
        """Also where a coarse block lies between the nodes' azimuths of a fine one, and all round."""
        def refined(level, middle):
            return level == 0 and abs(middle[1] - 0.5) < 0.3 and middle[0] < 2.4
        path = self.folder / "levels.phdf"
        files.write_kharma(path, lambda x1, x2: files.mks(x1, x2), "mks", root=(32, 32, 16), size=(8, 8, 8), refined=refined)
        fine = self.known("kharma, two levels", path, "--nodes", 90, 70, 64)
        files.write_athena(self.folder / "levels.athdf", root=(32, 16, 16), size=(8, 8, 8), refined=lambda level, middle: level == 0 and abs(middle[1] - 1.57) < 0.8)
        self.known("athena++, two levels", self.folder / "levels.athdf", *self.athena, "--nodes", 90, 70, 64)
        # No step from node to node is larger than the flow's own: 90 nodes in ln r and 64 azimuths.
        for axis, most in ((0, 0.08), (2, 0.04)):
            self.assertLess(np.abs(np.diff(np.log(fine[..., 0]), axis=axis)).max(), most)

    athena = ("--spin", SPIN, "--adiabatic-index", files.GAMMA, "--code-mass", 1)

    def test_athena(self):
        nodes = ("--nodes", self.outside(1.25, 60, 48), 32)
        for name, keys in (("plain", {}), ("ghosts", {"ghosts": 2}), ("doubles", {"real": ">f8"})):
            path = self.folder / f"{name}.athdf"
            files.write_athena(path, **keys)
            self.known(f"athena++ {name}", path, *self.athena, *nodes, outer=100, bound=AT_CELLS)
        path = self.folder / "mass.athdf"
        files.write_athena(path, m=3.0)
        self.known("athena++ mass", path, "--spin", SPIN, "--adiabatic-index", files.GAMMA, "--code-mass", 3, *nodes, outer=100, bound=AT_CELLS)
        for number, (option, value) in enumerate(zip(self.athena[::2], self.athena[1::2])):
            rest = [each for n in range(3) if n != number for each in self.athena[2 * n:2 * n + 2]]
            self.refused(path, f"needed: {option}", *rest)

    def test_athenak(self):
        path, nodes = self.folder / "flow.bin", ("--nodes", 60, 40, 24)
        files.write_athenak(path)
        whole = self.known("athenak", path, *nodes, bound=BETWEEN_CUBES)
        self.assertGreater(whole[..., 0].min(), 0)
        files.write_athenak(self.folder / "ranks", ranks=3, location=4)
        parts = self.known("athenak ranks", self.folder / "ranks" / "rank_00000001" / "flow.bin", *nodes, bound=BETWEEN_CUBES)
        np.testing.assert_array_equal(whole, parts)
        files.write_athenak_hdf5(self.folder / "flow.athdf")
        np.testing.assert_array_equal(whole, self.known("athenak athdf", self.folder / "flow.athdf", *nodes, bound=BETWEEN_CUBES))

    def test_koral(self):
        path, nodes = self.folder / "flow.h5", ("--nodes", 40, 40)
        files.write_koral(path)
        self.known("koral", path, *nodes, electrons="kelvin")
        self.known("koral without te", path, *nodes, "--electrons", "r-high")
        done = convert(path, "-o", self.folder / "unit.grid", "--nodes", 40, 40, "--sigma-cut", 1e9, "--outer", 12)
        self.assertEqual(done.returncode, 0, done.stderr)
        ratio = read(self.folder / "unit.grid")[4] / read(self.folder / "koral.grid")[4]
        np.testing.assert_allclose(ratio[..., 0], 2e-17 / UNIT, rtol=1e-5)
        np.testing.assert_allclose(ratio[..., 4], math.sqrt(2e-17 / UNIT), rtol=1e-5)
        files.write_koral(path, te=False)
        self.known("koral of one fluid", path, *nodes)

    def test_hamr_asks_for_what_its_readers_disagree_on(self):
        path, nodes = self.folder / "flow.h5", ("--nodes", self.outside(1.2, 60, 40), 32)
        for lapse, word in ((True, "yes"), (False, "no")):
            files.write_hamr(path, lapse=lapse)
            self.known(f"hamr {word}", path, *nodes, "--field-has-lapse", word, outer=100, bound=AT_CELLS)
            self.refused(path, "needed: --field-has-lapse yes or no")
        files.write_hamr(path, hslope=0.5, r0=0.2)
        self.known("hamr with R0", path, "--nodes", 40, 40, "--field-has-lapse", "no")
        files.write_hamr(path, hslope=0.5, places=False)
        self.refused(path, "hslope 0.5, on which readers of this format disagree", "--field-has-lapse", "no")

    def refused(self, path, words, *arguments):
        out = self.folder / "out.grid"
        done = convert(path, "-o", out, *OPTIONS, *arguments)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        self.assertIn(words, done.stderr)
        self.assertFalse(out.exists() or pathlib.Path(f"{out}.part").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
