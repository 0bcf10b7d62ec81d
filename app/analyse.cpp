// amble analyse CLIP...: who stands when, what kind of motion it is, how it walks and how well.

#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "app/analysis_report.h"
#include "app/clip_sources.h"
#include "app/command.h"
#include "app/progress.h"
#include "app/read_options.h"
#include "app/say.h"
#include "app/stop.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/output_file.h"
#include "viz/pictures/gait_plot.h"

namespace amble {
namespace {

struct AnalyseArguments {
  std::vector<std::string> paths;
  ReadOptions read;
  std::string plants, plot;
  bool as_is = false, json = false;
  int threads = 0;
};

void print(const std::vector<AnalysedClip>& clips, bool json) {
  const std::vector<SubjectLaw> laws = subjectLaws(clips);
  if (clips.size() > 1 && !json) {
    printAnalysisTable(clips, laws);
    return;
  }
  std::vector<Findings> all;
  for (int i = 0; i < static_cast<int>(clips.size()); ++i) {
    for (const SubjectLaw& law : laws) {
      if (std::find(law.clips.begin(), law.clips.end(), i) != law.clips.end())
        all.push_back(describeAnalysis(clips[i], law));
    }
  }
  if (json || !all.empty()) printFindings(all, json);
}

/// What is missing of a clip is told where it is read.
void keepClips(const std::vector<std::filesystem::path>& clips, const ReadOptions& read,
               const std::vector<std::filesystem::path>& outputs) {
  if (outputs.empty()) return;
  std::vector<std::filesystem::path> inputs;
  for (const std::filesystem::path& clip : clips) {
    try {
      for (const auto& file : read.filesOf(clip)) inputs.push_back(file);
    } catch (const InputError&) {
      inputs.push_back(clip);
    }
  }
  for (const std::filesystem::path& output : outputs) keepInputs(output, inputs);
}

/// The files that were asked for, of every clip that could be read.
void writeOutputs(const std::vector<AnalysedClip>& clips, const AnalyseArguments& options,
                  const std::vector<std::filesystem::path>& plants,
                  const std::vector<std::filesystem::path>& plots) {
  for (size_t i = 0; i < clips.size(); ++i) {
    const AnalysedClip& clip = clips[i];
    if (!clip.good()) continue;
    if (!options.plants.empty()) {
      writeFile(plants[i], [&](std::ostream& out) { writePlantsCsv(out, clip); });
    }
    if (!options.plot.empty()) {
      writeGaitPlot(plots[i], clip.analysis, clip.file.filename().string(), clip.first_frame);
    }
  }
}

int run(const AnalyseArguments& options) {
  const std::vector<std::filesystem::path> files = findClips(options.paths);
  std::vector<std::filesystem::path> plants, plots;
  if (!options.plants.empty()) plants = outputNames("--plants", options.plants, "csv", files);
  if (!options.plot.empty()) plots = outputNames("--plot", options.plot, "svg", files);
  keepClips(files, options.read, plants);
  keepClips(files, options.read, plots);
  std::vector<AnalysedClip> clips;
  {
    Progress progress(files.size() > 1);
    const auto done = [&](int count) {
      progress.update(fmt::format("{} of {} clips", count, files.size()),
                      static_cast<double>(count) / static_cast<double>(files.size()));
      return !stopFlag();
    };
    clips = analyseFiles(files, {options.read.forReader(), options.as_is}, options.threads, done);
  }
  if (stopFlag()) return kExitStopped;
  writeOutputs(clips, options, plants, plots);
  bool wrong = false;
  for (const AnalysedClip& clip : clips) {
    if (clip.good()) continue;
    wrong = true;
    say(stderr, "{}\n", clip.error);
  }
  print(clips, options.json);
  return wrong ? kExitWrong : kExitDone;
}

}  // namespace

void addAnalyse(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<AnalyseArguments>();
  CLI::App* command = app.add_subcommand(
      "analyse", "Measure clips: foot plants, gait events, type, speed, stride, lift, quality");
  command->add_option("CLIP", options->paths, "Captures, and folders of them; - is standard input")
      ->type_name("FILE")
      ->required();
  addReadOptions(*command, options->read);
  command->add_flag("--as-is", options->as_is,
                    "All frames, and z = 0 is the floor: cut off no bad start, level no floor");
  command
      ->add_option("--plants", options->plants,
                   "Write frame,left,right: a file, a name with {stem}, or a folder")
      ->type_name("FILE");
  command
      ->add_option("--plot", options->plot,
                   "Write a picture (SVG) of the feet: a file, a name with {stem}, or a folder")
      ->type_name("FILE");
  addThreadsOption(*command, options->threads);
  command->add_flag("--json", options->json, "Print results for machines");
  command->callback([options, &chosen] {
    chosen = onThreads(options->threads, [options] { return run(*options); });
  });
}

}  // namespace amble
