#include "viz/figure/skin_weights.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/environments/test_walker.h"
#include "tests/viz/figure/lofts.h"
#include "viz/figure/figure_lofts.h"
#include "viz/figure/loft_surface.h"
#include "viz/figure/model_pose.h"

namespace amble {
namespace {

using Eigen::Vector3d;

constexpr double kReach = 0.035;

Joint jointOf(const char* name, int parent, const Vector3d& offset) {
  Joint joint;
  joint.name = name;
  joint.parent = parent;
  joint.offset = offset;
  return joint;
}

Loft barOf(const Vector3d& from, const Vector3d& to, std::array<int, 2> joints) {
  Loft loft;
  loft.a = {from, 0.04};
  loft.b = {to, 0.04};
  loft.joints = joints;
  loft.across = Vector3d::UnitZ();
  return loft;
}

// A chain of three bones along x: 0 at 0, 1 at 0.3, 2 at 0.6 m.
struct Chain {
  Skeleton skeleton{
      {jointOf("a", -1, {0, 0, 0}), jointOf("b", 0, {0.3, 0, 0}), jointOf("c", 1, {0.3, 0, 0})}};
  std::vector<LoftGroup> groups = {
      {{barOf({0, 0, 0}, {0.3, 0, 0}, {0, 1}), barOf({0.3, 0, 0}, {0.6, 0, 0}, {1, 2}),
        barOf({0.6, 0, 0}, {0.8, 0, 0}, {2, 2})},
       0.01,
       {}}};
  TriangleMesh mesh = loftSurface(groups, 0.015);
  SkinWeights weights = skinWeights(mesh, groups, skeleton, kReach);
};

double shareOf(const SkinWeights& weights, size_t vertex, int joint) {
  double share = 0.0;
  for (int k = 0; k < 4; ++k)
    if (weights.joints[vertex][k] == joint) share += weights.weights[vertex][k];
  return share;
}

void expectShares(const SkinWeights& weights, const Skeleton& skeleton) {
  for (size_t i = 0; i < weights.weights.size(); ++i) {
    float sum = 0.0F;
    std::set<int> seen;
    for (int k = 0; k < 4; ++k) {
      const float weight = weights.weights[i][k];
      sum += weight;
      EXPECT_GE(weight, 0.0F);
      if (k > 0) {
        EXPECT_LE(weight, weights.weights[i][k - 1]);
      }
      EXPECT_LT(weights.joints[i][k], skeleton.size());
      if (weight > 0.0F) {
        EXPECT_TRUE(seen.insert(weights.joints[i][k]).second) << i;
      }
    }
    EXPECT_NEAR(sum, 1.0F, 1e-6F);
  }
}

TEST(SkinWeights, FallAndSumToOneOverDistinctJoints) {
  const Chain chain;
  ASSERT_EQ(chain.weights.joints.size(), chain.mesh.vertices.size());
  expectShares(chain.weights, chain.skeleton);
  const TestWalker walker;
  const auto groups = figureLofts(walker.body, modelPose(walker.skeleton, walker.body));
  const TriangleMesh mesh = loftSurface(groups, 0.04);
  expectShares(skinWeights(mesh, groups, walker.skeleton, kReach), walker.skeleton);
}

TEST(SkinWeights, AJointsShareIsMostWhereItIsAndGoesOverToTheNext) {
  const Chain chain;
  for (size_t i = 0; i < chain.mesh.vertices.size(); ++i) {
    const double x = chain.mesh.vertices[i].x();
    if (x < 0.05) {
      EXPECT_GT(shareOf(chain.weights, i, 0), 0.8) << x;
    }
    if (std::abs(x - 0.3) < 0.02) {
      EXPECT_GT(shareOf(chain.weights, i, 1), 0.6) << x;
    }
    if (x > 0.7) {
      EXPECT_GT(shareOf(chain.weights, i, 2), 0.9) << x;
    }
  }
  // Along the first bone the second joint's share grows.
  std::map<int, std::pair<double, int>> by_place;
  for (size_t i = 0; i < chain.mesh.vertices.size(); ++i) {
    const double x = chain.mesh.vertices[i].x();
    if (x < 0.0 || x > 0.28) continue;
    auto& [sum, count] = by_place[static_cast<int>(x / 0.05)];
    sum += shareOf(chain.weights, i, 1);
    ++count;
  }
  double before = -1.0;
  for (const auto& [place, mean] : by_place) {
    EXPECT_GT(mean.first / mean.second, before) << place;
    before = mean.first / mean.second;
  }
}

TEST(SkinWeights, NeighboursHangOnNearlyTheSame) {
  const Chain chain;
  for (const auto& t : chain.mesh.triangles)
    for (int i = 0; i < 3; ++i)
      for (int joint = 0; joint < 3; ++joint)
        EXPECT_NEAR(shareOf(chain.weights, t[i], joint),
                    shareOf(chain.weights, t[(i + 1) % 3], joint), 0.2);
}

// Two arms of a tree that come near to one another: neither pulls at the other.
TEST(SkinWeights, ALimbThatOnlyComesNearPullsAtNothing) {
  const Skeleton skeleton({jointOf("root", -1, {0, 0, 0}), jointOf("left", 0, {0, 0.5, 0}),
                           jointOf("right", 0, {0, -0.5, 0}),
                           jointOf("left tip", 1, {0.5, -0.4, 0}),
                           jointOf("right tip", 2, {0.5, 0.4, 0})});
  const std::vector<LoftGroup> groups = {
      {{barOf({0, 0, 0}, {0, 0.5, 0}, {0, 1}), barOf({0, 0.5, 0}, {0.5, 0.06, 0}, {1, 3})},
       0.01,
       {}},
      {{barOf({0, 0, 0}, {0, -0.5, 0}, {0, 2}), barOf({0, -0.5, 0}, {0.5, -0.06, 0}, {2, 4})},
       0.01,
       {}}};
  const TriangleMesh mesh = loftSurface(groups, 0.012);
  const SkinWeights weights = skinWeights(mesh, groups, skeleton, kReach);
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vector3d& p = mesh.vertices[i];
    if (p.x() < 0.4) continue;  // the tips
    EXPECT_EQ(shareOf(weights, i, p.y() > 0.0 ? 4 : 3), 0.0) << p.transpose();
  }
}

TEST(SkinWeights, OfOneJointAreAllItsOwn) {
  const Skeleton skeleton({jointOf("only", -1, {0, 0, 0})});
  const std::vector<LoftGroup> groups = {{{barOf({0, 0, 0}, {0.2, 0, 0}, {0, 0})}, 0.01, {}}};
  const TriangleMesh mesh = loftSurface(groups, 0.03);
  for (const auto& weights : skinWeights(mesh, groups, skeleton, kReach).weights)
    EXPECT_EQ(weights, (std::array<float, 4>{1, 0, 0, 0}));
}

// Left and right of a person are each other's mirror image.
TEST(SkinWeights, AreMirroredAsTheBodyIs) {
  const TestWalker walker;
  const auto groups = figureLofts(walker.body, modelPose(walker.skeleton, walker.body));
  std::vector<int> other(walker.skeleton.size());
  for (int j = 0; j < walker.skeleton.size(); ++j) {
    std::string name = walker.skeleton.joint(j).name;
    if (name.starts_with("Left"))
      name.replace(0, 4, "Right");
    else if (name.starts_with("Right"))
      name.replace(0, 5, "Left");
    for (int k = 0; k < walker.skeleton.size(); ++k)
      if (walker.skeleton.joint(k).name == name) other[j] = k;
  }
  Generator random(40);
  TriangleMesh points, mirrored;  // without triangles: nothing is evened out
  for (int i = 0; i < 400; ++i) {
    points.vertices.push_back(randomVector(random, 0.9));
    mirrored.vertices.push_back(points.vertices.back().cwiseProduct(Vector3d(1, -1, 1)));
  }
  const SkinWeights a = skinWeights(points, groups, walker.skeleton, kReach);
  const SkinWeights b = skinWeights(mirrored, groups, walker.skeleton, kReach);
  for (size_t i = 0; i < points.vertices.size(); ++i)
    for (int j = 0; j < walker.skeleton.size(); ++j)
      EXPECT_NEAR(shareOf(a, i, j), shareOf(b, i, other[j]), 1e-4)
          << points.vertices[i].transpose();
}

}  // namespace
}  // namespace amble
