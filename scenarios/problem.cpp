#include "scenarios/problem.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "animation/library/library_style.h"
#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/action.h"
#include "base/error.h"
#include "base/rotation.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "environments/ground/ground_warnings.h"
#include "scenarios/walked_scene.h"
#include "scenarios/walker_body.h"
#include "scenarios/walker_ground.h"

namespace amble {
namespace {

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value == 0.0 ? 0.0 : value);
  return text;
}

std::string range(const char* axis, double min, double max) {
  return std::string(axis) + " from " + metres(min) + " to " + metres(max);
}

std::string listed(const std::vector<double>& heights) {
  std::string text;
  for (const double height : heights) text += (text.empty() ? "" : ", ") + metres(height);
  return text;
}

// Actions are held for the whole walk: what is valid for a part of it only cannot be one.
void requireActions(const Scenario& scenario, const MotionLibrary& library) {
  for (size_t i = 0; i < scenario.walk.actions.size(); ++i) {
    const std::string& action = scenario.walk.actions[i];
    if (findAction(library, action) != nullptr) continue;
    scenario.source.fail(
        "walk.actions[" + std::to_string(i) + "]",
        "'" + action + "' is no movement or posture of the library that is always valid",
        "of" + listActions(library));
  }
}

void requireStyle(const Scenario& scenario, const MotionLibrary& all) {
  const std::string& style = scenario.walk.style;
  if (style.empty()) return;
  const std::vector<std::string> styles = stylesOf(all);
  if (std::find(styles.begin(), styles.end(), style) != styles.end()) return;
  scenario.source.fail(
      "walk.style", "nobody in the library walks in the style '" + style + "'",
      styles.empty() ? "no style: its walks have none" : "one of " + joined(styles));
}

CharacterSettings settingsOf(const Scenario& scenario, double frame_time) {
  CharacterSettings settings;
  settings.height = scenario.character.height;
  settings.speed = scenario.walk.speed;
  settings.frame_time = frame_time;
  settings.limits = scenario.character.limits;
  settings.actions = scenario.walk.actions;
  return settings;
}

// Whether an action moves the trunk: who bends is as low as he bends.
bool mayStoop(const Scenario& scenario, const MotionLibrary& library) {
  const std::vector<int> trunk = chainJoints(library.skeleton, library.roles, "trunk");
  for (const std::string& action : scenario.walk.actions)
    for (const int joint : movedJoints(library, *findAction(library, action)))
      if (std::find(trunk.begin(), trunk.end(), joint) != trunk.end()) return true;
  return false;
}

Body checkedBody(const WalkSynthesizer& walker, const MotionLibrary& library, bool may_stoop) {
  Body body = walkerBody(walker, library);
  if (!may_stoop) body.upright = walker.stature();
  return body;
}

void requireWithinBounds(const Scenario& scenario, const Place& place, const std::string& key) {
  if (!scenario.bounds) return;
  const Bounds& bounds = *scenario.bounds;
  if ((place.at.array() >= bounds.min.array()).all() &&
      (place.at.array() <= bounds.max.array()).all()) {
    return;
  }
  scenario.source.fail(key + ".at", "'" + key + ".at' is outside of 'bounds'",
                       range("x", bounds.min.x(), bounds.max.x()) + " and " +
                           range("y", bounds.min.y(), bounds.max.y()));
}

std::string degrees(double angle) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", angle / kDegree);
  return text;
}

}  // namespace

SceneReading beginScene(const Scenario& scenario, const LoadLimits& limits) {
  if (!std::filesystem::exists(scenario.scene)) {
    scenario.source.fail("scene", "the scene '" + scenario.scene.string() + "' is not there",
                         "the path of a scene file, relative to this one");
  }
  return SceneReading(scenario.scene, limits);
}

MotionLibrary loadLibrary(const Scenario& scenario) {
  const CharacterSpec& character = scenario.character;
  if (character.library != "default" && !std::filesystem::exists(character.library)) {
    scenario.source.fail("character.library",
                         "the library '" + character.library + "' is not there",
                         "'default', or the path of a motion library, relative to this file");
  }
  return loadLibrary(scenario, readMotionLibrary(motionLibraryFile(character.library)));
}

MotionLibrary loadLibrary(const Scenario& scenario, const MotionLibrary& all) {
  requireStyle(scenario, all);
  MotionLibrary library = openMotionLibrary(all, scenario.walk.style);
  requireActions(scenario, library);
  return library;
}

