"""What the module makes, measured anew by NumPy: walks, edits, grafts; what must not change them does not."""

import concurrent.futures
import pathlib
import tempfile
import unittest

import amble
import numpy as np
from inputs import short_walk, write_floor


def turned(quaternions, vectors):
    """Vectors turned by unit quaternions w, x, y, z."""
    w, q = quaternions[..., :1], quaternions[..., 1:]
    t = 2 * np.cross(q, vectors)
    return vectors + w * t + np.cross(q, t)


def product(a, b):
    """Of quaternions."""
    w = a[..., :1] * b[..., :1] - (a[..., 1:] * b[..., 1:]).sum(-1, keepdims=True)
    v = a[..., :1] * b[..., 1:] + b[..., :1] * a[..., 1:] + np.cross(a[..., 1:], b[..., 1:])
    return np.concatenate([w, v], axis=-1)


def kinematics(arrays):
    """Positions of joints by their quaternions and offsets alone."""
    parents, offsets = arrays["parents"], arrays["offsets"]
    own = np.asarray(arrays["quaternions"], float)
    places, turns = [np.asarray(arrays["root_positions"], float)], [own[:, 0]]
    for joint in range(1, len(parents)):
        parent = parents[joint]
        turns.append(product(turns[parent], own[:, joint]))
        step = np.broadcast_to(offsets[joint], (len(own), 3))
        places.append(places[parent] + turned(turns[parent], step))
    return np.stack(places, axis=1)


