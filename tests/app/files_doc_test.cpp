// docs/files.md against the readers: its examples are right, and its tables have the keys that the
// readers know and the report holds, no others.

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "test_paths.h"
#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Keys = std::set<std::string>;  // "objects.box.size"

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// The yaml blocks, by the file that their first line names.
std::map<std::string, std::string> examplesOf(const fs::path& page) {
  std::map<std::string, std::string> examples;
  const std::string text = textOf(page);
  const std::regex block("```yaml\n# (\\w+\\.yaml)([^`]*)```");
  for (std::sregex_iterator at(text.begin(), text.end(), block), end; at != end; ++at)
    examples[(*at)[1]] = "#" + (*at)[2].str();
  return examples;
}

// Of the first column of a section's table.
Keys documentedKeys(const std::string& section) {
  Keys keys;
  bool inside = false;
  const std::regex quoted("`([a-z_0-9.]+)`");
  for (const std::string& line : linesOf(textOf(sourceFolder() / "docs/files.md"))) {
    if (line.starts_with("## ")) inside = line == "## " + section;
    if (!inside || !line.starts_with("| `")) continue;
    const std::string first = line.substr(0, line.find('|', 1));
    for (std::sregex_iterator at(first.begin(), first.end(), quoted), end; at != end; ++at)
      keys.insert((*at)[1]);
  }
  return keys;
}

// The keys, without those that have others below them.
Keys leavesOf(const Keys& keys) {
  Keys leaves;
  for (const std::string& key : keys) {
    const auto next = keys.lower_bound(key + ".");
    if (next == keys.end() || !next->starts_with(key + ".")) leaves.insert(key);
  }
  return leaves;
}

// The text with a key that no reader knows in one map, for each of its maps; of list items that
// begin alike the first.
std::vector<std::string> withAKeyTooMany(const std::string& text) {
  const std::string unknown = "zzzzzzzz: 0";
  std::vector<std::string> changed;
  for (size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1))
    changed.push_back(text.substr(0, at + 1) + unknown + ", " + text.substr(at + 1));
  const std::regex keyed("( *(?:- )?)[a-z_]+:[^]*");
  std::set<std::string> seen;
  std::string before, last;
  size_t indent = 0, begin = 0;
  for (const std::string& line : linesOf(text)) {
    std::smatch match;
    if (std::regex_match(line, match, keyed)) {
      const std::string lead = match[1];
      const bool item = lead.ends_with("- ");
      const bool opens = last.empty() || item || lead.size() > indent;
      if (opens && seen.insert(item ? lead : last).second)
        changed.push_back(before + lead + unknown + "\n" + std::string(lead.size(), ' ') +
                          text.substr(begin + lead.size()));
      indent = lead.size();
      last = line;
    }
    before += line + "\n";
    begin += line.size() + 1;
  }
  return changed;
}

void addKeys(const json& value, const std::string& path, Keys& keys) {
  if (value.is_array() && !value.empty()) return addKeys(value[0], path, keys);
  if (!path.empty()) keys.insert(path);
  if (!value.is_object() || path == "refusals" || path == "inputs") return;
  for (const auto& [key, below] : value.items())
    addKeys(below, path.empty() ? key : path + "." + key, keys);
}

class FilesPage : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    for (const char* folder : {"scenarios", "environments", "animation"})
      fs::create_directory_symlink(sourceFolder() / folder, folder_ / folder);
    for (const auto& [name, text] : examplesOf(sourceFolder() / "docs/files.md")) write(name, text);
  }

  // What the readers say that they know, when a file has a key that they do not.
  Keys knownKeys(const std::string& file) const {
    Keys keys;
    const std::regex message("unknown key 'zzzzzzzz'(?: in ([^;]*))?; expected ([^\n]*)");
    const std::string text = read(file);
    for (const std::string& changed : withAKeyTooMany(text)) {
      write(file, changed);
      const Ran ran = run("inspect " + file);
      EXPECT_EQ(ran.status, 2) << changed;
      std::smatch match;
      if (!std::regex_search(ran.err, match, message)) continue;
      const std::string in = std::regex_replace(match[1].str(), std::regex("\\[\\d+\\]"), "");
      std::string known = std::regex_replace(match[2].str(), std::regex(" or "), ", ");
      const std::regex name("[^, ]+");
      for (std::sregex_iterator at(known.begin(), known.end(), name), end; at != end; ++at)
        keys.insert(in.empty() ? at->str() : in + "." + at->str());
    }
    write(file, text);
    return keys;
  }
};

