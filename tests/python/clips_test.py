"""Captures and walks without a scene: what the module says is what the commands say."""

import json
import pathlib
import tempfile
import unittest

import amble
import numpy as np
from inputs import ROOT, run, short_walk, write_floor

ROOM = ROOT / "environments/scenes/living-room/scene.yaml"


class Clips(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.here = pathlib.Path(cls.folder.name)
        cls.straight = amble.animate(speed=1.2, duration=5)
        cls.turn = amble.animate(speed=1.2, turn=20, duration=5)
        cls.straight.write(cls.here / "straight.bvh")
        cls.turn.write(cls.here / "turn.bvh")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def program(self, name, *arguments):
        """The bytes of what a command writes."""
        run(*arguments, "-o", self.here / name)
        return (self.here / name).read_bytes()

    def written(self, motion):
        motion.write(self.here / "module.bvh")
        return (self.here / "module.bvh").read_bytes()

    def test_animations_are_the_programs(self):
        cases = {("--turn", "20", "--duration", "5", "--speed", "1.2"): self.turn,
                 ("--stairs", ".17,.29"): amble.animate(stairs=(.17, .29)),
                 ("--incline", "0..8", "--height", "1.5"): amble.animate(incline=(0, 8), height=1.5),
                 ("--stride", "0.6..0.8", "--lift", "0.1"): amble.animate(stride=(0.6, 0.8), lift=0.1)}
        for options, motion in cases.items():
            with self.subTest(options):
                self.assertEqual(self.written(motion), self.program("program.bvh", "animate", *options))

    def test_what_no_walk_of_the_library_does_is_refused_with_its_limit(self):
        with self.assertRaisesRegex(amble.InputError, "--turn: is 170 .* expected"):
            amble.animate(turn=170)
        with self.assertRaisesRegex(ValueError, "duration is 0; expected 1 to 600 s"):
            amble.animate(duration=0)
        with self.assertRaisesRegex(amble.NoWalkError, "at most"):
            amble.animate(stairs=(0.45, 0.3))

    def test_a_clip_that_is_read_has_the_frames_that_were_written(self):
        clip = amble.read_clip(self.here / "turn.bvh")
        self.assertEqual(clip.joint_names, self.turn.joint_names)
        np.testing.assert_allclose(clip.positions, self.turn.positions, atol=1e-5)
        self.assertAlmostEqual(clip.frame_time, self.turn.frame_time, places=6)
        self.assertEqual(self.written(clip), (self.here / "turn.bvh").read_bytes())

    def test_an_analysis_is_the_programs(self):
        file = self.here / "turn.bvh"
        found = amble.analyse(file)
        said = json.loads(run("analyse", file, "--json", "--plants", self.here / "plants.csv"))[0]
        self.assertEqual(found.report, {key: value for key, value in said.items() if key != "kind"})
        plants = np.loadtxt(self.here / "plants.csv", delimiter=",", skiprows=1)[:, 1:]
        np.testing.assert_array_equal(found.planted, plants.astype(bool))
        self.assertEqual(found.type, "walk")

    def test_an_edit_is_the_programs(self):
        file = self.here / "straight.bvh"
        for options, edit in {("--stride", "1.1x", "--footlock"): {"stride": "1.1x", "footlock": True},
                              ("--lift", "0.06..0.1"): {"lift": (0.06, 0.1)},
                              ("--stairs", ".17,.29"): {"stairs": (.17, .29)},
                              ("--arrive", "4,1.5"): {"arrive": (4, 1.5)}}.items():
            with self.subTest(options):
                edited = amble.edit(file, **edit)
                self.assertEqual(self.written(edited), self.program("edited.bvh", "edit", file, *options))
        with self.assertRaisesRegex(amble.InputError, "0.6x to 1.4x"):
            amble.edit(file, stride="3x")
        with self.assertRaisesRegex(ValueError, "1.2x"):
            amble.edit(file, stride="longer")

    def test_a_graft_is_the_programs(self):
        files = self.here / "straight.bvh", self.here / "turn.bvh"
        self.assertEqual(self.written(amble.graft(*files, chains=["left_arm"])),
                         self.program("grafted.bvh", "graft", *files, "--chains", "left_arm"))

    def test_a_graph_is_the_programs_and_plays_the_same(self):
        files = self.here / "straight.bvh", self.here / "turn.bvh"
        graph = amble.Graph.build(files, self.here / "module.graph")
        self.assertEqual((self.here / "module.graph").read_bytes(), self.program("program.graph", "graph", "build", *files))
        self.assertEqual(list(graph.clips), ["straight", "turn"])
        ways = graph.query("straight:60", "turn:150")
        said = json.loads(run("graph", "query", self.here / "program.graph", "--from", "straight:60", "--to", "turn:150",
                              "--json"))
        self.assertEqual(ways, said)
        ranges = next(iter(ways["ways"].values()))["play"]
        self.assertEqual(self.written(amble.Graph(self.here / "module.graph").play(ranges)),
                         self.program("played.bvh", "graph", "play", self.here / "program.graph", ranges))
        with self.assertRaises(amble.InputError):
            graph.play("nobody:1-2")

    def test_a_loop_is_the_programs(self):
        amble.Graph.build([self.here / "straight.bvh"], self.here / "loop.graph")
        graph = amble.Graph(self.here / "loop.graph")
        listed = run("graph", "loop", self.here / "loop.graph", "straight").splitlines()
        loops = graph.loops("straight")
        self.assertEqual(listed[20:], [f"{len(loops) - 20} more"] if len(loops) > 20 else [])
        for said, loop in zip(listed[:20], loops):
            self.assertEqual(said, f"{loop['leave']} back to {loop['enter']}  {loop['duration']:.2f} s, "
                                   f"error {loop['error']:.3f} m")
        for options, wishes in {("--count", "3"): {"count": 3}, ("--at", "150"): {"at": 150}}.items():
            with self.subTest(options):
                self.assertEqual(self.written(graph.loop("straight", **wishes)),
                                 self.program("looped.bvh", "graph", "loop", self.here / "loop.graph", "straight", *options))
        with self.assertRaises(amble.NoWalkError):
            graph.loop("straight", error=0)

    def test_a_walk_of_an_engine_is_the_programs(self):
        engine = self.here / "engine.yaml"
        run("library", "engine", "build", self.here / "straight.bvh", "-o", engine)
        walk = amble.Engine(engine).walk((0.6, 1.2), duration=3)
        self.assertEqual(self.written(walk.clip), self.program("faster.bvh", "animate", "--engine", engine, "--speed",
                                                               "0.6..1.2", "--duration", "3"))
        self.assertEqual(walk.speeds.shape, (walk.clip.frames,))
        self.assertGreater(walk.speeds[-1], walk.speeds[0])

    def test_walks_of_an_engine_in_a_library_are_the_programs(self):
        engine = self.here / "person.yaml"
        run("library", "engine", "build", self.here / "straight.bvh", "-o", engine)
        made = {name: self.here / name / "walks.yaml" for name in ("by-program", "by-module")}
        run("library", "add", made["by-program"], engine, "--speed", "0.6,0.9")
        library = amble.Library.new(made["by-module"])
        library.add(engine, speed=[0.6, 0.9])
        made["by-module"].parent.mkdir()
        library.write(made["by-module"])
        self.assertEqual(made["by-module"].read_bytes(), made["by-program"].read_bytes())
        self.assertEqual(library.motions[1]["source"]["speed"], 0.6)
        with self.assertRaisesRegex(ValueError, "speed"):
            library.add(engine, speed=[0.1])
        with self.assertRaisesRegex(amble.InputError, "is a speed engine"):
            library.add(engine)
        with self.assertRaisesRegex(amble.InputError, "is no speed engine"):
            library.add(self.here / "straight.bvh", speed=[1])

    def test_a_validation_is_the_programs(self):
        scene = write_floor(self.here)
        amble.plan(short_walk(scene)).write(self.here / "walk.bvh")
        found = amble.validate(self.here / "walk.bvh", scene, fps=240)
        self.assertEqual(found.report, json.loads(run("validate", self.here / "walk.bvh", "--scene", scene, "--fps", 240,
                                                      "--json")))
        self.assertTrue(found)
        through = amble.validate(self.here / "straight.bvh", ROOM)  # which knows nothing of the room
        self.assertFalse(through)
        self.assertGreater(len(through.contacts), 0)

    def test_a_library_says_whose_motions_it_has(self):
        library = amble.Library()
        walks = [motion for motion in library.motions if motion["kind"] == "walk"]
        self.assertGreater(len(walks), 3)
        for motion in walks:
            self.assertTrue(motion["source"]["licence"] and motion["source"]["credit"], motion["name"])
            self.assertGreater(motion["speed"], 0)
        library.write(self.here / "again.yaml")
        self.assertEqual(amble.Library(self.here / "again.yaml").motions, library.motions)

    def test_a_library_that_is_added_to_is_the_programs(self):
        files = self.here / "straight.bvh", self.here / "turn.bvh"
        made = {name: self.here / name / "mine.yaml" for name in ("program", "module")}
        run("library", "add", made["program"], *files, "--licence", "CC0", "--credit", "nobody")
        library = amble.Library.new(made["module"])
        library.add(*files, licence="CC0", credit="nobody")
        made["module"].parent.mkdir()
        library.write(made["module"])
        self.assertEqual(made["module"].read_bytes(), made["program"].read_bytes())
        count = len(library.motions)
        self.turn.write(self.here / "other.bvh")
        with self.assertRaisesRegex(amble.InputError, "straight"):  # a name that it has
            library.add(self.here / "other.bvh", files[0])
        self.assertEqual(len(library.motions), count)
        with self.assertRaisesRegex(ValueError, "a posture"):
            library.add(files[0], kind="posture", style="old-man")

    def test_what_is_found_is_what_the_program_finds(self):
        paths = ["default", self.here / "straight.bvh", self.here / "turn.bvh"]
        found = amble.Library.find("walk", paths, at_least=0.5)
        said = run("library", "find", *paths, "--type", "walk", "--at-least", "0.5", "--json")
        self.assertEqual(found, json.loads(said))
        self.assertGreater(len(found), 2)
        (self.here / "wrong.bvh").write_text("no")
        with self.assertRaisesRegex(amble.InputError, "wrong.bvh"):
            amble.Library.find("walk", [self.here / "wrong.bvh"])

    def test_a_file_that_is_no_capture_says_where_it_is_wrong(self):
        (self.here / "bad.bvh").write_text("HIERARCHY\nROOT Hips\n{\n  OFFSET 0 0 zero\n}\n")
        with self.assertRaises(amble.InputError) as caught:
            amble.read_clip(self.here / "bad.bvh")
        self.assertEqual((caught.exception.file, caught.exception.line), (str(self.here / "bad.bvh"), 4))


if __name__ == "__main__":
    unittest.main()
