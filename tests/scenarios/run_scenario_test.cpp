#include "scenarios/run_scenario.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "animation/captures/bvh.h"
#include "base/rotation.h"
#include "base/sha256.h"
#include "scenarios/problem.h"
#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

class RunScenario : public SmallRoom {
 protected:
  RunResult run(const std::string& text, const RunOptions& options = {}) const {
    return runScenario(readScenario(write("case.yaml", text)), options);
  }
  std::string errorOf(const std::string& text) const {
    return inputError([&] { run(text); });
  }
  static std::string withoutTimes(const Report& report) {
    std::ostringstream out;
    writeJson(out, report);
    const std::string text = out.str();
    return text.substr(0, text.find("\"times\""));
  }
};

TEST_F(RunScenario, WhatIsNotThereIsNamedWithItsLine) {
  const std::string ends = "start: {at: [1, 1]}\ngoal: {at: [2, 1]}\n";
  EXPECT_TRUE(holds(errorOf("scene: none.yaml\n" + ends), "case.yaml:1: the scene"));
  EXPECT_TRUE(holds(errorOf(std::string(kScenario) + "character:\n  library: none.yaml\n"),
                    "case.yaml:5: the library"));
  for (const char* const action : {"wave", "walk-slow", "start"}) {  // none; a walk; a start
    EXPECT_TRUE(holds(errorOf(std::string(kScenario) + "walk:\n  actions: [" + action + "]\n"),
                      "case.yaml:5: '" + std::string(action) + "' is no movement or posture"))
        << action;
  }
  const std::string error = errorOf(std::string(kScenario) + "planner:\n  name: visibilty\n");
  EXPECT_TRUE(holds(error, "case.yaml:5:") && holds(error, "'visibility'")) << error;
}

// Parts are read at the same time; what is told is the first in the order of scene file, library,
// meshes and the rest of the scene, ground, however soon the others are found.
TEST_F(RunScenario, OfSeveralThingsThatAreWrongTheSameOneIsToldEachTime) {
  const std::string room = kScene, bad_mesh = "  - {name: a, mesh: bad.obj, up: z}\n",
                    worse = "  - {name: b, mesh: worse.obj, up: z}\n",
                    bad_key = "  - {name: c, colour: red}\n",
                    no_floor = "objects:\n  - {name: a, box: {size: [1, 1, 1]}, role: obstacle}\n";
  write("bad.obj", "v 0 0 0\nf 1 2 3\n");
  write("worse.obj", "nothing\n");
  write("bad.yaml", "colour: red\n");
  const std::string both = std::string(kScenario) + "character:\n  library: bad.yaml\n";
  struct Case {
    std::string scene, scenario, told;
  };
  for (const Case& one : {Case{"objects: [\n", both, "scene.yaml:"},
                          Case{room + bad_mesh + worse + bad_key, both, "bad.yaml:"},
                          Case{room + bad_key + bad_mesh, both, "bad.yaml:"},
                          Case{room + bad_mesh + worse + bad_key, kScenario, "bad.obj:"},
                          Case{room + worse + bad_mesh, kScenario, "worse.obj:"},
                          Case{room + bad_key + worse, kScenario, "scene.yaml:9:"},
                          Case{no_floor, kScenario, "case.yaml:1: the scene"}}) {
    write("scene.yaml", one.scene);
    for (int n = 0; n < 5; ++n) {
      const std::string error = errorOf(one.scenario);
      EXPECT_TRUE(holds(error, one.told.c_str())) << one.scene << error;
    }
  }
}

TEST_F(RunScenario, APlaceOutsideOfTheSceneIsNamedWithItsLine) {
  const std::string error =
      errorOf("scene: scene.yaml\nstart: {at: [1, 1]}\ngoal:\n  at: [12, 1]\n");
  EXPECT_TRUE(holds(error, "case.yaml:4: 'goal.at' has no floor under it")) << error;
  EXPECT_TRUE(holds(errorOf(std::string(kScenario) + "via:\n  - {at: [1, 9]}\n"),
                    "case.yaml:5: 'via[0].at' has no floor"));
  EXPECT_TRUE(holds(errorOf(std::string(kScenario) + "bounds: {min: [0, 0], max: [5, 3]}\n"),
                    "case.yaml:3: 'goal.at' is outside of 'bounds'"));
}

