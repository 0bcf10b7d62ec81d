#include "animation/preparation/cycle_samples.h"

#include <cmath>

#include "animation/preparation/cycle_path.h"
#include "base/rotation.h"

namespace amble {
namespace {

const FootChange* changeAt(const std::vector<FootChange>& changes, double middle) {
  for (const FootChange& change : changes) {
    if (std::abs(change.middle() - middle) < 0.5) return &change;
  }
  return nullptr;
}

// Where the feet are put around the stretch's begin.
void measurePrints(const GaitTrack& track, const Stretch& s, const FootChange& change,
                   const FittedPath& line, CycleSamples& samples) {
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
  const FittedPath line = fitPath(track, s, false, count);
  CycleSamples samples;
  samples.period = (s.end - s.begin) * track.clip().frame_time;
  samples.speed = line.length / samples.period;
  const int late = s.leading == kLeft ? 0 : count / 2;
  const Eigen::MatrixXd closed = closedSamples(track, s, line, reference, count);
  samples.channels.resize(closed.rows(), count);
  for (int i = 0; i < count; ++i) samples.channels.col((i + late) % count) = closed.col(i);
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