GroundSettings groundSettings(const Scenario& scenario, const MotionLibrary& library) {
  const CharacterSpec& character = scenario.character;
  const double stature = character.height > 0.0 ? character.height : library.stature;
  GroundSettings settings = walkerGround(stature, character.limits);
  const auto add = [&](const Place& start, const Place& goal, const std::vector<Place>& via) {
    for (const Place& place : {start, goal}) settings.places.push_back({place.at, place.z});
    for (const Place& place : via) settings.places.push_back({place.at, place.z});
  };
  if (scenario.queries.empty() && scenario.has_ends)
    add(scenario.start, scenario.goal, scenario.via);
  for (const ScenarioQuery& query : scenario.queries) add(query.start, query.goal, query.via);
  return settings;
}

namespace {

template <typename Make>
auto timed(double& seconds, Make make) {
  struct Lap {
    explicit Lap(double& out_in) : out(out_in) {}
    ~Lap() { out = watch.seconds(); }
    double& out;
    const Stopwatch watch;
  } const lap(seconds);
  return make();
}

// Without ground nobody stands anywhere; what is wrong then is the scene, not a place in it.
void requireGround(const Scene& scene, const Scenario& scenario, const SceneGround& ground) {
  const GroundSettings& settings = ground.settings();
  if (ground.extent().isEmpty()) {
    const std::vector<std::string> hints = groundWarnings(scene, ground);
    scenario.source.fail(
        "scene",
        "the scene '" + scenario.scene.string() + "' holds nothing that can be walked on" +
            (hints.empty() ? "" : " (" + hints.front() + ")"),
        "a floor that faces up, no steeper than " + degrees(settings.limits.max_slope) +
            " degrees, with " + metres(settings.headroom) + " m of room above it");
  }
}

std::shared_ptr<const SceneGround> makeGround(const ProblemInputs& inputs, const Scenario& scenario,
                                              const StopRequest& stop) {
  const GroundSettings settings = groundSettings(scenario, *inputs.library);
  const auto ground = inputs.walked
                          ? inputs.walked->ground(settings, stop)
                          : std::make_shared<const SceneGround>(*inputs.scene, settings, stop);
  requireGround(*inputs.scene, scenario, *ground);
  return ground;
}

std::shared_ptr<const SceneLayers> makeLayers(const ProblemInputs& inputs,
                                              const SceneGround& ground, const StopRequest& stop,
                                              Checker checker) {
  if (inputs.walked && checker == Checker::kFast) return inputs.walked->layers(ground, stop);
  return std::make_shared<const SceneLayers>(*inputs.scene, ground, stop, checker);
}

// Of a query, before its places' own.
std::string keysOf(size_t query) { return "queries[" + std::to_string(query) + "]."; }

// A scene alone has the lowest of its ground.
double startFloor(const Scene& scene, const SceneGround& ground, const Scenario& scenario,
                  const std::string& keys) {
  if (!scenario.has_ends) return ground.heights().min()[0];
  return chooseFloor(scene, ground, scenario, scenario.start, keys + "start");
}

}  // namespace

double chooseFloor(const Scene& scene, const SceneGround& ground, const Scenario& scenario,
                   const Place& place, const std::string& key) {
  requireWithinBounds(scenario, place, key);
  const auto fail = [&](const std::string& problem, const std::string& expected) {
    scenario.source.fail(key + ".at", "'" + key + ".at' " + problem, expected);
  };
  const std::vector<double> heights = place.z ? ground.floors(place.at.x(), place.at.y())
                                              : ground.mainFloors(place.at.x(), place.at.y());
  if (heights.empty()) {
    const Eigen::AlignedBox3d box = scene.bounds();
    const std::vector<std::string> hints = groundWarnings(scene, ground);
    fail("has no floor under it" + (hints.empty() ? "" : " (" + hints.front() + ")"),
         "a place on the scene's floor; the scene has " + range("x", box.min().x(), box.max().x()) +
             " and " + range("y", box.min().y(), box.max().y()));
  }
  if (!place.z && heights.size() > 1) {
    fail("has several floors over one another that steps join",
         "[x, y, z] with z near one of " + listed(heights));
  }
  if (!place.z) return heights.front();
  const double nearest = *std::min_element(heights.begin(), heights.end(), [&](double a, double b) {
    return std::abs(a - *place.z) < std::abs(b - *place.z);
  });
  if (std::abs(nearest - *place.z) > kFloorReach) {
    fail("has no floor within " + metres(kFloorReach) + " m of z",
         "z near one of " + listed(heights));
  }
  return nearest;
}

ProblemInputs readInputs(const Scenario& scenario, const LoadLimits& limits) {
  const Stopwatch begun;
  SceneReading reading = beginScene(scenario, limits);  // other processes read its meshes meanwhile
  ProblemInputs inputs;
  inputs.library = timed(inputs.times.library, [&] {
    return std::make_shared<const MotionLibrary>(loadLibrary(scenario));
  });
  inputs.scene = std::make_shared<const Scene>(reading.finish());
  inputs.times.scene = begun.seconds() - inputs.times.library;
  return inputs;
}

