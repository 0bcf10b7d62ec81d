/// The surfaces over one point of the plan that could be ground, and which of them can be stood on:
/// what GroundCells asks at the middle of each square.
///
/// What is inside a solid, or has too little free above it, cannot be stood on; neither can a
/// surface that goes on straight under a foot by no heading. With n triangles over a point and
/// beside it this costs O(n log n), however many of them can be stood on.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "environments/ground/ground_settings.h"
#include "environments/scene/scene_pieces.h"

namespace amble {

class GroundColumn {
 public:
  struct Surface {
    double height;   ///< [m, World]
    bool standable;  ///< room for a foot, and for who stands there
    bool said;       ///< of an object that is said to be ground
  };

  /// @param up  of each triangle whether it faces up, is flat enough and of an `auto` or `ground`
  /// object
  /// @pre all of these outlive the column.
  GroundColumn(const Scene& scene, const ScenePieces& pieces, const std::vector<bool>& up,
               const GroundSettings& settings);

  /// Over p, lowest first. They hold until it is asked again.
  const std::vector<Surface>& surfacesAt(const Eigen::Vector2d& p);

 private:
  static constexpr int kFootHeadings = 8;  // by which a foot is tried, of half a turn

  // A surface that the vertical meets.
  struct Hit {
    double height;
    int triangle, piece;
    bool faces_up;
  };
  // A place under a foot, from the middle of it, and the heights of what could be ground there.
  struct Beside {
    Eigen::Vector2d offset;
    double most = 0.0;  // that the ground may rise or fall on the way there [m]
    bool known = false;
    std::vector<double> heights = {};  // lowest first [m]
  };
  // To both sides of the middle.
  using Pair = std::array<Beside, 2>;

  Pair pairAlong(const Eigen::Vector2d& offset) const;
  void collect();
  void cross(int piece);
  bool hasRoom(double z);
  bool isStraight(double z, Pair& pair);
  std::optional<double> nearest(double z, Beside& beside);

  const Scene& scene_;
  const ScenePieces& pieces_;
  const TriangleGrid& all_;
  const std::vector<bool>& up_;
  const GroundSettings& settings_;
  std::array<std::array<Pair, 3>, kFootHeadings> feet_;
  Eigen::Vector2d at_{0, 0};
  std::vector<Hit> hits_;
  std::vector<Surface> surfaces_;
  // Of the vertical, where it is: which closed pieces it is in, of each object solids less hollows,
  // and objects in whose solid it is.
  std::vector<bool> inside_;
  std::vector<int> depth_;
  int solids_ = 0;
};

}  // namespace amble
