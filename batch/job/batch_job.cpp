#include "batch/job/batch_job.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "base/strict_yaml.h"
#include "base/text.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

constexpr FileKind kJobKind = {"a job (YAML)", size_t{16} << 20};
constexpr double kFarthestWay = 1e5;  // [m]
constexpr int kMostSeeds = 1'000'000;
constexpr int kMostDrawn = 1'000'000;

// Files that a path with `*` and `?` in its parts stands for, in order of their names.
std::vector<fs::path> matching(const fs::path& pattern) {
  std::vector<fs::path> found = {pattern.root_path()};
  for (const fs::path& part : pattern.relative_path()) {
    std::vector<fs::path> longer;
    for (const fs::path& so_far : found) {
      if (part.string().find_first_of("*?") == std::string::npos) {
        longer.push_back(so_far / part);
        continue;
      }
      std::error_code unknown;
      std::vector<fs::path> here;
      for (const auto& entry : fs::directory_iterator(so_far.empty() ? "." : so_far, unknown))
        if (matchesPattern(part.string(), entry.path().filename().string()))
          here.push_back(so_far / entry.path().filename());
      std::sort(here.begin(), here.end());
      longer.insert(longer.end(), here.begin(), here.end());
    }
    found = std::move(longer);
  }
  std::erase_if(found, [](const fs::path& file) {
    std::error_code unknown;
    return !fs::exists(file, unknown);
  });
  return found;
}

std::vector<BatchWay> readWays(const YamlNode& node) {
  std::vector<BatchWay> ways;
  for (const YamlNode& item : node.items()) {
    item.requireKeys({"name", "start", "goal", "via"});
    BatchWay way;
    way.line = item.line();
    const YamlNode name = item["name"];
    way.name = name ? name.asString() : std::to_string(ways.size() + 1);
    for (const BatchWay& other : ways) {
      if (other.name != way.name) continue;
      (name ? name : item)
          .fail("the name '" + withoutControls(way.name) + "' is that of the way on line " +
                    std::to_string(other.line) + " too",
                "a name of its own");
    }
    way.start = readPlace(item.at("start"), true);
    way.goal = readPlace(item.at("goal"), true);
    if (const YamlNode n = item["via"]) way.via = readVia(n);
    ways.push_back(std::move(way));
  }
  return ways;
}

Bounds readBatchBounds(const YamlNode& node) {
  node.requireKeys({"min", "max"});
  Bounds bounds{node.at("min").asVec2("corner [m]"), node.at("max").asVec2("corner [m]")};
  if (!(bounds.min.array() < bounds.max.array()).all())
    node.at("max").fail("'bounds.max' is not beyond 'bounds.min'", "both numbers to be larger");
  return bounds;
}

void addScene(const YamlNode& path, BatchScene scene, std::vector<BatchScene>& scenes) {
  const std::string text = path.asString();
  const fs::path file = path.asPath();
  if (text.find_first_of("*?") == std::string::npos) {
    scene.file = file;
    scene.name = text;
    scenes.push_back(std::move(scene));
    return;
  }
  const std::vector<fs::path> files = matching(file);
  if (files.empty()) path.fail("no file is called '" + text + "'", "a pattern that scenes match");
  const fs::path folder = fs::path(path.file()).parent_path();
  for (const fs::path& match : files) {
    scene.file = match;
    scene.name = match.lexically_relative(folder.empty() ? fs::path(".") : folder).generic_string();
    if (fs::path(text).is_absolute()) scene.name = match.string();
    scenes.push_back(scene);
  }
}

std::vector<BatchScene> readScenes(const YamlNode& node) {
  std::vector<BatchScene> scenes;
  for (const YamlNode& item : node.items()) {
    BatchScene scene;
    scene.line = item.line();
    if (item.isScalar()) {
      addScene(item, scene, scenes);
      continue;
    }
    item.requireKeys({"scene", "ways", "bounds"});
    if (const YamlNode n = item["ways"]) scene.ways = readWays(n);
    if (const YamlNode n = item["bounds"]) scene.bounds = readBatchBounds(n);
    addScene(item.at("scene"), scene, scenes);
  }
  if (scenes.empty()) node.fail("'scenes' names none", "at least one scene");
  return scenes;
}

