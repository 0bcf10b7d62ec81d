/// What slopes and stairs change of how people walk: pace, lean, landing, the length and time of
/// steps. Climbs are up positive.
#pragma once

#include "animation/steps/foot_state.h"

namespace amble {

/// Measured on people, where somebody has; where "by trial" stands, on what looks right.
struct SlopeGait {
  /// Tobler's hiking function (1993), v ~ exp(-3.5 |slope + 0.05|): how fast the speed falls off
  /// with the slope [1], and the slope that is walked fastest, downhill [1].
  static constexpr double kSlowing = 3.5, kFastest = 0.05;
  /// Of that, which is for hours of path, half: a ramp of 10 degrees is walked at 0.73 of the speed
  /// and not at 0.54, which would be a stroll [1].
  static constexpr double kOnSight = 0.5;
  /// Trunk's lean, as shares of the slope's angle: what trunks do on treadmills that are inclined
  /// by 5 to 10 % (Leroux, Fung & Barbeau 2002), and as much in proportion on stairs [1].
  static constexpr double kLeanUp = 0.35, kLeanDown = 0.15;
  /// Rise per metre on which feet land flat; by trial: less, and gentle ramps are stamped on; more,
  /// and heels are put into a hill [1].
  static constexpr double kFlatStrike = 0.35;
  /// Steps of stairs against those of the level: Riener, Rabuffetti & Frigo (2002), cycles of 1.41
  /// s up and 1.19 s down stairs of 0.17 m by 0.29 m, against steps of 0.53 s. So much longer takes
  /// a step that rises or falls by kStairRise [m, 1, 1].
  static constexpr double kStairRise = 0.17;
  static constexpr double kSlowerUp = 0.33, kSlowerDown = 0.13;
  /// A landing this much above or below the other foot is flat, or on the ball, for a captured
  /// subject; by trial: a heel that strikes a tread looks like a march [m].
  static constexpr double kFlatLanding = 0.15;
  /// At this height a step is half as long as on the level; by trial: stairs' goings of 0.29 m at
  /// rises of 0.17 m come out as wanted [m].
  static constexpr double kHalvingHeight = 0.25;
};

/// Share of the level's speed that people walk on a slope at, 1 where that is faster than on the
/// level: Tobler's, softened (SlopeGait::kOnSight) [0 to 1]. @param slope  [1, up positive]
double slopePace(double slope);

/// How far people lean into a slope, or back [rad, forwards positive]. @param slope  [1, positive
/// up]
double slopeLean(double slope);

/// How much of the heel strike is kept on a foot that stands so: uphill feet land flatter
/// (FootState::strike_roll) [0, 1].
double slopeStrike(const FootPlace& place);

/// What a step up or down by `height` [m] leaves of that heel strike: flat upwards, on the ball
/// downwards (FootState::strike_roll) [-1, 1]. @param scale  of the character to a captured subject
/// [> 0]
double climbStrike(double strike, double height, double scale);

/// How much longer a step up or down by `height` [m] takes than one on the level [1, >= 1].
/// @param scale  of the character to a captured subject [> 0]
double climbTime(double height, double scale);

/// Length of a step up or down by `height` [m] whose length on the level is `level` [m].
double climbStep(double level, double height);

}  // namespace amble
