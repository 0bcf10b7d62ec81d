/// A tree of axis-aligned boxes: which of many a box meets, without looking at all of them.
///
/// Halved at the middle item along the widest axis of their middles, down to a few; in one array, a
/// node before what is below it. Built in O(n log^2 n), asked in O(log n + what is found) where
/// boxes are spread out.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace amble {

class BoxTree {
 public:
  BoxTree() = default;
  /// Empty boxes are met by nothing.
  explicit BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes);

  /// The numbers of the boxes that `box` meets, touching included, ascending, into `found`.
  void find(const Eigen::AlignedBox3d& box, std::vector<int>& found) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int begin, end;  // of its items
    int skip;        // the node that follows where nothing below is met
  };
  void build(const std::vector<Eigen::AlignedBox3d>& boxes, int begin, int end);

  std::vector<Node> nodes_;
  std::vector<int> items_;                  // numbers of boxes
  std::vector<Eigen::AlignedBox3d> boxes_;  // of the items
};

}  // namespace amble
