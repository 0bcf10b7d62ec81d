/// A whole person who walks, for readers: the walking Rig with neck, head and arms.
#pragma once

#include "animation/captures/bvh.h"
#include "tests/animation/rig.h"
#include "tests/environments/test_files.h"

namespace amble {

/// Rig's ten joints, then neck, head and both arms, in the order of a BVH file's names. It walks a
/// left turn for two seconds at 30 Hz and swings its arms.
inline Clip walkingPerson() {
  Puppet puppet;
  puppet.rate = 30.0;
  puppet.duration = 2.0;
  puppet.turn_rate = 0.3;
  const Clip legs = Rig().walk(puppet);
  std::vector<Joint> joints = legs.skeleton.joints();
  const auto add = [&joints](const std::string& name, int parent, const Eigen::Vector3d& offset) {
    Joint joint;
    joint.name = name;
    joint.parent = parent;
    joint.offset = offset;
    joints.push_back(joint);
    return static_cast<int>(joints.size()) - 1;
  };
  const int chest = 9;
  const int head = add("Head", add("Neck", chest, {0, 0.2, 0}), {0, 0.1, 0});
  joints[head].end_sites.push_back({0, 0.2, 0});
  for (const int side : {1, -1}) {
    const std::string name = side > 0 ? "Left" : "Right";
    const int clavicle = add(name + "Shoulder", chest, {0.05 * side, 0.15, 0});
    const int arm = add(name + "Arm", clavicle, {0.12 * side, 0, 0});
    const int hand =
        add(name + "Hand", add(name + "ForeArm", arm, {0.28 * side, 0, 0}), {0.25 * side, 0, 0});
    joints[hand].end_sites.push_back({0.1 * side, 0, 0});
  }
  Clip person = legs;
  person.skeleton = Skeleton(joints);
  person.poses = PoseArray(person.skeleton.size());
  person.poses.resize(legs.frames());
  for (int i = 0; i < legs.frames(); ++i) {
    person.poses.p_WR(i) = legs.poses.p_WR(i);
    const auto from = legs.poses.rotations(i);
    std::copy(from.begin(), from.end(), person.poses.rotations(i).begin());
    const double swing = 0.4 * std::sin(2.0 * kPi * i / 33.0);
    person.poses.rotations(i)[person.skeleton.find("LeftArm")] = expRotation({swing, 0, -1.3});
    person.poses.rotations(i)[person.skeleton.find("RightArm")] = expRotation({-swing, 0, 1.3});
  }
  return person;
}

/// A BVH in a unit and with a vertical axis of the file's own.
inline void writeInAxes(const std::filesystem::path& file, Clip clip, double metres_per_unit,
                        UpAxis up) {
  // The writer turns World to y up; what is y up already in World comes out z up.
  for (int i = 0; up == UpAxis::kZ && i < clip.frames(); ++i) {
    clip.poses.p_WR(i) = yUpToWorld() * clip.poses.p_WR(i);
    clip.poses.rotations(i)[0] = yUpToWorld() * clip.poses.rotations(i)[0];
  }
  writeBvh(file, clip, {.metres_per_unit = metres_per_unit});
}

}  // namespace amble
