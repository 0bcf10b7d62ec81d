#include "scenarios/input_digests.h"

#include <system_error>
#include <vector>

#include "base/parallel.h"
#include "base/sha256.h"

namespace amble {

std::map<std::string, std::string> inputDigests(const Problem& problem,
                                                const std::filesystem::path& roadmap) {
  namespace fs = std::filesystem;
  const ScenarioSource& source = problem.scenario.source;
  const fs::path folder = fs::absolute(source.file.parent_path() / ".").lexically_normal();
  std::map<std::string, std::string> inputs;
  if (!source.sha256.empty()) inputs[source.file.filename().string()] = source.sha256;
  std::vector<fs::path> files = problem.scene.inputs;
  files.push_back(problem.library.file);
  files.push_back(problem.library.file.parent_path() / problem.library.skeleton_file);
  if (!roadmap.empty()) files.push_back(roadmap);
  // What is no regular file would be read a second time.
  std::erase_if(files, [](const fs::path& file) {
    std::error_code unknown;
    return !fs::is_regular_file(file, unknown);
  });
  std::vector<std::string> digests(files.size());
  parallelFor(static_cast<int>(files.size()), usualThreads(),
              [&](int i, int) { digests[i] = sha256OfFile(files[i]); });
  for (size_t i = 0; i < files.size(); ++i) {
    const fs::path relative = fs::absolute(files[i]).lexically_normal().lexically_relative(folder);
    inputs[relative.generic_string()] = digests[i];
  }
  return inputs;
}

}  // namespace amble
