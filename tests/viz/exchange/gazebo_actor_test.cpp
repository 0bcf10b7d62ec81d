#include "viz/exchange/gazebo_actor.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <pugixml.hpp>
#include <sstream>

#include "base/rotation.h"
#include "tests/viz/test_walk.h"

namespace amble {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// An arm of three joints along x, and a fourth that hangs on the first; its bind pose is bent.
struct Arm {
  Skeleton skeleton;
  Figure figure;
};

Joint jointAt(const std::string& name, int parent, const Vector3d& offset) {
  Joint joint;
  joint.name = name;
  joint.parent = parent;
  joint.offset = offset;
  return joint;
}

Arm makeArm() {
  Arm arm;
  arm.skeleton = Skeleton({jointAt("root", -1, {0, 0, 0}), jointAt("upper", 0, {0.1, 0, 0}),
                           jointAt("side", 0, {0, 0.2, 0}), jointAt("lower", 1, {0.3, 0, 0})});
  Pose bent;
  bent.rotations.assign(4, Eigen::Quaterniond::Identity());
  bent.rotations[0] = yUpToWorld();
  bent.rotations[1] = Eigen::AngleAxisd(0.9, Vector3d(0.2, 0.5, 1).normalized());
  bent.rotations[3] = Eigen::AngleAxisd(-1.1, Vector3d(0, 1, 0.3).normalized());
  Figure& figure = arm.figure;
  figure.bind.resize(4);
  forwardKinematics(arm.skeleton, bent, figure.bind);
  for (int i = 0; i < 12; ++i) {
    const float share = static_cast<float>(i % 4) / 3.0f;
    figure.vertices.push_back(Vector3f(0.05f * static_cast<float>(i), 0.03f, 0.4f * share));
    figure.normals.push_back(Vector3f(1, share, 0.3f).normalized());
    figure.colors.push_back({static_cast<std::uint8_t>(i < 6 ? 200 : 40), 30, 30});
    figure.joints.push_back({1, 3, 0, 2});
    figure.weights.push_back({share, 1 - share, 0, 0});
  }
  for (std::uint32_t i = 0; i < 12; i += 3) figure.triangles.push_back({i, i + 1, i + 2});
  return arm;
}

std::vector<double> numbersOf(const pugi::xml_node& node) {
  std::istringstream text(node.text().get());
  std::vector<double> numbers;
  for (double number; text >> number;) numbers.push_back(number);
  return numbers;
}

TEST(GazeboActor, SkinnedBackTheRestedFigureIsTheFigure) {
  const Arm arm = makeArm();
  const Figure rested = restedFigure(arm.skeleton, arm.figure);
  for (size_t v = 0; v < rested.vertices.size(); ++v) {
    Vector3d p = Vector3d::Zero();
    for (size_t k = 0; k < 4; ++k) {
      const JointFrame& rest = rested.bind[rested.joints[v][k]];
      const Vector3d own = rest.q_WJ.conjugate() * (rested.vertices[v].cast<double>() - rest.p_WJ);
      p += rested.weights[v][k] * (arm.figure.bind[rested.joints[v][k]] * own);
    }
    EXPECT_LT((p - arm.figure.vertices[v].cast<double>()).norm(), 1e-5) << v;
    EXPECT_NEAR(rested.normals[v].norm(), 1.0, 1e-5);
  }
}

TEST(GazeboActor, RestsAsTheBvhDoes) {
  const Arm arm = makeArm();
  const Figure rested = restedFigure(arm.skeleton, arm.figure);
  EXPECT_LT((rested.bind[3].p_WJ - Vector3d(0.4, 0, 0)).norm(), 1e-12) << "the sum of the offsets";
  EXPECT_LT((rested.bind[2].p_WJ - Vector3d(0, 0, 0.2)).norm(), 1e-12) << "y is up in the file";
}

// Of the document's joints, with all that they hang under, as the file has them.
struct ReadJoint {
  std::string name, parent;
};
void readJoints(const pugi::xml_node& node, std::vector<ReadJoint>& joints) {
  for (const pugi::xml_node& child : node.children("node")) {
    if (std::string(child.attribute("type").value()) != "JOINT") continue;
    joints.push_back({child.attribute("name").value(), node.attribute("name").value()});
    readJoints(child, joints);
  }
}

TEST(GazeboActor, TheSkinHasTheTreeOfTheBvh) {
  const Arm arm = makeArm();
  const std::vector<std::string> names = {"root", "1_upper", "side", "lower"};
  std::ostringstream out;
  writeSkinCollada(out, arm.skeleton, arm.figure, names);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(out.str().c_str()));
  std::vector<ReadJoint> joints;
  readJoints(document.select_node("//visual_scene").node(), joints);
  ASSERT_EQ(joints.size(), 4u);
  EXPECT_EQ(joints[1].name, "_1_upper") << "no name begins with a digit";
  EXPECT_EQ(joints[2].name, "lower") << "limb by limb, as a BVH";
  EXPECT_EQ(joints[2].parent, "_1_upper");
  EXPECT_EQ(joints[3].name, "side");
}

