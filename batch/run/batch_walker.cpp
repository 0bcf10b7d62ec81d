#include "batch/run/batch_walker.h"

#include "animation/library/motion_library_reader.h"
#include "base/data_directory.h"
#include "base/error.h"
#include "base/sha256.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "planner/roadmap/kept_roadmap.h"
#include "scenarios/walked_scene.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  if (from.empty()) return;
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

std::string withSlash(const fs::path& folder) {
  const std::string text = folder.string();
  return text.empty() || text.back() == '/' ? text : text + "/";
}

fs::path plain(const fs::path& file) { return fs::absolute(file).lexically_normal(); }

std::string nameOf(const BatchJob& job, const fs::path& file) {
  const fs::path data = plain(dataDirectory() / "animation");
  const fs::path in_data = plain(file).lexically_relative(data);
  if (!in_data.empty() && *in_data.begin() != "..") return "amble:" + in_data.generic_string();
  return plain(file).lexically_relative(plain(job.file.parent_path() / ".")).generic_string();
}

}  // namespace

std::string relativeText(const BatchJob& job, std::string text) {
  const fs::path folder = job.file.parent_path();
  replaceAll(text, withSlash(folder), "");
  replaceAll(text, withSlash(plain(folder / ".")), "");
  replaceAll(text, withSlash(plain(dataDirectory() / ".")), "amble:");
  return withoutControls(text);
}

std::string digestOfInputs(const InputDigests& inputs) {
  std::string lines;
  for (const auto& [file, digest] : inputs) lines += withoutControls(file) + " " + digest + "\n";
  return sha256(lines);
}

InputDigests digestsOf(const BatchJob& job, const std::vector<fs::path>& files) {
  InputDigests inputs;
  for (const fs::path& file : files) inputs[nameOf(job, file)] = sha256OfFile(file);
  return inputs;
}

std::shared_ptr<const BatchSceneData> readBatchScene(const BatchJob& job, int scene,
                                                     const LoadLimits& limits) {
  auto data = std::make_shared<BatchSceneData>();
  BatchItem any;
  any.scene = scene;
  try {
    SceneReading reading = beginScene(scenarioOf(job, any), limits);
    data->scene = std::make_shared<const Scene>(reading.finish());
    data->walked = std::make_shared<const WalkedScene>(data->scene);
    data->inputs = digestsOf(job, data->scene->inputs);
    data->digest = digestOfInputs(data->inputs);
  } catch (const InputError& error) {
    data->scene = nullptr;
    data->wrong = relativeText(job, error.what());
    data->digest = "wrong: " + data->wrong;
  }
  return data;
}

std::shared_ptr<const BatchLibraryData> readDrawersLibrary(const BatchJob& job) {
  auto data = std::make_shared<BatchLibraryData>();
  try {
    data->library = std::make_shared<const MotionLibrary>(openMotionLibrary("default"));
  } catch (const InputError& error) {
    data->wrong = relativeText(job, error.what());
  }
  return data;
}

std::shared_ptr<const BatchDrawer> makeBatchDrawer(const BatchJob& job, int scene,
                                                   const BatchSceneData& data,
                                                   const BatchLibraryData& library,
                                                   const LoadLimits& limits) {
  auto made = std::make_shared<BatchDrawer>();
  BatchItem any;
  any.scene = scene;
  if (!library.library) {
    made->wrong = library.wrong;
    return made;
  }
  Scenario scenario = scenarioOf(job, any);
  scenario.has_ends = false;
  scenario.character.library = "default";
  scenario.character.height = job.tallest();
  scenario.walk.style.clear();
  scenario.walk.actions.clear();
  try {
    const ProblemInputs inputs{data.scene, library.library, {}, data.walked};
    made->problem = std::make_unique<const Problem>(scenario, 1.0 / job.fps, inputs, limits);
    made->drawer = std::make_unique<const WayDrawer>(*made->problem);
  } catch (const InputError& error) {
    made->wrong = relativeText(job, error.what());
  }
  return made;
}

std::shared_ptr<const BatchLibraryData> readBatchLibrary(const BatchJob& job,
                                                         const BatchItem& item) {
  auto data = std::make_shared<BatchLibraryData>();
  const Scenario scenario = scenarioOf(job, item);
  try {
    const MotionLibrary all = readMotionLibrary(motionLibraryFile(scenario.character.library));
    data->inputs = digestsOf(job, {all.file, all.file.parent_path() / all.skeleton_file});
    data->digest = digestOfInputs(data->inputs);
    data->library = std::make_shared<const MotionLibrary>(loadLibrary(scenario, all));
  } catch (const InputError& error) {
    data->wrong = relativeText(job, error.what());
    if (data->digest.empty()) data->digest = "wrong: " + data->wrong;
  }
  return data;
}

std::shared_ptr<const BatchWalker> makeBatchWalker(const BatchJob& job, const BatchItem& item,
                                                   const BatchSceneData& scene,
                                                   const BatchLibraryData& library,
                                                   const LoadLimits& limits) {
  auto walker = std::make_shared<BatchWalker>();
  Scenario scenario = scenarioOf(job, item);
  scenario.has_ends = false;
  try {
    walker->problem = std::make_unique<const Problem>(
        scenario, 1.0 / job.fps, ProblemInputs{scene.scene, library.library, {}, scene.walked},
        limits);
  } catch (const InputError& error) {
    walker->wrong = relativeText(job, error.what());
    return walker;
  }
  if (job.roadmap == BatchRoadmap::kEach) return walker;
  const Stopwatch watch;
  PlanRequest request = walker->problem->request();
  request.limits.stop = limits.stop.flag;
  request.limits.seed = job.seed;
  request.limits.max_failures = Planner::kFailures;
  KeptRoadmap roadmap = Planner::grow(request);
  limits.stop.check();
  walker->planner.emplace(walker->problem->request(), std::move(roadmap));
  walker->seconds = watch.seconds();
  return walker;
}

}  // namespace amble
