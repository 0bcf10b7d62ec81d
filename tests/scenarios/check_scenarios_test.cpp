#include "scenarios/check_scenarios.h"

#include <thread>

#include "base/sha256.h"
#include "scenarios/find_scenarios.h"
#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

class CheckScenarios : public SmallRoom {
 protected:
  CheckRow checkOne(const std::string& text, const CheckOptions& options = {}) const {
    return checkScenarios(findScenarios({write("case.yaml", text)}), options).at(0);
  }
};

TEST_F(CheckScenarios, ABrokenScenarioIsAnErrorAndDoesNotStopTheOthers) {
  write("a.yaml", "scene: scene.yaml\nstart: {at: [1]}\ngoal: {at: [1, 1]}\n");
  write("b.yaml", std::string(kScenario) + "expect: {status: solved}\n");
  const std::vector<CheckRow> rows = checkScenarios(findScenarios({folder_}), {});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].verdict, CheckVerdict::kError);
  EXPECT_TRUE(holds(rows[0].notes.at(0), "a.yaml:2:"));
  EXPECT_EQ(rows[1].verdict, CheckVerdict::kHolds);
  EXPECT_FALSE(allHold(rows));
}

TEST_F(CheckScenarios, WhatIsNotAsExpectedIsSaid) {
  Report report;
  report.status = PlanStatus::kSolved;
  report.length = 5.0;
  report.clearance.min = 0.01;
  report.foot_skate_max = 0.003;
  report.times.roadmap = 4.0;
  RunResult result;
  result.report = report;
  result.bvh = "a walk";
  const auto differ = [&](auto set, bool judge_times = false) {
    Expectation expect;
    set(expect);
    return differences(expect, result, judge_times).size();
  };
  EXPECT_EQ(differ([](Expectation&) {}), 0u);
  EXPECT_EQ(differ([](Expectation& e) { e.status = PlanStatus::kSolved; }), 0u);
  EXPECT_EQ(differ([](Expectation& e) { e.status = PlanStatus::kNoWalk; }), 1u);
  EXPECT_EQ(differ([](Expectation& e) { e.max_length = 5.0; }), 0u);
  EXPECT_EQ(differ([](Expectation& e) { e.max_length = 4.99; }), 1u);
  EXPECT_EQ(differ([](Expectation& e) { e.min_clearance = 0.01; }), 0u);
  EXPECT_EQ(differ([](Expectation& e) { e.min_clearance = 0.02; }), 1u);
  EXPECT_EQ(differ([](Expectation& e) { e.max_foot_skate = 0.003; }), 0u);
  EXPECT_EQ(differ([](Expectation& e) { e.max_foot_skate = 0.002; }), 1u);
  EXPECT_EQ(differ([](Expectation& e) { e.max_planning_time = 3.0; }), 0u);
  EXPECT_EQ(differ([](Expectation& e) { e.max_planning_time = 3.0; }, true), 1u);
  EXPECT_EQ(differ([](Expectation& e) { e.bvh_sha256 = sha256("a walk"); }), 0u);
  EXPECT_EQ(differ([](Expectation& e) { e.bvh_sha256 = sha256("another"); }), 1u);
}

TEST_F(CheckScenarios, UpdateWritesTheDigestThatTheNextCheckCompares) {
  const std::string text = std::string(kScenario) + "expect:  # of the room\n  status: solved\n";
  CheckOptions update;
  update.update = true;
  const CheckRow row = checkOne(text, update);
  EXPECT_EQ(row.verdict, CheckVerdict::kHolds);
  EXPECT_TRUE(row.updated);
  const std::string updated = read(folder_ / "case.yaml");
  EXPECT_EQ(updated.substr(0, text.size()), text);
  EXPECT_EQ(checkScenarios(findScenarios({folder_ / "case.yaml"}), {}).at(0).verdict,
            CheckVerdict::kHolds);
  const CheckRow differs = checkOne(text + "  bvh_sha256: " + std::string(64, '0') + "\n");
  EXPECT_EQ(differs.verdict, CheckVerdict::kDiffers);
  EXPECT_TRUE(holds(differs.notes.at(0), "SHA-256"));
}

TEST_F(CheckScenarios, AnUpdateTakesFinishedRunsOnly) {
  // A gap too narrow to be walked through so soon, and more samples than any limit lets it try.
  write("scene.yaml",
        std::string(kScene) +
            "  - {name: divider, box: {size: [0.1, 2.4, 2.5]}, at: [3, 1.2, 1.25]}\n");
  const std::string text = std::string(kScenario) +
                           "planner: {max_failures: 1000000, time_limit: 0.1}\n"
                           "expect: {status: no_walk}\n";
  CheckOptions update;
  update.update = true;
  const CheckRow late = checkOne(text, update);
  EXPECT_EQ(late.verdict, CheckVerdict::kDiffers);
  EXPECT_TRUE(holds(late.notes.at(0), "time_limit, so nothing was updated")) << late.notes.at(0);
  EXPECT_FALSE(late.updated);
  EXPECT_EQ(read(folder_ / "case.yaml"), text);
}

