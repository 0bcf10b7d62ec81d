/// What of a scene can be stood on.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "animation/ground.h"
#include "environments/scene.h"

namespace amble {

/// Up-facing surfaces of `auto` and `ground` objects that are level with the floor under a given
/// point: within `kLevel` of its height. (Slopes and stairs are not ground yet: they are
/// obstacles.)
class SceneGround : public Ground {
 public:
  /// How far from the floor's height a surface may lie and still be floor: rugs and thresholds [m].
  static constexpr double kLevel = 0.03;

  /// Floor heights are found by `floors`; the ground is then that of one floor.
  SceneGround(const Scene& scene, double floor);
  ~SceneGround() override;

  std::optional<SurfacePoint> surface(double x, double y, double z, double reach) const override;
  double floor() const { return floor_; }
  /// Whether the object has ground that counts: soles may touch it.
  bool isGround(int object) const { return ground_objects_[object]; }
  /// Extent of what can be walked on [m].
  Eigen::AlignedBox2d extent() const { return extent_; }

 private:
  struct Grid;
  std::unique_ptr<Grid> grid_;
  double floor_;
  std::vector<bool> ground_objects_;
  Eigen::AlignedBox2d extent_;
};

/// Heights of every surface that could be a floor at (x, y), lowest first; those nearer than kLevel
/// count as one, the lowest of them [m]. A floor is said to be `ground`, or goes on level for 4 m^2
/// (a table does not); where nothing at (x, y) does, every surface there is one.
std::vector<double> floors(const Scene& scene, double x, double y);

}  // namespace amble
