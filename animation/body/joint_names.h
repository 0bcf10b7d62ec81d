/// Joints named as other tools name them, so that their retargeting finds them by itself.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/body/skeleton.h"

namespace amble {

/// mixamo, vrm, unreal, unity, acclaim.
const std::vector<std::string>& jointNamings();

/// By joint: that of its role in the naming; a joint without a role keeps its own, with a number
/// behind it where another's role has it now. Names that differed before differ after. "" is the
/// skeleton's own naming. @pre `naming` is "" or one of jointNamings()
std::vector<std::string> jointNames(const Skeleton& skeleton, const JointRoles& roles,
                                    std::string_view naming);

/// The skeleton with such names.
Skeleton renamed(const Skeleton& skeleton, const std::vector<std::string>& names);

}  // namespace amble
