#include "scenarios/export_walk.h"

#include <sstream>

#include "animation/captures/bvh.h"

namespace amble {
namespace {

// A file lists a joint's children behind it, one whole limb after another: our joint for each of
// the file's.
std::vector<int> fileOrder(const Skeleton& skeleton) {
  std::vector<int> order, open = {0};
  while (!open.empty()) {
    const int joint = open.back();
    open.pop_back();
    order.push_back(joint);
    for (int child = skeleton.size() - 1; child > joint; --child) {
      if (skeleton.joint(child).parent == joint) open.push_back(child);
    }
  }
  return order;
}

Clip writtenAndRead(const Clip& clip, double unit, std::string& bytes) {
  std::ostringstream out;
  BvhWriteOptions write;
  write.metres_per_unit = unit;
  writeBvh(out, clip, write);
  bytes = std::move(out).str();
  std::istringstream in(bytes);
  BvhReadOptions read;
  read.metres_per_unit = unit;
  return readBvh(in, clip.name, read);
}

std::vector<std::string> namesOf(const Clip& read, const std::vector<int>& order) {
  std::vector<std::string> names(order.size());
  for (size_t i = 0; i < order.size(); ++i) {
    names[order[i]] = read.skeleton.joint(static_cast<int>(i)).name;
  }
  return names;
}

}  // namespace

ExportedWalk exportWalk(const std::string& name, const Skeleton& skeleton,
                        const AnimationBuffer& walk, double unit) {
  ExportedWalk exported;
  const Clip clip = {name, skeleton, walk.frame_time, walk.poses, {}};
  const Clip read = writtenAndRead(clip, unit, exported.bvh);
  const std::vector<int> order = fileOrder(skeleton);
  exported.joint_names = namesOf(read, order);
  exported.poses = PoseArray(skeleton.size());
  exported.poses.resize(read.frames());
  for (int frame = 0; frame < read.frames(); ++frame) {
    exported.poses.p_WR(frame) = read.poses.p_WR(frame);
    for (size_t i = 0; i < order.size(); ++i) {
      exported.poses.rotations(frame)[order[i]] = read.poses.rotations(frame)[i];
    }
  }
  return exported;
}

}  // namespace amble
