/// Furniture in tests: its boxes, its connected surfaces, their volumes.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "base/union_find.h"
#include "environments/furniture/furniture.h"

namespace amble {

inline std::vector<Furniture> allPieces() {
  auto pieces = makeLivingRoomFurniture();
  pieces.push_back(makeCupboard());
  return pieces;
}

inline Eigen::AlignedBox3d boxOf(const Surface& surface) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : surface.vertices) box.extend(p);
  return box;
}

/// Of the group of that name, or of all.
inline Eigen::AlignedBox3d boxOf(const Furniture& piece, const std::string& group = "") {
  Eigen::AlignedBox3d box;
  for (const auto& [name, surface] : piece.groups)
    if (group.empty() || name == group) box.extend(boxOf(surface));
  return box;
}

inline Surface groupOf(const Furniture& piece, const std::string& group) {
  for (const auto& [name, surface] : piece.groups)
    if (name == group) return surface;
  ADD_FAILURE() << piece.name << " has no " << group;
  return {};
}

/// Its connected surfaces, in the order of their first vertices.
inline std::vector<Surface> componentsOf(const Surface& surface) {
  UnionFind joined(static_cast<int>(surface.vertices.size()));
  for (const auto& t : surface.triangles) {
    joined.join(t[0], t[1]);
    joined.join(t[0], t[2]);
  }
  std::map<int, Surface> components;
  std::vector<int> index(surface.vertices.size());
  for (int v = 0; v < joined.size(); ++v) {
    Surface& own = components[joined.find(v)];
    index[v] = static_cast<int>(own.vertices.size());
    own.vertices.push_back(surface.vertices[v]);
  }
  for (const auto& t : surface.triangles)
    components[joined.find(t[0])].triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
  std::vector<Surface> list;
  for (auto& [first, component] : components) list.push_back(std::move(component));
  return list;
}

inline std::vector<Surface> componentsOf(const Furniture& piece) {
  std::vector<Surface> all;
  for (const auto& [name, surface] : piece.groups)
    for (Surface& component : componentsOf(surface)) all.push_back(std::move(component));
  return all;
}

/// Of a closed surface that is wound outwards [m^3].
inline double volumeOf(const Surface& surface) {
  double six_times = 0.0;
  for (const auto& t : surface.triangles) {
    const auto &a = surface.vertices[t[0]], &b = surface.vertices[t[1]],
               &c = surface.vertices[t[2]];
    six_times += a.dot(b.cross(c));
  }
  return six_times / 6.0;
}

/// Of what it encloses, of one density [m].
inline Eigen::Vector3d centroidOf(const Surface& surface) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& t : surface.triangles) {
    const auto &a = surface.vertices[t[0]], &b = surface.vertices[t[1]],
               &c = surface.vertices[t[2]];
    sum += a.dot(b.cross(c)) / 24.0 * (a + b + c);
  }
  return sum / volumeOf(surface);
}

/// Whether every vertex has another one where a mirror at x = 0 shows it, to a micrometre.
inline bool isSymmetric(const Surface& surface) {
  constexpr double kUnit = 1e-5;  // [m]
  std::map<std::array<long, 3>, int> places;
  const auto key = [&](double x, double y, double z) {
    return std::array<long, 3>{std::lround(x / kUnit), std::lround(y / kUnit),
                               std::lround(z / kUnit)};
  };
  for (const auto& p : surface.vertices) ++places[key(p.x(), p.y(), p.z())];
  for (const auto& p : surface.vertices) {
    bool found = false;
    for (int i = 0; i < 27 && !found; ++i) {  // a rounding off at most
      auto near = key(-p.x(), p.y(), p.z());
      near[0] += i % 3 - 1;
      near[1] += i / 3 % 3 - 1;
      near[2] += i / 9 - 1;
      found = places.count(near) > 0;
    }
    if (!found) return false;
  }
  return true;
}

}  // namespace amble
