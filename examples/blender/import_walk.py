"""A walk in the Blender file of the room that it was planned in.

    blender --background ROOM.blend --python examples/blender/import_walk.py -- WALK.bvh|WALK.glb OUT.blend

By hand: File > Import > Motion Capture (.bvh), "Update Scene FPS" and "Update Scene Duration" ticked, all else as it is; or
File > Import > glTF 2.0. Room and walk overlay, since Amble writes y up, as Blender's importers expect it.

Blender 3.4.1 (Debian 12) is older than its Python 3.11 and NumPy 1.24: it fails at every BVH with `invalid mode: 'rU'` and at
every glTF with `no attribute 'bool'`. Here it is helped over both; other versions need no help.
"""
import builtins
import os
import sys

import addon_utils
import bpy


def import_bvh(path):
    addon_utils.enable("io_anim_bvh")
    import io_anim_bvh.import_bvh as importer

    importer.open = lambda file, mode="r": builtins.open(file, mode.replace("U", ""))
    bpy.ops.import_anim.bvh(filepath=path, update_scene_fps=True, update_scene_duration=True)


def import_glb(path):
    import numpy

    numpy.bool = bool
    addon_utils.enable("io_scene_gltf2")
    bpy.context.scene.render.fps = 60  # glTF has times, Blender frames: as many as the walk has
    bpy.ops.import_scene.gltf(filepath=path)
    bpy.context.scene.frame_end = round(max(action.frame_range[1] for action in bpy.data.actions))
    # The file brings the room along, which is here already.
    room = next(o for o in bpy.context.selected_objects if o.name.startswith("scene"))
    for thing in [*room.children_recursive, room]:
        bpy.data.objects.remove(thing)


def import_walk(path):
    before = set(bpy.data.objects)
    (import_glb if path.endswith(".glb") else import_bvh)(path)
    return next(o for o in bpy.data.objects if o.type == "ARMATURE" and o not in before)


def main():
    walk, blend = map(os.path.abspath, sys.argv[sys.argv.index("--") + 1 :])
    armature = import_walk(walk)
    scene = bpy.context.scene
    rate = scene.render.fps / scene.render.fps_base
    for frame in (1, scene.frame_end):
        scene.frame_set(frame)
        x, y, _ = armature.matrix_world @ armature.pose.bones[0].head
        print(f"frame {frame}, {rate:g} a second: hips over {x:.2f}, {y:.2f}")
    scene.frame_set(1)
    bpy.ops.wm.save_as_mainfile(filepath=blend)


def run(what):
    try:
        what()
    except Exception as error:  # Blender itself would go on and end with 0
        print(f"failed: {error!r}")
        sys.exit(1)


if __name__ == "__main__":
    run(main)
