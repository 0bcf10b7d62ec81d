#include "viz/pictures/thin_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

namespace amble {
namespace {

double volume(const TriangleMesh& mesh) {
  double six = 0.0;
  for (const auto& t : mesh.triangles)
    six += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
  return six / 6.0;
}

TEST(ThinMesh, NothingMovesByMoreThanACell) {
  const TriangleMesh ball = makeSphere(1.0, 200);
  const double cell = 0.1;
  const TriangleMesh thin = thinMesh(ball, cell);
  EXPECT_LT(thin.triangles.size(), ball.triangles.size() / 4);
  for (const Eigen::Vector3d& p : thin.vertices) {
    EXPECT_LE(p.norm(), 1.0 + 1e-9);
    EXPECT_GE(p.norm(), 1.0 - std::sqrt(3.0) * cell);
  }
  EXPECT_NEAR(volume(thin), volume(ball), 0.05 * volume(ball));
}

TEST(ThinMesh, AClosedSurfaceKeepsItsSides) {
  const TriangleMesh thin = thinMesh(makeSphere(1.0, 100), 0.15);
  std::map<std::pair<int, int>, int> directed;
  for (const auto& t : thin.triangles)
    for (int i = 0; i < 3; ++i) ++directed[{t[i], t[(i + 1) % 3]}];
  for (const auto& [edge, count] : directed) {
    const auto back = directed.find({edge.second, edge.first});
    ASSERT_NE(back, directed.end());
    EXPECT_EQ(back->second, count);
  }
}

TEST(ThinMesh, TheCellIsTheFirstThatIsEnough) {
  const TriangleMesh ball = makeSphere(1.0, 300);
  const std::vector<const TriangleMesh*> meshes = {&ball, &ball};
  EXPECT_EQ(thinningCell(meshes, 2 * ball.triangles.size()), 0.0);
  const double cell = thinningCell(meshes, 5000);
  ASSERT_GT(cell, 0.0);
  EXPECT_LE(2 * thinMesh(ball, cell).triangles.size(), 5000u);
  EXPECT_GT(2 * thinMesh(ball, cell / 1.5).triangles.size(), 5000u);
}

TEST(ThinMesh, ManyThingsThatCannotBeThinnedEndTheSearch) {
  const TriangleMesh box =
      makeBox({1.0, 1.0, 1.0});  // about the origin: in eight cells of any size
  const std::vector<const TriangleMesh*> meshes(100, &box);
  EXPECT_GT(thinningCell(meshes, 10), 1.0);
}

}  // namespace
}  // namespace amble
