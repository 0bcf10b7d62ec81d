#include "animation/editing/foot_lift.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "animation/editing/least_curve.h"
#include "animation/editing/toe_turn.h"

namespace amble {
namespace {

constexpr double kSmooth = 0.05;  // over which the change of height is averaged [s]
constexpr double kSmoothUnder =
    0.02;  // the same where it is lowered; longer, and lows are lost [s]
// Toes that are bent under come lower before they come up: where the smooth turn only gets them
// there they are turned by more, which may do the same to the frames beside [1].
constexpr int kTurnRounds = 3;
constexpr double kTellsMost = 0.1;  // of the change's largest, below which a frame decides nothing

/// A foot's swing from one plant to the next.
struct Swing {
  const PlantMeasures &from, &to;
  int first() const { return from.plant.last; }
  int last() const { return to.plant.first; }
};

/// How high the sole is over the line between its prints, at each frame of the swing [m]; 0
/// outside.
std::vector<double> heights(const Swing& swing, const FootTrack& foot, double heel) {
  std::vector<double> heights(foot.toe.size(), 0.0);
  for (int i = swing.first(); i <= swing.last(); ++i) {
    const SoleEnds sole = capturedSole(foot.ankle[i], foot.toe[i], heel, swing.from.flat_pitch);
    heights[i] = heightOver(swing.from.ends, swing.to.ends, sole);
  }
  return heights;
}

/// A smooth curve that is nowhere above values that are not negative, and nowhere negative.
std::vector<double> curveUnder(const std::vector<double>& values, double frame_time, double width) {
  const double most = *std::max_element(values.begin(), values.end());
  std::vector<double> missing;
  for (const double value : values) missing.push_back(most - value);
  std::vector<double> curve = curveOver(missing, frame_time, width);
  for (double& value : curve) value = std::max(0.0, most - value);
  return curve;
}

/// What a swing is raised by where it is to be higher, and lowered by where it is not: less than
/// the sole is clear of the line, so that a lower lift puts no foot into the floor.
std::vector<double> changeOf(const std::vector<double>& height, double factor, double frame_time) {
  std::vector<double> clear(height);
  for (double& h : clear) h = std::max(0.0, h);
  return factor < 1.0 ? curveUnder(clear, frame_time, kSmoothUnder)
                      : averaged(clear, frame_time, kSmooth);
}

/// The toes of one foot at each frame as captured [World, m]; empty without tips.
struct ToeTips {
  std::vector<Eigen::Vector3d> joint, tip;
  std::vector<Eigen::Vector3d> axis;  // toe_turn.h

  ToeTips(const Clip& clip, int toe) {
    if (toe < 0 || clip.skeleton.joint(toe).end_sites.empty()) return;
    const auto& sites = clip.skeleton.joint(toe).end_sites;
    const Eigen::Vector3d& farthest = *std::max_element(
        sites.begin(), sites.end(), [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
          return a.squaredNorm() < b.squaredNorm();
        });
    std::vector<JointFrame> joints(clip.skeleton.size());
    std::vector<Eigen::Quaterniond> q_WF;
    std::vector<Eigen::Vector3d> bones;
    for (int i = 0; i < clip.frames(); ++i) {
      forwardKinematics(clip, i, joints);
      joint.push_back(joints[toe].p_WJ);
      tip.push_back(joints[toe] * farthest);
      bones.emplace_back(tip.back() - joint.back());
      q_WF.push_back(joints[clip.skeleton.joint(toe).parent].q_WJ);
    }
    axis = toeAxes(bones, q_WF);
  }
};

/// Turns toes up where the foot is lowered so far that their tips come below the line between the
/// prints, over which they stand, and below where they were captured.
void bendToes(const Swing& swing, const std::vector<double>& change, const ToeTips& toes,
              double frame_time, FootTrack& foot) {
  if (toes.tip.empty()) return;
  const auto over = [&](int i) {
    const SoleEnds from{swing.from.ends.ball, swing.from.ends.ball},
        to{swing.to.ends.ball, swing.to.ends.ball};
    return heightOver(from, to, {toes.tip[i], toes.tip[i]});
  };
  const double stood = over((swing.from.plant.first + swing.from.plant.last) / 2);
  std::vector<double> turn(foot.toe.size(), 0.0), smooth = turn;
  for (int round = 0; round < kTurnRounds; ++round) {
    for (int i = swing.first(); i <= swing.last(); ++i) {
      const Eigen::Vector3d bone = toes.tip[i] - toes.joint[i];
      const double gained = (Eigen::AngleAxisd(smooth[i], toes.axis[i]) * bone).z() - bone.z();
      const double captured = over(i), lowest = std::min(captured, stood);
      const double missing = lowest - (captured + change[i]);
      if (missing > gained) turn[i] = std::max(turn[i], turnUp(bone, toes.axis[i], missing));
    }
    smooth = curveOver(turn, frame_time, kSmoothUnder);
  }
  for (size_t i = 0; i < smooth.size(); ++i) {
    if (smooth[i] == 0.0) continue;
    foot.toes[i] = Eigen::AngleAxisd(smooth[i], toes.axis[i]) * foot.toes[i];
  }
}

void liftSwing(const Swing& swing, double factor, double heel, double frame_time,
               const ToeTips& toes, FootTrack& foot) {
  const std::vector<double> height = heights(swing, foot, heel);
  std::vector<double> change = changeOf(height, factor, frame_time);
  const double lift = *std::max_element(height.begin(), height.end());
  const double most = *std::max_element(change.begin(), change.end());
  if (!(lift > 0.0)) return;
  // The largest share with which no frame gets over the lift that is asked for.
  double share = std::numeric_limits<double>::infinity();
  for (int i = swing.first(); i <= swing.last(); ++i) {
    if (change[i] > kTellsMost * most) {
      share = std::min(share, (factor * lift - height[i]) / change[i]);
    }
  }
  // Nor does any get under the line, where a curve under a sharp peak would ask for that.
  if (factor < 1.0) share = std::max(share, -1.0);
  for (size_t i = 0; i < change.size(); ++i) {
    change[i] *= share;
    foot.move(static_cast<int>(i), {0.0, 0.0, change[i]});
  }
  if (factor < 1.0) bendToes(swing, change, toes, frame_time, foot);
}

}  // namespace

void scaleLift(const CapturedWalk& walk, const std::function<double(int frame)>& factor,
               WalkTracks& tracks) {
  for (const Side side : {kLeft, kRight}) {
    const double heel = kAnkleHeightOfLeg * walk.roles.legLength(walk.clip.skeleton, side);
    const ToeTips toes(walk.clip, walk.roles.legs[side].toe);
    const PlantMeasures* before = nullptr;
    for (const PlantMeasures& plant : walk.analysis.gait.plants) {
      if (plant.side != side) continue;
      if (before != nullptr) {
        const Swing swing{*before, plant};
        const double of_swing = factor((swing.first() + swing.last()) / 2);
        liftSwing(swing, of_swing, heel, walk.clip.frame_time, toes, tracks.feet[side]);
      }
      before = &plant;
    }
  }
}

}  // namespace amble
