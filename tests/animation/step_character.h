/// The default library's character as the placing of steps sees it.
#pragma once

#include "animation/library/motion_library_reader.h"
#include "animation/steps/step_placer.h"
#include "animation/synthesis/gait_blend.h"
#include "base/rotation.h"

namespace amble {

struct StepCharacter {
  MotionLibrary library = openMotionLibrary("default");
  std::array<FootShape, 2> feet = library.feet();
  GaitBlend blend{library, 1.0};

  StepSettings settings() const {
    StepSettings s;
    s.placement.walk_width = blend.stepWidth();
    s.placement.forward = blend.footForward();
    s.placement.step_length = blend.law().stepLength(1.2);
    s.limits.law = blend.law();
    s.placement.supports = s.limits.law.supports(1.2, 0.0);
    s.limits.max_turn_rate = blend.maxTurnRate();
    s.footholds = {20.0 * kDegree, 0.25, 0.25};
    return s;
  }
  StepPlacer placer(const Ground& ground) const { return {ground, feet, blend.feet(), settings()}; }
};

inline const StepCharacter& stepCharacter() {
  static const StepCharacter kCharacter;
  return kCharacter;
}

}  // namespace amble