BatchNumbers readNumbers(const YamlNode& node, double min, double max, const char* what) {
  BatchNumbers numbers;
  numbers.line = node.line();
  if (node.isMap()) {
    node.requireKeys({"from", "to"});
    const double from = node.at("from").asDouble(min, max, what);
    const double to = node.at("to").asDouble(from, max, what);
    numbers.range = {from, to};
    return numbers;
  }
  if (node.isScalar()) {
    numbers.values = {node.asDouble(min, max, what)};
    return numbers;
  }
  for (const YamlNode& item : node.items()) numbers.values.push_back(item.asDouble(min, max, what));
  if (numbers.values.empty()) node.fail("'" + node.path() + "' is empty", "at least one value");
  return numbers;
}

std::vector<std::string> readNames(const YamlNode& node) {
  std::vector<std::string> names;
  for (const YamlNode& item : node.items()) names.push_back(item.asString());
  return names;
}

void requireSome(const YamlNode& node, size_t count) {
  if (count == 0) node.fail("'" + node.path() + "' is empty", "at least one value");
}

std::vector<std::uint64_t> readSeeds(const YamlNode& node) {
  std::vector<std::uint64_t> seeds;
  if (node.isScalar()) {
    seeds.resize(static_cast<size_t>(node.asInt(1, kMostSeeds, "number of seeds")));
    std::iota(seeds.begin(), seeds.end(), 1);
    return seeds;
  }
  for (const YamlNode& item : node.items())
    seeds.push_back(static_cast<std::uint64_t>(item.asInt(0, 2147483647, "seed")));
  requireSome(node, seeds.size());
  return seeds;
}

BatchDraw readDraw(const YamlNode& node) {
  node.requireKeys({"draw", "least", "most"});
  BatchDraw draw;
  draw.count = node.at("draw").asInt(0, kMostDrawn, "number of ways");
  if (const YamlNode n = node["least"]) draw.least = n.asDouble(0.0, kFarthestWay, "distance [m]");
  if (const YamlNode n = node["most"])
    draw.most = n.asDouble(draw.least, kFarthestWay, "distance [m]");
  return draw;
}

void readAxes(const YamlNode& root, BatchJob& job) {
  if (const YamlNode n = root["libraries"]) {
    job.libraries.clear();
    for (const YamlNode& item : n.items())
      job.libraries.push_back(item.asString() == "default" ? "default" : item.asPath().string());
    requireSome(n, job.libraries.size());
  }
  if (const YamlNode n = root["heights"]) job.heights = readNumbers(n, 0.5, 2.5, "height [m]");
  if (const YamlNode n = root["speeds"]) job.speeds = readNumbers(n, 0.3, 2.0, "speed [m/s]");
  if (const YamlNode n = root["styles"]) {
    job.styles = readNames(n);
    for (std::string& style : job.styles)
      if (style == "none") style.clear();
    requireSome(n, job.styles.size());
  }
  if (const YamlNode n = root["actions"]) {
    job.actions.clear();
    for (const YamlNode& item : n.items()) job.actions.push_back(readNames(item));
    requireSome(n, job.actions.size());
  }
  if (const YamlNode n = root["ways"]) job.draw = readDraw(n);
  if (const YamlNode n = root["seeds"]) job.seeds = readSeeds(n);
}