TEST_F(RunScenario, WhatCannotBeWalkedToIsNoFloorUnlessZNamesIt) {
  write("scene.yaml", std::string(kScene) +
                          "  - {name: upstairs, box: {size: [2, 3, 0.1]}, at: [1, 1.5, 2.75]}\n");
  EXPECT_EQ(run(kScenario).problem->floor, 0.0);
  const RunResult upstairs =
      run("scene: scene.yaml\nstart: {at: [0.8, 1.5, 2.8]}\ngoal: {at: [5.2, 1.5]}\n");
  EXPECT_NEAR(upstairs.problem->floor, 2.8, 1e-9);
  EXPECT_EQ(upstairs.report.status, PlanStatus::kNoWalk);
  EXPECT_TRUE(holds(errorOf("scene: scene.yaml\nstart: {at: [0.8, 1.5, 1.4]}\n"
                            "goal: {at: [5.2, 1.5]}\n"),
                    "no floor within 0.30 m"));
  const RunResult result =
      run("scene: scene.yaml\nstart: {at: [0.8, 1.5, 0.1]}\ngoal: {at: [5.2, 1.5]}\n");
  EXPECT_EQ(result.problem->floor, 0.0);
}

TEST_F(RunScenario, AWalkMeetsItsGoalAndTouchesNothing) {
  const RunResult result = run(kScenario);
  const Report& report = result.report;
  ASSERT_EQ(report.status, PlanStatus::kSolved) << report.why;
  EXPECT_LE(report.goal_position_error, 1e-3);
  EXPECT_LE(report.goal_heading_error, 0.5 * kDegree);
  EXPECT_GT(report.clearance.min, 0.0);
  EXPECT_LE(report.foot_skate_max, 0.002);
  EXPECT_LE(report.ground_penetration, 0.005);
  EXPECT_GE(report.length, 4.4);  // no shorter than the straight line
  // The file says so too, by its root: x and z of the file are x and -y of World.
  std::istringstream in(result.bvh);
  const Clip clip = readBvh(in, "walk.bvh");
  ASSERT_EQ(clip.frames(), report.frames);
  EXPECT_NEAR((clip.poses.p_WR(clip.frames() - 1).head<2>() - Eigen::Vector2d(5.2, 1.5)).norm(),
              0.0, 1e-3);
  EXPECT_NEAR((clip.poses.p_WR(0).head<2>() - Eigen::Vector2d(0.8, 1.5)).norm(), 0.0, 1e-3);
}

TEST_F(RunScenario, TheSameScenarioGivesTheSameBytesAtAnyNumberOfThreads) {
  RunOptions two;
  two.threads = 2;
  const RunResult a = run(kScenario), b = run(kScenario), c = run(kScenario, two);
  ASSERT_EQ(a.report.status, PlanStatus::kSolved);
  EXPECT_FALSE(a.bvh.empty());
  EXPECT_EQ(a.bvh, b.bvh);
  EXPECT_EQ(a.bvh, c.bvh);
  EXPECT_EQ(withoutTimes(a.report), withoutTimes(b.report));
  EXPECT_EQ(withoutTimes(a.report), withoutTimes(c.report));
}

TEST_F(RunScenario, CentimetresAreTheSameWalk) {
  RunOptions options;
  options.bvh_unit = 0.01;
  const RunResult metres = run(kScenario), centimetres = run(kScenario, options);
  std::istringstream in_m(metres.bvh), in_cm(centimetres.bvh);
  BvhReadOptions cm;
  cm.metres_per_unit = 0.01;
  const Clip a = readBvh(in_m, "m"), b = readBvh(in_cm, "cm", cm);
  ASSERT_EQ(a.frames(), b.frames());
  for (int i = 0; i < a.frames(); ++i) {
    EXPECT_LT((a.poses.p_WR(i) - b.poses.p_WR(i)).norm(), 2e-6);
  }
  EXPECT_EQ(centimetres.report.bvh_unit, 0.01);
}

