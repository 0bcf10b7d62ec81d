#include "base/large_array.h"

#include <gtest/gtest.h>

#include <new>
#include <numeric>

namespace amble {
namespace {

// Empty, within a page, at the border from where pages are large, and beyond.
constexpr size_t kSizes[] = {0, 1, 1023, (size_t{1} << 20) - 1, size_t{1} << 20, 3'000'001};

TEST(LargeArray, IsZeroAllOverWhateverLayThereBefore) {
  for (int round = 0; round < 3; ++round) {
    for (const size_t size : kSizes) {
      LargeArray<float> array(size);
      ASSERT_EQ(array.size(), size);
      EXPECT_TRUE(std::all_of(array.begin(), array.end(), [](float v) { return v == 0.0f; }));
      std::fill(array.begin(), array.end(), 7.0f);
    }
  }
}

TEST(LargeArray, ACopyIsOfItsOwnAndWhatIsMovedIsTheSame) {
  for (const size_t size : kSizes) {
    LargeArray<int> array(size);
    std::iota(array.begin(), array.end(), 1);
    const LargeArray<int> copy = array;
    std::fill(array.begin(), array.end(), -1);
    const int* const place = array.begin();
    LargeArray<int> moved = std::move(array);
    EXPECT_EQ(moved.begin(), place);
    EXPECT_EQ(array.size(), 0u);
    for (size_t i = 0; i < size; ++i) {
      ASSERT_EQ(copy[i], static_cast<int>(i + 1));
      ASSERT_EQ(moved[i], -1);
    }
    moved = copy;
    EXPECT_TRUE(std::equal(moved.begin(), moved.end(), copy.begin(), copy.end()));
    array = std::move(moved);
    EXPECT_EQ(array.size(), size);
    EXPECT_EQ(moved.size(), 0u);
  }
}

TEST(LargeArray, MoreThanThereIsIsRefused) {
  EXPECT_THROW(LargeArray<char>(size_t{1} << 60), std::bad_alloc);
}

}  // namespace
}  // namespace amble
