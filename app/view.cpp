// amble view DIR | WALK.bvh | CLIP... | LIBRARY.yaml | GRAPH: a page to look at results and
// captures with, in a browser.

#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <set>

#include "animation/captures/capture_file.h"
#include "animation/library/motion_library_reader.h"
#include "app/clip_sources.h"
#include "app/command.h"
#include "app/graph_words.h"
#include "app/library_addition.h"
#include "app/open_file.h"
#include "app/own_files.h"
#include "app/read_options.h"
#include "app/result_folder.h"
#include "app/say.h"
#include "app/stop.h"
#include "app/view_bench.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/output_file.h"
#include "base/parallel.h"
#include "base/strict_yaml.h"
#include "base/text.h"
#include "viz/page/clip_page.h"
#include "viz/page/thin_clips.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

struct ViewArguments {
  std::vector<std::string> paths;
  ReadOptions read;
  std::string scene, captures, out;
  double error = kGraphError;  // [m]
  bool open = false, json = false;
};

// What is to be shown, and where the page goes if nobody says.
struct Shown {
  std::vector<fs::path> clips;
  std::optional<fs::path> scene;
  fs::path page;
};

Shown find(const ViewArguments& options) {
  Shown shown;
  if (!options.scene.empty()) shown.scene = options.scene;
  if (options.paths.size() == 1 && isResultFolder(options.paths[0])) {
    const fs::path folder = options.paths[0];
    shown.clips = {folder / "walk.bvh"};
    shown.page = folder / "walk.html";
    if (!shown.scene) shown.scene = sceneOfResult(folder);
    return shown;
  }
  shown.clips = findClips(options.paths);
  const fs::path& first = shown.clips.front();
  shown.page = first == "-" ? fs::path("motion.html") : first.stem().concat(".html");
  if (shown.scene && shown.clips.size() > 1)
    throw InputError("--scene", 0, fmt::format("with {} clips", shown.clips.size()), "one walk");
  return shown;
}

void keepAll(const Shown& shown, const ViewArguments& options, const std::optional<Scene>& scene) {
  std::vector<fs::path> inputs;
  for (const fs::path& clip : shown.clips)
    for (const fs::path& file : options.read.filesOf(clip)) inputs.push_back(file);
  if (shown.scene) inputs.push_back(*shown.scene);
  if (scene) inputs.insert(inputs.end(), scene->inputs.begin(), scene->inputs.end());
  if (shown.page != "-") keepInputs(shown.page, inputs);
}

std::optional<Scene> sceneFor(const Shown& shown, const ViewArguments& options) {
  if (!shown.scene) return std::nullopt;
  LoadLimits limits;
  limits.memory = options.read.memory;
  const Scene scene = readScene(*shown.scene, limits);
  keepAll(shown, options, scene);
  return scene;
}

// A walk in its scene, or captures, of which some may be bad.
ReadClips readShown(const Shown& shown, const std::optional<Scene>& scene,
                    const MotionReadOptions& how) {
  if (!scene) return readClips(shown.clips, how);
  ReadClips read;
  read.clips.push_back(readWalkIn(*scene, shown.clips.front(), how));
  return read;
}

void writeShown(const Shown& shown, std::vector<ShownClip>& clips,
                const std::optional<Scene>& scene) {
  Bench bench;
  if (!scene) bench = benchOf(clips);
  const bool exactly = fitExactly(clips);
  const std::vector<std::string> notes = thinClips(clips);
  PageSubject page = clipPage(clips, scene ? &*scene : nullptr);
  for (PageTake& take : page.takes) take.coarse = !exactly;
  page.notes.insert(page.notes.end(), notes.begin(), notes.end());
  if (!scene) page.bench = &bench;
  writeFile(shown.page, [&](std::ostream& out) { writePage(out, page); });
}

