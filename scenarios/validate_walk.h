/// Any BVH against a scene: what it touches and when, how near it comes, how its feet slide and
/// whether they stand on the ground.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "animation/ground/ground_limits.h"
#include "base/file_axes.h"
#include "environments/scene/scene.h"
#include "scenarios/walk_findings.h"

namespace amble {

struct ValidateOptions {
  std::optional<double>
      metres_per_unit;  ///< of the BVH; none: guessed from the length of its legs [m, > 0]
  UpAxis up = UpAxis::kY;
  double height = 0.0;  ///< stature [m, 0.5 to 2.5]; 0: from the length of the legs
  /// Checked at this rate too, in between as a player shows it [1/s]; 0: at the frames only.
  double fps = 0.0;
  std::optional<double> floor;   ///< height of the floor [m]; none: the one below the feet
  LoadLimits load = {};          ///< of the scene
  GroundLimits limits;           ///< what is walked on, and by what steps: the scenario's
  double clearance_limit = 2.0;  ///< how far clearances are looked for [m, > 0]
};

struct WalkValidation {
  int frames = 0;           ///< of the file
  double frame_time = 0.0;  ///< [s]
  int poses_checked = 0;    ///< with those in between
  double metres_per_unit = 1.0;
  double stature = 0.0;               ///< of the body that was checked [m]
  double floor = 0.0;                 ///< [m]
  std::vector<ContactSpan> contacts;  ///< in order of start
  double clearance = 0.0;  ///< smallest, at frames; the limit where nothing is nearer [m]
  std::string clearance_part, clearance_object;  ///< empty where nothing is within the limit
  double clearance_time = 0.0;                   ///< [s]
  StandingFeet feet;
  StepHeights steps;                ///< [m]
  double ground_penetration = 0.0;  ///< largest depth of a sole [m]
  double pops = 0.0;                ///< motion_measures.h [1, >= 0]

  bool hovers() const { return feet.hover_max > kHoverLimit; }
  bool slides() const { return feet.skate_max > kSlideLimit; }
  bool hasPops() const { return pops > kPopsLimit; }
  /// Whether a step is higher than the limits have it, by more than kStepSlack.
  bool oversteps(const GroundLimits& limits) const {
    return steps.up > limits.max_climb + kStepSlack || steps.down > limits.max_drop + kStepSlack;
  }
};

/// The most poses that are checked, times the skeleton's joints: half a gigabyte.
inline constexpr double kMostCheckedPoses = 1e7;

/// A BVH does not say when its feet are planted, so soles may touch the floor at any time, no
/// deeper than kSoleDepth: a foot that drags over it shows as skate. The motion between frames is
/// checked too (CollisionWorld). Radii of a skeleton that the library does not know come from its
/// leg length; its soles' height from its lowest feet.
/// @throws InputError with file and line.
WalkValidation validateWalk(const std::filesystem::path& bvh, const std::filesystem::path& scene,
                            const ValidateOptions& options = {});

}  // namespace amble
