/// Footholds: whether and how a whole sole stands at a place.
///
/// The sole's outline is sampled on the ground, a plane is laid on the samples, and what sticks out
/// of it or is missing below it tells whether the foot stands on one surface.
#pragma once

#include <array>
#include <optional>

#include "animation/body/foot_shape.h"
#include "animation/ground/ground.h"
#include "animation/ground/ground_limits.h"
#include "animation/steps/foot_state.h"

namespace amble {

/// What is found at a place.
struct Foothold {
  enum class Refusal {
    kNone,
    kNoGround,  ///< under the middle of the sole
    kSlope,     ///< too steep
    kEdge,      ///< something sticks up under the sole, or less than kLeastSupport of it stands
  };
  Refusal refusal = Refusal::kNone;
  FootPlace place;         ///< with height and normal
  double supported = 1.0;  ///< share of the sole's length that has ground below [0, 1]
};

class FootholdFinder {
 public:
  /// The least share of a sole's length that stands: a foot on a tread may overhang its edge, heel
  /// or toes. Less, and the ball is in the air; more, and treads of 0.22 m cannot be climbed [0 to
  /// 1].
  static constexpr double kLeastSupport = 0.7;

  FootholdFinder(const Ground& ground, const std::array<FootShape, 2>& feet,
                 const GroundLimits& limits)
      : ground_(ground), feet_(feet), limits_(limits) {}

  const GroundLimits& limits() const { return limits_; }
  const Ground& ground() const { return ground_; }
  /// Height of the ground under a point, within reach of it [m].
  std::optional<double> heightNear(const Eigen::Vector3d& point, double reach) const {
    return ground_.height(point.x(), point.y(), point.z(), reach);
  }
  /// Of a foot that is put down with its sole's middle at place.position (z: where ground is
  /// expected within `reach` [m]) and its heading.
  Foothold at(const FootPlace& place, Side side, double reach) const;

 private:
  struct SoleRows;
  struct Samples;
  bool isLevelUnder(const FootPlace& place, const FootShape& foot, double height,
                    double reach) const;
  std::optional<Foothold::Refusal> sample(const FootPlace& place, const FootShape& foot,
                                          double reach, Samples& out) const;
  bool sampleLevels(const FootPlace& place, const SoleRows& rows, double reach,
                    Samples& samples) const;
  Foothold judge(const FootPlace& place, const Samples& samples, const Eigen::Vector3d& normal,
                 double height) const;
  bool obstructed(const FootPlace& stood, const FootShape& foot) const;

  const Ground& ground_;
  const std::array<FootShape, 2>& feet_;
  GroundLimits limits_;
};

}  // namespace amble