class Measures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.here = pathlib.Path(cls.folder.name)
        cls.walk = amble.animate(speed=1.2, duration=6)
        cls.turn = amble.animate(speed=1.2, turn=20, duration=6)
        cls.walk.write(cls.here / "walk.bvh")
        cls.clip = amble.read_clip(cls.here / "walk.bvh")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_quaternions_are_of_length_one_and_say_where_joints_are(self):
        for made in (self.walk, self.turn):
            arrays = made.arrays
            length = np.linalg.norm(np.asarray(arrays["quaternions"], float), axis=-1)
            self.assertLess(np.abs(length - 1).max(), 1e-6)
            off = np.abs(kinematics(arrays) - np.asarray(arrays["positions"])).max()
            self.assertLess(off, 1e-4)

    def test_bones_do_not_stretch(self):
        for made in (self.walk, self.turn):
            parents = np.asarray(made.arrays["parents"])
            places = np.asarray(made.arrays["positions"], float)
            bones = np.linalg.norm(places[:, 1:] - places[:, parents[1:]], axis=-1)
            self.assertLess(np.ptp(bones, axis=0).max(), 1e-4)

    def test_a_walk_has_the_speed_that_was_asked_for(self):
        for speed in (0.8, 1.0, 1.2, 1.5):
            places = np.asarray(amble.animate(speed=speed, duration=8).arrays["path_positions"], float)
            middle = places[120:-120]
            walked = np.linalg.norm(np.diff(middle[:, :2], axis=0), axis=1).sum()
            self.assertAlmostEqual(walked / (len(middle) - 1) * 60, speed, delta=0.04 * speed)

    def test_a_turn_has_the_rate_that_was_asked_for_to_either_side(self):
        for rate in (-20, 10, 20):
            headings = np.unwrap(amble.animate(turn=rate, duration=8).arrays["path_headings"])
            middle = headings[150:-150]
            told = np.degrees(middle[-1] - middle[0]) / (len(middle) - 1) * 60
            self.assertAlmostEqual(told, rate, delta=1.5)

    def test_frames_are_as_many_as_the_rate_says(self):
        for fps in (24, 30, 60, 120):
            made = amble.animate(duration=4, fps=fps)
            self.assertAlmostEqual(float(made.arrays["frame_time"]), 1 / fps, 9)
            self.assertAlmostEqual((len(made.arrays["positions"]) - 1) / fps, 4, delta=0.6)

    def test_a_taller_walker_is_as_much_taller_in_every_bone(self):
        small, tall = (amble.animate(height=h, duration=3).arrays["offsets"] for h in (1.5, 1.8))
        np.testing.assert_allclose(np.asarray(tall)[1:], np.asarray(small)[1:] * (1.8 / 1.5), atol=1e-6)

    def test_planted_ankles_stay(self):
        for made in (self.walk, self.turn):
            arrays = made.arrays
            names = list(arrays["joint_names"])
            for side, name in enumerate(("LeftFoot", "RightFoot")):
                foot = np.asarray(arrays["positions"], float)[:, names.index(name)]
                for owner, (first, last) in zip(arrays["footprint_sides"], arrays["footprint_frames"]):
                    if owner != side or last - first < 8:
                        continue
                    middle = (first + last) // 2
                    self.assertLess(np.linalg.norm(np.ptp(foot[middle - 2:middle + 3, :2], axis=0)), 0.02)

    def test_an_edited_stride_is_as_much_longer_as_was_asked(self):
        before = amble.analyse(self.clip)
        mean = np.mean([step["length"] for step in before.steps[2:-2]])
        for factor in (0.85, 1.15):
            after = amble.analyse(amble.edit(self.clip, stride=f"{factor}x"))
            got = np.mean([step["length"] for step in after.steps[2:-2]])
            self.assertAlmostEqual(got / mean, factor, delta=0.05)

    def test_what_is_edited_arrives_where_it_was_told(self):
        for to in ((5.0, 0.6), (6.0, -0.5)):
            made = amble.edit(self.clip, arrive=to)
            made.write(self.here / "there.bvh")
            places = amble.read_clip(self.here / "there.bvh").arrays["root_positions"]
            np.testing.assert_allclose(np.asarray(places)[-1, :2], to, atol=1e-3)

    def test_an_edit_changes_nothing_of_its_clip(self):
        before = np.array(self.clip.arrays["quaternions"])
        amble.edit(self.clip, lift="1.5x")
        np.testing.assert_array_equal(before, self.clip.arrays["quaternions"])

    def test_a_graft_moves_the_arms_alone(self):
        self.turn.write(self.here / "turn.bvh")
        upper = amble.read_clip(self.here / "turn.bvh")
        made = amble.graft(self.clip, upper, chains=["left_arm"], as_it_falls=True)
        names = list(self.clip.arrays["joint_names"])
        frames = min(len(made.arrays["quaternions"]), len(self.clip.arrays["quaternions"]))
        moved = set()
        for joint, name in enumerate(names):
            a = np.asarray(made.arrays["quaternions"], float)[:frames, joint]
            b = np.asarray(self.clip.arrays["quaternions"], float)[:frames, joint]
            if np.abs(np.abs((a * b).sum(-1)) - 1).max() > 1e-6:
                moved.add(str(name))
        self.assertTrue(moved)
        self.assertTrue(all(name.startswith("Left") for name in moved), moved)

    def test_threads_make_the_same_as_one_after_another(self):
        asked = [{"speed": 0.8 + 0.1 * i, "turn": 3 * i, "duration": 3} for i in range(6)]
        alone = [np.array(amble.animate(**how).arrays["positions"]) for how in asked]
        with concurrent.futures.ThreadPoolExecutor(3) as pool:
            together = list(pool.map(lambda how: np.array(amble.animate(**how).arrays["positions"]), asked))
        for one, other in zip(alone, together):
            np.testing.assert_array_equal(one, other)

    def test_arrays_cannot_be_written_and_outlive_their_walk(self):
        made = amble.animate(duration=3)
        for name in made.arrays:
            array = made.arrays[name]
            if isinstance(array, np.ndarray) and array.ndim > 0:
                with self.assertRaises(ValueError, msg=name):
                    array[...] = array
        kept, copy = made.arrays["positions"], np.array(made.arrays["positions"])
        del made
        amble.animate(duration=3.5)
        np.testing.assert_array_equal(kept, copy)

    def test_numbers_beyond_their_range_are_refused_by_name(self):
        for name, values in {"speed": (0, -1, 99, float("nan")), "turn": (9999, float("inf")),
                             "duration": (0, -1, float("nan")), "fps": (0, 1, 1e9),
                             "height": (0.01, 30, float("nan"))}.items():
            for value in values:
                with self.assertRaises((ValueError, amble.InputError), msg=f"{name} {value}") as raised:
                    amble.animate(**{name: value})
                self.assertIn(name, str(raised.exception))

    def test_edits_that_contradict_each_other_are_refused(self):
        for pair in ({"stairs": (0.17, 0.3), "incline": 5}, {"stairs": (0.17, 0.3), "stride": 0.6},
                     {"stairs": (0.17, 0.3), "arrive": (1, 1)}, {"arrive": (1, 1), "stride": 0.6}):
            with self.assertRaisesRegex(ValueError, " beside "):
                amble.edit(self.clip, **pair)

    def test_what_is_wrong_in_a_scene_is_told_with_file_and_line(self):
        scene = self.here / "broken.yaml"
        scene.write_text("name: broken\nobjects:\n  - {name: floor, box: {size: [1, 1]}}\n")
        with self.assertRaises(amble.InputError) as raised:
            amble.plan(short_walk(scene))
        self.assertIn("broken.yaml:3: ", str(raised.exception))
        with self.assertRaises(amble.InputError) as raised:
            amble.Planner(scene)
        self.assertIn("broken.yaml:3: ", str(raised.exception))

    def test_what_is_not_written_leaves_no_file(self):
        for name in ("walk.xyz", "nowhere/walk.bvh"):
            with self.assertRaises((amble.InputError, OSError)):
                amble.edit(self.clip, lift="1.2x").write(self.here / name)
            self.assertFalse((self.here / name).exists())

    def test_a_validation_finds_the_walk_that_was_pushed_into_a_box(self):
        floor = write_floor(self.here)
        walk = amble.plan(short_walk(floor))
        (self.here / "planned.bvh").write_bytes(walk.bvh)
        self.assertTrue(amble.validate(self.here / "planned.bvh", floor, unit=1.0))
        blocked = self.here / "blocked.yaml"
        blocked.write_text(floor.read_text() + "  - {name: crate, box: {size: [0.3, 0.3, 1]}, at: [1.8, 1.5, 0.5]}\n")
        found = amble.validate(self.here / "planned.bvh", blocked, unit=1.0)
        self.assertFalse(found)
        self.assertEqual({contact["object"] for contact in found.contacts}, {"crate"})


if __name__ == "__main__":
    unittest.main()
