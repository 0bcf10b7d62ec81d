"""How costs grow: over triangles, over area, over threads. Drawn halls (draw_hall.py), from corner to corner."""
import csv
import math
import pathlib
import tempfile

import plot
import run
from draw_hall import ROOM, draw

TRIANGLES = (1_000, 10_000, 100_000, 1_000_000)  # of nine rooms
SIDES = (8, 20, 50, 100, 200)  # of the hall [m]
THREADS = (1, 2)
THINGS = 7  # a room, with its walls

# Rows of navmesh_benchmark, and the clock that each is told by: loading has children and threads.
COSTS = {
    "loading": ("loading", "real_time"),
    "map and first way": ("mapAndWay", "cpu_time"),
    "plan": ("plan", "cpu_time"),
    "Recast, its usual cells": ("recastBuild", "cpu_time"),
    "Recast, cells of 5 cm": ("recastBuildFine", "cpu_time"),
    "Detour, a query": ("detourQuery", "cpu_time"),
}
CHECKS = {
    "a pose checked": "wholeBodyCheck",
    "a pose checked, FCL's manager": "fclManager<OBBRSSd>",
}
TREES = {"trees of triangles": "makeObstacles", "FCL's trees of them": "makeObstaclesByFcl"}


def rooms(side):
    """Columns and rows of a hall of about that side."""
    return [max(1, round(side / length)) for length in ROOM]


def costs(scenario):
    if not run.program("navmesh").exists():
        raise RuntimeError("growth compares with Recast: install librecast-dev and configure anew")
    only = "^(" + "|".join(row for row, _ in COSTS.values()) + ")/"
    found = run.rows("navmesh", [str(scenario)], repetitions=1, least=0.02, only=only)
    stem = scenario.stem
    for name, (row, clock) in COSTS.items():
        yield name, run.seconds(found[f"{row}/{stem}"], clock)
    label = found[f"plan/{stem}"].get("label")
    if label != "solved":
        print(f"  {scenario}: {label}")


def checks(scenario):
    only = "^(" + "|".join([*CHECKS.values(), *TREES.values()]) + ")/"
    found = run.rows("collision", [str(scenario)], repetitions=1, least=0.02, only=only)
    for name, row in CHECKS.items():
        yield name, 1.0 / found[f"{row}/{scenario.stem}"]["poses/s"]
    for name, row in TREES.items():
        yield name, run.seconds(found[f"{row}/{scenario.stem}"])


def over_triangles(folder, quick):
    for triangles in TRIANGLES[: 1 if quick else None]:
        scenario = draw(folder / f"t{triangles}", 3, 3, 9 * THINGS, triangles=triangles)
        for name, value in [*costs(scenario), *checks(scenario)]:
            yield "triangles", name, triangles, value


def over_area(folder, quick):
    for side in SIDES[: 1 if quick else None]:
        columns, rows = rooms(side)
        scenario = draw(folder / f"a{side}", columns, rows, columns * rows * THINGS)
        for name, value in costs(scenario):
            yield "side", name, math.sqrt(columns * ROOM[0] * rows * ROOM[1]), value


def over_threads(folder, quick):
    scenario = draw(folder / "threads", *((1, 1, THINGS) if quick else (10, 10, 700)))
    for threads in THREADS:
        times = run.plan(scenario, "--threads", threads)["times"]
        for name in ("roadmap", "refine"):
            yield "threads", name, threads, times[name]


def measure(out, quick=False):
    """Writes growth.csv and growth.svg into the folder."""
    out = pathlib.Path(out)
    out.mkdir(parents=True, exist_ok=True)
    about = run.machine()
    lines = []
    with tempfile.TemporaryDirectory() as folder:
        for series in (over_triangles, over_area, over_threads):
            for entry in series(pathlib.Path(folder), quick):
                lines.append(entry)
                print("  {:<10} {:<42} {:>9.6g}  {:.4g} s".format(*entry), flush=True)
    with open(out / "growth.csv", "w", newline="") as file:
        file.writelines(f"# {line}\n" for line in about)
        table = csv.writer(file, lineterminator="\n")
        table.writerow(("over", "cost", "value", "seconds"))
        table.writerows((over, name, f"{x:g}", f"{y:.4g}") for over, name, x, y in lines)
    (out / "growth.svg").write_text(plot.plot(list(charts(lines))))


def charts(lines):
    """Of the table, as plot() takes them."""
    titles = {
        "triangles": ("Nine rooms, 30 x 18 m", "triangles"),
        "side": ("Rooms of 10 x 6 m, 7 objects each", "side of the hall [m]"),
        "threads": ("100 rooms, 700 objects", "threads"),
    }
    for over, (title, along) in titles.items():
        curves = {}
        for series, name, x, y in lines:
            if series == over:
                curves.setdefault(name, []).append((x, y))
        yield title, along, curves
