"""The converter of GRMHD files: one known flow in the layout of each code becomes the grid that is known."""
import contextlib
import io
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import types
import unittest
import unittest.mock

import h5py
import numpy as np

import grmhd_files as files
from grmhd_files import SPIN, TURN

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import convert_grmhd
from grmhd.mesh import Mesh, trilinear
PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 else None
UNIT = 1e-18     # g/cm^3
OPTIONS = ("--density-unit", UNIT, "--sigma-cut", 1e9)

AT_CELLS = 1e-6       # nodes at middles of cells: 32-bit numbers of file and grid (measured 2.5e-7)
BETWEEN = 0.02        # nodes elsewhere, of cells of 0.08 to 0.13 in ln r and theta: quadratic terms, an eighth of the step's square times second derivatives

BETWEEN_CUBES = 0.02  # of cubes of 0.1 to 0.25 r

NEXT_TO_EXCISED = 0.25 # where some of eight cubes hold nothing
FLUX = 1e-3           # of pictures of two grids of one flow


def convert(*arguments):
    """The script within this process, which saves starting an interpreter a hundred times."""
    said, code = io.StringIO(), None
    with unittest.mock.patch.object(sys, "argv", ["convert_grmhd.py", *map(str, arguments)]), contextlib.redirect_stderr(said), contextlib.redirect_stdout(None):
        try:
            convert_grmhd.main()
        except SystemExit as error:
            code = error.code
    return types.SimpleNamespace(returncode=1 if code else 0, stderr=said.getvalue() + (f"{code}\n" if code else ""))


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
        start = time.process_time()
        self.addCleanup(lambda: print(f"  {time.process_time() - start:.1f} core-s"))

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
        zero = 0.8
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
        fine = self.known("kharma, two levels", path, "--nodes", 60, 40, 32)
        files.write_athena(self.folder / "levels.athdf", root=(32, 16, 16), size=(8, 8, 8), refined=lambda level, middle: level == 0 and abs(middle[1] - 1.57) < 0.8)
        self.known("athena++, two levels", self.folder / "levels.athdf", *self.athena, "--nodes", 60, 40, 32)
        # No step from node to node is larger than the flow's own, of which r^-1.5 and 1 + 0.3 sin(theta) cos(phi) are the largest parts.
        for axis, most in ((0, 1.5 * math.log(24 / 1.78) / 59), (2, 0.3 / math.sqrt(1 - 0.3 ** 2) * TURN / 32)):
            self.assertLess(np.abs(np.diff(np.log(fine[..., 0]), axis=axis)).max(), most + BETWEEN)

    def test_a_linear_field_is_itself_across_four_levels(self):
        half, rng = 32.0, np.random.default_rng(1)
        leaves = files.blocks_of((32,) * 3, (8,) * 3, ((-half, half),) * 3, files.nested((16.0, 8.0, 4.0)))
        mesh = Mesh("made", [leaf.faces for leaf in leaves], [leaf.level for leaf in leaves],
                    lambda block: [np.add.outer(np.add.outer(leaves[block].middles[0], 2 * leaves[block].middles[1]), 5 * leaves[block].middles[2])])
        points = rng.uniform(-1, 1, (3, 20000)) * half * 2.0 ** -rng.integers(0, 4, 20000) * (1 - 1.0 / 32)   # not beyond the last middles
        owners = mesh.locate(points)
        self.assertEqual(set(np.asarray(mesh.levels)[owners]), {0, 1, 2, 3})
        for block in np.unique(owners):
            x, y, z = inside = points[:, owners == block]
            around = mesh.around(int(block))
            np.testing.assert_allclose(trilinear(around.values, around.at(inside))[0], x + 2 * y + 5 * z, atol=1e-12)

    def test_cells_within_the_hole_are_not_used(self):
        """Of a hole that rotates fast nodes are next to cells that the code has cut out; the test writes 1e30 there."""
        files.write_athenak(self.folder / "fast.bin", a=0.99)
        self.known("athenak, a = 0.99", self.folder / "fast.bin", "--nodes", 60, 40, 24, spin=0.99, bound=NEXT_TO_EXCISED)

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

    def test_coordinates_of_a_user_are_told(self):
        path = self.folder / "user.athdf"
        files.write_athena_cartesian(path, m=2.0)
        options = ("--spin", SPIN, "--adiabatic-index", files.GAMMA, "--code-mass", 2)
        self.known("athena++ gr_user", path, *options, "--coordinates", "cartesian-kerr-schild", "--nodes", 60, 40, 24, bound=BETWEEN_CUBES)
        self.refused(path, "Coordinates is 'gr_user'; allowed: kerr-schild", *options)

    def test_negative_spins_are_turned(self):
        path = self.folder / "west"
        files.write_kharma(path, files.mks, "mks", a=-SPIN)
        self.known("kharma, westward", path, "--nodes", 40, 30, 24, spin=-SPIN)
        files.write_athenak(path, a=-SPIN)
        self.known("athenak, westward", path, "--nodes", 60, 40, 24, spin=-SPIN, bound=BETWEEN_CUBES)

    def test_axisymmetric_files_are_read(self):
        files.write_athena(self.folder / "flat.athdf", root=(48, 32, 1), size=(16, 16, 1))
        done = convert(self.folder / "flat.athdf", "-o", self.folder / "flat.grid", *OPTIONS, *self.athena)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(read(self.folder / "flat.grid")[4].shape[2], 1)

    def test_fluxes_are_those_of_the_same_flow_in_the_first_layout(self):
        cells = (96, 64, 48)
        files.write_iharm(self.folder / "iharm.h5", cells)
        files.write_kharma(self.folder / "kharma.phdf", lambda x1, x2: files.fmks(x1, x2, zero=0.18), "fmks", root=(96, 64, 48), size=(16, 16, 16),
                           refined=lambda level, middle: level == 0 and abs(middle[1] - 0.5) < 0.2 and middle[0] < 2.0)
        files.write_athenak(self.folder / "athenak.bin", root=64, size=16, half=48.0, widths=(24.0, 12.0, 6.0))
        fluxes = {}
        for name in ("iharm.h5", "kharma.phdf", "athenak.bin"):
            grid = self.folder / f"{name}.grid"
            done = convert(self.folder / name, "-o", grid, "--density-unit", 1e-15, "--r-high", 1, "--sigma-cut", 1e9, "--outer", 12, "--nodes", 120, 64, 48)
            self.assertEqual(done.returncode, 0, done.stderr)
            fluxes[name] = self.flux(grid)
        print("fluxes, Jy:", fluxes)
        for name in ("kharma.phdf", "athenak.bin"):
            self.assertLess(abs(fluxes[name] / fluxes["iharm.h5"] - 1), FLUX, fluxes)

    def changed(self, good, change):
        path = good.with_name("changed" + good.suffix)
        shutil.copy(good, path)
        with h5py.File(path, "r+") as file:
            change(file)
        return path

    def test_what_is_wrong_with_a_file_of_kharma_is_said(self):
        good = self.folder / "flow.phdf"
        files.write_kharma(good, files.mks, "mks", "hslope = 0.3", kel=("Howes",))
        def text(old, new):
            return lambda file: file["Input"].attrs.__setitem__("File", file["Input"].attrs["File"].replace(old, new))
        def without(*names):
            return lambda file: [file.__delitem__(name) for name in names]
        def info(name, value):
            return lambda file: file["Info"].attrs.__setitem__(name, value)
        def both(*changes):
            return lambda file: [change(file) for change in changes]
        def nan(file):
            file["prims.uvec"][2, 1, 3, 4, 5] = np.nan
        def fewer(file):
            for name in ("Levels", "Locations/x", "Locations/y", "Locations/z", "prims.rho", "prims.u", "prims.uvec", "prims.B"):
                values = file[name][:-1]
                del file[name]
                file[name] = values
            file["Info"].attrs["NumMeshBlocks"] = len(values)
        cases = ((text("spherical_ks", "spherical_bl"), "base in <coordinates> is 'spherical_bl'; allowed: spherical_ks"),
                 (text("transform = mks", "transform = cmks"), "transform in <coordinates> is 'cmks'; allowed: null"),
                 (text("<GRMHD>", "<hydro>"), "not of KHARMA"), (text("a = 0.7", "b = 0.7"), "has no a in <coordinates>"),
                 (text("a = 0.7", "a = 1.7"), "a in <coordinates> is 1.7; allowed: between -1 and 1"), (text("a = 0.7", "a = x"), "is 'x'; allowed: a number"),
                 (text("hslope = 0.3", "hslope = 3"), "hslope in <coordinates> is 3"),
                 (info("OutputFormatVersion", 5), "OutputFormatVersion is 5; allowed: none, 2, 3, 4"), (info("OutputFormatVersion", 2), "prims.rho has the shape"),
                 (info("RootGridDomain", np.array([0, 4, 1, 0, 1, 1, 0, TURN, 1.0])), "but Info attribute RootGridDomain has 0 to 4"),
                 (info("MeshBlockSize", np.array([16, 8, 9])), "Locations/z has the shape"), (without("prims.rho"), "the file has no prims.rho"),
                 (without("prims.B"), "no prims.B, and no cons.B of flux_ct"), (without("Levels"), "the file has no Levels"),
                 (both(without("prims.B"), lambda file: file.__setitem__("cons.fB", np.ones(3))), "cons.fB, of face_ct, is not read"),
                 (lambda file: file["Levels"].__setitem__(0, -1), "its levels go from -1 to 0"),
                 (lambda file: file["prims.B"].__setitem__(Ellipsis, 1e38), "are not finite: field or velocity are too large"),
                 (nan, "not finite: prims.uvec 2 of cell (5, 4, 3) of block 2"), (fewer, "leave gaps"))
        for change, words in cases:
            self.refused(self.changed(good, change), words)
        self.refused(good, "the file holds the spin, 0.7; --spin is for files that do not", "--spin", 0.5)
        self.refused(good, "no electrons Kel_Werner; allowed: --electrons Kel_Howes, r-high", "--electrons", "Kel_Werner")
        self.refused_short(good)
        done = convert(good, "-o", self.folder / "out.grid", "--sigma-cut", 1)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        self.assertIn("needed: --density-unit, in g/cm^3", done.stderr)

    def test_what_is_wrong_with_a_file_of_athena_is_said(self):
        good = self.folder / "flow.athdf"
        files.write_athena(good)
        def put(name, value):
            return lambda file: file.attrs.__setitem__(name, value)
        def scaled(file):
            del file["B"]
            file["B"] = np.ones((3, 6, 16, 16, 16), "u2")
        def cold(file):
            file["prim"][0, 1, 2, 3, 4] = -1
        names = np.array(["dens", "Etot", "mom1", "mom2", "mom3", "s0", "Bcc1", "Bcc2", "Bcc3"], "S21")
        cases = ((put("Coordinates", np.bytes_("schwarzschild")), "Coordinates is 'schwarzschild'; allowed: kerr-schild"), (put("VariableNames", names), "has no rho, press"),
                 (put("VariableNames", names[:8]), "NumVariables counts 9 variables, but VariableNames has 8"), (lambda file: file.__delitem__("B"), "the file has no B"),
                 (scaled, "B is of uint16; allowed: floating-point"), (cold, "densities below 0: rho of cell (4, 3, 2) of block 1"),
                 (lambda file: file.attrs.__delitem__("RootGridX1"), "no attribute RootGridX1"), (put("RootGridX3", np.array([0, 5.0, 1])), "attribute RootGridX3 has 0 to 5"),
                 (put("MeshBlockSize", np.array([8, 16, 16])), "x1f has the shape"))
        for change, words in cases:
            self.refused(self.changed(good, change), words, *self.athena)
        self.refused(good, "the file holds its coordinates, kerr-schild", *self.athena, "--coordinates", "cartesian-kerr-schild")
        self.refused_short(good, *self.athena)

    def test_what_is_wrong_with_a_file_of_athenak_is_said(self):
        path = self.folder / "flow.bin"
        small = {"root": 16, "size": 8, "half": 16.0, "widths": ()}
        text = files.ATHENAK_TEXT
        for words, keys in (("needed: general_rel = true", {"text": text.replace("general_rel", "special_rel")}), ("needed: general_rel", {"text": text + "<coord>\nminkowski = true\n"}),
                            ("has <adm>", {"text": text + "<adm>\n"}), ("has no gamma in <mhd>", {"text": text.replace("gamma =", "gam =")}),
                            ("has no eint, but dens", {"names": tuple("ener" if name == "eint" else name for name in files.NAMES_K)}),
                            ("slices are not read", {"text": text.replace("<meshblock>\nnx1 = {size}", "<meshblock>\nnx1 = 16")}),
                            ("but <mesh> has -20 to", {"text": text.replace("x1min = {low}", "x1min = -20")})):
            files.write_athenak(path, **small, **keys)
            self.refused(path, words)
        files.write_athenak(path, **small)
        whole = path.read_bytes()
        for words, changed in (("allowed: Athena binary output version=1.1", whole.replace(b"version=1.1", b"version=2.0", 1)), ("allowed: 5 (7", whole.replace(b"header=5", b"header=7", 1)),
                               ("cut short", whole[:-1]), ("cut short", whole[:-9000]), ("leave gaps", whole[:-(40 + 48 + 4 * 9 * 512)]), ("cut short", whole[:400]),
                               ("size of location is ''", whole[:100]), ("no blocks", whole[:whole.index(b"gamma = 1.4\n") + 12]),
                               ("is 'x'; allowed: a whole number", whole.replace(b"variables=9", b"variables=x", 1)), ("but 9 names", whole.replace(b"variables=9", b"variables=8", 1))):
            path.write_bytes(changed)
            self.refused(path, words)
        files.write_athenak(self.folder / "ranks", **small, ranks=3)
        shutil.rmtree(self.folder / "ranks" / "rank_00000002")
        self.refused(self.folder / "ranks" / "rank_00000000" / "flow.bin", "is a block or the file of a rank missing?")

    def test_what_is_wrong_with_other_files_is_said(self):
        koral, hamr = self.folder / "koral.h5", self.folder / "hamr.h5"
        files.write_koral(koral)
        files.write_hamr(hamr)
        def put(name, value):
            return lambda file: (file.__delitem__(name), file.__setitem__(name, value))
        def bent(file):
            file["grid_out/r"][3, 4, 5] *= 1.01
        for change, words in ((put("header/version", np.bytes_("KORALv1")), "allowed: KORALv2"), (put("header/metric_out", np.bytes_("BL")), "metric_out is 'BL'; allowed: KS"),
                              (lambda file: file.__delitem__("quants/B3"), "the file has no quants/B3"), (bent, "grid_out/r is not finite or not of a grid"),
                              (put("header/n3", 15), "has the shape (32, 24, 16); allowed: (32, 24, 15)"), (put("header/bhspin", 2.0), "bhspin is 2")):
            self.refused(self.changed(koral, change), words)
        for change, words in ((lambda file: file.attrs.__setitem__("hslope", 0.9), "h is not that of its attributes"), (lambda file: file.__delitem__("U2"), "the file has no U2"),
                              (lambda file: file.attrs.__setitem__("startx", np.array([0.2, 0.0, 0.0])), "x2 = -0.03"), (lambda file: file.attrs.__delitem__("a"), "no attribute a")):
            self.refused(self.changed(hamr, change), words, "--field-has-lapse", "no")
        self.refused_short(koral)
        bhac = self.folder / "data0010.dat"
        bhac.write_bytes(bytes(1000))
        self.refused(bhac, "BHAC's raw output does not hold its domain, base grid and coordinates")

    def refused_short(self, good, *arguments):
        whole = good.read_bytes()
        for part in (len(whole) // 2, len(whole) - 2000, 3000):
            short = good.with_name("short" + good.suffix)
            short.write_bytes(whole[:part])
            self.refused(short, "it is cut short or damaged", *arguments)

    def flux(self, grid):
        scene = self.folder / "scene.toml"
        scene.write_text(f'[spacetime]\nmetric = "kerr"\nspin = {SPIN}\n[camera]\ntheta = 60\nr = 500\nfov = 3\n[sky]\nkind = "black"\n[object]\nname = "m87"\n[medium]\n'
                         f'kind = "grid"\nfile = "{grid.name}"\nemission = "synchrotron"\nfield_direction = "file"\nouter = 11\n')
        picture = self.folder / "picture.fits"
        done = subprocess.run([PROGRAM, "capture", scene, "--size", "64x36", "-o", picture], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        said, whole = float(re.search(r"([\d.e+-]+) Jy", done.stdout + done.stderr)[1]), picture.read_bytes()
        head = whole[:2880 * (1 + whole.index(b"END      ") // 2880)]
        self.assertIn(b"BITPIX  =                  -32", head)
        flux = np.frombuffer(whole, ">f4", 64 * 36, len(head)).astype(float).sum()
        self.assertAlmostEqual(flux / said, 1, places=3)
        return flux

    def refused(self, path, words, *arguments):
        out = self.folder / "out.grid"
        done = convert(path, "-o", out, *OPTIONS, *arguments)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        self.assertIn(words, done.stderr)
        self.assertFalse(out.exists() or pathlib.Path(f"{out}.part").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
