/// What of a body is in level ground: a body that stands so can begin no walk.
#pragma once

#include <string>
#include <vector>

#include "animation/body/pose.h"
#include "animation/body/skeleton.h"
#include "environments/body/body.h"

namespace amble {

struct SunkPart {
  std::string name;
  double depth = 0.0;  ///< of its lowest point below z = 0 [m, > 0]
};

/// Parts below z = 0, of soles those deeper than kSoleDepth (collision_world.h); the deepest first.
std::vector<SunkPart> sunkParts(const Body& body, const Skeleton& skeleton, PoseView pose);

}  // namespace amble
