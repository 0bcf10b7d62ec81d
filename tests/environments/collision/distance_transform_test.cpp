#include "environments/collision/distance_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace amble {
namespace {

// Values that tell all squares of a window apart, up to a byte's end.
std::vector<uint8_t> squaresUpTo(int window) {
  std::vector<uint8_t> of_square(static_cast<size_t>(window) * window + 1);
  for (size_t s = 0; s < of_square.size(); ++s) of_square[s] = static_cast<uint8_t>(s);
  return of_square;
}

int squareApart(const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
  const Eigen::Vector3i apart = ((a - b).cwiseAbs().array() - 1).cwiseMax(0);
  return apart.squaredNorm();
}

// Each voxel against each occupied one.
std::vector<uint8_t> byDefinition(const std::vector<uint8_t>& voxels, const Eigen::Vector3i& count,
                                  int window, const std::vector<uint8_t>& of_square) {
  std::vector<Eigen::Vector3i> all, occupied;
  for (int k = 0; k < count.z(); ++k)
    for (int j = 0; j < count.y(); ++j)
      for (int i = 0; i < count.x(); ++i) {
        if (voxels[all.size()]) occupied.emplace_back(i, j, k);
        all.emplace_back(i, j, k);
      }
  std::vector<uint8_t> values;
  for (const Eigen::Vector3i& voxel : all) {
    int least = window * window;
    for (const Eigen::Vector3i& other : occupied)
      least = std::min(least, squareApart(voxel, other));
    values.push_back(of_square[least]);
  }
  return values;
}

// Rows shorter and longer than what is done at a time, single voxels along an axis, and windows
// longer than the grid.
TEST(DistanceTransform, IsTheLeastOverAllOccupiedVoxels) {
  std::mt19937_64 generator(41);
  const auto upTo = [&](int most) { return static_cast<int>(1 + generator() % most); };
  for (int n = 0; n < 150; ++n) {
    const Eigen::Vector3i count(upTo(n % 3 == 0 ? 120 : 40), upTo(12), upTo(12));
    const int window = upTo(15);
    std::vector<uint8_t> voxels(static_cast<size_t>(count.prod()), 0);
    for (int things = static_cast<int>(generator() % 4); things > 0; --things)
      voxels[generator() % voxels.size()] = static_cast<uint8_t>(upTo(255));
    const std::vector<uint8_t> of_square = squaresUpTo(window);
    const std::vector<uint8_t> expected = byDefinition(voxels, count, window, of_square);
    transformDistances(voxels, count, window, of_square);
    ASSERT_EQ(voxels, expected) << count.transpose() << ", window " << window;
  }
}

TEST(DistanceTransform, FreeSpaceIsFarAndFullSpaceIsAtNoDistance) {
  const Eigen::Vector3i count(70, 3, 2);
  std::vector<uint8_t> free(static_cast<size_t>(count.prod()), 0), full(free.size(), 7);
  const std::vector<uint8_t> of_square = squaresUpTo(9);
  transformDistances(free, count, 9, of_square);
  EXPECT_EQ(free, std::vector<uint8_t>(free.size(), 81));
  transformDistances(full, count, 9, of_square);
  EXPECT_EQ(full, std::vector<uint8_t>(full.size(), 0));
}

// The longest window, along one axis each: no sum of squares goes over an int16_t's end.
TEST(DistanceTransform, LongestWindowReachesAlongEachAxis) {
  std::vector<uint8_t> of_square(static_cast<size_t>(kLongestWindow) * kLongestWindow + 1, 0);
  for (int d = 0; d <= kLongestWindow; ++d) of_square[static_cast<size_t>(d) * d] = d;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Vector3i count(1, 1, 1);
    count[axis] = 130;
    std::vector<uint8_t> line(130, 0);
    line[40] = 1;
    transformDistances(line, count, kLongestWindow, of_square);
    for (int i = 0; i < 130; ++i)
      EXPECT_EQ(line[i], std::clamp(std::abs(i - 40) - 1, 0, kLongestWindow)) << axis << " " << i;
  }
}

}  // namespace
}  // namespace amble
