#include "viz/page/page_data.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"
#include "tests/viz/page/read_back.h"
#include "tests/viz/test_walk.h"

namespace amble {
namespace {

using Eigen::Vector3d;
using nlohmann::json;

// A take of somebody who does anything.
struct AnyMotion {
  explicit AnyMotion(std::uint64_t seed) : random(seed), skeleton(randomSkeleton(random, 8)) {
    for (int i = 0; i < 12; ++i) {
      Pose pose;
      pose.p_WR = randomVector(random, 5.0);
      for (int j = 0; j < skeleton.size(); ++j) pose.rotations.push_back(randomRotation(random));
      poses.append(pose);
    }
    take.frame_time = 1.0 / 30;
    take.poses = &poses;
  }

  Generator random;
  Skeleton skeleton;
  PoseArray poses{8};
  PageTake take;
};

TEST(PageTake, RootsAndRotationsAreThoseOfThePosesToThePrecisionOfFloats) {
  for (const bool coarse : {false, true}) {
    AnyMotion motion(3);
    motion.take.coarse = coarse;
    PageBytes bytes;
    const json said = json::parse(takeJson(motion.take, bytes));
    EXPECT_EQ(said["frames"], motion.poses.size());
    const std::vector<double> root = readBack(bytes, said["root"]);
    const std::vector<double> rotations = readBack(bytes, said["rotations"], 1.0 / 32767.0);
    const double within = coarse ? 0.51 / 32767.0 : 1e-7;
    for (int i = 0; i < motion.poses.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(root[3 * i + axis], motion.poses.p_WR(i)[axis], 1e-6);
      for (int j = 0; j < motion.skeleton.size(); ++j)
        for (int part = 0; part < 4; ++part)
          EXPECT_NEAR(rotations[4 * (8 * i + j) + part],
                      motion.poses.rotations(i)[j].coeffs()[part], within);
    }
  }
}

TEST(PageTake, WhatIsNotKnownIsNotThere) {
  AnyMotion motion(4);
  PageBytes bytes;
  const json said = json::parse(takeJson(motion.take, bytes));
  for (const char* const key : {"positions", "way", "headings", "stop"})
    EXPECT_FALSE(said.contains(key)) << key;
  EXPECT_TRUE(said["clearance"].is_null());
  for (const char* const key : {"events", "prints", "sources"}) EXPECT_TRUE(said[key].empty());
}

TEST(PageTake, WhatIsKnownIsWhereItWasPut) {
  AnyMotion motion(5);
  PageTake& take = motion.take;
  take.way = {{0, 0, 0}, {1, 2, 3}};
  take.headings.assign(12, 0.5F);
  take.planted[kRight] = {{2, 7}};
  take.events = {{"left strike", kLeft, 3.25}};
  take.stop = PageStop{8.5, 3, 4, {1, 2, 3}};
  take.sources = {{"walk", std::vector<float>(12, 0.75F)}};
  take.clearance.distance.assign(12, 0.25F);
  take.clearance.on_body.assign(12, {1, 2, 3});
  take.clearance.on_it.assign(12, {4, 5, 6});
  take.clearance.part.assign(12, 2);
  take.clearance.object.assign(12, 1);
  PageBytes bytes;
  const json said = json::parse(takeJson(take, bytes));
  EXPECT_EQ(readBack(bytes, said["way"]), (std::vector<double>{0, 0, 0, 1, 2, 3}));
  EXPECT_EQ(readBack(bytes, said["headings"]), std::vector<double>(12, 0.5));
  EXPECT_EQ(said["planted"], json({json::array(), {{2, 7}}}));
  EXPECT_EQ(said["events"][0]["frame"], 3.25);
  EXPECT_EQ(said["stop"]["object"], 4);
  EXPECT_EQ(readBack(bytes, said["sources"][0]["share"]), std::vector<double>(12, 0.75));
  const std::vector<double> points = readBack(bytes, said["clearance"]["points"]);
  ASSERT_EQ(points.size(), 72u);
  for (size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i], 1.0 + static_cast<double>(i % 6));
}

// Outlines as walk_view.h draws them on every other picture.
TEST(PageTake, PrintsAreTheShoesThatStoodThere) {
  AnyMotion motion(6);
  Footprint print;
  print.side = kRight;
  print.position = {3, 4, 0.5};
  print.heading = 1.2;
  print.first_frame = 2;
  print.last_frame = 9;
  motion.take.footprints = {print};
  motion.take.sole = 0.31;
  PageBytes bytes;
  const json said = json::parse(takeJson(motion.take, bytes))["prints"][0];
  const auto shoe = placedShoe(print, 0.31);
  ASSERT_EQ(said["outline"].size(), shoe.size());
  for (size_t i = 0; i < shoe.size(); ++i)
    EXPECT_EQ(said["outline"][i], json({shoe[i].x(), shoe[i].y()}));
  EXPECT_EQ(said["side"], static_cast<int>(kRight));
  EXPECT_EQ(said["last"], 9);
}

TEST(PageBody, JointsAndPartsAreTheBodys) {
  const auto walk = makeTestWalk();
  const json said = json::parse(bodyJson({"walker", &walk->skeleton, &walk->body}));
  ASSERT_EQ(said["joints"].size(), 3u);
  ASSERT_EQ(said["parts"].size(), walk->body.parts.size());
  for (size_t i = 0; i < walk->body.parts.size(); ++i) {
    const BodyPart& part = walk->body.parts[i];
    EXPECT_EQ(said["parts"][i]["name"], part.name);
    EXPECT_EQ(said["parts"][i]["radius"], part.radius);
    EXPECT_EQ(said["parts"][i]["side"], part.sole);
  }
  EXPECT_EQ(said["joints"][1]["offset"], json({0.0, 0.1, 0.0}));
  EXPECT_TRUE(json::parse(bodyJson({"bones", &walk->skeleton}))["parts"].empty());
}

TEST(PageFigure, IsTheFigureToThePrecisionOfFloats) {
  const auto walk = makeTestWalk();
  const Figure& figure = figureOfTestWalk();
  PageBytes bytes;
  const json said =
      json::parse(figureJson({"walker", &walk->skeleton, &walk->body, &figure}, bytes));
  const std::vector<double> vertices = readBack(bytes, said["vertices"]);
  ASSERT_EQ(vertices.size(), 3 * figure.vertices.size());
  const std::vector<double> triangles = readBack(bytes, said["triangles"]);
  ASSERT_EQ(triangles.size(), 3 * figure.triangles.size());
  const std::vector<double> weights = readBack(bytes, said["weights"]);
  const std::vector<double> bind = readBack(bytes, said["bind"]);
  for (size_t i = 0; i < figure.vertices.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(vertices[3 * i + axis], figure.vertices[i][axis]);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(weights[4 * i + k], figure.weights[i][k]);
  }
  for (size_t i = 0; i < triangles.size(); ++i)
    EXPECT_EQ(triangles[i], figure.triangles[i / 3][i % 3]);
  for (size_t j = 0; j < figure.bind.size(); ++j)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(bind[7 * j + axis], figure.bind[j].p_WJ[axis], 1e-6);
  EXPECT_EQ(figureJson({"bones", &walk->skeleton}, bytes), "null");
}

// Corners of every instance, as viz/page/web/room.js places them.
std::vector<Vector3d> cornersOf(const json& mesh, size_t instance, const PageBytes& bytes) {
  const std::vector<double> corners = readBack(bytes, mesh["corners"]);
  const std::vector<double> placings = readBack(bytes, mesh["placings"]);
  const Eigen::Map<const Eigen::Matrix<double, 3, 4>> placing(placings.data() + 12 * instance);
  std::vector<Vector3d> points;
  for (size_t i = 0; i < corners.size(); i += 3) {
    const Vector3d share = Vector3d(corners[i], corners[i + 1], corners[i + 2]) / 65535.0;
    points.emplace_back(placing.leftCols<3>() * share + placing.col(3));
  }
  return points;
}

TEST(PageRoom, ThingsLieWhereTheyDoInWhateverPose) {
  Generator random(7);
  Scene scene;
  for (int i = 0; i < 6; ++i) {
    SceneObject object = testBox("box " + std::to_string(i), {0.2 + 0.1 * i, 0.3, 0.4}, {0, 0, 0});
    if (i % 2 == 0) object.shape = makeCylinder(0.2 + 0.05 * i, 0.7, 16);
    object.X_WO = Eigen::Translation3d(randomVector(random, 3.0)) * randomRotation(random);
    scene.objects.push_back(object);
  }
  PageBytes bytes;
  const json room = json::parse(roomJson(scene, 0.0, bytes));
  std::vector<Eigen::AlignedBox3d> boxes(scene.objects.size());
  for (const json& mesh : room["meshes"]) {
    const std::vector<double> objects = readBack(bytes, mesh["objects"]);
    for (size_t k = 0; k < objects.size(); ++k)
      for (const Vector3d& p : cornersOf(mesh, k, bytes)) boxes[objects[k]].extend(p);
  }
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    Eigen::AlignedBox3d expected;
    for (const Vector3d& p : worldMesh(scene.objects[i]).vertices) expected.extend(p);
    EXPECT_LT((boxes[i].min() - expected.min()).norm(), 1e-4) << i;
    EXPECT_LT((boxes[i].max() - expected.max()).norm(), 1e-4) << i;
  }
}

TEST(PageRoom, TrianglesNameCornersThatAreThere) {
  PageBytes bytes;
  const json room = json::parse(roomJson(testRoom(), 0.0, bytes));
  EXPECT_EQ(room["objects"].size(), 6u);
  for (const json& mesh : room["meshes"])
    for (const double corner : readBack(bytes, mesh["triangles"]))
      EXPECT_LT(corner, mesh["corners"]["n"].get<double>() / 3.0);
}

TEST(JsonString, IsTheTextWhateverItHolds) {
  for (const std::string text :
       {"", "a\"b\\c", "\n\t\x01", "\xd0\xb6\xf0\x9f\xaa\x91", "</script>"})
    EXPECT_EQ(json::parse(jsonString(text)), text);
}

}  // namespace
}  // namespace amble
