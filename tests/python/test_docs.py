"""docs/python.md, the examples and the notebook do what they say: each is run."""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import nbclient
import nbformat

import support

EXAMPLES = support.ROOT / "python" / "examples"


def code_blocks(text):
    return re.findall(r"^```python\n(.*?)^```$", text, re.M | re.S)


class Docs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="nullscope-python-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_python(self, *arguments):
        done = subprocess.run([sys.executable, "-W", "ignore", *map(str, arguments)], cwd=self.folder, capture_output=True, text=True,
                              env={k: v for k, v in os.environ.items() if k != "DISPLAY"})
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_the_page(self):
        blocks = code_blocks((support.ROOT / "docs" / "python.md").read_text())
        self.assertGreaterEqual(len(blocks), 7)
        (self.folder / "page.py").write_text("\n".join(blocks))
        said = self.run_python("page.py")
        self.assertIn("scene: camera.r: a static camera cannot be at 0.5", said)
        self.assertTrue((self.folder / "kerr.png").read_bytes().startswith(b"\x89PNG"))

    def test_the_page_of_fits(self):
        blocks = [block for block in code_blocks((support.ROOT / "docs" / "fit.md").read_text()) if "numpyro" not in block]   # that one: scripts/interop.sh samplers
        self.assertEqual(len(blocks), 1)
        (self.folder / "page.py").write_text(blocks[0])
        self.assertIn("nullscope.Fit spacetime.spin", self.run_python("page.py"))

    def test_the_examples(self):
        scripts = sorted(EXAMPLES.glob("*.py"))
        self.assertEqual(len(scripts), 3)
        for script in scripts:
            picture = self.folder / (script.stem + ".png")
            said = self.run_python(script, picture)
            self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"), script)
            if script.stem == "shadow_radius":
                self.assertLess(float(re.search(r"difference: (\S+) rad", said)[1]), 1e-11)

    def test_the_notebook(self):
        notebook = nbformat.read(EXAMPLES / "first_steps.ipynb", as_version=4)
        nbformat.validate(notebook)
        nbclient.NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(self.folder)}}).execute()
        shown = [output.get("data", {}) for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
        self.assertEqual(sum("image/png" in data for data in shown), 5)


class Stubs(unittest.TestCase):
    def test_every_name_has_a_type(self):
        import nullscope
        folder = Path(nullscope.__file__).parent
        self.assertTrue((folder / "py.typed").exists())
        text = (folder / "_core.pyi").read_text()
        for name in ("class Scene", "class Spacetime", "class Observer", "class Worldline", "def scenes", "class Error(ValueError)"):
            self.assertIn(name, text)
        for name in nullscope.__all__:
            self.assertTrue(getattr(nullscope, name).__doc__ or name in ("RAYDATA", "__version__"), name)


if __name__ == "__main__":
    support.main()