void readSettings(const YamlNode& root, BatchJob& job) {
  if (const YamlNode n = root["limits"]) {
    n.requireKeys({"max_slope", "max_climb", "max_drop"});
    if (const YamlNode v = n["max_slope"])
      job.limits.max_slope = v.asDouble(0.0, 45.0, "slope [degrees]") * kDegree;
    if (const YamlNode v = n["max_climb"])
      job.limits.max_climb = v.asDouble(0.0, 1.0, "step height [m]");
    if (const YamlNode v = n["max_drop"])
      job.limits.max_drop = v.asDouble(0.0, 1.0, "step height [m]");
  }
  if (const YamlNode n = root["walk"]) {
    n.requireKeys({"from", "to", "comfort"});
    const auto stands = [](const YamlNode& v) {
      return v.asEnum<bool>({{"stand", true}, {"walking", false}});
    };
    if (const YamlNode v = n["from"]) job.walk.from_standing = stands(v);
    if (const YamlNode v = n["to"]) job.walk.to_standing = stands(v);
    if (const YamlNode v = n["comfort"]) job.walk.comfort = v.asDouble(0.0, 0.5, "distance [m]");
  }
  job.planner.time_limit = kBatchTimeLimit;
  if (const YamlNode n = root["planner"]) {
    n.requireKeys({"name", "max_failures", "time_limit", "roadmap"});
    if (const YamlNode v = n["name"]) {
      std::vector<std::string> names;
      for (const PlannerInfo& planner : listPlanners()) names.push_back(planner.name);
      job.planner.name = names[static_cast<size_t>(v.indexIn(names))];
    }
    if (const YamlNode v = n["max_failures"])
      job.planner.max_failures = v.asInt(1, 1000000, "number of failures");
    if (const YamlNode v = n["time_limit"])
      job.planner.time_limit = v.asPositive("time [s]", kBatchTimeLimit);
    if (const YamlNode v = n["roadmap"]) {
      job.roadmap = v.asEnum<BatchRoadmap>(
          {{"shared", BatchRoadmap::kShared}, {"each", BatchRoadmap::kEach}});
    }
  }
}

void readFormats(const YamlNode& node, const std::vector<std::string>& known, BatchJob& job) {
  std::vector<std::string> names = known;
  names.emplace_back("labels");
  std::vector<std::string> formats;
  for (const YamlNode& item : node.items())
    formats.push_back(names[static_cast<size_t>(item.indexIn(names))]);
  requireSome(node, formats.size());
  std::sort(formats.begin(), formats.end());
  formats.erase(std::unique(formats.begin(), formats.end()), formats.end());
  job.formats = std::move(formats);
}

void requireWays(const YamlNode& scenes, const BatchJob& job) {
  for (const BatchScene& scene : job.scenes) {
    if (!scene.ways.empty() || job.draw.count > 0) continue;
    throw InputError(scenes.file(), scene.line, "nobody walks in '" + scene.name + "'",
                     "`ways:` of the scene, or `ways: {draw: N}` of the job");
  }
}

}  // namespace

double BatchJob::tallest() const {
  if (heights.range) return heights.range->second;
  return *std::max_element(heights.values.begin(), heights.values.end());
}

BatchJob readBatchJob(const fs::path& file, const std::vector<std::string>& formats) {
  const YamlNode root = readYaml(file, kJobKind);
  root.requireKeys({"scenes", "libraries", "heights", "speeds", "styles", "actions", "ways",
                    "seeds", "sample", "seed", "limits", "walk", "planner", "fps", "formats"});
  BatchJob job;
  job.file = file;
  job.scenes = readScenes(root.at("scenes"));
  readAxes(root, job);
  readSettings(root, job);
  if (const YamlNode n = root["sample"]) job.sample = n.asInt(1, 100'000'000, "number of walks");
  if (const YamlNode n = root["seed"])
    job.seed = static_cast<std::uint64_t>(n.asInt(0, 2147483647, "seed"));
  if (const YamlNode n = root["fps"]) job.fps = n.asDouble(24.0, 240.0, "frames a second [1/s]");
  if (const YamlNode n = root["formats"]) readFormats(n, formats, job);
  for (const BatchNumbers* numbers : {&job.heights, &job.speeds}) {
    if (!numbers->range || job.sample > 0) continue;
    throw InputError(file.string(), numbers->line, "a range has no product",
                     "a list of values, or `sample: N` walks to be drawn");
  }
  requireWays(root.at("scenes"), job);
  for (const char* key : {"libraries", "styles", "actions", "ways", "sample"})
    if (const YamlNode n = root[key]) job.lines[key] = n.line();
  return job;
}

}  // namespace amble