// A workbench that is of one file: its page, or all that it shows for machines.
int showBench(const ViewArguments& options, PageSubject page, const Bench& bench,
              const std::vector<fs::path>& inputs) {
  if (options.json) printBench(bench);
  if (options.json && options.out.empty()) return kExitDone;
  const fs::path file = options.paths[0];
  const fs::path out = options.out.empty() ? file.stem().concat(".html") : fs::path(options.out);
  if (out != "-") keepInputs(out, inputs);
  page.title = file.filename().string();
  page.bench = &bench;
  writeFile(out, [&](std::ostream& stream) { writePage(stream, page); });
  if (out == "-") return kExitDone;
  if (!options.json) say(stdout, "{}: open it in a browser\n", out.string());
  if (options.open) openFile(out);
  return kExitDone;
}

// A library may be broken; another of Amble's files is told as what it is.
void requireLibrary(const fs::path& file) {
  const YamlNode root = readYaml(file);
  const OwnFile kind = ownFileOf(root);
  if (kind == OwnFile::kNone || kind == OwnFile::kLibrary) return;
  root.fail("is " + describeOwnFile(kind),
            "a folder of results, captures, a motion library or a cluster graph");
}

int viewLibrary(const ViewArguments& options) {
  const fs::path file = options.paths[0];
  const MotionLibrary library = readMotionLibrary(file);
  const BenchLibrary shown = benchOfLibrary(library, capturesOf(file, options.captures));
  PageSubject page = clipPage(shown.clips);
  page.description = "Motion library " + file.filename().string() + ": " +
                     counted(static_cast<long long>(library.motions.size()), "motion") + ".";
  return showBench(options, std::move(page), benchOf(shown),
                   {file, file.parent_path() / library.skeleton_file});
}

std::string joinsNote(const BenchGraph& shown) {
  const size_t made = shown.joins.size();
  if (shown.joins_found == 0)
    return fmt::format("No frames are alike at error {:g} m but those that follow one another.",
                       shown.cut.error);
  if (static_cast<int>(made) == shown.joins_found) return "";
  return fmt::format("{} of {} transitions can be played: of each two clips the smoothest.", made,
                     shown.joins_found);
}

int viewGraph(const ViewArguments& options) {
  const KeptGraph kept = readFreshGraph(options.paths[0]);
  std::set<int> all;
  std::vector<fs::path> inputs = {options.paths[0]};
  for (size_t i = 0; i < kept.inputs.size(); ++i) {
    all.insert(static_cast<int>(i));
    for (const GraphInput& input : kept.inputs[i])
      inputs.push_back(inputFile(options.paths[0], input));
  }
  const GraphClips clips =
      readKeptClips(kept, options.paths[0], all, kept.graph.frame_time, usualThreads());
  BenchGraph shown = benchOfGraph(kept.graph, clips, options.error);
  const Bench bench = benchOf(shown);
  const bool exactly = fitExactly(shown.clips);
  std::vector<std::string> notes = thinClips(shown.clips);
  PageSubject page = clipPage(shown.clips);
  for (PageTake& take : page.takes) take.coarse = !exactly;
  page.description =
      fmt::format("Cluster graph of {}: {} of frames that are alike.",
                  counted(static_cast<long long>(kept.graph.clips.size()), "clip"),
                  counted(static_cast<long long>(shown.cut.clusters.size()), "cluster"));
  page.notes = std::move(notes);
  if (std::string note = joinsNote(shown); !note.empty()) page.notes.push_back(std::move(note));
  return showBench(options, std::move(page), bench, inputs);
}

// Of a folder of results the page that came with them, which knows more than its walk tells.
int showPage(const fs::path& page, const ViewArguments& options) {
  fs::path shown = page;
  if (!options.out.empty()) {
    shown = options.out;
    if (shown != "-") keepInputs(shown, {page});
    std::ifstream in(page, std::ios::binary);
    writeFile(shown, [&](std::ostream& out) { out << in.rdbuf(); });
  }
  if (shown == "-") return kExitDone;
  say(stdout, "{}: open it in a browser\n", shown.string());
  if (options.open) openFile(shown);
  return kExitDone;
}