TEST_F(RunScenario, StepsAlternateAndCoverTheWalk) {
  const RunResult result = run(kScenario);
  const Report& report = result.report;
  ASSERT_GE(report.steps.size(), 6u);
  // All prints but the two that are stood on at the start.
  EXPECT_EQ(report.steps.size() + 2, result.outcome.walk.buffer.footprints.size());
  for (size_t i = 1; i < report.steps.size(); ++i) {
    EXPECT_NE(report.steps[i].side, report.steps[i - 1].side) << i;
  }
  for (const StepMeasure& step : report.steps) {
    EXPECT_LE(step.strike, step.lift_off);
    EXPECT_LE(step.slide, 0.002);
    EXPECT_NEAR(step.at.z(), 0.0, 1e-9);
    EXPECT_LT(step.stride, 1.0);
    EXPECT_LT(step.lift, 0.3);
  }
  EXPECT_GT(report.steps.front().strike, 0.0);
  EXPECT_NEAR(
      std::max(report.steps.back().lift_off, report.steps[report.steps.size() - 2].lift_off),
      report.duration, 1e-9);
}

TEST_F(RunScenario, InputsAreTheFilesThatWereRead) {
  const RunResult result = run(kScenario);
  const auto& inputs = result.report.inputs;
  EXPECT_EQ(inputs.at("case.yaml"), sha256OfFile(folder_ / "case.yaml"));
  EXPECT_EQ(inputs.at("scene.yaml"), sha256OfFile(folder_ / "scene.yaml"));
  EXPECT_EQ(inputs.size(), 4u);  // and the library's two
}

TEST_F(RunScenario, ViaPointsArePassedInOrder) {
  const RunResult result = run(std::string(kScenario) + "via: [{at: [3, 0.8]}, {at: [4, 2.2]}]\n");
  ASSERT_EQ(result.report.status, PlanStatus::kSolved) << result.report.why;
  const std::vector<FrameState>& states = result.outcome.walk.buffer.states;
  const auto nearest = [&](const Eigen::Vector2d& via) {
    return std::min_element(states.begin(), states.end(), [&](const auto& a, const auto& b) {
      return (a.position.template head<2>() - via).norm() <
             (b.position.template head<2>() - via).norm();
    });
  };
  const auto first = nearest({3, 0.8}), second = nearest({4, 2.2});
  // A frame lies within half a frame's way of every place that is passed.
  EXPECT_LT((first->position.head<2>() - Eigen::Vector2d(3, 0.8)).norm(), 0.02);
  EXPECT_LT((second->position.head<2>() - Eigen::Vector2d(4, 2.2)).norm(), 0.02);
  EXPECT_LT(first, second);
}

TEST_F(RunScenario, AStartInAThingIsBlockedAndWhyNamesIt) {
  const RunResult result =
      run("scene: scene.yaml\nstart: {at: [2.85, 1.5, 0], heading: 0}\ngoal: {at: [5, 1.5]}\n");
  EXPECT_EQ(result.report.status, PlanStatus::kStartBlocked);
  EXPECT_TRUE(holds(result.report.why, "pillar")) << result.report.why;
  EXPECT_TRUE(result.bvh.empty());
  EXPECT_EQ(result.bvhDigest(), "");
}

TEST_F(RunScenario, AGoalInAThingIsBlockedAndWhyNamesIt) {
  const RunResult result =
      run("scene: scene.yaml\nstart: {at: [1, 1.5]}\ngoal: {at: [2.85, 1.5, 0], heading: 0}\n");
  EXPECT_EQ(result.report.status, PlanStatus::kGoalBlocked);
  EXPECT_TRUE(holds(result.report.why, "pillar")) << result.report.why;
}

