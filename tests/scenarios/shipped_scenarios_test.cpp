/// What must hold of the scenarios that come with Amble (the repository's `scenarios/`).
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <vector>

#include "base/output_file.h"
#include "base/rotation.h"
#include "scenarios/check_scenarios.h"
#include "scenarios/find_scenarios.h"
#include "scenarios/problem.h"
#include "scenarios/validate_walk.h"
#include "test_paths.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> shipped(bool with_walk) {
  std::vector<fs::path> files;
  for (const ScenarioFile& file : findScenarios({fs::path(AMBLE_SOURCE_DIR) / "scenarios"})) {
    const Scenario scenario = readScenario(file);
    const bool solved = scenario.expect && scenario.expect->status == PlanStatus::kSolved;
    if (solved == with_walk) files.push_back(file.file);
  }
  return files;
}

std::string testName(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

RunResult runShipped(const Scenario& scenario) {
  RunOptions options;
  options.threads = 2;
  return runScenario(scenario, options);
}

TEST(ShippedScenarios, EveryOneExpectsAStatus) {
  for (const ScenarioFile& file : findScenarios({fs::path(AMBLE_SOURCE_DIR) / "scenarios"})) {
    const Scenario scenario = readScenario(file);
    ASSERT_TRUE(scenario.expect) << file.file;
    EXPECT_TRUE(scenario.expect->status) << file.file;
    EXPECT_TRUE(fs::exists(scenario.scene)) << file.file;
  }
}

class ShippedWalk : public testing::TestWithParam<fs::path> {};

TEST_P(ShippedWalk, MeetsItsGoalTouchesNothingAndHoldsTheBars) {
  const Scenario scenario = readScenario(GetParam());
  if (const std::string missing = missingData(scenario); !missing.empty()) {
    GTEST_SKIP() << missing << " is not there";
  }
#ifdef __SANITIZE_ADDRESS__
  if (scenario.name == "maze") GTEST_SKIP() << "takes minutes under the sanitizers";
#endif
  const RunResult result = runShipped(scenario);
  for (const std::string& note : differences(*scenario.expect, result, false))
    ADD_FAILURE() << note;
  ASSERT_EQ(result.report.status, PlanStatus::kSolved);
  EXPECT_LE(result.report.goal_position_error, 1e-3);
  EXPECT_LE(result.report.goal_heading_error, 0.5 * kDegree);
  EXPECT_LE(result.report.foot_skate_max, 0.002);
  EXPECT_LE(result.report.ground_penetration, 0.005);
  for (const QualityLine& line : result.report.quality) {
    EXPECT_TRUE(line.holds()) << line.measure << " is " << line.value << " " << line.unit
                              << "; expected at most " << line.bar;
  }

  const fs::path walk = fs::path(testing::TempDir()) / ("amble_shipped_" + scenario.name + ".bvh");
  writeFile(walk, [&](std::ostream& out) { out << result.bvh; });
  ValidateOptions options;
  options.fps = 240.0;
  options.floor = result.problem->floor;
  options.limits = scenario.character.limits;
  const WalkValidation found = validateWalk(walk, scenario.scene, options);
  for (const ContactSpan& contact : found.contacts) {
    ADD_FAILURE() << contact.part << " touches " << contact.object << " at " << contact.start;
  }
  EXPECT_FALSE(found.hovers()) << found.feet.hover_max;
  EXPECT_LE(found.feet.skate_mean, 0.004);
  fs::remove(walk);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, ShippedWalk, testing::ValuesIn(shipped(true)), testName);

class ShippedRefusal : public testing::TestWithParam<fs::path> {};

TEST_P(ShippedRefusal, SaysWhatStoodInTheWay) {
  // Where one object only can be in the way, its name.
  const std::map<std::string, std::string> in_the_way = {
      {"goal-inside-closed-cupboard", "cupboard"},
      {"low-beam-tall", "beam"},
      {"sealed-goal", "cell-"},
      {"start-in-table", "table"}};
  // `amble check` runs them with the count that they ask for; that there is a refusal with a reason
  // shows sooner.
  constexpr int kFewFailures = 10;
  Scenario scenario = readScenario(GetParam());
  scenario.planner.max_failures = std::min(scenario.planner.max_failures, kFewFailures);
  const RunResult result = runShipped(scenario);
  for (const std::string& note : differences(*scenario.expect, result, false))
    ADD_FAILURE() << note;
  EXPECT_EQ(result.report.stopped_by, "");
  EXPECT_TRUE(result.bvh.empty());
  const auto object = in_the_way.find(scenario.name);
  if (object != in_the_way.end()) {
    EXPECT_NE(result.report.why.find(object->second), std::string::npos) << result.report.why;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenarios, ShippedRefusal, testing::ValuesIn(shipped(false)), testName);

}  // namespace
}  // namespace amble
