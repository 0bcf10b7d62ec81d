#include "app/animated.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "animation/library/library_style.h"
#include "animation/library/motion_library_reader.h"
#include "animation/steps/foothold.h"
#include "animation/synthesis/action.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kSlowestWalk = 0.3, kFastestWalk = 2.0;  // of CharacterSettings [m/s]

// What is asked for must be within what captured walks are edited to (thesis, chapter 6).
void checkRamp(const std::string& option, const std::optional<Ramp>& asked, double captured,
               double least, double most) {
  if (!asked) return;
  const double low = least * captured, high = most * captured;
  for (const double value : {asked->from, asked->to}) {
    if (value >= low - 1e-9 && value <= high + 1e-9) continue;
    throw InputError("amble animate: " + option, 0, fmt::format("is {:g} m", value),
                     fmt::format("{:.3f} to {:.3f}, {:g} to {:g} of the captured walk's {:.3f}",
                                 low, high, least, most, captured));
  }
}

// What the character takes, of the rules that a number that was asked for breaks.
std::string limitText(WalkRule rule, const GroundLimits& limits) {
  switch (rule) {
    case WalkRule::kStepHeight:
      return fmt::format("; steps are at most {:g} m up and {:g} m down", limits.max_climb,
                         limits.max_drop);
    case WalkRule::kSlope:
      return fmt::format("; ground is at most {:g} degrees steep", limits.max_slope / kDegree);
    case WalkRule::kStepLength:
      return "; expected a --duration, --speed and --stride that a whole number of steps fits";
    case WalkRule::kTurnRate:
      return "; expected a smaller --turn or --speed";
    case WalkRule::kReach:
      return "; expected shorter steps, or less steep ground: a leg is too short";
    case WalkRule::kFoothold:
      return "; expected --stairs with more room for a sole";
    default:
      return "; expected other ground";
  }
}

// Why steps are too high on stairs whose risers are not: soles do not stand on their treads, so
// that several would have to be taken at once.
std::string treadText(const AnimateRequest& request, const FootShape& foot,
                      const GroundLimits& limits) {
  if (!request.walk.stairs) return "";
  const auto [rise, going] = *request.walk.stairs;
  const double sole = foot.tip_x - foot.heel_x + 2.0 * foot.radius;
  const bool is_low = rise > 0.0 ? rise <= limits.max_climb : -rise <= limits.max_drop;
  const double stands = FootholdFinder::kLeastSupport * sole;
  if (!is_low || going >= stands) return "";
  return fmt::format(
      "; a sole of {:.2f} m stands on treads of {:.2f} m and more, others are taken several at "
      "once",
      sole, stands);
}

// A ramp is walked all the way, or not at all: who turns back where it gets too steep has not done
// what was asked.
bool isTooSteep(const DemoRequest& request, const GroundLimits& limits) {
  constexpr double kRounding = 1e-9;  // of degrees [rad]
  return request.incline && std::max(std::abs(request.incline->from),
                                     std::abs(request.incline->to)) > limits.max_slope + kRounding;
}

CharacterSettings settingsOf(const AnimateRequest& request, const MotionLibrary& library) {
  CharacterSettings settings;
  settings.height = request.height;
  settings.frame_time = 1.0 / request.fps;
  if (!request.style.empty()) settings.speed = ownSpeed(library, request.height);
  if (request.speed) settings.speed = *request.speed;
  if (request.speed && (*request.speed < kSlowestWalk || *request.speed > kFastestWalk)) {
    throw InputError("amble animate: --speed", 0, fmt::format("is {:g} m/s", *request.speed),
                     fmt::format("{:g} to {:g} m/s; an engine takes other speeds, and ramps",
                                 kSlowestWalk, kFastestWalk));
  }
  settings.actions = request.actions;
  for (const std::string& action : request.actions) {
    if (findAction(library, action) != nullptr) continue;
    throw InputError(
        "amble animate: --action", 0,
        "'" + action + "' is no movement or posture of the library that is always valid",
        "of" + listActions(library));
  }
  return settings;
}

void checkRequest(const WalkSynthesizer& synthesizer, const DemoRequest& request) {
  const double fastest_deg = synthesizer.maxTurnRate() / kDegree;
  const double asked_deg = request.turn_rate / kDegree;
  if (std::abs(asked_deg) > fastest_deg) {
    throw InputError("amble animate: --turn", 0, fmt::format("is {:g} degrees/s", asked_deg),
                     fmt::format("-{0:.1f} to {0:.1f}, as the library's turns go", fastest_deg));
  }
  checkRamp("--stride", request.stride, synthesizer.capturedStep(), 0.6, 1.4);
  checkRamp("--lift", request.lift, synthesizer.capturedLift(), 0.5, 3.0);
}

}  // namespace

AnimatedWalk animateWalk(const AnimateRequest& request, const StopRequest& stop) {
  AnimatedWalk made;
  made.library =
      std::make_unique<const MotionLibrary>(openMotionLibrary(request.library, {}, request.style));
  const CharacterSettings settings = settingsOf(request, *made.library);
  made.ground = demoGround(request.walk, settings.speed);
  made.synthesizer = std::make_unique<const WalkSynthesizer>(*made.library, *made.ground, settings);
  checkRequest(*made.synthesizer, request.walk);
  if (isTooSteep(request.walk, settings.limits))
    made.result.refused = WalkRule::kSlope;
  else
    made.result = demoWalk(*made.synthesizer, *made.ground, request.walk, made.walk, stop);
  if (made.result.refused != WalkRule::kNone) {
    made.refused = std::string(walkRuleName(made.result.refused)) + " refused" +
                   limitText(made.result.refused, settings.limits);
    if (made.result.refused == WalkRule::kStepHeight) {
      made.refused += treadText(request, made.synthesizer->feet()[kLeft], settings.limits);
    }
  }
  return made;
}

}  // namespace amble
