#include "environments/collision/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "environments/collision/segment_distance.h"

namespace amble {
namespace {

constexpr int kFew = 4;         // triangles of a leaf at most; by trial
constexpr size_t kStack = 256;  // nodes that wait: 7 more a level, of which 2^31 triangles have 11
// Relative to the largest coordinate: what a difference of two floats may be wrong by, twice over.
constexpr double kFloatError = 4e-7;
constexpr float kNever = std::numeric_limits<float>::infinity();

float roundedDown(double x) {
  const float f = static_cast<float>(x);
  return f > x ? std::nextafter(f, -kNever) : f;
}
float roundedUp(double x) { return -roundedDown(-x); }

Eigen::AlignedBox3d boxOf(const Triangle3& t) {
  Eigen::AlignedBox3d box(t[0]);
  box.extend(t[1]);
  box.extend(t[2]);
  return box;
}

// A capsule as nodes are asked about it.
struct Question {
  std::array<float, 3> min, max, middle;  // of its axis

  explicit Question(const Capsule& capsule) {
    for (int k = 0; k < 3; ++k) {
      min[k] = static_cast<float>(std::min(capsule.from[k], capsule.to[k]));
      max[k] = static_cast<float>(std::max(capsule.from[k], capsule.to[k]));
      middle[k] = static_cast<float>(0.5 * (capsule.from[k] + capsule.to[k]));
    }
  }
};

}  // namespace

struct TriangleTree::Order {
  struct Item {
    Eigen::Vector3d twice_middle;  // of the triangle's box [m]
    int triangle;
  };
  const TriangleMesh& mesh;
  std::vector<Item> items;

  explicit Order(const TriangleMesh& of) : mesh(of) {
    items.reserve(mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      const Eigen::AlignedBox3d box = boxOf(cornersOf(t));
      items.push_back({box.min() + box.max(), t});
    }
  }
  Triangle3 cornersOf(int triangle) const {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
  }
};

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return;
  Order order(mesh);
  build(order, 0, static_cast<int>(order.items.size()));
  triangles_.reserve(order.items.size());
  for (const Order::Item& item : order.items) {
    triangles_.push_back(order.cornersOf(item.triangle));
    for (const Eigen::Vector3d& corner : triangles_.back())
      farthest_ = std::max(farthest_, corner.cwiseAbs().maxCoeff());
  }
}

// Halves at the middle along the widest axis, three times over.
int TriangleTree::build(Order& order, int begin, int end) {
  const int node = static_cast<int>(nodes_.size());
  Node& empty = nodes_.emplace_back();
  for (std::array<float, kWide>& min : empty.min) min.fill(kNever);
  for (std::array<float, kWide>& max : empty.max) max.fill(-kNever);
  empty.first.fill(-1);
  empty.count.fill(0);
  std::array<int, kWide + 1> cut;
  cut.fill(end);
  cut[0] = begin;
  for (int span = kWide; span > 1; span /= 2) {
    for (int child = 0; child < kWide; child += span) {
      const int first = cut[child], last = cut[child + span];
      cut[child + span / 2] = last;
      if (last - first <= kFew) continue;
      Eigen::AlignedBox3d middles;
      for (int i = first; i < last; ++i) middles.extend(order.items[i].twice_middle);
      Eigen::Index axis;
      middles.sizes().maxCoeff(&axis);
      const int half = first + (last - first) / 2;
      const auto items = order.items.begin();
      std::nth_element(items + first, items + half, items + last,
                       [axis](const Order::Item& a, const Order::Item& b) {
                         const double at = a.twice_middle[axis], bt = b.twice_middle[axis];
                         return at != bt ? at < bt : a.triangle < b.triangle;
                       });
      cut[child + span / 2] = half;
    }
  }
  for (int child = 0; child < kWide; ++child)
    if (cut[child] < cut[child + 1]) addChild(node, child, order, cut[child], cut[child + 1]);
  return node;
}

