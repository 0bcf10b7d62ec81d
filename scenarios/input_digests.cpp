#include "scenarios/input_digests.h"

#include <system_error>

#include "base/sha256.h"

namespace amble {

std::map<std::string, std::string> inputDigests(const Problem& problem,
                                                const std::filesystem::path& roadmap) {
  namespace fs = std::filesystem;
  const ScenarioSource& source = problem.scenario.source;
  const fs::path folder = fs::absolute(source.file.parent_path() / ".").lexically_normal();
  std::map<std::string, std::string> inputs;
  const auto add = [&](const fs::path& file) {
    std::error_code unknown;
    if (!fs::is_regular_file(file, unknown)) return;  // it would be read a second time
    const fs::path relative = fs::absolute(file).lexically_normal().lexically_relative(folder);
    inputs[relative.generic_string()] = sha256OfFile(file);
  };
  if (!source.sha256.empty()) inputs[source.file.filename().string()] = source.sha256;
  for (const fs::path& file : problem.scene.inputs) add(file);
  add(problem.library.file);
  add(problem.library.file.parent_path() / problem.library.skeleton_file);
  if (!roadmap.empty()) add(roadmap);
  return inputs;
}

}  // namespace amble
