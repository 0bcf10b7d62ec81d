#include "app/library_find.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/library_found.h"
#include "app/progress.h"
#include "app/read_options.h"
#include "app/say.h"
#include "app/stop.h"
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

/// "75%" or "0.75"; nothing where it is neither.
std::optional<double> shareOf(const std::string& text) {
  const bool percent = text.ends_with('%');
  const std::optional<double> number =
      numberOf(std::string_view(text).substr(0, text.size() - (percent ? 1 : 0)));
  if (!number) return std::nullopt;
  const double share = percent ? *number / 100.0 : *number;
  return share >= 0.0 && share <= 1.0 ? std::optional(share) : std::nullopt;
}

std::string segmentsText(const FoundMotion& found) {
  std::string text;
  for (const MotionSegment& segment : found.segments) {
    text += fmt::format("{}{}-{}", text.empty() ? "  frames " : ", ", segment.first, segment.last);
  }
  return text;
}

void print(const std::vector<FoundMotion>& all, const std::string& type, bool json) {
  if (json) {
    std::cout << foundJson(all, type).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    return;
  }
  for (const FoundMotion& found : all) {
    say(stdout, "{:>3.0f} % {}  {}{}\n", 100.0 * found.share, type, found.name,
        segmentsText(found));
  }
}

int run(const LibraryFindArguments& options) {
  Progress progress;
  MotionSearch search{.paths = options.paths,
                      .type = options.type,
                      .at_least = *shareOf(options.at_least),
                      .read = options.read.forReader(),
                      .threads = options.threads,
                      .done = {}};
  search.done = [&](int done, int count) {
    if (count > 1)
      progress.update(fmt::format("{} of {} clips", done, count),
                      static_cast<double>(done) / static_cast<double>(count));
    return !stopFlag();
  };
  std::vector<std::string> wrong;
  const std::vector<FoundMotion> all = findMotions(search, wrong);
  progress.clear();
  if (stopFlag()) return kExitStopped;
  for (const std::string& error : wrong) say(stderr, "{}\n", error);
  print(all, options.type, options.json);
  if (!wrong.empty()) return kExitWrong;
  return all.empty() ? kExitNone : kExitDone;
}

}  // namespace

void addLibraryFind(CLI::App& library, Command& chosen) {
  const auto options = std::make_shared<LibraryFindArguments>();
  options->paths = {"default"};
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
  addThreadsOption(*command, options->threads);
  command->add_flag("--json", options->json, "Print results for machines");
  addExamples(*command, {"amble library find --type walk --at-least 75%"});
  addExitStatus(*command, "some were found", "none was found");
  command->callback([options, &chosen] {
    chosen = onThreads(options->threads, [options] { return run(*options); });
  });
}

}  // namespace amble