void TriangleTree::addChild(int node, int child, Order& order, int begin, int end) {
  Eigen::AlignedBox3d box;
  for (int i = begin; i < end; ++i) box.extend(boxOf(order.cornersOf(order.items[i].triangle)));
  const bool leaf = end - begin <= kFew;
  const int first = leaf ? begin : build(order, begin, end);  // which moves the nodes
  Node& parent = nodes_[node];
  for (int axis = 0; axis < 3; ++axis) {
    parent.min[axis][child] = roundedDown(box.min()[axis]);
    parent.max[axis][child] = roundedUp(box.max()[axis]);
  }
  parent.first[child] = first;
  parent.count[child] = leaf ? end - begin : 0;
}

// Shows leaf(first, count) what may be no farther from the capsule's axis than `reach`, which may
// shrink meanwhile, near ones first; ends where that says so.
template <typename Leaf>
void TriangleTree::search(const Capsule& capsule, const double& reach, Leaf leaf) const {
  if (nodes_.empty()) return;
  struct Waiting {
    float near;  // squared distance of the axis' middle to the box [m^2]
    int32_t first, count;
  };
  const Question q(capsule);
  const double half = 0.5 * (capsule.to - capsule.from).norm();
  const double slack = kFloatError * std::max({farthest_, capsule.from.cwiseAbs().maxCoeff(),
                                               capsule.to.cwiseAbs().maxCoeff()});
  const auto squared = [&](double length) {
    const double wide = (length + slack) * (1.0 + 1e-6);
    return static_cast<float>(std::min(wide * wide, 1e38));
  };
  std::array<Waiting, kStack> stack;
  size_t waiting = 0;
  stack[waiting++] = {0.0f, 0, 0};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.near > squared(half + reach)) continue;
    if (next.count > 0) {
      if (leaf(next.first, next.count)) return;
      continue;
    }
    const Node& node = nodes_[next.first];
    std::array<float, kWide> near{}, gap{};
    for (int axis = 0; axis < 3; ++axis) {
      const float low = q.min[axis], high = q.max[axis], middle = q.middle[axis];
      for (int k = 0; k < kWide; ++k) {
        const float min = node.min[axis][k], max = node.max[axis][k];
        const float away = std::max(std::max(min - middle, middle - max), 0.0f);
        const float apart = std::max(std::max(min - high, low - max), 0.0f);
        near[k] += away * away;
        gap[k] += apart * apart;
      }
    }
    const float most_near = squared(half + reach), most_gap = squared(reach);
    const size_t begin = waiting;
    for (int k = 0; k < kWide; ++k) {
      if (!(near[k] <= most_near && gap[k] <= most_gap)) continue;
      size_t at = waiting++;
      for (; at > begin && stack[at - 1].near < near[k]; --at) stack[at] = stack[at - 1];
      stack[at] = {near[k], node.first[k], node.count[k]};
    }
  }
}

bool TriangleTree::touches(const Capsule& capsule) const {
  const Segment axis{capsule.from, capsule.to};
  const double square = capsule.radius * capsule.radius;
  bool found = false;
  search(capsule, capsule.radius, [&](int first, int count) {
    for (int i = first; i < first + count && !found; ++i)
      found = isWithin(square, axis, triangles_[i]);
    return found;
  });
  return found;
}

double TriangleTree::distance(const Capsule& capsule, double limit) const {
  const Segment axis{capsule.from, capsule.to};
  double reach = capsule.radius + limit, nearest = limit;
  search(capsule, reach, [&](int first, int count) {
    for (int i = first; i < first + count; ++i) {
      const double square = squaredDistance(axis, triangles_[i]);
      if (square >= reach * reach) continue;
      reach = std::sqrt(square);
      nearest = std::min(nearest, std::max(0.0, reach - capsule.radius));
    }
    return reach <= capsule.radius;
  });
  return nearest;
}

}  // namespace amble
