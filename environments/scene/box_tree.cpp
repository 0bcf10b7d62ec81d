#include "environments/scene/box_tree.h"

#include <algorithm>

namespace amble {
namespace {

constexpr int kFew = 4;  // items that are looked at one by one; by trial

}  // namespace

BoxTree::BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes) {
  for (size_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].isEmpty()) items_.push_back(static_cast<int>(i));
  if (!items_.empty()) build(boxes, 0, static_cast<int>(items_.size()));
  for (const int item : items_) boxes_.push_back(boxes[item]);
}

void BoxTree::build(const std::vector<Eigen::AlignedBox3d>& boxes, int begin, int end) {
  const size_t here = nodes_.size();
  nodes_.push_back({{}, begin, end, 0});
  Eigen::AlignedBox3d middles;
  for (int k = begin; k < end; ++k) {
    nodes_[here].box.extend(boxes[items_[k]]);
    middles.extend(Eigen::Vector3d(boxes[items_[k]].center()));
  }
  if (end - begin > kFew) {
    Eigen::Index axis;
    middles.sizes().maxCoeff(&axis);
    const int half = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + half, items_.begin() + end,
                     [&](int a, int b) {
                       const double at = boxes[a].min()[axis] + boxes[a].max()[axis];
                       const double bt = boxes[b].min()[axis] + boxes[b].max()[axis];
                       return at != bt ? at < bt : a < b;
                     });
    nodes_[here].end = begin;  // what is below holds the items
    build(boxes, begin, half);
    build(boxes, half, end);
  }
  nodes_[here].skip = static_cast<int>(nodes_.size());
}

void BoxTree::find(const Eigen::AlignedBox3d& box, std::vector<int>& found) const {
  found.clear();
  for (size_t n = 0; n < nodes_.size();) {
    const Node& node = nodes_[n];
    if (!node.box.intersects(box)) {
      n = static_cast<size_t>(node.skip);
      continue;
    }
    for (int k = node.begin; k < node.end; ++k)
      if (boxes_[k].intersects(box)) found.push_back(items_[k]);
    ++n;
  }
  std::sort(found.begin(), found.end());
}

}  // namespace amble
