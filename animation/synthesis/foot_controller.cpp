#include "animation/synthesis/foot_controller.h"

#include <algorithm>
#include <cmath>

#include "animation/synthesis/hip_dip.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

void putBeside(const Sole& sole, int lane, LaneSoles& lanes) {
  for (int k = 0; k < 3; ++k) {
    lanes.position[4 * k + lane] = sole.place.position[k];
    lanes.normal[4 * k + lane] = sole.place.normal[k];
  }
  lanes.heading[lane] = sole.place.heading;
  lanes.pitch[lane] = sole.pitch;
  lanes.roll[lane] = sole.roll;
  lanes.toes[lane] = sole.toes;
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
              LegReach::kRefused,
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

// Frames from `first` on; where there are fewer, the last one stands for what is missing.
FootController::Four FootController::fourFrom(int first, int last) {
  return {first, std::min(first + 1, last), std::min(first + 2, last), std::min(first + 3, last)};
}

// Legs are placed where the hips are; only where those are lowered, from anew, and once more where
// that made a leg longer: a heel rises less under lower hips.
bool FootController::apply(AnimationBuffer& buffer) const {
  constexpr int kRounds = 3;
  constexpr double kEnough = 1e-9;  // [m]
  Scratch scratch(chain_.size());
  LaneLegFrames& legs = scratch.legs;
  Trial trial;
  if (!tryLegs(buffer, scratch, trial)) return false;
  std::vector<double> lowered(buffer.size(), 0.0), missing(4);
  bool reached[4];
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<double> next = hipDip(trial.missing, buffer.frame_time);
    std::vector<int> again;
    for (int i = 0; i < buffer.size(); ++i) {
      if (next[i] == lowered[i]) continue;
      for (size_t k = 0; k < chain_.size(); ++k)
        buffer.poses.rotations(i)[chain_[k]] = trial.captured[i * chain_.size() + k];
      buffer.poses.p_WR(i).z() = trial.height[i] - next[i];
      again.push_back(i);
    }
    if (again.empty()) break;
    bool more = false;
    for (size_t first = 0; first < again.size(); first += 4) {
      Four frames;
      for (size_t i = 0; i < 4; ++i) frames[i] = again[std::min(first + i, again.size() - 1)];
      aim(buffer, frames, trial, legs);
      legKernel().lower(view(), legs, missing.data());
      turn(frames, legs, buffer, reached);
      for (int i = 0; i < 4; ++i) {
        trial.reached[frames[i]] = reached[i];
        if (missing[i] <= kEnough) continue;
        trial.missing[frames[i]] = next[frames[i]] + missing[i];
        more = true;
      }
    }
    if (!more) break;
    lowered = next;
  }
  return std::ranges::all_of(trial.reached, [](char leg) { return leg != 0; });
}

// False where hips would have to dip too deep.
bool FootController::tryLegs(AnimationBuffer& buffer, Scratch& scratch, Trial& trial) const {
  const int n = buffer.size();
  LaneLegFrames& legs = scratch.legs;
  trial.missing.resize(n + 3);
  trial.reached.resize(n);
  trial.captured.reserve(n * chain_.size());
  trial.soles.reserve(n);
  bool reached[4];
  for (int first = 0; first < n; first += 4) {
    const Four frames = fourFrom(first, n - 1);
    for (int i = first; i < std::min(first + 4, n); ++i) addSoles(buffer.states[i], scratch, trial);
    aim(buffer, frames, trial, legs);
    legKernel().lower(view(), legs, &trial.missing[first]);
    for (int i = first; i < std::min(first + 4, n); ++i) {
      if (trial.missing[i] > HipDip::kDeepest) return false;
      trial.height.push_back(buffer.poses.p_WR(i).z());
      for (const int j : chain_) trial.captured.push_back(buffer.poses.rotations(i)[j]);
    }
    turn(frames, legs, buffer, reached);
    for (int i = 0; i < 4; ++i) trial.reached[frames[i]] = reached[i];
  }
  trial.missing.resize(n);
  return true;
}

// Of the frame after those that are there.
void FootController::addSoles(const FrameState& state, Scratch& scratch, Trial& trial) const {
  std::array<Sole, 2>& soles = trial.soles.emplace_back();
  for (const Side side : {kLeft, kRight}) {
    const FootState& foot = state.feet[side];
    Follows& follows = scratch.follows[side];
    if (follows.state == nullptr || !followsSame(foot, *follows.state)) {
      follows.cycle = blend_.feet().of(side, foot).asOne(follows.blended);
      follows.state = &foot;
    }
    soles[side] = soleOf(foot, follows.cycle, shapes_[side]);
  }
}

// Where the legs are and their feet are to be. Behind the walker, where a leg would be too long,
// the heel rises: only there it is asked how far.
void FootController::aim(const AnimationBuffer& buffer, const Four& frames, const Trial& trial,
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
    LaneSoles lanes;
    for (int i = 0; i < 4; ++i) putBeside(trial.soles[frames[i]][side], i, lanes);
    kernel.aim(lanes_[side], lanes, legs);
    bool risen = false;
    for (int i = 0; i < 4; ++i) {
      const Sole& sole = trial.soles[frames[i]][side];
      legs.targets[side].longest[i] =
          longestLeg(legs.targets[side].captured[i], leg_lengths_[side], sole.unloaded);
      const double pitch = lanes.pitch[i];
      lanes.pitch[i] = risenPitch(sole, side, i, legs);
      risen = risen || lanes.pitch[i] != pitch;
    }
    if (risen) kernel.aim(lanes_[side], lanes, legs);
  }
}

// Of one of four soles, that is pitched so.
double FootController::risenPitch(const Sole& sole, Side side, int lane,
                                  const LaneLegFrames& legs) const {
  const LaneLegFrames::Target& target = legs.targets[side];
  if (!(target.behind[lane] > 0.0)) return sole.pitch;
  const double* p = target.hip_S + lane;
  return raisedPitch(sole.pitch, shapes_[side],
                     {{p[0], p[4], p[8]}, target.behind[lane], sole.unloaded},
                     target.distance[lane], target.longest[lane]);
}

void FootController::turn(const Four& frames, const LaneLegFrames& legs, AnimationBuffer& buffer,
                          bool reached[4]) const {
  double* rotations[4];
  for (int i = 0; i < 4; ++i) rotations[i] = buffer.poses.rotations(frames[i])[0].coeffs().data();
  legKernel().reach(view(), legs, rotations, reached);
}

}  // namespace amble
