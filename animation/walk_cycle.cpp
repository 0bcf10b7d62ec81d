#include "animation/walk_cycle.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "animation/error.h"
#include "animation/foot_cycle_fit.h"
#include "animation/gait_track.h"
#include "animation/rotation.h"

namespace amble {
namespace {

constexpr int kSamples = 64;             // of a cycle, to fit the series to
constexpr double kShortestPeriod = 0.7;  // of two steps of a walk [s]
constexpr double kLongestPeriod = 1.8;   // [s]

// A stretch from one double support to the next but one, in fractions of the clip's frames.
struct Stretch {
  double begin, middle, end;  // middles of the double supports
  Side leading;               // in front at begin
  double closure, turn;       // [m], [rad]
};

// Middles of the double supports in which `leading` has just struck and the other foot is about to
// leave.
std::vector<double> doubleSupports(const GaitTrack& track, Side leading) {
  std::vector<double> middles;
  const Side trailing = leading == kLeft ? kRight : kLeft;
  for (const Plant& front : track.plants(leading)) {
    for (const Plant& rear : track.plants(trailing)) {
      if (rear.strike < front.strike && rear.lift_off > front.strike - 2.0 &&
          rear.lift_off < front.lift_off) {
        middles.push_back(0.5 * (front.strike + rear.lift_off));
        break;
      }
    }
  }
  return middles;
}

// Root mean square distance of the joints at two times, each seen from the root's place and
// heading.
double closureOf(const GaitTrack& track, double a, double b) {
  const auto seen = [&](double frame) {
    const Eigen::Quaterniond back = aboutZ(-track.headingAt(frame));
    std::vector<JointFrame> joints = track.jointsAt(frame);
    const Eigen::Vector3d root = joints[0].p_WJ;
    for (JointFrame& j : joints) {
      j.p_WJ = back * Eigen::Vector3d(j.p_WJ.x() - root.x(), j.p_WJ.y() - root.y(), j.p_WJ.z());
    }
    return joints;
  };
  const auto ja = seen(a), jb = seen(b);
  double squares = 0.0;
  for (size_t i = 0; i < ja.size(); ++i) squares += (ja[i].p_WJ - jb[i].p_WJ).squaredNorm();
  return std::sqrt(squares / static_cast<double>(ja.size()));
}

std::vector<Stretch> stretches(const GaitTrack& track, const CycleOptions& options) {
  const double frame_time = track.clip().frame_time;
  std::vector<Stretch> found;
  for (const Side leading : {kLeft, kRight}) {
    const auto own = doubleSupports(track, leading);
    const auto other = doubleSupports(track, leading == kLeft ? kRight : kLeft);
    for (size_t i = 0; i + 1 < own.size(); ++i) {
      const double period = (own[i + 1] - own[i]) * frame_time;
      const auto middle = std::upper_bound(other.begin(), other.end(), own[i]);
      if (period < kShortestPeriod || period > kLongestPeriod || middle == other.end() ||
          *middle >= own[i + 1]) {
        continue;
      }
      if (options.frames &&
          (own[i] < options.frames->first || own[i + 1] > options.frames->second)) {
        continue;
      }
      found.push_back({own[i], *middle, own[i + 1], leading, closureOf(track, own[i], own[i + 1]),
                       wrapAngle(track.headingAt(own[i + 1]) - track.headingAt(own[i]))});
    }
  }
  return found;
}

Stretch mostCyclic(const GaitTrack& track, const CycleOptions& options) {
  const std::vector<Stretch> found = stretches(track, options);
  if (found.empty()) {
    throw InputError(options.clip, 0, "no whole cycle of a walk was found",
                     "two steps in a row, each foot planted before and after");
  }
  const auto cost = [&](const Stretch& s) {
    return options.turning ? s.closure / std::max(std::abs(s.turn), 1e-3) : s.closure;
  };
  return *std::min_element(found.begin(), found.end(),
                           [&](const Stretch& a, const Stretch& b) { return cost(a) < cost(b); });
}

// The fitted line or circle: the path's point and heading at phase 0, and how they go on.
struct FittedPath {
  Eigen::Vector2d start;
  double heading, length, turn;  // of one cycle

