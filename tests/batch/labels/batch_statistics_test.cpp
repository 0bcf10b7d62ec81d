// What the walks of a batch are like.

#include "batch/labels/batch_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <pugixml.hpp>
#include <sstream>

#include "base/error.h"

namespace amble {
namespace {

WalkRow walk(double length, double duration) {
  WalkRow row;
  row.scene = "room.yaml";
  row.status = "solved";
  row.length = length;
  row.duration = duration;
  row.steps = 4;
  return row;
}

WalkRow refused(const std::string& status, const std::string& rule) {
  WalkRow row;
  row.scene = "room.yaml";
  row.status = status;
  row.rule = rule;
  return row;
}

const Measure& measureOf(const BatchStatistics& all, const std::string& name) {
  return *std::find_if(all.measures.begin(), all.measures.end(),
                       [&](const Measure& measure) { return measure.name == name; });
}

TEST(BatchStatistics, OfNothingThereIsNothingToTellAndADrawing) {
  const BatchStatistics none = statisticsOf({});
  EXPECT_EQ(none.walks, 0);
  std::ostringstream out;
  writeStatisticsPlot(out, none, "none");
  pugi::xml_document drawing;
  EXPECT_TRUE(drawing.load_string(out.str().c_str()));
}

TEST(BatchStatistics, RefusalsAreCountedByRuleAndCountInNoFigure) {
  const std::vector<WalkRow> rows = {walk(3.0, 2.0), refused("no_walk", "contact"),
                                     refused("no_walk", "contact"), refused("start_blocked", "")};
  const BatchStatistics all = statisticsOf(rows);
  EXPECT_EQ(all.walks, 4);
  EXPECT_EQ(all.solved, 1);
  EXPECT_EQ(all.refusals, (Counts{{"contact", 2}, {"start_blocked", 1}}));
  EXPECT_EQ(all.statuses, (Counts{{"no_walk", 2}, {"solved", 1}, {"start_blocked", 1}}));
  for (const Measure& measure : all.measures) EXPECT_EQ(measure.values.size(), 1u) << measure.name;
  EXPECT_DOUBLE_EQ(measureOf(all, "mean speed").values[0], 1.5);
  EXPECT_DOUBLE_EQ(measureOf(all, "step length").values[0], 0.75);
  EXPECT_DOUBLE_EQ(measureOf(all, "cadence").values[0], 120.0);
}

TEST(BatchStatistics, OrderOfTheRowsDoesNotMatter) {
  std::vector<WalkRow> rows;
  for (int i = 0; i < 20; ++i) rows.push_back(walk(1.0 + i % 7, 1.0 + i % 5));
  std::ostringstream one, other;
  writeStatisticsPlot(one, statisticsOf(rows), "walks");
  std::reverse(rows.begin(), rows.end());
  writeStatisticsPlot(other, statisticsOf(rows), "walks");
  EXPECT_EQ(one.str(), other.str());
}

class HistogramOf : public testing::TestWithParam<std::vector<double>> {};

TEST_P(HistogramOf, HasEveryValueInTheBinThatHoldsIt) {
  constexpr int kMost = 24;
  const Measure measure{"length", "m", GetParam()};
  const Histogram bins = histogramOf(measure, kMost);
  ASSERT_FALSE(bins.counts.empty());
  EXPECT_LE(bins.counts.size(), static_cast<size_t>(kMost));
  EXPECT_EQ(std::accumulate(bins.counts.begin(), bins.counts.end(), 0),
            static_cast<int>(measure.values.size()));
  const double slack = 1e-6 * bins.width;  // edges are multiples of a decimal number
  for (size_t i = 0; i < bins.counts.size(); ++i) {
    const double from = bins.from + bins.width * static_cast<double>(i);
    const auto within = std::count_if(
        measure.values.begin(), measure.values.end(),
        [&](double value) { return value >= from - slack && value < from + bins.width + slack; });
    EXPECT_GE(within, bins.counts[i]) << "bin " << i;
  }
}

TEST_P(HistogramOf, IsAsWideAsARoundNumber) {
  const double width = histogramOf({"length", "m", GetParam()}, 24).width;
  const double digit = width / std::pow(10.0, std::floor(std::log10(width) + 1e-9));
  EXPECT_TRUE(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 ||
              std::abs(digit - 5) < 1e-6)
      << width;
}

INSTANTIATE_TEST_SUITE_P(Values, HistogramOf,
                         testing::Values(std::vector<double>{1.6}, std::vector<double>{0, 0, 0},
                                         std::vector<double>{-0.3, 0.1, 0.7},
                                         std::vector<double>{0.0003, 0.00031, 0.00047},
                                         std::vector<double>{2, 3, 3, 8, 1000},
                                         std::vector<double>{1e5, 1e5 + 1e-3}));

TEST(BatchStatistics, SharesOfASpreadAscend) {
  for (int count = 1; count < 30; ++count) {
    Measure measure{"length", "m", {}};
    for (int i = 0; i < count; ++i) measure.values.push_back(i * i);
    const Spread spread = spreadOf(measure);
    EXPECT_LE(spread.least, spread.tenth);
    EXPECT_LE(spread.tenth, spread.median);
    EXPECT_LE(spread.median, spread.ninetieth);
    EXPECT_LE(spread.ninetieth, spread.most);
    EXPECT_EQ(spread.most, (count - 1) * (count - 1));
  }
}

TEST(BatchStatistics, WhatIsNoLabelsIsAnErrorWithItsFile) {
  BatchStatistics all;
  for (const char* text : {"", "{", "[]", "{\"frame_time\": \"x\"}",
                           "{\"frame_time\": 0.1, \"frames\": 3, \"activities\": [3]}"}) {
    try {
      addLabels(text, "labels.json", all);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), "labels.json");
    }
  }
}

