#include "viz/exchange/glb.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "base/rotation.h"
#include "tests/environments/test_walker.h"
#include "tests/viz/test_walk.h"
#include "viz/figure/bone_figure.h"

namespace amble {
namespace {

using Eigen::Vector3d;
using nlohmann::json;

// A reader of what the format's definition says of such files (Khronos, glTF 2.0, section 4.4).
struct ReadGlb {
  json file;
  std::string bytes;  // of the one buffer

  explicit ReadGlb(const std::string& glb) {
    const auto word = [&](size_t at) {
      std::uint32_t value = 0;
      std::memcpy(&value, glb.data() + at, sizeof value);
      return value;
    };
    EXPECT_EQ(glb.substr(0, 4), "glTF");
    EXPECT_EQ(word(8), glb.size());
    const size_t length = word(12);
    file = json::parse(glb.substr(20, length));
    bytes = glb.substr(28 + length);
  }

  std::vector<float> floats(int accessor) const {
    const json& one = file["accessors"][accessor];
    const std::map<std::string, int> sizes = {
        {"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    std::vector<float> values(one["count"].get<size_t>() * sizes.at(one["type"]));
    const json& view = file["bufferViews"][one["bufferView"].get<int>()];
    std::memcpy(values.data(), bytes.data() + view.value("byteOffset", 0),
                values.size() * sizeof(float));
    return values;
  }

  int find(const std::string& name) const {
    for (size_t i = 0; i < file["nodes"].size(); ++i)
      if (file["nodes"][i]["name"] == name) return static_cast<int>(i);
    return -1;
  }

  // Where nodes are at a frame, in the file's axes.
  std::vector<Eigen::Isometry3d> placed(int frame) const {
    std::vector<Eigen::Isometry3d> local, world;
    for (const json& node : file["nodes"]) {
      Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
      if (node.contains("translation"))
        for (int k = 0; k < 3; ++k) X.translation()[k] = node["translation"][k];
      if (node.contains("rotation"))
        X.linear() = turn(node["rotation"].get<std::vector<float>>(), 0);
      local.push_back(X);
    }
    for (const json& channel : file["animations"][0]["channels"]) {
      const json& sampler = file["animations"][0]["samplers"][channel["sampler"].get<int>()];
      const std::vector<float> values = floats(sampler["output"]);
      Eigen::Isometry3d& X = local[channel["target"]["node"].get<int>()];
      if (channel["target"]["path"] == "rotation") {
        X.linear() = turn(values, 4 * frame);
      } else {
        for (int k = 0; k < 3; ++k) X.translation()[k] = values[3 * frame + k];
      }
    }
    world = local;
    for (size_t i = 0; i < local.size(); ++i)  // parents come before their children
      if (file["nodes"][i].contains("children"))
        for (const int child : file["nodes"][i]["children"]) world[child] = world[i] * local[child];
    return world;
  }

  static Eigen::Matrix3d turn(const std::vector<float>& values, size_t at) {
    return Eigen::Quaterniond(values[at + 3], values[at], values[at + 1], values[at + 2])
        .normalized()
        .toRotationMatrix();
  }
};

Vector3d inWorld(const Vector3d& p_file) { return {p_file.x(), -p_file.z(), p_file.y()}; }

std::string written(const WalkView& view, const GlbWalkOptions& options = {}) {
  std::ostringstream out;
  writeGlb(out, view, makeFigure(*view.skeleton, *view.body), options);
  return out.str();
}

// Somebody who turns and swings his arms; q and -q, which are one turn, take turns.
Clip turningWalker() {
  const TestWalker walker;
  Clip clip{"a walk", walker.skeleton, 1.0 / 60.0, PoseArray(walker.skeleton.size()), {}};
  for (int i = 0; i < 40; ++i) {
    Pose pose = walker.standing(0.02 * i, 0.5, 0.2 * i);
    pose.rotations[walker.roles.arms[kLeft].arm] = expRotation(0.3 * i * Vector3d::UnitX());
    if (i % 3 == 0)
      for (Eigen::Quaterniond& q : pose.rotations) q.coeffs() *= -1.0;
    clip.poses.append(pose);
  }
  return clip;
}

std::string written(const Clip& clip, const Figure& figure) {
  std::ostringstream out;
  writeGlb(out, clip, figure);
  return out.str();
}

TEST(Glb, JointsAreWhereTheClipHasThemAtEveryFrame) {
  const Clip clip = turningWalker();
  const ReadGlb glb(written(clip, makeBoneFigure(clip.skeleton)));
  std::vector<JointFrame> frames(clip.skeleton.size());
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, frames);
    const auto placed = glb.placed(i);
    for (int j = 0; j < clip.skeleton.size(); ++j) {
      const int node = glb.file["skins"][0]["joints"][j];
      EXPECT_LT((inWorld(placed[node].translation()) - frames[j].p_WJ).norm(), 1e-5);
    }
  }
}

TEST(Glb, JointsThatMoveApartMoveSoInTheFile) {
  Clip clip = turningWalker();
  for (int i = 0; i < clip.frames(); ++i)
    for (const Joint& joint : clip.skeleton.joints())
      clip.joint_positions.push_back((1.0 + 0.01 * i) * joint.offset);
  const ReadGlb glb(written(clip, makeBoneFigure(clip.skeleton)));
  std::vector<JointFrame> frames(clip.skeleton.size());
  forwardKinematics(clip, 39, frames);
  const auto placed = glb.placed(39);
  for (int j = 0; j < clip.skeleton.size(); ++j)
    EXPECT_LT((inWorld(placed[j].translation()) - frames[j].p_WJ).norm(), 1e-5);
}

TEST(Glb, TurnsGoTheShorterWayFromFrameToFrame) {
  const ReadGlb glb(written(turningWalker(), makeBoneFigure(TestWalker().skeleton)));
  for (const json& channel : glb.file["animations"][0]["channels"]) {
    if (channel["target"]["path"] != "rotation") continue;
    const std::vector<float> q =
        glb.floats(glb.file["animations"][0]["samplers"][channel["sampler"].get<int>()]["output"]);
    for (size_t i = 4; i < q.size(); i += 4)
      EXPECT_GT(q[i] * q[i - 4] + q[i + 1] * q[i - 3] + q[i + 2] * q[i - 2] + q[i + 3] * q[i - 1],
                0.0F);
  }
}

TEST(Glb, FramesAreAtTheirTimes) {
  const Clip clip = turningWalker();
  const ReadGlb glb(written(clip, makeBoneFigure(clip.skeleton)));
  const std::vector<float> times = glb.floats(glb.file["animations"][0]["samplers"][0]["input"]);
  ASSERT_EQ(times.size(), 40);
  for (int i = 0; i < 40; ++i) EXPECT_NEAR(times[i], i / 60.0, 1e-7);
}

// A skin is where it was made while its joints are in its bind pose.
TEST(Glb, InverseBindMatricesUndoTheFiguresBindPose) {
  const TestWalker walker;
  const Figure figure = makeFigure(walker.skeleton, walker.body);
  const ReadGlb glb(written(turningWalker(), figure));
  const std::vector<float> numbers = glb.floats(glb.file["skins"][0]["inverseBindMatrices"]);
  for (int j = 0; j < walker.skeleton.size(); ++j) {
    const Eigen::Map<const Eigen::Matrix4f> inverse(numbers.data() + 16 * j);
    const Vector3d p = figure.bind[j].p_WJ;
    const Eigen::Vector4f joint(static_cast<float>(p.x()), static_cast<float>(p.z()),
                                static_cast<float>(-p.y()), 1.0F);
    EXPECT_LT((inverse * joint - Eigen::Vector4f::UnitW()).norm(), 1e-6F);
  }
}

TEST(Glb, PathPrintsAndSceneAreNodesByName) {
  const auto walk = makeTestWalk();
  const ReadGlb glb(written(walk->view));
  for (const char* name : {"hips", "figure", "root path", "footprints", "footprint 1 left",
                           "footprint 8 right", "scene", "floor", "chest"})
    EXPECT_GE(glb.find(name), 0) << name;
  const auto placed = glb.placed(0);
  const Vector3d print = inWorld(placed[glb.find("footprint 3 left")].translation());
  EXPECT_LT((print - walk->animation.footprints[2].position).norm(), 0.005);
}

TEST(Glb, AScenesObjectsLieWhereTheyDo) {
  const auto walk = makeTestWalk();
  const ReadGlb glb(written(walk->view));
  const json& node = glb.file["nodes"][glb.find("chest")];
  const json& mesh = glb.file["meshes"][node["mesh"].get<int>()]["primitives"][0];
  const json& corners = glb.file["accessors"][mesh["attributes"]["POSITION"].get<int>()];
  const auto corner = [&](const char* which) {
    return Vector3d(corners[which][0], corners[which][1], corners[which][2]);
  };
  EXPECT_LT((inWorld(corner("min")) - Vector3d(5.2, 3.85, 0.0)).norm(), 1e-5);
  EXPECT_LT((inWorld(corner("max")) - Vector3d(5.8, 3.35, 0.7)).norm(), 1e-5);
}

TEST(Glb, ASceneIsLeftOutWhereItIsNotWanted) {
  const auto walk = makeTestWalk();
  EXPECT_EQ(ReadGlb(written(walk->view, {.scene = false})).find("scene"), -1);
}

TEST(Glb, AVastSceneIsThinnedAndTheFileSaysSo) {
  const auto walk = makeTestWalk();
  SceneObject vast = testBox("vast", {1, 1, 1}, {0, 0, 0});
  TriangleMesh mesh;
  constexpr int kSide = 400;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      mesh.vertices.push_back({0.1 * x, 0.1 * y, 0.0});
      if (x == 0 || y == 0) continue;
      const int a = y * kSide + x;
      mesh.triangles.push_back({a, a - 1, a - kSide});
      mesh.triangles.push_back({a - 1, a - kSide - 1, a - kSide});
    }
  vast.shape = mesh;
  walk->scene.objects.push_back(vast);
  const ReadGlb glb(written(walk->view));
  const std::string said = glb.file["nodes"][glb.find("scene")]["extras"]["thinned"];
  const int all = 2 * (kSide - 1) * (kSide - 1) + 12 * 6;  // and six boxes
  EXPECT_NE(said.find("of " + std::to_string(all) + " triangles"), std::string::npos) << said;
  ASSERT_GE(glb.find("vast"), 0);
  const json& vast_mesh =
      glb.file["meshes"][glb.file["nodes"][glb.find("vast")]["mesh"].get<int>()];
  const json& corners =
      glb.file["accessors"][vast_mesh["primitives"][0]["attributes"]["POSITION"].get<int>()];
  EXPECT_LE(corners["count"].get<size_t>() / 3, kMostGlbTriangles);
  // A flat sheet of 39.9 m stays one, but for a cell at its edges.
  EXPECT_NEAR(corners["max"][0].get<double>(), 39.9, 0.3);
  EXPECT_EQ(corners["max"][1].get<double>(), 0.0);
}

TEST(Glb, NamesOfAnyBytesAreUtf8AndUnique) {
  const auto walk = makeTestWalk();
  const char* const names[] = {"hips", "</script>\"'", "日本 \n", "\xff\xfe", "", ""};
  for (const char* const name : names)
    walk->scene.objects.push_back(testBox(name, {1, 1, 1}, {0, 0, 0}));
  const ReadGlb glb(written(walk->view));
  std::set<std::string> all;
  for (const json& node : glb.file["nodes"]) EXPECT_TRUE(all.insert(node["name"]).second);
  EXPECT_EQ(glb.find("hips"), 0);  // the joint
  EXPECT_GE(glb.find("</script>\"'"), 0);
  EXPECT_GE(glb.find("日本 \n"), 0);
}

TEST(Glb, JointsHaveTheNamesThatAreAsked) {
  const auto walk = makeTestWalk();
  const ReadGlb glb(written(walk->view, {.joint_names = {"pelvis", "thigh_l", "thigh_r"}}));
  EXPECT_EQ(glb.file["nodes"][2]["name"], "thigh_r");
}

TEST(Glb, HasTheReportButItsTimes) {
  const auto walk = makeTestWalk();
  const ReadGlb glb(
      written(walk->view, {.report = R"({"length": 4.5, "ok": true, "times": {"load": 1.0}})"}));
  const json& report = glb.file["scenes"][0]["extras"]["report"];
  EXPECT_EQ(report["length"], 4.5);
  EXPECT_EQ(report["ok"], true);
  EXPECT_FALSE(report.contains("times"));
}

TEST(Glb, TheSameWalkGivesTheSameBytes) {
  const auto walk = makeTestWalk();
  EXPECT_EQ(written(walk->view), written(walk->view));
}

TEST(Glb, ASingleJointAndASingleFrameAreAFileToo) {
  Joint alone;
  alone.name = "Cart";
  Clip clip{"cart", Skeleton({alone}), 1.0 / 30.0, PoseArray(1), {}};
  clip.poses.resize(1);
  const ReadGlb glb(written(clip, makeBoneFigure(clip.skeleton)));
  EXPECT_EQ(glb.file["skins"][0]["joints"].size(), 1);
  EXPECT_EQ(glb.file["animations"][0]["channels"].size(), 2);
}

}  // namespace
}  // namespace amble
