#include "animation/analysis/motion_measures.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "animation/analysis/low_pass.h"
#include "animation/body/pelvis.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Samples at 30 Hz left out at both ends: the first and last frames of captures often jump, and a
// filter knows one side only there. Either would be the largest acceleration of most clips.
constexpr Eigen::Index kEndSamples = 1;

// Clips of no more than about 30 Hz are not sampled down, so that nothing can be folded over: they
// are taken as they are [Hz].
constexpr double kUnfilteredRate = 1.1 * kMeasureRate;

constexpr double kQuietJoint = 1.0;  // pops: a joint's percentile is not taken below this [rad/s²]
constexpr double kBackwards = 8.0 * kDegree;  // knee: QUALITY.md
constexpr double kPathWindow = 0.25;          // path error: smoothing of the root, QUALITY.md [s]
// Path error: how far along the path the nearest point may be [s]
constexpr double kPathReach = 0.5;

// Rows between rows, linearly: sampled at `rate`, from rows at `own_rate`.
Eigen::MatrixXd resampled(const Eigen::MatrixXd& rows, double own_rate, double rate) {
  const Eigen::Index last = rows.rows() - 1;
  const double step = own_rate / rate;
  // A billionth of a frame makes up for a frame time of seven digits.
  const auto count =
      static_cast<Eigen::Index>(std::floor((static_cast<double>(last) + 1e-3) / step)) + 1;
  Eigen::MatrixXd result(count, rows.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    const double at = std::min(static_cast<double>(i) * step, static_cast<double>(last));
    const Eigen::Index before =
        std::min(static_cast<Eigen::Index>(at), std::max<Eigen::Index>(0, last - 1));
    const Eigen::Index after = std::min(before + 1, last);
    const double t = at - static_cast<double>(before);
    result.row(i) = (1.0 - t) * rows.row(before) + t * rows.row(after);
  }
  return result;
}

// Rows at 30 Hz, without the ends.
Eigen::MatrixXd measured(Eigen::MatrixXd rows, double frame_time, double cutoff) {
  const double rate = 1.0 / frame_time;
  if (rate > kUnfilteredRate) lowPass(rows, rate, cutoff);
  const Eigen::MatrixXd samples = resampled(rows, rate, kMeasureRate);
  if (samples.rows() <= 2 * kEndSamples) return Eigen::MatrixXd(0, rows.cols());
  return samples.middleRows(kEndSamples, samples.rows() - 2 * kEndSamples);
}

// Distance of `p` from the part of the path between points [first, last].
double distanceToPath(const Eigen::Vector2d& p, std::span<const PlannedPoint> path, int first,
                      int last) {
  double nearest = (p - path[first].position).norm();
  for (int i = first; i < last; ++i) {
    const Eigen::Vector2d a = path[i].position, ab = path[i + 1].position - a;
    const double squared = ab.squaredNorm();
    const double t = squared > 0.0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (a + t * ab - p).norm());
  }
  return nearest;
}

}  // namespace

double rootAcceleration(const Clip& clip) {
  if (clip.frames() == 0) return 0.0;
  Eigen::MatrixXd root(clip.frames(), 3);
  for (int i = 0; i < clip.frames(); ++i) root.row(i) = clip.poses.p_WR(i).transpose();
  root = measured(std::move(root), clip.frame_time, kRootMeasureCutoff);
  double largest = 0.0;
  for (Eigen::Index i = 1; i + 1 < root.rows(); ++i) {
    largest = std::max(largest, (root.row(i - 1) - 2.0 * root.row(i) + root.row(i + 1)).norm());
  }
  return largest * kMeasureRate * kMeasureRate;
}

double jointJerk(const Clip& clip) {
  if (clip.frames() == 0) return 0.0;
  const int joints = clip.skeleton.size();
  std::vector<JointFrame> frames(joints);
  Eigen::MatrixXd places(clip.frames(), 3 * joints);
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, frames);
    for (int j = 0; j < joints; ++j) places.block<1, 3>(i, 3 * j) = frames[j].p_WJ.transpose();
  }
  places = measured(std::move(places), clip.frame_time, kJointMeasureCutoff);
  double sum = 0.0;
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i + 3 < places.rows(); ++i) {
    const Eigen::RowVectorXd third =
        places.row(i + 3) - 3.0 * places.row(i + 2) + 3.0 * places.row(i + 1) - places.row(i);
    for (int j = 0; j < joints; ++j) sum += third.segment<3>(3 * j).norm();
    count += joints;
  }
  return count == 0 ? 0.0 : sum / static_cast<double>(count) * std::pow(kMeasureRate, 3);
}