struct Problem::Parts {
  Parts(const Scenario& scenario, double frame_time, ProblemInputs read, const LoadLimits& limits,
        Checker checker, LoadTimes& times)
      : inputs(std::move(read)),
        ground(timed(times.ground, [&] { return makeGround(inputs, scenario, limits.stop); })),
        synthesizer(timed(times.character,
                          [&] {
                            return WalkSynthesizer(*inputs.library, *ground,
                                                   settingsOf(scenario, frame_time));
                          })),
        body(checkedBody(synthesizer, *inputs.library, mayStoop(scenario, *inputs.library))),
        world(timed(times.collision, [&] {
          return CollisionWorld(*inputs.scene, makeLayers(inputs, *ground, limits.stop, checker),
                                synthesizer.skeleton(), body);
        })) {}
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  const ProblemInputs inputs;
  const std::shared_ptr<const SceneGround> ground;
  const WalkSynthesizer synthesizer;
  const Body body;
  const CollisionWorld world;
};

namespace {

// With the speed that a style has of its own, where none is said.
Scenario withSpeed(Scenario scenario, const MotionLibrary& library) {
  if (scenario.walk.own_speed) scenario.walk.speed = ownSpeed(library, scenario.character.height);
  return scenario;
}

}  // namespace

Problem::Problem(const Scenario& problem, double frame_time, const LoadLimits& limits,
                 Checker checker)
    : Problem(problem, frame_time, readInputs(problem, limits), limits, checker) {}

Problem::Problem(const Scenario& problem, double frame_time, ProblemInputs inputs,
                 const LoadLimits& limits, Checker checker)
    : keys(problem.queries.empty() ? "" : keysOf(0)),
      times(inputs.times),
      scenario(withSpeed(problem, *inputs.library)),
      parts_(std::make_shared<const Parts>(scenario, frame_time, std::move(inputs), limits, checker,
                                           times)),
      library(*parts_->inputs.library),
      scene(*parts_->inputs.scene),
      ground(*parts_->ground),
      floor(startFloor(scene, ground, scenario, keys)),
      synthesizer(parts_->synthesizer),
      body(parts_->body),
      world(parts_->world) {}

Problem::Problem(const Problem& other, const Scenario& asked)
    : keys(asked.queries.empty() ? "" : keysOf(0)),
      scenario(withSpeed(asked, other.library)),
      parts_(other.parts_),
      library(other.library),
      scene(other.scene),
      ground(other.ground),
      floor(startFloor(scene, ground, scenario, keys)),
      synthesizer(other.synthesizer),
      body(other.body),
      world(other.world) {}

void Problem::ask(size_t query) {
  const ScenarioQuery& asked = scenario.queries.at(query);
  scenario.start = asked.start;
  scenario.goal = asked.goal;
  scenario.via = asked.via;
  keys = keysOf(query);
  floor = stand(scenario.start, "start").z();
}

PlanRequest Problem::request() const {
  PlanRequest request;
  request.synthesizer = &synthesizer;
  request.world = &world;
  request.ground = &ground;
  request.bounds = bounds();
  if (scenario.bounds) request.within = request.bounds;
  request.comfort = scenario.walk.comfort;
  request.planner = scenario.planner.name;
  request.limits.seed = scenario.planner.seed;
  request.limits.max_failures = scenario.planner.max_failures;
  return request;
}

PlanQuery Problem::query() const {
  PlanQuery query;
  query.start = {stand(scenario.start, "start"), scenario.start.heading,
                 scenario.walk.from_standing};
  query.goal = {stand(scenario.goal, "goal"), scenario.goal.heading, scenario.walk.to_standing};
  for (size_t i = 0; i < scenario.via.size(); ++i)
    query.via.push_back(stand(scenario.via[i], "via[" + std::to_string(i) + "]"));
  return query;
}

Eigen::Vector3d Problem::stand(const Place& place, const std::string& key) const {
  return {place.at.x(), place.at.y(), chooseFloor(scene, ground, scenario, place, keys + key)};
}

std::vector<std::filesystem::path> Problem::inputs() const {
  std::vector<std::filesystem::path> files = scene.inputs;
  files.insert(files.end(), {scenario.source.file, library.file,
                             library.file.parent_path() / library.skeleton_file});
  return files;
}

Eigen::AlignedBox2d Problem::bounds() const {
  if (!scenario.bounds) return ground.extent();
  return {scenario.bounds->min, scenario.bounds->max};
}

}  // namespace amble
