#include "environments/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/rotation.h"
#include "test_paths.h"
#include "tests/environments/test_files.h"
#include "tests/environments/test_meshes.h"

namespace amble {
namespace {

const std::string kFloor = "  - name: floor\n    box: {size: [8, 6, 0.1]}\n    at: [4, 3, -0.05]\n";

// The refusal of a scene with these objects beside a floor, without the file's name.
std::string refusal(const std::string& objects, const std::string& before = "objects:\n") {
  const TestFolder folder;
  folder.write("cube.obj", cubeObj());
  const auto file = folder.write("scene.yaml", before + kFloor + objects);
  const std::string error = errorOf([&] { readScene(file); });
  if (error.empty()) return "";
  EXPECT_TRUE(error.starts_with(file.string() + ":")) << error;
  return error.substr(file.string().size() + 1);
}

void expectBounds(const SceneObject& object, const Eigen::Vector3d& min,
                  const Eigen::Vector3d& max) {
  expectBounds(worldMesh(object), min, max);
}

TEST(ReadScene, BadInputIsRefusedAtItsLine) {
  // Line 5 is the first of the objects given here.
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"  - name: a\n    bok: {size: [1, 1, 1]}\n", "6: "},
      {"  - name: a\n", "5: "},
      {"  - box: {size: [1, 1, 1]}\n", "5: "},
      {"  - name: a\n    box: {size: [1, 1, 1]}\n    sphere: {radius: 1}\n", "7: "},
      {"  - name: a\n    box: {size: [1, 1, 0]}\n", "6: "},
      {"  - name: a\n    box: {size: [1, 1, .nan]}\n", "6: "},
      {"  - name: a\n    box: {size: [1, 1]}\n", "6: "},
      {"  - name: a\n    sphere: {radius: -1}\n", "6: "},
      {"  - name: a\n    capsule: {radius: 0.5, height: 1}\n", "6: "},
      {"  - name: a\n    sphere: {radius: 1}\n    role: floor\n", "7: "},
      {"  - name: a\n    sphere: {radius: 1}\n    scale: 2\n", "7: "},
      {"  - name: a\n    sphere: {radius: 1}\n    parts: []\n", "7: "},
      {"  - name: a\n    sphere: {radius: 1}\n    at: [1, 2]\n", "7: "},
      {"  - name: a\n    sphere: {radius: 1}\n    turn: 90\n    rotate: [0, 0, 90]\n", "8: "},
      {"  - name: floor\n    sphere: {radius: 1}\n", "5: "},
      {"  - name: a\n    mesh: nothing.obj\n    up: y\n", "6: "},
      {"  - name: a\n    mesh: cube.obj\n", "6: "},
      {"  - name: a\n    mesh: cube.obj\n    up: x\n", "7: "},
      {"  - name: a\n    mesh: cube.obj\n    up: y\n    scale: 0\n", "8: "},
      {"  - name: a\n    mesh: cube.obj\n    up: y\n    parts: [{match: door, role: ignore}]\n",
       "8: "},
  };
  for (const auto& [objects, line] : bad) {
    const std::string error = refusal(objects);
    EXPECT_TRUE(error.starts_with(line)) << objects << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST(ReadScene, AMisspelledKeyIsNamed) {
  EXPECT_NE(refusal("  - name: a\n    sphere: {radius: 1}\n    rolle: ground\n").find("role"),
            std::string::npos);
}

TEST(ReadScene, ASecondObjectOfANameNamesTheFirst) {
  EXPECT_NE(refusal("  - name: floor\n    sphere: {radius: 1}\n").find("line 2"),
            std::string::npos);
}

TEST(ReadScene, ASceneWithoutObjectsIsRefused) {
  const TestFolder folder;
  EXPECT_NE(errorOf([&] { readScene(folder.write("a.yaml", "name: a\n")); }), "");
  EXPECT_NE(errorOf([&] { readScene(folder.write("b.yaml", "name: a\nobjects: []\n")); }), "");
}

TEST(ReadScene, ASceneInMillimetresIsToldItsScale) {
  const TestFolder folder;
  folder.write("room.obj", "v 0 0 0\nv 8000 0 0\nv 0 0 6000\nf 1 2 3\n");
  const std::string millimetres = errorOf([&] {
    readScene(folder.write("mm.yaml", "objects:\n  - name: room\n    mesh: room.obj\n    up: y\n"));
  });
  EXPECT_NE(millimetres.find("scale: 0.001"), std::string::npos) << millimetres;
  const std::string kilometres = errorOf([&] {
    readScene(folder.write(
        "km.yaml",
        "objects:\n  - name: room\n    mesh: room.obj\n    up: y\n    scale: 0.000001\n"));
  });
  EXPECT_NE(kilometres.find("scale: 0.001"), std::string::npos) << kilometres;
}

TEST(ReadScene, FormatsThatSayTheirAxesTakeNoUp) {
  const std::filesystem::path model = "/usr/share/assimp/models/FBX/cubes_with_names.fbx";
  if (!std::filesystem::exists(model)) GTEST_SKIP() << "assimp-testmodels is not installed";
  EXPECT_TRUE(
      refusal("  - name: a\n    mesh: " + model.string() + "\n    up: y\n").starts_with("7: "));
  EXPECT_EQ(refusal("  - name: a\n    mesh: " + model.string() + "\n"), "");
}

TEST(ReadScene, PlacesByUpThenScaleThenTurnThenAt) {
  const TestFolder folder;
  // One triangle whose corner stands out by 1, 2, 3 along the file's axes.
  folder.write("t.obj", "v 1 2 3\nv 0 0 0\nv 1 0 0\nf 1 2 3\n");
  const Scene scene = readScene(
      folder.write("s.yaml",
                   "objects:\n"
                   "  - {name: a, mesh: t.obj, up: y, scale: 2, turn: 90, at: [10, 20, 30]}\n"
                   "  - {name: b, mesh: t.obj, up: z, rotate: [90, 0, 0]}\n"
                   "  - {name: c, mesh: t.obj, up: z, rotate: [90, 0, 90]}\n"));
  ASSERT_EQ(scene.objects.size(), 3u);
  const auto corner = [&](int i) { return worldMesh(scene.objects[i]).vertices[0]; };
  // y up: (1, -3, 2); scaled (2, -6, 4); turned (6, 2, 4).
  EXPECT_LT((corner(0) - Eigen::Vector3d(16, 22, 34)).norm(), 1e-12);
  // About x: (1, 2, 3) becomes (1, -3, 2); and then about z: (3, 1, 2).
  EXPECT_LT((corner(1) - Eigen::Vector3d(1, -3, 2)).norm(), 1e-12);
  EXPECT_LT((corner(2) - Eigen::Vector3d(3, 1, 2)).norm(), 1e-12);
}

TEST(ReadScene, PrimitivesStandUprightCentredOnAt) {
  const TestFolder folder;
  const Scene scene =
      readScene(folder.write("s.yaml",
                             "objects:\n"
                             "  - {name: a, cylinder: {radius: 0.25, height: 2}, at: [1, 2, 3]}\n"
                             "  - {name: b, capsule: {radius: 0.25, height: 2}, at: [1, 2, 3]}\n"
                             "  - {name: c, sphere: {radius: 0.25}, at: [1, 2, 3]}\n"
                             "  - {name: d, box: {size: [1, 2, 3]}, at: [1, 2, 3], turn: 90}\n"));
  expectBounds(scene.objects[0], {0.75, 1.75, 2}, {1.25, 2.25, 4});
  expectBounds(scene.objects[1], {0.75, 1.75, 2}, {1.25, 2.25, 4});
  expectBounds(scene.objects[2], {0.75, 1.75, 2.75}, {1.25, 2.25, 3.25});
  expectBounds(scene.objects[3], {0, 1.5, 1.5}, {2, 2.5, 4.5});
  EXPECT_EQ(scene.triangleCount(), 0);
}

TEST(ReadScene, PartsHaveTheRoleOfTheFirstPatternThatMatches) {
  const TestFolder folder;
  folder.write("house.obj",
               "o Front_Door\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no wall\nv 0 0 1\nv 1 0 1\nv 0 1 "
               "1\nf 4 5 6\n"
               "o Back_door\nv 0 0 2\nv 1 0 2\nv 0 1 2\nf 7 8 9\n");
  const Scene scene = readScene(folder.write(
      "s.yaml",
      "objects:\n  - name: house\n    mesh: house.obj\n    up: y\n"
      "    role: obstacle\n"
      "    parts: [{match: \"back*\", role: ground}, {match: \"*door*\", role: ignore}]\n"));
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.objects[0].role, Role::kIgnore);
  EXPECT_EQ(scene.objects[1].role, Role::kObstacle);
  EXPECT_EQ(scene.objects[2].role, Role::kGround);
  EXPECT_EQ(scene.objects[1].name, "house");
  EXPECT_EQ(scene.objects[1].part, "wall");
  EXPECT_EQ(scene.triangleCount(), 3);
}

TEST(ReadScene, NamesEveryFileThatItRead) {
  const TestFolder folder;
  folder.write("cube.obj", cubeObj());
  const auto file = folder.write("s.yaml",
                                 "objects:\n  - {name: a, mesh: cube.obj, up: y}\n"
                                 "  - {name: b, mesh: cube.obj, up: y, at: [3, 0, 0]}\n");
  const Scene scene = readScene(file);
  ASSERT_EQ(scene.inputs.size(), 2u);
  EXPECT_EQ(scene.inputs[0], file);
  EXPECT_EQ(scene.inputs[1].filename(), "cube.obj");
}

TEST(Scene, BoundsLeaveOutWhatIsIgnored) {
  const TestFolder folder;
  const Scene scene = readScene(
      folder.write("s.yaml",
                   "objects:\n  - {name: a, box: {size: [2, 2, 2]}}\n"
                   "  - {name: b, box: {size: [2, 2, 2]}, at: [9, 0, 0], role: ignore}\n"));
  EXPECT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.bounds().max(), Eigen::Vector3d(1, 1, 1));
}

