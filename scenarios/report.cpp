#include "scenarios/report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/rotation.h"
#include "planner/why/obstruction_text.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

// To a nanometre: below that a number says nothing of a walk, and a last bit must not make two
// reports differ to the eye. JSON knows no infinity.
Json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  constexpr double kPerMetre = 1e9;
  const double rounded = std::round(value * kPerMetre) / kPerMetre;
  return rounded == 0.0 ? 0.0 : rounded;  // no -0
}

Json inDegrees(double angle) { return number(angle / kDegree); }

Json vector(const Eigen::Vector3d& v) { return {number(v.x()), number(v.y()), number(v.z())}; }

const char* sideName(int side) { return side == kLeft ? "left" : "right"; }

Json stepsJson(const Report& report) {
  Json steps = Json::array();
  for (const StepMeasure& step : report.steps) {
    steps.push_back({{"foot", sideName(step.side)},
                     {"start", number(step.strike)},
                     {"end", number(step.lift_off)},
                     {"at", vector(step.at)},
                     {"stride", number(step.stride)},
                     {"lift", number(step.lift)},
                     {"climb", number(step.climb)},
                     {"slide", number(step.slide)}});
  }
  return steps;
}

Json clearanceJson(const ClearanceReport& clearance) {
  const bool near = !clearance.object.empty();
  return {{"min", number(clearance.min)},
          {"part", near ? Json(clearance.part) : Json(nullptr)},
          {"object", near ? Json(clearance.object) : Json(nullptr)},
          {"time", near ? number(clearance.time) : Json(nullptr)}};
}

Json bodyJson(const Report& report) {
  Json body = Json::array();
  for (const BodyPart& part : report.body) {
    body.push_back({{"part", part.name},
                    {"joint", report.joint_names.at(part.joint)},
                    {"from", vector(part.from)},
                    {"to", vector(part.to)},
                    {"radius", number(part.radius)},
                    {"sole", part.sole < 0 ? Json(nullptr) : Json(sideName(part.sole))}});
  }
  return body;
}

Json qualityJson(const Report& report) {
  Json quality = Json::array();
  for (const QualityLine& line : report.quality) {
    quality.push_back({{"measure", line.measure},
                       {"value", number(line.value)},
                       {"bar", number(line.bar)},
                       {"unit", line.unit},
                       {"holds", line.holds()}});
  }
  return quality;
}

Json walkJson(const Report& report) {
  return {{"length", number(report.length)},
          {"duration", number(report.duration)},
          {"frames", report.frames},
          {"frame_time", number(report.frame_time)},
          {"steps", stepsJson(report)},
          {"goal_error",
           {{"position", number(report.goal_position_error)},
            {"heading", inDegrees(report.goal_heading_error)}}},
          {"clearance", clearanceJson(report.clearance)},
          {"foot_skate",
           {{"mean", number(report.foot_skate_mean)}, {"max", number(report.foot_skate_max)}}},
          {"ground_penetration", {{"max", number(report.ground_penetration)}}},
          {"quality", qualityJson(report)}};
}

Json obstructionJson(const Obstruction& why) {
  const auto named = [](const std::string& name) {
    return name.empty() ? Json(nullptr) : Json(name);
  };
  const auto measured = [](const std::optional<double>& value) {
    return value ? number(*value) : Json(nullptr);
  };
  Json json = {{"rule", walkRuleName(why.rule)},
               {"lack", lackName(why.lack)},
               {"part", named(why.part)},
               {"object", named(why.object)},
               {"other", named(why.other)},
               {"at", vector(why.at)},
               {"width", measured(why.width)},
               {"needed", measured(why.needed)},
               {"overlap", measured(why.overlap)},
               {"slope", why.slope ? inDegrees(*why.slope) : Json(nullptr)},
               {"max_slope", why.max_slope ? inDegrees(*why.max_slope) : Json(nullptr)}};
  if (why.free) json["free"] = vector(*why.free);
  if (why.via) json["via"] = *why.via;
  return json;
}

Json reachedJson(const ReachedReport& reached) {
  return {
      {"area", number(reached.area)}, {"near", vector(reached.near)}, {"far", vector(reached.far)}};
}

Json searchJson(const Report& report) {
  Json refusals = Json::object();
  for (const auto& [rule, count] : report.refusals) refusals[rule] = count;
  return {{"roadmap",
           {{"guards", report.roadmap.guards},
            {"connectors", report.roadmap.connectors},
            {"edges", report.roadmap.edges},
            {"samples", report.roadmap.samples},
            {"coverage", number(report.roadmap.coverage)},
            {"refused", report.roadmap.refused}}},
          {"refusals", refusals},
          {"poses_checked", report.poses_checked}};
}

Json timesJson(const RunTimes& times) {
  const LoadTimes& loading = times.loading;
  return {{"load", number(times.load)},
          {"scene", number(loading.scene)},
          {"library", number(loading.library)},
          {"ground", number(loading.ground)},
          {"character", number(loading.character)},
          {"collision", number(loading.collision)},
          {"roadmap", number(times.roadmap)},
          {"search", number(times.search)},
          {"refine", number(times.refine)},
          {"export", number(times.export_)}};
}

}  // namespace

void writeJson(std::ostream& out, const Report& report, bool with_times) {
  Json json = {{"status", statusName(report.status)},
               {"scenario", report.scenario},
               {"seed", report.seed},
               {"planner", report.planner},
               {"stopped_by", report.stopped_by.empty() ? Json(nullptr) : Json(report.stopped_by)}};
  if (!report.why.empty()) {
    json["why"] = report.why;
    json["obstruction"] = report.obstruction ? obstructionJson(*report.obstruction) : Json(nullptr);
    json["proved"] = report.proved;
    json["reached"] = report.reached ? reachedJson(*report.reached) : Json(nullptr);
  }
  if (report.status == PlanStatus::kSolved) json.update(walkJson(report));
  json.update(searchJson(report));
  json["inputs"] = report.inputs;
  json["version"] = report.version;
  json["bvh_unit"] = number(report.bvh_unit);
  json["stature"] = number(report.stature);
  json["body"] = bodyJson(report);
  if (with_times) json["times"] = timesJson(report.times);
  // Names come from files: what is no UTF-8 in them is replaced, not thrown at.
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace amble
