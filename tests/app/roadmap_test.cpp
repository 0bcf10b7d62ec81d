// amble roadmap build|show, plan --roadmap and a scenario's queries, as a shell runs them.

#include "test_paths.h"
#include "tests/app/options.h"

namespace amble {
namespace {

using nlohmann::json;

class RoadmapCommand : public Options {
 protected:
  json shown(const std::string& file) const { return printed("roadmap show --json " + file); }
  const std::string kBuild = "roadmap build in/scenario.yaml ";
};

TEST_F(RoadmapCommand, BuildsWhatPlanThenAsks) {
  const Ran built = good(kBuild + "-o it.roadmap --m 5");
  EXPECT_TRUE(built.out.starts_with("it.roadmap: ")) << built.out;
  const Ran told = good("roadmap show it.roadmap");
  for (const char* part : {"guards", "grown ", "extent ", "scene      room.yaml", "library ",
                           "max_climb 0.25", "speed 1.2"})
    EXPECT_NE(told.out.find(part), std::string::npos) << part << '\n' << told.out;
  const json report = printed("plan in/scenario.yaml -o out --json --roadmap it.roadmap");
  EXPECT_EQ(report["status"], "solved");
  EXPECT_EQ(report["roadmap"]["guards"], shown("it.roadmap")["guards"]);
  EXPECT_EQ(report["times"]["roadmap"], 0.0);
}

TEST_F(RoadmapCommand, OfASceneAloneIsThatOfItsScenario) {
  good("roadmap build in/room.yaml -o scene.roadmap --m 3");
  good("plan in/scenario.yaml -o out --formats json --roadmap scene.roadmap");
}

TEST_F(RoadmapCommand, WhatIsStaleOrDamagedIsOneLineAndNothingIsWritten) {
  good(kBuild + "-o it.roadmap --m 3");
  const std::string plan = "plan in/scenario.yaml -o new --roadmap it.roadmap";
  const std::string whole = read("it.roadmap"), room = read("in/room.yaml");
  write("in/room.yaml",
        room + "  - {name: post, box: {size: [0.1, 0.1, 1]}, at: [5.8, 3.8, 0.5]}\n");
  expectRefused(plan, {"it.roadmap: ", "have changed: scene (room.yaml)"});
  write("in/room.yaml", room);
  write("it.roadmap", whole.substr(0, whole.size() / 2));
  expectRefused(plan, {"it.roadmap: is a damaged roadmap"});
  expectRefused("roadmap show it.roadmap", {"it.roadmap: is a damaged roadmap"});
  write("it.roadmap", "");
  expectRefused("roadmap show it.roadmap", {"it.roadmap: is no roadmap"});
  expectRefused("roadmap show /dev/zero", {"/dev/zero: is larger than 256 MiB"});
  expectRefused("roadmap build in/scenario.yaml -o in/room.yaml", {"in/room.yaml"});
}

TEST_F(RoadmapCommand, IsNeverWrittenOverWhatItIsMadeOf) {
  const std::string motions = std::string(AMBLE_SOURCE_DIR) + "/animation/motions/default";
  write("in/mine.yaml", read(motions + ".yaml"));
  write("in/default.bvh", read(motions + ".bvh"));
  write("in/walk.yaml", kScenario + "character: {library: mine.yaml}\n");
  for (const std::string input :
       {"in/walk.yaml", "in/room.yaml", "in/mine.yaml", "in/default.bvh"}) {
    const std::string before = read(input);
    expectRefused("roadmap build in/walk.yaml --m 1 -o " + input, {"is read too"});
    EXPECT_EQ(read(input), before) << input;
  }
}

TEST_F(RoadmapCommand, OptionsOfBuild) {
  expectEach(
      "roadmap build",
      {{"--output", [this] { expectRefused("roadmap build in/scenario.yaml", {"--output"}); }},
       {"--seed",
        [this] {
          good(kBuild + "-o a.roadmap --m 3 --seed 4");
          good(kBuild + "-o b.roadmap --m 3");
          EXPECT_EQ(shown("a.roadmap")["seed"], 4);
          EXPECT_NE(shown("a.roadmap")["nodes"], shown("b.roadmap")["nodes"]);
        }},
       {"--m",
        [this] {
          good(kBuild + "-o a.roadmap --m 7");
          EXPECT_EQ(shown("a.roadmap")["max_failures"], 7);
          EXPECT_NEAR(shown("a.roadmap")["coverage"].get<double>(), 1.0 - 1.0 / 7.0, 1e-12);
        }},
       {"--threads",
        [this] {
          good(kBuild + "-o a.roadmap --m 5 --threads 1");
          good(kBuild + "-o b.roadmap --m 5 --threads 3");
          EXPECT_EQ(read("a.roadmap"), read("b.roadmap"));
        }},
       {"--time-limit",
        [this] {
          EXPECT_EQ(run(kBuild + "-o late.roadmap --m 100000 --time-limit 0.3").status, 1);
          EXPECT_FALSE(files().contains("late.roadmap"));
        }},
       {"--fps",
        [this] {
          good(kBuild + "-o a.roadmap --m 2 --fps 30");
          EXPECT_EQ(shown("a.roadmap")["source"]["settings"]["values"]["fps"], "30");
        }},
       {"--memory",
        [this] { expectMemoryBounds("roadmap build in/of-mesh.yaml -o a.roadmap --m 1"); }}});
}

TEST_F(RoadmapCommand, OptionsOfShow) {
  good(kBuild + "-o it.roadmap --m 2");
  expectEach("roadmap show",
             {{"--json", [this] {
                 const json map = shown("it.roadmap");
                 EXPECT_EQ(map["nodes"].size(),
                           map["guards"].get<size_t>() + map["connectors"].get<size_t>());
                 for (const char* part : {"scene", "library", "character", "settings"})
                   EXPECT_EQ(map["source"][part]["sha256"].get<std::string>().size(), 64u);
               }}});
}

class QueriesCommand : public RoadmapCommand {
 protected:
  void SetUp() override {
    RoadmapCommand::SetUp();
    write("in/queries.yaml",
          "scene: room.yaml\nqueries:\n"
          "  - {name: there, start: {at: [1, 2], heading: 0}, goal: {at: [3, 2], heading: 0}}\n"
          "  - {start: {at: [3, 2]}, goal: {at: [1, 2]}}\n");
  }
};

TEST_F(QueriesCommand, EachHasAFolderAndALineOfTheTable) {
  const Ran ran = good("plan in/queries.yaml -o out --formats bvh,json");
  const std::set<std::string> all = files();
  for (const char* file :
       {"out/there/walk.bvh", "out/there/report.json", "out/2/walk.bvh", "out/2/report.json"})
    EXPECT_TRUE(all.contains(file)) << file;
  for (const char* part : {"query ", "there ", "\n2 ", "solved", "written to out\n"})
    EXPECT_NE(ran.out.find(part), std::string::npos) << part << '\n' << ran.out;
  const json reports = printed("plan in/queries.yaml -o out --formats json --json");
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[1]["scenario"], "queries/2");
}

TEST_F(QueriesCommand, AFolderThatCannotBeMadeIsSeenBeforeThePlanning) {
  write("out/2", "a file");
  expectRefused("plan in/queries.yaml -o out --formats json", {"out/2", "is no folder"});
}

TEST_F(QueriesCommand, OneWithoutAWalkIsTheExitStatus) {
  write("in/queries.yaml",
        read("in/queries.yaml") + "  - {name: post, start: {at: [1, 2]}, goal: {at: [5, 2]}}\n");
  write("in/room.yaml", kRoom + "  - {name: block, box: {size: [0.6, 0.6, 2]}, at: [5, 2, 1]}\n");
  const Ran ran = good("plan in/queries.yaml -o out --formats bvh,json", 1);
  EXPECT_NE(ran.out.find("goal_blocked"), std::string::npos) << ran.out;
  EXPECT_TRUE(files().contains("out/there/walk.bvh"));
  EXPECT_FALSE(files().contains("out/post/walk.bvh"));
}

TEST_F(QueriesCommand, CheckHasARowForEach) {
  write("in/queries.yaml", read("in/queries.yaml") + "expect: {status: solved}\n");
  const Ran ran = good("check in/queries.yaml");
  for (const char* part : {"queries/there", "queries/2", "2 scenarios: 2 as expected"})
    EXPECT_NE(ran.out.find(part), std::string::npos) << part << '\n' << ran.out;
}

}  // namespace
}  // namespace amble
