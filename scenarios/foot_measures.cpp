#include "scenarios/foot_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/statistics.h"

namespace amble {
namespace {

constexpr double kReach = 1.0;  // how far from a sole its ground is looked for [m]

// Of a foot's capsules those from the heel to the ball: the first of its sole's, and what begins
// where it does.
std::vector<int> heelToBall(const Body& body, int side) {
  std::vector<int> parts;
  for (int i = 0; i < static_cast<int>(body.parts.size()); ++i) {
    const BodyPart& part = body.parts[i];
    if (part.sole != side) continue;
    if (parts.empty() || body.parts[parts[0]].from == part.from) parts.push_back(i);
  }
  return parts;
}

}  // namespace

SoleTracks::SoleTracks(const Skeleton& skeleton, const Body& body, const PoseArray& poses,
                       const Ground& ground)
    : frames_(poses.size()) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(body.parts.size()), to(body.parts.size());
  const auto underside = [&](const Eigen::Vector3d& centre, double radius) {
    const auto level = ground.height(centre.x(), centre.y(), centre.z(), kReach);
    return level ? centre.z() - radius - *level : kNone;
  };
  const std::array<std::vector<int>, 2> feet = {heelToBall(body, kLeft), heelToBall(body, kRight)};
  for (int side = 0; side < 2; ++side) {
    lowest_[side].assign(frames_, kNone);
    centres_[side].assign(2 * static_cast<size_t>(frames_), {Eigen::Vector3d::Zero(), kNone});
  }
  for (int frame = 0; frame < frames_; ++frame) {
    forwardKinematics(skeleton, poses[frame], joints);
    placeBody(body, joints, from, to);
    for (size_t i = 0; i < body.parts.size(); ++i) {
      const int side = body.parts[i].sole;
      if (side < 0) continue;
      const double radius = body.parts[i].radius;
      lowest_[side][frame] =
          std::min({lowest_[side][frame], underside(from[i], radius), underside(to[i], radius)});
    }
    for (int side = 0; side < 2; ++side) {
      if (feet[side].empty()) continue;
      Eigen::Vector3d heel = Eigen::Vector3d::Zero(), ball = heel;
      for (const int part : feet[side]) {
        heel += from[part] / static_cast<double>(feet[side].size());
        ball += to[part] / static_cast<double>(feet[side].size());
      }
      const double radius = body.parts[feet[side][0]].radius;
      const Eigen::Vector3d down(0, 0, radius);
      centres_[side][2 * frame] = {heel - down, underside(heel, radius)};
      centres_[side][2 * frame + 1] = {ball - down, underside(ball, radius)};
    }
  }
}

double SoleTracks::slide(Side side, int first, int last) const {
  double largest = 0.0;
  for (int end = 0; end < 2; ++end) {
    std::vector<double> x, y;
    for (int frame = first; frame <= last; ++frame) {
      const Centre& centre = centres_[side][2 * frame + end];
      if (centre.height > kTouchHeight) continue;
      x.push_back(centre.at.x());
      y.push_back(centre.at.y());
    }
    if (x.empty()) continue;
    const Eigen::Vector2d rest(median(x), median(y));
    for (int frame = first; frame <= last; ++frame) {
      const Centre& centre = centres_[side][2 * frame + end];
      if (centre.height <= kTouchHeight)
        largest = std::max(largest, (centre.at.head<2>() - rest).norm());
    }
  }
  return largest;
}

double SoleTracks::penetration() const {
  double deepest = 0.0;
  for (const auto& heights : lowest_) {
    for (const double height : heights) deepest = std::max(deepest, -height);
  }
  return deepest;
}

SoleEnds SoleTracks::ends(Side side, int frame) const {
  return {centres_[side][2 * frame].at, centres_[side][2 * frame + 1].at};
}

int SoleTracks::flattest(Side side, int first, int last) const {
  const auto higher = [&](int frame) {
    return std::max(centres_[side][2 * frame].height, centres_[side][2 * frame + 1].height);
  };
  int best = first;
  for (int frame = first; frame <= last; ++frame) {
    if (higher(frame) < higher(best)) best = frame;
  }
  return best;
}

std::vector<StepMeasure> measureSteps(const AnimationBuffer& walk, const SoleTracks& soles) {
  std::vector<StepMeasure> steps;
  std::array<const Footprint*, 2> before = {nullptr, nullptr};
  const auto printOf = [&](const Footprint& print) -> SolePrint {
    const int flat = soles.flattest(print.side, print.first_frame, print.last_frame);
    return {print.position, soles.ends(print.side, flat)};
  };
  for (const Footprint& print : walk.footprints) {
    const Footprint *own = before[print.side], *standing = before[other(print.side)];
    StepMeasure step;
    step.side = print.side;
    step.at = print.position;
    if (own != nullptr && standing != nullptr) {
      StepPrints prints{print.side, printOf(*own), printOf(print), printOf(*standing), 0.0, {}};
      prints.along = headingBetween(standing->heading, print.heading);
      for (int frame = own->last_frame; frame <= print.first_frame; ++frame) {
        prints.swing.push_back(soles.ends(print.side, frame));
      }
      step = measureStep(prints);
    }
    step.strike = print.first_frame * walk.frame_time;
    step.lift_off = print.last_frame * walk.frame_time;
    step.slide = soles.slide(print.side, print.first_frame, print.last_frame);
    before[print.side] = &print;
    steps.push_back(step);
  }
  return steps;
}

}  // namespace amble
