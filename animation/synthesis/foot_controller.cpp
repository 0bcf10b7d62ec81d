#include "animation/synthesis/foot_controller.h"

#include <algorithm>
#include <cmath>

#include "animation/synthesis/leg_reach.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Replaces every value by the mean of those within `half` of it.
void smoothed(std::vector<double>& values, int half) {
  const int n = static_cast<int>(values.size());
  std::vector<double> sums(n + 1, 0.0);
  for (int i = 0; i < n; ++i) sums[i + 1] = sums[i] + values[i];
  for (int i = 0; i < n; ++i) {
    const int first = std::max(0, i - half), last = std::min(n - 1, i + half);
    values[i] = (sums[last + 1] - sums[first]) / (last + 1 - first);
  }
}

// A dip near a stance, which stays as it is: one of a millimetre or two may come at once, a deep
// one needs its time.
void fadeToStances(std::vector<double>& dip, double speed, double frame_time) {
  const int n = static_cast<int>(dip.size());
  for (int i = 0; i < n; ++i) {
    const double from_end = std::min(i, n - 1 - i) * frame_time;
    const double fade = std::max(HipDip::kShortestFade, dip[i] / speed);
    dip[i] *= smoothstep(from_end / fade);
  }
}

LaneSoles sideBySide(const std::array<Sole, 4>& soles) {
  LaneSoles lanes;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) {
      lanes.position[4 * k + i] = soles[i].place.position[k];
      lanes.normal[4 * k + i] = soles[i].place.normal[k];
    }
    lanes.heading[i] = soles[i].place.heading;
    lanes.pitch[i] = soles[i].pitch;
    lanes.roll[i] = soles[i].roll;
  }
  return lanes;
}

}  // namespace

FootController::FootController(const Skeleton& skeleton, const JointRoles& roles,
                               const std::array<FootShape, 2>& shapes, const GaitBlend& blend,
                               const std::array<Eigen::Vector3d, 2>& knee_axes)
    : roles_(roles),
      shapes_(shapes),
      leg_lengths_{roles.legLength(skeleton, kLeft), roles.legLength(skeleton, kRight)},
      blend_(blend),
      chain_(chainOf(skeleton, std::array{roles.legs[kLeft].foot, roles.legs[kRight].foot})) {
  for (const int joint : chain_) {
    const Joint& link = skeleton.joint(joint);
    const auto parent = std::find(chain_.begin(), chain_.end(), link.parent);
    parents_.push_back(joint == 0 ? -1 : static_cast<int>(parent - chain_.begin()));
    offsets_.insert(offsets_.end(), {link.offset.x(), link.offset.y(), link.offset.z()});
  }
  for (const Side side : {kLeft, kRight}) lanes_[side] = laneLeg(side, knee_axes[side]);
}

LaneLeg FootController::laneLeg(Side side, const Eigen::Vector3d& knee_axis) const {
  const auto bone = [&](int joint) {
    const auto at = std::find(chain_.begin(), chain_.end(), joint) - chain_.begin();
    return LaneLeg::Bone{joint, static_cast<int>(at), parents_[at]};
  };
  const LegJoints& joints = roles_.legs[side];
  const FootShape& shape = shapes_[side];
  LaneLeg leg{side,
              bone(joints.up_leg),
              bone(joints.leg),
              bone(joints.foot),
              joints.toe,
              {},
              LegReach::kLongest,
              leg_lengths_[side],
              shape.radius,
              shape.ankle_height,
              shape.ankle_x,
              shape.heel_x,
              shape.ball_x,
              {},
              {},
              {}};
  std::copy_n(knee_axis.data(), 3, leg.knee_axis);
  std::copy_n(shape.q_SF.coeffs().data(), 4, leg.q_SF);
  std::copy_n(shape.q_FT.coeffs().data(), 4, leg.q_FT);
  std::copy_n(shape.lateral_T.data(), 3, leg.lateral_T);
  return leg;
}

LaneLegs FootController::view() const {
  return {static_cast<int>(chain_.size()),
          chain_.data(),
          parents_.data(),
          offsets_.data(),
          {lanes_[kLeft], lanes_[kRight]}};
}

