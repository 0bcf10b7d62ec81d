/// A run as Python holds it.
#pragma once

#include "scenarios/run_scenario.h"

namespace amble {

/// Arrays that Python sees are views of it, which keep it: it is const once it is there.
struct PythonWalk {
  RunResult result;
};

}  // namespace amble
