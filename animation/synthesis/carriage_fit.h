/// How a character carries its hips: what of the root's height and lead is fitted, so that legs
/// reach their footprints and stay a little bent.
///
/// Captured cycles are of other steps and of feet that slide. Warped to a longer step, on feet that
/// are held, their legs would be too short: the root is lowered, by step length (on the level), by
/// stance (on slopes and steps), and by stride (where one is asked for).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "animation/steps/footsteps.h"
#include "animation/steps/stance_feet.h"
#include "animation/synthesis/foot_controller.h"
#include "animation/synthesis/gait_blend.h"
#include "animation/synthesis/walk_controller.h"

namespace amble {

/// How hips are taken away from the captured motion.
struct CarriageTuning {
  /// The root is taken up to so much farther before its feet than captured, of a captured subject;
  /// more, and walkers fall forwards [m].
  static constexpr double kLongestLean = 0.03;
  /// Metres of lowering that a metre of lean is worth; by trial: cheaper, and everybody leans;
  /// dearer, and long steps are walked on bent knees [1].
  static constexpr double kLeanCost = 0.2;
  static constexpr int kLeanSteps = 12;  ///< leans that are tried: every 2.5 mm
  /// Step lengths for which lowering is prepared, linear between: 5 cm apart, off by under 1 mm.
  static constexpr int kLoweringSteps = 16;
  /// Real walkers' hips rise by 15 to 45 mm a step: strides that are asked for are kept to this, of
  /// a captured subject; beyond, long steps throw the hips up and down [m].
  static constexpr double kLeastRise = 0.016, kMostRise = 0.042;
};

/// Whose hips. Refers to what outlives it.
struct CarriageBody {
  const GaitBlend& blend;
  const std::vector<Eigen::Quaterniond>& reference;  ///< the library's, a joint each
  const FootController& feet;
  FootPlacement placement;  ///< at the plan's speed on the level
  double scale = 1.0;       ///< of the character to the captured subject [> 0]

  int joints() const { return static_cast<int>(reference.size()); }
};

struct CarriageFit {
  WalkController::Carriage carriage;  ///< of the walking root
  Eigen::VectorXd stand_channels;     ///< WalkCycle::series' channels of standing
};

/// @param stand_height  captured height of the standing root, scaled [m, > 0]
CarriageFit fitCarriage(const CarriageBody& body, double stand_height);

/// How much lower than on the level the root is at a stance for the legs to reach: standing where
/// it stands, walking on as it does on a slope like this [m, >= 0].
/// @param state  of the stance, its feet on their ground
double stanceCrouch(const CarriageBody& body, const WalkController& walk, const Stance& stance,
                    const StanceFeet& stood, const FrameState& state);

/// How much lower the root is in a step of an asked length. Long steps would throw the hips up and
/// down, short ones hardly move them: what they do is scaled to what hips do, over knees that stay
/// bent [m, >= 0; between the 24 phases that it goes by >= -0.001].
double strideCrouch(const WalkController& walk, const FrameState& state, double scale);

}  // namespace amble
