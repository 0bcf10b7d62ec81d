/// A tree of boxes over triangles, eight to a node: whether a capsule touches a surface, and how
/// far it is.
///
/// Boxes are kept in floats, rounded outwards, coordinate by coordinate for eight at once, so that
/// one pass over a node judges all of them; what they let through is decided by doubles
/// (segment_distance.h). Built by halves at the middle triangle along the widest axis, in
/// O(n log n); the same for the same triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "environments/body/capsule.h"
#include "environments/scene/mesh.h"
#include "environments/scene/triangle_grid.h"

namespace amble {

class TriangleTree {
 public:
  TriangleTree() = default;
  /// @pre the mesh is in World and clean (cleanMesh).
  explicit TriangleTree(const TriangleMesh& mesh);

  bool empty() const { return triangles_.empty(); }
  bool touches(const Capsule& capsule) const;
  /// Of capsule and surface, if it is less than `limit`; else `limit`. 0 where they touch [m].
  double distance(const Capsule& capsule, double limit) const;

 private:
  static constexpr int kWide = 8;
  struct Node {
    std::array<std::array<float, kWide>, 3> min, max;  // by axis [m]; of no child upside down
    std::array<int32_t, kWide> first;  // the child's node or, of a leaf, its first triangle
    std::array<int32_t, kWide> count;  // of a leaf's triangles; 0: a node
  };
  struct Order;  // of the triangles while they are sorted
  int build(Order& order, int begin, int end);
  void addChild(int node, int child, Order& order, int begin, int end);
  template <typename Leaf>
  void search(const Capsule& capsule, const double& reach, Leaf leaf) const;

  std::vector<Node> nodes_;
  std::vector<Triangle3> triangles_;  // those of a leaf one after another
  double farthest_ = 0.0;             // of their coordinates from 0 [m]
};

}  // namespace amble
