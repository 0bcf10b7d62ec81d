"""Walks of a batch in one Blender file, an armature each, named as the walk is.

    blender --background [ROOM.blend] --python examples/blender/import_batch.py -- DIR OUT.blend [--scene NAME] [--count N]

DIR is a merged batch whose walks have BVH files. Of its table the first N walks that were found are taken (10), of one scene
where NAME, as the job has it, is given. Each begins at frame 1, and brings the cameras that its labels suggest. ROOM.blend is
that scene's room, in which they stand where they were planned.
"""
import argparse
import json
import math
import os
import sys

import bpy
from mathutils import Vector

sys.path.append(os.path.dirname(os.path.abspath(__file__)))
from import_walk import import_walk, run


def read_table(folder):
    with open(os.path.join(folder, "index.jsonl"), encoding="utf-8") as lines:
        return [json.loads(line) for line in lines]


def import_row(folder, row):
    key = row["walk"]
    armature = import_walk(os.path.join(folder, "walks", key[:2], key, "walk.bvh"))
    armature.name = armature.data.name = key
    for name in ("scene", "height", "speed", "caption"):
        armature[name] = row[name]
    return armature


def add_cameras(folder, row):
    """Those that its labels suggest: at a place, towards another, as wide as the walk is seen from there."""
    key = row["walk"]
    labels = os.path.join(folder, "walks", key[:2], key, "labels.json")
    if not os.path.exists(labels):
        return 0
    with open(labels, encoding="utf-8") as text:
        cameras = json.load(text)["cameras"]
    for number, view in enumerate(cameras):
        data = bpy.data.cameras.new(f"{key} {number}")
        data.angle = math.radians(view["field_of_view"])
        camera = bpy.data.objects.new(data.name, data)
        camera.location = view["position"]
        towards = Vector(view["target"]) - camera.location
        camera.rotation_euler = towards.to_track_quat("-Z", "Y").to_euler()
        bpy.context.scene.collection.objects.link(camera)
        bpy.context.scene.camera = bpy.context.scene.camera or camera
    return len(cameras)


def main():
    parser = argparse.ArgumentParser(prog="import_batch.py", description=__doc__)
    parser.add_argument("folder")
    parser.add_argument("blend")
    parser.add_argument("--scene")
    parser.add_argument("--count", type=int, default=10)
    asked = parser.parse_args(sys.argv[sys.argv.index("--") + 1 :])
    folder, blend = map(os.path.abspath, (asked.folder, asked.blend))
    rows = [row for row in read_table(folder) if row["status"] == "solved" and asked.scene in (None, row["scene"])]
    last = 1
    for row in rows[: asked.count]:
        armature = import_row(folder, row)
        last = max(last, bpy.context.scene.frame_end)
        bpy.context.scene.frame_set(1)
        x, y, _ = armature.matrix_world @ armature.pose.bones[0].head
        cameras = add_cameras(folder, row)
        print(f"{row['walk']}: {row['frames']} frames, hips over {x:.2f}, {y:.2f} at first, {cameras} cameras")
    bpy.context.scene.frame_end = last
    bpy.ops.wm.save_as_mainfile(filepath=blend)
    print(f"{min(len(rows), asked.count)} of {len(rows)} walks in {asked.blend}")


run(main)
