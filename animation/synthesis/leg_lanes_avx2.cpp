// Compiled with -mavx2 where the processor's family has it (animation/CMakeLists.txt).
#include "animation/synthesis/leg_lanes_kernel.h"

namespace amble {

const LegKernel* avx2Legs() {
#if defined(__AVX2__)
  static constexpr LegKernel kernel = {placeChainLanes, aimLanes, lowerLanes, reachLanes};
  return __builtin_cpu_supports("avx2") ? &kernel : nullptr;
#else
  return nullptr;
#endif
}

}  // namespace amble
