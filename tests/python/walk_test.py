"""Walks that Python plans are those that the program plans."""

import gc
import json
import pathlib
import pickle
import tempfile
import unittest

import amble
import numpy as np
from inputs import ROOT, run, short_walk, write_floor

SCENARIO = ROOT / "scenarios" / "living-room.yaml"


def without_times(report):
    return {key: value for key, value in report.items() if key != "times"}


class Walks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.here = pathlib.Path(cls.folder.name)
        run("plan", SCENARIO, "-o", cls.here / "program", "--formats", "bvh,json,npz,html")
        cls.walk = amble.plan(SCENARIO)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_the_bvh_has_the_programs_bytes(self):
        self.assertEqual(self.walk.bvh, (self.here / "program/walk.bvh").read_bytes())

    def test_the_report_is_the_programs_but_for_its_times(self):
        report = json.loads((self.here / "program/report.json").read_text())
        self.assertEqual(without_times(self.walk.report), without_times(report))
        self.assertEqual(self.walk.report["times"].keys(), report["times"].keys())

    def test_arrays_are_those_of_the_npz_to_the_bit(self):
        with np.load(self.here / "program/walk.npz") as arrays:
            for name in set(arrays.files) - {"title"}:
                ours, theirs = np.asarray(self.walk.arrays[name]), arrays[name]
                self.assertEqual((ours.dtype, ours.shape), (theirs.dtype, theirs.shape), name)
                self.assertEqual(ours.tobytes(), theirs.tobytes(), name)
            self.assertLessEqual(set(self.walk.arrays), set(arrays.files))

    def test_files_that_it_writes_have_the_programs_bytes(self):
        self.walk.write(self.here / "module", ["bvh", "json", "npz", "html"])
        for name in ["walk.bvh", "walk.npz"]:
            self.assertEqual((self.here / "module" / name).read_bytes(), (self.here / "program" / name).read_bytes())
        self.assertEqual(sorted(file.name for file in (self.here / "module").iterdir()),
                         ["report.json", "walk.bvh", "walk.html", "walk.npz"])
        self.walk.write(self.here / "alone.npz")
        self.assertEqual((self.here / "alone.npz").read_bytes(), (self.here / "program/walk.npz").read_bytes())

    def test_a_file_of_no_format_and_a_folder_that_cannot_be_are_refused(self):
        with self.assertRaisesRegex(amble.InputError, r"walk\.foo: no format .* \.bvh"):
            self.walk.write(self.here / "walk.foo")
        (self.here / "file").write_text("")
        with self.assertRaises(amble.InputError):
            self.walk.write(self.here / "file" / "out")
        with self.assertRaisesRegex(ValueError, "'tiff'"):
            self.walk.write(self.here / "out", ["tiff"])
        self.assertFalse((self.here / "out").exists())

    def test_views_keep_what_they_are_of(self):
        walk = amble.plan(SCENARIO, fps=30)
        roots, headings = walk.root_positions, walk.path_headings
        copies = roots.copy(), headings.copy()
        self.assertFalse(roots.flags.owndata or headings.flags.owndata)
        del walk
        gc.collect()
        amble.plan(SCENARIO, fps=30)  # would take the memory again
        np.testing.assert_array_equal(roots, copies[0])
        np.testing.assert_array_equal(headings, copies[1])

    def test_arrays_cannot_be_written_to_and_are_made_once(self):
        for name, array in self.walk.arrays.items():
            if isinstance(array, np.ndarray):
                self.assertFalse(array.flags.writeable, name)
        self.assertIs(self.walk.positions, self.walk.positions)

    def test_positions_are_what_quaternions_and_offsets_say(self):
        """Forward kinematics in NumPy."""
        walk = self.walk
        matrices = np.empty((walk.frames, len(walk.joint_names), 3, 3))
        w, x, y, z = np.moveaxis(walk.quaternions, -1, 0)
        local = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                          2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                          2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
                         axis=-1).reshape(*w.shape, 3, 3)
        for joint, parent in enumerate(walk.parents):
            if parent < 0:
                matrices[:, joint] = local[:, joint]
                np.testing.assert_array_equal(walk.positions[:, joint], walk.root_positions)
                continue
            matrices[:, joint] = matrices[:, parent] @ local[:, joint]
            at = walk.positions[:, parent] + matrices[:, parent] @ walk.offsets[joint]
            np.testing.assert_allclose(walk.positions[:, joint], at, atol=1e-9)

    def test_the_least_clearance_is_the_reports(self):
        self.assertEqual(self.walk.clearance.shape, (self.walk.frames,))
        least = self.walk.report["clearance"]
        # Which is measured between frames as well.
        self.assertGreaterEqual(self.walk.clearance.min(), least["min"] - 1e-9)
        self.assertLess(self.walk.clearance.min(), least["min"] + 0.008)
        self.assertAlmostEqual(self.walk.clearance.argmin() * self.walk.frame_time, least["time"], delta=self.walk.frame_time)

    def test_planted_feet_are_those_of_the_footprints(self):
        planted = np.zeros_like(self.walk.planted)
        for side, (first, last) in zip(self.walk.footprint_sides, self.walk.footprint_frames):
            planted[first:last + 1, side] = True
        np.testing.assert_array_equal(planted, self.walk.planted)

    def test_settings_of_the_call_are_those_of_the_command_line(self):
        run("plan", SCENARIO, "-o", self.here / "other", "--formats", "bvh", "--seed", 7, "--fps", 30, "--planner",
            "rrt", "--names", "mixamo")
        walk = amble.plan(SCENARIO, seed=7, fps=30, planner="rrt", names="mixamo", threads=1)
        self.assertEqual(walk.bvh, (self.here / "other/walk.bvh").read_bytes())
        self.assertEqual(walk.joint_names[0], "mixamorig_Hips")


