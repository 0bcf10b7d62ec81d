/// What a character can stand on, and what of a scene is asked for.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "animation/ground/ground_limits.h"

namespace amble {

/// How far two surfaces may be apart and still be one level: rugs and thresholds [m].
inline constexpr double kOneLevel = 0.03;

/// Where somebody is to stand.
struct GroundPlace {
  Eigen::Vector2d at{0, 0};
  std::optional<double> z;  ///< names a surface, that nearest to it within kFloorReach [m]

  bool operator==(const GroundPlace& other) const { return at == other.at && z == other.z; }
};
/// How far from a place's z its floor may lie [m].
inline constexpr double kFloorReach = 0.3;

struct GroundSettings {
  GroundLimits limits;
  double headroom = 1.0;      ///< free height without which nobody walks, not even stooped [m, > 0]
  double foot_length = 0.25;  ///< [m, > 0]
  double foot_breadth = 0.09;  ///< [m, > 0]
  /// Ground is what is at this height, too, however small [m]...
  std::optional<double> level;
  /// ...and what these places name, or have where there is no ground.
  std::vector<GroundPlace> places;

  bool operator==(const GroundSettings& other) const = default;
};

}  // namespace amble