bool FootController::apply(AnimationBuffer& buffer) const {
  return place(buffer, {LegReach::kDip, HipDip::kDeepest, 1.0, dips});
}

bool FootController::applyUneven(AnimationBuffer& buffer) const {
  return place(buffer, {LegReach::kUneven, HipDip::kUnevenDeepest, HipDip::kUnevenHeel, sinks});
}

// Frames from `first` on; where there are fewer, the last one stands for what is missing.
FootController::Four FootController::fourFrom(int first, int last) {
  return {first, std::min(first + 1, last), std::min(first + 2, last), std::min(first + 3, last)};
}

// Legs are placed where the hips are; only where those are lowered then, from anew. Never at the
// first and last frame: those are stances.
bool FootController::place(AnimationBuffer& buffer, const Manner& manner) const {
  const int n = buffer.size();
  std::vector<double> joints(kLaneJoint * chain_.size());
  LaneLegFrames legs{joints.data(), {}};
  Trial trial;
  if (!tryLegs(buffer, manner, legs, trial)) return false;
  const std::vector<double> lowered = manner.lowering(trial.missing, buffer.frame_time);
  std::vector<int> again;
  for (int i = 0; i < n; ++i) {
    if (lowered[i] == 0.0 && !trial.reached[i]) return false;
    if (lowered[i] == 0.0) continue;
    for (size_t k = 0; k < chain_.size(); ++k)
      buffer.poses.rotations(i)[chain_[k]] = trial.captured[i * chain_.size() + k];
    buffer.poses.p_WR(i).z() -= lowered[i];
    again.push_back(i);
  }
  bool reached[4];
  for (size_t first = 0; first < again.size(); first += 4) {
    Four frames;
    for (size_t i = 0; i < 4; ++i) frames[i] = again[std::min(first + i, again.size() - 1)];
    aim(buffer, frames, manner.heel_share, legs);
    turn(frames, legs, buffer, reached);
    if (!std::all_of(reached, reached + 4, [](bool leg) { return leg; })) return false;
  }
  return true;
}

// False where hips would have to dip too deep.
bool FootController::tryLegs(AnimationBuffer& buffer, const Manner& manner, LaneLegFrames& legs,
                             Trial& trial) const {
  const int n = buffer.size();
  trial.missing.resize(n + 3);
  trial.reached.resize(n);
  trial.captured.reserve(n * chain_.size());
  bool reached[4];
  for (int first = 0; first < n; first += 4) {
    const Four frames = fourFrom(first, n - 1);
    aim(buffer, frames, manner.heel_share, legs);
    legKernel().lower(view(), legs, manner.reach, &trial.missing[first]);
    for (int i = first; i < std::min(first + 4, n); ++i) {
      if (i == 0 || i == n - 1) trial.missing[i] = 0.0;
      if (trial.missing[i] > manner.deepest) return false;
      for (const int j : chain_) trial.captured.push_back(buffer.poses.rotations(i)[j]);
    }
    turn(frames, legs, buffer, reached);
    for (int i = 0; i < 4; ++i) trial.reached[frames[i]] = reached[i];
  }
  trial.missing.resize(n);
  return true;
}

// Share of its length to which a leg behind stretches: less around lift-off.
double FootController::heelReach(double at) {
  constexpr double kFrom = LegReach::kPreSwingFrom, kTo = LegReach::kPreSwingTo;
  const double rise = smoothstep((at - kFrom) / (1.0 - kFrom));
  const double fall = smoothstep((kTo - at) / (kTo - 1.0));
  return LegReach::kHeel - LegReach::kPreSwing * rise * fall;
}

