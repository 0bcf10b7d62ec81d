#include "batch/labels/write_labels.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "batch/labels/caption.h"
#include "batch/labels/walk_row.h"
#include "scenarios/problem.h"
#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

class WalkLabelled : public SmallRoom {
 protected:
  RunResult walk(const std::string& things, const std::string& ends) const {
    write("scene.yaml", kScene + things);
    RunOptions how;
    how.frame_time = 1.0 / 30.0;
    RunResult run =
        runScenario(readScenario(write("case.yaml", "scene: scene.yaml\n" + ends)), how);
    EXPECT_EQ(run.report.status, PlanStatus::kSolved) << run.report.why;
    return run;
  }
  RunResult across(const std::string& things = "") const {
    return walk(things,
                "start: {at: [0.8, 1.5], heading: 0}\ngoal: {at: [5.2, 1.5], heading: 0}\n");
  }
};

TEST_F(WalkLabelled, SharesOfMotionsSumToOneInEveryFrame) {
  const RunResult run = across();
  const FrameLabels labels = labelFrames(run, false);
  const size_t columns = labels.motions.size();
  ASSERT_EQ(labels.shares.size(), columns * static_cast<size_t>(labels.frames));
  for (int frame = 0; frame < labels.frames; ++frame) {
    double sum = 0.0;
    for (size_t i = 0; i < columns; ++i)
      sum += labels.shares[static_cast<size_t>(frame) * columns + i];
    EXPECT_NEAR(sum, 1.0, 1e-5);
  }
}

// But for what the report finds nearer between two frames: some millimetres of what passes quickly.
TEST_F(WalkLabelled, TheLeastOfAllClearancesIsTheReports) {
  const RunResult run = across();
  ASSERT_LT(run.report.clearance.min, kLabelClearance);
  const FrameLabels labels = labelFrames(run, true);
  const auto least = std::min_element(labels.clearance.begin(), labels.clearance.end());
  EXPECT_GE(*least, run.report.clearance.min - 1e-6);
  EXPECT_LT(*least, run.report.clearance.min + 0.008);
  const auto at = static_cast<size_t>(least - labels.clearance.begin());
  EXPECT_EQ(labels.parts[at % labels.parts.size()], run.report.clearance.part);
  EXPECT_EQ(labels.objects[static_cast<size_t>(labels.nearest[at])], run.report.clearance.object);
}

TEST_F(WalkLabelled, OnlySolesTouchTheGroundAndOneOfThemAlways) {
  const RunResult run = across();
  const FrameLabels labels = labelFrames(run, true);
  for (int frame = 0; frame < labels.frames; ++frame) {
    bool stands = false;
    for (size_t part = 0; part < labels.parts.size(); ++part) {
      const bool touches =
          labels.contact[static_cast<size_t>(frame) * labels.parts.size() + part] != 0;
      EXPECT_TRUE(!touches || run.problem->body.parts[part].sole >= 0) << labels.parts[part];
      stands |= touches;
    }
    EXPECT_TRUE(stands) << frame;
  }
}

TEST_F(WalkLabelled, StrikesAreTheReportsStepsAndAFootLiftsOffBeforeItStrikes) {
  const RunResult run = across();
  const FrameLabels labels = labelFrames(run, false);
  size_t strikes = 0;
  std::array<bool, 2> in_air = {false, false};
  for (const GaitEvent& event : labels.events) {
    EXPECT_EQ(in_air[event.side], event.strike);
    in_air[event.side] = !event.strike;
    strikes += event.strike ? 1 : 0;
  }
  EXPECT_EQ(strikes, run.report.steps.size());
}

TEST_F(WalkLabelled, ADoorIsToldAndAWayPastNothingIsNone) {
  const std::string door =
      "  - {name: left-of-door, box: {size: [0.1, 1.1, 2.5]}, at: [4, 0.55, 1.25]}\n"
      "  - {name: right-of-door, box: {size: [0.1, 1, 2.5]}, at: [4, 2.5, 1.25]}\n";
  const RunResult through = across(door);
  const PassedThings passed = findPassed(through);
  const auto doors = std::count_if(passed.gaps.begin(), passed.gaps.end(),
                                   [](const PassedGap& gap) { return gap.door; });
  EXPECT_EQ(doors, 1);
  EXPECT_NE(captionOf(through, passed).find("through a door"), std::string::npos);
  const RunResult beside = walk("", "start: {at: [0.8, 1.5]}\ngoal: {at: [2, 1.5]}\n");
  EXPECT_TRUE(findPassed(beside).gaps.empty());
}

