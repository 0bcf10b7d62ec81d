// The commands on good input: exit status, files, what is printed for machines.

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Commands : public InRoom {
 protected:
  void SetUp() override {
    InRoom::SetUp();
    write("in/room.yaml",
          kRoom + "  - {name: pillar, cylinder: {radius: 0.3, height: 2.5}, at: [3, 2, 1.25]}\n");
    write("in/scenario.yaml", kScenario +
                                  "planner: {seed: 3, max_failures: 30}\n"
                                  "expect: {status: solved}\n");
  }
};

TEST_F(Commands, HelpAndVersionAreNoErrors) {
  EXPECT_EQ(run("--help").status, 0);
  const Ran version = run("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_TRUE(std::regex_match(version.out, std::regex("[0-9]+\\.[0-9]+\\.[0-9]+\n")));
  for (const char* command : {"plan", "check", "validate", "animate", "analyse", "library", "edit",
                              "convert", "graft", "inspect", "roadmap", "graph", "view"}) {
    EXPECT_EQ(run(std::string(command) + " --help").status, 0) << command;
  }
}

TEST_F(Commands, PlanWritesAWalkWithItsReportAndPictures) {
  const Ran ran = run("plan in/scenario.yaml -o out");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(files(), (std::set<std::string>{"in/room.yaml", "in/scenario.yaml", "out/report.html",
                                            "out/report.json", "out/top.svg", "out/walk.bvh",
                                            "out/walk.html", "out/walk.png"}));
  const json report = json::parse(read("out/report.json"));
  EXPECT_EQ(report["status"], "solved");
  EXPECT_GT(report["length"], 4.0);
  EXPECT_EQ(read("out/walk.bvh").rfind("HIERARCHY", 0), 0u);
  EXPECT_EQ(run("validate out/walk.bvh --scene in/room.yaml --fps 240").status, 0);
  EXPECT_EQ(run("inspect out/walk.bvh").status, 0);
  EXPECT_EQ(run("analyse out/walk.bvh").status, 0);
}

TEST_F(Commands, PlanGivesTheSameBytesAtAnyNumberOfThreads) {
  ASSERT_EQ(run("plan in/scenario.yaml -o one --threads 1 --formats bvh,json").status, 0);
  ASSERT_EQ(run("plan in/scenario.yaml -o two --threads 2 --formats bvh,json").status, 0);
  EXPECT_EQ(read("one/walk.bvh"), read("two/walk.bvh"));
  json one = json::parse(read("one/report.json")), two = json::parse(read("two/report.json"));
  one.erase("times");
  two.erase("times");
  EXPECT_EQ(one, two);
}

TEST_F(Commands, WithoutAWalkTheFilesOfOneThatWereAskedForAreNamedAsMissing) {
  wallOff();
  const Ran ran = run("plan in/scenario.yaml -o out --formats glb,png,json");
  EXPECT_EQ(ran.status, 1);
  EXPECT_TRUE(ran.err.ends_with("amble plan: without a walk there is no walk.glb\n")) << ran.err;
  const Ran other = run("plan in/scenario.yaml -o out --formats json,svg");
  EXPECT_EQ(other.err.find("without a walk"), std::string::npos) << other.err;
}

TEST_F(Commands, AGoalThatIsTheStartTakesNoStep) {
  write("in/scenario.yaml", "scene: room.yaml\nstart: {at: [1, 1]}\ngoal: {at: [1, 1]}\n");
  const Ran ran = run("plan in/scenario.yaml -o out --formats json");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find(" 0 steps"), std::string::npos) << ran.out;
  EXPECT_EQ(json::parse(read("out/report.json"))["steps"].size(), 0u);
}

TEST_F(Commands, NoPlanOrCheckWritesOverWhatItReads) {
  std::filesystem::create_symlink("../in/room.yaml", folder_ / "in/link.xml");
  expectRefused("check in/scenario.yaml --junit in/scenario.yaml", {"is read too"});
  expectRefused("check in/scenario.yaml --junit in/link.xml", {"in/link.xml", "is read too"});
  std::filesystem::create_directories(folder_ / "out");
  std::filesystem::create_symlink("../in/room.yaml", folder_ / "out/walk.bvh");
  expectRefused("plan in/scenario.yaml -o out", {"out/walk.bvh", "is read too"});
}

TEST_F(Commands, PlanSaysWhyThereIsNoWalk) {
  wallOff();
  const Ran ran = run("plan in/scenario.yaml -o out --json");
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_FALSE(fs::exists(folder_ / "out/walk.bvh"));
  const json report = json::parse(read("out/report.json"));
  EXPECT_EQ(report["status"], "no_walk");
  EXPECT_NE(report["why"].get<std::string>().find("wall"), std::string::npos) << report["why"];
  EXPECT_EQ(json::parse(ran.out)["status"], "no_walk");
}

TEST_F(Commands, PlanExplainsItsPlanners) {
  const Ran ran = run("plan --list-planners");
  EXPECT_EQ(ran.status, 0);
  for (const char* planner : {"visibility", "prm", "rrt", "cylinder"}) {
    EXPECT_NE(ran.out.find(planner), std::string::npos) << planner;
  }
}

