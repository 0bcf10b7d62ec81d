#include "batch/labels/walk_row.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "planner/legs/planner.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) {
  constexpr double kParts = 1e6;  // of a metre or a second
  const double to = std::round(value * kParts) / kParts;
  return to == 0.0 ? 0.0 : to;
}

Json placeJson(const std::optional<Eigen::Vector3d>& p) {
  if (!p) return nullptr;
  return {rounded(p->x()), rounded(p->y()), rounded(p->z())};
}

std::optional<Eigen::Vector3d> placeOf(const Json& json) {
  if (!json.is_array()) return std::nullopt;
  return Eigen::Vector3d(json.at(0), json.at(1), json.at(2));
}

std::string field(const std::string& text) {
  const std::string plain = utf8Text(text);
  if (plain.find_first_of(",\"\r\n") == std::string::npos) return plain;
  std::string quoted = "\"";
  for (const char c : plain) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string numberField(double value) { return plainNumber(value, 6); }

std::string placeFields(const std::optional<Eigen::Vector3d>& p) {
  if (!p) return ",,";
  return numberField(p->x()) + "," + numberField(p->y()) + "," + numberField(p->z());
}

}  // namespace

void fillRow(const RunResult& result, WalkRow& row) {
  const Report& report = result.report;
  const PlanQuery asked = result.problem->query();
  row.height = report.stature;
  row.speed = result.problem->scenario.walk.speed;
  row.start = asked.start.position;
  row.goal = asked.goal.position;
  row.status = statusName(report.status);
  row.stopped_by = report.stopped_by;
  if (report.status != PlanStatus::kSolved) {
    row.reason = report.why;
    if (report.obstruction) row.rule = std::string(walkRuleName(report.obstruction->rule));
    return;
  }
  row.length = report.length;
  row.duration = report.duration;
  row.frames = report.frames;
  row.steps = static_cast<int>(report.steps.size());
  row.clearance = report.clearance.min;
  row.foot_skate = report.foot_skate_max;
}

std::string rowJson(const WalkRow& row) {
  const Json json = {{"walk", row.key},
                     {"scene", row.scene},
                     {"library", row.library},
                     {"style", row.style},
                     {"actions", row.actions},
                     {"height", rounded(row.height)},
                     {"speed", rounded(row.speed)},
                     {"way", row.way},
                     {"seed", row.seed},
                     {"start", placeJson(row.start)},
                     {"goal", placeJson(row.goal)},
                     {"status", row.status},
                     {"rule", row.rule},
                     {"reason", row.reason},
                     {"stopped_by", row.stopped_by},
                     {"length", rounded(row.length)},
                     {"duration", rounded(row.duration)},
                     {"frames", row.frames},
                     {"steps", row.steps},
                     {"clearance", rounded(row.clearance)},
                     {"foot_skate", rounded(row.foot_skate)},
                     {"caption", row.caption},
                     {"credits", row.credits}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

WalkRow readRow(const std::string& text, const std::string& file, int line) {
  try {
    const Json json = Json::parse(text);
    WalkRow row;
    row.key = json.at("walk");
    row.scene = json.at("scene");
    row.library = json.at("library");
    row.style = json.at("style");
    row.actions = json.at("actions").get<std::vector<std::string>>();
    row.height = json.at("height");
    row.speed = json.at("speed");
    row.way = json.at("way");
    row.seed = json.at("seed");
    row.start = placeOf(json.at("start"));
    row.goal = placeOf(json.at("goal"));
    row.status = json.at("status");
    row.rule = json.at("rule");
    row.reason = json.at("reason");
    row.stopped_by = json.at("stopped_by");
    row.length = json.at("length");
    row.duration = json.at("duration");
    row.frames = json.at("frames");
    row.steps = json.at("steps");
    row.clearance = json.at("clearance");
    row.foot_skate = json.at("foot_skate");
    row.caption = json.at("caption");
    row.credits = json.at("credits").get<std::vector<std::string>>();
    return row;
  } catch (const Json::exception&) {
    throw InputError(file, line, "is no row of a batch", "what amble batch has written");
  }
}

std::string rowCsvHead() {
  return "walk,scene,library,style,actions,height [m],speed [m/s],way,seed,start x [m],start y [m],"
         "start z [m],goal x [m],goal y [m],goal z [m],status,rule,reason,stopped by,length [m],"
         "duration [s],frames,steps,clearance [m],foot skate [m],caption";
}

std::string rowCsv(const WalkRow& row) {
  std::string text = row.key;
  const auto add = [&](const std::string& value) { text += "," + value; };
  for (const std::string* name : {&row.scene, &row.library, &row.style}) add(field(*name));
  add(field(joined(row.actions, " ")));
  add(numberField(row.height));
  add(numberField(row.speed));
  add(field(row.way));
  add(std::to_string(row.seed));
  add(placeFields(row.start));
  add(placeFields(row.goal));
  for (const std::string* name : {&row.status, &row.rule, &row.reason, &row.stopped_by})
    add(field(*name));
  if (row.status != "solved") return text + ",,,,,,,";
  add(numberField(row.length));
  add(numberField(row.duration));
  add(std::to_string(row.frames));
  add(std::to_string(row.steps));
  add(numberField(row.clearance));
  add(numberField(row.foot_skate));
  add(field(row.caption));
  return text;
}

}  // namespace amble
