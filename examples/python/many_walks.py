#!/usr/bin/python3
"""Walks between places drawn in one scene, by threads: an NPZ file each, and a table of them.

    /usr/bin/python3 examples/python/many_walks.py [FOLDER] [WALKS] [SCENE]

The same seed gives the same walks, whatever the number of threads. For more scenes, people and machines there is `amble batch`.
"""

import csv
import pathlib
import sys
from concurrent.futures import ThreadPoolExecutor

import amble
import numpy as np


def main(folder="out/many-walks", walks=8, scene="environments/scenes/living-room/scene.yaml", seed=1):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    planner = amble.Planner(scene, {"height": 1.7})
    draws = np.random.default_rng(seed)

    def walk_between(number, ends):
        try:
            walk = planner.plan(*ends, seed=number, name=f"walk-{number:04}")
        except amble.InputError as error:  # a place in a thing, or where no floor is
            return [number, *np.ravel(ends), "no_floor", "", "", error.problem]
        if not walk:
            return [number, *np.ravel(ends), walk.status, "", "", walk.why]
        walk.write(folder / f"walk-{number:04}.npz")
        return [number, *np.ravel(ends), walk.status, walk.report["length"], walk.clearance.min(), ""]

    ends = [draws.uniform([[0.5, 0.5]] * 2, [[7.5, 5.5]] * 2).round(2).tolist() for _ in range(int(walks))]
    with ThreadPoolExecutor() as threads:
        rows = list(threads.map(walk_between, range(1, len(ends) + 1), ends))
    with open(folder / "walks.csv", "w", newline="", encoding="utf-8") as out:
        table = csv.writer(out)
        table.writerow(["walk", "start_x", "start_y", "goal_x", "goal_y", "status", "length", "clearance", "why"])
        table.writerows(rows)
    print(f"{sum(row[5] == 'solved' for row in rows)} of {len(rows)} walks in {folder}")


if __name__ == "__main__":
    main(*sys.argv[1:])
