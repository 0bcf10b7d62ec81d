"""Labels of a batch, frame by frame, against what NumPy finds in the BVH beside them."""

import collections
import csv
import json
import pathlib
import tempfile
import unittest

import numpy as np
from inputs import run, write_floor

# Two rooms with a door between them, and a step of 17 cm beyond it.
SCENE = """name: two-rooms
objects:
  - {name: floor, box: {size: [6, 3, 0.1]}, at: [3, 1.5, -0.05]}
  - {name: south, box: {size: [6, 0.1, 2.5]}, at: [3, -0.05, 1.25]}
  - {name: north, box: {size: [6, 0.1, 2.5]}, at: [3, 3.05, 1.25]}
  - {name: west, box: {size: [0.1, 3.2, 2.5]}, at: [-0.05, 1.5, 1.25]}
  - {name: east, box: {size: [0.1, 3.2, 2.5]}, at: [6.05, 1.5, 1.25]}
  - {name: left-post, box: {size: [0.1, 1.1, 2.5]}, at: [2.5, 0.55, 1.25]}
  - {name: right-post, box: {size: [0.1, 1.1, 2.5]}, at: [2.5, 2.45, 1.25]}
  - {name: step, box: {size: [1.8, 3, 0.17]}, at: [5.1, 1.5, 0.085]}
"""
JOB = """scenes:
  - scene: rooms.yaml
    ways:
      - {name: up, start: {at: [0.8, 1.5], heading: 0}, goal: {at: [5.2, 1.5], heading: 0}}
      - {name: back, start: {at: [3.6, 2.2]}, goal: {at: [1, 0.8], heading: 90}}
  - scene: floor.yaml
    ways: [{name: aside, start: {at: [0.8, 0.6]}, goal: {at: [2.2, 0.6]}}]
fps: 60
"""
AXES = {"X": np.array([1.0, 0, 0]), "Y": np.array([0, 1.0, 0]), "Z": np.array([0, 0, 1.0])}
# The BVH is y up: World's x, y, z are its x, -z, y.
TO_WORLD = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])


def turn(axis, angles):
    """F rotations by degrees about an axis (Rodrigues)."""
    x, y, z = AXES[axis]
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    a = np.radians(angles)[:, None, None]
    return np.eye(3) + np.sin(a) * k + (1 - np.cos(a)) * (k @ k)


def read_bvh(file):
    """Joints' names, and where each is in each frame: read and multiplied out here alone."""
    words = iter(pathlib.Path(file).read_text().split())
    names, parents, offsets, channels, stack = [], [], [], [], []
    for word in words:
        if word in ("ROOT", "JOINT", "End"):
            names.append(next(words))
            parents.append(stack[-1] if stack else -1)
            channels.append([])
        elif word == "{":
            stack.append(len(names) - 1)
        elif word == "}":
            stack.pop()
        elif word == "OFFSET":
            offsets.append([float(next(words)) for _ in range(3)])
        elif word == "CHANNELS":
            channels[-1] = [next(words) for _ in range(int(next(words)))]
        elif word == "MOTION":
            break
    next(words)
    count = int(next(words))
    next(words), next(words)
    frame_time = float(next(words))
    rows = np.array([float(word) for word in words]).reshape(count, -1)
    places, turns, column = [], [], 0
    for joint, parent in enumerate(parents):
        place = np.tile(np.array(offsets[joint]), (count, 1))
        own = np.tile(np.eye(3), (count, 1, 1))
        for channel in channels[joint]:
            if channel.endswith("position"):
                place[:, "XYZ".index(channel[0])] = rows[:, column]
            else:
                own = own @ turn(channel[0], rows[:, column])
            column += 1
        if parent >= 0:
            place = places[parent] + np.einsum("fij,fj->fi", turns[parent], place)
            own = turns[parent] @ own
        places.append(place)
        turns.append(own)
    return names, frame_time, np.stack(places, axis=1) @ TO_WORLD.T


