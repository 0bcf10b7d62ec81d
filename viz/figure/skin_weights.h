/// Which joints a figure's vertices hang on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "animation/body/skeleton.h"
#include "environments/scene/mesh.h"
#include "viz/figure/loft.h"

namespace amble {

struct SkinWeights {
  std::vector<std::array<std::uint16_t, 4>> joints;  ///< distinct where their weight is not 0
  std::vector<std::array<float, 4>> weights;         ///< falling; they sum to 1, [0, 1]
};

/// From the distances to the lofts: a vertex hangs on the joint of the nearest, and on those next
/// to it in the skeleton the more the less farther theirs are; then evened out over the mesh. So
/// no limb pulls at another that it only comes near to.
/// @param reach  over which one joint's share falls to nothing [m, > 0]
SkinWeights skinWeights(const TriangleMesh& mesh, const std::vector<LoftGroup>& groups,
                        const Skeleton& skeleton, double reach);

}  // namespace amble
