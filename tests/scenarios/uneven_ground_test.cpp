/// Ground that is hard to walk on or badly modelled: each gives a walk or a refusal by name, never
/// a foot in the air or through the floor.
#include <cmath>
#include <set>
#include <sstream>

#include "base/rotation.h"
#include "scenarios/problem.h"
#include "scenarios/run_scenario.h"
#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

// Lines of a scene file.
class SceneText {
 public:
  SceneText& box(const std::string& name, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                 double turn_deg = 0.0) {
    const Eigen::Vector3d size = high - low, at = 0.5 * (low + high);
    text_ << "  - {name: " << name << ", box: {size: " << vec(size) << "}, at: " << vec(at)
          << ", turn: " << turn_deg << "}\n";
    return *this;
  }
  SceneText& mesh(const std::string& name) {
    text_ << "  - {name: " << name << ", mesh: " << name << ".obj, up: z}\n";
    return *this;
  }
  // Rise 0.17 m and going 0.29 m from (0, 0) towards +x, treads `thick` [m] or whole.
  SceneText& flight(int treads, double thick, const std::set<int>& missing = {}) {
    for (int i = 0; i < treads; ++i) {
      const double top = 0.17 * (i + 1);
      if (missing.count(i)) continue;
      box("step-" + std::to_string(i + 1), {0.29 * i, -0.6, thick > 0.0 ? top - thick : 0.0},
          {0.29 * (i + 1), 0.6, top});
    }
    return box("upper", {0.29 * treads, -1.5, 0.17 * (treads + 1) - 0.1},
               {0.29 * treads + 3.0, 1.5, 0.17 * (treads + 1)});
  }
  std::string str() const { return "name: uneven\nobjects:\n" + text_.str(); }

 private:
  static std::string vec(const Eigen::Vector3d& v) {
    std::ostringstream out;
    out << "[" << v.x() << ", " << v.y() << ", " << v.z() << "]";
    return out.str();
  }
  std::ostringstream text_;
};

// A mesh of quads.
class ObjText {
 public:
  ObjText& quad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d) {
    for (const Eigen::Vector3d& p : {a, b, c, d})
      vertices_ << "v " << p.x() << " " << p.y() << " " << p.z() << "\n";
    faces_ << "f " << count_ + 1 << " " << count_ + 2 << " " << count_ + 3 << "\n"
           << "f " << count_ + 1 << " " << count_ + 3 << " " << count_ + 4 << "\n";
    count_ += 4;
    return *this;
  }
  std::string str() const { return vertices_.str() + faces_.str(); }

 private:
  std::ostringstream vertices_, faces_;
  int count_ = 0;
};

class UnevenGround : public SmallRoom {
 protected:
  RunResult run(const SceneText& scene, const std::string& start, const std::string& goal) {
    write("scene.yaml", scene.str());
    return runScenario(readScenario(write("case.yaml", "scene: scene.yaml\nstart: {at: " + start +
                                                           "}\ngoal: {at: " + goal +
                                                           "}\nplanner: {max_failures: 4}\n")));
  }

  // The walk was checked whole when it was written; here: every foot stands on ground.
  static void expectStood(const RunResult& result) {
    ASSERT_EQ(result.report.status, PlanStatus::kSolved) << result.report.why;
    EXPECT_LE(result.report.ground_penetration, 0.005);
    EXPECT_LE(result.report.foot_skate_max, 0.002);
    for (const Footprint& print : result.outcome.walk.buffer.footprints) {
      const auto under = result.problem->ground.height(print.position.x(), print.position.y(),
                                                       print.position.z(), 0.02);
      EXPECT_TRUE(under.has_value()) << print.position.transpose();
    }
  }
  static void expectRefusedByName(const RunResult& result) {
    ASSERT_EQ(result.report.status, PlanStatus::kNoWalk);
    EXPECT_TRUE(result.bvh.empty());
    EXPECT_FALSE(result.report.why.empty());
    EXPECT_FALSE(result.report.refusals.empty());
  }
  static void expectStoodOrRefused(const RunResult& result) {
    if (result.report.status == PlanStatus::kSolved)
      expectStood(result);
    else
      expectRefusedByName(result);
  }
};

TEST_F(UnevenGround, NoGroundUnderTheStartIsNamed) {
  SceneText scene;
  scene.box("floor", {0, 0, -0.1}, {6, 3, 0});
  const std::string error = inputError([&] { run(scene, "[8, 1]", "[5, 1]"); });
  EXPECT_TRUE(holds(error, "case.yaml:2: 'start.at' has no floor under it")) << error;
}

TEST_F(UnevenGround, AFlightIsClimbedTreadByTread) {
  SceneText scene;
  scene.box("floor", {-3, -1.5, -0.1}, {0, 1.5, 0}).flight(5, 0.0);
  const RunResult result = run(scene, "[-1.5, 0, 0]", "[3, 0, 1.02]");
  expectStood(result);
  double highest = 0.0;
  for (const StepMeasure& step : result.report.steps) {
    EXPECT_LE(step.climb, 0.18);
    highest = std::max(highest, step.climb);
  }
  EXPECT_NEAR(highest, 0.17, 0.005);
}

