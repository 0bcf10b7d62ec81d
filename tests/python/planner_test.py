"""A planner is made once and asked many times, from many threads; Ctrl-C stops what takes long; nothing grows."""

import concurrent.futures
import gc
import os
import pathlib
import signal
import tempfile
import threading
import time
import unittest

import amble
from inputs import ROOT, run, short_walk, write_floor

ROOM = ROOT / "environments/scenes/living-room/scene.yaml"
START, GOAL = {"at": [1, 1], "heading": 90}, {"at": [6.5, 4.8], "heading": 0}


def resident():
    """Memory of the process [bytes]."""
    return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class Planners(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.here = pathlib.Path(cls.folder.name)
        cls.floor = amble.Planner(write_floor(cls.here))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_a_planner_answers_as_the_program_does_by_its_roadmap(self):
        planner = amble.Planner(ROOM, 1.7, walk={"speed": 1.1})
        planner.save(self.here / "room.roadmap")
        scenario = self.here / "room.yaml"
        scenario.write_text(f"scene: {ROOM}\ncharacter: {{height: 1.7}}\nwalk: {{speed: 1.1}}\n"
                            "start: {at: [1, 1], heading: 90}\ngoal: {at: [6.5, 4.8], heading: 0}\n")
        run("roadmap", "build", scenario, "-o", self.here / "program.roadmap")
        self.assertEqual((self.here / "room.roadmap").read_bytes(), (self.here / "program.roadmap").read_bytes())
        run("plan", scenario, "--roadmap", self.here / "program.roadmap", "-o", self.here / "out", "--formats", "bvh")
        walk = planner.plan(START, GOAL, name="room")
        self.assertEqual(walk.bvh, (self.here / "out/walk.bvh").read_bytes())
        kept = amble.Planner(ROOM, {"height": 1.7}, walk={"speed": 1.1}, roadmap=self.here / "room.roadmap")
        self.assertEqual(kept.plan(START, GOAL).bvh, walk.bvh)
        with self.assertRaisesRegex(amble.InputError, "stale roadmap.*speed"):
            amble.Planner(ROOM, 1.7, walk={"speed": 1.3}, roadmap=self.here / "room.roadmap")

    def test_answers_from_many_threads_are_those_of_one(self):
        ends = [([1, 1], [1.5 + 0.25 * i, 2 - 0.1 * i]) for i in range(6)]
        alone = [self.floor.plan(*end).bvh for end in ends]
        with concurrent.futures.ThreadPoolExecutor(4) as threads:
            together = list(threads.map(lambda end: self.floor.plan(*end).bvh, ends[::-1]))
        self.assertEqual(together[::-1], alone)
        self.assertEqual(len(set(alone)), len(alone))

    def test_plans_from_many_threads_are_those_of_one(self):
        """Each reads its scene's meshes by processes of its own."""
        alone = amble.plan("living-room", fps=30)
        with concurrent.futures.ThreadPoolExecutor(3) as threads:
            walks = list(threads.map(lambda _: amble.plan("living-room", fps=30), range(3)))
        self.assertEqual([walk.bvh for walk in walks], [alone.bvh] * 3)

    def test_others_run_while_a_walk_is_planned(self):
        """A plan that kept the interpreter's lock would let this thread do nothing until it had ended."""
        begun, ended = threading.Event(), threading.Event()

        def work():
            begun.set()
            self.floor.plan([1, 1], [3, 2])
            ended.set()

        thread = threading.Thread(target=work)
        thread.start()
        begun.wait()
        turns = 0
        while not ended.wait(0.0005):
            turns += 1
        thread.join()
        self.assertGreater(turns, 3)

    def test_a_place_where_nobody_can_stand_is_wrong_input(self):
        with self.assertRaises(amble.InputError) as caught:
            self.floor.plan([1, 1], [9, 9], name="far")
        self.assertEqual((caught.exception.file, caught.exception.line), ("<far>", None))
        self.assertIn("'goal.at' has no floor under it", str(caught.exception))

    def test_what_is_no_place_is_told_as_it_was_given(self):
        for wrong in None, "kitchen", 3:
            with self.assertRaisesRegex(TypeError, f"{wrong!r} is no place; expected"):
                self.floor.plan([1, 1.5], wrong)

    def test_via_points_are_passed(self):
        via = [2.5, 2.4]
        walk = self.floor.plan([1, 1], [3, 1], via=[via])
        away = ((walk.path_positions[:, :2] - via) ** 2).sum(axis=1).min()
        self.assertLess(away, 1e-3)

    def test_queries_share_a_roadmap_and_have_their_names(self):
        run_in = self.here / "queries.yaml"
        run_in.write_text("scene: floor.yaml\nqueries:\n"
                          "  - {name: there, start: {at: [1, 1]}, goal: {at: [3, 2]}}\n"
                          "  - {name: back, start: {at: [3, 2]}, goal: {at: [1, 1]}}\n")
        walks = amble.plan_queries(run_in)
        run("plan", run_in, "-o", self.here / "queries", "--formats", "bvh")
        self.assertEqual(list(walks), ["there", "back"])
        for name, walk in walks.items():
            self.assertEqual(walk.bvh, (self.here / "queries" / name / "walk.bvh").read_bytes())
        self.assertGreater(walks["there"].clearance.min(), 0)
        walks["back"].write(self.here / "back.npz")
        with self.assertRaisesRegex(amble.InputError, "several walks"):
            amble.plan(run_in)

    def test_many_walks_take_no_more_memory_than_a_few(self):
        def ask(count):
            for i in range(count):
                walk = self.floor.plan([1, 1.5], [2 + 0.01 * (i % 50), 1.5])
                walk.arrays, walk.report
                with self.assertRaises(amble.InputError):
                    self.floor.plan([1, 1], [9, 9])
            gc.collect()
            return resident()

        before = ask(20)
        # What one walk keeps, its arrays and its file, is 300 kB.
        self.assertLess(ask(60) - before, 1_000_000)

    def test_thousands_of_plans_take_no_more_memory_than_a_hundred(self):
        """Each of which reads its scene and its library. Ten thousand: docs/performance.md."""
        def ask(count):
            for i in range(count):
                walk = amble.plan(short_walk(self.here / "floor.yaml", planner={"seed": i}), fps=24, threads=1)
                walk.arrays, walk.report
            gc.collect()
            return resident()

        before = ask(100)
        self.assertLess(ask(200) - before, 1_500_000)


class Stopping(unittest.TestCase):
    def stopped_by(self, number, endless):
        ask = threading.Timer(0.3, os.kill, (os.getpid(), number))
        ask.start()
        try:
            endless()
        finally:
            ask.join()

    def test_ctrl_c_ends_a_plan(self):
        """Of a planner that uses all of its samples."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        search = {"name": "rrtstar", "max_failures": 1_000_000, "time_limit": 600}
        scenario = short_walk(write_floor(folder.name), planner=search)
        with self.assertRaises(KeyboardInterrupt):
            self.stopped_by(signal.SIGINT, lambda: amble.plan(scenario))

    def test_ctrl_c_ends_the_growing_of_a_roadmap(self):
        with self.assertRaises(KeyboardInterrupt):
            self.stopped_by(signal.SIGINT, lambda: amble.Planner(ROOM, max_failures=1_000_000, time_limit=600))

    def test_ctrl_c_ends_the_building_of_a_graph(self):
        """Of so many frames that clustering them takes a minute."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        here = pathlib.Path(folder.name)
        walk = amble.animate(duration=200, turn=5)
        walk.write(here / "long.bvh")
        with self.assertRaises(KeyboardInterrupt):
            self.stopped_by(signal.SIGINT, lambda: amble.Graph.build([here / "long.bvh"], here / "long.graph", fps=240))
        self.assertFalse((here / "long.graph").exists())

    def long_walk(self):
        """Of two minutes."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        amble.animate(duration=120, turn=5).write(pathlib.Path(folder.name) / "long.bvh")
        return amble.read_clip(pathlib.Path(folder.name) / "long.bvh")

    def seconds_until_ctrl_c(self, work):
        began = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            self.stopped_by(signal.SIGINT, work)
        return time.monotonic() - began

    def seconds_of(self, work):
        began = time.monotonic()
        work()
        return time.monotonic() - began

    def test_ctrl_c_ends_an_animation_before_its_last_try(self):
        whole = self.seconds_of(lambda: amble.animate(duration=600, turn=5))
        self.assertLess(self.seconds_until_ctrl_c(lambda: amble.animate(duration=600, turn=5)), 0.75 * whole)

    def test_ctrl_c_ends_editing_and_grafting(self):
        clip = self.long_walk()

        def again(work):
            for _ in range(1000):
                work()

        self.seconds_until_ctrl_c(lambda: again(lambda: amble.edit(clip, stride="1.05x")))
        self.seconds_until_ctrl_c(lambda: again(lambda: amble.graft(clip, clip)))

    def test_whatever_a_handler_raises_ends_a_plan(self):
        class Enough(Exception):
            pass

        def handler(number, frame):
            raise Enough

        before = signal.signal(signal.SIGUSR1, handler)
        self.addCleanup(signal.signal, signal.SIGUSR1, before)
        with self.assertRaises(Enough):
            self.stopped_by(signal.SIGUSR1, lambda: amble.Planner(ROOM, max_failures=1_000_000, time_limit=600))

    def test_a_time_limit_that_ends_a_roadmap_is_said(self):
        with self.assertRaisesRegex((amble.InputError, TimeoutError), "the time limit passed"):  # growing, or reading
            amble.Planner(ROOM, max_failures=1_000_000, time_limit=2)


if __name__ == "__main__":
    unittest.main()