class Scenarios(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.here = pathlib.Path(folder.name)
        self.floor = write_floor(self.here)

    def test_a_dict_is_what_its_file_is(self):
        values = short_walk(self.floor, planner={"seed": 3})
        (self.here / "short.yaml").write_text(json.dumps(values))
        from_file, from_dict = amble.plan(self.here / "short.yaml"), amble.plan(values)
        self.assertTrue(from_file.solved)
        self.assertEqual(from_file.bvh, from_dict.bvh)

    def test_a_dict_may_hold_paths_and_numpys_numbers(self):
        values = short_walk(self.floor)
        numbers = {**values, "scene": self.floor, "goal": {"at": np.array([2.5, 1.5]), "heading": np.float64(0)}}
        self.assertEqual(amble.plan(values).bvh, amble.plan(numbers).bvh)
        with self.assertRaisesRegex(TypeError, "set in a scenario"):
            amble.plan({**values, "walk": {1, 2}})
        with self.assertRaisesRegex(ValueError, "nan or inf in a scenario; expected"):
            amble.plan({**values, "start": {"at": [float("nan"), 1]}})
        with self.assertRaisesRegex(TypeError, "a scenario is of type bytes; expected"):
            amble.plan(b"kerb")

    def test_a_name_is_a_scenario_that_comes_with_amble(self):
        self.assertEqual(amble.plan("kerb", fps=24).bvh, amble.plan(ROOT / "scenarios/kerb.yaml", fps=24).bvh)

    def test_wrong_input_says_file_and_line(self):
        file = self.here / "wrong.yaml"
        file.write_text("scene: floor.yaml\nstart: {at: [1, 1.5]}\ngoal: {at: [2.5, 1.5]}\nwalk: {sped: 1}\n")
        with self.assertRaises(amble.InputError) as caught:
            amble.plan(file)
        error = caught.exception
        self.assertEqual((error.file, error.line), (str(file), 4))
        self.assertIn("speed", error.expected)
        self.assertEqual(str(error), f"{file}:4: {error.problem}; expected {error.expected}")
        again = pickle.loads(pickle.dumps(error))  # as another process raises it
        self.assertEqual((str(again), again.file, again.line), (str(error), error.file, error.line))

    def test_a_wrong_dict_says_what_and_no_line_that_nobody_has_seen(self):
        with self.assertRaises(amble.InputError) as caught:
            amble.plan(short_walk(self.floor, walk={"sped": 1}), name="mine")
        self.assertEqual((caught.exception.file, caught.exception.line), ("<mine>", None))
        self.assertTrue(str(caught.exception).startswith("<mine>: "))

    def test_names_of_any_letters_are_told(self):
        odd = self.here / "räume\n'<script>'.yaml"
        with self.assertRaises(amble.InputError) as caught:
            amble.plan(short_walk(odd))
        self.assertNotIn("\n", str(caught.exception))

    def test_that_there_is_no_walk_is_a_result(self):
        walk = amble.plan("sealed-goal")
        self.assertFalse(walk)
        self.assertEqual((walk.status, walk.bvh), ("no_walk", b""))
        self.assertEqual(walk.why, walk.report["why"])
        for ask in (lambda: walk.positions, lambda: walk.clearance, lambda: walk.frames):
            with self.assertRaises(amble.NoWalkError) as caught:
                ask()
            self.assertIn(walk.why, str(caught.exception))
        walk.write(self.here / "none")
        self.assertTrue((self.here / "none/report.json").exists())
        self.assertFalse((self.here / "none/walk.bvh").exists())
        with self.assertRaisesRegex(amble.InputError, "there is no walk"):
            walk.write(self.here / "none.bvh")

    def test_numbers_beyond_their_range_are_refused_with_it(self):
        for name, value in {"fps": 10, "threads": 0, "seed": -1, "time_limit": 0, "names": "mixmo"}.items():
            with self.subTest(name), self.assertRaisesRegex(ValueError, name):
                amble.plan(short_walk(self.floor), **{name: value})


if __name__ == "__main__":
    unittest.main()
