#include "animation/body/skeleton.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/animation/random_clip.h"

namespace amble {
namespace {

Joint joint(const std::string& name, int parent, const Eigen::Vector3d& offset = {0, 0, 0}) {
  Joint made;
  made.name = name;
  made.parent = parent;
  made.offset = offset;
  return made;
}

TEST(Skeleton, RefusesWhatIsNoTree) {
  EXPECT_THROW(Skeleton(std::vector<Joint>{}), std::invalid_argument);
  EXPECT_THROW(Skeleton({joint("root", 0)}), std::invalid_argument);
  EXPECT_THROW(Skeleton({joint("root", -1), joint("second root", -1)}), std::invalid_argument);
  EXPECT_THROW(Skeleton({joint("root", -1), joint("own parent", 1)}), std::invalid_argument);
  EXPECT_THROW(Skeleton({joint("root", -1), joint("a", 2), joint("b", 0)}), std::invalid_argument);
}

TEST(Skeleton, RefusesNumbersThatAreNotFiniteAndOrdersThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Skeleton({joint("root", -1), joint("a", 0, {0, nan, 0})}), std::invalid_argument);
  Joint tip = joint("root", -1);
  tip.end_sites.emplace_back(0, 0, std::numeric_limits<double>::infinity());
  EXPECT_THROW(Skeleton({tip}), std::invalid_argument);
  Joint twice = joint("root", -1);
  twice.order = {'X', 'X', 'Y'};
  EXPECT_THROW(Skeleton({twice}), std::invalid_argument);
}

TEST(Skeleton, FindsAJointByItsVeryName) {
  const Skeleton skeleton({joint("Hips", -1), joint("Spine", 0), joint("spine", 1)});
  EXPECT_EQ(skeleton.find("Spine"), 1);
  EXPECT_EQ(skeleton.find("spine"), 2);
  EXPECT_EQ(skeleton.find("SPINE"), -1);
}

TEST(Skeleton, AncestorsAreThoseOnTheWayToTheRoot) {
  Generator generator(11);
  const Skeleton skeleton = randomSkeleton(generator, 40);
  for (int j = 0; j < skeleton.size(); ++j) {
    std::vector<bool> on_the_way(skeleton.size(), false);
    for (int a = j; a >= 0; a = skeleton.joint(a).parent) on_the_way[a] = true;
    for (int a = 0; a < skeleton.size(); ++a) EXPECT_EQ(skeleton.isAncestor(a, j), on_the_way[a]);
  }
}

TEST(Skeleton, ScalingIsOfOffsetsAndTips) {
  Generator generator(12);
  const Skeleton skeleton = randomSkeleton(generator, 20), larger = skeleton.scaled(2.0);
  for (int j = 0; j < skeleton.size(); ++j) {
    EXPECT_EQ(larger.joint(j).offset, 2.0 * skeleton.joint(j).offset);
    for (size_t i = 0; i < skeleton.joint(j).end_sites.size(); ++i) {
      EXPECT_EQ(larger.joint(j).end_sites[i], 2.0 * skeleton.joint(j).end_sites[i]);
    }
  }
}

}  // namespace
}  // namespace amble
