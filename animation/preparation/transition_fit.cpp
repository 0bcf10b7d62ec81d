#include "animation/preparation/transition_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "animation/analysis/foot_plants.h"
#include "animation/analysis/motion_measures.h"
#include "animation/body/pelvis.h"
#include "base/error.h"
#include "base/statistics.h"

namespace amble {
namespace {

constexpr double kHalfWindow = 0.1;                // over which speed is taken, both ways [s]
constexpr double kStanding = 0.1, kWalking = 0.9;  // of the speed that is reached
constexpr double kSlowestWalkOn = 0.4;             // [m/s]
constexpr double kUsualSpeed = 0.75;               // quantile of speeds: most of the clip walks

// Speed of the pelvis along the ground at each frame, [m/s].
std::vector<double> walkingSpeeds(const Clip& clip, const JointRoles& roles) {
  const std::vector<Eigen::Vector3d> path = pelvisPath(clip, roles);
  const int n = static_cast<int>(path.size());
  const int half = std::max(1, static_cast<int>(std::lround(kHalfWindow / clip.frame_time)));
  std::vector<double> speeds(n);
  for (int i = 0; i < n; ++i) {
    const int a = std::max(0, i - half), b = std::min(n - 1, i + half);
    speeds[i] = b > a ? (path[b] - path[a]).head<2>().norm() / ((b - a) * clip.frame_time) : 0.0;
  }
  return speeds;
}

// Frames of the first strike after `begin`.
int firstStrike(const FootPlants& plants, int begin, int last) {
  int strike = last;
  for (const auto& side : plants.plants) {
    for (const FootPlant& plant : side) {
      if (plant.first > begin) strike = std::min(strike, plant.first);
    }
  }
  return strike;
}

// As a stop is a start seen backwards.
FootPlants reversed(const FootPlants& plants) {
  FootPlants back = plants;
  for (auto& side : back.plants) {
    for (FootPlant& plant : side) {
      const FootPlant forward = plant;
      plant.first = plants.frames - 1 - forward.last;
      plant.last = plants.frames - 1 - forward.first;
    }
  }
  return back;
}

}  // namespace

Transition fitTransition(const Clip& level, const JointRoles& roles, bool start,
                         const std::string& file, std::array<int, 2>& frames) {
  std::vector<double> speeds = walkingSpeeds(level, roles);
  FootPlants plants = detectPlants(level, roles);
  if (!start) {
    std::reverse(speeds.begin(), speeds.end());
    plants = reversed(plants);
  }
  Transition transition;
  transition.speed = quantile(speeds, kUsualSpeed);
  const auto walking = std::find_if(speeds.begin(), speeds.end(),
                                    [&](double v) { return v > kWalking * transition.speed; });
  const auto standing = std::find_if(std::make_reverse_iterator(walking), speeds.rend(),
                                     [&](double v) { return v < kStanding * transition.speed; });
  if (transition.speed < kSlowestWalkOn || standing == speeds.rend()) {
    throw InputError(file, 0,
                     start ? "does not stand and then walk" : "does not walk and then stand",
                     "a clip that does");
  }
  const int first = static_cast<int>(speeds.rend() - standing) - 1;
  const int last = static_cast<int>(walking - speeds.begin());
  transition.acceleration =
      (kWalking - kStanding) * transition.speed / ((last - first) * level.frame_time);
  transition.first_speed = speeds[firstStrike(plants, first, static_cast<int>(speeds.size()) - 1)];
  const int end = static_cast<int>(speeds.size()) - 1;
  frames = start ? std::array{first, last} : std::array{end - last, end - first};
  return transition;
}

}  // namespace amble
