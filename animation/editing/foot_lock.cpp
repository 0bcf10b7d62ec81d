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
// Of that, of a foot that comes down to stand still [1]; one that stood is held until it leaves: it
// starts slowly.
constexpr double kStandingLoose = 0.25;
constexpr double kHeld = 1e10;  // weight of a frame in which the toe is held
// Weight of the frames of a plant that is cut by the clip's begin or end, beyond which nothing is
// held: there a foot goes on by what it is moved by. With none the curve goes on as steeply as it
// came, and a toe that jumped by 44 mm put a foot off by 537 mm within six frames [1].
constexpr double kGoesOn = 100.0;
constexpr double kPelvisWidth = 0.12;  // of the pelvis, which is heavier [s]
// Weight of what the pelvis is to go up or down; the curve's width grows by its sixth root [1].
constexpr double kUpright = 100.0;
constexpr double kSwinging = 0.3;  // what a swinging foot counts for the pelvis, a standing one 1

/// Where a toe shall be moved to, and how firmly, at each frame.
struct Wanted {
  Eigen::MatrixXd shift;        // x y [m]
  std::vector<double> weights;  // [>= 0]
  double width;                 // of the curve: the widest [s]
};

/// First and last frame of a plant in which its toe is held: all of those at the clip's begin and
/// end where the foot comes down or leaves outside of it.
std::pair<int, int> heldFrames(const FootPlant& plant, int frames, double longest_loose) {
  const int loose =
      static_cast<int>(std::floor(std::min(kLoose * (plant.last - plant.first), longest_loose)));
  const bool stood = plant.first == 0 && plant.strike < -1.0 - loose;
  const bool stands_on = plant.last == frames - 1 && plant.lift_off > frames + loose;
  return {stood ? plant.first : plant.first + loose, stands_on ? plant.last : plant.last - loose};
}

/// Which frame says where a foot stands: that in which who walks stands still. -1: the mean.
int printFrame(const FootPlant& plant, int frames, const LockOptions& options) {
  if (options.stands_at_begin && plant.first == 0) return 0;
  if (options.stands_at_end && plant.last == frames - 1) return frames - 1;
  return -1;
}

/// A frame that is held at nothing by a weight w has the width of (1 + w)^(-1/6) of the curve's.
Wanted wantedOf(const std::vector<Eigen::Vector3d>& toe, const std::vector<FootPlant>& plants,
                double frame_time, const LockOptions& options) {
  const int frames = static_cast<int>(toe.size());
  Wanted wanted{Eigen::MatrixXd::Zero(frames, 2), std::vector<double>(toe.size(), 0.0),
                *std::max_element(options.widths.begin(), options.widths.end())};
  for (int i = 0; i < frames; ++i) {
    wanted.weights[i] = std::pow(wanted.width / options.widths[i], 6) - 1.0;
  }
  for (const FootPlant& plant : plants) {
    const int print = printFrame(plant, frames, options);
    const double share = print < 0 ? 1.0 : print == 0 ? 0.0 : kStandingLoose;
    const auto [first, last] =
        heldFrames(plant, frames, share == 0.0 ? 0.0 : share * options.longest_loose / frame_time);
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    for (int i = first; i <= last; ++i) at += toe[i].head<2>();
    at /= last - first + 1;
    if (print >= 0) at = toe[print].head<2>();
    for (int i = first; i <= last; ++i) {
      wanted.weights[i] = kHeld;
      wanted.shift.row(i) = (at - toe[i].head<2>()).transpose();
    }
    const auto goOn = [&](int i, int held) {
      wanted.weights[i] = kGoesOn;
      wanted.shift.row(i) = wanted.shift.row(held);
    };
    for (int i = 0; i < first && plant.first == 0; ++i) goOn(i, first);
    for (int i = last + 1; i < frames && plant.last == frames - 1; ++i) goOn(i, last);
  }
  return wanted;
}

/// Between the feet, nearer to the one that stands: along the ground half of the way, for the least
/// curve weighs no more what is wanted than nothing; up and down all of it, that legs stay as bent.
Eigen::MatrixXd pelvisShift(const std::array<Eigen::MatrixXd, 2>& shifts, const FootPlants& plants,
                            double frame_time) {
  const std::array<std::vector<bool>, 2> planted = {plants.planted(kLeft), plants.planted(kRight)};
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(shifts[kLeft].rows(), 3);
  for (Eigen::Index i = 0; i < wanted.rows(); ++i) {
    const double left = planted[kLeft][i] ? 1.0 : kSwinging;
    const double right = planted[kRight][i] ? 1.0 : kSwinging;
    wanted.row(i) = (left * shifts[kLeft].row(i) + right * shifts[kRight].row(i)) / (left + right);
  }
  Eigen::MatrixXd pelvis(wanted.rows(), 3);
  pelvis.leftCols(2) = leastCurve(wanted.leftCols(2), std::vector<double>(wanted.rows(), 1.0),
                                  frame_time, kPelvisWidth);
  pelvis.col(2) = leastCurve(wanted.col(2), std::vector<double>(wanted.rows(), kUpright),
                             frame_time, kPelvisWidth * std::pow(kUpright, 1.0 / 6.0));
  return pelvis;
}

}  // namespace

void shiftFeet(const std::array<Eigen::MatrixXd, 2>& shifts, const FootPlants& plants,
               double frame_time, WalkTracks& tracks) {
  for (const Side side : {kLeft, kRight}) {
    for (int i = 0; i < plants.frames; ++i) {
      tracks.feet[side].move(i, shifts[side].row(i).transpose());
    }
  }
  const Eigen::MatrixXd pelvis = pelvisShift(shifts, plants, frame_time);
  for (Eigen::Index i = 0; i < pelvis.rows(); ++i) {
    tracks.root[i] += pelvis.row(i).transpose();
  }
}

double lockTracks(const FootPlants& plants, double frame_time, const LockOptions& options,
                  WalkTracks& tracks) {
  assert(static_cast<int>(options.widths.size()) == plants.frames);
  std::array<Eigen::MatrixXd, 2> shifts;
  double farthest = 0.0;
  for (const Side side : {kLeft, kRight}) {
    const Wanted wanted = wantedOf(tracks.feet[side].toe, plants.plants[side], frame_time, options);
    shifts[side] = Eigen::MatrixXd::Zero(plants.frames, 3);
    shifts[side].leftCols(2) = leastCurve(wanted.shift, wanted.weights, frame_time, wanted.width);
    farthest = std::max(farthest, shifts[side].rowwise().norm().maxCoeff());
  }
  shiftFeet(shifts, plants, frame_time, tracks);
  return farthest;
}

double lockTracks(const FootPlants& plants, double frame_time, WalkTracks& tracks) {
  LockOptions options;
  options.widths.assign(plants.frames, kFootLockWidth);
  return lockTracks(plants, frame_time, options, tracks);
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
