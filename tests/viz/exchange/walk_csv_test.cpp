#include "viz/exchange/walk_csv.h"

#include <gtest/gtest.h>

#include <locale>
#include <sstream>
#include <utility>

#include "base/rotation.h"
#include "tests/viz/test_walk.h"

namespace amble {
namespace {

using Rows = std::vector<std::vector<std::string>>;

// A reader of RFC 4180 that takes nothing else.
Rows rowsOf(const std::string& text) {
  Rows rows;
  std::string field;
  bool quoted = false;
  const auto endField = [&] { rows.back().push_back(std::exchange(field, "")); };
  for (size_t i = 0; i < text.size(); ++i) {
    if (i == 0 || (!quoted && text.compare(i - 1, 1, "\n") == 0)) rows.emplace_back();
    const char c = text[i];
    if (quoted && c == '"' && text.compare(i, 2, "\"\"") == 0) {
      field += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (quoted) {
      field += c;
    } else if (c == ',') {
      endField();
    } else if (text.compare(i, 2, "\r\n") == 0) {
      endField();
      ++i;
    } else {
      EXPECT_TRUE(c != '\r' && c != '\n') << "a line's end that is none at " << i;
      field += c;
    }
  }
  return rows;
}

double number(const std::string& field) { return std::stod(field); }

std::unique_ptr<TestWalk> walkWithUnevenNumbers() {
  auto walk = makeTestWalk();
  for (int i = 0; i < walk->animation.size(); ++i) {
    walk->animation.poses.rotations(i)[0] =
        Eigen::AngleAxisd(0.1 * i / 7, Eigen::Vector3d::UnitZ());
    FrameState& state = walk->animation.states[i];
    state.position = {1 + 4.0 * i / 120, 2, -0.0};
    state.heading = 0.1 * i / 7;
    state.planted = {i % 2 == 0, i % 3 == 0};
  }
  return walk;
}

const std::vector<std::string> kNames = {"hips", "left", "right"};

TEST(WalkCsv, EveryJointReadsBackToTheLastBit) {
  const auto walk = walkWithUnevenNumbers();
  std::ostringstream out;
  writeJointsCsv(out, walk->view, kNames);
  const Rows rows = rowsOf(out.str());
  ASSERT_EQ(rows.size(), 1u + walk->animation.size());
  EXPECT_EQ(rows[0][5], "left x [m]");
  std::vector<JointFrame> joints(3);
  for (int frame = 0; frame < walk->animation.size(); ++frame) {
    forwardKinematics(walk->skeleton, walk->animation.poses[frame], joints);
    const std::vector<std::string>& row = rows[frame + 1];
    ASSERT_EQ(row.size(), 2u + 9u);
    for (int i = 0; i < 9; ++i) EXPECT_EQ(number(row[2 + i]), joints[i / 3].p_WJ[i % 3]);
  }
}

TEST(WalkCsv, ThePathHasARowAFrameInDegrees) {
  const auto walk = walkWithUnevenNumbers();
  std::ostringstream out;
  writePathCsv(out, walk->view);
  const Rows rows = rowsOf(out.str());
  ASSERT_EQ(rows.size(), 122u);
  for (int frame = 0; frame <= 120; ++frame) {
    const std::vector<std::string>& row = rows[frame + 1];
    ASSERT_EQ(row.size(), rows[0].size());
    EXPECT_EQ(number(row[3]), 1 + 4.0 * frame / 120);
    EXPECT_EQ(row[5], "0") << "no -0";
    EXPECT_NEAR(number(row[6]), 0.1 * frame / 7 * 180 / kPi, 1e-12);
    EXPECT_EQ(row[9], frame % 2 == 0 ? "1" : "0");
    EXPECT_EQ(row[10], frame % 3 == 0 ? "1" : "0");
  }
}

TEST(WalkCsv, StepsAreOfPrintsThatAFootWasPutDownOn) {
  const auto walk = walkWithUnevenNumbers();
  std::vector<StepMeasure> steps;
  for (size_t i = 1; i < walk->animation.footprints.size(); ++i) {
    Footprint& print = walk->animation.footprints[i];
    print.heading = kPi / 180 * static_cast<double>(i);
    StepMeasure step;
    step.side = print.side;
    step.at = print.position;
    step.stride = 0.5;
    steps.push_back(step);
  }
  std::ostringstream out;
  writeStepsCsv(out, walk->view, steps);
  const Rows rows = rowsOf(out.str());
  ASSERT_EQ(rows.size(), 1 + steps.size());
  for (size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][0], std::to_string(i));
    EXPECT_EQ(rows[i][1], steps[i - 1].side == kLeft ? "left" : "right");
    EXPECT_EQ(number(rows[i][4]), steps[i - 1].at.x());
    EXPECT_NEAR(number(rows[i][7]), static_cast<double>(i), 1e-12) << "the print's heading";
  }
}

TEST(WalkCsv, NamesOfAnyCharactersAreOneFieldEach) {
  const auto walk = makeTestWalk();
  const std::vector<std::string> names = {"a,b \"c\"", "two\r\nlines", "<script> \xe8\x85\xb0"};
  std::ostringstream out;
  writeJointsCsv(out, walk->view, names);
  const Rows rows = rowsOf(out.str());
  ASSERT_EQ(rows[0].size(), 2u + 9u);
  for (size_t joint = 0; joint < names.size(); ++joint)
    EXPECT_EQ(rows[0][2 + 3 * joint], names[joint] + " x [m]");
}

TEST(WalkCsv, NoLocaleChangesANumber) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const auto walk = walkWithUnevenNumbers();
  std::ostringstream plain, german;
  german.imbue(std::locale(german.getloc(), new Comma));
  writePathCsv(plain, walk->view);
  writePathCsv(german, walk->view);
  EXPECT_EQ(plain.str(), german.str());
}

}  // namespace
}  // namespace amble