TEST_F(RunScenario, AnEndInABedIsBlockedByItHoweverLargeTheBedIs) {
  for (const std::string side : {"1.6", "2.5"}) {
    write("bed.yaml",
          "name: bedroom\nobjects:\n"
          "  - {name: floor, box: {size: [9, 6, 0.1]}, at: [4.5, 3, -0.05]}\n"
          "  - {name: bed, box: {size: [" +
              side + ", " + side + ", 0.5]}, at: [6.5, 3, 0.25]}\n");
    const RunResult goal = run("scene: bed.yaml\nstart: {at: [1, 3]}\ngoal: {at: [6.5, 3]}\n");
    EXPECT_EQ(goal.report.status, PlanStatus::kGoalBlocked) << side;
    const RunResult start = run("scene: bed.yaml\nstart: {at: [6.5, 3]}\ngoal: {at: [1, 3]}\n");
    EXPECT_EQ(start.report.status, PlanStatus::kStartBlocked) << side;
    for (const RunResult* result : {&goal, &start}) {
      const std::string& why = result->report.why;
      EXPECT_TRUE(holds(why, "and bed touch at (") || holds(why, "it is in bed")) << why;
      EXPECT_LT(result->outcome.why->width.value_or(0.0), 0.1) << "it is in it";
      ASSERT_TRUE(result->outcome.why && result->outcome.why->free);
      EXPECT_NEAR(result->outcome.why->free->z(), 0.0, 1e-9) << "not on the bed";
    }
  }
}

TEST_F(RunScenario, BehindAWallThereIsNoWalkAndWhyNamesTheWall) {
  write("scene.yaml", std::string(kScene) +
                          "  - {name: divider, box: {size: [0.1, 3, 2.5]}, at: [3, 1.5, 1.25]}\n");
  const RunResult result =
      run(std::string(kScenario) + "planner: {max_failures: 3, time_limit: 20}\n");
  EXPECT_EQ(result.report.status, PlanStatus::kNoWalk);
  EXPECT_TRUE(holds(result.report.why, "divider") || holds(result.report.why, "pillar"))
      << result.report.why;
  EXPECT_FALSE(result.report.refusals.empty());
}

TEST_F(RunScenario, LoadingThatIsStoppedIsAResultThatSaysSo) {
  const RunResult late = run(std::string(kScenario) + "planner: {time_limit: 1e-6, seed: 4}\n");
  EXPECT_EQ(late.report.status, PlanStatus::kNoWalk);
  EXPECT_EQ(late.report.stopped_by, "time_limit");
  EXPECT_TRUE(holds(late.report.why, "time limit passed while the scene was loaded"));
  EXPECT_FALSE(late.report.proved);
  EXPECT_EQ(late.report.seed, 4u);
  EXPECT_EQ(late.problem, nullptr);
  std::ostringstream written;
  writeJson(written, late.report);
  EXPECT_TRUE(holds(written.str(), "no_walk"));
  const std::atomic<bool> stop = true;
  RunOptions options;
  options.stop = &stop;
  EXPECT_EQ(run(kScenario, options).report.stopped_by, "interrupt");
}

TEST_F(RunScenario, LoadingIsTimedByItsParts) {
  const RunTimes& times = run(kScenario).report.times;
  const LoadTimes& of = times.loading;
  for (const double part : {of.scene, of.library, of.ground, of.character, of.collision})
    EXPECT_GT(part, 0.0);
  EXPECT_LE(of.scene + of.library + of.ground + of.character + of.collision, times.load);
}

// Through a gap of 0.6 m nobody walks so soon, and nothing proves that nobody does.
TEST_F(RunScenario, ATimeLimitStopsTheSearchAndTheReportSaysSo) {
  write("scene.yaml",
        std::string(kScene) +
            "  - {name: divider, box: {size: [0.1, 2.4, 2.5]}, at: [3, 1.2, 1.25]}\n");
  const RunResult result =
      run(std::string(kScenario) + "planner: {max_failures: 1000000, time_limit: 0.2}\n");
  EXPECT_EQ(result.report.status, PlanStatus::kNoWalk);
  EXPECT_EQ(result.report.stopped_by, "time_limit");
}

}  // namespace
}  // namespace amble
