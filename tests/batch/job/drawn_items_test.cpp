// Which walks a shard and a sample are of.

#include <cmath>
#include <numeric>

#include "tests/batch/small_job.h"

namespace amble {
namespace {

using DrawnItems = SmallJob;

// As many as asked for, each of its own seed: nothing else differs.
std::vector<BatchItem> numbered(int count) {
  std::vector<BatchItem> items(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) items[static_cast<size_t>(i)].number = i;
  return items;
}

TEST_F(DrawnItems, ShardsOfAnyCountAreAPartitionInOrderAndAsLargeAsOneAnother) {
  for (const int size : {0, 1, 2, 3, 10, 97, 1000}) {
    const std::vector<BatchItem> items = numbered(size);
    for (int count = 1; count <= 2 * std::min(size, 40) + 3; ++count) {
      int next = 0;
      size_t least = items.size(), most = 0;
      for (int index = 1; index <= count; ++index) {
        const auto part = itemsOf(items, {index, count});
        least = std::min(least, part.size());
        most = std::max(most, part.size());
        for (const BatchItem& item : part) EXPECT_EQ(item.number, next++);
      }
      EXPECT_EQ(next, size) << count;
      EXPECT_LE(most - least, 1u) << size << " in " << count;
    }
  }
}

// Each value of an axis is drawn as often as any other: chi-squared at 1 in 10^5, fixed seed.
TEST_F(DrawnItems, ASampleTakesEachValueOfAnAxisAsOften) {
  const BatchJob walks = twoRooms(
      "heights: {from: 1.5, to: 1.9}\nspeeds: [0.8, 1, 1.2, 1.4]\nseeds: 5\nsample: 4000\n");
  const std::vector<BatchItem> items = listItems(walks);
  ASSERT_EQ(items.size(), 4000u);
  const auto evenly = [&](int bins, auto bin_of) {
    std::vector<int> counts(static_cast<size_t>(bins), 0);
    for (const BatchItem& item : items) ++counts.at(static_cast<size_t>(bin_of(item)));
    const double expected = 4000.0 / bins;
    double chi = 0.0;
    for (const int count : counts) chi += (count - expected) * (count - expected) / expected;
    const double freedom = bins - 1;
    return chi < freedom + 4.3 * std::sqrt(2.0 * freedom) + 8.0;
  };
  EXPECT_TRUE(evenly(2, [](const BatchItem& item) { return item.scene; }));
  EXPECT_TRUE(evenly(2, [](const BatchItem& item) { return item.way; }));
  EXPECT_TRUE(evenly(5, [](const BatchItem& item) { return static_cast<int>(item.seed) - 1; }));
  EXPECT_TRUE(evenly(
      4, [](const BatchItem& item) { return static_cast<int>(std::lround(item.speed * 5)) - 4; }));
  EXPECT_TRUE(evenly(8, [](const BatchItem& item) {
    return std::min(7, static_cast<int>((item.height - 1.5) / 0.05));
  }));
}

TEST_F(DrawnItems, HeightsOfARangeAreInItAndWholeMillimetres) {
  const BatchJob walks =
      twoRooms("heights: {from: 1.5, to: 1.9}\nspeeds: {from: 0.7, to: 0.9}\nsample: 500\n");
  for (const BatchItem& item : listItems(walks)) {
    EXPECT_GE(item.height, 1.5);
    EXPECT_LE(item.height, 1.9);
    EXPECT_GE(item.speed, 0.7);
    EXPECT_LE(item.speed, 0.9);
    EXPECT_NEAR(item.height * 1000, std::round(item.height * 1000), 1e-9);
  }
}

// Who wants more later keeps what is there: item i depends on the seed and i alone.
TEST_F(DrawnItems, ASmallerSampleIsInALargerOneOfTheSameSeed) {
  const auto drawn = [&](int count, int seed) {
    const BatchJob walks =
        twoRooms("heights: {from: 1.5, to: 1.9}\nsample: " + std::to_string(count) +
                 "\nseed: " + std::to_string(seed) + "\n");
    std::set<double> heights;
    for (const BatchItem& item : listItems(walks)) heights.insert(item.height * 10 + item.scene);
    return heights;
  };
  const auto few = drawn(30, 4), many = drawn(80, 4), other = drawn(30, 5);
  EXPECT_TRUE(std::includes(many.begin(), many.end(), few.begin(), few.end()));
  EXPECT_EQ(few, drawn(30, 4));
  EXPECT_NE(few, other);
}

TEST_F(DrawnItems, ItemsOfOneWalkerAreTogetherWhateverIsDrawn) {
  for (const char* how : {"seeds: 2\nheights: [1.8, 1.6]\nspeeds: [1, 0.8]\n",
                          "seeds: 3\nheights: [1.8, 1.6]\nspeeds: [1, 0.8]\nsample: 25\n"}) {
    const std::vector<BatchItem> items = listItems(twoRooms(how));
    for (size_t i = 0; i < items.size(); ++i) {
      EXPECT_EQ(items[i].number, static_cast<int>(i));
      for (size_t k = i + 1; k < items.size(); ++k)
        if (sameWalker(items[i], items[k])) {
          for (size_t j = i; j < k; ++j) EXPECT_TRUE(sameWalker(items[i], items[j]));
        }
    }
  }
}

TEST_F(DrawnItems, WaysOfTheirOwnComeFirstAndDrawnOnesAreNumbered) {
  const BatchJob walks = twoRooms("ways: {draw: 2}\n");
  std::vector<std::string> names;
  for (const BatchItem& item : listItems(walks)) {
    names.push_back(wayName(walks, item));
    const bool drawn = drawnWay(walks, item) >= 0;
    EXPECT_EQ(drawn, item.way >= 2);
    EXPECT_EQ(scenarioOf(walks, item).has_ends, !drawn);
  }
  const std::vector<std::string> once = {"there", "across", "drawn-1", "drawn-2"};
  ASSERT_EQ(names.size(), 8u);
  for (size_t i = 0; i < names.size(); ++i) EXPECT_EQ(names[i], once[i % 4]);
}

TEST_F(DrawnItems, WhereNoWayCanBeDrawnTheRowSaysHowFarItWasToLead) {
  const auto reason = [&](const std::string& ways) {
    const BatchJob walks = job("scenes: [scene.yaml]\nfps: 30\nways: {draw: 1, " + ways + "}\n");
    const std::string out = "out-" + std::to_string(ways.size());
    make(walks, out);
    const WalkRow row = rows(walks, out).at(0);
    EXPECT_EQ(row.status, "no_way");
    return row.reason;
  };
  EXPECT_TRUE(holds(reason("least: 20"), "leads between, 20 m apart or more"));
  EXPECT_TRUE(holds(reason("least: 20, most: 25"), "leads between, 20 to 25 m apart"));
}

// Every mistake of a job's file: its line, and what was expected.
TEST_F(DrawnItems, WhatIsWrongInAJobIsToldWithItsLine) {
  const std::string scenes = "scenes: [scene.yaml]\n";
  const std::vector<std::pair<std::string, const char*>> wrong = {
      {"heights: [1.7]\n", "scenes"},
      {scenes + "heigths: [1.7]\n", "job.yaml:2: "},
      {scenes + "heights: []\n", "job.yaml:2: 'heights' is empty"},
      {scenes + "heights: [0.2]\n", "job.yaml:2: "},
      {scenes + "heights: [3]\n", "job.yaml:2: "},
      {scenes + "heights: {from: 1.8, to: 1.6}\nsample: 2\n", "job.yaml:2: "},
      {scenes + "speeds: [9]\n", "job.yaml:2: "},
      {scenes + "speeds: [fast]\n", "job.yaml:2: "},
      {scenes + "seeds: []\n", "job.yaml:2: "},
      {scenes + "seeds: 0\n", "job.yaml:2: "},
      {scenes + "ways: {draw: -1}\n", "job.yaml:2: "},
      {scenes + "ways: {draw: 1, least: 5, most: 3}\n", "job.yaml:2: "},
      {scenes + "fps: 500\n", "job.yaml:2: "},
      {scenes + "formats: [dvd]\n", "job.yaml:2: "},
      {scenes + "planner: {roadmap: mine}\n", "job.yaml:2: "},
      {scenes + "planner: {name: guess}\n", "job.yaml:2: "},
      {scenes + "sample: -2\n", "job.yaml:2: "},
      {"scenes: []\n", "job.yaml:1: "},
      {"scenes: [no-*.yaml]\n", "job.yaml:1: no file is called 'no-*.yaml'"},
      {"scenes:\n  - {scene: scene.yaml, bounds: {min: [1, 1], max: [1, 2]}}\n", "job.yaml:2: "}};
  for (const auto& [text, expected] : wrong) {
    const std::string said = inputError([&] { listItems(job(text)); });
    EXPECT_TRUE(holds(said, expected)) << text << said;
    EXPECT_TRUE(holds(said, "expected") || holds(said, "needs")) << said;
  }
}

TEST_F(DrawnItems, ARangeWithoutASampleIsNoProduct) {
  const std::string said =
      inputError([&] { listItems(job("scenes: [scene.yaml]\nheights: {from: 1.5, to: 1.8}\n")); });
  EXPECT_TRUE(holds(said, "sample")) << said;
}

TEST_F(DrawnItems, MergingIsTheSameInWhateverOrderTheShardsCame) {
  const BatchJob walks = twoRooms();
  std::map<std::string, std::string> first;
  for (const std::vector<int>& order :
       {std::vector<int>{1, 2, 3, 4}, {4, 3, 2, 1}, {2, 2, 4, 1, 3}}) {
    std::filesystem::remove_all(folder_ / "out");
    for (const int index : order) {
      BatchOptions options;
      options.shard = {index, 4};
      make(walks, "out", options);
    }
    EXPECT_EQ(mergeBatch(walks, folder_ / "out", {}).missing, 0);
    const auto once = filesIn("out");
    EXPECT_EQ(mergeBatch(walks, folder_ / "out", {}).swept, 0);
    EXPECT_EQ(filesIn("out"), once) << "merging twice is merging once";
    if (first.empty()) first = once;
    EXPECT_EQ(once, first);
  }
}

}  // namespace
}  // namespace amble