TEST(BatchStatistics, TimesOfLabelsAddUp) {
  BatchStatistics all;
  const std::string labels =
      R"({"frame_time": 0.5, "frames": 5, "motions": [{"motion": "walk", "share": 0.8},
          {"motion": "turn", "share": 0.2}, {"motion": "start", "share": 0}],
          "activities": [{"activity": "stand", "from": 0, "to": 0.5},
                         {"activity": "walk", "from": 1, "to": 2}]})";
  for (int i = 0; i < 2; ++i) addLabels(labels, "labels.json", all);
  EXPECT_EQ(all.activities, (Times{{"stand", 2.0}, {"walk", 3.0}}));
  EXPECT_EQ(all.motions, (Times{{"turn", 1.0}, {"walk", 4.0}}));
}

TEST(BatchStatistics, NamesOfAnyKindGiveADrawing) {
  std::vector<WalkRow> rows;
  for (const char* name :
       {"<script>&\"'", "комната с очень длинным названием и столом.yaml", "\x01\xff\n", ""}) {
    rows.push_back(walk(2.0, 2.0));
    rows.back().scene = name;
    rows.push_back(refused("no_walk", name));
  }
  std::ostringstream out;
  writeStatisticsPlot(out, statisticsOf(rows), "<a & b>");
  pugi::xml_document drawing;
  ASSERT_TRUE(drawing.load_string(out.str().c_str()));
  EXPECT_STREQ(drawing.child("svg").child_value("title"), "<a & b>");
  EXPECT_FALSE(drawing.select_node("//script"));
}

TEST(BatchStatistics, MoreNamesThanThereIsRoomForAreOneBar) {
  std::vector<WalkRow> rows;
  constexpr int kScenes = 10000;
  for (int i = 0; i < kScenes; ++i) {
    rows.push_back(walk(2.0, 2.0));
    rows.back().scene = "room-" + std::to_string(i) + ".yaml";
  }
  std::ostringstream out;
  writeStatisticsPlot(out, statisticsOf(rows), "many");
  EXPECT_LT(out.str().size(), 100'000u);
  EXPECT_NE(out.str().find("9989 others"), std::string::npos);
}

}  // namespace
}  // namespace amble
