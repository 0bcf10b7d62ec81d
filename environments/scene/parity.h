/// Inside or outside of a solid of several closed parts.
///
/// Inside a part is by parity of its surfaces above a point (DESIGN.md, section 3), so that winding
/// does not matter. Inside of them all is what lies in more parts that are solid than in hollows of
/// them (hollows.h): a hollow shell is free within, and where parts overlap they stay solid, which
/// the parity of all surfaces together would take for outside. The ray is a little off the
/// vertical, so that walls do not contain it.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "environments/scene/mesh.h"

namespace amble {

/// Adds the triangles of a mesh to another.
void appendMesh(TriangleMesh& to, const TriangleMesh& from);

/// Closed surfaces, some of which bound hollows in the others.
struct SolidMesh {
  struct Part {
    int first;    ///< its triangles go from here to the next part's first
    bool hollow;  ///< all of it lies in the solid of others
  };
  TriangleMesh mesh;
  std::vector<Part> parts;

  SolidMesh() = default;
  /// Of one part. @pre it is closed
  explicit SolidMesh(const TriangleMesh& closed) { add(closed, false); }
  void add(const TriangleMesh& closed, bool hollow);
};

class Parity {
 public:
  Parity() = default;
  explicit Parity(const SolidMesh& solid);

  bool empty() const { return corners_.empty(); }
  /// Of all parts [m].
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }
  /// @pre p is not within rounding of the surface: who touches it asks something else.
  bool inside(const Eigen::Vector3d& p) const;
  /// The ray's way aside for each metre up [m, >= 0].
  static constexpr double kShear = 0.012347;
  /// Where the ray through a point, above and below it, enters or leaves a part.
  struct Crossing {
    double height;  ///< [m]
    int change;     ///< of depth from below to above it: 1 or -1
  };
  /// Appends the crossings of the ray through p, in no order, and returns the ray's depth below
  /// them all: 0 of surfaces without a fault. Inside is where depth is above 0.
  int addCrossings(const Eigen::Vector3d& p, std::vector<Crossing>& crossings) const;

 private:
  void sortIntoCells();
  template <typename Visit>
  void visitCrossings(const Eigen::Vector3d& p, Visit visit) const;
  Eigen::Vector2i cellOf(double u, double v) const;

  // Corners with (x, y) sheared along the ray, so that it is vertical for them; three a triangle,
  // part by part.
  std::vector<std::array<Eigen::Vector3d, 3>> corners_;
  std::vector<int> part_of_;        // of each triangle
  std::vector<int> depth_in_;       // of each part: 1, or -1 of a hollow
  Eigen::AlignedBox3d bounds_;      // World
  Eigen::Vector2d min_{0, 0};       // of the grid, sheared
  Eigen::Vector2d cell_{1, 1};      // [m]
  Eigen::Vector2i count_{0, 0};     // cells
  std::vector<int> start_, items_;  // triangles of cell c: items_[start_[c] .. start_[c + 1])
};

}  // namespace amble
