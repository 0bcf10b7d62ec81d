#include "scenarios/scenario.h"

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "base/files.h"
#include "base/rotation.h"
#include "base/sha256.h"
#include "base/strict_yaml.h"
#include "base/text.h"

namespace amble {
namespace {

constexpr FileKind kScenarioKind = {"a scenario (YAML)", kMaxScenario};
// Of a coordinate: beyond it the squares of lengths have no digits left for micrometres, and
// contacts are told wrongly [m].
constexpr double kFarthest = 1e5;

double asAngle(const YamlNode& node, double min_deg, double max_deg, const char* what) {
  return node.asDouble(min_deg, max_deg, what) * kDegree;
}

}  // namespace

Place readPlace(const YamlNode& node, bool with_heading) {
  if (with_heading) {
    node.requireKeys({"at", "heading"});
  } else {
    node.requireKeys({"at"});
  }
  Place place;
  const YamlNode at = node.at("at");
  const bool has_z = at.isSequence() && at.size() == 3;
  if (!has_z && at.isSequence() && at.size() != 2) {
    at.fail("'" + at.path() + "' has " + std::to_string(at.size()) + " numbers",
            "[x, y], or [x, y, z] where floors lie over one another [m]");
  }
  const Eigen::VectorXd p =
      at.asVec(has_z ? 3 : 2, "place [m]", -YamlNode::kInfinity, YamlNode::kInfinity);
  if (p.cwiseAbs().maxCoeff() > kFarthest) {
    at.fail("'" + at.path() + "' is more than 100 km from the origin",
            "a place nearer to it: a scene on a map's coordinates is brought there by the `at` of "
            "its objects");
  }
  place.at = p.head<2>();
  if (has_z) place.z = p.z();
  if (const YamlNode heading = node["heading"]) {
    place.heading = asAngle(heading, -360.0, 360.0, "heading [degrees]");
  }
  return place;
}

std::vector<Place> readVia(const YamlNode& node) {
  std::vector<Place> via;
  for (const YamlNode& place : node.items()) via.push_back(readPlace(place, false));
  return via;
}

namespace {

CharacterSpec readCharacter(const YamlNode& node) {
  node.requireKeys({"height", "library", "max_slope", "max_climb", "max_drop"});
  CharacterSpec character;
  if (const YamlNode n = node["height"]) character.height = n.asDouble(0.5, 2.5, "height [m]");
  if (const YamlNode n = node["library"]) {
    character.library = n.asString() == "default" ? "default" : n.asPath().string();
  }
  if (const YamlNode n = node["max_slope"]) {
    character.limits.max_slope = asAngle(n, 0.0, 45.0, "slope [degrees]");
  }
  if (const YamlNode n = node["max_climb"]) {
    character.limits.max_climb = n.asDouble(0.0, 1.0, "step height [m]");
  }
  if (const YamlNode n = node["max_drop"]) {
    character.limits.max_drop = n.asDouble(0.0, 1.0, "step height [m]");
  }
  return character;
}

Bounds readBounds(const YamlNode& node) {
  node.requireKeys({"min", "max"});
  Bounds bounds;
  bounds.min = node.at("min").asVec(2, "corner [m]", -kFarthest, kFarthest);
  bounds.max = node.at("max").asVec(2, "corner [m]", -kFarthest, kFarthest);
  if (!(bounds.min.array() < bounds.max.array()).all()) {
    node.at("max").fail("'bounds.max' is not beyond 'bounds.min'",
                        "both of its numbers to be larger");
  }
  return bounds;
}

WalkSpec readWalk(const YamlNode& node) {
  node.requireKeys({"speed", "from", "to", "style", "comfort", "actions"});
  WalkSpec walk;
  if (const YamlNode n = node["speed"]) walk.speed = n.asDouble(0.3, 2.0, "speed [m/s]");
  if (const YamlNode n = node["style"]) walk.style = n.asString();
  walk.own_speed = !node.has("speed") && !walk.style.empty();
  if (const YamlNode n = node["from"]) {
    walk.from_standing = n.asEnum<bool>({{"stand", true}, {"walking", false}});
  }
  if (const YamlNode n = node["to"]) {
    walk.to_standing = n.asEnum<bool>({{"stand", true}, {"walking", false}});
  }
  if (const YamlNode n = node["comfort"]) walk.comfort = n.asDouble(0.0, 0.5, "distance [m]");
  if (const YamlNode n = node["actions"]) {
    for (const YamlNode& action : n.items()) walk.actions.push_back(action.asString());
  }
  return walk;
}

PlannerSpec readPlanner(const YamlNode& node) {
  node.requireKeys({"name", "seed", "max_failures", "time_limit"});
  PlannerSpec planner;
  if (const YamlNode n = node["name"]) planner.name = n.asString();
  if (const YamlNode n = node["seed"]) {
    planner.seed = static_cast<std::uint64_t>(n.asInt(0, 2147483647, "seed"));
  }
  if (const YamlNode n = node["max_failures"]) {
    planner.max_failures = n.asInt(1, 1000000, "number of failures");
  }
  if (const YamlNode n = node["time_limit"]) planner.time_limit = n.asPositive("time [s]", 86400.0);
  return planner;
}

// A name is a folder's, on any system.
std::string readQueryName(const YamlNode& node) {
  constexpr size_t kLongest = 100;
  const std::string name = node.asString();
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return isLetter(c) || isDigit(c) || c == '-' || c == '_' || c == '.';
  });
  if (!plain || name.front() == '.' || name.size() > kLongest) {
    node.fail("'" + name + "' is no name for a folder",
              "up to 100 letters, digits, '-', '_' and '.', the first of them no '.'");
  }
  return name;
}

