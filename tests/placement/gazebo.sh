#!/bin/bash
# Gazebo's readers against ours, in metres and in centimetres.   gazebo.sh AMBLE PLACE_JOINTS GAZEBO_ACTOR WORK
set -euo pipefail
here=$(dirname "$0") amble=$1 place_joints=$2 gazebo_actor=$3 work=$4
mkdir -p "$work"
"$amble" plan "$here/room.yaml" --formats bvh -o "$work/m"
"$place_joints" "$work/m/walk.bvh" 7 >"$work/joints.txt"
time=$(sed -n 's/^Frame Time: //p' "$work/m/walk.bvh")
for unit in m cm; do
  "$amble" plan "$here/room.yaml" --formats sdf --bvh-units $unit -o "$work/$unit"
  "$gazebo_actor" "$work/$unit/walk.sdf" "$work/joints.txt" "$time"
done