class Labels(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.here = pathlib.Path(cls.folder.name)
        (cls.here / "rooms.yaml").write_text(SCENE)
        write_floor(cls.here)
        (cls.here / "job.yaml").write_text(JOB)
        run("batch", cls.here / "job.yaml", "-o", cls.here / "out")
        with open(cls.here / "out/index.csv", newline="") as table:
            cls.rows = list(csv.DictReader(table))
        cls.walks = []
        for row in cls.rows:
            folder = cls.here / "out/walks" / row["walk"][:2] / row["walk"]
            with np.load(folder / "labels.npz") as arrays:
                npz = {name: arrays[name] for name in arrays.files}
            labels = json.loads((folder / "labels.json").read_text())
            cls.walks.append((row, npz, labels, read_bvh(folder / "walk.bvh")))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_all_ways_are_walked(self):
        self.assertEqual([row["status"] for row in self.rows], ["solved"] * 3)

    def test_joints_are_where_the_bvh_has_them(self):
        for _, npz, _, (names, frame_time, places) in self.walks:
            self.assertAlmostEqual(frame_time, float(npz["frame_time"]), 6)
            where = {name: places[:, i] for i, name in enumerate(names)}
            for joint, name in enumerate(npz["joint_names"]):
                off = np.abs(npz["positions"][:, joint] - where[str(name)]).max()
                self.assertLess(off, 1e-4, name)

    def test_the_path_is_walked_at_its_speed_and_turned_along_at_its_rate(self):
        for _, npz, _, _ in self.walks:
            dt = float(npz["frame_time"])
            steps = np.linalg.norm(np.diff(npz["path_positions"][:, :2], axis=0), axis=1)
            mean = 0.5 * (npz["path_speeds"][1:] + npz["path_speeds"][:-1])
            self.assertLess(np.abs(steps - mean * dt).max(), 2e-3)
            self.assertLess(abs(steps.sum() - npz["path_arcs"][-1]), 0.01)
            turns = np.diff(np.unwrap(npz["path_headings"]))
            rates = 0.5 * (npz["path_turn_rates"][1:] + npz["path_turn_rates"][:-1])
            self.assertLess(abs(turns.sum() - rates.sum() * dt), np.radians(3))

    def test_turns_of_the_labels_are_those_of_the_path(self):
        for _, npz, labels, _ in self.walks:
            turns = np.degrees(np.diff(np.unwrap(npz["path_headings"])))
            self.assertAlmostEqual(labels["turned_left"], turns[turns > 0].sum(), 1)
            self.assertAlmostEqual(labels["turned_right"], -turns[turns < 0].sum(), 1)

    def test_a_planted_foot_stays_where_it_is(self):
        for _, npz, _, (names, frame_time, places) in self.walks:
            for side, letter in enumerate(("Left", "Right")):
                toe = next(i for i, name in enumerate(names) if name.startswith(letter + "Toe"))
                moved = np.linalg.norm(np.diff(places[:, toe, :2], axis=0), axis=1) / frame_time
                both = npz["planted"][1:, side] & npz["planted"][:-1, side]
                self.assertGreater(both.sum(), 20)
                self.assertLess(np.median(moved[both]), 0.05)
                self.assertGreater(moved[~both].max(), 1.0)

    def test_plants_are_the_footprints_and_events_their_begins_and_ends(self):
        for _, npz, _, _ in self.walks:
            frames = len(npz["planted"])
            planted = np.zeros((frames, 2), bool)
            events = []
            for side, (first, last) in zip(npz["footprint_sides"], npz["footprint_frames"]):
                planted[first:last + 1, side] = True
                events += [(first, side, True)] if first > 0 else []
                events += [(last + 1, side, False)] if last + 1 < frames else []
            np.testing.assert_array_equal(planted, npz["planted"])
            told = zip(npz["event_frames"], npz["event_sides"], npz["event_strikes"].astype(bool))
            self.assertEqual(sorted(events), sorted(tuple(event) for event in told))

    def test_strikes_are_the_rows_steps(self):
        for row, npz, _, _ in self.walks:
            self.assertEqual(int(npz["event_strikes"].sum()), int(row["steps"]))

    def test_gait_events_of_the_json_are_those_of_the_arrays(self):
        for _, npz, labels, _ in self.walks:
            self.assertEqual(len(labels["gait_events"]), len(npz["event_frames"]))

    def test_contact_and_nearest_agree_with_the_clearances(self):
        for row, npz, _, _ in self.walks:
            self.assertEqual(npz["clearance"].shape, npz["contact"].shape)
            np.testing.assert_array_equal(npz["nearest"] < 0, npz["clearance"] >= 0.25)
            self.assertLess(npz["nearest"].max(), len(npz["object_names"]))
            least = min(0.25, float(row["clearance [m]"]))  # between frames as well
            self.assertGreaterEqual(float(npz["clearance"].min()), least - 1e-5)
            self.assertLess(float(npz["clearance"].min()), least + 0.008)
            touching = {str(npz["part_names"][part]) for part in np.nonzero(npz["contact"].any(axis=0))[0]}
            self.assertTrue(touching and all("sole" in name or "toes" in name or "instep" in name for name in touching), touching)

    def test_a_part_is_as_near_to_a_post_as_its_joints_are(self):
        # The pelvis' middle is between its joints: its distance in plan to the posts, less what it
        # is thick, is the clearance, up to the thickness of a pelvis.
        _, npz, _, (names, _, places) = self.walks[0]
        pelvis = [str(name) for name in npz["part_names"]].index("pelvis")
        hips = places[:, 0, :2]
        distance = np.full(len(hips), np.inf)
        for middle, size in (((2.5, 0.55), (0.1, 1.1)), ((2.5, 2.45), (0.1, 1.1))):
            beyond = np.maximum(np.abs(hips - middle) - np.array(size) / 2, 0)
            distance = np.minimum(distance, np.linalg.norm(beyond, axis=1))
        near = npz["clearance"][:, pelvis] < 0.25
        self.assertGreater(near.sum(), 5)
        thick = distance[near] - npz["clearance"][near, pelvis]
        self.assertGreater(thick.min(), 0.08)
        self.assertLess(thick.max(), 0.30)
        posts = {str(npz["object_names"][i]) for i in npz["nearest"][near, pelvis]}
        self.assertLessEqual(posts, {"left-post", "right-post"})

    def test_who_stands_is_slow_and_who_walks_gets_on(self):
        for _, npz, labels, _ in self.walks:
            names = [str(name) for name in npz["activity_names"]]
            speed = npz["path_speeds"]
            still = np.isin(npz["activity"], [names.index("stand"), names.index("turn")])
            np.testing.assert_array_equal(still, speed < 0.02)
            stands = npz["activity"] == names.index("stand")
            self.assertTrue(npz["planted"][stands].all())
            self.assertLessEqual(np.abs(npz["path_turn_rates"][stands]).max(initial=0), 0.05)
            self.assertEqual(names[npz["activity"][-1]], "stand")

    def test_stretches_of_activities_are_the_frames(self):
        for _, npz, labels, _ in self.walks:
            dt = float(npz["frame_time"])
            names = [str(name) for name in npz["activity_names"]]
            frames = []
            for stretch in labels["activities"]:
                count = round((stretch["to"] - stretch["from"]) / dt) + 1
                frames += [names.index(stretch["activity"])] * count
            np.testing.assert_array_equal(frames, npz["activity"])

    def test_only_who_goes_up_climbs(self):
        up, back, aside = self.walks
        count = collections.Counter(up[1]["activity_names"][i] for i in up[1]["activity"])
        self.assertGreater(count["climb"], 10)
        self.assertEqual(count["descend"], 0)
        self.assertEqual(up[2]["flights"], [1])
        rise = up[1]["path_positions"][-1, 2] - up[1]["path_positions"][0, 2]
        self.assertAlmostEqual(rise, 0.17, 2)
        self.assertEqual(aside[2]["flights"] + back[2]["flights"], [])

    def test_shares_of_motions_are_those_of_the_json(self):
        for _, npz, labels, _ in self.walks:
            np.testing.assert_allclose(npz["motion_shares"].sum(axis=1), 1, atol=1e-5)
            mean = collections.defaultdict(float)
            for name, share in zip(npz["motion_names"], npz["motion_shares"].mean(axis=0)):
                mean[str(name)] += float(share)
            for motion in labels["motions"]:
                self.assertAlmostEqual(motion["share"], mean[motion["motion"]], 4)

    def test_the_gap_is_as_wide_as_the_door(self):
        for row, npz, labels, _ in self.walks:
            doors = [gap for gap in labels["gaps"] if {gap["left"], gap["right"]} == {"left-post", "right-post"}]
            if row["way"] == "aside":
                self.assertEqual(doors, [])
                continue
            self.assertEqual(len(doors), 1)
            self.assertAlmostEqual(doors[0]["width"], 0.8, delta=0.06)
            at = round(doors[0]["time"] / float(npz["frame_time"]))
            self.assertAlmostEqual(npz["path_positions"][at, 0], 2.5, delta=0.25)
            self.assertIn("through a door", labels["caption"])

    def test_cameras_see_head_and_hips_in_their_picture(self):
        self.assertGreater(len(self.walks[2][2]["cameras"]), 0)
        for _, _, labels, (names, _, places) in self.walks:
            for camera in labels["cameras"]:
                eye, target = np.array(camera["position"]), np.array(camera["target"])
                half = np.radians(camera["field_of_view"]) / 2
                ahead = (target - eye) / np.linalg.norm(target - eye)
                for joint in ("Hips", "Head"):
                    ray = places[:, names.index(joint)] - eye
                    angle = np.arccos(ray @ ahead / np.linalg.norm(ray, axis=1))
                    self.assertLess(angle.max(), half, joint)

    def test_credits_are_those_of_the_motions(self):
        all_credits = set()
        for _, _, labels, _ in self.walks:
            told = {f"{motion['licence']}: {motion['credit']}" for motion in labels["motions"]}
            self.assertEqual(told, set(labels["credits"]))
            all_credits |= told
        lines = (self.here / "out/CREDITS.md").read_text().splitlines()
        self.assertEqual([line[2:] for line in lines if line.startswith("- ")], sorted(all_credits))

    def test_statistics_count_what_the_rows_say(self):
        stats = json.loads(run("batch", "stats", self.here / "out", "--json"))
        lengths = sorted(float(row["length [m]"]) for row in self.rows)
        self.assertEqual(stats["walks"], len(self.rows))
        self.assertAlmostEqual(stats["measures"]["length"]["mean"], np.mean(lengths), 5)
        self.assertAlmostEqual(stats["measures"]["length"]["most"], lengths[-1], 5)
        seconds = collections.Counter()
        for _, npz, _, _ in self.walks:
            for i in npz["activity"]:
                seconds[str(npz["activity_names"][i])] += float(npz["frame_time"])
        for name, told in stats["activities"].items():
            self.assertAlmostEqual(told, seconds[name], 2)


if __name__ == "__main__":
    unittest.main()