TEST_F(UnevenGround, TheWalkUpAFlightIsTheSameOnAnyNumberOfThreads) {
  SceneText scene;
  scene.box("floor", {-3, -1.5, -0.1}, {0, 1.5, 0}).flight(3, 0.0);
  write("scene.yaml", scene.str());
  const Scenario scenario = readScenario(write(
      "case.yaml", "scene: scene.yaml\nstart: {at: [-1.5, 0, 0]}\ngoal: {at: [3, 0, 0.68]}\n"));
  RunOptions one, two;
  one.threads = 1;
  two.threads = 2;
  const RunResult a = runScenario(scenario, one), b = runScenario(scenario, two);
  ASSERT_EQ(a.report.status, PlanStatus::kSolved) << a.report.why;
  EXPECT_TRUE(a.bvh == b.bvh);
}

TEST_F(UnevenGround, OverAMissingTreadThereIsNoWalk) {
  SceneText scene;
  scene.box("floor", {-3, -1.5, -0.1}, {0, 1.5, 0}).flight(5, 0.04, {2});
  expectRefusedByName(run(scene, "[-1.5, 0, 0]", "[3, 0, 1.02]"));
}

TEST_F(UnevenGround, OpenRisersAreClimbed) {
  SceneText scene;
  scene.box("floor", {-3, -1.5, -0.1}, {3, 1.5, 0}).flight(5, 0.04);
  expectStoodOrRefused(run(scene, "[-1.5, 0, 0]", "[3, 0, 1.02]"));
}

TEST_F(UnevenGround, OnASpiralStairNobodyStepsIntoTheAir) {
  SceneText scene;
  scene.box("floor", {-3, -3, -0.1}, {3, 3, 0});
  for (int i = 0; i < 8; ++i) {
    const double angle = 22.5 * i * kDegree, top = 0.17 * (i + 1);
    const Eigen::Vector3d at(0.8 * std::cos(angle), 0.8 * std::sin(angle), 0.0);
    scene.box("tread-" + std::to_string(i), at + Eigen::Vector3d(-0.6, -0.2, top - 0.04),
              at + Eigen::Vector3d(0.6, 0.2, top), 22.5 * i);
  }
  scene.box("upper", {-3.5, -2.4, 1.43}, {-0.3, -0.3, 1.53});
  expectStoodOrRefused(run(scene, "[2.2, -1, 0]", "[-2, -1.4, 1.53]"));
}

TEST_F(UnevenGround, AFloorOfSliversIsAFloor) {
  ObjText slivers;
  for (int i = 0; i < 600; ++i) {
    const double x = 0.01 * i, next = 0.01 * (i + 1);
    slivers.quad({x, 0, 0}, {next, 0, 0}, {next, 3, 0}, {x, 3, 0});
  }
  write("slivers.obj", slivers.str());
  expectStood(run(SceneText().mesh("slivers"), "[0.8, 1.5]", "[5.2, 1.5]"));
}

TEST_F(UnevenGround, AFloorOfOneTriangleIsAFloor) {
  write("triangle.obj", "v -10 -10 0\nv 20 -10 0\nv 5 20 0\nf 1 2 3\n");
  expectStood(run(SceneText().mesh("triangle"), "[0.8, 1.5]", "[5.2, 1.5]"));
}

TEST_F(UnevenGround, WallsWithoutThicknessAreWalkedRound) {
  ObjText wall;
  wall.quad({3, 0, 0}, {3, 2, 0}, {3, 2, 2.5}, {3, 0, 2.5});
  write("wall.obj", wall.str());
  SceneText scene;
  scene.box("floor", {0, 0, -0.1}, {6, 4, 0}).mesh("wall");
  const RunResult result = run(scene, "[0.8, 1]", "[5.2, 1]");
  expectStood(result);
  EXPECT_GT(result.report.length, 4.8);
}

TEST_F(UnevenGround, FloorsOverOneAnotherAreToldApartByZ) {
  SceneText scene;
  scene.box("floor", {-3, -1.5, -0.1}, {5, 1.5, 0}).flight(5, 0.04);
  write("scene.yaml", scene.str());
  const auto errorOf = [&](const std::string& goal) {
    return inputError([&] { run(scene, "[-1.5, 0, 0]", goal); });
  };
  EXPECT_TRUE(holds(errorOf("[3, 0]"),
                    "has several floors over one another that steps join; expected "
                    "[x, y, z] with z near one of 0.00, 1.02"))
      << errorOf("[3, 0]");
  EXPECT_TRUE(holds(errorOf("[3, 0, 0.5]"), "no floor within 0.30 m of z; expected z near one of"));
}

}  // namespace
}  // namespace amble
