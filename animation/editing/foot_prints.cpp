#include "animation/editing/foot_prints.h"

#include "base/ease.h"

namespace amble {
namespace {

// A foot that moves less from print to print goes by time, one that moves twice so much by its way
// [m].
constexpr double kHardlyMoved = 0.1;

FootPrint inAir(const FootTrack& foot, int frame) {
  FootPrint print;
  print.first = print.last = print.middle = frame;
  print.toe = print.at = foot.toe[frame].head<2>();
  print.in_air = true;
  return print;
}

}  // namespace

FootPrints footPrints(const CapturedWalk& walk, const WalkTracks& tracks) {
  FootPrints prints;
  for (const PlantMeasures& plant : walk.analysis.gait.plants) {
    FootPrint print;
    print.first = plant.plant.first;
    print.last = plant.plant.last;
    print.middle = (print.first + print.last) / 2;
    print.toe = tracks.feet[plant.side].toe[print.middle].head<2>();
    print.at = plant.at.head<2>();
    prints[plant.side].push_back(print);
  }
  const int end = walk.clip.frames() - 1;
  for (const Side side : {kLeft, kRight}) {
    std::vector<FootPrint>& of_foot = prints[side];
    const FootTrack& foot = tracks.feet[side];
    if (of_foot.empty() || of_foot.front().first > 0) {
      of_foot.insert(of_foot.begin(), inAir(foot, 0));
    }
    if (of_foot.back().last < end) of_foot.push_back(inAir(foot, end));
  }
  return prints;
}

PrintPair printsAt(const std::vector<FootPrint>& prints, int frame) {
  size_t next = 0;
  while (next < prints.size() && prints[next].middle <= frame) ++next;
  const size_t to = next < prints.size() ? next : prints.size() - 1;
  return {prints[next > 0 ? next - 1 : 0], prints[to]};
}

double progress(const PrintPair& prints, const FootTrack& foot, int frame) {
  const FootPrint &from = prints.from, &to = prints.to;
  if (&from == &to) return 0.0;
  const Eigen::Vector2d way = to.toe - from.toe;
  const double length = way.norm();
  const double by_way = smoothstep(length / kHardlyMoved - 1.0);
  const double swing = to.first - from.last;
  const double timed = minimumJerk(swing > 0.0 ? (frame - from.last) / swing : 1.0);
  if (by_way == 0.0) return timed;
  const double along = (foot.toe[frame].head<2>() - from.toe).dot(way) / (length * length);
  return by_way * along + (1.0 - by_way) * timed;
}

}  // namespace amble
