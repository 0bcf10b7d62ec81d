/// Whose captured swing a foot follows: the walk's, or that of a captured start or stop.
#pragma once

#include <array>

#include "animation/body/joint_roles.h"
#include "animation/library/foot_cycle.h"
#include "animation/steps/foot_state.h"

namespace amble {

/// All by Side. Where nothing is captured of first and last steps, they are the walk's.
struct SwingCycles {
  std::array<FootCycle, 2> walk, first, last;

  const FootCycle& of(Side side, SwingKind kind) const {
    return (kind == SwingKind::kWalk ? walk : kind == SwingKind::kFirst ? first : last)[side];
  }
};

}  // namespace amble
