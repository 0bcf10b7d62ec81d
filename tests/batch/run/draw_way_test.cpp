#include "batch/run/draw_way.h"

#include "scenarios/kept_roadmaps.h"
#include "scenarios/run_scenario.h"
#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

class DrawWay : public SmallRoom {};

TEST_F(DrawWay, EndsAreFarEnoughApartAndThereIsAWalk) {
  const Problem problem(sceneAlone(folder_ / "scene.yaml"), 1.0 / 30.0);
  const WayDrawer drawer(problem);
  for (std::uint64_t i = 0; i < 5; ++i) {
    SampleStream stream(1, i);
    const auto ends = drawer.draw(stream, 2.5, 4.0);
    ASSERT_TRUE(ends);
    const double distance = (ends->goal.at - ends->start.at).norm();
    EXPECT_GE(distance, 2.5);
    EXPECT_LE(distance, 4.0);
    Scenario scenario = problem.scenario;
    scenario.start = ends->start;
    scenario.goal = ends->goal;
    scenario.has_ends = true;
    const RunResult run =
        runProblem(std::make_unique<const Problem>(problem, scenario), {}, nullptr, {});
    EXPECT_EQ(run.report.status, PlanStatus::kSolved);
  }
}

TEST_F(DrawWay, NoneLeadsThroughAWall) {
  write("scene.yaml",
        std::string(kScene) + "  - {name: wall, box: {size: [0.1, 3, 2.5]}, at: [4, 1.5, 1.25]}\n");
  const Problem problem(sceneAlone(folder_ / "scene.yaml"), 1.0 / 30.0);
  const WayDrawer drawer(problem);
  for (std::uint64_t i = 0; i < 20; ++i) {
    SampleStream stream(1, i);
    const auto ends = drawer.draw(stream, 0.5, 10.0);
    ASSERT_TRUE(ends);
    EXPECT_EQ(ends->start.at.x() < 4.0, ends->goal.at.x() < 4.0);
  }
}

TEST_F(DrawWay, ThereIsNoneWhereNobodyIsAsFarFromAnybody) {
  const Problem problem(sceneAlone(folder_ / "scene.yaml"), 1.0 / 30.0);
  SampleStream stream(1, 0);
  EXPECT_FALSE(WayDrawer(problem).draw(stream, 20.0, 30.0));
}

}  // namespace
}  // namespace amble
