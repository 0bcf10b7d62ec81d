// Compiled with -mavx2 where the processor's family has it (environments/CMakeLists.txt).
#include "environments/body/body_lanes_kernel.h"

namespace amble {

const LaneKernel* avx2Lanes() {
#if defined(__AVX2__)
  static constexpr LaneKernel kernel = {placeLanes, measureLanes};
  return __builtin_cpu_supports("avx2") ? &kernel : nullptr;
#else
  return nullptr;
#endif
}

}  // namespace amble
