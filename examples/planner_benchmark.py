#!/usr/bin/env python3
"""Planners against one another, in the log that OMPL's benchmark tools read.

    python3 examples/planner_benchmark.py FOLDER SCENARIO... [--planners visibility,prm,rrt] [--runs 10] [--time-limit 10]

Writes FOLDER/SCENARIO.log, an experiment each: for ompl_benchmark_statistics.py, which makes a database and plots of it, and for
plannerarena.org, which takes that database. A scenario is a file or the name of one that comes with Amble. Runs have seeds 1, 2,
..., so all but the times is the same wherever it ran. The format is OMPL's, "Benchmark log file format" of its tutorial on
benchmarking; `plan_benchmark --ompl` of Amble's own benchmarks measures the search alone, this whole walks.
"""
import argparse
import pathlib
import platform
import time

import amble

STATUSES = ("solved", "no_walk", "start_blocked", "goal_blocked")
NONE = ""  # as the format has what was not measured


def figure(*keys):
    """Reads it from a walk's report; what is no walk has not all of them."""

    def read(walk):
        value = walk.report
        for key in keys:
            value = value.get(key, {})
        return NONE if value == {} else value

    return read


def planning_time(walk):
    return sum(walk.report["times"].get(part, 0.0) for part in ("roadmap", "search", "refine"))


# Name and type of each property, and where it is in a walk's report [s, m].
PROPERTIES = {
    "time REAL": planning_time,
    "solved BOOLEAN": lambda walk: int(walk.solved),
    "status ENUM": lambda walk: STATUSES.index(walk.status),
    "roadmap time REAL": figure("times", "roadmap"),
    "search time REAL": figure("times", "search"),
    "refine time REAL": figure("times", "refine"),
    "poses checked INTEGER": figure("poses_checked"),
    "guards INTEGER": figure("roadmap", "guards"),
    "connectors INTEGER": figure("roadmap", "connectors"),
    "graph motions INTEGER": figure("roadmap", "edges"),
    "samples INTEGER": figure("roadmap", "samples"),
    "solution length REAL": figure("length"),
    "solution clearance REAL": figure("clearance", "min"),
    "walk duration REAL": figure("duration"),
    "foot skate REAL": figure("foot_skate", "max"),
}


def measure(scenario, planners, runs, time_limit):
    """Lines of the log."""
    began = time.monotonic()
    date = time.strftime("%Y-%m-%d %H:%M:%S")
    results = {planner: [amble.plan(scenario, planner=planner, seed=seed, time_limit=time_limit) for seed in range(1, runs + 1)]
               for planner in planners}
    return [
        f"Amble version {amble.__version__}",
        f"Experiment {name_of(scenario)}",
        "0 experiment properties",
        f"Running on {platform.node() or 'unknown'}",
        f"Starting at {date}",
        "<<<|",
        f"scenario {scenario}; seeds 1 to {runs}; whole walks, refined and checked",
        "|>>>",
        "1 is the random seed",
        f"{time_limit:g} seconds per run",
        "0 MB per run",  # no limit is kept
        f"{runs} runs per planner",
        f"{time.monotonic() - began:.3f} seconds spent to collect the data",
        "1 enum type",
        "|".join(("status", *STATUSES)),
        f"{len(planners)} planners",
        *(line for planner, walks in results.items() for line in planner_lines(planner, walks)),
    ]


def planner_lines(planner, walks):
    yield from (planner, "0 common properties", f"{len(PROPERTIES)} properties for each run", *PROPERTIES, f"{len(walks)} runs")
    for walk in walks:
        yield "".join(f"{read(walk)}; " for read in PROPERTIES.values())
    yield "."


def name_of(scenario):
    """One word: what reads the log takes the last of the line."""
    return "-".join(pathlib.Path(scenario).stem.split())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("scenarios", nargs="+", metavar="SCENARIO")
    parser.add_argument("--planners", default="visibility,prm,rrt")
    parser.add_argument("--runs", type=int, default=10)
    parser.add_argument("--time-limit", type=float, default=10.0, help="a run [s]")
    asked = parser.parse_args()
    asked.folder.mkdir(parents=True, exist_ok=True)
    for scenario in asked.scenarios:
        lines = measure(scenario, asked.planners.split(","), asked.runs, asked.time_limit)
        file = asked.folder / f"{name_of(scenario)}.log"
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        print(file)


if __name__ == "__main__":
    main()
