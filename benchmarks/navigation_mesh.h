/// Recast and Detour as their users have them (RecastDemo's solo mesh, with its usual settings): a
/// mesh of polygons that a cylinder's axis may be in, and the shortest way over it. y is up there.
#pragma once

#include <DetourNavMesh.h>
#include <DetourNavMeshBuilder.h>
#include <DetourNavMeshQuery.h>
#include <Recast.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "base/rotation.h"
#include "environments/scene/scene.h"

namespace amble {

/// A scene's triangles as Recast takes them.
struct NavigationInput {
  std::vector<float> vertices;  ///< x, y, z of each
  std::vector<int> triangles;   ///< three a triangle

  explicit NavigationInput(const Scene& scene) {
    for (const SceneObject& object : scene.objects) {
      if (object.role == Role::kIgnore) continue;
      const TriangleMesh mesh = worldMesh(object);
      const int first = static_cast<int>(vertices.size() / 3);
      for (const Eigen::Vector3d& v : mesh.vertices)
        for (const double value : {v.x(), v.z(), -v.y()})
          vertices.push_back(static_cast<float>(value));
      for (const auto& t : mesh.triangles)
        for (const int corner : t) triangles.push_back(first + corner);
    }
  }
};

/// Whom the mesh is for.
struct NavigationAgent {
  double radius = 0.3, height = 1.75;  ///< [m, > 0]
  double climb = 0.25;                 ///< [m, >= 0]
  double slope = 20.0 * kDegree;       ///< steepest [rad]
};

class NavigationMesh {
 public:
  /// @param cell  of the heightfield, in plan [m, > 0]
  NavigationMesh(const NavigationInput& input, const NavigationAgent& agent, double cell) {
    rcContext context(false);
    const rcConfig config = configOf(input, agent, cell);
    const auto field = compactField(context, input, config);
    const Handle<rcContourSet> contours(rcAllocContourSet(), rcFreeContourSet);
    check(rcBuildContours(&context, *field, config.maxSimplificationError, config.maxEdgeLen,
                          *contours));
    const Handle<rcPolyMesh> mesh(rcAllocPolyMesh(), rcFreePolyMesh);
    check(rcBuildPolyMesh(&context, *contours, config.maxVertsPerPoly, *mesh));
    const Handle<rcPolyMeshDetail> detail(rcAllocPolyMeshDetail(), rcFreePolyMeshDetail);
    check(rcBuildPolyMeshDetail(&context, *mesh, *field, config.detailSampleDist,
                                config.detailSampleMaxError, *detail));
    polygons_ = mesh->npolys;
    take(*mesh, *detail, agent, config);
  }

  int polygons() const { return polygons_; }

  /// Length of the shortest way from one place to another, or none [m].
  std::optional<double> query(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    constexpr int kMost = 2048;  // polygons and corners of a way
    const std::array<float, 3> near = {0.5F, 0.5F, 0.5F};
    const std::array<float, 3> a = yUp(from), b = yUp(to);
    std::array<float, 3> start, end;
    dtPolyRef first = 0, last = 0;
    query_->findNearestPoly(a.data(), near.data(), &filter_, &first, start.data());
    query_->findNearestPoly(b.data(), near.data(), &filter_, &last, end.data());
    if (!first || !last) return std::nullopt;
    static thread_local std::array<dtPolyRef, kMost> corridor;
    static thread_local std::array<float, 3 * kMost> corners;
    int count = 0;
    query_->findPath(first, last, start.data(), end.data(), &filter_, corridor.data(), &count,
                     kMost);
    if (count == 0 || corridor[count - 1] != last) return std::nullopt;
    int points = 0;
    query_->findStraightPath(start.data(), end.data(), corridor.data(), count, corners.data(),
                             nullptr, nullptr, &points, kMost);
    double length = 0.0;
    for (int i = 3; i < 3 * points; i += 3)
      length += std::hypot(corners[i] - corners[i - 3], corners[i + 1] - corners[i - 2],
                           corners[i + 2] - corners[i - 1]);
    return length;
  }

 private:
  template <typename T>
  using Handle = std::unique_ptr<T, void (*)(T*)>;

