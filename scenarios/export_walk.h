/// A walk as the file that is exported, read back: what was validated is what is exported
/// (DESIGN.md, section 3).
#pragma once

#include <string>
#include <vector>

#include "animation/body/clip.h"
#include "animation/synthesis/animation_buffer.h"

namespace amble {

struct ExportedWalk {
  std::string bvh;  ///< the file's bytes
  /// What a reader of the file sees, to the last bit, with joints in our skeleton's order.
  PoseArray poses;
  std::vector<std::string> joint_names;  ///< as the file has them, by joint of our skeleton
};

/// @param unit  length of the BVH's unit [m].
ExportedWalk exportWalk(const std::string& name, const Skeleton& skeleton,
                        const AnimationBuffer& walk, double unit);

}  // namespace amble