double pops(const Clip& clip) {
  const int changes = clip.frames() - 2;
  if (changes < 1) return 0.0;
  double worst = 0.0;
  std::vector<double> accelerations(changes);
  for (int j = 0; j < clip.skeleton.size(); ++j) {
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    for (int i = 0; i + 1 < clip.frames(); ++i) {
      const Eigen::Quaterniond& q = clip.poses[i].rotations[j];
      const Eigen::Vector3d turn = logRotation(q.conjugate() * clip.poses[i + 1].rotations[j]);
      if (i > 0)
        accelerations[i - 1] = (turn - before).norm() / (clip.frame_time * clip.frame_time);
      before = turn;
    }
    std::sort(accelerations.begin(), accelerations.end());
    const double usual = accelerations[static_cast<size_t>(0.99 * (changes - 1))];
    worst = std::max(worst, accelerations.back() / std::max(usual, kQuietJoint));
  }
  return worst;
}

double kneeBackwardsShare(const Clip& clip, const JointRoles& roles) {
  if (clip.frames() == 0) return 0.0;
  std::vector<JointFrame> joints(clip.skeleton.size());
  int backwards = 0;
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, joints);
    const Eigen::Vector3d left =
        (joints[roles.legs[kLeft].up_leg].p_WJ - joints[roles.legs[kRight].up_leg].p_WJ)
            .normalized();
    bool bent = false;
    for (const LegJoints& leg : roles.legs) {
      const Eigen::Vector3d thigh = joints[leg.leg].p_WJ - joints[leg.up_leg].p_WJ;
      const Eigen::Vector3d shank = joints[leg.foot].p_WJ - joints[leg.leg].p_WJ;
      bent = bent || std::atan2(thigh.cross(shank).dot(left), thigh.dot(shank)) < -kBackwards;
    }
    backwards += bent ? 1 : 0;
  }
  return static_cast<double>(backwards) / clip.frames();
}

double boneLengthChange(const Clip& clip) {
  const size_t joints = clip.skeleton.size();
  double largest = 0.0;
  std::vector<double> shortest(joints, 1e300), longest(joints, 0.0);
  for (size_t i = 0; i < clip.joint_positions.size(); ++i) {
    const double length = clip.joint_positions[i].norm();
    shortest[i % joints] = std::min(shortest[i % joints], length);
    longest[i % joints] = std::max(longest[i % joints], length);
    largest = std::max(largest, longest[i % joints] - shortest[i % joints]);
  }
  return largest;
}

std::vector<Eigen::Vector3d> smoothed(const std::vector<Eigen::Vector3d>& points, double frame_time,
                                      double window) {
  const int n = static_cast<int>(points.size());
  const int half = static_cast<int>(std::lround(0.5 * window / frame_time));
  std::vector<Eigen::Vector3d> result(points);
  for (int i = 0; i < n; ++i) {
    const int reach = std::min({half, i, n - 1 - i});
    for (int k = 1; k <= reach; ++k) result[i] += points[i - k] + points[i + k];
    result[i] /= 2.0 * reach + 1.0;
  }
  return result;
}

PathError pathError(const Clip& clip, const JointRoles& roles,
                    std::span<const PlannedPoint> planned) {
  const int frames = clip.frames();
  assert(frames > 0 && static_cast<int>(planned.size()) == frames);
  std::vector<Eigen::Vector3d> root;
  for (int i = 0; i < frames; ++i) root.push_back(clip.poses.p_WR(i));
  root = smoothed(root, clip.frame_time, kPathWindow);
  const int reach = static_cast<int>(std::lround(kPathReach / clip.frame_time));
  PathError error;
  for (int i = 0; i < frames; ++i) {
    const double distance = distanceToPath(root[i].head<2>(), planned, std::max(0, i - reach),
                                           std::min(frames - 1, i + reach));
    error.mean += distance / frames;
    error.largest = std::max(error.largest, distance);
  }
  error.end = (root.back().head<2>() - planned.back().position).norm();
  error.end_heading =
      std::abs(wrapAngle(pelvisHeadings(clip, roles).back() - planned.back().heading));
  return error;
}

}  // namespace amble
