#include "animation/grafting/plant_correlation.h"

#include <algorithm>
#include <cmath>

#include "animation/analysis/gait_phase.h"
#include "animation/body/pelvis.h"
#include "base/rotation.h"

namespace amble {
namespace {

// A moment at which feet change, and which of two kinds it is: left or right comes down; in jumps,
// the feet leave or land.
struct PlantMoment {
  double frame = 0.0;
  bool first_kind = true;
};

std::vector<PlantMoment> stepMoments(const FootPlants& plants, int offset) {
  std::vector<PlantMoment> moments;
  for (const PhaseMoment& moment : gaitPhase(plants)) {
    moments.push_back({moment.frame + offset, moment.phase == std::floor(moment.phase)});
  }
  return moments;
}

// Take-offs are of the first kind. What begins or ends with the window is nobody's flight.
std::vector<PlantMoment> jumpMoments(const FootPlants& plants, int offset) {
  const std::vector<Support> tokens = supportTokens(plants);
  std::vector<PlantMoment> moments;
  for (size_t i = 1; i < tokens.size(); ++i) {
    const bool flies = tokens[i] == Support::kNone, flew = tokens[i - 1] == Support::kNone;
    if (flies == flew || (flew && moments.empty())) continue;
    moments.push_back({static_cast<double>(i) - 0.5 + offset, flies});
  }
  return moments;
}

std::vector<PlantMoment> momentsOf(const LocomotiveClip& clip, const MotionStretch& window) {
  const FootPlants plants = plantsWithin(clip.plants, window.first, window.last);
  return window.type == MotionType::kJump ? jumpMoments(plants, window.first)
                                          : stepMoments(plants, window.first);
}

using Ankles = std::array<Eigen::Vector3d, 2>;

// Seen from the middle of the hips and the pelvis' heading, in leg lengths.
std::vector<Ankles> anklesOf(const LocomotiveClip& clip) {
  const JointRoles& roles = clip.roles;
  const double leg = roles.meanLeg(clip.clip.skeleton);
  std::vector<JointFrame> frames(clip.clip.skeleton.size());
  std::vector<Ankles> ankles(clip.clip.frames());
  for (int i = 0; i < clip.clip.frames(); ++i) {
    forwardKinematics(clip.clip, i, frames);
    const Eigen::Quaterniond back = aboutZ(-pelvisHeading(frames, roles));
    const Eigen::Vector3d middle =
        0.5 * (frames[roles.legs[kLeft].up_leg].p_WJ + frames[roles.legs[kRight].up_leg].p_WJ);
    for (const Side side : {kLeft, kRight}) {
      ankles[i][side] = back * (frames[roles.legs[side].foot].p_WJ - middle) / leg;
    }
  }
  return ankles;
}

double mismatchOf(const Correlation& correlation, const std::vector<Ankles>& base,
                  const std::vector<Ankles>& upper) {
  const TimeWarp warp(correlation);
  double sum = 0.0;
  for (int i = correlation.first; i <= correlation.last; ++i) {
    const Ankles& there = upper[static_cast<size_t>(std::lround(warp.at(i)))];
    for (const Side side : {kLeft, kRight}) sum += (base[i][side] - there[side]).squaredNorm();
  }
  return correlation.frames() < 1 ? 0.0 : std::sqrt(sum / (2.0 * correlation.frames()));
}

// The frames of base between the first and the last moment.
void setFrames(Correlation& correlation) {
  correlation.first = static_cast<int>(std::ceil(correlation.moments.front().base));
  correlation.last = static_cast<int>(std::floor(correlation.moments.back().base));
}

// Time goes on alike in both from the windows' beginnings.
Correlation byTimeAlone(const LocomotiveClip& base, const LocomotiveClip& upper,
                        const CorrelationWindows& windows) {
  const double ratio = base.clip.frame_time / upper.clip.frame_time;
  const double frames = std::min<double>(windows.base.last - windows.base.first,
                                         (windows.upper.last - windows.upper.first) / ratio);
  Correlation correlation;
  correlation.moments = {
      {static_cast<double>(windows.base.first), static_cast<double>(windows.upper.first)},
      {windows.base.first + frames, windows.upper.first + frames * ratio}};
  setFrames(correlation);
  return correlation;
}

void rank(std::vector<Correlation>& alternatives) {
  double least = alternatives.front().mismatch;
  for (const Correlation& each : alternatives) least = std::min(least, each.mismatch);
  const auto agrees = [&](const Correlation& c) { return c.mismatch <= kAgreeing * least; };
  std::stable_sort(alternatives.begin(), alternatives.end(),
                   [&](const Correlation& a, const Correlation& b) {
                     if (agrees(a) != agrees(b)) return agrees(a);
                     if (agrees(a) && a.frames() != b.frames()) return a.frames() > b.frames();
                     return a.mismatch < b.mismatch;
                   });
}

}  // namespace

TimeWarp::TimeWarp(const Correlation& correlation) {
  std::vector<double> base, upper;
  for (const MatchedMoment& moment : correlation.moments) {
    base.push_back(moment.base);
    upper.push_back(moment.upper);
  }
  const auto slope = [&](size_t i) { return (upper[i + 1] - upper[i]) / (base[i + 1] - base[i]); };
  const double first = slope(0), last = slope(base.size() - 2);
  curve_ = CubicSpline(std::move(base), std::move(upper), first, last);
  curve_.keepRising();
}

std::vector<Correlation> correlate(const LocomotiveClip& base, const LocomotiveClip& upper,
                                   const CorrelationWindows& windows) {
  if (windows.upper.type == MotionType::kStand) {
    if (windows.base.frames() < 2 || windows.upper.frames() < 2) return {};
    return {byTimeAlone(base, upper, windows)};
  }
  const std::vector<PlantMoment> below = momentsOf(base, windows.base);
  const std::vector<PlantMoment> above = momentsOf(upper, windows.upper);
  const int n = static_cast<int>(below.size()), m = static_cast<int>(above.size());
  const std::vector<Ankles> base_ankles = anklesOf(base), upper_ankles = anklesOf(upper);
  std::vector<Correlation> alternatives;
  for (int shift = 2 - n; shift <= m - 2; ++shift) {
    Correlation correlation;
    correlation.shift = shift;
    for (int i = std::max(0, -shift); i < std::min(n, m - shift); ++i) {
      correlation.moments.push_back({below[i].frame, above[i + shift].frame});
      correlation.same_foot = below[i].first_kind == above[i + shift].first_kind;
    }
    if (correlation.moments.size() < 2) continue;
    if (windows.base.type == MotionType::kJump && !correlation.same_foot) continue;
    setFrames(correlation);
    correlation.mismatch = mismatchOf(correlation, base_ankles, upper_ankles);
    alternatives.push_back(std::move(correlation));
  }
  if (!alternatives.empty()) rank(alternatives);
  return alternatives;
}

}  // namespace amble
