#include "viz/figure/figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/rotation.h"
#include "tests/environments/test_walker.h"
#include "tests/viz/test_walk.h"

namespace amble {
namespace {

using Eigen::Vector3d;

const TestWalker& walker() {
  static const TestWalker person;
  return person;
}

const Figure& figure() {
  static const Figure made = makeFigure(walker().skeleton, walker().body);
  return made;
}

// Vertices in a pose, as viewers skin them.
std::vector<Vector3d> skinned(const Figure& skin, const std::vector<JointFrame>& frames) {
  std::vector<Vector3d> placed;
  for (size_t i = 0; i < skin.vertices.size(); ++i) {
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < 4; ++k) {
      const int joint = skin.joints[i][k];
      const JointFrame& bind = skin.bind[joint];
      const Vector3d p_J = bind.q_WJ.conjugate() * (skin.vertices[i].cast<double>() - bind.p_WJ);
      sum += skin.weights[i][k] * (frames[joint] * p_J);
    }
    placed.push_back(sum);
  }
  return placed;
}

std::vector<JointFrame> framesOf(const Pose& pose) {
  std::vector<JointFrame> frames(walker().skeleton.size());
  forwardKinematics(walker().skeleton, pose, frames);
  return frames;
}

double volumeOf(const Figure& skin, const std::vector<Vector3d>& at) {
  double six = 0.0;
  for (const auto& t : skin.triangles) six += at[t[0]].dot(at[t[1]].cross(at[t[2]]));
  return six / 6.0;
}

double distanceToCapsule(const Vector3d& p, const Vector3d& a, const Vector3d& b, double radius) {
  const Vector3d axis = b - a;
  const double squared = axis.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(axis) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * axis).norm() - radius;
}

// How far the figure is outside of its capsules at most, in a pose.
double outOfCapsules(const Figure& skin, const Body& body, const std::vector<JointFrame>& frames) {
  double most = -1.0;
  for (const Vector3d& p : skinned(skin, frames)) {
    double least = 1.0;
    for (const BodyPart& part : body.parts) {
      const JointFrame& joint = frames[part.joint];
      least =
          std::min(least, distanceToCapsule(p, joint * part.from, joint * part.to, part.radius));
    }
    most = std::max(most, least);
  }
  return most;
}

// Of a closed surface every edge is there once in either direction.
bool isClosed(const Figure& skin) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : skin.triangles)
    for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    return edge.second == 1 && edges.contains({edge.first.second, edge.first.first});
  });
}

// A human body is as dense as water, within 5 percent.
constexpr double kDensity = 1000.0;  // [kg/m^3]

TEST(Figure, IsClosed) { EXPECT_TRUE(isClosed(figure())); }

// Euler: a sphere with no handle. A limb that had run into another would make one.
TEST(Figure, HasNoHandleAndNoPieceApart) {
  const size_t faces = figure().triangles.size(), corners = figure().vertices.size();
  EXPECT_EQ(corners + faces, 3 * faces / 2 + 2);
}

TEST(Figure, HasTwoToFiveThousandTriangles) {
  EXPECT_GE(figure().triangles.size(), 2000);
  EXPECT_LE(figure().triangles.size(), 5000);
}

TEST(Figure, WeighsWhatAPersonOfItsStatureDoes) {
  const double kilograms = kDensity * volumeOf(figure(), skinned(figure(), figure().bind));
  const double body_mass_index = kilograms / (walker().stature * walker().stature);
  EXPECT_GT(body_mass_index, 17.0);
  EXPECT_LT(body_mass_index, 28.0);
}

TEST(Figure, NormalsAreUnitAndFaceAsTheirTrianglesDo) {
  const Figure& skin = figure();
  std::vector<Vector3d> sums(skin.vertices.size(), Vector3d::Zero());
  for (const auto& t : skin.triangles) {
    const Eigen::Vector3f &a = skin.vertices[t[0]], &b = skin.vertices[t[1]],
                          &c = skin.vertices[t[2]];
    for (const auto v : t) sums[v] += (b - a).cross(c - a).cast<double>();
  }
  for (size_t i = 0; i < sums.size(); ++i) {
    EXPECT_NEAR(skin.normals[i].norm(), 1.0, 1e-5);
    EXPECT_GT(sums[i].normalized().dot(skin.normals[i].cast<double>()), 0.5) << i;
  }
}

TEST(Figure, WeightsSumToOneAndHangOnJointsThatAreThere) {
  const Figure& skin = figure();
  for (size_t i = 0; i < skin.vertices.size(); ++i) {
    float sum = 0.0F;
    for (int k = 0; k < 4; ++k) {
      EXPECT_GE(skin.weights[i][k], 0.0F);
      EXPECT_LT(skin.joints[i][k], walker().skeleton.size());
      sum += skin.weights[i][k];
    }
    EXPECT_NEAR(sum, 1.0F, 1e-6F);
  }
}

TEST(Figure, LiesWithinTheCapsulesButForNoseAndThumbs) {
  EXPECT_LT(outOfCapsules(figure(), walker().body, figure().bind), 0.025);
  EXPECT_LT(outOfCapsules(figure(), walker().body, framesOf(walker().standing(0, 0))), 0.025);
}

