"""What docs/python.md and examples/python/ show works, and the types are those that the module has."""

import ast
import contextlib
import importlib.util
import inspect
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import amble
import numpy as np
from amble import _amble
from inputs import ROOT

EXAMPLES = ROOT / "examples/python"


def example(name):
    """Its file as a module."""
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Docs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.here = pathlib.Path(folder.name)
        for name in ("environments", "scenarios", "animation"):
            (self.here / name).symlink_to(ROOT / name)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.here)

    def said_by(self, function, *arguments):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            function(*arguments)
        return said.getvalue()

    def test_the_pages_code_works_from_its_begin_to_its_end(self):
        names = {}
        blocks = re.findall(r"```python\n(.*?)```", (ROOT / "docs/python.md").read_text(), re.DOTALL)
        self.assertGreater(len(blocks), 4)
        said = self.said_by(lambda: [exec(block, names) for block in blocks])
        self.assertIn("<amble.Walk: 6.57 m, 7.33 s, 441 frames>", said)
        self.assertIn("no_walk", said)
        for file in ("walk.npz", "out/walk.bvh", "out/walk.html", "room.roadmap", "turn.bvh"):
            self.assertTrue((self.here / file).exists(), file)

    def test_first_walk_tells_what_the_walk_is(self):
        said = self.said_by(example("first_walk").main, "kerb", "walk")
        self.assertRegex(said, r"[0-9.]+ m in [0-9.]+ s, \d+ steps")
        self.assertTrue((self.here / "walk/walk.html").exists())

    def test_many_walks_are_files_and_a_table(self):
        said = self.said_by(example("many_walks").main, "set", 3)
        table = (self.here / "set/walks.csv").read_text().splitlines()
        files = sorted((self.here / "set").glob("*.npz"))
        self.assertEqual(len(table), 4)
        self.assertEqual(sum(",solved," in line for line in table), len(files))
        self.assertIn(f"{len(files)} of 3 walks", said)
        self.assertGreater(len(files), 0)
        with np.load(files[0]) as walk:
            self.assertEqual(walk["positions"].shape[1:], (22, 3))

    def test_captures_are_made_to_step_longer(self):
        said = self.said_by(example("captures").main)
        lengths = [float(text) for text in re.findall(r"steps of ([0-9.]+) m", said)]
        self.assertAlmostEqual(lengths[1] / lengths[0], 1.15, delta=0.03)
        self.assertTrue((self.here / "out/longer.bvh").exists())

    def test_the_notebook_runs_from_its_begin_to_its_end(self):
        try:
            import nbclient
            import nbformat
        except ImportError:
            self.skipTest("nbclient and nbformat are not installed")
        os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"  # of a debugger, which is loaded with the kernel
        notebook = nbformat.read(EXAMPLES / "walks.ipynb", as_version=4)
        nbformat.validate(notebook)
        nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3",
                                resources={"metadata": {"path": str(self.here)}}).execute()
        texts = "".join(output.get("text", "") for cell in notebook.cells for output in cell.get("outputs", []))
        self.assertIn("beam hangs 1.60 m over the ground", texts)


class Types(unittest.TestCase):
    def test_stubs_have_the_names_that_the_module_has(self):
        tree = ast.parse((ROOT / "python/amble/_amble.pyi").read_text())
        said = {}
        for node in tree.body:
            if isinstance(node, ast.ClassDef):
                said[node.name] = {part.name if isinstance(part, ast.FunctionDef) else part.target.id
                                   for part in node.body} - {"__init__"}
            elif isinstance(node, ast.FunctionDef):
                said[node.name] = None
            elif isinstance(node, ast.AnnAssign):
                said[node.target.id] = None
        there = {name: {part for part in vars(value) if not part.startswith("_")} if inspect.isclass(value) else None
                 for name, value in vars(_amble).items() if not name.startswith("__")}
        self.assertEqual(said, there)

    def test_all_that_is_public_is_documented_and_typed(self):
        for name in amble.__all__:
            value = getattr(amble, name)
            if inspect.isfunction(value):
                self.assertIn("return", value.__annotations__, name)
            elif inspect.isclass(value) and not issubclass(value, Exception):
                for part, function in inspect.getmembers(value, inspect.isfunction):
                    if not part.startswith("_"):
                        self.assertIn("return", function.__annotations__, f"{name}.{part}")
            if callable(value):
                self.assertTrue(inspect.getdoc(value), name)
        self.assertTrue((pathlib.Path(amble.__file__).parent / "py.typed").exists())

    def test_an_import_loads_little_beside_numpy(self):
        """NumPy is what it costs."""
        script = ("import sys, json, numpy.typing; before = set(sys.modules); import amble; "
                  "print(*sorted(set(sys.modules) - before))")
        ended = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True)
        others = [name for name in ended.stdout.split() if not name.startswith("amble")]
        self.assertEqual(others, [])


if __name__ == "__main__":
    unittest.main()
