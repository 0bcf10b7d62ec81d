// What holds of any scene's shapes: inside and outside, pieces and bounds do not depend on how a
// surface is cut up, ordered, wound or placed.
#include <gtest/gtest.h>

#include <cmath>

#include "environments/scene/box_tree.h"
#include "environments/scene/parity_column.h"
#include "environments/scene/scene_pieces.h"
#include "tests/environments/random_scenes.h"

namespace amble {
namespace {

// A primitive of any kind, and whether p, in its frame, lies in it; `off` is how far p is from its
// surface at least, for points that chords cut off.
struct DrawnShape {
  Shape shape;
  Eigen::AlignedBox3d box;

  explicit DrawnShape(SampleStream& random, int kind) {
    const double r = random.uniform(0.3, 1.0), h = random.uniform(0.4, 1.5);
    if (kind == 0) shape = Box{{r, h, random.uniform(0.2, 1.0)}};
    if (kind == 1) shape = Cylinder{r, h};
    if (kind == 2) shape = Sphere{r};
    if (kind == 3) shape = CapsuleShape{r, 2.0 * r + h};
    box = worldBounds(shape, Eigen::Isometry3d::Identity());
  }
  /// Signed distance to the surface in its frame, negative within; of a box and a cylinder no
  /// larger than it is.
  double off(const Eigen::Vector3d& p) const {
    if (const auto* b = std::get_if<Box>(&shape)) return (p.cwiseAbs() - 0.5 * b->size).maxCoeff();
    if (const auto* c = std::get_if<Cylinder>(&shape))
      return std::max(p.head<2>().norm() - c->radius, std::abs(p.z()) - 0.5 * c->height);
    if (const auto* s = std::get_if<Sphere>(&shape)) return p.norm() - s->radius;
    const auto& c = std::get<CapsuleShape>(shape);
    const double z = std::max(0.0, std::abs(p.z()) - (0.5 * c.height - c.radius));
    return std::hypot(p.head<2>().norm(), z) - c.radius;
  }
};

Eigen::Isometry3d drawnPlace(SampleStream& random) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = expRotation(drawnVector(random, 3.0)).toRotationMatrix();
  X.translation() = drawnVector(random, 4.0);
  return X;
}

SceneObject placed(const Shape& shape, const Eigen::Isometry3d& X_WO) {
  SceneObject object = makeObject("it", shape, {0, 0, 0});
  object.X_WO = X_WO;
  return object;
}

template <typename Visit>
void forDrawnShapes(std::uint64_t seed, Visit visit) {
  SampleStream random(seed, 0);
  for (int n = 0; n < 16; ++n) visit(DrawnShape(random, n % 4), drawnPlace(random), random);
}

// Chords of round things lie a little within them [m].
constexpr double kChord = 0.02;

TEST(SceneLaws, InsideTheMeshOfAPrimitiveIsInsideThePrimitive) {
  forDrawnShapes(1, [](const DrawnShape& drawn, const Eigen::Isometry3d& X, SampleStream& random) {
    const Parity parity(SolidMesh(worldMesh(placed(drawn.shape, X))));
    int inside = 0;
    for (int n = 0; n < 300; ++n) {
      const Eigen::Vector3d p = drawnPoint(random, drawn.box);
      const double off = drawn.off(p);
      if (std::abs(off) < kChord) continue;
      inside += off < 0.0;
      EXPECT_EQ(parity.inside(X * p), off < 0.0) << p.transpose() << " " << off;
    }
    EXPECT_GT(inside, 20);
  });
}

TEST(SceneLaws, InsideDoesNotDependOnHowASurfaceIsCutUpOrderedOrWound) {
  forDrawnShapes(2, [](const DrawnShape& drawn, const Eigen::Isometry3d& X, SampleStream& random) {
    const TriangleMesh mesh = worldMesh(placed(drawn.shape, X));
    const Parity usual((SolidMesh(mesh))), shuffled_one(SolidMesh(shuffled(mesh, random)));
    const Parity fine(SolidMesh(subdivided(mesh, random))), inside_out(SolidMesh(turned(mesh)));
    for (int n = 0; n < 200; ++n) {
      const Eigen::Vector3d p = drawnPoint(random, drawn.box);
      if (std::abs(drawn.off(p)) < kChord) continue;
      const bool inside = usual.inside(X * p);
      EXPECT_EQ(shuffled_one.inside(X * p), inside);
      EXPECT_EQ(fine.inside(X * p), inside);
      EXPECT_EQ(inside_out.inside(X * p), inside);
    }
  });
}

TEST(SceneLaws, InsideOfAShrunkMeshIsInsideOfTheMesh) {
  forDrawnShapes(3, [](const DrawnShape& drawn, const Eigen::Isometry3d& X, SampleStream& random) {
    TriangleMesh mesh = worldMesh(placed(drawn.shape, X)), small = mesh;
    for (Eigen::Vector3d& v : small.vertices) v = X.translation() + 0.7 * (v - X.translation());
    const Parity whole((SolidMesh(mesh))), shrunk((SolidMesh(small)));
    for (int n = 0; n < 150; ++n) {
      const Eigen::Vector3d p = X * drawnPoint(random, drawn.box);
      if (shrunk.inside(p)) {
        EXPECT_TRUE(whole.inside(p));
      }
      const Eigen::Vector3d q = X.translation() + 0.7 * (p - X.translation());
      if (std::abs(drawn.off(X.inverse() * p)) < kChord) continue;
      EXPECT_EQ(shrunk.inside(q), whole.inside(p));
    }
  });
}

TEST(SceneLaws, AlongAVerticalCrossingsAreWhereInsideChanges) {
  forDrawnShapes(4, [](const DrawnShape& drawn, const Eigen::Isometry3d& X, SampleStream& random) {
    const Parity parity(SolidMesh(worldMesh(placed(drawn.shape, X))));
    std::vector<Parity::Crossing> crossings;
    const Eigen::Vector3d p = X * (0.5 * drawnPoint(random, drawn.box));
    EXPECT_EQ(parity.addCrossings(p, crossings), 0);
    std::vector<double> heights;
    int depth = 0;
    for (const Parity::Crossing& crossing : crossings) {
      heights.push_back(crossing.height);
      depth += crossing.change;
    }
    EXPECT_EQ(depth, 0) << "what goes in comes out";
    std::sort(heights.begin(), heights.end());
    const auto above = heights.end() - std::upper_bound(heights.begin(), heights.end(), p.z());
    EXPECT_EQ(parity.inside(p), above % 2 == 1);
    if (heights.empty()) return;
    EXPECT_GE(heights.front(), parity.bounds().min().z() - 1e-9);
    EXPECT_LE(heights.back(), parity.bounds().max().z() + 1e-9);
  });
}

TEST(SceneLaws, NothingBeyondTheBoundsIsInside) {
  forDrawnShapes(5, [](const DrawnShape& drawn, const Eigen::Isometry3d& X, SampleStream& random) {
    const Parity parity(SolidMesh(worldMesh(placed(drawn.shape, X))));
    const Eigen::AlignedBox3d bounds = parity.bounds();
    for (int n = 0; n < 100; ++n) {
      const Eigen::Vector3d p = bounds.center() + drawnVector(random, 6.0);
      if (bounds.contains(p)) continue;
      EXPECT_FALSE(parity.inside(p));
    }
  });
}

TEST(SceneLaws, BoundsOfAPrimitiveHoldItsMeshAndHardlyMore) {
  forDrawnShapes(6, [](const DrawnShape& drawn, const Eigen::Isometry3d& X, SampleStream&) {
    const Eigen::AlignedBox3d bounds = worldBounds(drawn.shape, X);
    const Eigen::AlignedBox3d mesh = boundsOf(worldMesh(placed(drawn.shape, X)));
    EXPECT_TRUE(((mesh.min() - bounds.min()).array() > -1e-9).all());
    EXPECT_TRUE(((bounds.max() - mesh.max()).array() > -1e-9).all());
    EXPECT_LT((bounds.sizes() - mesh.sizes()).maxCoeff(), 2.0 * kChord);
  });
}

TEST(SceneLaws, BoundsMoveWithAShape) {
  forDrawnShapes(7, [](const DrawnShape& drawn, const Eigen::Isometry3d& X, SampleStream& random) {
    const Eigen::Vector3d by = drawnVector(random, 10.0);
    Eigen::Isometry3d moved_place = X;
    moved_place.translation() += by;
    const Eigen::AlignedBox3d a = worldBounds(drawn.shape, X),
                              b = worldBounds(drawn.shape, moved_place);
    EXPECT_LT((a.min() + by - b.min()).norm(), 1e-12);
    EXPECT_LT((a.max() + by - b.max()).norm(), 1e-12);
    for (const double turn : {0.5, 1.0, 1.5}) {
      Eigen::Isometry3d turned_place = Eigen::Isometry3d::Identity();
      turned_place.linear() = aboutZ(kPi * turn).toRotationMatrix();
      const Eigen::AlignedBox3d c = worldBounds(drawn.shape, turned_place * X);
      EXPECT_NEAR(c.sizes().z(), a.sizes().z(), 1e-9);
      EXPECT_NEAR(c.sizes().head<2>().sum(), a.sizes().head<2>().sum(), 1e-9);
    }
  });
}

TEST(SceneLaws, VolumesOfMeshesAreThoseOfTheFormulaLessTheirChords) {
  forDrawnShapes(8, [](const DrawnShape& drawn, const Eigen::Isometry3d& X, SampleStream&) {
    double expected = 0.0;
    if (const auto* b = std::get_if<Box>(&drawn.shape)) expected = b->size.prod();
    if (const auto* c = std::get_if<Cylinder>(&drawn.shape))
      expected = kPi * c->radius * c->radius * c->height;
    if (const auto* s = std::get_if<Sphere>(&drawn.shape))
      expected = 4.0 / 3.0 * kPi * std::pow(s->radius, 3);
    if (const auto* c = std::get_if<CapsuleShape>(&drawn.shape))
      expected = kPi * c->radius * c->radius * (c->height - 2.0 / 3.0 * c->radius);
    const double volume = volumeOf(worldMesh(placed(drawn.shape, X)));
    EXPECT_LE(volume, expected * (1.0 + 1e-9));
    EXPECT_GE(volume, expected * 0.97);
  });
}

TEST(SceneLaws, PiecesAreAsManyHoweverTheirTrianglesAreOrdered) {
  SampleStream random(9, 0);
  for (int n = 0; n < 20; ++n) {
    TriangleMesh mesh;
    const int count = 1 + random.below(6);
    for (int i = 0; i < count; ++i)
      mesh = joined(mesh, moved(makeBox({0.5, 0.5, 0.5}), Eigen::Vector3d(i, random.below(3), 0)));
    const auto components = splitComponents(shuffled(mesh, random));
    ASSERT_EQ(static_cast<int>(components.size()), count);
    for (const MeshComponent& component : components) {
      EXPECT_TRUE(component.closed);
      EXPECT_EQ(component.mesh.triangles.size(), 12u);
      EXPECT_NEAR(volumeOf(component.mesh), 0.125, 1e-12);
    }
  }
}

TEST(SceneLaws, ACutUpPieceIsClosedStillAndOneThatMissesATriangleIsNot) {
  forDrawnShapes(10, [](const DrawnShape& drawn, const Eigen::Isometry3d& X, SampleStream& random) {
    const TriangleMesh mesh = worldMesh(placed(drawn.shape, X));
    const auto fine = splitComponents(subdivided(mesh, random));
    ASSERT_EQ(fine.size(), 1u);
    EXPECT_TRUE(fine[0].closed);
    TriangleMesh open = mesh;
    open.triangles.erase(open.triangles.begin() +
                         random.below(static_cast<int>(open.triangles.size())));
    const auto broken = splitComponents(open);
    ASSERT_EQ(broken.size(), 1u);
    EXPECT_FALSE(broken[0].closed);
    EXPECT_TRUE(Parity(solidOf(open)).empty());
  });
}

TEST(SceneLaws, CleaningTwiceIsCleaningOnceAndKeepsTheVolume) {
  forDrawnShapes(11, [](const DrawnShape& drawn, const Eigen::Isometry3d& X, SampleStream& random) {
    TriangleMesh mesh = worldMesh(placed(drawn.shape, X));
    const double volume = volumeOf(mesh);
    // Doubled corners, one that nothing uses, and triangles without area.
    const int n = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), mesh.vertices.begin(), mesh.vertices.begin() + n);
    for (auto& t : mesh.triangles)
      for (int& v : t) v += n * random.below(2);
    mesh.vertices.push_back({99, 99, 99});
    mesh.triangles.push_back({0, n, 1});
    const TriangleMesh clean = cleanMesh(mesh), again = cleanMesh(clean);
    EXPECT_LE(static_cast<int>(clean.vertices.size()), n);
    EXPECT_EQ(clean.triangles.size() + 1, mesh.triangles.size());
    EXPECT_NEAR(volumeOf(clean), volume, 1e-9);
    EXPECT_EQ(again.vertices, clean.vertices);
    EXPECT_EQ(again.triangles, clean.triangles);
  });
}

