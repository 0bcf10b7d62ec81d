#include "environments/body/body_lanes.h"

#include "environments/body/body_lanes_kernel.h"

namespace amble {

const LaneKernel kPlainLanes = {placeLanes, measureLanes};

const LaneKernel& lanes() {
  static const LaneKernel& quickest = avx2Lanes() ? *avx2Lanes() : kPlainLanes;
  return quickest;
}

}  // namespace amble