TEST_F(CheckScenarios, ATimeLimitThatPassesWhileLoadingIsNoWalk) {
  const std::string late = std::string(kScenario) + "planner: {time_limit: 1e-6}\n";
  EXPECT_EQ(checkOne(late + "expect: {status: no_walk}\n").verdict, CheckVerdict::kHolds);
  const CheckRow row = checkOne(late + "expect: {status: solved}\n");
  EXPECT_EQ(row.verdict, CheckVerdict::kDiffers);
  EXPECT_EQ(row.run.status, "no_walk");
}

TEST_F(CheckScenarios, WhatIsInterruptedIsStoppedAndNeitherJudgedNorWritten) {
  const std::string text = std::string(kScenario) + "expect: {max_length: 0.1}\n";
  std::atomic<bool> stop = false;
  CheckOptions options;
  options.update = true;
  options.run.stop = &stop;
  options.started = [&](const ScenarioFile&, int, int) { stop = true; };
  write("other.yaml", text);
  write("case.yaml", text);
  const std::vector<CheckRow> rows = checkScenarios(findScenarios({folder_}), options);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].verdict, CheckVerdict::kStopped);
  EXPECT_TRUE(rows[0].notes.empty());
  EXPECT_FALSE(allHold(rows));
  EXPECT_EQ(read(folder_ / "case.yaml"), text);
}

TEST_F(CheckScenarios, AFileThatIsChangedWhileItRunsIsNotWrittenOver) {
  CheckOptions options;
  options.update = true;
  options.started = [&](const ScenarioFile& file, int, int) {
    write(file.file.filename().string(), "# somebody's edit\n" + file.text);
  };
  const CheckRow row = checkOne(kScenario, options);
  EXPECT_EQ(row.verdict, CheckVerdict::kError);
  EXPECT_TRUE(holds(row.notes.at(0), "was changed while it ran")) << row.notes.at(0);
  EXPECT_TRUE(holds(read(folder_ / "case.yaml"), "# somebody's edit"));
}

TEST_F(CheckScenarios, EveryFaultOfOneIsOneRow) {
  write("low.yaml",  // half a metre below a lid: nobody walks there
        "name: low\nobjects:\n"
        "  - {name: floor, box: {size: [6, 3, 0.1]}, at: [3, 1.5, -0.05]}\n"
        "  - {name: lid, box: {size: [6, 3, 0.1]}, at: [3, 1.5, 0.55], role: obstacle}\n");
  write("a.yaml", "scene: low.yaml\nstart: {at: [1, 1]}\ngoal: {at: [3, 1]}\n");
  write("b.yaml", std::string(kScenario) + "expect: {status: solved}\n");
  CheckOptions options;  // a fault that is none of the input
  write("c.yaml", kScenario);
  options.run.progress = [](const SearchProgress&) { throw std::bad_alloc(); };
  const std::vector<CheckRow> rows = checkScenarios(findScenarios({folder_}), options);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_TRUE(holds(rows[0].notes.at(0), "a.yaml:1: the scene")) << rows[0].notes.at(0);
  EXPECT_TRUE(holds(rows[0].notes.at(0), "can be walked on")) << rows[0].notes.at(0);
  for (const CheckRow& row : rows) EXPECT_EQ(row.verdict, CheckVerdict::kError) << row.scenario;
  EXPECT_TRUE(holds(rows[2].notes.at(0), "c.yaml: out of memory")) << rows[2].notes.at(0);
}

TEST_F(CheckScenarios, DataThatLiesElsewhereAndIsNotThereSkipsAndSaysSo) {
  write("inner/scene.yaml",
        "name: far\nobjects:\n  - {name: flat, mesh: ../../no-such-folder/flat.obj, up: y}\n");
  const std::string text = "scene: inner/scene.yaml\nstart: {at: [1, 1]}\ngoal: {at: [2, 1]}\n";
  const CheckRow skipped = checkOne(text);
  EXPECT_EQ(skipped.verdict, CheckVerdict::kSkipped);
  EXPECT_TRUE(holds(skipped.notes.at(0), "flat.obj"));
  EXPECT_TRUE(allHold({skipped}));
  // What should lie beside the scene is a slip, not somebody else's data.
  write("inner/scene.yaml", "name: near\nobjects:\n  - {name: flat, mesh: flat.obj, up: y}\n");
  EXPECT_EQ(checkOne(text).verdict, CheckVerdict::kError);
}

