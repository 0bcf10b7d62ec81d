#include "app/graph_made.h"

#include <fmt/format.h>

#include "animation/graph/graph_clips.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/text.h"

namespace amble {
namespace {

// The clips' files, each once, with what is read for them.
KeptGraph inputsOf(const std::vector<std::filesystem::path>& files,
                   const std::filesystem::path& out, const ReadOptions& read) {
  KeptGraph kept;
  kept.reading = read.forReader();
  const auto beside = [&](const std::string& file) {
    return file.empty() ? std::string() : graphInput(out, file).path;
  };
  kept.reading.asf = beside(read.asf);
  kept.reading.roles = beside(read.roles);
  for (const std::filesystem::path& file : files) {
    if (file == "-")
      throw InputError("amble graph build", 0, "a clip on standard input cannot be played later",
                       "files");
    std::vector<GraphInput> inputs;
    for (const std::filesystem::path& part : read.filesOf(file)) {
      std::error_code ignored;
      if (std::filesystem::exists(part, ignored) &&
          !std::filesystem::is_regular_file(part, ignored))
        throw InputError(part.string(), 0, "is no file that can be read again to be played",
                         "a file");
      keepInputs(out, {part});
      inputs.push_back(graphInput(out, part));
    }
    for (const std::vector<GraphInput>& other : kept.inputs)
      if (other[0].path == inputs[0].path)
        throw InputError(file.string(), 0, "is given twice", "each clip once");
    kept.inputs.push_back(inputs);
  }
  return kept;
}

}  // namespace

KeptGraph makeKeptGraph(const std::vector<std::filesystem::path>& files,
                        const std::filesystem::path& out, const GraphMaking& making,
                        std::vector<std::string>& warnings) {
  const auto tell = [&](const std::string& stage) {
    if (making.stage) making.stage(stage);
  };
  KeptGraph kept = inputsOf(files, out, making.read);
  tell(fmt::format("reading {}", counted(static_cast<long long>(files.size()), "clip")));
  std::optional<double> frame_time;
  if (making.fps > 0.0) frame_time = 1.0 / making.fps;
  const GraphClips clips =
      readGraphClips(files, making.read.forReader(), frame_time, making.threads, making.stop);
  tell("clustering");
  kept.graph = makeGraph(clips, making.threads, making.stop);
  warnings = clips.warnings;
  return kept;
}

}  // namespace amble
