// What comes out of buckets is what comes out of one heap.
#include "base/bucket_queue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <queue>

#include "base/sample_stream.h"

namespace amble {
namespace {

using Entry = std::pair<float, int>;
using Heap = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

// Puts in what is drawn by value(least so far), and takes out now and then.
template <typename Value>
void expectAsOfOneHeap(std::uint64_t seed, float breadth, Value value) {
  SampleStream random(seed, 0);
  BucketQueue queue(breadth);
  Heap heap;
  float least = 0.0f;
  for (int i = 0; i < 20000; ++i) {
    const int number = random.below(500);  // some are in it more than once
    const float one = value(random, least);
    queue.push(one, number);
    heap.emplace(one, number);
    while (!heap.empty() && random.uniform(0, 1) < (i < 15000 ? 0.45 : 0.6)) {
      ASSERT_FALSE(queue.empty());
      least = heap.top().first;
      ASSERT_EQ(queue.pop(), heap.top().second) << i;
      heap.pop();
    }
  }
  for (; !heap.empty(); heap.pop()) ASSERT_EQ(queue.pop(), heap.top().second);
  EXPECT_TRUE(queue.empty());
}

TEST(BucketQueue, GivesWhatOneHeapGivesAsSearchesFillIt) {
  for (const float breadth : {0.001f, 0.05f, 3.0f}) {
    expectAsOfOneHeap(1, breadth, [](SampleStream& random, float least) {
      return least + static_cast<float>(random.uniform(0.0, 0.5));
    });
  }
}

TEST(BucketQueue, GivesWhatOneHeapGivesWhereLessComesAfterMore) {
  expectAsOfOneHeap(2, 0.05f, [](SampleStream& random, float) {
    return static_cast<float>(random.uniform(0.0, 40.0));
  });
}

TEST(BucketQueue, OfEqualValuesTheSmallestNumberComesFirst) {
  expectAsOfOneHeap(3, 0.05f, [](SampleStream& random, float) {
    return 0.25f * static_cast<float>(random.below(4));
  });
}

TEST(BucketQueue, HoldsWhatIsFarBeyondItsBuckets) {
  expectAsOfOneHeap(4, 1e-3f, [](SampleStream& random, float) {
    return static_cast<float>(std::exp(random.uniform(-5.0, 80.0)));
  });
}

}  // namespace
}  // namespace amble
