#include "app/view_bench.h"

#include <algorithm>
#include <iostream>
#include <optional>

#include "app/analysis_report.h"
#include "app/stop.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/strict_yaml.h"

namespace amble {
namespace {

AnalysedClip analysedOf(const ShownClip& shown) {
  AnalysedClip clip;
  clip.file = shown.file;
  clip.motion = shown.motion;
  clip.motion.clip.poses.clear();
  clip.motion.clip.joint_positions.clear();
  clip.file_frames = shown.file_frames;
  clip.first_frame = shown.first_frame;
  clip.floor = shown.fit;
  if (shown.analysis) clip.analysis = *shown.analysis;
  return clip;
}

// Of those clips whose feet are known; nothing else of the others is.
void addAnalyses(const std::vector<AnalysedClip>& clips, const std::vector<size_t>& places,
                 Bench& bench) {
  for (const SubjectLaw& law : subjectLaws(clips)) {
    for (const int i : law.clips) {
      const Findings found = describeAnalysis(clips[i], law);
      BenchClip& clip = bench.clips[places[i]];
      clip.analysis =
          found.data.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
      clip.facts = found.facts;
    }
  }
}

}  // namespace

ReadClips readClips(const std::vector<std::filesystem::path>& files,
                    const MotionReadOptions& options) {
  std::vector<std::optional<ShownClip>> clips(files.size());
  std::vector<std::string> errors(files.size());
  parallelFor(static_cast<int>(files.size()), usualThreads(), [&](int i, int) {
    if (stopFlag()) return;
    try {
      clips[i] = readShownClip(files[i], options);
    } catch (const InputError& error) {
      errors[i] = error.what();
    }
  });
  ReadClips read;
  for (size_t i = 0; i < files.size(); ++i) {
    if (clips[i]) read.clips.push_back(std::move(*clips[i]));
    if (!errors[i].empty()) read.errors.push_back(errors[i]);
  }
  return read;
}

Bench benchOf(const std::vector<ShownClip>& clips) {
  Bench bench;
  std::vector<AnalysedClip> analysed;
  std::vector<size_t> places;
  for (size_t i = 0; i < clips.size(); ++i) {
    bench.clips.push_back({&clips[i], "", {}});
    if (!clips[i].feet) continue;
    analysed.push_back(analysedOf(clips[i]));
    places.push_back(i);
  }
  addAnalyses(analysed, places, bench);
  return bench;
}

Bench benchOf(const BenchGraph& graph) {
  Bench bench = benchOf(graph.clips);
  bench.graph = &graph;
  return bench;
}

Bench benchOf(const BenchLibrary& library) {
  Bench bench;
  bench.library = &library;
  for (size_t i = 0; i < library.clips.size(); ++i) {
    const Motion& motion = *library.motions[i].motion;
    bench.clips.push_back({&library.clips[i], motionAnalysisJson(motion, library.clips[i]), {}});
  }
  return bench;
}

std::filesystem::path capturesOf(const std::filesystem::path& library, const std::string& asked) {
  if (!asked.empty()) return asked;
  std::filesystem::path recipe = library;
  recipe.replace_extension(".recipe.yaml");
  std::error_code ignored;
  if (std::filesystem::is_regular_file(recipe, ignored)) {
    if (const YamlNode captures = readYaml(recipe)["captures"]) return captures.asPath();
  }
  return library.has_parent_path() ? library.parent_path() : ".";
}

void printBench(const Bench& bench) {
  if (bench.library != nullptr || bench.graph != nullptr) {
    std::cout << benchJson(bench, plainNumbers()) << '\n';
    return;
  }
  std::cout << "[";
  for (size_t i = 0; i < bench.clips.size(); ++i)
    std::cout << (i > 0 ? ",\n " : "") << benchClipJson(bench.clips[i], plainNumbers());
  std::cout << "]\n";
}

}  // namespace amble