std::vector<ScenarioQuery> readQueries(const YamlNode& node) {
  std::vector<ScenarioQuery> queries;
  std::map<std::string, int> lines;  // of names, in lower case: some systems know no other
  for (const YamlNode& item : node.items()) {
    item.requireKeys({"name", "start", "goal", "via"});
    ScenarioQuery query;
    const YamlNode name = item["name"];
    query.name = name ? readQueryName(name) : std::to_string(queries.size() + 1);
    const auto [before, is_new] = lines.emplace(lowerCase(query.name), item.line());
    if (!is_new) {
      (name ? name : item)
          .fail("the name '" + query.name + "' is that of the query on line " +
                    std::to_string(before->second) + " too",
                "a name of its own");
    }
    query.start = readPlace(item.at("start"), true);
    query.goal = readPlace(item.at("goal"), true);
    if (const YamlNode n = item["via"]) query.via = readVia(n);
    queries.push_back(std::move(query));
  }
  if (queries.empty()) node.fail("'queries' asks for nothing", "at least one {start, goal}");
  return queries;
}

std::string readDigest(const YamlNode& node) {
  const std::string digest = node.asString();
  const bool hex = digest.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (digest.size() != 64 || !hex) {
    node.fail("'" + node.path() + "' is no SHA-256", "64 lower-case hexadecimal digits");
  }
  return digest;
}

Expectation readExpectation(const YamlNode& node) {
  node.requireKeys({"status", "max_length", "min_clearance", "max_foot_skate", "max_planning_time",
                    "bvh_sha256"});
  Expectation expect;
  if (const YamlNode n = node["status"]) {
    expect.status = n.asEnum<PlanStatus>({{"solved", PlanStatus::kSolved},
                                          {"no_walk", PlanStatus::kNoWalk},
                                          {"start_blocked", PlanStatus::kStartBlocked},
                                          {"goal_blocked", PlanStatus::kGoalBlocked}});
  }
  if (const YamlNode n = node["max_length"]) expect.max_length = n.asPositive("length [m]");
  if (const YamlNode n = node["min_clearance"]) {
    expect.min_clearance = n.asDouble(0.0, YamlNode::kInfinity, "distance [m]");
  }
  if (const YamlNode n = node["max_foot_skate"]) {
    expect.max_foot_skate = n.asDouble(0.0, YamlNode::kInfinity, "distance [m]");
  }
  if (const YamlNode n = node["max_planning_time"]) {
    expect.max_planning_time = n.asPositive("time [s]");
  }
  if (const YamlNode n = node["bvh_sha256"]) expect.bvh_sha256 = readDigest(n);
  return expect;
}

