#include "scenarios/find_scenarios.h"

#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

class FindScenarios : public SmallRoom {};

TEST_F(FindScenarios, PathsThatHoldNoScenarioAreInputErrors) {
  EXPECT_TRUE(holds(inputError([&] { findScenarios({folder_ / "none"}); }), "is not there"));
  EXPECT_TRUE(
      holds(inputError([&] { findScenarios({folder_ / "scene.yaml"}); }), "is no scenario"));
  EXPECT_TRUE(holds(inputError([&] { findScenarios({folder_}); }), "holds no scenario"));
}

TEST_F(FindScenarios, FoldersAreSearchedAndOtherFilesPassedOver) {
  write("b.yaml", kScenario);
  write("deeper/a.yml", kScenario);
  write("deeper/notes.txt", kScenario);
  write("deeper/other.yaml", "objects: []\n");
  write("deeper/huge.yaml", kScenario + std::string(size_t{1} << 20, '#'));
  const std::vector<fs::path> expected = {folder_ / "b.yaml", folder_ / "deeper" / "a.yml"};
  std::vector<fs::path> found;
  for (const ScenarioFile& file : findScenarios({folder_})) {
    found.push_back(file.file);
    EXPECT_EQ(file.text, kScenario);
  }
  EXPECT_EQ(found, expected);
}

TEST_F(FindScenarios, ASlipDoesNotHideAScenarioAndSomebodyElsesFileIsPassedOver) {
  write("slip.yaml", std::string(kScenario) + "walk: {speed: 1\n");
  write("template.yaml", "start: %(start)s\n\t- broken\n");
  const std::vector<ScenarioFile> found = findScenarios({folder_});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].file.filename(), "slip.yaml");
}

TEST_F(FindScenarios, WhatCannotBeReadIsHeardOfAndHidesNothing) {
  write("a.yaml", kScenario);
  fs::create_symlink("loop.yaml", folder_ / "loop.yaml");
  fs::create_symlink("nowhere.yaml", folder_ / ".#mark.yaml");  // as editors do
  fs::create_directory(folder_ / "folder.yaml");
  const std::vector<ScenarioFile> found = findScenarios({folder_});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].unread, "");
  EXPECT_EQ(found[1].file.filename(), "loop.yaml");
  const std::string error = inputError([&] { readScenario(found[1]); });
  EXPECT_TRUE(holds(error, "loop.yaml: cannot be opened: ")) << error;
  EXPECT_TRUE(holds(inputError([&] { findScenarios({folder_ / "loop.yaml"}); }), "is not there"));
}

TEST_F(FindScenarios, AScenarioThatIsNamedMayBeAPipeAndNotTooLarge) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << kScenario; });
  const std::vector<ScenarioFile> found = findScenarios({pipe});
  writer.join();
  EXPECT_EQ(found.at(0).text, kScenario);
  EXPECT_NEAR(readScenario(found.at(0)).start.at.x(), 0.8, 1e-12);
  const std::string error = inputError([&] { findScenarios({"/dev/zero"}); });
  EXPECT_TRUE(holds(error, "/dev/zero: is larger than 1 MiB; expected a scenario")) << error;
}

TEST_F(FindScenarios, AreNarrowedByNamesAndAPatternThatMatchesNoneIsASlip) {
  for (const char* name : {"gap-020.yaml", "gap-070.yaml", "stairs.yaml"}) write(name, kScenario);
  const std::vector<ScenarioFile> all = findScenarios({folder_});
  const auto named = [&](const std::vector<std::string>& patterns) {
    std::string names;
    for (const ScenarioFile& file : scenariosNamed(all, patterns))
      names += scenarioName(file.file) + " ";
    return names;
  };
  EXPECT_EQ(named({}), "gap-020 gap-070 stairs ");
  EXPECT_EQ(named({"GAP-*"}), "gap-020 gap-070 ");
  EXPECT_EQ(named({"stairs", "gap-0?0", "gap-070"}), "gap-020 gap-070 stairs ") << "each once";
  EXPECT_EQ(named({"gap-07?"}), "gap-070 ");
  EXPECT_TRUE(holds(inputError([&] {
                      named({"gap-*", "stairz"});
                    }),
                    "stairz: matches no scenario's name; expected 'stairs'"));
  EXPECT_TRUE(holds(inputError([&] { named({"*kitchen*"}); }), "a pattern with * and ?"));
}

}  // namespace
}  // namespace amble
