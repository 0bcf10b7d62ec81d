/// What an option of a command is seen to do: for tests that run all options of a command, and fail
/// for one that the help has and no line of theirs.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "tests/app/program.h"

namespace amble {

class Options : public InRoom {
 protected:
  /// What an option is seen to do, by its long name.
  using Uses = std::map<std::string, std::function<void()>>;

  /// First words of the lines of a part of the help, such as "Subcommands:".
  std::vector<std::string> listed(const std::string& command, const std::string& part) const {
    std::istringstream help(run(command + " --help").out);
    std::vector<std::string> words;
    bool within = false;
    for (std::string line; std::getline(help, line);) {
      if (line == part || line.empty()) within = line == part;
      if (within && line.starts_with("  ") && line[2] != ' ') {
        words.push_back(line.substr(2, line.find(' ', 2) - 2));
      }
    }
    return words;
  }
  /// Long names of a command's options but --help.
  std::set<std::string> optionsOf(const std::string& command) const {
    std::set<std::string> names;
    for (const std::string& word : listed(command, "Options:")) {
      const size_t longer = word.find("--");
      if (longer != word.npos && !word.ends_with("--help")) names.insert(word.substr(longer));
    }
    return names;
  }
  /// The same of a table in parts.
  void expectAll(const std::string& command, const std::vector<Uses>& parts) const {
    Uses all;
    for (const Uses& part : parts) all.insert(part.begin(), part.end());
    expectEach(command, all);
  }
  void expectEach(const std::string& command, const Uses& uses) const {
    std::set<std::string> used;
    for (const auto& [option, use] : uses) used.insert(option);
    EXPECT_EQ(optionsOf(command), used);
    for (const auto& [option, use] : uses) {
      SCOPED_TRACE("amble " + command + " " + option);
      use();
    }
  }
  Ran good(const std::string& arguments, int status = 0, const std::string& before = "") const {
    Ran ran = run(arguments, before);
    EXPECT_EQ(ran.status, status) << "amble " << arguments << '\n' << ran.out << ran.err;
    return ran;
  }
  nlohmann::json printed(const std::string& arguments, int status = 0) const {
    return nlohmann::json::parse(good(arguments, status).out);
  }
  /// A mesh of 28,000 triangles, which do not fit into a megabyte.
  void writeGrid() const {
    constexpr int kSide = 120;
    std::ostringstream grid;
    for (int i = 0; i < kSide * kSide; ++i) {
      grid << "v " << 0.05 * (i % kSide) << ' ' << 0.03 * static_cast<int>(i / kSide) << " 0\n";
    }
    for (int i = 0; i + kSide + 1 < kSide * kSide; ++i) {
      if (i % kSide + 1 == kSide) continue;
      grid << "f " << i + 1 << ' ' << i + 2 << ' ' << i + kSide + 2 << ' ' << i + kSide + 1 << '\n';
    }
    write("in/grid.obj", grid.str());
    write("in/mesh.yaml", kRoom + "  - {name: grid, mesh: grid.obj, up: z, at: [0, 0, 0]}\n");
    write("in/of-mesh.yaml", "scene: mesh.yaml\n" + kScenario.substr(kScenario.find("start")));
  }
  void expectMemoryBounds(const std::string& arguments) const {
    writeGrid();
    expectRefused(arguments + " --memory 1", {"more than 1 MB", "--memory"});
    good(arguments + " --memory 700");
  }
};

}  // namespace amble