TEST(MatchesPattern, StarsAndQuestionMarksWithoutRegardToCase) {
  EXPECT_TRUE(matchesPattern("*door*", "IfcDoor_Haustuer"));
  EXPECT_TRUE(matchesPattern("d??r", "DOOR"));
  EXPECT_TRUE(matchesPattern("*", ""));
  EXPECT_TRUE(matchesPattern("a*b*c", "axxbxxbc"));
  EXPECT_FALSE(matchesPattern("a*b*c", "axxbxxbd"));
  EXPECT_FALSE(matchesPattern("door", "doors"));
  EXPECT_FALSE(matchesPattern("", "x"));
  EXPECT_TRUE(matchesPattern("[door]", "[DOOR]"));
}

TEST(Apartment, IsReadWithItsThirtyThreeObjects) {
  const std::filesystem::path mesh =
      std::filesystem::path(AMBLE_SHARED) / "scenes/apartment/apartment.obj";
  if (!std::filesystem::exists(mesh)) GTEST_SKIP() << mesh << " is not there";
  const TestFolder folder;
  const Scene scene = readScene(folder.write(
      "s.yaml", "objects:\n  - {name: flat, mesh: " + std::filesystem::absolute(mesh).string() +
                    ", up: y}\n"));
  EXPECT_EQ(scene.objects.size(), 33u);
  EXPECT_NEAR(scene.bounds().sizes().x(), 21.8, 0.1);
  EXPECT_NEAR(scene.bounds().sizes().z(), 2.5, 0.1);
}

