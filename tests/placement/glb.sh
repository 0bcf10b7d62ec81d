#!/bin/bash
# Our GLB against Khronos' validator and three.js.   glb.sh AMBLE MODULES WORK SCENARIOS MOCAP
# MODULES: a folder in which npm has put three and gltf-validator. Of walks every joint is compared with their BVH.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) amble=$1 modules=$2 work=$3 scenarios=$4 mocap=$5
rm -rf "$work"
mkdir -p "$work"
cd "$work"

for format in bvh glb; do "$amble" animate --turn 25 --duration 4 --names unreal -o "walk.$format" >/dev/null; done
for scenario in kerb stairs-up; do
  "$amble" plan "$scenarios/$scenario.yaml" --formats bvh,glb -o "$scenario" >/dev/null
done

# Nobody's skeletons: one joint, a chain that does not move, names of any kind.
cat >cart.bvh <<'BVH'
HIERARCHY
ROOT "cart"<script>
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
}
MOTION
Frames: 2
Frame Time: 0.04
0 0 0 0 0 0
1 0 0 0 90 0
BVH
cat >crane.bvh <<'BVH'
HIERARCHY
ROOT 起重機
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT 起重機
  {
    OFFSET 0 0 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 2 0
    }
  }
}
MOTION
Frames: 1
Frame Time: 0.04
0 0 0 0 0 0 0 0 0
BVH
for cart in cart crane; do "$amble" convert "$cart.bvh" --unit 1 -o "of-$cart.glb" >/dev/null; done

# A capture of each rig, where they are.
for folder in "$mocap"/*/; do
  [ -d "$folder" ] || continue
  capture=$(find "$folder" -name '*.bvh' -not -name 'malformed*' -o -name '*.amc' | LC_ALL=C sort | head -1)
  [ -z "$capture" ] || "$amble" convert "$capture" -o "capture-$(basename "$folder").glb" >/dev/null
done
node "$here/glb.mjs" "$modules" *.glb */*.glb
