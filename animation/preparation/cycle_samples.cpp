#include "animation/preparation/cycle_samples.h"

#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

// The line that a cycle walks along: its ends are a whole cycle's ends, and across it the root's
// errors have no mean.
struct Line {
  Eigen::Vector2d start;
  double heading, length;

  Eigen::Vector2d along() const { return {std::cos(heading), std::sin(heading)}; }
  Eigen::Vector2d across() const { return {-std::sin(heading), std::cos(heading)}; }
  // Forward of the point that goes evenly along the line, and left of it.
  Eigen::Vector2d seen(const Eigen::Vector2d& p, double u) const {
    const Eigen::Vector2d d = p - start - length * u * along();
    return {along().dot(d), across().dot(d)};
  }
};

Line fitLine(const GaitTrack& track, const Stretch& s, int count) {
  const Eigen::Vector2d from = track.jointsAt(s.begin)[0].p_WJ.head<2>();
  const Eigen::Vector2d to = track.jointsAt(s.end)[0].p_WJ.head<2>();
  Line line{from, std::atan2(to.y() - from.y(), to.x() - from.x()), (to - from).norm()};
  double aside = 0.0;
  for (int i = 0; i < count; ++i) {
    const double u = static_cast<double>(i) / count;
    aside += line.seen(track.jointsAt(frameAt(s, u))[0].p_WJ.head<2>(), u).y() / count;
  }
  line.start += aside * line.across();
  return line;
}

Eigen::VectorXd channelsAt(const GaitTrack& track, const Stretch& s, const Line& line,
                           const std::vector<Eigen::Quaterniond>& reference, double u) {
  Pose pose;
  pose.rotations.resize(reference.size());
  track.poseAt(frameAt(s, u), pose);
  Eigen::VectorXd c(3 + 3 * static_cast<Eigen::Index>(reference.size()));
  c.head<3>() << line.seen(pose.p_WR.head<2>(), u), pose.p_WR.z();
  pose.rotations[0] = aboutZ(-line.heading) * pose.rotations[0];
  for (size_t j = 0; j < reference.size(); ++j) {
    c.segment<3>(3 + 3 * static_cast<Eigen::Index>(j)) =
        logRotation(reference[j].conjugate() * pose.rotations[j]);
  }
  return c;
}

const FootChange* changeAt(const std::vector<FootChange>& changes, double middle) {
  for (const FootChange& change : changes) {
    if (std::abs(change.middle() - middle) < 0.5) return &change;
  }
  return nullptr;
}

// Where the feet are put around the stretch's begin.
void measurePrints(const GaitTrack& track, const Stretch& s, const FootChange& change,
                   const Line& line, CycleSamples& samples) {
  std::array<Eigen::Vector2d, 2> prints = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double height = 0.0;
  for (const Side side : {kLeft, kRight}) {
    for (const Plant& plant : track.plants(side)) {
      const bool is_it =
          side == s.leading ? plant.strike == change.strike : plant.lift_off == change.lift_off;
      if (!is_it) continue;
      const GaitTrack::FlatFoot flat = track.flatFoot(side, plant);
      prints[side] = line.seen(flat.print.head<2>(), 0.0);
      samples.toe_out[side] = wrapAngle(flat.heading - line.heading);
      height += 0.5 * flat.print.z();
    }
  }
  samples.step_width = prints[kLeft].y() - prints[kRight].y();
  for (const Side side : {kLeft, kRight}) {
    const double half_step = (side == s.leading ? 0.25 : -0.25) * line.length;
    samples.foot_forward[side] = prints[side].x() - half_step;
  }
  samples.channels.row(2).array() -= height;
}

}  // namespace

CycleSamples sampleCycle(const GaitTrack& track, const Stretch& s, Gait gait,
                         const std::vector<Eigen::Quaterniond>& reference, int count) {
  const Line line = fitLine(track, s, count);
  CycleSamples samples;
  samples.period = (s.end - s.begin) * track.clip().frame_time;
  samples.speed = line.length / samples.period;
  const int late = s.leading == kLeft ? 0 : count / 2;
  const Eigen::VectorXd first = channelsAt(track, s, line, reference, 0.0);
  const Eigen::VectorXd gap = channelsAt(track, s, line, reference, 1.0) - first;
  samples.channels.resize(first.size(), count);
  for (int i = 0; i < count; ++i) {
    const double u = static_cast<double>(i) / count;
    samples.channels.col((i + late) % count) =
        channelsAt(track, s, line, reference, u) - (u - 0.5) * gap;
  }
  const std::vector<FootChange> own = footChanges(track, s.leading, gait);
  const std::vector<FootChange> others = footChanges(track, other(s.leading), gait);
  const FootChange *begin = changeAt(own, s.begin), *middle = changeAt(others, s.middle);
  const double share = 1.0 / (s.end - s.begin);
  samples.support[s.leading] = share * (begin->lift_off - begin->strike);
  samples.support[other(s.leading)] = share * (middle->lift_off - middle->strike);
  measurePrints(track, s, *begin, line, samples);
  return samples;
}

}  // namespace amble
