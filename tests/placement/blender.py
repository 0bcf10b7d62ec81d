"""Blender places every joint of a walk, and every corner of a mesh, where Amble does, to 0.1 mm.

    blender --background --factory-startup --python blender.py -- WALK.bvh WALK.glb JOINTS MESH.obj BOUNDS

JOINTS as place_joints writes them; BOUNDS: `amble inspect --json` of a scene that holds MESH.obj with `up: y`.
All is imported with Blender's usual settings, so that what this proves is that they overlay.
"""
import builtins
import json
import sys

import addon_utils
import bpy
import numpy
from mathutils import Vector

LARGEST = 1e-4  # [m]


def import_walk(path):
    """Debian's Blender 3.4 runs on a Python without the mode 'rU' that its BVH importer opens files with."""
    import io_anim_bvh.import_bvh as importer

    importer.open = lambda file, mode="r": builtins.open(file, mode.replace("U", ""))
    bpy.ops.import_anim.bvh(filepath=path)
    return bpy.context.object


def import_glb(path):
    """A frame of the walk is a frame of Blender's, the first of them 0. Debian's NumPy 1.24 has not the name `bool` that
    the importer of its Blender 3.4 asks for."""
    numpy.bool = bool
    bpy.context.scene.render.fps = 60
    bpy.ops.object.select_all(action="DESELECT")
    bpy.ops.import_scene.gltf(filepath=path)
    return next(o for o in bpy.context.selected_objects if o.type == "ARMATURE")


def compare_walk(armature, path, first):
    worst, compared, shown = 0.0, 0, None
    for line in open(path):
        frame, name, *place = line.split()
        if frame != shown:
            bpy.context.scene.frame_set(int(frame) + first)
            shown = frame
        there = armature.matrix_world @ armature.pose.bones[name].head
        worst = max(worst, (there - Vector(map(float, place))).length)
        compared += 1
    print(f"Blender {bpy.app.version_string}: {compared} joints, farthest apart {1000 * worst:.4f} mm")
    return compared > 0 and worst <= LARGEST


def compare_mesh(path, bounds_path):
    bpy.ops.object.select_all(action="DESELECT")
    bpy.ops.wm.obj_import(filepath=path)
    corners = [o.matrix_world @ v.co for o in bpy.context.selected_objects for v in o.data.vertices]
    bounds = json.load(open(bounds_path))[0]["bounds"]
    worst = 0.0
    for axis in range(3):
        worst = max(worst, abs(min(c[axis] for c in corners) - bounds["min"][axis]))
        worst = max(worst, abs(max(c[axis] for c in corners) - bounds["max"][axis]))
    print(f"Blender {bpy.app.version_string}: {len(corners)} corners, bounds {1000 * worst:.4f} mm apart")
    return worst <= LARGEST


def main():
    walk, glb, joints, mesh, bounds = sys.argv[sys.argv.index("--") + 1 :]
    for addon in ("io_anim_bvh", "io_scene_gltf2"):
        addon_utils.enable(addon)
    good = compare_walk(import_walk(walk), joints, first=1)  # the importer's first frame
    good = compare_walk(import_glb(glb), joints, first=0) and good
    good = compare_mesh(mesh, bounds) and good
    sys.exit(0 if good else 1)


try:
    main()
except Exception as error:  # Blender itself would go on and end with 0
    print(f"failed: {error!r}")
    sys.exit(1)
