#include "scenarios/kept_roadmaps.h"

#include "animation/library/motion_library_reader.h"
#include "planner/roadmap/roadmap_file.h"
#include "scenarios/run_scenario.h"
#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

class KeptRoadmaps : public SmallRoom {
 protected:
  void SetUp() override {
    SmallRoom::SetUp();
    write("mine.yaml", library());
    std::filesystem::copy_file(defaultLibrary().parent_path() / "default.bvh",
                               folder_ / "default.bvh");
  }
  static std::filesystem::path defaultLibrary() { return motionLibraryFile("default"); }
  static std::string library() { return read(defaultLibrary()); }

  Scenario scenario(const std::string& more = "") const {
    const std::string text =
        kScenario + (more.empty() ? "character: {library: mine.yaml}\n" : more);
    return readScenario(write("case.yaml", text));
  }
  // An empty roadmap, kept as one of the scenario as it is now.
  std::filesystem::path keepNow() const {
    KeptRoadmap roadmap;
    roadmap.max_failures = 1;
    roadmap.source = roadmapSource(Problem(scenario(), 1.0 / 60.0));
    writeRoadmap(roadmap, folder_ / "it.roadmap");
    return folder_ / "it.roadmap";
  }
  std::string errorOf(const Scenario& asked, double fps = 60.0) const {
    return inputError([&] { openRoadmap(folder_ / "it.roadmap", Problem(asked, 1.0 / fps)); });
  }
};

TEST_F(KeptRoadmaps, WhatHasChangedIsNamed) {
  keepNow();
  EXPECT_EQ(errorOf(scenario()), "no error");
  const std::string changed = "it.roadmap: is a stale roadmap, since these have changed: ";
  write("scene.yaml", std::string(kScene) +
                          "  - {name: rug, box: {size: [1, 1, 0.01]}, "
                          "at: [1, 1, 0.005]}\n");
  EXPECT_TRUE(holds(errorOf(scenario()), changed + "scene (scene.yaml)"));
  write("scene.yaml", kScene);
  write("mine.yaml", library() + "# another comment\n");
  EXPECT_TRUE(holds(errorOf(scenario()), changed + "library (mine.yaml)"));
  write("mine.yaml", library());
  EXPECT_TRUE(holds(errorOf(scenario("character: {library: mine.yaml, height: 1.5}\n")),
                    changed + "character (height 1.5, was 1.6"));
  EXPECT_TRUE(holds(errorOf(scenario("character: {library: mine.yaml, max_climb: 0.1}\n")),
                    changed + "character (max_climb 0.1, was 0.25)"));
  const std::string mine = "character: {library: mine.yaml}\n";
  EXPECT_TRUE(holds(errorOf(scenario(mine + "walk: {speed: 1, comfort: 0}\n")),
                    changed + "settings (comfort 0, was 0.05; speed 1, was 1.2)"));
  EXPECT_TRUE(holds(errorOf(scenario(mine + "bounds: {min: [0, 0], max: [6, 3]}\n")),
                    changed + "settings (bounds 0 0 6 3, was all)"));
  EXPECT_TRUE(holds(errorOf(scenario(), 30.0), changed + "settings (fps 30, was 60)"));
  EXPECT_TRUE(holds(errorOf(scenario("walk: {speed: 1}\n")), " and settings (speed 1, was 1.2)"));
}

TEST_F(KeptRoadmaps, StartGoalSeedAndFailuresMakeNoOther) {
  keepNow();
  Scenario other = scenario(
      "character: {library: mine.yaml}\nplanner: {seed: 9, max_failures: 3}\n"
      "walk: {to: walking}\nvia: [{at: [1, 1]}]\n");
  other.goal.at = {2, 2};
  EXPECT_EQ(errorOf(other), "no error");
}

