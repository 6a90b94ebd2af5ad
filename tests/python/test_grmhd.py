"""The converter of GRMHD dumps: a made dump of known matter becomes the grid that is known, and the program draws it."""
import hashlib
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

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONVERTER = ROOT / "scripts" / "convert_grmhd.py"
PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 else None
UNIT = 1e-18   # g/cm^3
SPIN = 0.9


def kerr_schild(r, theta, a):
    """Covariant metric of t, r, theta, phi, written out once more: flat part and null vector l = (1, 1, 0, -a sin^2 theta), g = eta + 2r/Sigma l l."""
    s2, sigma = math.sin(theta) ** 2, r * r + a * a * math.cos(theta) ** 2
    flat = np.array([[-1, 0, 0, 0], [0, 1, 0, -a * s2], [0, 0, sigma, 0], [0, -a * s2, 0, (r * r + a * a) * s2]])
    null = np.array([1, 1, 0, -a * s2])
    return flat + 2 * r / sigma * np.outer(null, null)


def dump(path, metric="MKS", spin=SPIN, hslope=0.3, spoil=None, turns=1, pole=1):
    """Matter that falls from rest far away: E = 1, L = 0, u_r = -sqrt(2r (r^2 + a^2))/Delta in Boyer and Lindquist's; density r^-1.5. pole -1: the same, told
    in coordinates of which the hole's axis is the other way round."""
    n = (40, 24, 8)
    x_in = math.log(1.2)
    start, step = (x_in, 0.0, 0.0), (math.log(60) / n[0], 1 / n[1], 2 * math.pi / n[2] / turns)
    prims = np.zeros(n + (8,))
    squares = np.zeros(n)
    xt, alpha, smooth = 0.82, 14.0, 0.5
    def theta_of(x1, x2):
        geometric = math.pi * x2 + 0.5 * (1 - hslope) * math.sin(2 * math.pi * x2)
        if metric == "MKS":
            return geometric
        y = 2 * x2 - 1
        norm = 0.5 * math.pi / (1 + xt ** -alpha / (1 + alpha))
        return geometric + math.exp(smooth * (start[0] - x1)) * (norm * y * (1 + (y / xt) ** alpha / (1 + alpha)) + 0.5 * math.pi - geometric)
    for i in range(n[0]):
        for j in range(n[1]):
            x1, x2 = start[0] + (i + 0.5) * step[0], start[1] + (j + 0.5) * step[1]
            r, theta, small = math.exp(x1), theta_of(x1, x2), 1e-5
            jacobian = np.diag([1.0, r, (theta_of(x1, x2 + small) - theta_of(x1, x2 - small)) / (2 * small), 1.0])
            jacobian[2, 1] = (theta_of(x1 + small, x2) - theta_of(x1 - small, x2)) / (2 * small)
            g = kerr_schild(r, theta, spin)
            delta, sigma = r * r - 2 * r + spin ** 2, r * r + spin ** 2 * math.cos(theta) ** 2
            u_r = -math.sqrt(2 * r * (r * r + spin ** 2)) / sigma
            # u^t, u^phi of E = 1, L = 0 from u_t = -1, u_phi = 0.
            rest = np.linalg.solve(g[np.ix_([0, 3], [0, 3])], np.array([-1, 0]) - g[np.ix_([0, 3], [1])][:, 0] * u_r)
            u = np.linalg.solve(jacobian, np.array([rest[0], u_r, 0, rest[1]]))
            native = jacobian.T @ g @ jacobian
            up = np.linalg.inv(native)
            lapse = 1 / math.sqrt(-up[0, 0])
            prims[i, j, :, 0], prims[i, j, :, 1] = r ** -1.5, 0.1 * r ** -2.5
            prims[i, j, 0, 0] *= 2   # the first azimuth
            prims[i, j, :, 2:5] = u[1:] + u[0] * lapse * lapse * up[0, 1:]
            field = np.array([0, 0.02 / r ** 2, 0.005 / r ** 2, 0.01 / r])
            prims[i, j, :, 5:8] = field[1:]
            b_t = field @ native @ u
            b = (field + b_t * u) / u[0]
            b[0] = b_t
            squares[i, j] = b @ native @ b
    if spoil:
        spoil(prims)
    if pole < 0:   # theta -> pi - theta, phi -> -phi: nothing is mirrored
        prims = prims[:, ::-1, ::-1].copy()
        prims[..., [3, 4, 6, 7]] *= -1
    with h5py.File(path, "w") as file:
        file["prims"] = prims.astype(np.float32 if not spoil else np.float64)
        head = file.create_group("header")
        head["metric"], head["gam"] = np.bytes_(metric), 4 / 3
        for axis in range(3):
            head[f"geom/startx{axis + 1}"], head[f"geom/dx{axis + 1}"] = start[axis], step[axis]
        folder = f"geom/{'mks' if metric == 'MKS' else 'mmks'}/"
        head[folder + "a"], head[folder + "hslope"] = pole * spin, hslope
        if metric != "MKS":
            head[folder + "poly_xt"], head[folder + "poly_alpha"], head[folder + "mks_smooth"] = xt, alpha, smooth
    return squares