TEST_F(Commands, PlanStopsWhenToldTo) {
  makeEndless();
  const Ran ran = run("plan in/scenario.yaml -o out & pid=$!; sleep 1; kill -TERM $pid; wait $pid");
  EXPECT_EQ(ran.status, 130) << ran.err;
  for (const std::string& file : files()) EXPECT_EQ(file.find(".part"), std::string::npos) << file;
}

TEST_F(Commands, CheckComparesWithWhatIsExpected) {
  const Ran good = run("check in --junit junit.xml");
  EXPECT_EQ(good.status, 0) << good.out << good.err;
  EXPECT_NE(good.out.find("scenario"), std::string::npos);
  EXPECT_NE(read("junit.xml").find("<testsuite"), std::string::npos);
  wallOff();
  EXPECT_EQ(run("check in").status, 1);
}

TEST_F(Commands, ValidateFindsTheContactOfAWalkThroughAWall) {
  ASSERT_EQ(run("plan in/scenario.yaml -o out --formats bvh").status, 0);
  wallOff();
  const Ran ran = run("validate out/walk.bvh --scene in/room.yaml --json");
  EXPECT_EQ(ran.status, 1) << ran.err;
  const json result = json::parse(ran.out);
  ASSERT_FALSE(result["contacts"].empty());
  EXPECT_EQ(result["contacts"][0]["object"], "wall");
}

TEST_F(Commands, AnimateWritesToStandardOutput) {
  const Ran ran = run("animate --speed 1.1 --turn -20 --duration 3 -o -");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out.rfind("HIERARCHY", 0), 0u);
  EXPECT_EQ(files().size(), 2u);
}

TEST_F(Commands, AnimateShowsStrideLiftInclineAndStairsEach) {
  for (const char* options :
       {"--stride 0.5..0.75", "--lift 0.08..0.15", "--incline -12", "--incline 0..15",
        "--stairs .17,.29", "--stairs -.17,.29", "--incline 8 --lift 0.1"}) {
    const Ran ran = run(std::string("animate --duration 7 -o a.bvh --quality ") + options);
    EXPECT_EQ(ran.status, 0) << options << "\n" << ran.out << ran.err;
  }
}

TEST_F(Commands, AnimateSaysWhichRuleRefused) {
  const Ran steep = run("animate --incline 30 -o a.bvh");
  EXPECT_EQ(steep.status, 1);
  EXPECT_NE(steep.err.find("slope refused"), std::string::npos) << steep.err;
  // A ramp that gets too steep on its way is not walked as far as it is not.
  for (const char* ramp : {"0..25", "10..25", "-25..0", "25..0"}) {
    const Ran ran = run(std::string("animate --duration 6 -o b.bvh --incline ") + ramp);
    EXPECT_EQ(ran.status, 1) << ramp;
    EXPECT_NE(ran.err.find("at most 20 degrees steep"), std::string::npos) << ran.err;
  }
  EXPECT_EQ(files().count("b.bvh"), 0u);
  EXPECT_EQ(run("animate --duration 6 -o c.bvh --incline 0..20").status, 0);
  EXPECT_EQ(run("animate --stairs .4,.29 -o a.bvh").status, 1);
}

TEST_F(Commands, InspectSaysSizesForMachines) {
  const Ran ran = run("inspect in/room.yaml in/scenario.yaml --json");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const json all = json::parse(ran.out);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0]["kind"], "scene");
  EXPECT_EQ(all[0]["objects"].size(), 2u);
  EXPECT_DOUBLE_EQ(all[0]["bounds"]["max"][0], 6.0);
  EXPECT_EQ(all[1]["kind"], "scenario");
}

TEST_F(Commands, NamesOfAnyBytesSteerNoTerminal) {
  // Escape sequences in an object's name, a scenario's and a joint's.
  write("in/room.yaml", kRoom +
                            "  - {name: \"w\\x01\\x1b[31m\\x7f\", box: {size: [1, 1, 1]}, "
                            "at: [1, 2, 0.5]}\n");
  const std::string name = "in/esc\x1b[31m\tx.yaml";
  write(name, kScenario + "expect: {status: solved}\n");
  ASSERT_EQ(run("animate --duration 2 -o walk.bvh").status, 0);
  std::string walk = read("walk.bvh");
  for (size_t at = walk.find("LeftHand"); at != walk.npos; at = walk.find("LeftHand", at + 1))
    walk.replace(at, 8, "Left\x1bHand");
  write("walk.bvh", walk);
  int blocked = 0;
  for (const std::string& command : std::vector<std::string>{
           "plan '" + name + "' -o out", "check in", "inspect '" + name + "'",
           "inspect in/room.yaml walk.bvh", "analyse walk.bvh",
           "validate walk.bvh --scene in/room.yaml", "convert walk.bvh -o 'out\x1b.bvh'"}) {
    const Ran ran = run(command);
    const std::string said = ran.out + ran.err;
    EXPECT_FALSE(said.empty()) << command;
    blocked += said.find("start_blocked") != said.npos;
    for (const char c : said)
      EXPECT_TRUE(c == '\n' || (c >= ' ' && c != '\x7f')) << command << said;
  }
  EXPECT_EQ(blocked, 2) << "plan and check name what stands there";
}

}  // namespace
}  // namespace amble
