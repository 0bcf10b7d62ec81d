// Compiled with -mavx2 where the processor's family has it (animation/CMakeLists.txt).
#include "animation/synthesis/cycle_lanes_kernel.h"

namespace amble {

const CycleKernel* avx2Cycles() {
#if defined(__AVX2__)
  static constexpr CycleKernel kernel = {blendLanes, projectLanes};
  return __builtin_cpu_supports("avx2") ? &kernel : nullptr;
#else
  return nullptr;
#endif
}

}  // namespace amble