TEST(ReadScene, AMeshThatSaysItsAxesIsRightedByRotate) {
  const TestFolder folder;
  folder.write(
      "room.gltf",
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAAA"}]})");
  const auto with = [&](const std::string& key) {
    return folder.write("scene.yaml", "objects:\n  - {name: room, mesh: room.gltf, " + key + "}\n");
  };
  EXPECT_NE(errorOf([&] { readScene(with("up: z")); }).find("`rotate: [-90, 0, 0]`"),
            std::string::npos);
  // The corner at 2 along the file's y, which a file that is z up has behind: y of World again.
  const Scene righted = readScene(with("rotate: [-90, 0, 0]"));
  EXPECT_NEAR(righted.bounds().max().y(), 2.0, 1e-6);
  EXPECT_NEAR(righted.bounds().max().z(), 0.0, 1e-6);
}

TEST(ReadScene, AStopBeforeTheFirstObjectEndsIt) {
  const TestFolder folder;
  const auto file = folder.write("scene.yaml", "objects:\n  - {name: a, sphere: {radius: 1}}\n");
  const std::atomic<bool> stop = true;
  EXPECT_THROW(readScene(file, {.stop = {&stop, {}}}), Stopped);
  EXPECT_THROW(readScene(file, {.stop = {nullptr, std::chrono::steady_clock::now()}}), Stopped);
}

