/// A walk without a scene: what `amble animate` makes of what it is asked for.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "animation/library/motion_library.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "app/demo_walk.h"
#include "base/stop_request.h"

namespace amble {

struct AnimateRequest {
  std::string library = "default";  ///< or a file
  std::string style;                ///< in whose manner, of the library's, or ""
  std::optional<double> speed;      ///< [m/s]; none: 1.2, or the style's own
  double height = 0.0;              ///< [m]; 0: the library's
  double fps = 60.0;                ///< [1/s, 24 to 240]
  std::vector<std::string> actions;
  DemoRequest walk;
};

/// Its parts know one another by address.
struct AnimatedWalk {
  std::unique_ptr<const MotionLibrary> library;
  std::unique_ptr<const Ground> ground;
  std::unique_ptr<const WalkSynthesizer> synthesizer;
  AnimationBuffer walk;
  WalkResult result;    ///< which rule refused, if one did
  std::string refused;  ///< the same for people, with the limit; "" where there is a walk
};

/// @param stop  looked at between tries. @throws InputError for what is beyond the library's walks:
/// it names the option; Stopped
AnimatedWalk animateWalk(const AnimateRequest& request, const StopRequest& stop = {});

}  // namespace amble