TEST_F(CheckScenarios, ARunThatIsNotTheAcceptedOneDiffersUntilItIsAccepted) {
  CheckOptions update;
  update.update = true;
  update.picture = [](const RunResult& result) { return result.report.scenario + "'s picture"; };
  EXPECT_TRUE(checkOne(kScenario, update).updated);
  EXPECT_FALSE(checkScenarios(findScenarios({folder_ / "case.yaml"}), update).at(0).updated);
  EXPECT_EQ(read(folder_ / "accepted/case.png"), "case's picture");

  // The same room with another goal: `expect` asks for nothing of it.
  const std::string farther =
      "scene: scene.yaml\nstart: {at: [0.8, 1.5], heading: 0}\ngoal: {at: [5.5, 1.5], heading: "
      "90}\n";
  const CheckRow differs = checkOne(farther);
  EXPECT_EQ(differs.verdict, CheckVerdict::kDiffers);
  EXPECT_TRUE(holds(differs.changes, "not the accepted one: length")) << differs.changes;
  EXPECT_TRUE(differs.notes.empty()) << differs.notes.at(0);
  ASSERT_TRUE(differs.accepted);
  EXPECT_LT(differs.accepted->figures.length, differs.run.length);
  EXPECT_EQ(differs.accepted->picture, "case's picture");

  const CheckRow accepted = checkOne(farther, update);
  EXPECT_EQ(accepted.verdict, CheckVerdict::kHolds);
  EXPECT_NE(accepted.changes, "") << "so that it can be looked at";
  const CheckRow after = checkScenarios(findScenarios({folder_ / "case.yaml"}), {}).at(0);
  EXPECT_EQ(after.verdict, CheckVerdict::kHolds);
  EXPECT_EQ(after.changes, "");
}

TEST_F(CheckScenarios, EachQueryHasAnAcceptedRunOfItsOwn) {
  const std::string queries =
      "scene: scene.yaml\nqueries:\n"
      "  - {name: there, start: {at: [0.8, 1.5]}, goal: {at: [2.2, 1.5]}}\n";
  CheckOptions update;
  update.update = true;
  EXPECT_TRUE(checkOne(queries, update).updated);
  EXPECT_TRUE(fs::exists(folder_ / "accepted/case/there.json"));
  EXPECT_EQ(read(folder_ / "case.yaml"), queries) << "a scenario has one digest";
  EXPECT_EQ(checkOne(queries).verdict, CheckVerdict::kHolds);
}

TEST_F(CheckScenarios, ABrokenAcceptedRunIsAnErrorThatAnUpdateMends) {
  write("accepted/case.json", "{\"status\": 1, \"colour\": 2}");
  const CheckRow row = checkOne(kScenario);
  EXPECT_EQ(row.verdict, CheckVerdict::kError);
  EXPECT_TRUE(holds(row.notes.at(0), "case.json:1: unknown key 'colour'")) << row.notes.at(0);
  CheckOptions update;
  update.update = true;
  EXPECT_EQ(checkOne(kScenario, update).verdict, CheckVerdict::kHolds);
}

TEST_F(CheckScenarios, RowsAreTheSameInTheSameOrderHoweverManyRunAtOnce) {
  for (const char* name : {"a.yaml", "b.yaml", "c.yaml", "d.yaml"}) write(name, kScenario);
  write("a.yaml", "scene: scene.yaml\nstart: {at: [1, 1]}\ngoal: {at: [1.4, 1]}\n");
  write("c.yaml", "scene: none.yaml\nstart: {at: [1, 1]}\ngoal: {at: [2, 1]}\n");
  const auto rowsWith = [&](int jobs) {
    std::string told;
    CheckOptions options;
    options.jobs = jobs;
    options.finished = [&](const CheckRow& row) { told += row.scenario; };
    std::vector<std::string> rows;
    for (const CheckRow& row : checkScenarios(findScenarios({folder_}), options)) {
      rows.push_back(row.scenario + verdictName(row.verdict) + row.run.bvh_sha256);
      for (const std::string& note : row.notes) rows.push_back(note);
    }
    EXPECT_EQ(told, "abcd");
    return rows;
  };
  EXPECT_EQ(rowsWith(1), rowsWith(3));
}

TEST_F(CheckScenarios, StoppingEndsTheRound) {
  write("a.yaml", kScenario);
  std::atomic<bool> stop = true;
  CheckOptions options;
  options.run.stop = &stop;
  EXPECT_TRUE(checkScenarios(findScenarios({folder_}), options).empty());
}

}  // namespace
}  // namespace amble
