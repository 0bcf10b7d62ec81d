#include "batch/job/batch_items.h"

#include "tests/batch/small_job.h"

namespace amble {
namespace {

using BatchItems = SmallJob;

std::vector<std::string> keys(const BatchJob& job, const std::vector<BatchItem>& items) {
  std::vector<std::string> all;
  for (const BatchItem& item : items) {
    const auto& scene = job.scenes[static_cast<size_t>(item.scene)].name;
    all.push_back(itemKey(describeItem(job, item, scene, "library")));
  }
  return all;
}

std::set<std::string> asSet(const std::vector<std::string>& all) {
  return {all.begin(), all.end()};
}

TEST_F(BatchItems, AreTheProductOfTheAxes) {
  const BatchJob walks = twoRooms(
      "heights: [1.6, 1.8]\nspeeds: [0.8, 1, 1.2]\nactions: [[], [carry]]\nseeds: 2\n"
      "ways: {draw: 3}\n");
  const auto items = listItems(walks);
  EXPECT_EQ(items.size(), 2u * 2 * 3 * 2 * 2 * (2 + 3));
  EXPECT_EQ(asSet(keys(walks, items)).size(), items.size());
}

TEST_F(BatchItems, OfASampleAreOfTheProductAndNoTwoTheSame) {
  const std::string axes = "heights: [1.6, 1.8]\nspeeds: [0.8, 1, 1.2]\nseeds: 2\n";
  const BatchJob all = twoRooms(axes), some = twoRooms(axes + "sample: 20\n");
  const auto product = asSet(keys(all, listItems(all)));
  const auto sample = asSet(keys(some, listItems(some)));
  EXPECT_EQ(sample.size(), 20u);
  for (const std::string& key : sample) EXPECT_TRUE(product.count(key) > 0);
  EXPECT_NE(sample, asSet(keys(some, listItems(twoRooms(axes + "sample: 20\nseed: 2\n")))));
  EXPECT_EQ(asSet(keys(all, listItems(twoRooms(axes + "sample: 48\n")))), product);
  EXPECT_NE(inputError([&] { listItems(twoRooms(axes + "sample: 49\n")); }).find("of 48 walks"),
            std::string::npos);
}

TEST_F(BatchItems, OfAllShardsAreThoseOfTheJob) {
  const BatchJob walks = twoRooms("seeds: 5\n");
  const auto items = listItems(walks);
  for (const int count : {1, 2, 7, 40}) {
    std::vector<int> numbers;
    for (int index = 1; index <= count; ++index) {
      const auto part = itemsOf(items, {index, count});
      EXPECT_LE(part.size(), items.size() / static_cast<size_t>(count) + 1);
      for (const BatchItem& item : part) numbers.push_back(item.number);
    }
    ASSERT_EQ(numbers.size(), items.size());
    for (size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], static_cast<int>(i));
  }
}

TEST_F(BatchItems, AreKnownByWhatTheyAreOfAndNotByTheirJob) {
  const BatchJob one = job(std::string("scenes: [{scene: other.yaml, ways: ") + kWays + "}]\n");
  const BatchJob two = twoRooms("");
  const auto wanted = keys(one, listItems(one));
  const auto all = asSet(keys(two, listItems(two)));
  for (const std::string& key : wanted) EXPECT_TRUE(all.count(key) > 0);
  for (const char* other :
       {"fps: 24\n", "speeds: [1]\n", "heights: [1.7]\n", "seeds: [2]\n", "walk: {comfort: 0}\n",
        "planner: {max_failures: 9}\n", "limits: {max_climb: 0.1}\n", "formats: [bvh]\n",
        "planner: {roadmap: shared}\n", "styles: [old-man]\n"}) {
    const BatchJob changed = twoRooms(other);
    for (const std::string& key : keys(changed, listItems(changed)))
      EXPECT_EQ(all.count(key), 0u) << other;
  }
}

}  // namespace
}  // namespace amble
