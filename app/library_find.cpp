#include "app/library_find.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "animation/library/motion_library_reader.h"
#include "app/analysed_clip.h"
#include "app/clip_sources.h"
#include "app/progress.h"
#include "app/read_options.h"
#include "app/say.h"
#include "app/stop.h"
#include "base/parallel.h"
#include "base/text.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

struct LibraryFindArguments {
  ReadOptions read;
  std::vector<std::string> paths;
  std::string type, at_least = "75%";
  bool json = false;
  int threads = 0;
};

/// A clip, or a motion of a library, and how much of it is of the type that is looked for.
struct Found {
  std::string name;
  MotionType largest = MotionType::kUnknown;
  double share = 0.0;                   // [0, 1]
  std::vector<MotionSegment> segments;  // of that type, in frames of the file
};

/// "75%" or "0.75"; nothing where it is neither.
std::optional<double> shareOf(const std::string& text) {
  const bool percent = text.ends_with('%');
  const std::optional<double> number =
      numberOf(std::string_view(text).substr(0, text.size() - (percent ? 1 : 0)));
  if (!number) return std::nullopt;
  const double share = percent ? *number / 100.0 : *number;
  return share >= 0.0 && share <= 1.0 ? std::optional(share) : std::nullopt;
}

MotionType typeNamed(const std::string& name) {
  int i = 0;
  while (motionTypeName(static_cast<MotionType>(i)) != name) ++i;
  return static_cast<MotionType>(i);
}

Found foundIn(const AnalysedClip& clip, MotionType type) {
  Found found{
      clip.file.string(), clip.analysis.kind.largest(), clip.analysis.kind.shareOf(type), {}};
  for (MotionSegment segment : clip.analysis.kind.segments) {
    if (segment.type != type) continue;
    segment.first += clip.first_frame;
    segment.last += clip.first_frame;
    found.segments.push_back(segment);
  }
  return found;
}

/// A library's motions are cut from clips so that each is of one type.
std::vector<Found> foundIn(const MotionLibrary& library, MotionType type) {
  std::vector<Found> all;
  for (const Motion& motion : library.motions) {
    const MotionType own = motion.kind == MotionKind::kWalk      ? MotionType::kWalk
                           : motion.kind == MotionKind::kPosture ? MotionType::kStand
                                                                 : MotionType::kUnknown;
    const std::string name =
        fmt::format("{}: {} ({} {}-{})", library.file.string(), motion.name, motion.source.clip,
                    motion.source.frames[0], motion.source.frames[1]);
    all.push_back({name, own, own == type ? 1.0 : 0.0, {}});
  }
  return all;
}

bool isLibrary(const std::string& path) { return path == "default" || path.ends_with(".yaml"); }

/// What there is at the paths, clips in parallel. @param wrong  set where a clip cannot be read
std::vector<Found> search(const LibraryFindArguments& options, MotionType type, bool& wrong) {
  std::vector<Found> all;
  std::vector<std::string> clip_paths;
  for (const std::string& path : options.paths) {
    if (!isLibrary(path)) {
      clip_paths.push_back(path);
      continue;
    }
    const std::vector<Found> motions = foundIn(readMotionLibrary(motionLibraryFile(path)), type);
    all.insert(all.end(), motions.begin(), motions.end());
  }
  const std::vector<std::filesystem::path> files = findClips(clip_paths);
  Progress progress(files.size() > 1);
  const auto done = [&](int count) {
    progress.update(fmt::format("{} of {} clips", count, files.size()),
                    static_cast<double>(count) / static_cast<double>(files.size()));
    return !stopFlag();
  };
  const std::vector<AnalysedClip> clips =
      analyseFiles(files, {options.read.forReader()}, options.threads, done);
  progress.clear();
  if (stopFlag()) return {};
  for (const AnalysedClip& clip : clips) {
    if (clip.good()) {
      all.push_back(foundIn(clip, type));
    } else {
      wrong = true;
      say(stderr, "{}\n", clip.error);
    }
  }
  return all;
}

std::string segmentsText(const Found& found) {
  std::string text;
  for (const MotionSegment& segment : found.segments) {
    text += fmt::format("{}{}-{}", text.empty() ? "  frames " : ", ", segment.first, segment.last);
  }
  return text;
}

void print(const std::vector<Found>& all, const std::string& type, bool json) {
  if (!json) {
    for (const Found& found : all) {
      say(stdout, "{:>3.0f} % {}  {}{}\n", 100.0 * found.share, type, found.name,
          segmentsText(found));
    }
    return;
  }
  Json list = Json::array();
  for (const Found& found : all) {
    Json segments = Json::array();
    for (const MotionSegment& segment : found.segments) {
      segments.push_back({{"first_frame", segment.first}, {"last_frame", segment.last}});
    }
    list.push_back({{"name", found.name},
                    {"type", type},
                    {"share", found.share},
                    {"largest", motionTypeName(found.largest)},
                    {"segments", segments}});
  }
  std::cout << list.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

int run(const LibraryFindArguments& options) {
  bool wrong = false;
  std::vector<Found> all = search(options, typeNamed(options.type), wrong);
  if (stopFlag()) return kExitStopped;
  const double least = *shareOf(options.at_least);
  std::erase_if(all, [&](const Found& found) { return found.share < least - 1e-12; });
  std::stable_sort(all.begin(), all.end(),
                   [](const Found& a, const Found& b) { return a.share > b.share; });
  print(all, options.type, options.json);
  if (wrong) return kExitWrong;
  return all.empty() ? kExitNone : kExitDone;
}

}  // namespace

void addLibraryFind(CLI::App& library, Command& chosen) {
  const auto options = std::make_shared<LibraryFindArguments>();
  options->paths = {"default"};
  options->threads = usualThreads();
  CLI::App* command = library.add_subcommand(
      "find", "Find clips and motions that are mostly standing, walking, running or jumping");
  command->add_option("PATH", options->paths, "Clips, folders of them, libraries; default: default")
      ->type_name("FILE");
  command->add_option("--type", options->type, "stand, walk, run, jump or unknown")
      ->required()
      ->check(choice({"stand", "walk", "run", "jump", "unknown"}));
  const auto check = [](const std::string& text) -> std::string {
    return shareOf(text) ? "" : fmt::format("is '{}'; expected 0% to 100%, or 0 to 1", text);
  };
  command->add_option("--at-least", options->at_least, "Share of the clip's frames of that type")
      ->check(CLI::Validator(check, "[0% to 100%]"))
      ->capture_default_str();
  addReadOptions(*command, options->read);
  command->add_option("--threads", options->threads, "Threads; changes no result")
      ->check(wholeNumber(1, 64));
  command->add_flag("--json", options->json, "Print results for machines");
  addExamples(*command, {"amble library find --type walk --at-least 75%"});
  addExitStatus(*command, "some were found", "none was found");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
