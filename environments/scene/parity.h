/// Inside or outside of a mesh: parity of the surfaces above a point, over the mesh's closed
/// components.
///
/// Inside is by parity (DESIGN.md, section 3), so a hollow shell is free within and winding does
/// not matter. Open components are surfaces: they have no inside. The ray is a little off the
/// vertical, so that walls do not contain it.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "environments/scene/mesh.h"

namespace amble {

/// Adds the triangles of a mesh to another.
void appendMesh(TriangleMesh& to, const TriangleMesh& from);
/// A mesh's closed components.
TriangleMesh closedPart(const TriangleMesh& mesh);

class Parity {
 public:
  Parity() = default;
  explicit Parity(const TriangleMesh& mesh) : Parity(ofClosed(closedPart(mesh))) {}
  /// Of a mesh whose components are known to be closed, which costs less. @pre they are
  static Parity ofClosed(const TriangleMesh& mesh);

  /// Whether the mesh has a closed component.
  bool empty() const { return corners_.empty(); }
  /// Of the closed components [m].
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }
  /// @pre p is not within rounding of the surface: who touches it asks something else.
  bool inside(const Eigen::Vector3d& p) const;
  /// The ray's way aside for each metre up [m, >= 0].
  static constexpr double kShear = 0.012347;
  /// Appends the heights [m], in no order, of all surfaces that the ray through p crosses, above
  /// and below. A point of the ray is inside where those that are not below it are odd in number.
  void addCrossings(const Eigen::Vector3d& p, std::vector<double>& heights) const;

 private:
  void sortIntoCells();
  template <typename Visit>
  void visitCrossings(const Eigen::Vector3d& p, Visit visit) const;
  Eigen::Vector2i cellOf(double u, double v) const;

  // Corners with (x, y) sheared along the ray, so that it is vertical for them; three a triangle.
  std::vector<std::array<Eigen::Vector3d, 3>> corners_;
  Eigen::AlignedBox3d bounds_;      // World
  Eigen::Vector2d min_{0, 0};       // of the grid, sheared
  Eigen::Vector2d cell_{1, 1};      // [m]
  Eigen::Vector2i count_{0, 0};     // cells
  std::vector<int> start_, items_;  // triangles of cell c: items_[start_[c] .. start_[c + 1])
};

}  // namespace amble
