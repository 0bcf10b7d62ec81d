#include "animation/synthesis/cycle_lanes.h"

#include "animation/synthesis/cycle_lanes_kernel.h"

namespace amble {

const CycleKernel kPlainCycles = {blendLanes, projectLanes};

const CycleKernel& cycleKernel() {
  static const CycleKernel& quickest = avx2Cycles() ? *avx2Cycles() : kPlainCycles;
  return quickest;
}

}  // namespace amble
