"""examples/batch/dataset.py: what a training loop reads of a batch is what the program wrote."""

import importlib.util
import pathlib
import tempfile
import unittest

import numpy as np

from inputs import ROOT, run, write_floor

FRAMES, STRIDE, SIZE = 24, 10, 4
JOB = """\
scenes: [floor.yaml]
ways: {draw: 3, least: 1, most: 2}
heights: [1.6, 1.8]
fps: 24
"""


def load_example():
    spec = importlib.util.spec_from_file_location("dataset", ROOT / "examples" / "batch" / "dataset.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Dataset(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.example = load_example()
        cls.held = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.held.name)
        write_floor(folder)
        (folder / "job.yaml").write_text(JOB)
        cls.folder, cls.packed = folder / "walks", folder / "packed"
        run("batch", folder / "job.yaml", "-o", cls.folder)
        run("batch", folder / "job.yaml", "-o", cls.packed, "--pack")
        cls.walks = cls.example.Walks(cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.held.cleanup()

    def test_walks_are_those_that_were_found(self):
        self.assertGreater(len(self.walks), 0)
        for index, row in enumerate(self.walks.rows):
            arrays = self.walks[index]
            self.assertEqual(arrays["positions"].shape[0], row["frames"])
            np.testing.assert_allclose(arrays["path_positions"][0], row["start"], atol=2e-3)
        tall = self.example.Walks(self.folder, keep=lambda row: row["height"] > 1.7)
        self.assertEqual({row["height"] for row in tall.rows}, {1.8})

    def test_packs_hold_what_folders_hold(self):
        packed = self.example.Walks(self.packed)
        self.assertEqual(packed.rows, self.walks.rows)
        for index in range(len(packed)):
            one, other = packed[index], self.walks[index]
            self.assertEqual(sorted(one), sorted(other))
            for name, array in one.items():
                np.testing.assert_array_equal(array, other[name])

    def test_windows_are_stretches_of_their_walks(self):
        windows = self.example.Windows(self.walks, FRAMES, STRIDE)
        expected = sum(max(0, (row["frames"] - FRAMES) // STRIDE + 1) for row in self.walks.rows)
        self.assertEqual(len(windows), expected)
        for window in (windows[i] for i in range(len(windows))):
            whole, first = self.walks[int(window["walk"])], int(window["first"])
            for name in self.example.BY_FRAME:
                self.assertEqual(len(window[name]), FRAMES, name)
                np.testing.assert_array_equal(window[name], whole[name][first : first + FRAMES])

    def test_a_time_over_the_batches_has_every_window_once_in_an_order_of_its_seed(self):
        windows = self.example.Windows(self.walks, FRAMES, STRIDE)

        def orders(seed):
            batches = self.example.Batches(windows, SIZE, seed)
            return [[(int(w), int(f)) for batch in batches for w, f in zip(batch["walk"], batch["first"])] for _ in range(2)]

        first, second = orders(1)
        self.assertEqual(sorted(first), sorted(windows.places))
        self.assertEqual(sorted(second), sorted(windows.places))
        self.assertNotEqual(first, second)
        self.assertEqual(orders(1), [first, second])
        self.assertNotEqual(orders(2)[0], first)
        batch = next(iter(self.example.Batches(windows, SIZE)))
        self.assertEqual(batch["quaternions"].shape[:2], (SIZE, FRAMES))


if __name__ == "__main__":
    unittest.main()
