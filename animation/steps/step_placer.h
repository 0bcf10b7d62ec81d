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

#include "animation/steps/foothold.h"
#include "animation/steps/footstep_plan.h"
#include "animation/steps/footsteps.h"
#include "animation/steps/gait_parameters.h"
#include "animation/steps/speed_profile.h"
#include "animation/steps/step_timing.h"
#include "animation/steps/stride_law.h"
#include "animation/steps/swing_path.h"
#include "animation/steps/walk_rule.h"

namespace amble {

/// The feet of a stance on its ground.
struct StanceFeet {
  WalkRule refused = WalkRule::kNone;
  FootPlacement placement;        ///< steps are shorter on slopes
  std::array<FootPlace, 2> feet;  ///< by Side
  double height = 0.0;            ///< of the root path there [m]
  double rise = 0.0;              ///< of a walking stance's front foot over its rear one [m]
  bool level = true;              ///< both on level ground at the stance's own height
};

/// A walk's steps. Where refused, nothing else may be asked.
struct WalkSteps {
  WalkRule refused = WalkRule::kNone;
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

/// How far people lean into a slope, or back [rad, forwards positive]; about what trunks do on
/// treadmills that are inclined by 5 to 10 % (Leroux, Fung & Barbeau 2002), and as much in
/// proportion on stairs. @param slope  [1, positive up]
double slopeLean(double slope);

/// Share of the level's speed that people walk on a slope [1, positive up] at: half of the slowing
/// of Tobler's hiking function (1993), v ~ exp(-3.5 |slope + 0.05|), which is for hours of path; 1
/// where that is faster than on the level.
double slopePace(double slope);

/// Const after construction: threads share it.
class StepPlacer {
 public:
  struct Settings {
    FootPlacement placement;  ///< at the plan's speed on the level
    SpeedLimits limits;
    FootholdLimits footholds;
    double scale = 1.0;       ///< of the character to the captured subject
    double leg_length = 0.8;  ///< [m]
    std::array<double, 2> captured_lift = {0.05, 0.05};  ///< by Side [m]
  };
  /// @pre what is referred to outlives it
  StepPlacer(const Ground& ground, const std::array<FootShape, 2>& shapes, const StrideLaw& law,
             const std::array<FootCycle, 2>& cycles, const Settings& settings);

  StanceFeet stanceFeet(const Stance& stance) const;
  WalkSteps plan(const Stance& from, const Stance& to, const RootPath& path, bool any_leading,
                 const GaitWishes& wishes) const;
  /// Puts feet on the ground from placing to placing and makes swings clear what lies in between.
  /// @return what refused
  WalkRule standOnGround(Footsteps& steps) const;

 private:
  double slopeUnder(const Stance& stance) const;
  double slopeAlong(const RootPath& path, double arc, double z) const;
  std::function<double(double)> paceAlong(const RootPath& path, const Stance& from,
                                          const Stance& to) const;
  bool natural(WalkSteps& walk, const RootPath& path, bool any_leading,
               const GaitWishes& wishes) const;
  void adapted(WalkSteps& walk, const RootPath& path, bool any_leading, const GaitWishes& wishes,
               const SpeedLimits& limits) const;
  void time(WalkSteps& walk, const FootstepPlan& plan, const RootPath& path,
            const SpeedLimits& limits) const;
  WalkRule swing(Footsteps& steps) const;
  void shapeSwings(WalkSteps& walk, const RootPath& path, const GaitWishes& wishes) const;
  double askedLift(double lift, Side side) const;
  void support(WalkSteps& walk) const;
  void finish(WalkSteps& walk) const;

  const Ground& ground_;
  const std::array<FootShape, 2>& shapes_;
  const StrideLaw& law_;
  const std::array<FootCycle, 2>& cycles_;  // by Side
  Settings s_;
  FootholdFinder holds_;
  SwingClearance clearance_;
};

}  // namespace amble
