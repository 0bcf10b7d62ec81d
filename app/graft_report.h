/// What is said of a graft, for people and for machines.
#pragma once

#include <nlohmann/json.hpp>

#include "app/findings.h"
#include "app/grafted.h"

namespace amble {

/// @pre grafted.refusal is "", or tells of arms in the body
Findings describeGraft(const std::string& file, const GraftSource& base, const GraftSource& upper,
                       const Grafted& grafted, const GraftWishes& wishes);

/// Data alone: also of what was refused.
nlohmann::ordered_json graftData(const GraftSource& base, const GraftSource& upper,
                                 const Grafted& grafted, const GraftWishes& wishes);

/// What arms are deeper in than in the sources, a line each.
std::vector<std::string> armWarnings(const Grafted& grafted);

}  // namespace amble
