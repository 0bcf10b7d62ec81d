"""examples/planner_benchmark.py writes what OMPL's benchmark tools read: its tutorial on benchmarking has the grammar."""

import importlib.util
import pathlib
import sys
import tempfile
import unittest

import amble
from inputs import ROOT

RUNS = 2


def load_example():
    spec = importlib.util.spec_from_file_location("planner_benchmark", ROOT / "examples" / "planner_benchmark.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Lines:
    """Of a log, one after another; each is told what it has to end or begin with."""

    def __init__(self, text):
        self.left = text.splitlines()

    def next(self, begin="", end=""):
        line = self.left.pop(0)
        if not line.startswith(begin) or not line.endswith(end):
            raise AssertionError(f"{line!r}; expected {begin!r} ... {end!r}")
        return line[len(begin) : len(line) - len(end)]

    def count(self, end):
        return int(self.next(end=end))


def read_log(text):
    """{planner: [{property: value}]}, by the grammar, read to the last line."""
    lines = Lines(text)
    lines.next("Amble version ")
    if len(lines.next("Experiment ").split()) != 1:
        raise AssertionError("an experiment's name is one word")
    lines.count(" experiment properties")
    lines.next("Running on ")
    lines.next("Starting at ")
    lines.next("<<<|")
    while lines.next() != "|>>>":
        pass
    lines.count(" is the random seed")
    float(lines.next(end=" seconds per run"))
    float(lines.next(end=" MB per run"))
    lines.count(" runs per planner")
    float(lines.next(end=" seconds spent to collect the data"))
    enums = dict(line.split("|", 1) for line in [lines.next() for _ in range(lines.count(" enum type"))])
    planners = {}
    for _ in range(lines.count(" planners")):
        name = lines.next()
        for _ in range(lines.count(" common properties")):
            lines.next()
        names = [lines.next().rsplit(" ", 1) for _ in range(lines.count(" properties for each run"))]
        runs = [lines.next().split("; ")[:-1] for _ in range(lines.count(" runs"))]
        planners[name] = [{key: read(kind, value) for (key, kind), value in zip(names, run, strict=True)} for run in runs]
        lines.next(".")
    if lines.left:
        raise AssertionError(f"{len(lines.left)} lines too many")
    return planners, enums


def read(kind, value):
    if value == "":
        return None
    number = {"REAL": float, "INTEGER": int, "BOOLEAN": int, "ENUM": int}[kind](value)
    if kind == "BOOLEAN" and number not in (0, 1):
        raise AssertionError(f"{value} is no truth")
    return number


class PlannerBenchmark(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.example = load_example()

    def log(self, scenario, *options):
        with tempfile.TemporaryDirectory() as folder:
            sys.argv = ["planner_benchmark.py", folder, scenario, "--runs", str(RUNS), *options]
            self.example.main()
            (file,) = pathlib.Path(folder).iterdir()
            self.assertEqual(file.name, scenario + ".log")
            return read_log(file.read_text(encoding="utf-8"))

    def test_each_run_is_the_walk_of_its_seed(self):
        planners, _ = self.log("narrow-gap-070", "--planners", "visibility,est")
        self.assertEqual(list(planners), ["visibility", "est"])
        for planner, runs in planners.items():
            self.assertEqual(len(runs), RUNS)
            walk = amble.plan("narrow-gap-070", planner=planner, seed=RUNS)
            self.assertEqual(runs[-1]["solution length"], walk.report["length"])
            self.assertEqual(runs[-1]["poses checked"], walk.report["poses_checked"])
            self.assertEqual(runs[-1]["solved"], 1)
            self.assertGreater(runs[-1]["time"], 0)

    def test_what_is_no_walk_has_a_status_and_no_figures_of_one(self):
        planners, enums = self.log("narrow-gap-020", "--planners", "visibility")
        (run, _) = planners["visibility"]
        self.assertEqual(enums["status"].split("|")[run["status"]], "no_walk")
        self.assertEqual(run["solved"], 0)
        self.assertIsNone(run["solution length"])


if __name__ == "__main__":
    unittest.main()