TEST(SceneLaws, PiecesOfASceneAreItsObjectsInAnyOrder) {
  for (const std::uint64_t seed : {12, 13}) {
    auto objects = drawnThings(seed, 12);
    const ScenePieces usual = splitScene(sceneOf(objects));
    std::reverse(objects.begin(), objects.end());
    const ScenePieces other = splitScene(sceneOf(objects));
    ASSERT_EQ(usual.pieces.size(), other.pieces.size());
    ASSERT_EQ(usual.triangles().size(), other.triangles().size());
    const size_t count = usual.pieces.size();
    for (size_t i = 0; i < count; ++i) {
      const ScenePiece &a = usual.pieces[i], &b = other.pieces[count - 1 - i];
      EXPECT_EQ(a.closed, b.closed);
      EXPECT_EQ(a.hollow, b.hollow);
      EXPECT_EQ(a.object + b.object, static_cast<int>(objects.size()) - 1);
      EXPECT_NEAR(volumeOf(a.mesh), volumeOf(b.mesh), 1e-12);
    }
  }
}

TEST(SceneLaws, APieceKnowsItsTriangles) {
  const ScenePieces pieces = splitScene(sceneOf(drawnThings(14, 15)));
  std::vector<int> seen(pieces.triangles().size(), 0);
  for (size_t i = 0; i < pieces.pieces.size(); ++i) {
    const ScenePiece& piece = pieces.pieces[i];
    for (size_t k = 0; k < piece.mesh.triangles.size(); ++k) {
      const int t = piece.first + static_cast<int>(k);
      ++seen[t];
      EXPECT_EQ(pieces.piece_of[t], static_cast<int>(i));
      for (int corner = 0; corner < 3; ++corner)
        EXPECT_EQ(pieces.triangles()[t][corner],
                  piece.mesh.vertices[piece.mesh.triangles[k][corner]]);
    }
  }
  for (const int times : seen) EXPECT_EQ(times, 1);
}

TEST(SceneLaws, ATriangleIsAsUprightFromEveryCornerAndTheOtherWayRoundTurned) {
  SampleStream random(15, 0);
  for (int n = 0; n < 300; ++n) {
    const Triangle3 t = {drawnVector(random), drawnVector(random), drawnVector(random)};
    if ((t[1] - t[0]).cross(t[2] - t[0]).norm() < 1e-3) continue;
    const double up = upwardness(t);
    EXPECT_NEAR(upwardness({t[1], t[2], t[0]}), up, 1e-9);
    EXPECT_NEAR(upwardness({t[0], t[2], t[1]}), -up, 1e-9);
    EXPECT_LE(std::abs(up), 1.0 + 1e-12);
    const Eigen::Quaterniond turn = aboutZ(random.uniform(-3, 3));
    EXPECT_NEAR(upwardness({turn * t[0], turn * t[1], turn * t[2]}), up, 1e-9);
  }
}

}  // namespace
}  // namespace amble
