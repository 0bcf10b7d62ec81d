#include "scenarios/kept_roadmaps.h"

#include "base/error.h"
#include "base/rotation.h"
#include "base/sha256.h"
#include "base/text.h"
#include "base/version.h"
#include "planner/roadmap/roadmap_file.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

constexpr int kDigits = 12;  // of a setting: more than anybody writes

RoadmapSource::Values digests(const std::vector<fs::path>& files, const fs::path& folder) {
  const fs::path base = fs::absolute(folder / ".").lexically_normal();
  RoadmapSource::Values values;
  for (const fs::path& file : files) {
    const fs::path name = fs::absolute(file).lexically_normal().lexically_relative(base);
    values[name.generic_string()] = sha256OfFile(file);
  }
  return values;
}

std::string text(double value) { return shortNumber(value, kDigits); }

}  // namespace

RoadmapSource roadmapSource(const Problem& problem) {
  const Scenario& scenario = problem.scenario;
  const GroundLimits& limits = scenario.character.limits;
  RoadmapSource source;
  source.scene = digests(problem.scene.inputs, scenario.scene.parent_path());
  const fs::path& library = problem.library.file;
  source.library = digests({library, library.parent_path() / problem.library.skeleton_file},
                           library.parent_path());
  source.character = {{"height", text(problem.synthesizer.stature())},
                      {"max_slope", text(limits.max_slope / kDegree)},
                      {"max_climb", text(limits.max_climb)},
                      {"max_drop", text(limits.max_drop)}};
  source.settings = {{"speed", text(scenario.walk.speed)},
                     {"style", scenario.walk.style},
                     {"comfort", text(scenario.walk.comfort)},
                     {"actions", joined(scenario.walk.actions)},
                     {"fps", text(1.0 / problem.synthesizer.settings().frame_time)},
                     {"bounds", "all"},
                     {"amble", version()}};
  if (scenario.bounds) {
    const Bounds& box = *scenario.bounds;
    source.settings["bounds"] =
        joined({text(box.min.x()), text(box.min.y()), text(box.max.x()), text(box.max.y())}, " ");
  }
  return source;
}

Scenario sceneAlone(const fs::path& scene) {
  Scenario scenario;
  scenario.name = scene.stem().string();
  scenario.source.file = scene;
  scenario.scene = scene;
  scenario.has_ends = false;
  return scenario;
}

KeptRoadmap openRoadmap(const fs::path& file, const Problem& problem) {
  KeptRoadmap roadmap = readRoadmap(file);
  const std::string changed = whatChanged(roadmap.source, roadmapSource(problem));
  if (changed.empty()) return roadmap;
  throw InputError(file.string(), 0, "is a stale roadmap, since these have changed: " + changed,
                   "one that `amble roadmap build` makes of this");
}

}  // namespace amble
