#include "scenarios/check_scenarios.h"

#include <sstream>

#include "base/sha256.h"
#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

class CheckScenarios : public SmallRoom {
 protected:
  CheckRow checkOne(const std::string& text, const CheckOptions& options = {}) const {
    return checkScenarios({write("case.yaml", text)}, options).at(0);
  }
};

TEST_F(CheckScenarios, PathsThatHoldNoScenarioAreInputErrors) {
  EXPECT_TRUE(holds(inputError([&] { findScenarios({folder_ / "none"}); }), "is not there"));
  EXPECT_TRUE(
      holds(inputError([&] { findScenarios({folder_ / "scene.yaml"}); }), "is no scenario"));
  EXPECT_TRUE(holds(inputError([&] { findScenarios({folder_}); }), "holds no scenario"));
}

TEST_F(CheckScenarios, FoldersAreSearchedAndOtherFilesPassedOver) {
  write("b.yaml", kScenario);
  write("deeper/a.yml", kScenario);
  write("deeper/notes.txt", kScenario);
  write("deeper/other.yaml", "objects: []\n");
  const std::vector<fs::path> expected = {folder_ / "b.yaml", folder_ / "deeper" / "a.yml"};
  EXPECT_EQ(findScenarios({folder_}), expected);
}

TEST_F(CheckScenarios, ABrokenScenarioIsAnErrorAndDoesNotStopTheOthers) {
  write("a.yaml", "scene: scene.yaml\nstart: {at: [1]}\ngoal: {at: [1, 1]}\n");
  write("b.yaml", std::string(kScenario) + "expect: {status: solved}\n");
  const std::vector<CheckRow> rows = checkScenarios({folder_}, {});
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
  EXPECT_EQ(checkScenarios({folder_ / "case.yaml"}, {}).at(0).verdict, CheckVerdict::kHolds);
  const CheckRow differs = checkOne(text + "  bvh_sha256: " + std::string(64, '0') + "\n");
  EXPECT_EQ(differs.verdict, CheckVerdict::kDiffers);
  EXPECT_TRUE(holds(differs.notes.at(0), "SHA-256"));
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

TEST_F(CheckScenarios, StoppingEndsTheRound) {
  write("a.yaml", kScenario);
  std::atomic<bool> stop = true;
  CheckOptions options;
  options.run.stop = &stop;
  EXPECT_TRUE(checkScenarios({folder_}, options).empty());
}

TEST(WithDigest, EveryLayoutKeepsItsText) {
  const std::string begin = "scene: a\nstart: {at: [1, 1]}  # here\ngoal: {at: [2, 2]}\n";
  const std::string digest(64, 'b'), old(64, 'a');
  const auto with = [&](const std::string& text) { return withDigest(begin + text, "x", digest); };
  EXPECT_EQ(with(""), begin + "expect:\n  bvh_sha256: " + digest + "\n");
  EXPECT_EQ(with("expect:\n"), begin + "expect:\n  bvh_sha256: " + digest + "\n");
  EXPECT_EQ(with("expect:\n    status: solved  # yes\nwalk: {speed: 1}\n"),
            begin + "expect:\n    status: solved  # yes\n    bvh_sha256: " + digest +
                "\nwalk: {speed: 1}\n");
  EXPECT_EQ(with("expect: {status: solved}\n"),
            begin + "expect: {status: solved, bvh_sha256: " + digest + "}\n");
  EXPECT_EQ(with("expect: { status: solved }  # so\n"),
            begin + "expect: { status: solved, bvh_sha256: " + digest + " }  # so\n");
  EXPECT_EQ(with("expect: {}\n"), begin + "expect: {bvh_sha256: " + digest + "}\n");
  EXPECT_EQ(with("expect:\n  bvh_sha256: " + old + "  # of then\n  status: solved\n"),
            begin + "expect:\n  bvh_sha256: " + digest + "  # of then\n  status: solved\n");
}

TEST(WithDigest, ALayoutThatItCannotKeepIsRefused) {
  const std::string text =
      "scene: a\nstart: {at: [1, 1]}\ngoal: {at: [2, 2]}\nexpect: {status:\n    solved\n  }\n";
  EXPECT_THROW(withDigest(text, "x", std::string(64, 'b')), InputError);
}

TEST(WriteJUnit, CountsAndEscapes) {
  CheckRow good, bad, skipped, error;
  good.file = "s/good.yaml";
  good.scenario = "good";
  bad.scenario = "bad & \"worse\"";
  bad.verdict = CheckVerdict::kDiffers;
  bad.notes = {"length is 5 m; expected < 4", "second"};
  skipped.verdict = CheckVerdict::kSkipped;
  error.verdict = CheckVerdict::kError;
  std::ostringstream out;
  writeJUnit(out, {good, bad, skipped, error});
  const std::string xml = out.str();
  EXPECT_TRUE(holds(xml, "tests=\"4\" failures=\"1\" errors=\"1\" skipped=\"1\"")) << xml;
  EXPECT_TRUE(holds(xml, "classname=\"s\" name=\"good\"")) << xml;
  EXPECT_TRUE(holds(xml, "name=\"bad &amp; &quot;worse&quot;\"")) << xml;
  EXPECT_TRUE(holds(xml, "expected &lt; 4; second")) << xml;
}

}  // namespace
}  // namespace amble
