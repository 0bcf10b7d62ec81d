/// Any BVH against a scene: what it touches and when, how near it comes, how its feet slide.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "animation/captures/bvh.h"
#include "environments/collision/collision_world.h"

namespace amble {

struct ValidateOptions {
  std::optional<double>
      metres_per_unit;  ///< of the BVH; none: guessed from the length of its legs [m, > 0]
  UpAxis up = UpAxis::kY;
  double height = 0.0;  ///< stature [m, 0.5 to 2.5]; 0: from the length of the legs
  double fps = 0.0;  ///< checked at this rate too, in between as a player shows it [1/s]; 0: at the
                     ///< frames only
  std::optional<double>
      floor;             ///< height of the floor [m]; none: the one below the first frame's feet
  LoadLimits load = {};  ///< of the scene
  double clearance_limit = 2.0;  ///< how far clearances are looked for [m, > 0]
};

/// A stretch of time in which one body part touches one object.
struct ContactSpan {
  double start = 0.0, end = 0.0;  ///< [s]
  std::string part, object;
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
  std::string clearance_part, clearance_object;        ///< empty where nothing is within the limit
  double clearance_time = 0.0;                         ///< [s]
  int plants = 0;                                      ///< placings of feet that were found
  double foot_skate_mean = 0.0, foot_skate_max = 0.0;  ///< of their slides [m]
  double ground_penetration = 0.0;                     ///< largest depth of a sole [m]
};

/// A BVH does not say when its feet are planted, so soles may touch the floor at any time, no
/// deeper than kSoleDepth: a foot that drags over it shows as skate. The motion between frames is
/// checked too (CollisionWorld). Radii of a skeleton that the library does not know come from its
/// leg length; its soles' height from its lowest feet.
/// @throws InputError with file and line.
WalkValidation validateWalk(const std::filesystem::path& bvh, const std::filesystem::path& scene,
                            const ValidateOptions& options = {});

}  // namespace amble
