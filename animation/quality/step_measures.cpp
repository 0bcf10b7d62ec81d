#include "animation/quality/step_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "animation/body/pose.h"
#include "animation/body/step_prints.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kSupport = 0.012;       // ground so far below a sole supports it [m]
constexpr double kReach = 1.0;           // how far from a sole its ground is looked for [m]
constexpr double kSmall = 0.02;          // less is compared with this [m]
constexpr double kMiddleOfStance = 0.4;  // FootState::at, between flat foot and heel rise
constexpr double kFlatFirst = 20.0;      // of a radian that the sole is rolled, against that
// A print whose stance is cut off further from its middle is not measured.
constexpr double kCutOff = 0.2;

// A foot as it is in a frame.
struct Sole {
  Eigen::Quaterniond q_WS;
  Eigen::Vector3d middle;  // of the sole, as if flat [m, World]
  SoleEnds ends;
};

Sole soleAt(const JointFrame& foot_joint, const FootShape& foot) {
  Sole sole;
  sole.q_WS = foot_joint.q_WJ * foot.q_SF.conjugate();
  sole.middle = foot_joint.p_WJ - sole.q_WS * Eigen::Vector3d(foot.ankle_x, 0.0, foot.ankle_height);
  sole.ends = soleEnds(foot, foot_joint.p_WJ, foot_joint.q_WJ);
  return sole;
}

// Flat on its print.
Sole flatSole(const FootPlace& place, const FootShape& foot) {
  Sole sole;
  sole.q_WS = soleFrame(place.heading, place.normal);
  sole.middle = place.position;
  const Eigen::Vector3d ankle =
      place.position + sole.q_WS * Eigen::Vector3d(foot.ankle_x, 0.0, foot.ankle_height);
  sole.ends = soleEnds(foot, ankle, sole.q_WS * foot.q_SF);
  return sole;
}

double supportOf(const Sole& sole, const FootShape& foot, const Ground& ground) {
  constexpr int kPoints = 51;
  const double back = foot.heel_x - foot.radius, front = foot.tip_x + foot.radius;
  int standing = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double x = back + (front - back) * i / (kPoints - 1);
    const Eigen::Vector3d p = sole.middle + sole.q_WS * Eigen::Vector3d(x, 0.0, 0.0);
    const auto z = ground.height(p.x(), p.y(), p.z(), kReach);
    standing += z && std::abs(p.z() - *z) <= kSupport ? 1 : 0;
  }
  return static_cast<double>(standing) / kPoints;
}

// How far a sole is from lying in the plane of its print [rad].
double rolledBy(const Sole& sole, const FootPlace& place) {
  const double cosine = place.normal.dot(sole.q_WS * Eigen::Vector3d::UnitZ());
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

// The soles of a walk, frame by frame.
class WalkedSoles {
 public:
  WalkedSoles(const Skeleton& skeleton, const JointRoles& roles,
              const std::array<FootShape, 2>& feet, const AnimationBuffer& walk)
      : skeleton_(skeleton), roles_(roles), feet_(feet), walk_(walk), joints_(skeleton.size()) {}

  Sole at(int frame, Side side) {
    forwardKinematics(skeleton_, walk_.poses[frame], joints_);
    return soleAt(joints_[roles_.legs[side].foot], feet_[side]);
  }
  // The frame in which the sole lies flat, nearest to the middle of its stance; a print may be cut
  // off by the buffer's ends.
  int flattest(const Footprint& print) {
    int best = print.first_frame;
    double least = std::numeric_limits<double>::infinity();
    for (int frame = print.first_frame; frame <= print.last_frame; ++frame) {
      const FootState& foot = walk_.states[frame].feet[print.side];
      const double off = std::abs(foot.at - kMiddleOfStance);
      const double cost = off + kFlatFirst * rolledBy(at(frame, print.side), foot.from);
      if (cost < least) least = cost, best = frame;
    }
    return best;
  }

 private:
  const Skeleton& skeleton_;
  const JointRoles& roles_;
  const std::array<FootShape, 2>& feet_;
  const AnimationBuffer& walk_;
  std::vector<JointFrame> joints_;
};

// Where a print's foot was in the middle of its stance.
struct Stood {
  Sole sole;
  int last = 0;  // frame of the print

  SolePrint print() const { return {sole.middle, sole.ends}; }
  // As soleFrame's: across a slope the sole's direction in plan is another, by up to a degree.
  double heading() const {
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d ahead =
        turnBetween(sole.q_WS * up, up) * sole.q_WS * Eigen::Vector3d::UnitX();
    return std::atan2(ahead.y(), ahead.x());
  }
};

// Tilt and support of a sole that stands.
void measureStand(const Sole& sole, const FootShape& foot, const Ground& ground,
                  StepMeasure& step) {
  const auto surface = ground.surface(sole.middle.x(), sole.middle.y(), sole.middle.z(), kReach);
  if (surface) {
    const double cosine = surface->normal.dot(sole.q_WS * Eigen::Vector3d::UnitZ());
    step.tilt = std::acos(std::clamp(cosine, -1.0, 1.0));
  }
  step.supported = supportOf(sole, foot, ground);
}

}  // namespace

std::vector<JudgedStep> measureWalkSteps(const Skeleton& skeleton, const JointRoles& roles,
                                         const std::array<FootShape, 2>& feet,
                                         const AnimationBuffer& walk, const Ground& ground) {
  std::vector<JudgedStep> steps;
  WalkedSoles soles(skeleton, roles, feet, walk);
  std::array<std::optional<Stood>, 2> before;
  for (const Footprint& print : walk.footprints) {
    const Side side = print.side;
    const int frame = soles.flattest(print);
    const FootState& foot = walk.states[frame].feet[side];
    const double off = std::abs(foot.at - kMiddleOfStance);
    // Of a stance of which there is an end only, the foot rolls in all of it.
    const Stood stood{off < kCutOff ? soles.at(frame, side) : flatSole(foot.from, feet[side]),
                      print.last_frame};
    if (before[kLeft] && before[kRight] && off < kCutOff) {
      const Stood &own = *before[side], &standing = *before[other(side)];
      StepPrints prints{side, own.print(), stood.print(), standing.print(), 0.0, {}};
      prints.along = headingBetween(standing.heading(), stood.heading());
      for (int k = own.last + 1; k < print.first_frame; ++k) {
        prints.swing.push_back(soles.at(k, side).ends);
      }
      steps.push_back({print.gait, measureStep(prints)});
      measureStand(stood.sole, feet[side], ground, steps.back().achieved);
    }
    before[side] = stood;
  }
  return steps;
}

GaitParameters largestMiss(const std::vector<JudgedStep>& steps) {
  GaitParameters miss;
  const auto off = [](double asked, double achieved) {
    return std::abs(achieved - asked) / std::max(std::abs(asked), kSmall);
  };
  for (const JudgedStep& step : steps) {
    miss.stride = std::max(miss.stride, off(step.asked.stride, step.achieved.stride));
    miss.lift = std::max(miss.lift, off(step.asked.lift, step.achieved.lift));
    miss.climb = std::max(miss.climb, off(step.asked.climb, step.achieved.climb));
  }
  return miss;
}

}  // namespace amble
