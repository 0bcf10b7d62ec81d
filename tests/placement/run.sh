#!/bin/bash
# Another program's reader of our files against ours.   run.sh three|blender|numpy AMBLE PLACE_JOINTS WORK
# Exit status 77: that program is not installed.
set -euo pipefail
here=$(dirname "$0") who=$1 amble=$2 place_joints=$3 work=$4
three=${AMBLE_THREE_JS:-/usr/share/javascript/three}  # Debian's libjs-three

case $who in
  three)
    command -v node >/dev/null && [ -e "$three/examples/js/loaders/BVHLoader.js" ] ||
      { echo "skipped: nodejs or libjs-three is not installed"; exit 77; } ;;
  blender)
    command -v blender >/dev/null || { echo "skipped: blender is not installed"; exit 77; } ;;
  numpy)
    python=/usr/bin/python3  # Debian's has it; others that stand before it in the path often have not
    [ -x "$python" ] || python=python3
    "$python" -c "import numpy" 2>/dev/null || { echo "skipped: NumPy is not installed"; exit 77; } ;;
esac

mkdir -p "$work"
if [ "$who" = numpy ]; then
  "$amble" plan "$here/room.yaml" --formats bvh,json,csv,npz -o "$work"
  "$place_joints" "$work/walk.bvh" 7 >"$work/joints.txt"
  "$python" "$here/numpy_walk.py" "$work"
  exit
fi
for format in bvh glb; do "$amble" animate --speed 1.2 --turn 25 --duration 4 -o "$work/walk.$format"; done
"$place_joints" "$work/walk.bvh" 7 >"$work/joints.txt"
case $who in
  three) node "$here/three.js" "$three" "$work/walk.bvh" "$work/joints.txt" ;;
  blender)
    "$amble" inspect --json "$here/wedge.yaml" >"$work/wedge.json"
    blender --background --factory-startup --python "$here/blender.py" -- \
      "$work/walk.bvh" "$work/walk.glb" "$work/joints.txt" "$here/wedge.obj" "$work/wedge.json" ;;
esac
