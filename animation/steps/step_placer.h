/// The steps of a walk: where each foot is put down, over what it swings, when, and how high the
/// root path goes (DESIGN.md, section 3, stage 2, and where the feet of stage 3 go).
///
/// On level ground steps follow from the speed alone. Elsewhere they are tried as they follow from
/// it; where a sole then does not stand whole on one surface, or a step is high, they are chosen
/// for the ground (planFootsteps). The root path rises from double support to double support by
/// what the feet do (Shanbhag & Chandran §3.3.3), along a spline instead of the paper's straight
/// lines, which have corners where the slope changes.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "animation/steps/footstep_plan.h"
#include "animation/steps/gait_parameters.h"
#include "animation/steps/stance_feet.h"
#include "animation/steps/step_settings.h"
#include "animation/steps/step_swings.h"
#include "animation/steps/step_timing.h"

namespace amble {

/// What a walk is to do. Refers to what outlives it.
struct WalkRequest {
  Stance from, to;
  const RootPath& path;
  bool any_leading = true;  ///< either foot may lead at the end; else to.leading
  const GaitWishes& wishes;
  const WalkFilter* is_wanted = nullptr;  ///< asked before swings are planned
  /// Only what is told at once: of steps as they follow from the speed whether they are wanted;
  /// where they would be chosen for the ground nothing is refused.
  bool outlook = false;
};

/// A walk's steps. Where refused or unwanted, nothing else but their number may be asked.
struct WalkSteps {
  WalkRule refused = WalkRule::kNone;
  bool unwanted = false;  ///< by the request; its swings are not planned, and might be refused
  int steps = 0;
  Stance from, end;  ///< `end` with the foot that leads
  StanceFeet from_feet, end_feet;
  Side first = kLeft;
  std::optional<Footsteps> feet;
  std::vector<GaitParameters> gait;  ///< of placings 1 to `steps`
  bool level = true;                 ///< all on one level, with nothing to step over
  CubicSpline height;                ///< of the root path over progress, where not level [m]
  std::optional<SpeedProfile> profile;
  std::optional<StepTiming> timing;  ///< in place of the profile, where steps were chosen

  /// Rise of the root path per metre at a sample [1].
  double slopeAt(const SpeedProfile::Sample& at) const {
    return level ? 0.0 : height.slope(at.steps) / at.step_length;
  }
  /// Height of the root path at a sample of a path so long [m].
  double heightAt(const SpeedProfile::Sample& at, double length) const;
  int frames() const { return timing ? timing->frames() : profile->frames(); }
  SpeedProfile::Sample at(int frame) const {
    return timing ? timing->at(frame) : profile->at(frame);
  }
};

/// Const after construction: threads share it.
class StepPlacer {
 public:
  /// Over what lies between prints feet are lifted at most, for a captured subject; by trial: more
  /// is climbed with hands [m].
  static constexpr double kHighestLift = 0.25;

  /// Of the plan's speed: no walk is faster. Stride and cadence give way a little so that steps and
  /// frames are whole [1].
  static constexpr double kFastest = 1.15;

  /// @pre what is referred to outlives it
  StepPlacer(const Ground& ground, const std::array<FootShape, 2>& shapes,
             const SwingCycles& cycles, const StepSettings& settings);

  const FootPlacement& placement() const { return s_.placement; }
  StanceFeet stanceFeet(const Stance& stance) const {
    return findStanceFeet(s_, holds_, swings_.cycles, stance);
  }
  WalkSteps plan(const WalkRequest& request) const;
  /// Puts feet on the ground from placing to placing. @return what refused
  WalkRule standOnGround(Footsteps& steps) const;
  /// What ends between these heights over level prints no foot of a walk swings over; what goes on
  /// higher is a wall [m].
  Eigen::AlignedBox1d tooHighToSwingOver() const;

 private:
  bool mayBeWanted(const WalkRequest& request) const;
  bool natural(WalkSteps& walk, const WalkRequest& request) const;
  void adapted(WalkSteps& walk, const WalkRequest& request, const SpeedLimits& limits) const;
  void swing(WalkSteps& walk, const WalkRequest& request) const;

  StepSettings s_;
  FootholdFinder holds_;
  SwingFeet swings_;
  SwingClearance clearance_;
};

}  // namespace amble
