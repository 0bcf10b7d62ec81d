/// What is said of a walk that was validated, for machines.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "animation/ground/ground_limits.h"
#include "scenarios/validate_walk.h"

namespace amble {

nlohmann::ordered_json validationJson(const std::string& walk, const WalkValidation& result);

/// What is said, and is no failure.
struct AllowedFindings {
  bool hover = false, slide = false, pops = false;
};
/// @param limits  of the steps that may be taken
bool isClean(const WalkValidation& result, const GroundLimits& limits,
             const AllowedFindings& allowed = {});

}  // namespace amble