TEST_F(FilesPage, ItsExamplesAndTheReadmesAreRight) {
  for (const char* page : {"docs/files.md", "README.md"}) {
    const auto examples = examplesOf(sourceFolder() / page);
    EXPECT_TRUE(examples.contains("room.yaml") && examples.contains("walk.yaml")) << page;
    for (const auto& [name, text] : examples) write(name, text);
    for (const auto& [name, text] : examples) {
      if (name == "job.yaml") continue;  // of a batch
      const Ran ran = run("inspect " + name);
      EXPECT_EQ(ran.status, 0) << page << ' ' << name << '\n' << ran.err;
    }
    const Ran ran = run("plan walk.yaml -o out --formats json");
    EXPECT_EQ(ran.status, 0) << page << '\n' << ran.out << ran.err;
  }
}

TEST_F(FilesPage, ItSaysWhatIsMeasuredOfAWalk) {
  run("plan " + (sourceFolder() / "scenarios/log.yaml").string() + " -o log --formats json");
  const std::string page = textOf(sourceFolder() / "docs/files.md");
  const nlohmann::json quality = nlohmann::json::parse(read("log/report.json"))["quality"];
  EXPECT_GE(quality.size(), 15u);
  for (const nlohmann::json& line : quality) {
    const std::string measure = line["measure"];
    EXPECT_TRUE(page.find("| " + measure) != std::string::npos ||
                page.find("; " + measure) != std::string::npos)
        << measure;
  }
}

// One more motion of the default library, whose skeleton has 22 joints.
std::string turnOnSpot() {
  std::string text =
      "  - name: about\n    kind: turn_on_spot\n    valid: always\n    joints: all\n"
      "    source:\n      clip: a\n      frames: [0, 9]\n      licence: b\n      credit: c\n"
      "    turn:\n      angle: 170\n      duration: 2\n      first: left\n      steps: 3\n"
      "      twist: 40\n      turned: [0.5]\n      spline:\n";
  for (int row = 0; row < 3 + 3 * 22; ++row) text += "        - [0]\n";
  return text;
}

// The default library with one walk only, which says that it is of a speed engine.
std::string walkOfEngine(const std::string& library) {
  const size_t motions = library.find("  - name: "), from = library.find("  - name: walk-slow\n");
  const std::string walk = library.substr(from, library.find("  - name: ", from + 1) - from);
  return library.substr(0, motions) +
         std::regex_replace(walk, std::regex("frames: [^\n]*"), "speed: 0.8");
}

TEST_F(FilesPage, ItHasTheKeysThatTheReadersKnow) {
  EXPECT_EQ(leavesOf(documentedKeys("Scene")), leavesOf(knownKeys("room.yaml")));
  Keys scenario = knownKeys("walk.yaml");
  scenario.merge(knownKeys("walks.yaml"));
  EXPECT_EQ(leavesOf(documentedKeys("Scenario")), leavesOf(scenario));
  Keys library = knownKeys("mine.yaml");
  write("default.yaml", read("animation/motions/default.yaml") + turnOnSpot());  // with cycles
  write("default.bvh", read("animation/motions/default.bvh"));
  library.merge(knownKeys("default.yaml"));
  write("default.yaml", walkOfEngine(read("animation/motions/default.yaml")));
  library.merge(knownKeys("default.yaml"));
  const Keys documented = leavesOf(documentedKeys("Motion library")), known = leavesOf(library);
  Keys either;
  std::set_symmetric_difference(documented.begin(), documented.end(), known.begin(), known.end(),
                                std::inserter(either, either.end()));
  EXPECT_EQ(either, Keys());
}

