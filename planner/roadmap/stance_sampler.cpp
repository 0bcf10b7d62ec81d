#include "planner/roadmap/stance_sampler.h"

#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

// A try costs one check of one pose, an edge some hundreds of them: many tries are cheap beside one
// edge.
constexpr int kUniformTries = 200;
// Each with the body moved so far to its right, its widest side, since stepping round and swinging
// arms take more room than standing. By trial: with less there are places along walls that next to
// no edge leads to, and they end no search. [m]
constexpr double kSpare = 0.06;
constexpr int kAllRound = 8;  // headings by which a body that may turn there must be able to stand
constexpr int kBridgeTries = 60;
// Between the ends of a bridge [m]: less than a body's width is never free between, more is not
// narrow.
constexpr double kShortestBridge = 0.5;
constexpr double kLongestBridge = 1.8;
// The height of a place on a floor that is not there [m].
constexpr double kNowhere = -1e9;

}  // namespace

std::optional<StanceSampler::Sample> StanceSampler::draw(std::uint64_t seed, std::uint64_t index,
                                                         SteeringScratch& scratch) const {
  SampleStream stream(seed, index);
  if (!isUniform(index)) {
    if (const auto found = bridge(stream, scratch)) return found;
  }
  return uniform(stream, scratch);
}

Stance StanceSampler::anywhere(SampleStream& stream) const {
  Stance stance;
  stance.position.x() = stream.uniform(bounds_.min().x(), bounds_.max().x());
  stance.position.y() = stream.uniform(bounds_.min().y(), bounds_.max().y());
  stance.heading = stream.uniform(-kPi, kPi);
  if (steering_.layers() > 0) choose(stance, stream);
  return stance;
}

// One floor of those over one another; none where there are fewer than the number drawn, so that
// all ground is drawn alike.
void StanceSampler::choose(Stance& stance, SampleStream& stream) const {
  const int drawn = stream.below(steering_.layers());
  const std::vector<double> floors = steering_.floors(stance.position.x(), stance.position.y());
  const bool is_there = drawn < static_cast<int>(floors.size());
  stance.position.z() = is_there ? floors[drawn] : kNowhere;
}

std::optional<StanceSampler::Sample> StanceSampler::uniform(SampleStream& stream,
                                                            SteeringScratch& scratch) const {
  for (int i = 0; i < kUniformTries; ++i) {
    Stance stance = anywhere(stream);
    if (standsAllRound(stance, scratch)) return Sample{stance, true};
  }
  return std::nullopt;
}

bool StanceSampler::standsAllRound(Stance& stance, SteeringScratch& scratch) const {
  for (int i = 0; i < kAllRound; ++i) {
    const double aside = stance.heading + 2.0 * kPi * i / kAllRound;
    Stance turned = stance;
    turned.position += kSpare * Eigen::Vector3d(std::cos(aside), std::sin(aside), 0.0);
    turned.heading = aside + kPi / 2;
    if (steering_.stand(turned, scratch)) return false;
  }
  return !steering_.stand(stance, scratch);
}

std::optional<StanceSampler::Sample> StanceSampler::bridge(SampleStream& stream,
                                                           SteeringScratch& scratch) const {
  for (int i = 0; i < kBridgeTries; ++i) {
    // All three by one heading: along a plane wall the middle of two blocked places is then blocked
    // too.
    Stance near_end = anywhere(stream);
    const double direction = stream.uniform(-kPi, kPi);
    const double length = stream.uniform(kShortestBridge, kLongestBridge);
    near_end.heading = wrapAngle(direction + (stream.uniform() < 0.5 ? kPi / 2 : -kPi / 2));
    const Eigen::Vector3d half =
        0.5 * length * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0.0);
    Stance far_end = near_end, middle = near_end;
    far_end.position += 2 * half;
    middle.position += half;
    if (!bounds_.contains(middle.position.head<2>()) || near_end.position.z() == kNowhere) continue;
    if (!steering_.stand(near_end, scratch) || !steering_.stand(far_end, scratch)) continue;
    if (!steering_.stand(middle, scratch)) return Sample{middle, standsAllRound(middle, scratch)};
  }
  return std::nullopt;
}

}  // namespace amble