void refuseScene(const ViewArguments& options, const char* shown) {
  if (!options.scene.empty())
    throw InputError("--scene", 0, fmt::format("with a {}", shown), "one walk");
}

void requirePageName(const std::filesystem::path& out) {
  if (out.empty() || out == "-" || isStream(out)) return;
  if (out.extension() == ".html" || out.extension() == ".htm") return;
  throw InputError(out.string(), 0, "is no name of a page", "NAME.html");
}

int run(ViewArguments options) {
  requirePageName(options.out);
  if (options.paths.size() == 1 && !isResultFolder(options.paths[0]))
    if (const auto only = onlyResultIn(options.paths[0])) options.paths[0] = only->string();
  if (options.json && options.out == "-")
    throw InputError("--json", 0, "with a page on standard output", "-o FILE, or no page");
  if (options.paths.size() == 1 && isYaml(options.paths[0])) {
    requireLibrary(options.paths[0]);
    refuseScene(options, "motion library");
    return viewLibrary(options);
  }
  if (options.paths.size() == 1 && looksLikeGraph(options.paths[0])) {
    refuseScene(options, "cluster graph");
    return viewGraph(options);
  }
  if (options.paths.size() == 1 && options.scene.empty() && !options.json) {
    if (const auto page = pageOfResult(options.paths[0])) return showPage(*page, options);
  }
  Shown shown = find(options);
  if (!options.out.empty()) shown.page = options.out;
  keepAll(shown, options, std::nullopt);
  const std::optional<Scene> scene = sceneFor(shown, options);
  ReadClips read = readShown(shown, scene, options.read.forReader());
  if (stopFlag()) return kExitStopped;
  for (const std::string& error : read.errors) say(stderr, "{}\n", error);
  const int status = read.errors.empty() ? kExitDone : kExitWrong;
  if (options.json) printBench(benchOf(read.clips));
  if (read.clips.empty() || (options.json && options.out.empty())) return status;
  writeShown(shown, read.clips, scene);
  if (shown.page == "-") return status;
  if (!options.json) say(stdout, "{}: open it in a browser\n", shown.page.string());
  if (options.open) openFile(shown.page);
  return status;
}

}  // namespace

void addView(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<ViewArguments>();
  CLI::App* command =
      app.add_subcommand("view", "Write a page to look at a result or at captures, in a browser");
  command
      ->add_option(
          "PATH", options->paths,
          "A folder of results, or one that holds just that (its page, or one made of its walk), a "
          "walk, captures and "
          "folders of them, a motion library (YAML), or a cluster graph; - is standard input")
      ->type_name("FILE")
      ->required();
  command->add_option("--scene", options->scene, "Scene file (YAML) that the walk is in")
      ->type_name("FILE");
  command
      ->add_option("--captures", options->captures,
                   "Folder of a library's captures; default: its recipe's `captures:`")
      ->type_name("DIR");
  command
      ->add_option("-o,--output", options->out,
                   "The page; - is standard output; default: walk.html of the folder of results, "
                   "or STEM.html")
      ->type_name("FILE");
  command
      ->add_option("--error", options->error,
                   "Of a cluster graph: frames that differ by less are alike")
      ->check(number(0, 100, "m"))
      ->capture_default_str();
  command->add_flag("--open", options->open, "Open it in the browser");
  command->add_flag("--json", options->json,
                    "Print what the page of captures shows, for machines; a page only with -o");
  addReadOptions(*command, options->read);
  addExamples(*command, {"amble view out/living-room --open",
                         "amble view walk.bvh --scene scene.yaml -o walk.html",
                         "amble view captures/walk1.bvh captures/walk2.bvh -o walks.html",
                         "amble view animation/motions/default.yaml --captures captures",
                         "amble view walks.graph -o graph.html"});
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
