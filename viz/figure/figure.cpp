#include "viz/figure/figure.h"

#include <cmath>
#include <limits>

#include "viz/figure/figure_lofts.h"
#include "viz/figure/loft_surface.h"
#include "viz/figure/model_pose.h"
#include "viz/figure/simplify_mesh.h"
#include "viz/figure/skin_weights.h"

namespace amble {

using Eigen::Vector3d;

namespace {

// Of the mean man [m]: less than a hand is thick.
constexpr double kCell = 0.018;
constexpr double kReach = 0.035;
constexpr int kTriangles = 4000;

// Simplified, vertices lie beside the surface: back onto it. @return its normal there
Vector3d ontoSurface(Vector3d& p, const std::vector<LoftGroup>& groups) {
  const double beside = distanceTo(groups, p);
  const std::vector<LoftGroup> some = loftsNear(groups, p, std::abs(beside), beside);
  p -= beside * outwards(some, p);
  p -= distanceTo(some, p) * outwards(some, p);
  return outwards(some, p);
}

std::array<std::uint8_t, 3> colorAt(const std::vector<LoftGroup>& groups, const Vector3d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  std::array<std::uint8_t, 3> color{};
  for (const LoftGroup& group : groups)
    for (const Loft& loft : group.lofts) {
      const double distance = distanceTo(loft, p).distance;
      if (distance >= nearest) continue;
      nearest = distance;
      color = loft.color;
    }
  return color;
}

}  // namespace

Figure makeFigure(const Skeleton& skeleton, const Body& body) {
  Figure figure;
  figure.bind = modelPose(skeleton, body);
  const std::vector<LoftGroup> groups = figureLofts(body, figure.bind);
  if (groups.empty()) return figure;
  const double size = isPerson(body) ? sizeOf(body) : 1.0;
  TriangleMesh mesh = simplifyMesh(loftSurface(groups, kCell * size), kTriangles);
  for (Vector3d& p : mesh.vertices) figure.normals.push_back(ontoSurface(p, groups).cast<float>());
  SkinWeights skin = skinWeights(mesh, groups, skeleton, kReach * size);
  figure.joints = std::move(skin.joints);
  figure.weights = std::move(skin.weights);
  for (const Vector3d& p : mesh.vertices) {
    figure.vertices.push_back(p.cast<float>());
    figure.colors.push_back(colorAt(groups, p));
  }
  for (const auto& t : mesh.triangles)
    figure.triangles.push_back({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
                                static_cast<std::uint32_t>(t[2])});
  return figure;
}

}  // namespace amble