TEST_F(KeptRoadmaps, AMeshOfTheSceneCounts) {
  write("box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("scene.yaml",
        std::string(kScene) + "  - {name: m, mesh: box.obj, up: z, at: [4, 1, 0.5]}\n");
  keepNow();
  EXPECT_EQ(errorOf(scenario()), "no error");
  write("box.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
  EXPECT_TRUE(holds(errorOf(scenario()), ": scene (box.obj)"));
}

// One that was made of the scene alone is that of every scenario with nothing of its own.
TEST_F(KeptRoadmaps, ASceneAloneIsThatOfTheDefaultCharacter) {
  const Problem alone(sceneAlone(folder_ / "scene.yaml"), 1.0 / 60.0);
  const RoadmapSource source = roadmapSource(alone);
  EXPECT_EQ(whatChanged(source, roadmapSource(Problem(readScenario(write("case.yaml", kScenario)),
                                                      1.0 / 60.0))),
            "");
}

class Queries : public SmallRoom {
 protected:
  static constexpr const char* kQueries =
      "scene: scene.yaml\n"
      "queries:\n"
      "  - {name: by-the-pillar, start: {at: [0.8, 1.5], heading: 0}, goal: {at: [5.2, 1.5], "
      "heading: 90}}\n"
      "  - {start: {at: [1, 1]}, goal: {at: [2.5, 0.8]}, via: [{at: [1.5, 2]}]}\n"
      "  - {name: into-it, start: {at: [1, 1]}, goal: {at: [3, 1.5]}}\n";

  struct Ran {
    std::string name, bvh;
    Report report;
  };
  std::vector<Ran> run(const std::string& text, const RunOptions& options = {}) const {
    std::vector<Ran> all;
    runQueries(readScenario(write("queries.yaml", text)), options,
               [&](const ScenarioQuery& query, const RunResult& result) {
                 all.push_back({query.name, result.bvh, result.report});
               });
    return all;
  }
};

TEST_F(Queries, EachHasItsOwnResultInOrder) {
  const std::vector<Ran> all = run(kQueries);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].name, "by-the-pillar");
  EXPECT_EQ(all[1].name, "2");
  EXPECT_EQ(all[0].report.scenario, "queries/by-the-pillar");
  EXPECT_EQ(all[0].report.status, PlanStatus::kSolved);
  EXPECT_EQ(all[1].report.status, PlanStatus::kSolved);
  EXPECT_EQ(all[2].report.status, PlanStatus::kGoalBlocked);
  EXPECT_LT(all[1].report.goal_position_error, 1e-6);
  EXPECT_TRUE(all[2].bvh.empty());
  EXPECT_GT(all[0].report.times.roadmap, 0.0);
  EXPECT_EQ(all[1].report.times.roadmap, 0.0);
}

TEST_F(Queries, OneAloneIsThePlanWithThatRoadmap) {
  const Scenario plain = readScenario(write("case.yaml", kScenario));
  const Problem problem(plain, 1.0 / 60.0);
  PlanRequest request = problem.request();
  request.limits.max_failures = Planner::kFailures;
  KeptRoadmap roadmap = Planner::grow(request);
  roadmap.source = roadmapSource(problem);
  writeRoadmap(roadmap, folder_ / "it.roadmap");
  RunOptions from_file;
  from_file.roadmap = folder_ / "it.roadmap";
  const RunResult kept = runScenario(plain, from_file);
  ASSERT_EQ(kept.report.status, PlanStatus::kSolved);
  EXPECT_TRUE(kept.report.inputs.contains("it.roadmap"));
  for (const RunOptions& options : {RunOptions{}, from_file}) {
    const std::vector<Ran> all = run(kQueries, options);
    EXPECT_EQ(all.front().bvh, kept.bvh);
    EXPECT_EQ(all.front().report.poses_checked, kept.report.poses_checked);
  }
}

TEST_F(Queries, AWrongPlaceIsNamedWithItsLineBeforeAnyIsRun) {
  int visits = 0;
  const std::string text =
      std::string(kQueries) + "  - start: {at: [1, 1]}\n    goal: {at: [9, 9]}\n";
  const std::string error = inputError([&] {
    runQueries(readScenario(write("queries.yaml", text)), {},
               [&](const ScenarioQuery&, const RunResult&) { ++visits; });
  });
  EXPECT_TRUE(holds(error, "queries.yaml:7: 'queries[3].goal.at' has no floor")) << error;
  EXPECT_EQ(visits, 0);
}

TEST_F(Queries, WhatIsUnknownDoubledOrBesideThemIsRefusedWithItsLine) {
  const auto errorOf = [&](const std::string& more) {
    return inputError([&] { readScenario(write("queries.yaml", "scene: scene.yaml\n" + more)); });
  };
  const std::string ends = "start: {at: [1, 1]}, goal: {at: [2, 1]}";
  EXPECT_TRUE(holds(errorOf("queries: []\n"), "queries.yaml:2: 'queries' asks for nothing"));
  EXPECT_TRUE(holds(errorOf("queries:\n  - {start: {at: [1, 1]}}\n"), ":3: "));
  EXPECT_TRUE(holds(errorOf("queries:\n  - {" + ends + ", heading: 3}\n"), ":3: unknown key"));
  EXPECT_TRUE(holds(errorOf("queries:\n  - {name: a, " + ends + "}\n  - {name: A, " + ends + "}\n"),
                    ":4: the name 'A' is that of the query on line 3 too"));
  EXPECT_TRUE(holds(errorOf("queries:\n  - {name: 2, " + ends + "}\n  - {" + ends + "}\n"),
                    ":4: the name '2'"));
  for (const char* name : {"../up", "a/b", ".", ".hidden", "a b"})
    EXPECT_TRUE(holds(errorOf(std::string("queries:\n  - {name: ") + name + ", " + ends + "}\n"),
                      ":3: '" + std::string(name) + "' is no name for a folder"))
        << name;
  const std::string one = "queries: [{" + ends + "}]\n";
  EXPECT_TRUE(holds(errorOf(one + "goal: {at: [1, 1]}\n"), ":3: 'goal' beside 'queries'"));
  EXPECT_TRUE(holds(errorOf(one + "expect: {bvh_sha256: " + std::string(64, '0') + "}\n"),
                    ":3: 'expect.bvh_sha256' beside 'queries'"));
}

}  // namespace
}  // namespace amble
