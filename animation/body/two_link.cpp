#include "animation/body/two_link.h"

#include <cmath>

#include "animation/body/two_link_lanes.h"

namespace amble {
namespace {

Point pointOf(const Eigen::Vector3d& p) {
  return {p.x() + Lanes{}, p.y() + Lanes{}, p.z() + Lanes{}};
}

Eigen::Quaterniond turnOf(const Turn& q) { return {q.w[0], q.x[0], q.y[0], q.z[0]}; }

}  // namespace

// One of four.
std::optional<TwoLinkSolution> solveTwoLink(const TwoLink& leg, const Eigen::Vector3d& target) {
  const LegTurns turns = solveLegs(
      {pointOf(leg.hip), pointOf(leg.knee), pointOf(leg.ankle), pointOf(leg.flexion_axis)},
      pointOf(target));
  if (turns.solved[0] == 0) return std::nullopt;
  return TwoLinkSolution{turnOf(turns.thigh), turnOf(turns.shank), std::acos(turns.cosine[0])};
}

}  // namespace amble
