#include "animation/library/library_parts_reader.h"

#include <cmath>

#include "base/rotation.h"
#include "base/strict_yaml.h"

namespace amble {
namespace {

std::array<int, 2> readFrames(const YamlNode& node) {
  const std::vector<YamlNode> frames = node.items();
  if (frames.size() != 2) node.fail("not two frames", "[first, last]");
  return {frames[0].asInt(0, 10000000, "frame"), frames[1].asInt(0, 10000000, "frame")};
}

}  // namespace

std::array<double, 2> degreePair(const YamlNode& node) {
  const Eigen::Vector2d v = node.asVec2("angles [degrees]");
  return {v[0] * kDegree, v[1] * kDegree};
}

Eigen::MatrixXd readMatrix(const YamlNode& node, int rows, int columns, const std::string& what) {
  const std::vector<YamlNode> items = node.items();
  if (static_cast<int>(items.size()) != rows) {
    node.fail(std::to_string(items.size()) + " channels", std::to_string(rows) + ", " + what);
  }
  Eigen::MatrixXd matrix(rows, columns);
  for (int i = 0; i < rows; ++i)
    matrix.row(i) = items[i].asVec(columns, "coefficients").transpose();
  return matrix;
}

std::vector<Eigen::Quaterniond> readRotations(const YamlNode& node, int joints) {
  const std::vector<YamlNode> items = node.items();
  if (static_cast<int>(items.size()) != joints) {
    node.fail(std::to_string(items.size()) + " rotations",
              std::to_string(joints) + ", one a joint");
  }
  std::vector<Eigen::Quaterniond> rotations;
  for (const YamlNode& item : items) {
    const Eigen::Vector4d q = item.asVec(4, "a quaternion [w, x, y, z]");
    if (std::abs(q.norm() - 1.0) > 1e-6) item.fail("not a rotation", "a unit quaternion");
    rotations.push_back(Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized());
  }
  return rotations;
}

Posture readPosture(const YamlNode& node, int joints) {
  node.requireKeys({"root_height", "root_forward", "step_width", "toe_out", "rotations"});
  Posture posture;
  posture.root_height = node.at("root_height").asPositive("height [m]", 5.0);
  posture.root_forward = node.at("root_forward").asDouble(-1.0, 1.0, "distance [m]");
  posture.step_width = node.at("step_width").asDouble(0.0, 1.0, "step width [m]");
  posture.toe_out = degreePair(node.at("toe_out"));
  posture.rotations = readRotations(node.at("rotations"), joints);
  return posture;
}

MotionSource readSource(const YamlNode& node, std::optional<MotionKind> of) {
  MotionSource source;
  if (of == MotionKind::kWalk && node.has("speed")) {
    node.requireKeys({"clip", "speed", "mirrored", "licence", "credit"});
    source.speed = node.at("speed").asPositive("speed [m/s]", 5.0);
  } else {
    if (of && !isPose(*of)) {
      node.requireKeys({"clip", "frames", "within", "mirrored", "licence", "credit"});
    } else {
      node.requireKeys({"clip", "frames", "mirrored", "licence", "credit"});
    }
    source.frames = readFrames(node.at("frames"));
    if (const YamlNode within = node["within"]) source.within = readFrames(within);
  }
  source.clip = node.at("clip").asString();
  if (const YamlNode m = node["mirrored"]) source.mirrored = m.asBool();
  source.licence = node.at("licence").asString();
  source.credit = node.at("credit").asString();
  return source;
}

CaptureQuality readCapture(const YamlNode& node) {
  node.requireKeys({"toe_skate", "root_acceleration", "joint_jerk", "pops"});
  CaptureQuality quality;
  quality.toe_skate = node.at("toe_skate").asDouble(0.0, 100.0, "speed [m/s]");
  quality.root_acceleration = node.at("root_acceleration").asDouble(0.0, 1e4, "[m/s^2]");
  quality.joint_jerk = node.at("joint_jerk").asDouble(0.0, 1e6, "[m/s^3]");
  quality.pops = node.at("pops").asDouble(0.0, 1e9, "a ratio");
  return quality;
}

JointRoles readRoles(const YamlNode& node, const Skeleton& skeleton) {
  JointRoles roles;
  for (const auto& [role, name] : node.entries()) {
    const int joint = skeleton.find(name.asString());
    if (joint < 0) name.fail("no joint " + name.asString(), "a joint of the skeleton");
    if (!setRole(roles, role, joint)) name.fail("no role " + role, "hips, left_up_leg, ...");
  }
  for (const LegJoints& leg : roles.legs) {
    if (leg.up_leg < 0 || leg.leg < 0 || leg.foot < 0 || leg.toe < 0) {
      node.fail("a leg's joint is missing", "up_leg, leg, foot and toe, left and right");
    }
  }
  return roles;
}

}  // namespace amble
