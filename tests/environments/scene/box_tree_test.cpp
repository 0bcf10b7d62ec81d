#include "environments/scene/box_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace amble {
namespace {

Eigen::AlignedBox3d randomBox(std::mt19937_64& generator, double largest) {
  std::uniform_real_distribution<double> place(-10, 10), size(0, largest);
  const Eigen::Vector3d low(place(generator), place(generator), place(generator));
  return {low, low + Eigen::Vector3d(size(generator), size(generator), size(generator))};
}

std::vector<int> allThatMeet(const std::vector<Eigen::AlignedBox3d>& boxes,
                             const Eigen::AlignedBox3d& box) {
  std::vector<int> found;
  for (size_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].isEmpty() && boxes[i].intersects(box)) found.push_back(static_cast<int>(i));
  return found;
}

TEST(BoxTree, FindsWhatALoopOverAllFindsInItsOrder) {
  std::mt19937_64 generator(1);
  for (const int count : {1, 2, 4, 5, 9, 100, 1000}) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (int i = 0; i < count; ++i) boxes.push_back(randomBox(generator, i % 7 == 0 ? 15.0 : 1.0));
    const BoxTree tree(boxes);
    std::vector<int> found;
    for (int k = 0; k < 200; ++k) {
      const Eigen::AlignedBox3d box = randomBox(generator, 3.0);
      tree.find(box, found);
      EXPECT_EQ(found, allThatMeet(boxes, box)) << count;
    }
  }
}

TEST(BoxTree, BoxesThatTouchMeet) {
  const BoxTree tree({{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)}});
  std::vector<int> found;
  tree.find({Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(2, 1, 1)}, found);
  EXPECT_EQ(found.size(), 1u);
}

TEST(BoxTree, ABoxWithoutEndMeetsAllButTheEmptyOnes) {
  std::mt19937_64 generator(2);
  std::vector<Eigen::AlignedBox3d> boxes(10);
  for (int i = 0; i < 10; i += 2) boxes[i] = randomBox(generator, 1.0);
  const Eigen::Vector3d far = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  std::vector<int> found;
  BoxTree(boxes).find({-far, far}, found);
  EXPECT_EQ(found, (std::vector<int>{0, 2, 4, 6, 8}));
}

TEST(BoxTree, OfManyBoxesInOnePlaceIsBuilt) {
  const std::vector<Eigen::AlignedBox3d> boxes(
      1000, {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)});
  std::vector<int> found;
  BoxTree(boxes).find(boxes[0], found);
  EXPECT_EQ(found.size(), boxes.size());
}

TEST(BoxTree, OfNothingFindsNothing) {
  std::vector<int> found = {1};
  BoxTree().find({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)}, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace amble
