#include "viz/figure/loft_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace amble {

using Eigen::Vector3d;

namespace {

constexpr double kMostCells = 4e6;  // so that no body, however long its limbs, fills the memory
constexpr int kBlock = 4;           // cells a side of what is looked at, or left out, at once

Eigen::AlignedBox3d boundsOf(const std::vector<LoftGroup>& groups) {
  Eigen::AlignedBox3d box;
  for (const LoftGroup& group : groups)
    for (const Loft& loft : group.lofts)
      for (const LoftEnd& end : {loft.a, loft.b}) {
        const Vector3d reach = Vector3d::Constant(end.radius + end.half + loft.blend + group.blend);
        box.extend(end.at - reach);
        box.extend(end.at + reach);
      }
  return box;
}

class Marching {
 public:
  Marching(const std::vector<LoftGroup>& groups, double cell) : groups_(groups), cell_(cell) {
    const Eigen::AlignedBox3d box = boundsOf(groups);
    const double volume = (box.sizes().array() / cell + 2.0 * kBlock).prod();
    if (volume > kMostCells) cell_ *= std::cbrt(volume / kMostCells);
    for (int axis = 0; axis < 3; ++axis)
      blocks_[axis] = 1 + static_cast<int>(std::ceil(box.sizes()[axis] / (kBlock * cell_)));
    origin_ = box.min();
  }

  TriangleMesh make() {
    for (int z = 0; z < blocks_[2]; ++z)
      for (int y = 0; y < blocks_[1]; ++y)
        for (int x = 0; x < blocks_[0]; ++x) block({kBlock * x, kBlock * y, kBlock * z});
    return std::move(mesh_);
  }

 private:
  using Cell = std::array<int, 3>;

  Vector3d place(const Cell& c) const { return origin_ + cell_ * Vector3d(c[0], c[1], c[2]); }

  void block(const Cell& first) {
    constexpr int kSide = kBlock + 1;
    const double radius = 0.5 * std::sqrt(3.0) * kBlock * cell_;
    const Vector3d middle = place(first) + Vector3d::Constant(0.5 * kBlock * cell_);
    const double there = distanceTo(groups_, middle);
    if (std::abs(there) > 1.5 * radius) return;  // distances grow by little more than 1
    some_ = loftsNear(groups_, middle, radius, there);
    std::array<double, kSide * kSide * kSide> values;
    const auto value = [&](int x, int y, int z) -> double& {
      return values[(z * kSide + y) * kSide + x];
    };
    for (int z = 0; z < kSide; ++z)
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
          value(x, y, z) = distanceTo(some_, place({first[0] + x, first[1] + y, first[2] + z}));
    for (int z = 0; z < kBlock; ++z)
      for (int y = 0; y < kBlock; ++y)
        for (int x = 0; x < kBlock; ++x) {
          std::array<double, 8> corners;
          for (int i = 0; i < 8; ++i)
            corners[i] = value(x + (i & 1), y + ((i >> 1) & 1), z + (i >> 2));
          cube({first[0] + x, first[1] + y, first[2] + z}, corners);
        }
  }

  void cube(const Cell& cell, const std::array<double, 8>& values) {
    const int inside = static_cast<int>(
        std::count_if(values.begin(), values.end(), [](double v) { return v < 0.0; }));
    if (inside == 0 || inside == 8) return;
    // Along one axis after another from corner 0 to corner 7; positively oriented.
    static constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
        {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 3, 2, 7}, {0, 6, 4, 7}, {0, 5, 1, 7}}};
    for (const std::array<int, 4>& corners : kTetrahedra) tetrahedron(cell, corners, values);
  }

  void tetrahedron(const Cell& cell, const std::array<int, 4>& corners,
                   const std::array<double, 8>& values) {
    // Even permutations that begin with the corners that are inside, by which are (bits).
    static constexpr std::array<std::array<int, 4>, 16> kOrders = {{{0, 1, 2, 3},
                                                                    {0, 1, 2, 3},
                                                                    {1, 0, 3, 2},
                                                                    {0, 1, 2, 3},
                                                                    {2, 0, 1, 3},
                                                                    {0, 2, 3, 1},
                                                                    {1, 2, 0, 3},
                                                                    {3, 0, 2, 1},
                                                                    {3, 0, 2, 1},
                                                                    {0, 3, 1, 2},
                                                                    {1, 3, 2, 0},
                                                                    {2, 0, 1, 3},
                                                                    {2, 3, 0, 1},
                                                                    {1, 0, 3, 2},
                                                                    {0, 1, 2, 3},
                                                                    {0, 1, 2, 3}}};
    int bits = 0, inside = 0;
    for (int i = 0; i < 4; ++i) {
      if (!(values[corners[i]] < 0.0)) continue;
      bits |= 1 << i;
      ++inside;
    }
    if (inside == 0 || inside == 4) return;
    const std::array<int, 4>& order = kOrders[bits];
    const auto cut = [&](int i, int j) {
      return vertex(cell, corners[order[i]], corners[order[j]], values);
    };
    if (inside == 1) {
      add(cut(0, 1), cut(0, 2), cut(0, 3));
    } else if (inside == 3) {  // the order begins with the one that is outside
      add(cut(0, 1), cut(0, 3), cut(0, 2));
    } else {
      const int a = cut(0, 2), b = cut(0, 3), c = cut(1, 3), d = cut(1, 2);
      add(a, b, c);
      add(a, c, d);
    }
  }

  void add(int a, int b, int c) { mesh_.triangles.push_back({a, b, c}); }

  // Where the surface cuts the line between two corners: once, whichever tetrahedron asks.
  int vertex(const Cell& cell, int u, int v, const std::array<double, 8>& values) {
    if (u > v) std::swap(u, v);  // u's bits are among v's
    const Cell low = corner(cell, u), high = corner(cell, v);
    const std::int64_t sizes[2] = {blocks_[0] * kBlock + 1, blocks_[1] * kBlock + 1};
    const std::int64_t key = 8 * ((low[2] * sizes[1] + low[1]) * sizes[0] + low[0]) + (u ^ v);
    const auto [known, is_new] = index_.try_emplace(key, static_cast<int>(mesh_.vertices.size()));
    if (is_new) {
      // No nearer to a corner, so that no triangle is a needle; then straight onto the surface.
      constexpr double kEnd = 0.2;
      const double t = std::clamp(values[u] / (values[u] - values[v]), kEnd, 1.0 - kEnd);
      const Vector3d p = place(low) + t * (place(high) - place(low));
      mesh_.vertices.push_back(p - distanceTo(some_, p) * outwards(some_, p));
    }
    return known->second;
  }

  static Cell corner(const Cell& cell, int i) {
    return {cell[0] + (i & 1), cell[1] + ((i >> 1) & 1), cell[2] + (i >> 2)};
  }

  const std::vector<LoftGroup>& groups_;
  double cell_;
  std::array<int, 3> blocks_;
  std::vector<LoftGroup> some_;  // those that reach into the block at hand
  Vector3d origin_;
  std::unordered_map<std::int64_t, int> index_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh loftSurface(const std::vector<LoftGroup>& groups, double cell) {
  if (groups.empty()) return {};
  return Marching(groups, cell).make();
}

}  // namespace amble
