#!/bin/bash
# Blender's FBX, Collada and glTF copies of a walk against the walk.   copies.sh AMBLE COMPARE_MOTIONS WORK
# Exit status 77: Blender is not installed.
set -euo pipefail
here=$(dirname "$0") amble=$1 compare_motions=$2 work=$3
command -v blender >/dev/null || { echo "skipped: blender is not installed"; exit 77; }

mkdir -p "$work"
"$amble" animate --speed 1.2 --turn 25 --duration 2 --fps 60 -o "$work/walk.bvh"
frames=$(sed -n 's/^Frames: //p' "$work/walk.bvh")
blender --background --factory-startup --python "$here/export_motion.py" -- \
  "$work/walk.bvh" "$frames" 60 "$work/walk"
"$compare_motions" "$work/walk.bvh" "$work/walk."{fbx,dae,glb,gltf}
