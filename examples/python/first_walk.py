#!/usr/bin/python3
"""A walk through the living room, and what is known of it.

    /usr/bin/python3 examples/python/first_walk.py [SCENARIO] [FOLDER]
"""

import sys

import amble


def main(scenario="living-room", folder="out/first-walk"):
    walk = amble.plan(scenario)
    if not walk:
        sys.exit(f"{walk.status}: {walk.why}")
    head = walk.positions[:, :, 2].max(axis=1)
    nearest = walk.clearance.argmin()
    print(f"{walk.report['length']:.2f} m in {walk.duration:.2f} s, {len(walk.report['steps'])} steps")
    print(f"mean speed {walk.path_speeds.mean():.2f} m/s, highest joint between {head.min():.2f} and {head.max():.2f} m")
    print(f"both feet on the ground for {walk.planted.all(axis=1).mean():.0%} of the time")
    print(f"nearest to anything after {nearest * walk.frame_time:.2f} s: {walk.clearance[nearest] * 1000:.0f} mm")
    walk.write(folder, ["bvh", "html", "npz", "json"])
    print(f"{folder}/walk.html is to look at")


if __name__ == "__main__":
    main(*sys.argv[1:])
