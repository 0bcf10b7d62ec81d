#include "app/graft_all.h"

#include <fmt/format.h>

#include <atomic>
#include <iostream>
#include <memory>
#include <set>

#include "animation/captures/bvh.h"
#include "app/clip_sources.h"
#include "app/graft_report.h"
#include "app/output_folder.h"
#include "app/progress.h"
#include "app/read_options.h"
#include "app/say.h"
#include "app/stop.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/output_file.h"
#include "base/parallel.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

struct GraftAllArguments {
  std::vector<std::string> paths;
  std::string out = ".";
  ReadOptions read;
  std::vector<std::string> chains = {"left_arm", "right_arm"};
  bool json = false;
  int threads = 0;
};

// A pair of clips, by their places in the list; the same clip twice is no pair.
struct Pair {
  size_t base, upper;
  std::string file;     // name in the folder
  std::string refusal;  // "" where it was written
  MotionType base_type = MotionType::kUnknown, upper_type = MotionType::kUnknown;
  int first = 0, last = 0;
  bool cleared = false;  // arms made way
  Json data = {};
};

std::vector<GraftSource> readAll(const std::vector<std::filesystem::path>& files,
                                 const GraftAllArguments& options,
                                 std::vector<std::string>& errors) {
  std::vector<GraftSource> sources(files.size());
  std::vector<std::string> wrong(files.size());
  parallelFor(static_cast<int>(files.size()), options.threads, [&](int i, int) {
    if (stopFlag()) return;
    try {
      sources[i] = readGraftSource(files[i], options.read.forReader());
    } catch (const InputError& error) {
      wrong[i] = error.what();
    }
  });
  std::vector<GraftSource> good;
  for (size_t i = 0; i < files.size(); ++i) {
    if (wrong[i].empty()) {
      good.push_back(std::move(sources[i]));
    } else if (std::find(errors.begin(), errors.end(), wrong[i]) == errors.end()) {
      errors.push_back(wrong[i]);  // once: a file of roles is read with every clip
    }
  }
  return good;
}

std::vector<Pair> pairsOf(const std::vector<GraftSource>& sources) {
  std::vector<Pair> pairs;
  std::set<std::string> names;
  for (const GraftSource& source : sources) {
    if (!names.insert(source.file.stem().string()).second) {
      throw InputError(source.file.string(), 0, "has the name of another clip, but for its folder",
                       "clips whose names differ");
    }
  }
  for (size_t base = 0; base < sources.size(); ++base) {
    for (size_t upper = 0; upper < sources.size(); ++upper) {
      if (base == upper) continue;
      Pair pair{base, upper, {}, {}};
      pair.file = sources[upper].file.stem().string() + "-on-" +
                  sources[base].file.stem().string() + ".bvh";
      pairs.push_back(std::move(pair));
    }
  }
  return pairs;
}

void graftPair(const std::vector<GraftSource>& sources, const GraftAllArguments& options,
               Pair& pair) {
  const GraftSource &base = sources[pair.base], &upper = sources[pair.upper];
  GraftWishes wishes;
  wishes.chains = options.chains;
  Grafted grafted = graftOn(base, upper, wishes, true);
  pair.refusal = grafted.refusal;
  pair.base_type = grafted.plan.windows.base.type;
  pair.upper_type = grafted.plan.windows.upper.type;
  pair.first = grafted.graft.first;
  pair.last = grafted.graft.last;
  pair.cleared = grafted.clearing.frames[kLeft] + grafted.clearing.frames[kRight] > 0;
  pair.data = graftData(base, upper, grafted, wishes);
  if (!pair.refusal.empty()) return;
  pair.data["file"] = pair.file;
  grafted.graft.clip.joint_positions.clear();
  writeBvh(std::filesystem::path(options.out) / pair.file, grafted.graft.clip);
}

void printTable(const std::vector<GraftSource>& sources, const std::vector<Pair>& pairs) {
  size_t width = 5;
  for (const GraftSource& source : sources)
    width = std::max(width, source.file.stem().string().size());
  say(stdout, "{:<{}}  {:<{}}  {:<8} {:<8} {}\n", "upper", width, "base", width, "upper", "base",
      "graft");
  for (const Pair& pair : pairs) {
    const std::string result = pair.refusal.empty()
                                   ? fmt::format("frames {} to {}{}", pair.first, pair.last,
                                                 pair.cleared ? ", arms made way" : "")
                                   : "refused: " + pair.refusal;
    say(stdout, "{:<{}}  {:<{}}  {:<8} {:<8} {}\n", sources[pair.upper].file.stem().string(), width,
        sources[pair.base].file.stem().string(), width,
        std::string(motionTypeName(pair.upper_type)), std::string(motionTypeName(pair.base_type)),
        result);
  }
}

int run(const GraftAllArguments& options) {
  const std::vector<std::filesystem::path> files = findClips(options.paths);
  checkOutputFolder(options.out);
  std::vector<std::string> errors;
  const std::vector<GraftSource> sources = readAll(files, options, errors);
  if (stopFlag()) return kExitStopped;
  for (const std::string& error : errors) say(stderr, "{}\n", error);
  if (sources.size() < 2 && !errors.empty()) return kExitWrong;
  if (sources.size() < 2) {
    throw InputError(options.paths.front(), 0, "is one clip, which has nothing to go on",
                     "two clips or more");
  }
  std::vector<Pair> pairs = pairsOf(sources);
  std::filesystem::create_directories(options.out);
  for (const Pair& pair : pairs) keepInputs(std::filesystem::path(options.out) / pair.file, files);
  {
    Progress progress(pairs.size() > 1);
    std::atomic<int> finished{0};
    parallelFor(static_cast<int>(pairs.size()), options.threads, [&](int i, int) {
      if (stopFlag()) return;
      graftPair(sources, options, pairs[i]);
      const int done = ++finished;
      progress.update(fmt::format("{} of {} pairs", done, pairs.size()),
                      static_cast<double>(done) / static_cast<double>(pairs.size()));
    });
  }
  if (stopFlag()) return kExitStopped;
  Json index = Json::array();
  for (Pair& pair : pairs) index.push_back(std::move(pair.data));
  const std::string text = index.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  writeFile(std::filesystem::path(options.out) / "index.json",
            [&](std::ostream& out) { out << text; });
  if (options.json) {
    std::cout << text;
  } else {
    printTable(sources, pairs);
  }
  return errors.empty() ? kExitDone : kExitWrong;
}

}  // namespace

void addChainsOption(CLI::App& command, std::vector<std::string>& chains) {
  command
      .add_option("--chains", chains,
                  "left_arm, right_arm, head, trunk, upper (all of these), or a chain by its first "
                  "joint; default: both arms")
      ->delimiter(',')
      ->type_name("NAME,...");
}

void addGraftAll(CLI::App& graft, Command& chosen) {
  const auto options = std::make_shared<GraftAllArguments>();
  CLI::App* command =
      graft.add_subcommand("all", "Graft every pair of clips that the rules permit, with an index");
  command->add_option("DIR", options->paths, "Folders of captures, and captures")
      ->type_name("DIR")
      ->required();
  command
      ->add_option("-o,--output", options->out,
                   "Folder for UPPER-on-BASE.bvh of each pair, and index.json")
      ->type_name("DIR")
      ->capture_default_str();
  addChainsOption(*command, options->chains);
  addThreadsOption(*command, options->threads);
  command->add_flag("--json", options->json, "Print the index");
  addReadOptions(*command, options->read);
  command->callback([options, &chosen] {
    chosen = onThreads(options->threads, [options] { return run(*options); });
  });
}

}  // namespace amble
