#include "animation/editing/foot_lock.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "animation/editing/least_curve.h"

namespace amble {
namespace {

// Of a plant, at both ends, in which the toe comes down and leaves, at up to 1 m/s, and is not
// held: QUALITY.md judges from 15 % on, and whoever finds plants himself finds their ends
// elsewhere.
constexpr double kLoose = 0.12;
constexpr double kHeld = 1e10;  // weight of a frame in which the toe is held
// Corrections come and go over about twice so long: a third of a swing [s].
constexpr double kFootWidth = 0.035;
constexpr double kPelvisWidth = 0.12;  // of the pelvis, which is heavier [s]
constexpr double kSwinging = 0.3;  // what a swinging foot counts for the pelvis, a standing one 1

/// Where a toe shall be moved to, and how firmly, at each frame.
struct Wanted {
  Eigen::MatrixXd shift;        // x y [m]
  std::vector<double> weights;  // [>= 0]
};

/// First and last frame of a plant in which its toe is held.
std::pair<int, int> heldFrames(const FootPlant& plant) {
  const int loose = static_cast<int>(std::floor(kLoose * (plant.last - plant.first + 1)));
  return {plant.first + loose, plant.last - loose};
}

Wanted wantedOf(const std::vector<Eigen::Vector3d>& toe, const std::vector<FootPlant>& plants) {
  const auto frames = static_cast<Eigen::Index>(toe.size());
  Wanted wanted{Eigen::MatrixXd::Zero(frames, 2), std::vector<double>(toe.size(), 0.0)};
  for (const FootPlant& plant : plants) {
    const auto [first, last] = heldFrames(plant);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (int i = first; i <= last; ++i) sum += toe[i].head<2>();
    for (int i = first; i <= last; ++i) {
      wanted.weights[i] = kHeld;
      wanted.shift.row(i) = (sum / (last - first + 1) - toe[i].head<2>()).transpose();
    }
  }
  return wanted;
}

/// Between the feet, nearer to the one that stands.
Eigen::MatrixXd pelvisShift(const std::array<Eigen::MatrixXd, 2>& shifts, const FootPlants& plants,
                            double frame_time) {
  const std::array<std::vector<bool>, 2> planted = {plants.planted(kLeft), plants.planted(kRight)};
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(shifts[kLeft].rows(), 2);
  for (Eigen::Index i = 0; i < wanted.rows(); ++i) {
    const double left = planted[kLeft][i] ? 1.0 : kSwinging;
    const double right = planted[kRight][i] ? 1.0 : kSwinging;
    wanted.row(i) = (left * shifts[kLeft].row(i) + right * shifts[kRight].row(i)) / (left + right);
  }
  return leastCurve(wanted, std::vector<double>(wanted.rows(), 1.0), frame_time, kPelvisWidth);
}

}  // namespace

double lockTracks(const FootPlants& plants, double frame_time, WalkTracks& tracks) {
  std::array<Eigen::MatrixXd, 2> shifts;
  double farthest = 0.0;
  for (const Side side : {kLeft, kRight}) {
    FootTrack& foot = tracks.feet[side];
    const Wanted wanted = wantedOf(foot.toe, plants.plants[side]);
    shifts[side] = leastCurve(wanted.shift, wanted.weights, frame_time, kFootWidth);
    for (int i = 0; i < plants.frames; ++i) {
      foot.move(i, {shifts[side](i, 0), shifts[side](i, 1), 0.0});
      farthest = std::max(farthest, shifts[side].row(i).norm());
    }
  }
  const Eigen::MatrixXd pelvis = pelvisShift(shifts, plants, frame_time);
  for (Eigen::Index i = 0; i < pelvis.rows(); ++i) {
    tracks.root[i].head<2>() += pelvis.row(i).transpose();
  }
  return farthest;
}

Clip lockFeet(const Clip& clip, const JointRoles& roles, const FootPlants& plants, FootLock* lock) {
  assert(plants.frames == clip.frames());
  WalkTracks tracks = tracksOf(clip, roles);
  FootLock took;
  took.farthest = lockTracks(plants, clip.frame_time, tracks);
  const Clip held = followTracks(clip, roles, tracks, &took.fit);
  if (lock != nullptr) *lock = took;
  return held;
}

}  // namespace amble
