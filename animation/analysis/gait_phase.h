/// The phase of the gait over a clip: what two walks are compared at, whatever their cadence.
///
/// Phase is in cycles; n is the middle of the double support with the left foot in front, n + 0.5
/// the same with the right (DESIGN.md, section 2). In a run, which has none, it is the middle of
/// the flight before a foot comes down.
#pragma once

#include <vector>

#include "animation/analysis/foot_plants.h"

namespace amble {

/// A moment whose phase is known; between two of them phase goes on evenly.
struct PhaseMoment {
  double frame = 0.0;  ///< between frames
  double phase = 0.0;  ///< [cycles, >= 0]: a multiple of 0.5
};

/// In order of time, each half a cycle after the one before. Of several stretches in which left and
/// right take turns (a hop, a shuffle or a pause ends one) the longest in steps, the first of
/// equals; none for fewer than two steps.
std::vector<PhaseMoment> gaitPhase(const FootPlants& plants);

}  // namespace amble
