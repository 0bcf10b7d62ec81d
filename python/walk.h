/// A run as Python holds it.
#pragma once

#include <mutex>

#include "scenarios/run_scenario.h"

namespace amble {

/// Views of it keep it. Const once it is there, but for what its report says of its last writing.
struct PythonWalk {
  RunResult result;
  std::string command;  ///< that repeats it
  std::mutex report;    ///< held while the report is read or written
};

/// How far clearances are looked for, as in reports [m].
inline constexpr double kMostClearance = 2.0;

}  // namespace amble
