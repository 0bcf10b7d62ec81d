/// A walk without a scene: on level ground, a slope or a flight of stairs, with what is asked of
/// it.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "animation/ground/ground.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/ramp.h"
#include "base/stop_request.h"

namespace amble {

/// What `amble animate` is asked for.
struct DemoRequest {
  double duration = 5.0;                            ///< about [s, > 0]
  double turn_rate = 0.0;                           ///< at the plan's speed, left positive [rad/s]
  std::optional<Ramp> stride;                       ///< along the ground [m]
  std::optional<Ramp> lift;                         ///< GaitParameters::lift [m]
  std::optional<Ramp> incline;                      ///< up positive [rad]
  std::optional<std::pair<double, double>> stairs;  ///< rise, negative down, and going [m]
};

/// The ground that such a walk needs.
std::unique_ptr<Ground> demoGround(const DemoRequest& request, double speed);

/// The walk along +x, from standing to standing, whose duration is nearest to the wanted one: steps
/// are whole and legs must reach, so not every length is one that can be walked. @param stop looked
/// at between lengths. @throws Stopped
WalkResult demoWalk(const WalkSynthesizer& synthesizer, const Ground& ground,
                    const DemoRequest& request, AnimationBuffer& best,
                    const StopRequest& stop = {});

}  // namespace amble
