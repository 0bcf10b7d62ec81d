#include "scenarios/scenario.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

Scenario parse(const std::string& text) {
  return readScenario(ScenarioFile{"dir/case.yaml", text});
}

constexpr const char* kLeast = "scene: room.yaml\nstart: {at: [1, 1]}\ngoal: {at: [2, 3]}\n";

// What the error says for kLeast with `more` behind it, whose first line is line 4.
std::string refusalOf(const std::string& more) {
  try {
    parse(kLeast + more);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string errorOfText(const std::string& text) {
  try {
    parse(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

bool startsWith(const std::string& text, const std::string& begin) {
  return text.rfind(begin, 0) == 0;
}
bool hasPart(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Scenario, MissingKeysAreNamed) {
  EXPECT_TRUE(hasPart(errorOfText("start: {at: [1, 1]}\ngoal: {at: [2, 3]}\n"), "scene"));
  EXPECT_TRUE(hasPart(errorOfText("scene: a\ngoal: {at: [2, 3]}\n"), "start"));
  EXPECT_TRUE(hasPart(errorOfText("scene: a\nstart: {at: [2, 3]}\n"), "goal"));
  EXPECT_TRUE(hasPart(errorOfText("scene: a\nstart: {heading: 3}\ngoal: {at: [1, 1]}\n"), "at"));
}

TEST(Scenario, ASceneInPlaceOfOneIsToldByItsObjects) {
  const std::string error = errorOfText("objects:\n  - {name: floor, box: {size: [6, 4, 0.1]}}\n");
  EXPECT_TRUE(startsWith(error, "dir/case.yaml: is a scene;")) << error;
  EXPECT_TRUE(hasPart(error, "`scene: case.yaml`")) << error;
}

struct BadCase {
  const char* text;   // put behind kLeast
  const char* where;  // what the message begins with
  const char* says;   // and what it holds
};

TEST(Scenario, EveryBadKeyIsNamedWithItsLine) {
  const BadCase cases[] = {
      {"planer: {seed: 1}\n", "dir/case.yaml:4:", "planner"},
      {"goal: {at: [1, 1]}\n", "dir/case.yaml:4:", "goal"},
      {"character: {hight: 1.7}\n", "dir/case.yaml:4:", "height"},
      {"character:\n  height: 0.4\n", "dir/case.yaml:5:", "0.5"},
      {"character:\n  height: 2.6\n", "dir/case.yaml:5:", "2.5"},
      {"character:\n  height: tall\n", "dir/case.yaml:5:", "height [m]"},
      {"character:\n  height: .nan\n", "dir/case.yaml:5:", "height [m]"},
      {"character:\n  height: .inf\n", "dir/case.yaml:5:", "height [m]"},
      {"character:\n  max_slope: 46\n", "dir/case.yaml:5:", "slope [degrees]"},
      {"character:\n  max_climb: -0.1\n", "dir/case.yaml:5:", "step height"},
      {"character:\n  max_drop: 1.1\n", "dir/case.yaml:5:", "step height"},
      {"via: {at: [1, 2]}\n", "dir/case.yaml:4:", "via"},
      {"via:\n  - {at: [1, 2]}\n  - {at: [1]}\n", "dir/case.yaml:6:", "[x, y]"},
      {"via:\n  - {at: [1, 2, 3, 4]}\n", "dir/case.yaml:5:", "[x, y]"},
      {"via:\n  - {at: [1, .inf]}\n", "dir/case.yaml:5:", "number"},
      {"via:\n  - {at: [1, 2], heading: 40}\n", "dir/case.yaml:5:", "heading"},
      {"start: 3\n", "dir/case.yaml:4:", "start"},
      {"bounds: {min: [0, 0]}\n", "dir/case.yaml:4:", "max"},
      {"bounds:\n  min: [0, 0]\n  max: [1, 0]\n", "dir/case.yaml:6:", "bounds.min"},
      {"bounds:\n  min: [0, 0, 0]\n  max: [1, 1]\n", "dir/case.yaml:5:", "corner [m]"},
      {"walk:\n  speed: 0.2\n", "dir/case.yaml:5:", "speed [m/s]"},
      {"walk:\n  speed: 2.1\n", "dir/case.yaml:5:", "speed [m/s]"},
      {"walk:\n  from: standing\n", "dir/case.yaml:5:", "stand"},
      {"walk:\n  to: run\n", "dir/case.yaml:5:", "walking"},
      {"walk:\n  actions: carry\n", "dir/case.yaml:5:", "actions"},
      {"walk:\n  actions:\n    - {kind: duck}\n", "dir/case.yaml:6:", "expected text"},
      {"planner:\n  seed: -1\n", "dir/case.yaml:5:", "seed"},
      {"planner:\n  seed: 1.5\n", "dir/case.yaml:5:", "seed"},
      {"planner:\n  max_failures: 0\n", "dir/case.yaml:5:", "number of failures"},
      {"planner:\n  time_limit: 0\n", "dir/case.yaml:5:", "time [s]"},
      {"planner:\n  threads: 2\n", "dir/case.yaml:5:", "threads"},
      {"expect:\n  status: found\n", "dir/case.yaml:5:", "solved"},
      {"expect:\n  max_length: 0\n", "dir/case.yaml:5:", "length [m]"},
      {"expect:\n  min_clearance: -1\n", "dir/case.yaml:5:", "distance [m]"},
      {"expect:\n  max_foot_skate: -1\n", "dir/case.yaml:5:", "distance [m]"},
      {"expect:\n  max_planning_time: 0\n", "dir/case.yaml:5:", "time [s]"},
      {"expect:\n  bvh_sha256: abc\n", "dir/case.yaml:5:", "64"},
      {"expect:\n  min_clearence: 1\n", "dir/case.yaml:5:", "min_clearance"},
  };
  for (const BadCase& bad : cases) {
    const std::string error = refusalOf(bad.text);
    EXPECT_TRUE(startsWith(error, bad.where)) << bad.text << error;
    EXPECT_TRUE(hasPart(error, bad.says)) << bad.text << error;
  }
}

TEST(Scenario, DefaultsAreDesignsDefaults) {
  const Scenario s = parse(kLeast);
  EXPECT_EQ(s.name, "case");
  EXPECT_EQ(s.scene, std::filesystem::path("dir/room.yaml"));
  EXPECT_EQ(s.character.height, 0.0);
  EXPECT_EQ(s.character.library, "default");
  EXPECT_NEAR(s.character.limits.max_slope, 20.0 * kPi / 180.0, 1e-15);
  EXPECT_EQ(s.character.limits.max_climb, 0.25);
  EXPECT_FALSE(s.start.z || s.start.heading || s.goal.heading);
  EXPECT_EQ(s.source.lines.at("start.at"), 2);
  EXPECT_EQ(s.source.lines.at("goal.at"), 3);
  EXPECT_TRUE(s.via.empty());
  EXPECT_FALSE(s.bounds);
  EXPECT_EQ(s.walk.speed, 1.2);
  EXPECT_TRUE(s.walk.from_standing && s.walk.to_standing);
  EXPECT_EQ(s.planner.name, "visibility");
  EXPECT_EQ(s.planner.seed, 1u);
  EXPECT_EQ(s.planner.max_failures, 500);
  EXPECT_EQ(s.planner.time_limit, 60.0);
  EXPECT_FALSE(s.expect);
}

TEST(Scenario, DegreesBecomeRadians) {
  const Scenario s = parse(
      "scene: a\nstart: {at: [1, 1, 2.5], heading: 90}\ngoal: {at: [0, 0], heading: -180}\n"
      "via: [{at: [4, 2]}]\ncharacter: {max_slope: 30}\n");
  EXPECT_NEAR(*s.start.heading, kPi / 2, 1e-15);
  EXPECT_NEAR(*s.goal.heading, -kPi, 1e-15);
  EXPECT_EQ(s.via.at(0).at, Eigen::Vector2d(4, 2));
  EXPECT_NEAR(s.character.limits.max_slope, kPi / 6, 1e-15);
  EXPECT_EQ(*s.start.z, 2.5);
}

TEST(Scenario, DesignsExampleIsRead) {
  const Scenario s = parse(
      "scene: ../environments/scenes/living-room/scene.yaml\n"
      "character:\n  height: 1.75\n  library: default\n  max_slope: 20\n  max_climb: 0.25\n"
      "start: {at: [1, 1], heading: 90}\ngoal:  {at: [6.5, 4.8], heading: 0}\n"
      "via:   [{at: [4, 2]}]\nbounds: {min: [0, 0], max: [8, 6]}\n"
      "walk:\n  speed: 1.2\n  from: stand\n  to: walking\n  actions: []\n"
      "planner:\n  name: visibility\n  seed: 7\n  max_failures: 300\n  time_limit: 30\n"
      "expect:\n  status: no_walk\n  max_length: 12.0\n  min_clearance: 0.0\n"
      "  max_foot_skate: 0.005\n  max_planning_time: 10\n  bvh_sha256: " +
      std::string(64, 'a') + "\n");
  EXPECT_EQ(s.scene, std::filesystem::path("environments/scenes/living-room/scene.yaml"));
  EXPECT_EQ(s.character.height, 1.75);
  EXPECT_EQ(s.bounds->max, Eigen::Vector2d(8, 6));
  EXPECT_FALSE(s.walk.to_standing);
  EXPECT_EQ(s.planner.seed, 7u);
  EXPECT_EQ(s.expect->status, PlanStatus::kNoWalk);
  EXPECT_EQ(s.expect->max_foot_skate, 0.005);
  EXPECT_EQ(s.expect->bvh_sha256, std::string(64, 'a'));
}

TEST(Scenario, ALibrarysPathIsRelativeToTheFile) {
  EXPECT_EQ(parse(std::string(kLeast) + "character: {library: mine.yaml}\n").character.library,
            "dir/mine.yaml");
}

TEST(IsScenario, OnlyFilesWithSceneAndStartAre) {
  const auto file = std::filesystem::temp_directory_path() / "amble_is_scenario_test.yaml";
  const auto holdsScenario = [&](const std::string& text) {
    std::ofstream(file) << text;
    return isScenario(readScenarioFile(file));
  };
  EXPECT_TRUE(holdsScenario(kLeast));
  EXPECT_FALSE(holdsScenario("objects: []\n"));
  EXPECT_FALSE(holdsScenario("- scene\n- start\n"));
  EXPECT_FALSE(holdsScenario("a: {scene: b, start: c}\n"));
  EXPECT_FALSE(holdsScenario("a: [\n"));
  // Broken, yet meant as one: it must be heard of.
  EXPECT_TRUE(holdsScenario("scene: a\nstart: {at: [1, 1]\ngoal: {at: [1, 1]}\n"));
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace amble