  static std::array<float, 3> yUp(const Eigen::Vector3d& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.z()), static_cast<float>(-p.y())};
  }
  static void check(bool made) {
    if (!made) throw std::runtime_error("Recast or Detour made no mesh");
  }

  static rcConfig configOf(const NavigationInput& input, const NavigationAgent& agent,
                           double cell) {
    rcConfig config = {};
    config.cs = static_cast<float>(cell);
    config.ch = static_cast<float>(0.5 * cell);
    config.walkableSlopeAngle = static_cast<float>(agent.slope / kDegree);
    config.walkableHeight = static_cast<int>(std::ceil(agent.height / config.ch));
    config.walkableClimb = static_cast<int>(agent.climb / config.ch);
    config.walkableRadius = static_cast<int>(std::ceil(agent.radius / config.cs));
    config.maxEdgeLen = static_cast<int>(12.0F / config.cs);
    config.maxSimplificationError = 1.3F;
    config.minRegionArea = 8 * 8;
    config.mergeRegionArea = 20 * 20;
    config.maxVertsPerPoly = 6;
    config.detailSampleDist = 6.0F * config.cs;
    config.detailSampleMaxError = config.ch;
    rcCalcBounds(input.vertices.data(), static_cast<int>(input.vertices.size() / 3), config.bmin,
                 config.bmax);
    rcCalcGridSize(config.bmin, config.bmax, config.cs, &config.width, &config.height);
    return config;
  }

  // Where the agent's axis may be, by regions.
  static Handle<rcCompactHeightfield> compactField(rcContext& context, const NavigationInput& input,
                                                   const rcConfig& config) {
    const int vertices = static_cast<int>(input.vertices.size() / 3);
    const int triangles = static_cast<int>(input.triangles.size() / 3);
    std::vector<unsigned char> areas(triangles, 0);
    rcMarkWalkableTriangles(&context, config.walkableSlopeAngle, input.vertices.data(), vertices,
                            input.triangles.data(), triangles, areas.data());
    const Handle<rcHeightfield> solid(rcAllocHeightfield(), rcFreeHeightField);
    check(rcCreateHeightfield(&context, *solid, config.width, config.height, config.bmin,
                              config.bmax, config.cs, config.ch));
    check(rcRasterizeTriangles(&context, input.vertices.data(), vertices, input.triangles.data(),
                               areas.data(), triangles, *solid, config.walkableClimb));
    rcFilterLowHangingWalkableObstacles(&context, config.walkableClimb, *solid);
    rcFilterLedgeSpans(&context, config.walkableHeight, config.walkableClimb, *solid);
    rcFilterWalkableLowHeightSpans(&context, config.walkableHeight, *solid);
    Handle<rcCompactHeightfield> field(rcAllocCompactHeightfield(), rcFreeCompactHeightfield);
    check(rcBuildCompactHeightfield(&context, config.walkableHeight, config.walkableClimb, *solid,
                                    *field));
    check(rcErodeWalkableArea(&context, config.walkableRadius, *field));
    check(rcBuildDistanceField(&context, *field));
    check(rcBuildRegions(&context, *field, 0, config.minRegionArea, config.mergeRegionArea));
    return field;
  }

  void take(rcPolyMesh& mesh, const rcPolyMeshDetail& detail, const NavigationAgent& agent,
            const rcConfig& config) {
    for (int i = 0; i < mesh.npolys; ++i) mesh.flags[i] = mesh.areas[i] == RC_NULL_AREA ? 0 : 1;
    dtNavMeshCreateParams params = {};
    params.verts = mesh.verts;
    params.vertCount = mesh.nverts;
    params.polys = mesh.polys;
    params.polyAreas = mesh.areas;
    params.polyFlags = mesh.flags;
    params.polyCount = mesh.npolys;
    params.nvp = mesh.nvp;
    params.detailMeshes = detail.meshes;
    params.detailVerts = detail.verts;
    params.detailVertsCount = detail.nverts;
    params.detailTris = detail.tris;
    params.detailTriCount = detail.ntris;
    params.walkableHeight = static_cast<float>(agent.height);
    params.walkableRadius = static_cast<float>(agent.radius);
    params.walkableClimb = static_cast<float>(agent.climb);
    rcVcopy(params.bmin, mesh.bmin);
    rcVcopy(params.bmax, mesh.bmax);
    params.cs = config.cs;
    params.ch = config.ch;
    params.buildBvTree = true;
    unsigned char* data = nullptr;
    int size = 0;
    check(dtCreateNavMeshData(&params, &data, &size));
    check(dtStatusSucceed(mesh_->init(data, size, DT_TILE_FREE_DATA)));
    check(dtStatusSucceed(query_->init(mesh_.get(), 65535)));
  }

  int polygons_ = 0;
  Handle<dtNavMesh> mesh_{dtAllocNavMesh(), dtFreeNavMesh};
  Handle<dtNavMeshQuery> query_{dtAllocNavMeshQuery(), dtFreeNavMeshQuery};
  dtQueryFilter filter_;
};

}  // namespace amble
