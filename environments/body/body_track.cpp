#include "environments/body/body_track.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace amble {
namespace {

static_assert(sizeof(Capsule) == 7 * sizeof(double) && sizeof(Eigen::Quaterniond) == 32 &&
              sizeof(PartMotion) == 2 * sizeof(double));

void append(std::vector<double>& to, const Eigen::Vector3d& p) {
  to.insert(to.end(), {p.x(), p.y(), p.z()});
}

// Of a capsule and what follows it as numbers.
template <typename Capsules>
auto* numbersOf(Capsules capsules, int cell) {
  return capsules[cell].from.data();
}

LanePoses posesAt(const PoseArray& poses, const std::array<int, 4>& frames) {
  LanePoses at;
  for (int lane = 0; lane < 4; ++lane) {
    at.position[lane] = poses.p_WR(frames[lane]).data();
    at.rotations[lane] = poses.rotations(frames[lane])[0].coeffs().data();
  }
  return at;
}

}  // namespace

BodyTrack::BodyTrack(const Skeleton& skeleton, const Body& body, const LaneKernel& kernel)
    : kernel_(kernel) {
  for (const Joint& joint : skeleton.joints()) {
    parent_.push_back(joint.parent);
    append(offset_, joint.offset);
    offset_length_.push_back(joint.offset.norm());
  }
  for (const BodyPart& part : body.parts) {
    part_joint_.push_back(part.joint);
    append(part_from_, part.from);
    append(part_to_, part.to);
    part_length_.push_back(std::max(part.from.norm(), part.to.norm()));
    radius_.push_back(part.radius);
  }
}

LaneBody BodyTrack::view() const {
  return {joints(),
          parts(),
          parent_.data(),
          offset_.data(),
          offset_length_.data(),
          part_joint_.data(),
          part_from_.data(),
          part_to_.data(),
          part_length_.data(),
          radius_.data()};
}

// Four at a time; the last ones fewer, of which one stands for what is missing.
void BodyTrack::place(const PoseArray& poses, std::span<const int> frames,
                      std::span<Capsule> capsules, Scratch& scratch) const {
  for (size_t i = 0; i < frames.size(); i += 4) {
    std::array<int, 4> four;
    std::array<double*, 4> out;
    for (size_t lane = 0; lane < 4; ++lane) {
      four[lane] = frames[std::min(i + lane, frames.size() - 1)];
      out[lane] = numbersOf(capsules, four[lane] * parts());
    }
    kernel_.place(view(), posesAt(poses, four), scratch.data(), out.data());
  }
}

void BodyTrack::measure(const PoseArray& poses, int first, int last,
                        std::span<const Capsule> capsules, Motions& motions,
                        Scratch& scratch) const {
  assert(last < poses.size());
  for (int i = first; i < last; i += 4) {
    std::array<int, 4> here, next;
    std::array<const double*, 4> from, to;
    std::array<double*, 4> bounds, nears;
    for (int lane = 0; lane < 4; ++lane) {
      here[lane] = std::min(i + lane, last - 1);
      next[lane] = here[lane] + 1;
      from[lane] = numbersOf(capsules, here[lane] * parts());
      to[lane] = numbersOf(capsules, next[lane] * parts());
      const size_t cell = static_cast<size_t>(here[lane]) * parts();
      bounds[lane] = &motions.bounds[cell].path;
      nears[lane] = &motions.nears[cell];
    }
    kernel_.measure(view(), posesAt(poses, here), posesAt(poses, next), from.data(), to.data(),
                    PartMotion::kRounding, scratch.data(), bounds.data(), nears.data());
  }
}

}  // namespace amble
