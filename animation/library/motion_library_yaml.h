/// What libraries and their recipes write alike.
#pragma once

#include <string>
#include <vector>

#include "animation/library/motion_library.h"
#include "base/strict_yaml.h"

namespace amble {

/// `valid:` always | at_start | at_end | {from: , to: } | {clearance_above: }; of a walk always,
/// since every walk of a library is blended with the others. @throws InputError
Validity readValidity(const YamlNode& node, MotionKind kind);
/// `joints:` all, or a list of chains. @throws InputError
std::vector<std::string> readChains(const YamlNode& node);

}  // namespace amble