// Where the legs are and their feet are to be. Behind the walker, where a leg would be too long,
// the heel rises: only there it is asked how far.
void FootController::aim(const AnimationBuffer& buffer, const Four& frames, double heel_share,
                         LaneLegFrames& legs) const {
  const double* position[4];
  const double* rotations[4];
  for (int i = 0; i < 4; ++i) {
    position[i] = buffer.poses.p_WR(frames[i]).data();
    rotations[i] = buffer.poses.rotations(frames[i])[0].coeffs().data();
  }
  const LegKernel& kernel = legKernel();
  kernel.placeChain(view(), position, rotations, legs);
  for (const Side side : {kLeft, kRight}) {
    std::array<Sole, 4> soles;
    for (int i = 0; i < 4; ++i)
      soles[i] = soleOf(buffer.states[frames[i]].feet[side], blend_.foot(side));
    LaneSoles lanes = sideBySide(soles);
    kernel.aim(lanes_[side], lanes, legs);
    bool risen = false;
    for (int i = 0; i < 4; ++i) {
      const double at = buffer.states[frames[i]].feet[side].at;
      lanes.pitch[i] = risenPitch(soles[i], at, heel_share, side, i, legs);
      risen = risen || lanes.pitch[i] != soles[i].pitch;
    }
    if (risen) kernel.aim(lanes_[side], lanes, legs);
  }
}

// Of one of four soles, at a time of its foot (FootState::at).
double FootController::risenPitch(const Sole& sole, double at, double heel_share, Side side,
                                  int lane, const LaneLegFrames& legs) const {
  const double distance = legs.targets[side].distance[lane];
  const double least = (LegReach::kHeel - LegReach::kPreSwing) * leg_lengths_[side] - kHeelRests;
  if (distance < least) return sole.pitch;
  const LaneLeg& leg = lanes_[side];
  const Eigen::Vector3d hip(legs.hip(leg, 0, lane), legs.hip(leg, 1, lane), legs.hip(leg, 2, lane));
  return raisedPitch(sole, shapes_[side], hip, distance, heelReach(at) * leg_lengths_[side],
                     heel_share);
}

void FootController::turn(const Four& frames, const LaneLegFrames& legs, AnimationBuffer& buffer,
                          bool reached[4]) const {
  double* rotations[4];
  for (int i = 0; i < 4; ++i) rotations[i] = buffer.poses.rotations(frames[i])[0].coeffs().data();
  legKernel().reach(view(), legs, rotations, reached);
}

std::vector<double> FootController::missingHeights(const AnimationBuffer& buffer, double share,
                                                   double heel_share) const {
  const int n = buffer.size();
  std::vector<double> joints(kLaneJoint * chain_.size()), missing(n + 3);
  LaneLegFrames legs{joints.data(), {}};
  for (int first = 0; first < n; first += 4) {
    aim(buffer, fourFrom(first, n - 1), heel_share, legs);
    legKernel().lower(view(), legs, share, &missing[first]);
  }
  missing.resize(n);
  return missing;
}

// Around frames in which a leg would be too short.
std::vector<double> FootController::dips(const std::vector<double>& missing, double frame_time) {
  const int n = static_cast<int>(missing.size());
  std::vector<double> dip(n, 0.0);
  const int reach = std::max(1, static_cast<int>(std::lround(HipDip::kTime / frame_time)));
  for (int i = 1; i + 1 < n; ++i) {
    if (missing[i] <= 0.0) continue;
    for (int j = std::max(1, i - reach); j <= std::min(n - 2, i + reach); ++j) {
      const double away = std::abs(j - i) / static_cast<double>(reach);
      dip[j] = std::max(dip[j], missing[i] * 0.5 * (1.0 + std::cos(kPi * away)));
    }
  }
  fadeToStances(dip, HipDip::kSpeed, frame_time);
  return dip;
}

// The least smooth curve over what is missing: the largest of what is missing within
// HipDip::kUnevenTime, averaged over as long.
std::vector<double> FootController::sinks(const std::vector<double>& missing, double frame_time) {
  const int n = static_cast<int>(missing.size());
  std::vector<double> sunk(n, 0.0);
  const int reach = std::max(1, static_cast<int>(std::lround(HipDip::kUnevenTime / frame_time)));
  for (int i = 0; i < n; ++i) {
    const auto from = missing.begin() + std::max(0, i - reach);
    const auto to = missing.begin() + std::min(n, i + reach + 1);
    sunk[i] = *std::max_element(from, to);
  }
  for (int pass = 0; pass < 2; ++pass) smoothed(sunk, reach / 2);
  fadeToStances(sunk, HipDip::kUnevenSpeed, frame_time);
  return sunk;
}

}  // namespace amble
