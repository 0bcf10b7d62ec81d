#include "animation/preparation/engine_clip.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/rotation.h"
#include "base/text.h"

namespace amble {
namespace {

// Enough that there are whole cycles with either foot in front, and swings before and after them.
constexpr int kRuns = 4;
constexpr int kLastFrame = kRuns * kEnginePhases;

std::string eachOnce(const GaitSpace& walks, std::string MotionSource::*text) {
  std::vector<std::string> all;
  for (const EngineClip& clip : walks.clips) {
    const std::string& one = clip.source.*text;
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
  }
  std::string together;
  for (const std::string& one : all) together += (together.empty() ? "" : "; ") + one;
  return together;
}

// Of the plants that a foot has from run to run those within the clip; cut off where it ends.
std::vector<FootPlant> plantsOfFoot(double strike, double lift_off) {
  std::vector<FootPlant> plants;
  for (int run = -1; run <= kRuns; ++run) {
    FootPlant plant;
    plant.strike = strike + run * kEnginePhases;
    plant.lift_off = lift_off + run * kEnginePhases;
    plant.first = std::max(0, static_cast<int>(std::ceil(plant.strike)));
    plant.last = std::min(kLastFrame, static_cast<int>(std::floor(plant.lift_off)));
    if (plant.first <= plant.last) plants.push_back(plant);
  }
  return plants;
}

void requireWalk(const SpeedEngine& engine, double speed, const std::string& file) {
  if (!engine.data().walk) {
    throw InputError(file, 0, "holds runs and no walk", "an engine that walks: plans do not run");
  }
  const double fastest = engine.fastestWalk();
  if (speed >= kSlowestOfEngine && speed <= fastest) return;
  const std::string problem = speed < kSlowestOfEngine   ? " is slower than plans walk"
                              : speed > engine.fastest() ? " is beyond what was captured"
                                                         : " is no walk but, in part, a run";
  throw InputError(file, 0, shortNumber(speed) + " m/s" + problem,
                   shortNumber(kSlowestOfEngine) + " to " +
                       shortNumber(std::floor(100.0 * fastest) / 100.0) + " m/s");
}

const EngineClip& nearestClip(const GaitSpace& walks, double speed) {
  return *std::min_element(walks.clips.begin(), walks.clips.end(),
                           [&](const EngineClip& a, const EngineClip& b) {
                             return std::abs(a.speed - speed) < std::abs(b.speed - speed);
                           });
}

Clip clipOf(const SpeedEngine& engine, double speed) {
  Eigen::MatrixXd cycle;
  engine.cycleAt(speed, cycle);
  const double frame_time = 1.0 / (engine.frequency(speed) * kEnginePhases);
  Clip clip{"walk", engine.data().skeleton, frame_time, PoseArray(engine.joints()), {}};
  Pose pose;
  pose.rotations.resize(engine.joints());
  for (int i = 0; i <= kLastFrame; ++i) {
    const Eigen::VectorXd channels = cycle.col(i % kEnginePhases);
    pose.p_WR = channels.head<3>();
    pose.p_WR.x() += speed * i * frame_time;
    for (int j = 0; j < engine.joints(); ++j) {
      pose.rotations[j] =
          engine.data().mean_posture[j] * expRotation(channels.segment<3>(3 + 3 * j));
    }
    clip.poses.append(pose);
  }
  return clip;
}

}  // namespace

WalkOfEngine walkOfEngine(const SpeedEngine& engine, double speed, const std::string& file) {
  requireWalk(engine, speed, file);
  const EngineData& data = engine.data();
  WalkOfEngine walk;
  walk.capture.motion.clip = clipOf(engine, speed);
  walk.capture.motion.roles = data.roles;
  walk.plants.frames = kLastFrame + 1;
  const std::array<double, 2> both = engine.support(speed);
  for (const Side side : {kLeft, kRight}) {
    // As SpeedEngine::planted() has it.
    const double strike = (side == kLeft ? 0.0 : 0.5) - 0.5 * both[side];
    const double lift_off = (side == kLeft ? 0.5 : 1.0) + 0.5 * both[other(side)];
    walk.plants.plants[side] = plantsOfFoot(kEnginePhases * strike, kEnginePhases * lift_off);
  }
  walk.quality = nearestClip(*data.walk, speed).capture;
  walk.stand.name = "stand";
  walk.stand.kind = MotionKind::kPosture;
  walk.stand.posture = data.stand;
  walk.stand.source = data.stand_source;
  walk.licence = eachOnce(*data.walk, &MotionSource::licence);
  walk.credit = eachOnce(*data.walk, &MotionSource::credit);
  return walk;
}

}  // namespace amble