  Eigen::Vector2d at(double u) const {  // u in cycles
    const double half = 0.5 * turn * u;
    const double chord = std::abs(half) < 1e-9 ? length * u : length * u * std::sin(half) / half;
    return start + chord * Eigen::Vector2d(std::cos(heading + half), std::sin(heading + half));
  }
};

// Time of phase [cycles] after `begin`, such that the middle double support comes at 0.5 and the
// ends keep their rate.
double frameAt(const Stretch& s, double phase) {
  const double period = s.end - s.begin;
  const double late = (s.middle - s.begin) / period - 0.5;
  const double bump = std::sin(kPi * phase);
  return s.begin + period * (phase + late * bump * bump);
}

FittedPath fitPath(const GaitTrack& track, const Stretch& s, bool turning) {
  const Eigen::Vector2d from = track.jointsAt(s.begin)[0].p_WJ.head<2>();
  const Eigen::Vector2d to = track.jointsAt(s.end)[0].p_WJ.head<2>();
  FittedPath path;
  path.turn = turning ? s.turn : 0.0;
  const double half = 0.5 * path.turn;
  path.length = (to - from).norm() * (std::abs(half) < 1e-9 ? 1.0 : half / std::sin(half));
  path.heading = std::atan2(to.y() - from.y(), to.x() - from.x()) - half;
  path.start = from;
  // Across the path, the root's errors have no mean.
  double across = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double u = static_cast<double>(i) / kSamples;
    const double heading = path.heading + path.turn * u;
    const Eigen::Vector2d d = track.jointsAt(frameAt(s, u))[0].p_WJ.head<2>() - path.at(u);
    across += (-std::sin(heading) * d.x() + std::cos(heading) * d.y()) / kSamples;
  }
  path.start += across * Eigen::Vector2d(-std::sin(path.heading), std::cos(path.heading));
  return path;
}

// Column of channels at a phase of the stretch; see WalkCycle::series.
Eigen::VectorXd channelsAt(const GaitTrack& track, const Stretch& s, const FittedPath& path,
                           const std::vector<Eigen::Quaterniond>& reference, double u) {
  Pose pose;
  pose.rotations.resize(reference.size());
  track.poseAt(frameAt(s, u), pose);
  const double heading = path.heading + path.turn * u;
  const Eigen::Vector2d d = pose.p_WR.head<2>() - path.at(u);
  Eigen::VectorXd c(3 + 3 * static_cast<Eigen::Index>(reference.size()));
  c[0] = std::cos(heading) * d.x() + std::sin(heading) * d.y();
  c[1] = -std::sin(heading) * d.x() + std::cos(heading) * d.y();
  c[2] = pose.p_WR.z();
  pose.rotations[0] = aboutZ(-heading) * pose.rotations[0];
  for (size_t j = 0; j < reference.size(); ++j) {
    c.segment<3>(3 + 3 * static_cast<Eigen::Index>(j)) =
        logRotation(reference[j].conjugate() * pose.rotations[j]);
  }
  return c;
}

// Rows: channels; columns: kSamples even phases. What the ends differ by is spread over the cycle.
Eigen::MatrixXd closedSamples(const GaitTrack& track, const Stretch& s, const FittedPath& path,
                              const std::vector<Eigen::Quaterniond>& reference) {
  const Eigen::VectorXd first = channelsAt(track, s, path, reference, 0.0);
  const Eigen::VectorXd gap = channelsAt(track, s, path, reference, 1.0) - first;
  Eigen::MatrixXd samples(first.size(), kSamples);
  for (int i = 0; i < kSamples; ++i) {
    const double u = static_cast<double>(i) / kSamples;
    samples.col(i) = channelsAt(track, s, path, reference, u) - (u - 0.5) * gap;
  }
  return samples;
}

// Root mean square of what the series leaves out of the joints' channels.
double residualOf(const FourierSeries& series, const Eigen::MatrixXd& samples,
                  const std::vector<double>& phases) {
  double squares = 0.0;
  std::vector<double> basis(2 * static_cast<size_t>(series.harmonics()) + 2);
  for (Eigen::Index i = 0; i < samples.cols(); ++i) {
    fourierBasis(phases[i], series.harmonics(), basis.data());
    Eigen::VectorXd value = Eigen::VectorXd::Zero(series.channels());
    for (int k = 0; k <= series.harmonics(); ++k) {
      value += basis[2 * k] * series.alpha.col(k) + basis[2 * k + 1] * series.beta.col(k);
    }
    squares += (samples.col(i) - value).tail(series.channels() - 3).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(samples.cols() * (series.channels() - 3)));
}

FourierSeries fitSeries(const Eigen::MatrixXd& samples, Side leading, int harmonics,
                        double& residual) {
  std::vector<double> phases;
  for (int i = 0; i < kSamples; ++i) {
    phases.push_back(static_cast<double>(i) / kSamples + (leading == kLeft ? 0.0 : 0.5));
  }
  FourierSeries series = fitFourier(samples, phases, harmonics);
  residual = residualOf(series, samples, phases);
  return series;
}

}  // namespace

