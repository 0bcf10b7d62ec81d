#include "animation/library/speed_engine_reader.h"

#include <cmath>

#include "animation/captures/bvh.h"
#include "animation/library/library_parts_reader.h"
#include "animation/library/statures.h"
#include "base/rotation.h"
#include "base/strict_yaml.h"

namespace amble {
namespace {

constexpr double kUnitLength = 1e-3;  // to which a direction's length is 1: its digits [1]
constexpr double kFastest = 15.0;     // nobody runs faster [m/s]

SpeedLine readLine(const YamlNode& node, double unit = 1.0) {
  const Eigen::VectorXd v = node.asVec(2, "numbers, [at speed 0, slope]");
  return {v[0] * unit, v[1] * unit};
}

std::array<SpeedLine, 2> readLines(const YamlNode& node, double unit = 1.0) {
  const std::vector<YamlNode> lines = node.items();
  if (lines.size() != 2) node.fail(std::to_string(lines.size()) + " lines", "two");
  return {readLine(lines[0], unit), readLine(lines[1], unit)};
}

LeftOut readLeftOut(const YamlNode& node) {
  node.requireKeys({"between", "joints", "legs", "nearest_joints", "nearest_legs"});
  const auto angle = [&](const char* key) {
    return node.at(key).asDouble(0.0, 180.0, "angle [degrees]") * kDegree;
  };
  return {node.at("between").asBool(), angle("joints"), angle("legs"), angle("nearest_joints"),
          angle("nearest_legs")};
}

EngineClip readClip(const YamlNode& node) {
  node.requireKeys({"speed", "frequency", "cycles", "capture", "left_out", "source"});
  EngineClip clip;
  clip.speed = node.at("speed").asPositive("speed [m/s]", kFastest);
  clip.frequency = node.at("frequency").asPositive("frequency [Hz]", 10.0);
  clip.cycles = node.at("cycles").asInt(1, 1000, "cycles");
  clip.capture = readCapture(node.at("capture"));
  if (const YamlNode left_out = node["left_out"]) clip.left_out = readLeftOut(left_out);
  clip.source = readSource(node.at("source"));
  return clip;
}

FrequencyFit readLaw(const YamlNode& node) {
  node.requireKeys({"factor", "power", "own_power", "residual", "samples"});
  FrequencyFit fit;
  fit.law.factor = node.at("factor").asPositive("factor", 10.0);
  fit.law.power = node.at("power").asDouble(-2.0, 2.0, "power");
  fit.own_power = node.at("own_power").asBool();
  fit.residual = node.at("residual").asDouble(0.0, 10.0, "residual");
  fit.samples = node.at("samples").asInt(1, 1000000, "samples");
  return fit;
}

PrincipalComponent readComponent(const YamlNode& node, int rows) {
  node.requireKeys({"share", "coefficient", "direction"});
  PrincipalComponent component;
  component.share = node.at("share").asDouble(0.0, 1.0, "share");
  component.coefficient = readLine(node.at("coefficient"));
  component.direction = readMatrix(node.at("direction"), rows, kEnginePhases, "three a joint");
  const double length = component.direction.norm();
  if (std::abs(length - 1.0) > kUnitLength) {
    node.at("direction").fail("is " + std::to_string(length) + " long", "a direction of length 1");
  }
  return component;
}

GaitSpace readSpace(const YamlNode& node, int joints) {
  node.requireKeys({"clips", "law", "support", "step_width", "foot_forward", "toe_out", "root",
                    "mean", "components"});
  GaitSpace space;
  for (const YamlNode& item : node.at("clips").items()) {
    space.clips.push_back(readClip(item));
    const size_t n = space.clips.size();
    if (n > 1 && space.clips[n - 1].speed < space.clips[n - 2].speed) {
      item.fail("is slower than the clip before", "clips by speed");
    }
  }
  if (space.clips.empty()) node.at("clips").fail("no clips", "one or more");
  space.law = readLaw(node.at("law"));
  space.support = readLines(node.at("support"));
  space.step_width = readLine(node.at("step_width"));
  space.foot_forward = readLines(node.at("foot_forward"));
  space.toe_out = readLines(node.at("toe_out"), kDegree);
  space.root = readMatrix(node.at("root"), 6, kEnginePhases, "forward, left, height and slopes");
  space.mean = readMatrix(node.at("mean"), 3 * joints, kEnginePhases, "three a joint");
  for (const YamlNode& item : node.at("components").items()) {
    space.components.push_back(readComponent(item, 3 * joints));
  }
  return space;
}

}  // namespace

bool isSpeedEngine(const std::filesystem::path& file) {
  const YamlNode root = readYaml(file);
  return root.isMap() && root.has("skeleton") && root.has("mean_posture");
}

EngineData readSpeedEngine(const std::filesystem::path& file) {
  const YamlNode root = readYaml(file);
  root.requireKeys(
      {"skeleton", "stature", "joints", "mean_posture", "posture", "source", "walk", "run"});
  EngineData engine;
  engine.file = file;
  engine.skeleton_file = root.at("skeleton").asString();
  engine.skeleton = readBvh(root.at("skeleton").asPath()).skeleton;
  engine.roles = readRoles(root.at("joints"), engine.skeleton);
  engine.stature = root.at("stature").asDouble(kShortestStature, kTallestStature, "stature [m]");
  const int joints = engine.skeleton.size();
  engine.mean_posture = readRotations(root.at("mean_posture"), joints);
  engine.stand = readPosture(root.at("posture"), joints);
  engine.stand_source = readSource(root.at("source"));
  if (const YamlNode walk = root["walk"]) engine.walk = readSpace(walk, joints);
  if (const YamlNode run = root["run"]) engine.run = readSpace(run, joints);
  if (!engine.walk && !engine.run) root.fail("neither walks nor runs", "`walk`, `run` or both");
  return engine;
}

}  // namespace amble
