"""Blender's copies of a BVH: COPY.fbx, COPY.dae, COPY.glb and COPY.gltf, every frame baked.

    blender --background --factory-startup --python export_motion.py -- WALK.bvh FRAMES RATE COPY
"""
import builtins
import sys

import addon_utils
import bpy


def import_walk(path):
    """Debian's Blender 3.4 runs on a Python without the mode 'rU' that its BVH importer opens files with."""
    import io_anim_bvh.import_bvh as importer

    importer.open = lambda file, mode="r": builtins.open(file, mode.replace("U", ""))
    bpy.ops.import_anim.bvh(filepath=path)


def main():
    walk, frames, rate, copy = sys.argv[sys.argv.index("--") + 1 :]
    for addon in ("io_anim_bvh", "io_scene_fbx", "io_scene_gltf2"):
        addon_utils.enable(addon)
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    scene = bpy.context.scene
    scene.render.fps, scene.render.fps_base = int(rate), 1.0
    scene.frame_start, scene.frame_end = 1, int(frames)
    import_walk(walk)
    bpy.ops.export_scene.fbx(filepath=copy + ".fbx", bake_anim_simplify_factor=0.0, add_leaf_bones=False)
    bpy.ops.wm.collada_export(filepath=copy + ".dae")
    bpy.ops.export_scene.gltf(filepath=copy + ".glb", export_format="GLB")
    bpy.ops.export_scene.gltf(filepath=copy + ".gltf", export_format="GLTF_SEPARATE")


try:
    main()
except Exception as error:  # Blender itself would go on and end with 0
    print(f"failed: {error!r}")
    sys.exit(1)
