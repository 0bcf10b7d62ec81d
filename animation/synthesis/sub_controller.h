/// Sub-controllers (Pettré §4.2): each a rule that turns the states of an animation buffer, and
/// what is there already, into poses.
#pragma once

#include "animation/synthesis/animation_buffer.h"

namespace amble {

/// Applied one after another: walk cycles first, then postures and movements over them, then the
/// feet. Const: threads share them.
class SubController {
 public:
  virtual ~SubController() = default;
  /// Changes buffer.poses. @return false where it cannot: the walk is then refused (a leg that does
  /// not reach).
  virtual bool apply(AnimationBuffer& buffer) const = 0;
};

}  // namespace amble