// Headings of a body at rest differ by their rounding from frame to frame.
TEST_F(WalkLabelled, WhoStandsStillDoesNotTurnOnTheSpot) {
  for (int i = 0; i < 8; ++i) {
    const RunResult run = walk(
        "", "start: {at: [0.8, 0.6]}\ngoal: {at: [4.1, " + std::to_string(0.9 + 0.1 * i) + "]}\n");
    const FrameLabels labels = labelFrames(run, false);
    const auto turning = std::count(labels.activity.begin(), labels.activity.end(),
                                    static_cast<int32_t>(Activity::kTurn));
    EXPECT_EQ(turning, 0) << i;
    EXPECT_EQ(findPassed(run).turns_on_spot, 0) << i;
  }
}

TEST_F(WalkLabelled, StepsAreCountedOneByOne) {
  std::string stairs;
  for (int step = 1; step <= 3; ++step) {
    stairs += "  - {name: step-" + std::to_string(step) + ", box: {size: [" +
              std::to_string(2.6 - 0.3 * step) + ", 3, 0.17]}, at: [" +
              std::to_string(6 - 0.5 * (2.6 - 0.3 * step)) + ", 1.5, " +
              std::to_string(0.17 * step - 0.085) + "]}\n";
  }
  const RunResult up =
      walk(stairs, "start: {at: [0.8, 0.6], heading: 0}\ngoal: {at: [5.2, 0.6], heading: 0}\n");
  EXPECT_EQ(findPassed(up).flights, std::vector<int>{3});
  EXPECT_NE(captionOf(up, findPassed(up)).find("climbs three steps"), std::string::npos);
  const FrameLabels labels = labelFrames(up, false);
  EXPECT_EQ(std::count(labels.activity.begin(), labels.activity.end(),
                       static_cast<int32_t>(Activity::kDescend)),
            0);
  EXPECT_GT(std::count(labels.activity.begin(), labels.activity.end(),
                       static_cast<int32_t>(Activity::kClimb)),
            20);
}

TEST_F(WalkLabelled, CamerasStandInTheRoomAndSeeTheWalk) {
  const RunResult run = walk("", "start: {at: [0.8, 0.6]}\ngoal: {at: [2.2, 0.6]}\n");
  const auto cameras = suggestCameras(run);
  ASSERT_FALSE(cameras.empty());
  for (const CameraView& view : cameras) {
    EXPECT_GE(view.seen, kLeastSeen);
    EXPECT_LE(view.field_of_view, kWidestView);
    EXPECT_GT(view.position.x(), 0.0);
    EXPECT_LT(view.position.x(), 6.0);
    EXPECT_GT(view.position.y(), 0.0);
    EXPECT_LT(view.position.y(), 3.0);
  }
}

TEST_F(WalkLabelled, TheirFilesSayWhoseMotionsTheyAre) {
  const RunResult run = across();
  const WalkLabels labels = labelWalk(run, true);
  std::ostringstream out;
  writeLabelsJson(out, run, labels);
  const auto json = nlohmann::json::parse(out.str());
  ASSERT_FALSE(json.at("motions").empty());
  for (const auto& motion : json.at("motions")) {
    EXPECT_NE(motion.at("credit"), "");
    const std::string credit =
        motion.at("licence").get<std::string>() + ": " + motion.at("credit").get<std::string>();
    EXPECT_NE(std::find(json.at("credits").begin(), json.at("credits").end(), credit),
              json.at("credits").end());
  }
}

TEST(WalkRow, IsReadAsItWasWrittenWhateverItsNamesHold) {
  WalkRow row;
  row.key = "0123456789abcdef";
  row.scene = "a \"room\", <script>\n\xe6\x88\xbf\xe9\x97\xb4.yaml";
  row.actions = {"carry", "wave, twice"};
  row.status = "no_walk";
  row.reason = "in\r\nthe way";
  row.start = Eigen::Vector3d(1, 2, 3);
  const WalkRow read = readRow(rowJson(row), "row.json");
  EXPECT_EQ(rowJson(read), rowJson(row));
  EXPECT_EQ(read.scene, row.scene);
  EXPECT_EQ(read.goal, std::nullopt);
  const std::string csv = rowCsv(row);
  EXPECT_NE(csv.find("\"a \"\"room\"\", <script>"), std::string::npos);
  EXPECT_THROW(readRow("{}", "row.json"), InputError);
}

}  // namespace
}  // namespace amble
