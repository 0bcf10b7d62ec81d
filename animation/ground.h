/// What feet stand on, as the animation sees it.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace amble {

/// Height of the ground. An extension point: a plane here, a scene's layers in environments/.
class Ground {
 public:
  virtual ~Ground() = default;
  /// Height of the highest ground at (x, y) that is not above z + reach, nor below z - reach; none
  /// where there is none [m].
  virtual std::optional<double> height(double x, double y, double z, double reach) const = 0;
};

/// The plane z = level, without end.
class FlatGround : public Ground {
 public:
  explicit FlatGround(double level = 0.0) : level_(level) {}
  std::optional<double> height(double, double, double, double) const override { return level_; }

 private:
  double level_;
};

}  // namespace amble
