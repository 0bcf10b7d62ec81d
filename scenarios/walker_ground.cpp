#include "scenarios/walker_ground.h"

namespace amble {
namespace {

// Of stature. Who walks with the head lower than this crawls; by trial.
constexpr double kHeadroomOfStature = 0.6;
// A foot is 0.152 long and 0.055 broad (Drillis and Contini 1966); 70 % of it must be supported.
constexpr double kFootRoomOfStature = 0.7 * 0.152;
constexpr double kFootRoomAcrossOfStature = 0.055;

}  // namespace

GroundSettings walkerGround(double stature, const GroundLimits& limits) {
  GroundSettings settings;
  settings.limits = limits;
  settings.headroom = kHeadroomOfStature * stature;
  settings.foot_length = kFootRoomOfStature * stature;
  settings.foot_breadth = kFootRoomAcrossOfStature * stature;
  return settings;
}

}  // namespace amble
