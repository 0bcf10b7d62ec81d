#include "animation/preparation/cycle_path.h"

#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

// Column of channels at a phase of the stretch; see WalkCycle::series.
Eigen::VectorXd channelsAt(const GaitTrack& track, const Stretch& s, const FittedPath& path,
                           const std::vector<Eigen::Quaterniond>& reference, double u) {
  Pose pose;
  pose.rotations.resize(reference.size());
  track.poseAt(frameAt(s, u), pose);
  Eigen::VectorXd c(3 + 3 * static_cast<Eigen::Index>(reference.size()));
  c.head<3>() << path.seen(pose.p_WR.head<2>(), u), pose.p_WR.z();
  pose.rotations[0] = aboutZ(-path.headingAt(u)) * pose.rotations[0];
  for (size_t j = 0; j < reference.size(); ++j) {
    c.segment<3>(3 + 3 * static_cast<Eigen::Index>(j)) =
        logRotation(reference[j].conjugate() * pose.rotations[j]);
  }
  return c;
}

}  // namespace

Eigen::Vector2d FittedPath::at(double u) const {
  const double half = 0.5 * turn * u;
  const double chord = std::abs(half) < 1e-9 ? length * u : length * u * std::sin(half) / half;
  return start + chord * Eigen::Vector2d(std::cos(heading + half), std::sin(heading + half));
}

Eigen::Vector2d FittedPath::seen(const Eigen::Vector2d& p, double u) const {
  const Eigen::Vector2d d = p - at(u);
  const double c = std::cos(headingAt(u)), s = std::sin(headingAt(u));
  return {c * d.x() + s * d.y(), -s * d.x() + c * d.y()};
}

FittedPath fitPath(const GaitTrack& track, const Stretch& s, bool turning, int count) {
  const Eigen::Vector2d from = track.jointsAt(s.begin)[0].p_WJ.head<2>();
  const Eigen::Vector2d to = track.jointsAt(s.end)[0].p_WJ.head<2>();
  FittedPath path;
  path.turn = turning ? s.turn : 0.0;
  const double half = 0.5 * path.turn;
  path.length = (to - from).norm() * (std::abs(half) < 1e-9 ? 1.0 : half / std::sin(half));
  path.heading = std::atan2(to.y() - from.y(), to.x() - from.x()) - half;
  path.start = from;
  double across = 0.0;
  for (int i = 0; i < count; ++i) {
    const double u = static_cast<double>(i) / count;
    across += path.seen(track.jointsAt(frameAt(s, u))[0].p_WJ.head<2>(), u).y() / count;
  }
  path.start += across * Eigen::Vector2d(-std::sin(path.heading), std::cos(path.heading));
  return path;
}

Eigen::MatrixXd closedSamples(const GaitTrack& track, const Stretch& s, const FittedPath& path,
                              const std::vector<Eigen::Quaterniond>& reference, int count) {
  const Eigen::VectorXd first = channelsAt(track, s, path, reference, 0.0);
  const Eigen::VectorXd gap = channelsAt(track, s, path, reference, 1.0) - first;
  Eigen::MatrixXd samples(first.size(), count);
  for (int i = 0; i < count; ++i) {
    const double u = static_cast<double>(i) / count;
    samples.col(i) = channelsAt(track, s, path, reference, u) - (u - 0.5) * gap;
  }
  return samples;
}

}  // namespace amble
