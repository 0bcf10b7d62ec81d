"""NumPy reads every array of a walk, and what is in them agrees with its BVH, its tables and its report.

    python3 numpy_walk.py FOLDER      of `amble plan`: walk.npz, *.csv, report.json, joints.txt of place_joints
"""
import csv
import json
import sys

import numpy as np

SMALL = 1e-6  # [m]; half of the last digit that a BVH has


def turned(q, v):
    """Vectors turned by unit quaternions w, x, y, z."""
    w, xyz = q[..., :1], q[..., 1:]
    t = 2 * np.cross(xyz, v)
    return v + w * t + np.cross(xyz, t)


def placed(walk):
    """Where joints are, by the arrays of turns and offsets alone."""
    frames, joints, _ = walk["quaternions"].shape
    at = np.empty((frames, joints, 3))
    turn = np.empty((frames, joints, 4))
    for j, parent in enumerate(walk["parents"]):
        q = walk["quaternions"][:, j]
        if parent < 0:
            at[:, j], turn[:, j] = walk["root_positions"], q
            continue
        at[:, j] = at[:, parent] + turned(turn[:, parent], walk["offsets"][j])
        a, b = turn[:, parent], q
        turn[:, j, 0] = a[:, 0] * b[:, 0] - np.sum(a[:, 1:] * b[:, 1:], axis=1)
        turn[:, j, 1:] = a[:, :1] * b[:, 1:] + b[:, :1] * a[:, 1:] + np.cross(a[:, 1:], b[:, 1:])
    return at


def table(path):
    """Rows of numbers, by the header's names; RFC 4180."""
    rows = list(csv.reader(open(path, newline=""), strict=True))
    return {name: np.array([float(row[i]) for row in rows[1:]]) for i, name in enumerate(rows[0]) if name != "foot"}


def same(what, a, b, largest=SMALL):
    apart = float(np.max(np.abs(np.asarray(a, float) - np.asarray(b, float))))
    print(f"{what}: {np.size(a)} numbers, farthest apart {apart:.1e}")
    assert apart <= largest, what


def main(folder):
    walk = np.load(folder + "/walk.npz", allow_pickle=False)
    report = json.load(open(folder + "/report.json"))
    names = list(walk["joint_names"])
    frames = len(walk["positions"])
    assert frames == report["frames"] > 100 and walk["title"].shape == ()
    assert walk["planted"].dtype == bool and walk["planted"].shape == (frames, 2)
    same("frame time", walk["frame_time"], report["frame_time"], 1e-9)
    same("turns and offsets", placed(walk), walk["positions"])

    bvh = [line.split() for line in open(folder + "/joints.txt")]
    assert {line[1] for line in bvh} == set(names)
    ours = [walk["positions"][int(frame), names.index(joint)] for frame, joint, *_ in bvh]
    same("BVH", ours, [[float(x) for x in place] for _, _, *place in bvh], 1e-5)

    joints = table(folder + "/joints.csv")
    for j in (0, len(names) - 1):
        for axis in range(3):
            same("joints.csv", joints[f"{names[j]} {'xyz'[axis]} [m]"], walk["positions"][:, j, axis], 0)
    path = table(folder + "/path.csv")
    same("path.csv", path["arc [m]"], walk["path_arcs"], 0)
    same("headings", np.radians(path["heading [deg]"]), walk["path_headings"])
    same("planted", path["right planted"], walk["planted"][:, 1], 0)

    steps = table(folder + "/steps.csv")
    put_down = walk["footprint_frames"][:, 0] > 0
    assert put_down.sum() == len(report["steps"]) > 3
    same("steps.csv", np.stack([steps[f"{axis} [m]"] for axis in "xyz"], 1), walk["footprint_positions"][put_down], 0)
    same("strides", steps["stride [m]"], [step["stride"] for step in report["steps"]], 1e-9)
    same("strikes", steps["strike [s]"], walk["footprint_frames"][put_down, 0] * walk["frame_time"])


main(sys.argv[1])