// Start, goal and via of one walk, or the queries of several.
void readEnds(const YamlNode& root, Scenario& scenario) {
  if (const YamlNode queries = root["queries"]) {
    for (const char* key : {"start", "goal", "via"})
      if (const YamlNode n = root[key])
        n.fail(std::string("'") + key + "' beside 'queries'", "each query to have its own");
    scenario.queries = readQueries(queries);
    const ScenarioQuery& first = scenario.queries.front();
    scenario.start = first.start;
    scenario.goal = first.goal;
    scenario.via = first.via;
    return;
  }
  scenario.start = readPlace(root.at("start"), true);
  scenario.goal = readPlace(root.at("goal"), true);
  if (const YamlNode n = root["via"]) scenario.via = readVia(n);
}

void collectLines(const YamlNode& node, std::map<std::string, int>& lines) {
  lines[node.path()] = node.line();
  if (node.isMap()) {
    for (const auto& [key, value] : node.entries()) collectLines(value, lines);
  } else if (node.isSequence()) {
    for (const YamlNode& item : node.items()) collectLines(item, lines);
  }
}

}  // namespace

void ScenarioSource::fail(const std::string& key, const std::string& problem,
                          const std::string& expected) const {
  const auto line = lines.find(key);
  throw InputError(file.string(), line == lines.end() ? 0 : line->second, problem, expected);
}

std::string statusName(PlanStatus status) {
  switch (status) {
    case PlanStatus::kSolved:
      return "solved";
    case PlanStatus::kNoWalk:
      return "no_walk";
    case PlanStatus::kStartBlocked:
      return "start_blocked";
    case PlanStatus::kGoalBlocked:
      return "goal_blocked";
  }
  return "";
}

Scenario readScenario(const ScenarioFile& file) {
  if (!file.unread.empty())
    throw InputError(file.file.string(), 0, file.unread, "a file that can be read");
  const YamlNode root = parseYaml(file.text, file.file.string());
  if (root.isMap() && root.has("objects") && !root.has("scene")) {
    throw InputError(file.file.string(), 0, "is a scene",
                     "a scenario, which has start and goal and names it: `scene: " +
                         file.file.filename().string() + "`");
  }
  root.requireKeys({"scene", "character", "start", "goal", "via", "queries", "bounds", "walk",
                    "planner", "expect"});
  Scenario scenario;
  scenario.name = file.file == "-" ? "scenario" : file.file.stem().string();
  scenario.scene = root.at("scene").asPath();
  if (const YamlNode n = root["character"]) scenario.character = readCharacter(n);
  readEnds(root, scenario);
  if (const YamlNode n = root["bounds"]) scenario.bounds = readBounds(n);
  if (const YamlNode n = root["walk"]) scenario.walk = readWalk(n);
  if (const YamlNode n = root["planner"]) scenario.planner = readPlanner(n);
  if (const YamlNode n = root["expect"]) scenario.expect = readExpectation(n);
  if (scenario.expect && scenario.expect->bvh_sha256 && !scenario.queries.empty()) {
    root.at("expect")
        .at("bvh_sha256")
        .fail("'expect.bvh_sha256' beside 'queries'", "what holds for each of them");
  }
  scenario.source = {file.file, sha256(file.text), {}};
  collectLines(root, scenario.source.lines);
  return scenario;
}

ScenarioFile readScenarioFile(const std::filesystem::path& file) {
  return {file, readWholeFile(file, kScenarioKind)};
}

Scenario readScenario(const std::filesystem::path& file) {
  return readScenario(readScenarioFile(file));
}

bool isScenario(const ScenarioFile& file) {
  try {
    const YamlNode root = parseYaml(file.text, file.file.string());
    return root.isMap() && root.has("scene") && (root.has("start") || root.has("queries"));
  } catch (const InputError&) {
    // Not YAML as we read it: a scenario with a slip in it must be heard of, somebody else's file
    // must not.
    std::istringstream in(file.text);
    bool scene = false, start = false;
    for (std::string line; std::getline(in, line);) {
      scene |= line.starts_with("scene:");
      start |= line.starts_with("start:") || line.starts_with("queries:");
    }
    return scene && start;
  }
}

}  // namespace amble
