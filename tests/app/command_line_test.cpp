// How the command line is read and what the program does with its standard streams.

#include <fstream>
#include <sstream>

#include "test_paths.h"
#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

class CommandLine : public InRoom {
 protected:
  void SetUp() override {
    InRoom::SetUp();
    write("in/scenario.yaml", kScenario + "planner: {seed: 3, max_failures: 30}\n");
  }
};

TEST_F(CommandLine, AMistypedCommandIsNamedWithTheNearest) {
  expectRefused("plna in/scenario.yaml", {"no command 'plna'", "; expected 'plan'"});
  expectRefused("library shwo", {"amble library: ", "'shwo'", "; expected 'show'"});
  expectRefused("frobnicate", {"'frobnicate'", "; expected one of plan, check, validate"});
  expectRefused("", {"amble: no command; expected one of plan, check"});
  expectRefused("library", {"amble library: no command; expected one of build, show"});
}

TEST_F(CommandLine, AMistypedChoiceIsNamedWithTheNearest) {
  expectRefused("plan in/scenario.yaml --formats bvhh",
                {"--formats", "'bvhh'", "; expected 'bvh'"});
  expectRefused("plan in/scenario.yaml --bvh-units feet", {"'feet'", "; expected one of m, cm"});
  expectRefused("completion zhs", {"amble completion", "'zhs'", "; expected 'zsh'"});
  expectRefused("help libary", {"amble: ", "'libary'", "; expected 'library'"});
  expectRefused("help library shwo", {"amble library: ", "'shwo'", "; expected 'show'"});
}

TEST_F(CommandLine, AMistypedOptionIsNamedWithTheNearest) {
  expectRefused("plan --sede 3 in/scenario.yaml", {"amble plan: ", "'--sede'", "'--seed'"});
  expectRefused("plan in/scenario.yaml --sede=3", {"amble plan: ", "'--sede'", "'--seed'"});
  expectRefused("library show --jsn", {"amble library show: ", "'--jsn'", "'--json'"});
  expectRefused("--versoin", {"amble: ", "'--versoin'", "'--version'"});
  expectRefused("check in --zzzzzzzz", {"'--zzzzzzzz'; expected one that amble check --help"});
  expectRefused("plan in/scenario.yaml other.yaml", {"'other.yaml' is one too many; expected"});
}

TEST_F(CommandLine, AnOptionWithAListLeavesTheFilesAlone) {
  const Ran ran = run("plan -o out --formats json,bvh in/scenario.yaml");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(files(), (std::set<std::string>{"in/room.yaml", "in/scenario.yaml", "out/report.json",
                                            "out/walk.bvh"}));
}

TEST_F(CommandLine, APlannerThatIsMistypedIsNoLineOfTheFile) {
  expectRefused("plan in/scenario.yaml -o out --planner visibilty",
                {"scenario.yaml: ", "'visibilty'; expected 'visibility'"});
}

TEST_F(CommandLine, AScenarioMayComeByAPipe) {
  write("scenario.yaml", "scene: in/room.yaml\n" + kScenario.substr(kScenario.find("start")));
  const Ran piped = run("plan - -o out --formats json < scenario.yaml");
  EXPECT_EQ(piped.status, 0) << piped.err;
  EXPECT_EQ(run("check - < scenario.yaml").status, 0);
  ASSERT_EQ(run("inspect in/scenario.yaml", "mkfifo in/pipe.yaml;").status, 0);
  const Ran named =
      run("plan in/pipe.yaml -o out2 --formats json & cat in/scenario.yaml "
          ">in/pipe.yaml; wait $!");
  EXPECT_EQ(named.status, 0) << named.err;
  const Ran inspected = run("inspect in/pipe.yaml & cat in/scenario.yaml >in/pipe.yaml; wait $!");
  EXPECT_EQ(inspected.status, 0) << inspected.err;
}

TEST_F(CommandLine, APipeThatNobodyWritesToIsOneLine) {
  ASSERT_EQ(shell("mkfifo in/pipe").status, 0);
  expectRefused("plan in/scenario.yaml -o out --roadmap in/pipe",
                {"pipe: nobody writes to the pipe; expected a writer"});
}

TEST_F(CommandLine, WhatNeverEndsIsRefusedBeforeItFillsTheMachine) {
  const std::string bounded = "ulimit -v 4000000;";  // [KiB]
  expectRefused("plan /dev/zero -o out", {"/dev/zero: is larger than 1 MiB; expected"}, bounded);
  expectRefused("plan - -o out </dev/zero", {"-: is larger than 1 MiB; expected"}, bounded);
  write("in/endless.yaml", "scene: /dev/zero\nstart: {at: [1, 1]}\ngoal: {at: [2, 1]}\n");
  expectRefused("plan in/endless.yaml -o out", {"/dev/zero: ", "; expected"}, bounded);
  write("in/library.yaml", kScenario + "character: {library: /dev/zero}\n");
  expectRefused("plan in/library.yaml -o out", {"/dev/zero: ", "; expected"}, bounded);
}

TEST_F(CommandLine, AClosedOrFullStandardErrorLosesNothingElse) {
  const Ran closed = run("plan in/scenario.yaml -o out 2>&-");
  EXPECT_EQ(closed.status, 0);
  EXPECT_EQ(read("out/walk.bvh").rfind("HIERARCHY", 0), 0u);
  EXPECT_EQ(run("plan none.yaml 2>/dev/full").status, 2);
  EXPECT_EQ(run("library add in/mine.yaml out/walk.bvh 2>/dev/full").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "in/mine.yaml"));
  write("in/broken.yaml", "scene: none.yaml\nstart: {at: [1, 1]}\ngoal: {at: [2, 1]}\n");
  const Ran check = run("check in/scenario.yaml in/broken.yaml 2>/dev/full");
  EXPECT_EQ(check.status, 2);
  EXPECT_NE(check.out.find("2 scenarios: 1 as expected"), std::string::npos) << check.out;
}

TEST_F(CommandLine, AClosedStandardOutputIsNoSuccess) {
  const Ran ran = run("inspect in/room.yaml >&-");
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("cannot be written"), std::string::npos) << ran.err;
}

// Each command's examples in one folder, in the order of the help: what one makes the next may use.
TEST_F(CommandLine, TheExamplesOfTheHelpWork) {
  for (const char* folder : {"scenarios", "environments", "animation"}) {
    fs::create_directory_symlink(fs::path(AMBLE_SOURCE_DIR) / folder, folder_ / folder);
  }
  for (const char* made :
       {"animate --speed 0.8 -o in/slow.bvh", "animate --speed 1.5 -o in/quick.bvh",
        "library engine build in/slow.bvh in/quick.bvh -o anna.yaml"})
    ASSERT_EQ(run(made).status, 0) << made;
  for (const char* command : {"", "plan", "check", "validate", "animate", "inspect",
                              "roadmap build", "help", "completion"}) {
    std::istringstream help(run(std::string(command) + " --help").out);
    int examples = 0;
    for (std::string line; std::getline(help, line);) {
      const std::string prompt = "  amble ";
      if (line.rfind(prompt, 0) != 0) continue;
      const Ran ran = run(line.substr(prompt.size()));
      EXPECT_EQ(ran.status, 0) << line << '\n' << ran.err;
      ++examples;
    }
    EXPECT_GE(examples, 2) << command;
  }
}

}  // namespace
}  // namespace amble