TEST(ObjectName, OfAPartNamesItsObjectToo) {
  SceneObject object;
  object.name = "house";
  EXPECT_EQ(objectName(object), "house");
  object.part = "door";
  EXPECT_EQ(objectName(object), "house: door");
}

// A cube of OBJ from 0 to 1, scaled and placed by its middle, is the box of that size there.
TEST(ReadScene, ABoxAndACubeOfAFileAreTheSameThingPlacedAlike) {
  const TestFolder folder;
  folder.write("cube.obj", cubeObj());
  std::mt19937_64 generator(71);
  std::uniform_real_distribution<double> place(-5, 5), angle(-180, 180), size(0.3, 3);
  for (int n = 0; n < 5; ++n) {
    const double s = size(generator);
    const std::string rotate = "rotate: [" + std::to_string(angle(generator)) + ", " +
                               std::to_string(angle(generator)) + ", " +
                               std::to_string(angle(generator)) + "]";
    const std::string edge = std::to_string(s);
    const Scene scene = readScene(folder.write(
        "s.yaml", "objects:\n  - {name: a, box: {size: [" + edge + ", " + edge + ", " + edge +
                      "]}, " + rotate + "}\n  - {name: b, mesh: cube.obj, up: z, scale: " + edge +
                      ", " + rotate + "}\n"));
    const TriangleMesh box = worldMesh(scene.objects[0]), cube = worldMesh(scene.objects[1]);
    EXPECT_NEAR(volumeOf(box), volumeOf(cube), 1e-6);
    const Eigen::Vector3d off = boundsOf(cube).center() - boundsOf(box).center();
    for (const Eigen::Vector3d& corner : box.vertices) {
      double nearest = HUGE_VAL;
      for (const Eigen::Vector3d& v : cube.vertices)
        nearest = std::min(nearest, (v - off - corner).norm());
      EXPECT_LT(nearest, 1e-6);
    }
  }
}

TEST(ReadScene, YUpIsAQuarterTurnAboutX) {
  const TestFolder folder;
  folder.write("t.obj", "v 1 2 3\nv 0 0 1\nv 1 0 0\nf 1 2 3\n");
  const Scene scene =
      readScene(folder.write("s.yaml",
                             "objects:\n  - {name: a, mesh: t.obj, up: y}\n"
                             "  - {name: b, mesh: t.obj, up: z, rotate: [90, 0, 0]}\n"));
  const TriangleMesh a = worldMesh(scene.objects[0]), b = worldMesh(scene.objects[1]);
  for (size_t i = 0; i < a.vertices.size(); ++i)
    EXPECT_LT((a.vertices[i] - b.vertices[i]).norm(), 1e-12);
}

