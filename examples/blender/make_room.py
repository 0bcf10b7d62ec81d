"""A small studio, as somebody might model it in Blender, exported for Amble.

    blender --background --python examples/blender/make_room.py -- ROOM.blend ROOM.glb|ROOM.obj

Metres, z up, the floor's top at z = 0. The export's settings are those that docs/guide.md names: Blender's usual ones, and
modifiers are applied.
"""
import os
import sys

import addon_utils
import bpy


def add_box(name, size, at, bevel=0.0):
    """A box that stands on `at`: a closed mesh, so that inside counts as touched too."""
    bpy.ops.mesh.primitive_cube_add(size=1, location=(at[0], at[1], at[2] + size[2] / 2))
    thing = bpy.context.object
    thing.name = thing.data.name = name
    thing.scale = size
    bpy.ops.object.transform_apply(location=False, rotation=False, scale=True)
    if bevel > 0:
        thing.modifiers.new("rounded", "BEVEL").width = bevel
    return thing


def make_room():
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    add_box("floor", (6, 4, 0.1), (3, 2, -0.1))
    add_box("wall-north", (6, 0.1, 2.4), (3, 4.05, 0))
    add_box("wall-west", (0.1, 4, 2.4), (-0.05, 2, 0))
    add_box("sofa", (0.9, 1.8, 0.45), (3, 2.6, 0), bevel=0.08)
    add_box("step", (1.2, 4, 0.15), (5.4, 2, 0))
    bpy.ops.mesh.primitive_cylinder_add(radius=0.12, depth=1.5, location=(3, 0.5, 0.75))
    bpy.context.object.name = "column"


def export(path):
    if path.endswith(".obj"):  # File > Export > Wavefront (.obj): forward -Z, up Y
        bpy.ops.wm.obj_export(filepath=path, apply_modifiers=True)
        return
    addon_utils.enable("io_scene_gltf2")  # File > Export > glTF 2.0: +Y up
    bpy.ops.export_scene.gltf(filepath=path, export_apply=True)


try:
    blend, room = map(os.path.abspath, sys.argv[sys.argv.index("--") + 1 :])
    make_room()
    bpy.ops.wm.save_as_mainfile(filepath=blend)
    export(room)
except Exception as error:  # Blender itself would go on and end with 0
    print(f"failed: {error!r}")
    sys.exit(1)
