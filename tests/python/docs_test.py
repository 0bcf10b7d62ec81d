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
        self.assertIn("<amble.Walk: 6.61 m, 6.32 s, 380 frames>", said)
        self.assertIn("no_walk", said)
        for file in ("walk.npz", "out/walk.bvh", "out/walk.html", "room.roadmap", "turn.bvh"):
            self.assertTrue((self.here / file).exists(), file)

    def test_first_walk_tells_what_the_walk_is(self):
        said = self.said_by(example("first_walk").main, "kerb", "walk")
        self.assertRegex(said, r"[0-9.]+ m in [0-9.]+ s, \d+ steps")
        self.assertTrue((self.here / "walk/walk.html").exists())

    def test_many_walks_are_a_set_that_the_dataset_goes_through(self):
        said = self.said_by(example("many_walks").main, "set", 3)
        table = (self.here / "set/walks.csv").read_text().splitlines()
        solved = len(list((self.here / "set").glob("*.npz")))
        self.assertEqual(len(table), 4)
        self.assertIn(f"{solved} of 3 walks", said)
        self.assertGreater(solved, 0)
        dataset = example("dataset")
        windows = dataset.WalkWindows("set", frames=40, step=20)
        batches = list(dataset.batches(windows, 2))
        self.assertEqual(len(batches), len(windows) // 2)
        self.assertEqual(batches[0]["positions"].shape, (2, 40, 22, 3))
        self.assertIn(f"of {solved} walks", self.said_by(dataset.main, "set"))

    def test_windows_begin_where_the_walker_stands_and_face_ahead(self):
        """The root's turn is the joints': forward kinematics from it gives the window's positions."""
        walk = amble.plan("kerb", fps=30)
        (self.here / "set").mkdir()
        walk.write(self.here / "set" / "kerb.npz")
        item = example("dataset").WalkWindows("set", frames=30, step=45)[1]
        np.testing.assert_allclose(np.linalg.norm(item["quaternions"], axis=-1), 1, atol=1e-6)
        self.assertLess(np.abs(item["positions"][0, 0, :2]).max(), 0.15)
        along = item["positions"][-1, 0] - item["positions"][0, 0]
        self.assertGreater(along[0], abs(along[1]))
        w, x, y, z = np.moveaxis(item["quaternions"][:, 0], -1, 0)
        matrix = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
                           1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x),
                           1 - 2 * (x * x + y * y)], axis=-1).reshape(-1, 3, 3)
        child = list(walk.parents).index(0)
        np.testing.assert_allclose(item["positions"][:, 0] + matrix @ walk.offsets[child],
                                   item["positions"][:, child], atol=1e-5)

    def test_walks_of_a_pack_are_those_of_their_files(self):
        walk = amble.plan("kerb", fps=30)
        for folder in ("files", "packed/packs"):
            (self.here / folder).mkdir(parents=True)
        walk.write(self.here / "files/a.npz")
        with np.load(self.here / "files/a.npz") as arrays:
            np.savez(self.here / "packed/packs/00000.npz", **{f"{key}/{name}": arrays[name] for key in ("a", "b")
                                                              for name in arrays.files})
        windows = example("dataset").WalkWindows
        alone, packed = windows("files", 30, 30), windows("packed", 30, 30)
        self.assertEqual(len(packed), 2 * len(alone))
        for name, array in alone[1].items():
            np.testing.assert_array_equal(packed[1][name], array)

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
