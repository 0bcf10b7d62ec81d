#include "viz/exchange/walk_npz.h"

#include <vector>

#include "viz/exchange/npy_archive.h"

namespace amble {
namespace {

using Numbers = std::vector<double>;

void append(Numbers& numbers, const Eigen::Vector3d& p) {
  numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
}

void addSkeleton(NpyArchive& archive, const Skeleton& skeleton,
                 std::span<const std::string> joint_names) {
  const auto joints = static_cast<size_t>(skeleton.size());
  std::vector<int32_t> parents;
  Numbers offsets;
  for (const Joint& joint : skeleton.joints()) {
    parents.push_back(joint.parent);
    append(offsets, joint.offset);
  }
  archive.addTexts("joint_names", joint_names, {joints});
  archive.add("parents", parents, {joints});
  archive.add("offsets", offsets, {joints, 3});
}

void addPoses(NpyArchive& archive, const Skeleton& skeleton, const PoseArray& poses) {
  const auto frames = static_cast<size_t>(poses.size());
  const auto joints = static_cast<size_t>(skeleton.size());
  Numbers roots, turns, positions;
  turns.reserve(frames * joints * 4);
  positions.reserve(frames * joints * 3);
  std::vector<JointFrame> placed(joints);
  for (int frame = 0; frame < poses.size(); ++frame) {
    append(roots, poses.p_WR(frame));
    for (const Eigen::Quaterniond& q : poses.rotations(frame))
      turns.insert(turns.end(), {q.w(), q.x(), q.y(), q.z()});
    forwardKinematics(skeleton, poses[frame], placed);
    for (const JointFrame& joint : placed) append(positions, joint.p_WJ);
  }
  archive.add("root_positions", roots, {frames, 3});
  archive.add("quaternions", turns, {frames, joints, 4});
  archive.add("positions", positions, {frames, joints, 3});
}

void addPath(NpyArchive& archive, const std::vector<FrameState>& states) {
  Numbers positions, headings, speeds, turn_rates, arcs, phases;
  std::vector<uint8_t> planted;
  for (const FrameState& state : states) {
    append(positions, state.position);
    headings.push_back(state.heading);
    speeds.push_back(state.speed);
    turn_rates.push_back(state.turn_rate);
    arcs.push_back(state.arc);
    phases.push_back(state.phase);
    for (const Side side : {kLeft, kRight}) planted.push_back(state.planted[side] ? 1 : 0);
  }
  archive.add("path_positions", positions, {states.size(), 3});
  archive.add("path_headings", headings, {states.size()});
  archive.add("path_speeds", speeds, {states.size()});
  archive.add("path_turn_rates", turn_rates, {states.size()});
  archive.add("path_arcs", arcs, {states.size()});
  archive.add("phases", phases, {states.size()});
  archive.addBools("planted", planted, {states.size(), 2});
}

void addFootprints(NpyArchive& archive, const std::vector<Footprint>& prints) {
  std::vector<int32_t> sides, frames;
  Numbers positions, headings;
  for (const Footprint& print : prints) {
    sides.push_back(print.side);
    append(positions, print.position);
    headings.push_back(print.heading);
    frames.insert(frames.end(), {print.first_frame, print.last_frame});
  }
  archive.add("footprint_sides", sides, {prints.size()});
  archive.add("footprint_positions", positions, {prints.size(), 3});
  archive.add("footprint_headings", headings, {prints.size()});
  archive.add("footprint_frames", frames, {prints.size(), 2});
}

}  // namespace

NpyArchive walkArrays(const WalkView& view, std::span<const std::string> joint_names) {
  const AnimationBuffer& walk = *view.animation;
  NpyArchive archive;
  archive.addTexts("title", std::span(&view.title, 1), {});
  archive.add("frame_time", std::span(&walk.frame_time, 1), {});
  addSkeleton(archive, *view.skeleton, joint_names);
  addPoses(archive, *view.skeleton, walk.poses);
  addPath(archive, walk.states);
  addFootprints(archive, walk.footprints);
  return archive;
}

void writeWalkNpz(std::ostream& out, const WalkView& view,
                  std::span<const std::string> joint_names) {
  walkArrays(view, joint_names).write(out);
}

}  // namespace amble
