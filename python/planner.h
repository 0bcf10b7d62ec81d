/// A planner as Python holds it: a scene with its walker and his roadmap.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "planner/legs/planner.h"
#include "scenarios/problem.h"

namespace amble {

/// Const once it is there: any number of threads may ask it.
struct PythonPlanner {
  std::unique_ptr<const Problem> problem;     ///< without ends
  std::map<std::string, std::string> inputs;  ///< file: SHA-256, but for the scenario's own text
  std::optional<Planner> planner;
  double frame_time = 1.0 / 60.0;  ///< [s]
};

}  // namespace amble
