#include "animation/editing/sole_contact.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "animation/editing/foot_lock.h"
#include "animation/editing/least_curve.h"
#include "animation/editing/toe_turn.h"

namespace amble {
namespace {

// Weight of a frame in which the sole is on the floor: its lowest point changes from heel to ball
// to toes in a corner, which is rounded [1].
constexpr double kRests = 100.0;
constexpr double kWidth = 0.035;  // as feet are moved along the floor [s]
// Over which what is still in the floor is raised out of it [s]. Less, and feet jerk; more, and
// they float.
constexpr double kRaise = 0.05;
// What a swinging foot keeps between its sole and the floor in the middle of its swing, less
// towards its ends [m]: people keep 10 to 20 mm.
constexpr double kClear = 0.01;

/// How high the points of a sole are over the floor at each frame [m].
struct SoleHeights {
  std::vector<double> heel, ball, tip;
};

/// Toes as they lie in a track, at each frame.
struct Toes {
  std::vector<Eigen::Vector3d> bone;  // from the ball to the centre of the tip [m, World]
  std::vector<Eigen::Vector3d> axis;  // toe_turn.h
};

Toes toesOf(const Clip& clip, int joint, const FootShape& shape, const FootTrack& foot) {
  Toes toes;
  std::vector<JointFrame> joints(clip.skeleton.size());
  const Eigen::Vector3d forward_T =
      (shape.q_SF * shape.q_FT).conjugate() * Eigen::Vector3d::UnitX();
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, joints);
    toes.bone.emplace_back((shape.tip_x - shape.ball_x) * (joints[joint].q_WJ * forward_T));
  }
  toes.axis = toeAxes(toes.bone, foot.q_WF);
  return toes;
}

SoleHeights heightsOf(const FootTrack& foot, const FootShape& shape, const Toes& toes) {
  SoleHeights heights;
  for (size_t i = 0; i < foot.toe.size(); ++i) {
    const SoleEnds ends = soleEnds(shape, foot.ankle[i], foot.q_WF[i]);
    heights.heel.push_back(ends.heel.z());
    heights.ball.push_back(ends.ball.z());
    heights.tip.push_back(ends.ball.z() + toes.bone[i].z());
  }
  return heights;
}

/// Bends toes up by what their tips are lower than ball and floor both.
void bendToes(const Toes& toes, double frame_time, SoleHeights& heights, FootTrack& foot) {
  std::vector<double> bend;
  for (size_t i = 0; i < heights.tip.size(); ++i) {
    const double missing = std::min(0.0, heights.ball[i]) - heights.tip[i];
    bend.push_back(missing > 0.0 ? turnUp(toes.bone[i], toes.axis[i], missing) : 0.0);
  }
  const std::vector<double> smooth = curveOver(bend, frame_time, kRaise);
  for (size_t i = 0; i < smooth.size(); ++i) {
    if (smooth[i] == 0.0) continue;
    const Eigen::AngleAxisd turn(smooth[i], toes.axis[i]);
    foot.toes[i] = turn * foot.toes[i];
    heights.tip[i] = heights.ball[i] + (turn * toes.bone[i]).z();
  }
}

/// What a foot keeps between itself and the floor at each frame [m, >= 0]: nothing where it stands.
std::vector<double> clearances(const std::vector<FootPlant>& plants, int frames) {
  std::vector<double> clear(frames, 0.0);
  for (size_t k = 0; k + 1 < plants.size(); ++k) {
    const int first = plants[k].last, last = plants[k + 1].first;
    for (int i = first; i <= last && last > first; ++i) {
      const double share = static_cast<double>(i - first) / (last - first);
      clear[i] = kClear * 4.0 * share * (1.0 - share);
    }
  }
  return clear;
}

/// How far a foot is moved up at each frame [m].
Eigen::VectorXd liftOf(const SoleHeights& heights, const std::vector<FootPlant>& plants,
                       double frame_time) {
  const int frames = static_cast<int>(heights.ball.size());
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(frames, 1);
  std::vector<double> weights(frames, 0.0), lowest(frames, 0.0);
  for (int i = 0; i < frames; ++i) {
    lowest[i] = std::min({heights.heel[i], heights.ball[i], heights.tip[i]});
    wanted(i, 0) = -lowest[i];
  }
  for (const FootPlant& plant : plants) {
    std::fill(weights.begin() + plant.first, weights.begin() + plant.last + 1, kRests);
  }
  Eigen::VectorXd lift = leastCurve(wanted, weights, frame_time, kWidth);
  std::vector<double> missing = clearances(plants, frames);
  for (int i = 0; i < frames; ++i) missing[i] = std::max(0.0, missing[i] - (lowest[i] + lift[i]));
  const std::vector<double> raise = curveOver(missing, frame_time, kRaise);
  for (int i = 0; i < frames; ++i) lift[i] += raise[i];
  return lift;
}

}  // namespace

double restOnFloor(const Clip& clip, const JointRoles& roles,
                   const std::array<FootShape, 2>& shapes, const FootPlants& plants,
                   WalkTracks& tracks) {
  assert(plants.frames == clip.frames());
  std::array<Eigen::MatrixXd, 2> shifts;
  for (const Side side : {kLeft, kRight}) {
    FootTrack& foot = tracks.feet[side];
    const Toes toes = toesOf(clip, roles.legs[side].toe, shapes[side], foot);
    SoleHeights heights = heightsOf(foot, shapes[side], toes);
    bendToes(toes, clip.frame_time, heights, foot);
    shifts[side] = Eigen::MatrixXd::Zero(clip.frames(), 3);
    shifts[side].col(2) = liftOf(heights, plants.plants[side], clip.frame_time);
  }
  shiftFeet(shifts, plants, clip.frame_time, tracks);
  return std::max(shifts[kLeft].cwiseAbs().maxCoeff(), shifts[kRight].cwiseAbs().maxCoeff());
}

}  // namespace amble
