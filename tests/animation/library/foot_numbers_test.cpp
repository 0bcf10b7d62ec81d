#include "animation/library/foot_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "animation/library/motion_library_reader.h"

namespace amble {
namespace {

TEST(FootNumbers, OfAFootAreThatFootButForItsPhases) {
  const MotionLibrary library = openMotionLibrary("default");
  const auto walk = std::find_if(library.motions.begin(), library.motions.end(),
                                 [](const Motion& m) { return m.kind == MotionKind::kWalk; });
  FootCycle foot = walk->cycle.feet[kRight];
  for (int k = 0; k < FootCycle::kToeSplines; ++k) foot.toes[k] = 0.1 * k;
  const FootCycle again = footOf(footNumbers(foot));
  EXPECT_EQ(again.slip, foot.slip);
  EXPECT_EQ(again.progress, foot.progress);
  EXPECT_EQ(again.height, foot.height);
  EXPECT_EQ(again.sideways, foot.sideways);
  EXPECT_EQ(again.roll, foot.roll);
  EXPECT_EQ(again.yaw, foot.yaw);
  EXPECT_EQ(again.pitch, foot.pitch);
  EXPECT_EQ(again.toes, foot.toes);
  EXPECT_EQ(again.strike, 0.0);
}

}  // namespace
}  // namespace amble