TEST(WorldMesh, OfEveryPrimitiveIsClosedOutwardsAndWhereItStands) {
  for (const Shape& shape : {Shape(Box{{1, 2, 3}}), Shape(Cylinder{0.4, 1.5}), Shape(Sphere{0.6}),
                             Shape(CapsuleShape{0.3, 1.4})}) {
    SceneObject object;
    object.shape = shape;
    object.X_WO.translation() = Eigen::Vector3d(3, -2, 7);
    object.X_WO.linear() = aboutZ(0.4).toRotationMatrix();
    const TriangleMesh mesh = worldMesh(object);
    ASSERT_EQ(splitComponents(mesh).size(), 1u);
    EXPECT_TRUE(splitComponents(mesh)[0].closed);
    EXPECT_GT(volumeOf(mesh), 0.0);
    EXPECT_LT((boundsOf(mesh).center() - Eigen::Vector3d(3, -2, 7)).norm(), 0.01);
  }
}

// Chords of a ball lie half a centimetre in it at most, its triangles twice as deep; and small
// balls, of which a scene may have thousands, are not as fine as large ones.
TEST(WorldMesh, OfABallIsAsFineAsItIsLarge) {
  size_t last = 0;
  for (const double radius : {0.01, 0.05, 0.2, 0.6, 1.5, 2.3}) {
    SceneObject ball;
    ball.shape = Sphere{radius};
    const TriangleMesh mesh = worldMesh(ball);
    for (const std::array<int, 3>& t : mesh.triangles) {
      const Eigen::Vector3d middle =
          (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
      ASSERT_GT(middle.norm(), radius - 0.01) << radius;
    }
    EXPECT_LT((boundsOf(mesh).sizes() - Eigen::Vector3d::Constant(2.0 * radius)).norm(), 1e-9);
    EXPECT_GE(mesh.triangles.size(), last);
    last = mesh.triangles.size();
  }
  EXPECT_GT(last, 2000u);
  EXPECT_LT(worldMesh({"", "", Sphere{0.2}, Eigen::Isometry3d::Identity()}).triangles.size(), 300u);
}

TEST(WorldBounds, HoldPrimitivesTightlyHoweverTheyLie) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(0.2, 2.0), turn(-3.0, 3.0);
  for (int k = 0; k < 50; ++k) {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.translation() << turn(random), turn(random), turn(random);
    X.linear() = expRotation({turn(random), turn(random), turn(random)}).toRotationMatrix();
    const double radius = number(random), height = 2.0 * radius + number(random);
    const Eigen::Vector3d size(number(random), number(random), number(random));
    const std::vector<std::pair<Shape, TriangleMesh>> fine = {
        {Box{size}, makeBox(size)},
        {Sphere{radius}, makeSphere(radius, 256)},
        {Cylinder{radius, height}, makeCylinder(radius, height, 256)},
        {CapsuleShape{radius, height}, makeCapsule(radius, height, 256)},
        {makeBox(size), makeBox(size)}};
    for (size_t i = 0; i < fine.size(); ++i) {
      Eigen::AlignedBox3d of_mesh;
      for (const Eigen::Vector3d& v : fine[i].second.vertices) of_mesh.extend(X * v);
      const Eigen::AlignedBox3d bounds = worldBounds(fine[i].first, X);
      EXPECT_LT((bounds.min() - of_mesh.min()).cwiseAbs().maxCoeff(), 1e-3 * height) << i;
      EXPECT_LT((bounds.max() - of_mesh.max()).cwiseAbs().maxCoeff(), 1e-3 * height) << i;
      EXPECT_LE((of_mesh.max() - bounds.max()).maxCoeff(), 1e-12) << i;
      EXPECT_LE((bounds.min() - of_mesh.min()).maxCoeff(), 1e-12) << i;
    }
  }
}

}  // namespace
}  // namespace amble
