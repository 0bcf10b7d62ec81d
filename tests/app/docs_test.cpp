// What README and docs/ tell their readers to type works: every indented line that begins with a
// program's name, in the page's order, in a folder with the page's own files, as in the clone's.

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "test_paths.h"
#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

// Without the comments behind them.
std::vector<std::string> commandsOf(const std::string& page) {
  std::vector<std::string> commands;
  const std::regex command("(?:^|\n)    ((?:amble|blender|python3) [^\n]*?)(?= +# |\n)");
  for (std::sregex_iterator at(page.begin(), page.end(), command), end; at != end; ++at)
    commands.push_back((*at)[1]);
  return commands;
}

// Those that tell anything to type, from the clone's folder.
std::vector<std::string> pages() {
  std::vector<std::string> found = {"README.md"};
  for (const auto& entry : fs::recursive_directory_iterator(sourceFolder() / "docs")) {
    if (entry.path().extension() == ".md" && !commandsOf(textOf(entry.path())).empty())
      found.push_back(fs::relative(entry.path(), sourceFolder()).string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

class Docs : public Program, public testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    Program::SetUp();
    for (const char* folder :
         {"scenarios", "environments", "animation", "examples", "tests", "docs"})
      fs::create_directory_symlink(sourceFolder() / folder, folder_ / folder);
  }

  // The yaml blocks whose first line names a file.
  void writeExamples(const std::string& page) const {
    const std::regex block("```yaml\n# (\\w+\\.yaml)\n([^`]*)```");
    for (std::sregex_iterator at(page.begin(), page.end(), block), end; at != end; ++at)
      write((*at)[1], (*at)[2]);
  }
};

TEST_P(Docs, CommandsWork) {
  const std::string page = textOf(sourceFolder() / GetParam());
  writeExamples(page);
  for (const std::string& command : commandsOf(page)) {
    if (command == "amble check scenarios") continue;  // scripts/test does it
    if (command.starts_with("blender") && type("command -v blender").status != 0)
      GTEST_SKIP() << "blender is not installed";
    const Ran ran = type(command);
    EXPECT_EQ(ran.status, 0) << command << '\n' << ran.out << ran.err;
  }
}

std::string nameOf(const testing::TestParamInfo<std::string>& page) {
  return std::regex_replace(page.param, std::regex("[^A-Za-z0-9]"), "_");
}

INSTANTIATE_TEST_SUITE_P(Pages, Docs, testing::ValuesIn(pages()), nameOf);

}  // namespace
}  // namespace amble
