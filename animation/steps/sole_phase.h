/// What a foot's sole is about, as far as what it may touch goes.
#pragma once

#include <array>
#include <cstdint>

#include "animation/steps/foot_state.h"

namespace amble {

enum class SolePhase : std::uint8_t {
  kPlanted,
  kBeside,   ///< just being lifted or put down: it may still, or already, touch
  kSwinging  ///< nothing is touched
};
using SolePhases = std::array<SolePhase, 2>;  ///< by Side

/// Where planes meet a print may lie a millimetre or two in one of them, which the foot leaves in
/// the first and reaches in the last tenth of its swing.
inline SolePhase solePhase(const FootState& foot) {
  constexpr double kShare = 0.1;  // of a swing
  if (foot.planted()) return SolePhase::kPlanted;
  return foot.at < 1.0 + kShare || foot.at > 2.0 - kShare ? SolePhase::kBeside
                                                          : SolePhase::kSwinging;
}

}  // namespace amble
