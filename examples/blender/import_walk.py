"""A walk in the Blender file of the room that it was planned in.

    blender --background ROOM.blend --python examples/blender/import_walk.py -- WALK.bvh OUT.blend

By hand: File > Import > Motion Capture (.bvh), "Update Scene FPS" and "Update Scene Duration" ticked, all else as it is. Room
and walk overlay, since Amble writes y up, as Blender's importers expect it.
"""
import builtins
import os
import sys

import addon_utils
import bpy


def import_walk(path):
    """Blender 3.4.1 (Debian 12) fails with `invalid mode: 'rU'` on Python 3.11; here it is helped, others need no help."""
    addon_utils.enable("io_anim_bvh")
    import io_anim_bvh.import_bvh as importer

    importer.open = lambda file, mode="r": builtins.open(file, mode.replace("U", ""))
    bpy.ops.import_anim.bvh(filepath=path, update_scene_fps=True, update_scene_duration=True)
    return bpy.context.object


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


try:
    main()
except Exception as error:  # Blender itself would go on and end with 0
    print(f"failed: {error!r}")
    sys.exit(1)
