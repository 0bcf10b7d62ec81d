/// `amble animate --engine`: a walk of a speed engine, straight ahead over level ground.
#pragma once

#include <string>

#include "app/motion_output.h"
#include "base/ramp.h"

namespace amble {

struct EngineAnimation {
  std::string engine;     ///< file
  Ramp speed;             ///< from the walk's begin to its end [m/s]
  double duration = 5.0;  ///< [s]
  double height = 0.0;    ///< [m]; 0: the captured person's
  double fps = 60.0;
  MotionOutput out;
};

/// @return an exit status
int animateEngine(const EngineAnimation& options);

}  // namespace amble