def handed(prims):
    """A spot that is not on the equator, and a field that winds about the axis: in a mirror it winds the other way."""
    prims[12:20, 15:19, 2:4, 0] *= 50
    prims[..., 6:8] = 0
    prims[:, :14, :, 7] = 0.3 * np.abs(prims[:, :14, :, 5])


def convert(*arguments):
    return subprocess.run([sys.executable, "-B", CONVERTER, *map(str, arguments)], capture_output=True, text=True)


def read(path):
    head, data = path.read_bytes().split(b"data\n", 1)
    lines = dict(line.split(" ", 1) for line in head.decode().splitlines())
    r0, r1, nr = lines["r"].split()
    t0, t1, nt = lines["theta"].split()
    nodes = (int(nr), int(nt), int(lines["phi"].split()[1]))
    return lines, np.geomspace(float(r0), float(r1), nodes[0]), np.linspace(float(t0), float(t1), nodes[1]), \
        np.frombuffer(data, "<f4").reshape(nodes + (8,)).astype(float)


class Converter(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="nullscope-grmhd-")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def test_matter_is_what_the_dump_was_made_of(self):
        for metric, name, axis in (("MKS", "MKS", 1), ("FMKS", "MMKS", 1), ("MKS", "MKS", -1)):
            with self.subTest(metric=metric, axis=axis):
                path, grid = self.folder / f"{metric}.h5", self.folder / f"{metric}.grid"
                squares = dump(path, name, pole=axis)
                done = convert(path, "-o", grid, "--density-unit", UNIT, "--sigma-cut", 1e9, "--nodes", 60, 40, "--outer", 12)
                self.assertEqual(done.returncode, 0, done.stderr)
                lines, r, theta, numbers = read(grid)
                self.assertEqual((float(lines["spin"]), lines["coordinates"]), (SPIN, "kerr-schild"))
                r, theta = 2 * r[:, None, None], theta[None, :, None]    # M
                density = UNIT / 1.67262192e-24 * r ** -1.5 * np.ones_like(numbers[..., 0])
                density[:, :, 0] *= 2
                np.testing.assert_allclose(numbers[..., 0], density, rtol=1e-4)
                delta, sigma = r * r - 2 * r + SPIN ** 2, r * r + SPIN ** 2 * np.cos(theta) ** 2
                area = (r * r + SPIN ** 2) ** 2 - SPIN ** 2 * delta * np.sin(theta) ** 2
                lorentz = np.sqrt(area / (sigma * delta))     # E = 1, L = 0: 1/lapse
                out = -np.sqrt(lorentz ** 2 - 1) * np.ones_like(numbers[..., 5])
                np.testing.assert_allclose(numbers[..., 5], out, rtol=0.02)         # linear between cells
                self.assertLess(np.abs(numbers[..., 6:8]).max(), 0.01 * np.abs(out).max())
                # The field's square is the same for all observers: at a node that is a cell's middle.
                cell = np.interp(np.log(r[0, 0, 0]), math.log(1.2) + (np.arange(40) + 0.5) * math.log(60) / 40, np.arange(40))
                strength = math.sqrt(4 * math.pi * UNIT) * 2.99792458e10 * np.sqrt(squares[int(round(cell)), 0, 0])
                np.testing.assert_allclose(np.linalg.norm(numbers[0, 0, 0, 2:5]), strength, rtol=1e-3)
                if metric == "MKS":    # the first node is a cell's middle
                    rho, energy, square = r[0, 0, 0] ** -1.5, 0.1 * r[0, 0, 0] ** -2.5, squares[int(round(cell)), 0, 1]
                    beta2 = ((4 / 3 - 1) * energy / (0.5 * square)) ** 2
                    ratio = (40 * beta2 + 1) / (1 + beta2)
                    kelvin = 1836.15267 * (2 / 3) / (ratio + 2) * energy / rho * 5.92989658e9     # indices 4/3 and 5/3
                    np.testing.assert_allclose(numbers[0, 0, 1, 1], kelvin, rtol=1e-3)
                self.draw(grid, SPIN, 11)

    def test_a_dump_of_negative_spin_is_turned_and_not_mirrored(self):
        grids = {}
        for name, metric, spin, axis in (("east", "MKS", SPIN, 1), ("west", "MKS", SPIN, -1), ("east-f", "MMKS", SPIN, 1), ("west-f", "MMKS", SPIN, -1),
                                         ("still", "MKS", 0.0, 1), ("still-told", "MKS", 0.0, -1)):
            path = self.folder / f"{name}.h5"
            dump(path, metric, spin, spoil=handed, pole=axis)
            done = convert(path, "-o", self.folder / f"{name}.grid", "--density-unit", UNIT, "--sigma-cut", 1e9, "--nodes", 24, 24, "--outer", 12)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("camera.theta = 180 - theta, camera.phi = -phi, with camera.roll = 180 more" in done.stderr, name.startswith("west"))
            grids[name] = read(self.folder / f"{name}.grid")
        for east, west in (("east", "west"), ("east-f", "west-f")):
            for known, made in zip(grids[east][1:3], grids[west][1:3]):
                np.testing.assert_allclose(made, known, rtol=1e-6)
            scale = np.maximum(np.abs(grids[east][3]).max(axis=(0, 1, 2)), 1e-30)
            scale[5:] = scale[5:].max()   # one of the velocity's components is nothing but rounding
            np.testing.assert_allclose(grids[west][3] / scale, grids[east][3] / scale, atol=1e-5)
            self.assertAlmostEqual(math.cos(float(grids[west][0]["phi"].split()[0]) - float(grids[east][0]["phi"].split()[0])), 1, places=6)
            mirror = grids[east][3][:, :, ::-1] * [1, 1, 1, 1, -1, 1, 1, -1]
            self.assertGreater(np.abs(mirror / scale - grids[east][3] / scale).max(), 0.1)
        # A hole that does not rotate is not turned: its pictures show what the line about the camera means.
        pictures = [self.picture(name, 0, 10, f"theta = {theta}\nphi = {phi}\nroll = {roll}\nfov = 25")
                    for name, theta, phi, roll in (("still", 130, -20, 180), ("still-told", 50, 20, 0), ("still", 50, 20, 0), ("still", 130, -20, 0))]
        def off(a, b):
            said = subprocess.run([PROGRAM, "compare", pictures[a], pictures[b]], capture_output=True, text=True).stdout
            return float(re.search(r"^mean\s+(\S+)", said, re.M)[1])
        self.assertLess(off(1, 0), 0.02 * min(off(1, 2), off(1, 3)))

    def test_the_file_says_what_it_was_made_from_and_what_was_not_used(self):
        path, grid = self.folder / "said.h5", self.folder / "said.grid"
        dump(path)
        with h5py.File(path, "r+") as file:
            file["t"], file["header/version"] = 100.0, np.bytes_("iharm-alpha-3.6")
            file["header/n1"], file["header/n_prim"] = np.array([40]), 10
            file["header/prim_names"] = np.array([b"RHO", b"UU", b"U1", b"U2", b"U3", b"B1", b"B2", b"B3", b"KTOT", b"KEL0"])
            file.attrs["title"] = "a torus"
            prims = np.concatenate([file["prims"][()], np.full((40, 24, 8, 2), 7)], axis=3)
            gam = file["header/gam"][()]
            del file["prims"], file["header/gam"]
            file.create_dataset("prims", data=prims.astype(">f4"))
            file["header/gam"] = np.array([[gam]])
        done = convert(path, "-o", grid, "--density-unit", UNIT, "--electrons", "r-high")
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("attribute title", "header/version", " t,", "prims KTOT", "prims KEL0"):
            self.assertEqual(done.stderr.count(word), 1, (word, done.stderr))
        self.assertIn("electron entropies are not used", done.stderr)
        self.assertNotIn("header/n1", done.stderr)
        lines = read(grid)[0]
        self.assertEqual(lines["source"], f"sha256 {hashlib.sha256(path.read_bytes()).hexdigest()} said.h5")
        self.assertTrue(lines["converter"].startswith("convert_grmhd.py ") and lines["converter"].endswith(f"--density-unit {UNIT} --electrons r-high"), lines["converter"])
        self.draw(grid, SPIN, 11)
        plain = self.folder / "plain.grid"
        dump(self.folder / "plain.h5")
        self.assertEqual(convert(self.folder / "plain.h5", "-o", plain, "--density-unit", UNIT).stderr, "")
        np.testing.assert_array_equal(read(grid)[3], read(plain)[3])

    def test_magnetized_matter_is_left_out_and_a_wedge_goes_all_round(self):
        path, grid = self.folder / "half.h5", self.folder / "half.grid"
        squares = dump(path, turns=2)
        r_cells = np.exp(math.log(1.2) + (np.arange(40) + 0.5) * math.log(60) / 40)
        sigma = squares[:, 0, 1] * r_cells ** 1.5
        first = int(np.searchsorted(r_cells, 1.01 * (1 + math.sqrt(1 - SPIN ** 2))))
        cut = math.sqrt(sigma[first:].min() * sigma[first:].max())
        done = convert(path, "-o", grid, "--density-unit", UNIT, "--sigma-cut", cut, "--outer", 12)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines, r, theta, numbers = read(grid)
        self.assertEqual(numbers.shape[2], 16)
        np.testing.assert_array_equal(numbers[:, :, :8], numbers[:, :, 8:])
        known = np.interp(np.log(2 * r), np.log(r_cells), sigma)
        clear = np.abs(known / cut - 1) > 0.1     # between cells by interpolation
        np.testing.assert_array_equal((numbers[:, 0, 1, 0] == 0)[clear], (known > cut)[clear])
        self.assertTrue(0 < (numbers[:, 0, 1, 0] == 0).sum() < len(r))

    def test_the_grid_of_the_documentation_is_drawn(self):
        block, = re.findall(r"^```python\n(.*?)^```$", (ROOT / "docs" / "matter.md").read_text(), re.M | re.S)
        subprocess.run([sys.executable, "-c", block], cwd=self.folder, check=True)
        self.draw(self.folder / "flow.grid", 0, 10)

    def picture(self, name, spin, outer, camera=""):
        scene = self.folder / "scene.toml"
        picture = self.folder / f"picture-{name}-{hash(camera) % 10 ** 9}.png"
        scene.write_text(f'[spacetime]\nmetric = "kerr"\nspin = {spin}\n[camera]\n{camera}\n[sky]\nkind = "black"\n[object]\nname = "m87"\n[medium]\n'
                         f'kind = "grid"\nfile = "{name}.grid"\nemission = "synchrotron"\nfield_direction = "file"\nouter = {outer}\ndensity_scale = 1e4\n')
        done = subprocess.run([PROGRAM, "capture", scene, "--size", "64x36", "-o", picture], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return picture

    def draw(self, grid, spin, outer):
        picture = self.picture(grid.stem, spin, outer)
        black = self.folder / "black.toml"
        black.write_text('[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "black"\n')
        dark = self.folder / "black.png"
        subprocess.run([PROGRAM, "capture", black, "--size", "64x36", "-o", dark], check=True, capture_output=True)
        said = subprocess.run([PROGRAM, "compare", picture, dark], capture_output=True, text=True).stdout
        self.assertGreater(float(re.search(r"^mean\s+(\S+)", said, re.M)[1]), 1e-3)

    def test_what_is_wrong_with_a_dump_is_said_with_its_dataset_and_what_is_allowed(self):
        good = self.folder / "good.h5"
        dump(good)
        def of(change):
            path = self.folder / "changed.h5"
            shutil.copy(good, path)
            with h5py.File(path, "r+") as file:
                change(file)
            return path
        def put(name, value):
            def change(file):
                if f"header/{name}" in file:
                    del file[f"header/{name}"]
                file[f"header/{name}"] = value
            return change
        def without(name):
            return lambda file: file.__delitem__(name)
        def cells(index, value):
            return lambda file: file["prims"].__setitem__(index, value)
        def names(*words):
            return put("prim_names", np.array(words, dtype="S8"))
        eight = (b"RHO", b"UU", b"U1", b"U2", b"U3", b"B1", b"B2", b"B3")
        def to_pi(file):   # X2 is theta
            put("geom/dx2", math.pi / 24)(file)
        cases = ((to_pi, "from X2 = 0 to 3.14159", "allowed: 0 to 1"), (put("geom/startx2", -0.5), "X2 = -0.5", "allowed: 0 to 1"),
                 (put("geom/startx1", 30.0), "X1 = 30", "logarithms of r"), (put("geom/mks/r_out", 500.0), "geom/mks/r_out is 500", "X1 is the logarithm of r"),
                 (put("n1", 41), "header/n1 is 41", "allowed: 40"), (put("n3", np.array([4])), "header/n3 is 4", "allowed: 8"),
                 (put("n_prim", 9), "header/n_prim is 9", "8 to 8"), (put("gam", math.nan), "header/gam is nan", "above 1"),
                 (put("gam", np.array([1.3, 1.4])), "no single number", "allowed: one number"), (put("gam", np.bytes_("4/3")), "no single number", "allowed"),
                 (put("geom/dx1", 0.0), "geom/dx1 is 0", "above 0"), (put("geom/mks/hslope", 2.5), "hslope is 2.5", "between 0 and 2"),
                 (without("header/geom/mks/hslope"), "has no header/geom/mks/hslope", ""), (without("header/metric"), "has no header/metric", ""),
                 (put("metric", np.bytes_("BHAC_MKS")), "metric is BHAC_MKS", "allowed: MKS"), (put("metric", np.bytes_("FMKS")), "has no header/geom/mks/mks_smooth", ""),
                 (put("geom/mks/a", 1.0), "geom/mks/a is 1", "between -1 and 1"), (without("header/geom/mks/a"), "no geom/mks/a or", ""),
                 (names(*eight[:7]), "has no B3", "allowed: RHO"), (cells((3, 4, 5, 0), -1), "RHO of cell (3, 4, 5)", "0 and above"),
                 (cells((3, 4, 5, 6), math.inf), "not finite: B2 of cell (3, 4, 5)", ""), (put("has_derefine_poles", np.bool_(True)), "joined", ""))
        out = self.folder / "out.grid"
        for change, *words in cases:
            done = convert(of(change), "-o", out, "--density-unit", UNIT)
            self.assertEqual(done.returncode, 1, (words, done.stderr))
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            for word in words + ["changed.h5"]:
                self.assertIn(word, done.stderr)
            self.assertFalse(out.exists())
        # Primitives are found by their names.
        def shuffled(file):
            names(*eight[::-1])(file)
            file["prims"][...] = file["prims"][()][..., ::-1]
        for change, name in ((lambda file: None, "good"), (shuffled, "shuffled")):
            done = convert(of(change), "-o", self.folder / f"{name}.grid", "--density-unit", UNIT)
            self.assertEqual(done.returncode, 0, done.stderr)
        np.testing.assert_array_equal(read(self.folder / "shuffled.grid")[3], read(self.folder / "good.grid")[3])

    def test_what_is_of_no_known_code_or_not_whole_gets_one_line(self):
        def parthenon(file):
            file.create_group("Info").attrs["OutputFormatVersion"] = 3
            file["prims.rho"] = np.ones((2, 4, 4, 4))
        def athena(file):
            file.attrs["NumMeshBlocks"], file.attrs["Coordinates"] = 2, "kerr-schild"
            file["prim"] = np.ones((5, 2, 4, 4, 4))
        def table(file):
            file["prims"], file["header/n1"] = np.array([(1, 2.0)], dtype=[("a", "i4"), ("b", "f8")]), 3
        def nothing(file):
            file["cells"] = np.ones((4, 4, 4))
        out = self.folder / "out.grid"
        for name, make, words in (("kharma", parthenon, "Input/File"), ("athena", athena, "attribute MeshBlockSize"), ("table", table, "prims is no dataset"),
                                  ("nothing", nothing, "no dump of a code that is known; allowed: AthenaK")):
            path = self.folder / f"{name}.h5"
            with h5py.File(path, "w") as file:
                make(file)
            done = convert(path, "-o", out, "--density-unit", UNIT)
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
            self.assertIn(words, done.stderr)
        binary, short = self.folder / "flow.bin", self.folder / "short.h5"
        binary.write_bytes(b"Athena binary output version=1.1\n")
        dump(short)
        short.write_bytes(short.read_bytes()[:3000])
        for path, words in ((binary, "it is cut short"), (short, "cut short or damaged")):
            done = convert(path, "-o", out, "--density-unit", UNIT)
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
            self.assertIn(words, done.stderr)
        done = convert(self.folder / "short.h5", "-o", self.folder / "none" / "out.grid", "--density-unit", UNIT)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)

    def test_what_is_no_dump_gets_one_line(self):
        good = self.folder / "good.h5"
        dump(good)
        text = self.folder / "text.h5"
        text.write_text("no HDF5")
        bare, other, broken = (self.folder / f"{name}.h5" for name in ("bare", "other", "broken"))
        with h5py.File(bare, "w") as file:
            file["prims"] = np.zeros((2, 2, 2, 8))
        dump(other)
        with h5py.File(other, "r+") as file:
            del file["header/metric"]
            file["header/metric"] = np.bytes_("EKS")
        bent, wide = self.folder / "bent.h5", self.folder / "wide.h5"
        dump(wide, turns=2)
        dump(bent)
        with h5py.File(bent, "r+") as file:
            del file["header/geom/dx3"]
            file["header/geom/dx3"] = 0.3
        dump(broken, spoil=lambda prims: prims.__setitem__((3, 3, 3, 0), math.nan))
        out = self.folder / "out.grid"
        for arguments, words in (((self.folder / "none.h5",), "no dump"), ((text,), "no dump"), ((bare,), "no dump"), ((other,), "allowed: MKS"),
                                 ((broken,), "not finite"), ((bent,), "a whole part of a turn"), ((wide, "--nodes", 1024, 2048), "at most"), ((good, "--outer", 0.1), "allowed: more than"), ((good, "--nodes", 1, 5), "allowed: 2"),
                                 ((good, "--r-high", -1), "allowed: above 0")):
            done = convert(*arguments, "-o", out, "--density-unit", UNIT)
            self.assertEqual(done.returncode, 1, arguments)
            self.assertIn(words, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
