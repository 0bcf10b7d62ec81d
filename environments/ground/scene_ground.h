/// What of a scene can be stood on: the ground in all its layers, with exact heights and normals.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "animation/ground/ground.h"
#include "environments/ground/ground_settings.h"
#include "environments/scene/scene.h"

namespace amble {

class GroundCells;   // ground_cells.h
struct PlanStrip;    // plan_strip.h
struct ScenePieces;  // scene_pieces.h
class TriangleGrid;  // triangle_grid.h

/// Floors, stairs, ramps, kerbs, rugs: those surfaces of `auto` and `ground` objects that
/// GroundCells finds to be ground. Answers come from the triangles themselves. Everything else is
/// an obstacle; what of it is low enough to be stepped over is told by `crest`.
class SceneGround : public Ground {
 public:
  static constexpr double kLevel = kOneLevel;

  /// @throws Stopped if that is asked for.
  explicit SceneGround(const Scene& scene, const GroundSettings& settings = {},
                       const StopRequest& stop = {});
  /// The same of pieces that are there already. @pre they are the scene's, by splitScene
  SceneGround(const Scene& scene, std::shared_ptr<const ScenePieces> pieces,
              const GroundSettings& settings, const StopRequest& stop = {});
  /// The same with whatever is level with a floor.
  SceneGround(const Scene& scene, double level);
  ~SceneGround() override;
  SceneGround(SceneGround&&) noexcept;

  std::optional<SurfacePoint> surface(double x, double y, double z, double reach) const override;

  void surfaces(std::span<const Eigen::Vector2d> points, double z, double reach,
                std::span<std::optional<SurfacePoint>> out) const override;
  std::optional<double> levelOver(const Eigen::AlignedBox2d& box, double z,
                                  double reach) const override;
  bool isAllLevel() const override { return all_level_; }

  /// The highest point of anything, ground or obstacle, over the strip of `half_width` about the
  /// segment from a to b, of what ends between the heights low and high [m]; -infinity for nothing.
  /// What goes on above `high` is no thing to step over: it is left out, and left to the check of
  /// contacts.
  double crest(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half_width, double low,
               double high) const override;
  bool risesAbove(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half_width, double low,
                  double high) const override;
  std::vector<double> crests(std::span<const PlanSegment> pieces, double half_width, double low,
                             double high) const override;

  /// Heights of the floors at (x, y), lowest first: ground with headroom, those nearer than kLevel
  /// as one, the lowest of them. Where there is no ground, whatever could be stood on if one were
  /// put there [m].
  std::vector<double> floors(double x, double y) const;

  /// The floors at (x, y) that a place without a height means: of all that steps join the largest
  /// that has ground there, be it covered by a smaller one, and of that each storey, lowest first
  /// [m]. Below a bed that is as large as a floor it is the room's: nobody climbs there.
  std::vector<double> mainFloors(double x, double y) const;

  /// The ground where somebody stands who is said to be at a height: that of the nearest floor, or
  /// none where it is farther than `reach` from z or there is none [m].
  std::optional<SurfacePoint> stand(double x, double y, double z, double reach) const;

  const GroundSettings& settings() const { return settings_; }
  /// Whether the object has ground that counts: soles may touch it.
  bool isGround(int object) const { return ground_objects_[object]; }
  /// Extent of what can be walked on [m].
  const Eigen::AlignedBox2d& extent() const;
  /// Whether all of it lies within kLevel of one height, in one layer.
  bool isLevel() const { return is_level_; }
  /// Heights of all of it [m].
  const Eigen::AlignedBox1d& heights() const { return heights_; }
  const GroundCells& cells() const;
  const ScenePieces& pieces() const;
  /// All triangles of the scene, by number of ScenePieces.
  const TriangleGrid& all() const;
  /// The ground's triangles.
  const TriangleGrid& surfaces() const;
  /// By number of ScenePieces.
  bool isGroundTriangle(int triangle) const { return ground_triangles_[triangle]; }
  const std::vector<bool>& groundTriangles() const { return ground_triangles_; }

 private:
  SurfacePoint pointOf(int triangle, double height) const;
  void surfacesOfTriangles(std::span<const Eigen::Vector2d> points, double z, double reach,
                           std::span<std::optional<SurfacePoint>> out) const;
  template <typename Visit>
  void visitEnding(const PlanStrip& strip, double low, double high, Visit visit_one) const;
  double crestOf(int triangle, const PlanStrip& strip, double needed, double low,
                 double high) const;
  std::optional<SurfacePoint> surfaceOfTriangles(double x, double y, double z, double reach) const;
  int floorOf(const Eigen::Vector3d& p) const;
  std::vector<double> levels(double x, double y) const;
  std::vector<double> uncovered(const std::vector<double>& heights) const;

  struct Parts;

  GroundSettings settings_;
  std::unique_ptr<Parts> parts_;             // what it is made of: pieces, triangles, cells
  std::vector<bool> up_, ground_triangles_;  // by triangle
  std::vector<bool> ground_objects_;         // by object
  Eigen::AlignedBox1d heights_;
  bool is_level_ = true, all_level_ = true;
};

}  // namespace amble
