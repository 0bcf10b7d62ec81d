#include "viz/page/room_to_walk.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace amble {
namespace {

constexpr double kHardly = 0.05, kMuch = 0.20;  // to either side [m]
constexpr double kLevel = 0.01;                 // of a strip, end to end [m]

std::uint8_t kindOf(double spare) {
  if (spare < kHardly) return 0;
  return spare < kMuch ? 1 : 2;
}

}  // namespace

PageGround roomToWalk(const ClearanceMap& map) {
  PageGround ground;
  ground.breadth = map.cell();
  if (map.size() > kMostPlaces) return ground;
  std::vector<bool> taken(map.size(), false);
  for (int place = 0; place < map.size(); ++place) {
    if (taken[place] || map.spare(place) < 0.0) continue;
    const std::uint8_t kind = kindOf(map.spare(place));
    int last = place;
    for (;;) {
      taken[last] = true;
      const int next = map.beside(last, 1, 0);
      if (next < 0 || taken[next] || map.spare(next) < 0.0 || kindOf(map.spare(next)) != kind ||
          std::abs(map.at(next).z() - map.at(place).z()) > kLevel)
        break;
      last = next;
    }
    const Eigen::Vector3d half(0.5 * map.cell(), 0.0, 0.0);
    ground.strips.push_back({map.at(place) - half, map.at(last) + half});
    ground.kind.push_back(kind);
  }
  return ground;
}

PageGround reachedGround(const ReachedRegion& reached) {
  PageGround ground;
  ground.breadth = reached.breadth;
  const Eigen::Vector3d half(0.5 * reached.breadth, 0.0, 0.0);
  for (const ReachedRegion::Strip& strip : reached.strips)
    ground.strips.push_back({strip.from - half, strip.to + half});
  ground.kind.assign(ground.strips.size(), 0);
  return ground;
}

}  // namespace amble
