/// What is drawn, as triangles: scene objects, bodies, decals on the floor.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "environments/scene/mesh.h"
#include "viz/figure/figure.h"
#include "viz/pictures/rasterizer.h"
#include "viz/walk_view.h"

namespace amble {

/// Corner normals of a mesh, three a triangle: smooth over edges flatter than `crease`, sharp
/// elsewhere [rad].
std::vector<Eigen::Vector3f> cornerNormals(const TriangleMesh& mesh, double crease);

/// Its triangles, without flags. Cost: linear.
std::vector<DrawTriangle> drawnMesh(const TriangleMesh& mesh, const Color& color);

void addMesh(const TriangleMesh& mesh, const Color& color, uint8_t flags,
             std::vector<DrawTriangle>& triangles);

void addCapsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                const Color& color, std::vector<DrawTriangle>& triangles);

/// The capsules of a body as smooth meshes; `colors` one a part.
void addBody(const WalkView& view, int frame, std::span<const Color> colors,
             std::vector<DrawTriangle>& triangles);

/// The figure of the view's body, in its own colours. @pre view.hasBody()
void addFigure(const WalkView& view, int frame, const Figure& figure,
               std::vector<DrawTriangle>& triangles);

/// A polygon (a fan about its middle) lying at `height`, drawn over the floor.
void addPolygon(std::span<const Eigen::Vector2d> outline, double height, const Color& color,
                std::vector<DrawTriangle>& triangles);

/// A polyline as a ribbon of `width` lying at `height` [m].
void addRibbon(std::span<const Eigen::Vector2d> line, double width, double height,
               const Color& color, std::vector<DrawTriangle>& triangles);

}  // namespace amble
