#include "batch/run/check_batch.h"

#include "batch/run/batch_status.h"
#include "tests/batch/small_job.h"

namespace amble {
namespace {

using CheckBatch = SmallJob;

TEST_F(CheckBatch, TellsAWalkThatWasPutInTheWayOfSomething) {
  const BatchJob walks = twoRooms();
  make(walks, "out");
  const auto good = checkBatch(walks, folder_ / "out", 100, 1, {});
  ASSERT_EQ(good.size(), 4u);
  for (const CheckedWalk& walk : good) EXPECT_TRUE(walk.holds()) << walk.first << walk.wrong;
  // The walk around one room's pillar goes through that of the other.
  const auto fileOf = [&](int item) {
    const std::string key = rows(walks, "out")[static_cast<size_t>(item)].key;
    return folder_ / "out" / BatchFolder::nameOf(key) / "walk.bvh";
  };
  std::filesystem::copy_file(fileOf(3), fileOf(1),
                             std::filesystem::copy_options::overwrite_existing);
  const auto bad = checkBatch(walks, folder_ / "out", 100, 1, {});
  EXPECT_FALSE(bad[1].holds());
  EXPECT_NE((bad[1].first + bad[1].wrong).size(), 0u);
  EXPECT_TRUE(bad[0].holds() && bad[2].holds() && bad[3].holds());
}

TEST_F(CheckBatch, LooksAtAsManyAsItIsToldAndAtOthersByAnotherSeed) {
  const BatchJob walks = twoRooms();
  make(walks, "out");
  std::set<std::vector<int>> samples;
  for (const std::uint64_t seed : {1, 2, 3}) {
    std::vector<int> items;
    for (const CheckedWalk& walk : checkBatch(walks, folder_ / "out", 2, seed, {}))
      items.push_back(walk.item);
    EXPECT_EQ(items.size(), 2u);
    samples.insert(items);
  }
  EXPECT_GT(samples.size(), 1u);
}

TEST_F(CheckBatch, StatusCountsWhatIsThere) {
  const BatchJob walks = twoRooms();
  EXPECT_EQ(batchStatus(walks, folder_ / "out", {}).there, 0);
  BatchOptions options;
  options.shard = {2, 2};
  make(walks, "out", options);
  const BatchStatus half = batchStatus(walks, folder_ / "out", {});
  EXPECT_EQ(half.there, 2);
  EXPECT_EQ(half.total, 4);
}

}  // namespace
}  // namespace amble
