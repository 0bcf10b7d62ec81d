// What the workbench knows of a capture: curves of its joints, its root and its feet.
#include <cmath>
#include <nlohmann/json.hpp>

#include "animation/analysis/gait_phase.h"
#include "animation/analysis/motion_measures.h"
#include "animation/body/pelvis.h"
#include "base/rotation.h"
#include "viz/page/bench.h"
#include "viz/page/page_data.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kOfDegrees = 2, kOfMetres = 4, kOfSpeeds = 3;  // digits that can be seen
constexpr double kSmooth = 0.5;  // over which speed and turn rate are taken, as for analysis [s]

Json listOf(const std::string& numbers) { return Json::parse(numbers); }

// Euler angles of a joint in its own order, without jumps [degrees]: a list a channel.
std::array<std::vector<double>, 3> channelsOf(const Clip& clip, int joint) {
  std::array<std::vector<double>, 3> channels;
  const RotationOrder order = clip.skeleton.joint(joint).order;
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();
  for (int frame = 0; frame < clip.frames(); ++frame) {
    angles = unwrapEuler(toEuler(clip.poses.rotations(frame)[joint], order), angles);
    for (int i = 0; i < 3; ++i) channels[i].push_back(angles[i] / kDegree);
  }
  return channels;
}

Json jointsJson(const Clip& clip, const NumbersText& numbers) {
  Json joints = Json::array();
  for (int i = 0; i < clip.skeleton.size(); ++i) {
    const Joint& joint = clip.skeleton.joint(i);
    Json channels = Json::object();
    const auto curves = channelsOf(clip, i);
    for (int k = 0; k < 3; ++k)
      channels[std::string(1, joint.order[k])] = listOf(numbers(curves[k], kOfDegrees));
    joints.push_back(
        {{"name", joint.name}, {"parent", joint.parent}, {"channels", std::move(channels)}});
  }
  return joints;
}

// Rate of change of each list's values over kSmooth, a value a frame.
std::vector<double> ratesOf(const std::vector<double>& values, double frame_time) {
  const int frames = static_cast<int>(values.size());
  const int half = std::max(1, static_cast<int>(std::lround(0.5 * kSmooth / frame_time)));
  std::vector<double> rates(values.size(), 0.0);
  for (int i = 0; i < frames && frames > 1; ++i) {
    const int from = std::max(0, i - half), to = std::min(frames - 1, i + half);
    rates[i] = (values[to] - values[from]) / ((to - from) * frame_time);
  }
  return rates;
}

Json rootJson(const ShownClip& shown, const NumbersText& numbers) {
  const Clip& clip = shown.motion.clip;
  std::array<std::vector<double>, 3> root;
  for (int frame = 0; frame < clip.frames(); ++frame)
    for (int i = 0; i < 3; ++i) root[i].push_back(clip.poses.p_WR(frame)[i]);
  for (double& height : root[2]) height -= shown.floor;
  Json json = {{"x", listOf(numbers(root[0], kOfMetres))},
               {"y", listOf(numbers(root[1], kOfMetres))},
               {"height", listOf(numbers(root[2], kOfMetres))}};
  if (!shown.motion.no_person.empty()) return json;
  std::vector<double> x, y;
  for (const Eigen::Vector3d& p :
       smoothed(pelvisPath(clip, shown.motion.roles), clip.frame_time, kSmooth)) {
    x.push_back(p.x());
    y.push_back(p.y());
  }
  x = ratesOf(x, clip.frame_time);
  y = ratesOf(y, clip.frame_time);
  std::vector<double> speed,
      turn = ratesOf(pelvisHeadings(clip, shown.motion.roles), clip.frame_time);
  for (size_t i = 0; i < x.size(); ++i) speed.push_back(std::hypot(x[i], y[i]));
  for (double& rate : turn) rate /= kDegree;
  json["speed"] = listOf(numbers(speed, kOfSpeeds));
  json["turn_rate"] = listOf(numbers(turn, kOfDegrees));
  return json;
}

// Ankle (0) or toe (1): its curves, and the thresholds below which it is planted.
Json pointJson(const PlantTrace& trace, int point, const NumbersText& numbers) {
  const Eigen::VectorXd height = trace.signals.height.col(point);
  const Eigen::VectorXd speed = trace.signals.speed.col(point);
  return {
      {"height", listOf(numbers({height.data(), static_cast<size_t>(height.size())}, kOfMetres))},
      {"speed", listOf(numbers({speed.data(), static_cast<size_t>(speed.size())}, kOfSpeeds))},
      {"height_limit", trace.limits.height[point]},
      {"speed_limit", trace.limits.speed[point]}};
}

Json feetJson(const ShownClip& shown, const NumbersText& numbers) {
  if (!shown.feet) return nullptr;
  Json feet = Json::array();
  for (const PlantTrace& trace : *shown.feet)
    feet.push_back({{"ankle", pointJson(trace, 0, numbers)},
                    {"toe", pointJson(trace, 1, numbers)},
                    {"still", trace.limits.still}});
  return feet;
}

Json phaseJson(const ShownClip& shown) {
  Json moments = Json::array();
  if (!shown.analysis) return moments;
  for (const PhaseMoment& moment : gaitPhase(shown.analysis->plants))
    moments.push_back({moment.frame + shown.first_frame, moment.phase});
  return moments;
}

}  // namespace

std::string benchClipJson(const BenchClip& clip, const NumbersText& numbers) {
  const ShownClip& shown = *clip.shown;
  Json facts = Json::array();
  for (const auto& [label, value] : clip.facts) facts.push_back({label, value});
  const Json json = {
      {"file", shown.file},
      {"kind", "clip"},
      {"frame_time", shown.motion.clip.frame_time / shown.every},
      {"every", shown.every},
      {"first_frame", shown.first_frame},
      {"floor", shown.floor},
      {"analysis", clip.analysis.empty() ? Json(nullptr) : Json::parse(clip.analysis)},
      {"facts", std::move(facts)},
      {"warnings", shown.motion.warnings},
      {"joints", jointsJson(shown.motion.clip, numbers)},
      {"root", rootJson(shown, numbers)},
      {"feet", feetJson(shown, numbers)},
      {"phase", phaseJson(shown)}};
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace amble