TEST(Figure, StandsOnItsSolesAndReachesItsStature) {
  double low = 1.0, high = 0.0;
  for (const Vector3d& p : skinned(figure(), framesOf(walker().standing(0, 0)))) {
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  EXPECT_NEAR(low, 0.0, 0.003);
  EXPECT_NEAR(high, walker().stature, 0.01);
}

// Where the head ends in front it is as narrow as a nose, behind as broad as a head.
TEST(Figure, FacesAhead) {
  std::vector<Vector3d> head;
  for (const Vector3d& p : skinned(figure(), framesOf(walker().standing(0, 0))))
    if (p.z() > walker().stature - 0.17) head.push_back(p);
  const auto [back, fore] = std::minmax_element(
      head.begin(), head.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  double before = 0.0, behind = 0.0;  // half breadths
  for (const Vector3d& p : head) {
    if (p.x() > fore->x() - 0.015) before = std::max(before, std::abs(p.y()));
    if (p.x() < back->x() + 0.015) behind = std::max(behind, std::abs(p.y()));
  }
  EXPECT_LT(before, 0.02);
  EXPECT_GT(behind, 0.035);
}

Pose bent(double knees, double elbows, double arms) {
  Pose pose = walker().standing(0, 0);
  for (const Side side : {kLeft, kRight}) {
    const double sign = side == kLeft ? 1.0 : -1.0;
    pose.rotations[walker().roles.legs[side].leg] = expRotation(knees * Vector3d::UnitX());
    pose.rotations[walker().roles.legs[side].up_leg] =
        expRotation(-0.5 * knees * Vector3d::UnitX());
    pose.rotations[walker().roles.arms[side].fore_arm] =
        expRotation(-sign * elbows * Vector3d::UnitY());
    pose.rotations[walker().roles.arms[side].arm] = expRotation(sign * arms * Vector3d::UnitZ());
  }
  return pose;
}

TEST(Figure, KeepsItsVolumeWhereKneesAndElbowsBendAndArmsAreRaised) {
  const double before = volumeOf(figure(), skinned(figure(), figure().bind));
  for (const Pose& pose :
       {bent(1.2, 0, -1.3), bent(0, 1.5, 0), bent(0.5, 0.5, 0.9), bent(1.8, 1.5, 0)})
    EXPECT_NEAR(volumeOf(figure(), skinned(figure(), framesOf(pose))) / before, 1.0, 0.05);
}

// A limb that goes through a fold of its own skin would have some triangles turned over.
TEST(Figure, FewTrianglesAreFlatOrLongWhereItBends) {
  const auto placed = skinned(figure(), framesOf(bent(1.2, 1.2, -1.2)));
  int long_ones = 0;
  for (const auto& t : figure().triangles)
    for (int i = 0; i < 3; ++i) {
      const auto a = t[i], b = t[(i + 1) % 3];
      const double before = (figure().vertices[a] - figure().vertices[b]).norm();
      long_ones += (placed[a] - placed[b]).norm() > 2.0 * before + 0.02;
    }
  EXPECT_EQ(long_ones, 0);
}

// A rig of which nobody stands in the rest pose: all bones upwards.
TEST(Figure, IsWholeWhereTheRestPoseHasLegsAndArmsAgainstTheTrunk) {
  std::vector<Joint> joints = walker().skeleton.joints();
  BodyStance stance;
  std::vector<Eigen::Quaterniond> q(joints.size(), Eigen::Quaterniond::Identity());
  const Eigen::Quaterniond to_heading = aboutZ(0.5 * kPi) * yUpToWorld();
  // Every joint's frame is turned so that its bone points along y; the pose undoes that.
  std::vector<Eigen::Quaterniond> turns(joints.size(), Eigen::Quaterniond::Identity());
  for (size_t j = 1; j < joints.size(); ++j) {
    if (joints[j].offset.norm() > 0.0 && joints[j].parent > 0)
      turns[joints[j].parent] = turnBetween(joints[j].offset, Vector3d::UnitY());
  }
  for (size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].parent >= 0) joints[j].offset = turns[joints[j].parent] * joints[j].offset;
    for (Vector3d& tip : joints[j].end_sites) tip = turns[j] * tip;
    stance.upright.q_HJ.push_back(to_heading * turns[j].conjugate());
  }
  const Skeleton rig(joints);
  const Body body =
      makeBody(rig, walker().roles, walker().stature, evenSoles({0.06, 0.02}), stance);
  const Figure skin = makeFigure(rig, body);
  EXPECT_TRUE(isClosed(skin));
  EXPECT_EQ(skin.vertices.size() + skin.triangles.size(), 3 * skin.triangles.size() / 2 + 2);
}

TEST(Figure, OfAChildAndOfAGiantIsThatOfTheMeanScaled) {
  for (const double factor : {0.3, 1.8}) {
    const Skeleton scaled = walker().skeleton.scaled(factor);
    const Body body =
        makeBody(scaled, walker().roles, factor * walker().stature,
                 evenSoles({factor * walker().foot.ankle_height, factor * walker().foot.radius}));
    const Figure skin = makeFigure(scaled, body);
    EXPECT_TRUE(isClosed(skin));
    EXPECT_LE(skin.triangles.size(), 5000);
    EXPECT_NEAR(volumeOf(skin, skinned(skin, skin.bind)) / std::pow(factor, 3),
                volumeOf(figure(), skinned(figure(), figure().bind)), 0.002);
  }
}

TEST(Figure, OfABodyWithOtherPartsIsItsCapsules) {
  const auto walk = makeTestWalk();
  const Figure skin = makeFigure(walk->skeleton, walk->body);
  EXPECT_TRUE(isClosed(skin));
  EXPECT_LT(outOfCapsules(skin, walk->body, skin.bind), 0.003);
}

}  // namespace
}  // namespace amble
