#include "animation/synthesis/leg_lanes.h"

#include "animation/synthesis/leg_lanes_kernel.h"

namespace amble {

const LegKernel kPlainLegs = {placeChainLanes, aimLanes, lowerLanes, reachLanes};

const LegKernel& legKernel() {
  static const LegKernel& quickest = avx2Legs() ? *avx2Legs() : kPlainLegs;
  return quickest;
}

}  // namespace amble
