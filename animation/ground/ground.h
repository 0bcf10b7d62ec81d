/// What feet stand on, as the animation sees it.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace amble {

/// A point of the ground at a given (x, y).
struct SurfacePoint {
  double height = 0.0;                                ///< [m, World]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, upwards: z > 0 [World]
};

/// A piece of a line of the plane [m, World].
struct PlanSegment {
  Eigen::Vector2d from, to;
};

/// Heights and normals of the ground. An extension point: a plane here, analytic slopes and stairs
/// beside it, a scene's layers in environments/. Const: threads share it.
class Ground {
 public:
  virtual ~Ground() = default;
  /// The highest ground at (x, y) that is not above z + reach, nor below z - reach; none where
  /// there is none. @param reach  [m, >= 0]
  virtual std::optional<SurfacePoint> surface(double x, double y, double z, double reach) const = 0;
  /// Its height alone [m].
  std::optional<double> height(double x, double y, double z, double reach) const {
    const auto point = surface(x, y, z, reach);
    return point ? std::optional<double>(point->height) : std::nullopt;
  }
  /// The highest point of anything, ground or obstacle, over the strip of `half_width` about the
  /// segment a-b (in plan), of what ends between low and high [m]; -infinity where there is
  /// nothing. What goes on above `high` is nothing to step over and is left out. As it stands here
  /// only ground is seen, sampled every 2 cm. @pre half_width >= 0, low <= high
  virtual double crest(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half_width,
                       double low, double high) const;
  /// Whether crest() is above `low`.
  virtual bool risesAbove(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half_width,
                          double low, double high) const {
    return crest(a, b, half_width, low, high) > low;
  }
  /// crest() of each of the pieces of a straight line, which follow one another along it [m].
  virtual std::vector<double> crests(std::span<const PlanSegment> pieces, double half_width,
                                     double low, double high) const;
  /// surface() at each of some points that lie near to one another.
  virtual void surfaces(std::span<const Eigen::Vector2d> points, double z, double reach,
                        std::span<std::optional<SurfacePoint>> out) const;
  /// The height of surface() at every point of a box of the plane, where it is one for certain and
  /// every normal vertical to the bit [m]; none where that is not known.
  virtual std::optional<double> levelOver(const Eigen::AlignedBox2d& box, double z,
                                          double reach) const {
    (void)box, (void)z, (void)reach;
    return std::nullopt;
  }
  /// Whether for certain all of it is level, at whatever heights: every normal is vertical to the
  /// bit.
  virtual bool isAllLevel() const { return false; }
};

/// The plane z = level, without end.
class FlatGround : public Ground {
 public:
  explicit FlatGround(double level = 0.0) : level_(level) {}
  std::optional<SurfacePoint> surface(double, double, double z, double reach) const override {
    if (!(std::abs(level_ - z) <= reach)) return std::nullopt;
    return SurfacePoint{level_, Eigen::Vector3d::UnitZ()};
  }
  double crest(const Eigen::Vector2d&, const Eigen::Vector2d&, double, double low,
               double high) const override {
    return height(0.0, 0.0, 0.5 * (low + high), 0.5 * (high - low)).value_or(-HUGE_VAL);
  }
  std::optional<double> levelOver(const Eigen::AlignedBox2d&, double z,
                                  double reach) const override {
    return height(0.0, 0.0, z, reach);
  }
  bool isAllLevel() const override { return true; }

 private:
  double level_;
};

}  // namespace amble
