/// Lofts: what the figure is blended from. A round bar whose cross-section, a stadium, changes from
/// one end to the other.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace amble {

struct LoftEnd {
  Eigen::Vector3d at;  ///< middle of the cross-section [m]
  double radius;       ///< [m, > 0]
  double half = 0.0;   ///< the stadium's straight part to either side [m, >= 0]
};

struct Loft {
  LoftEnd a, b;
  Eigen::Vector3d across = Eigen::Vector3d::UnitY();  ///< unit: direction of the straight parts
  std::array<int, 2> joints = {0, 0};                 ///< that its ends hang on
  double blend = 0.01;  ///< width over which it runs into what stands before it [m, > 0]
  std::array<std::uint8_t, 3> color = {128, 128, 128};  ///< sRGB
};

/// What of a loft is nearest to a point: its distance, negative inside [m], and where along it.
struct LoftDistance {
  double distance;
  double along;  ///< [0, 1]
};
LoftDistance distanceTo(const Loft& loft, const Eigen::Vector3d& p);

/// Distance to two surfaces that run into one another over `blend`: at most the lesser of both, and
/// less than it by a quarter of `blend` at most.
double smoothUnion(double a, double b, double blend);

/// Lofts that are one thing before they join the others, cut off below a plane if there is one.
struct LoftGroup {
  std::vector<Loft> lofts;
  double blend = 0.01;  ///< into the groups before [m, > 0]
  struct Plane {
    Eigen::Vector3d normal;  ///< unit
    double offset;           ///< normal . p of its points [m]
  };
  std::optional<Plane> floor;
};

/// Signed distance to the surface of all groups, about [m]: its gradient is 1 or little more.
double distanceTo(const std::vector<LoftGroup>& groups, const Eigen::Vector3d& p);
/// The lofts that matter in a ball: what is farther than the nearest by more than the ball and the
/// blends changes nothing there. @param nearest  distanceTo(groups, at)
std::vector<LoftGroup> loftsNear(const std::vector<LoftGroup>& groups, const Eigen::Vector3d& at,
                                 double radius, double nearest);
/// Direction in which it grows, by differences [unit].
Eigen::Vector3d outwards(const std::vector<LoftGroup>& groups, const Eigen::Vector3d& p);

}  // namespace amble