WalkCycle prepareWalkCycle(const Clip& level, const JointRoles& roles,
                           const std::array<FootShape, 2>& feet,
                           const std::vector<Eigen::Quaterniond>& reference,
                           const CycleOptions& options, std::pair<int, int>* used_frames) {
  const GaitTrack track(level, roles, feet);
  const Stretch s = mostCyclic(track, options);
  const FittedPath path = fitPath(track, s, options.turning);
  WalkCycle cycle;
  cycle.period = (s.end - s.begin) * level.frame_time;
  cycle.speed = path.length / cycle.period;
  cycle.turn_rate = path.turn / cycle.period;
  cycle.closure = s.closure;
  cycle.series = fitSeries(closedSamples(track, s, path, reference), s.leading, options.harmonics,
                           cycle.residual);
  for (const Side side : {kLeft, kRight}) {
    cycle.feet[side] = fitFootCycle(track, side, feet[side], s.begin, s.end, options.clip);
    if (s.leading == kRight) {
      cycle.feet[side].strike = std::fmod(cycle.feet[side].strike + 0.5, 1.0);
      cycle.feet[side].lift_off = std::fmod(cycle.feet[side].lift_off + 0.5, 1.0);
    }
  }
  const FootPlacing placing = measurePlacing(track, s.begin, path.start, path.heading, s.leading);
  cycle.step_width = placing.width;
  cycle.foot_forward = placing.forward;
  cycle.toe_out = placing.toe_out;
  cycle.slide = placing.slide;
  if (used_frames != nullptr) {
    *used_frames = {static_cast<int>(std::lround(s.begin)), static_cast<int>(std::lround(s.end))};
  }
  return cycle;
}

Posture preparePosture(const Clip& level, const JointRoles& roles,
                       const std::array<FootShape, 2>& feet, int first, int last) {
  const GaitTrack track(level, roles, feet);
  const int joints = level.skeleton.size();
  Posture posture;
  posture.rotations.assign(joints, Eigen::Quaterniond::Identity());
  const int count = last - first + 1;
  std::vector<Eigen::Vector4d> sum(joints, Eigen::Vector4d::Zero());
  for (int i = first; i <= last; ++i) {
    const double heading = track.headingAt(i);
    Pose pose;
    pose.rotations.resize(joints);
    track.poseAt(i, pose);
    pose.rotations[0] = aboutZ(-heading) * pose.rotations[0];
    for (int j = 0; j < joints;
         ++j) {  // quaternions that lie near each other: their mean is their sum
      const Eigen::Vector4d q = pose.rotations[j].coeffs();
      sum[j] += q.dot(sum[j]) < 0.0 ? Eigen::Vector4d(-q) : q;
    }
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(), across = Eigen::Vector3d::Zero();
    for (const Side side : {kLeft, kRight}) {
      const Plant here{static_cast<double>(i), static_cast<double>(i)};
      const GaitTrack::FlatFoot flat = track.flatFoot(side, here);
      middle += 0.5 * flat.print;
      across += side == kLeft ? flat.print : Eigen::Vector3d(-flat.print);
      posture.toe_out[side] += wrapAngle(flat.heading - heading) / count;
    }
    posture.root_height += (pose.p_WR.z() - middle.z()) / count;
    const Eigen::Vector3d back = aboutZ(-heading) * (pose.p_WR - middle);
    posture.root_forward += back.x() / count;
    posture.step_width += (aboutZ(-heading) * across).y() / count;
  }
  for (int j = 0; j < joints; ++j) posture.rotations[j].coeffs() = sum[j].normalized();
  return posture;
}

}  // namespace amble
