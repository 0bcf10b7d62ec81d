// Standard streams in place of files, and what does not go together.

#include <csignal>

#include "tests/app/options.h"

namespace amble {
namespace {

class Pipes : public Options {
 protected:
  void SetUp() override {
    Options::SetUp();
    write("in/floor.yaml",
          "name: floor\nobjects:\n  - {name: floor, box: {size: [4, 3, 0.1]}, at: [2, 1.5, "
          "-0.05]}\n");
    write("in/short.yaml",
          "scene: floor.yaml\nstart: {at: [1, 1.5], heading: 0}\ngoal: {at: [2.5, 1.5], heading: "
          "0}\n");
  }
};

TEST_F(Pipes, AScenarioOfStandardInputIsPlannedAsThatOfItsFile) {
  good("plan in/short.yaml -o file --formats bvh");
  const Ran ran = shell("cd in && \"$AMBLE\" plan - -o ../pipe --formats bvh < short.yaml");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(read("pipe/walk.bvh"), read("file/walk.bvh"));
}

TEST_F(Pipes, WhatIsPrintedForMachinesIsOnStandardOutputAndNothingElseIs) {
  for (const char* command : {"plan in/short.yaml -o out --json", "inspect in/floor.yaml --json",
                              "inspect in/short.yaml --json"}) {
    const Ran ran = good(command);
    EXPECT_TRUE(nlohmann::json::accept(ran.out)) << command << ran.out;
  }
}

TEST_F(Pipes, WhoReadsNoFurtherMakesNoNoise) {
  const Ran ran = shell("\"$AMBLE\" plan --help | head -1; \"$AMBLE\" help animate | head -1");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 2);
}

TEST_F(Pipes, AWalkGoesThroughConversionAndBackUnchangedFromMetresToCentimetres) {
  good("animate --duration 2 -o walk.bvh");
  good("convert walk.bvh -o cm.bvh --bvh-units cm");
  good("convert cm.bvh -o back.bvh --unit 0.01 --bvh-units m");
  std::istringstream before(read("walk.bvh")), after(read("back.bvh"));
  std::string a, b;
  int numbers = 0;
  while (before >> a && after >> b) {
    char* end = nullptr;
    const double number = std::strtod(a.c_str(), &end);
    if (*end != '\0') continue;
    EXPECT_NEAR(std::stod(b), number, 2e-4);
    ++numbers;
  }
  EXPECT_GT(numbers, 1000);
}

TEST_F(Pipes, OptionsThatContradictEachOtherAreRefusedByBothNames) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> pairs = {
      {"animate -o w.bvh --stairs 0.17,0.3 --incline 5", {"--", "incline"}},
      {"animate -o w.bvh --stairs 0.17,0.3 --turn 5", {"--", "turn"}},
      {"edit in/none.bvh -o w.bvh --stairs 0.17,0.3 --stride 0.7", {"--", "str"}},
      {"edit in/none.bvh -o w.bvh --arrive 1,1 --stride 0.7", {"--", "stride"}}};
  for (const auto& [command, parts] : pairs) expectRefused(command, parts);
}

TEST_F(Pipes, AnOptionGivenTwiceOrTwoInputsForOneAreRefused) {
  expectRefused("plan in/short.yaml --seed 1 --seed 2", {"--seed"});
  expectRefused("plan in/short.yaml in/short.yaml", {"amble plan"});
  expectRefused("inspect", {"amble inspect"});
}

TEST_F(Pipes, AnOutputInAFolderThatIsAFileIsRefusedAndLeavesTheFile) {
  write("taken", "mine");
  for (const char* command : {"plan in/short.yaml -o taken", "plan in/short.yaml -o taken/below",
                              "animate --duration 2 -o taken/walk.bvh"}) {
    expectRefused(command, {"taken"});
    EXPECT_EQ(read("taken"), "mine");
  }
}

TEST_F(Pipes, AnotherSeedIsAnotherSearchAndTheSameSeedTheSameBytes) {
  const auto made = [&](const std::string& how, const std::string& out) {
    good("plan in/short.yaml --formats bvh -o " + out + " " + how);
    return read(out + "/walk.bvh");
  };
  const std::string one = made("--seed 7", "a");
  EXPECT_EQ(made("--seed 7 --threads 4", "b"), one);
  EXPECT_EQ(made("--seed 7 --checker fcl", "c"), one) << "they agree";
}

// What a status says: found, none, wrong.
TEST_F(Pipes, ExitStatusesAreThoseOfTheHelp) {
  EXPECT_EQ(run("plan in/short.yaml -o a").status, 0);
  write("in/shut.yaml",
        read("in/floor.yaml") +
            "  - {name: wall, box: {size: [0.1, 3.4, 2.5]}, at: [1.8, 1.5, 1.25]}\n");
  write(
      "in/none.yaml",
      "scene: shut.yaml\nstart: {at: [1, 1.5], heading: 0}\ngoal: {at: [2.5, 1.5], heading: 0}\n");
  const Ran none = run("plan in/none.yaml -o b");
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.out.find("wall shuts the way off"), std::string::npos) << none.out;
  EXPECT_EQ(run("plan in/no-such.yaml -o c").status, 2);
  EXPECT_FALSE(files().contains("b/walk.bvh"));
}

}  // namespace
}  // namespace amble