TEST(GazeboActor, EveryVertexHangsOnJointsWithWeightsThatSumToOne) {
  const Arm arm = makeArm();
  std::ostringstream out;
  writeSkinCollada(out, arm.skeleton, arm.figure, std::vector<std::string>{"a", "b", "c", "d"});
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(out.str().c_str()));
  const auto weights =
      numbersOf(document.select_node("//float_array[@id='figure-weights-array']").node());
  const auto counts = numbersOf(document.select_node("//vcount").node());
  const auto pairs = numbersOf(document.select_node("//vertex_weights/v").node());
  ASSERT_EQ(counts.size(), 12u);
  size_t at = 0;
  for (size_t v = 0; v < counts.size(); ++v) {
    double sum = 0.0;
    for (int k = 0; k < counts[v]; ++k, at += 2) {
      EXPECT_TRUE(pairs.at(at) == 1 || pairs.at(at) == 3);
      sum += weights.at(static_cast<size_t>(pairs.at(at + 1)));
    }
    EXPECT_NEAR(sum, 1.0, 1e-6);
  }
  EXPECT_EQ(at, pairs.size());
  size_t corners = 0;
  for (const auto& group : document.select_nodes("//triangles/p"))
    corners += numbersOf(group.node()).size() / 2;
  EXPECT_EQ(corners, 12u) << "of four triangles, in two colours";
  EXPECT_EQ(document.select_nodes("//triangles").size(), 2u);
}

TEST(GazeboActor, TheActorNamesItsFilesAndTheUnitOfTheBvh) {
  std::ostringstream out;
  writeActorSdf(out, 0.01, true);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(out.str().c_str()));
  const pugi::xml_node actor = document.child("sdf").child("world").child("actor");
  EXPECT_STREQ(actor.child("skin").child_value("filename"), "walk.dae");
  EXPECT_STREQ(actor.child("animation").child_value("filename"), "walk.bvh");
  EXPECT_STREQ(actor.child("animation").child_value("scale"), "0.01");
  EXPECT_FALSE(actor.child("script").child("trajectory")) << "the root's motion is the BVH's";
}

TEST(GazeboActor, TheRoomIsTheSceneInWorld) {
  const Scene scene = testRoom();
  std::ostringstream out;
  writeRoomCollada(out, scene, 0.0);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(out.str().c_str()));
  const auto positions =
      numbersOf(document.select_node("//source[@id='room-positions']/float_array").node());
  const auto normals =
      numbersOf(document.select_node("//source[@id='room-normals']/float_array").node());
  Eigen::AlignedBox3d box;
  for (size_t i = 0; i + 2 < positions.size(); i += 3)
    box.extend(Vector3d(positions[i], positions[i + 1], positions[i + 2]));
  EXPECT_TRUE(box.min().isApprox(scene.bounds().min(), 1e-4));
  EXPECT_TRUE(box.max().isApprox(scene.bounds().max(), 1e-4));
  // Corners in pairs, of a position and the normal of their triangle.
  size_t triangles = 0;
  double volume = 0.0;
  for (const auto& group : document.select_nodes("//triangles/p")) {
    const auto corners = numbersOf(group.node());
    for (size_t i = 0; i + 5 < corners.size(); i += 6, ++triangles) {
      std::array<Vector3d, 3> p;
      for (size_t k = 0; k < 3; ++k)
        p[k] = Eigen::Map<const Vector3d>(&positions[3 * static_cast<size_t>(corners[i + 2 * k])]);
      const Vector3d across = (p[1] - p[0]).cross(p[2] - p[0]);
      const Vector3d normal =
          Eigen::Map<const Vector3d>(&normals[3 * static_cast<size_t>(corners[i + 1])]);
      EXPECT_LT((across.normalized() - normal).norm(), 1e-3);
      volume += p[0].dot(across) / 6.0;
    }
  }
  EXPECT_EQ(triangles, 12 * scene.objects.size());
  double boxes = 0.0;
  for (const SceneObject& object : scene.objects) boxes += std::get<Box>(object.shape).size.prod();
  EXPECT_NEAR(volume, boxes, 1e-3) << "each box is closed, its triangles turned outwards";
}

TEST(GazeboActor, TheRoomStandsStillAndIsLeftOutWhereItIsNotAskedFor) {
  for (const bool with_room : {true, false}) {
    std::ostringstream out;
    writeActorSdf(out, 1.0, with_room);
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(out.str().c_str()));
    const pugi::xml_node model = document.child("sdf").child("world").child("model");
    EXPECT_EQ(static_cast<bool>(model), with_room);
    if (!with_room) continue;
    EXPECT_STREQ(model.child_value("static"), "true");
    EXPECT_STREQ(model.select_node("link/visual/geometry/mesh/uri").node().child_value(),
                 "room.dae");
  }
}

}  // namespace
}  // namespace amble