TEST_F(FilesPage, ItHasTheKeysOfASpeedEngine) {
  for (const char* const speed : {"0.7", "1.1", "1.5"}) {
    ASSERT_EQ(run(std::string("animate -o ") + speed + ".bvh --duration 6 --speed " + speed).status,
              0);
  }
  ASSERT_EQ(run("library engine build 0.7.bvh 1.1.bvh 1.5.bvh -o engine.yaml").status, 0);
  // Components are indented otherwise than clips: of items that begin alike only one is tried.
  std::string text = read("engine.yaml");
  const size_t components = text.find("\n", text.find("  components:"));
  text.replace(components, text.npos,
               std::regex_replace(text.substr(components), std::regex("\n +"), "$&  "));
  write("engine.yaml", text);
  EXPECT_EQ(leavesOf(documentedKeys("Speed engine")), leavesOf(knownKeys("engine.yaml")));
}

TEST_F(FilesPage, ItHasTheResultsWithTheirColumnsAndArrays) {
  ASSERT_EQ(run("plan walk.yaml -o walk --formats csv,npz,sdf,glb,svg,html,json").status, 0);
  const std::string page = textOf(sourceFolder() / "docs/files.md");
  for (const std::string file : {"path.csv", "steps.csv", "joints.csv"}) {
    const size_t from = page.find("- `" + file),
                 to = page.find(file == "joints.csv" ? "\n\n" : "\n-", from);
    const std::string about = page.substr(from, to - from);
    std::istringstream header(linesOf(read("walk/" + file)).at(0));
    for (std::string name; std::getline(header, name, ',');) {
      if (name.ends_with('\r')) name.pop_back();
      if (file == "joints.csv")
        name = std::regex_replace(name, std::regex("^\\w+ ([xyz])"), "NAME $1");
      EXPECT_NE(about.find('`' + name + '`'), about.npos) << file << ": " << name;
    }
  }
  for (const auto& file : fs::directory_iterator(folder_ / "walk")) {
    const std::string name = file.path().filename().string();
    EXPECT_NE(page.find("`" + name + "`"), page.npos) << name;
  }
  Keys arrays;
  const std::string bytes = read("walk/walk.npz");
  const std::regex entry("(\\w+)\\.npy\x93NUMPY");
  for (std::sregex_iterator at(bytes.begin(), bytes.end(), entry), end; at != end; ++at)
    arrays.insert((*at)[1]);
  EXPECT_EQ(documentedKeys("Arrays"), arrays);
}

TEST_F(FilesPage, ItHasTheKeysOfTheReport) {
  write("blocked.yaml",
        "scene: room.yaml\nstart: {at: [1, 1]}\ngoal: {at: [3, 2.8]}\n");  // in the pillar
  write("by.yaml",
        "scene: room.yaml\nstart: {at: [1, 1]}\ngoal: {at: [5, 1]}\nvia: [{at: [3, 2.8]}]\n");
  ASSERT_EQ(run("plan walk.yaml -o walk --formats json").status, 0);
  ASSERT_EQ(run("plan by.yaml -o by --formats json").status, 1);
  ASSERT_EQ(run("plan blocked.yaml -o blocked --formats json").status, 1);
  Keys keys;
  for (const char* report : {"walk/report.json", "blocked/report.json", "by/report.json"})
    addKeys(json::parse(read(report)), "", keys);
  EXPECT_EQ(leavesOf(documentedKeys("Report")), leavesOf(keys));
}

}  // namespace
}  // namespace amble
