/// What benchmarks run on: scenarios, shipped ones by name or files, planned once a program.
#pragma once

#include <benchmark/benchmark.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "scenarios/run_scenario.h"
#include "test_paths.h"

namespace amble {

/// A shipped scenario by name, or a file.
inline std::filesystem::path scenarioFile(const std::string& name) {
  if (name.ends_with(".yaml")) return name;
  return std::filesystem::path(AMBLE_SOURCE_DIR) / "scenarios" / (name + ".yaml");
}

/// Its walk, and all that it was planned with.
inline const RunResult& planned(const std::string& name) {
  static std::map<std::string, RunResult> all;
  const auto found = all.find(name);
  if (found != all.end()) return found->second;
  return all.emplace(name, runScenario(readScenario(scenarioFile(name)))).first->second;
}

/// Google's options from the command line, and rows for each scenario that it names besides, or
/// for the usual ones; then their run.
inline int runOnScenarios(int argc, char** argv, const std::vector<std::string>& usual,
                          const std::function<void(const std::string&)>& add_rows) {
  benchmark::Initialize(&argc, argv);
  const std::vector<std::string> named(argv + 1, argv + argc);
  for (const std::string& name : named.empty() ? usual : named) add_rows(name);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

/// "measure/living-room".
inline std::string rowName(const std::string& measure, const std::string& scenario) {
  return measure + "/" + std::filesystem::path(scenario).stem().string();
}

}  // namespace amble
