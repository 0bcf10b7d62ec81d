// What `amble library engine show` and `amble inspect` say of speed engines.

#include <fmt/format.h>

#include "animation/library/speed_engine_reader.h"
#include "app/findings.h"
#include "base/rotation.h"

namespace amble {
namespace {

using nlohmann::ordered_json;

std::string leftOutText(const LeftOut& left_out) {
  return fmt::format("; left out {:.1f} degrees, legs {:.1f} (nearest clip {:.1f}, {:.1f}){}",
                     left_out.joints / kDegree, left_out.legs / kDegree,
                     left_out.nearest_joints / kDegree, left_out.nearest_legs / kDegree,
                     left_out.between ? "" : ", at an end");
}

ordered_json clipData(const EngineClip& clip) {
  const MotionSource& source = clip.source;
  ordered_json data = {{"clip", source.clip},       {"frames", source.frames},
                       {"licence", source.licence}, {"credit", source.credit},
                       {"speed", clip.speed},       {"frequency", clip.frequency},
                       {"cycles", clip.cycles}};
  if (clip.left_out) {
    data["left_out"] = {{"between", clip.left_out->between},
                        {"joints", clip.left_out->joints / kDegree},
                        {"legs", clip.left_out->legs / kDegree},
                        {"nearest_joints", clip.left_out->nearest_joints / kDegree},
                        {"nearest_legs", clip.left_out->nearest_legs / kDegree}};
  }
  return data;
}

// Means over the clips that have others slower and faster; nothing where there are none.
std::string leftOutMeans(const GaitSpace& space, ordered_json& data) {
  LeftOut sum;
  int count = 0;
  for (const EngineClip& clip : space.clips) {
    if (!clip.left_out || !clip.left_out->between) continue;
    sum.joints += clip.left_out->joints;
    sum.legs += clip.left_out->legs;
    sum.nearest_joints += clip.left_out->nearest_joints;
    sum.nearest_legs += clip.left_out->nearest_legs;
    ++count;
  }
  if (count == 0) return "";
  const double share = 1.0 / (count * kDegree);
  data["left_out"] = {{"clips", count},
                      {"joints", share * sum.joints},
                      {"legs", share * sum.legs},
                      {"nearest_joints", share * sum.nearest_joints},
                      {"nearest_legs", share * sum.nearest_legs}};
  return fmt::format(
      "one clip of {} left out between the others: {:.2f} degrees, legs {:.2f}; the nearest clip "
      "{:.2f}, {:.2f}",
      count, share * sum.joints, share * sum.legs, share * sum.nearest_joints,
      share * sum.nearest_legs);
}

// How wide the prints are, and how far toes are out: at the slowest and the fastest capture.
void addPrints(const GaitSpace& space, Findings& out, ordered_json& data) {
  std::string text;
  data["prints"] = ordered_json::array();
  for (const double speed : {space.slowest(), space.fastest()}) {
    const double width = space.step_width.at(speed);
    const std::array<double, 2> toe_out = {space.toe_out[kLeft].at(speed) / kDegree,
                                           space.toe_out[kRight].at(speed) / kDegree};
    text += fmt::format("{}{:.3f} m wide, toes out by {:.1f} and {:.1f} degrees at {:.2f} m/s",
                        text.empty() ? "" : "; ", width, toe_out[kLeft], -toe_out[kRight], speed);
    data["prints"].push_back({{"speed", speed}, {"step_width", width}, {"toe_out", toe_out}});
  }
  out.facts.emplace_back("prints", text);
}

void addSpace(const std::string& gait, const GaitSpace& space, Findings& out) {
  const FrequencyFit& law = space.law;
  ordered_json data = {{"slowest", space.slowest()},
                       {"fastest", space.fastest()},
                       {"components", ordered_json::array()},
                       {"variance", space.variance()},
                       {"law",
                        {{"factor", law.law.factor},
                         {"power", law.law.power},
                         {"own_power", law.own_power},
                         {"residual", law.residual}}},
                       {"clips", ordered_json::array()}};
  out.facts.emplace_back(gait, fmt::format("{:.2f} to {:.2f} m/s, {} clips", space.slowest(),
                                           space.fastest(), space.clips.size()));
  std::string shares;
  for (const PrincipalComponent& component : space.components) {
    shares += fmt::format("{}{:.0f}", shares.empty() ? "" : " + ", 100.0 * component.share);
    data["components"].push_back({{"share", component.share},
                                  {"at_zero", component.coefficient.at_zero},
                                  {"slope", component.coefficient.slope}});
  }
  out.facts.emplace_back(
      "components", shares.empty()
                        ? "none: the speeds are too near each other for lines; the mean is taken"
                        : fmt::format("{} for {:.0f} % of the variance ({})",
                                      space.components.size(), 100.0 * space.variance(), shares));
  out.facts.emplace_back(
      "law", fmt::format("f = {:.3f} V^{:.3f}{}, {:.1f} % off", law.law.factor, law.law.power,
                         law.own_power ? "" : " (the power is Inman's)", 100.0 * law.residual));
  addPrints(space, out, data);
  for (const EngineClip& clip : space.clips) {
    out.facts.emplace_back(
        "", fmt::format("{:.3f} m/s, {:.3f} Hz, {} cycles of {} frames {} to {} ({}){}", clip.speed,
                        clip.frequency, clip.cycles, clip.source.clip, clip.source.frames[0],
                        clip.source.frames[1], clip.source.licence,
                        clip.left_out ? leftOutText(*clip.left_out) : ""));
    data["clips"].push_back(clipData(clip));
  }
  if (const std::string means = leftOutMeans(space, data); !means.empty()) {
    out.facts.emplace_back("left out", means);
  }
  out.data[gait] = std::move(data);
}

}  // namespace

Findings inspectEngine(const std::filesystem::path& file) {
  const SpeedEngine engine(readSpeedEngine(file));
  const EngineData& data = engine.data();
  Findings out{file.string(), "speed engine", {}, {}, {}};
  out.facts = {{"skeleton", fmt::format("{} joints, stature {:.2f} m, legs {:.3f} m",
                                        engine.joints(), data.stature, engine.leg())},
               {"speeds", fmt::format("{:.2f} to {:.2f} m/s", engine.slowest(), engine.fastest())}};
  out.data = {{"joints", engine.joints()},
              {"stature", data.stature},
              {"leg", engine.leg()},
              {"slowest", engine.slowest()},
              {"fastest", engine.fastest()}};
  if (data.walk) addSpace("walk", *data.walk, out);
  if (data.run) addSpace("run", *data.run, out);
  return out;
}

}  // namespace amble
