#include "animation/synthesis/animation_buffer.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

/// A buffer of frames in which a foot is planted where `at` says: at[side][frame].
AnimationBuffer bufferOf(const std::array<std::vector<double>, 2>& at, double arc = 0.0) {
  AnimationBuffer buffer;
  buffer.poses = PoseArray(1);
  buffer.poses.resize(static_cast<int>(at[0].size()));
  for (size_t i = 0; i < at[0].size(); ++i) {
    FrameState state;
    state.arc = arc + 0.1 * static_cast<double>(i);
    for (const Side side : {kLeft, kRight}) state.feet[side].at = at[side][i];
    buffer.poses.p_WR(static_cast<int>(i)) = {state.arc, 0, 1};
    buffer.states.push_back(state);
  }
  buffer.markFootprints();
  return buffer;
}

TEST(AnimationBuffer, FootprintsAreTheStretchesInWhichAFootIsPlanted) {
  const AnimationBuffer b =
      bufferOf({{{0.1, 0.9, 1.0, 1.5, 0.0, 0.5}, {1.2, 1.9, 0, 0.4, 0.8, 2}}});
  ASSERT_EQ(b.footprints.size(), 3u);
  EXPECT_EQ(b.footprints[0].side, kLeft);
  EXPECT_EQ(b.footprints[0].first_frame, 0);
  EXPECT_EQ(b.footprints[0].last_frame, 2);
  EXPECT_EQ(b.footprints[1].side, kRight);
  EXPECT_EQ(b.footprints[1].first_frame, 2);
  EXPECT_EQ(b.footprints[1].last_frame, 4);
  EXPECT_EQ(b.footprints[2].first_frame, 4);
  EXPECT_EQ(b.footprints[2].last_frame, 5);
  for (int i = 0; i < b.size(); ++i) {
    for (const Side side : {kLeft, kRight}) {
      EXPECT_EQ(b.states[i].planted[side], b.states[i].feet[side].at <= 1.0);
    }
  }
}

TEST(AnimationBuffer, MarkingFootprintsTwiceMarksThemOnce) {
  AnimationBuffer b = bufferOf({{{0.1, 0.9, 1.5}, {1.2, 0.1, 0.2}}});
  const size_t prints = b.footprints.size();
  b.markFootprints();
  EXPECT_EQ(b.footprints.size(), prints);
}

TEST(AnimationBuffer, AnAppendedBufferGoesOnInFramesAndArc) {
  AnimationBuffer a = bufferOf({{{0.1, 0.2, 0.3}, {1.2, 1.5, 0.0}}}, 5.0);
  const AnimationBuffer b = bufferOf({{{0.3, 1.5, 0.1, 0.2}, {0.0, 0.4, 0.9, 1.4}}}, 7.0);
  a.append(b);
  ASSERT_EQ(a.size(), 6);
  ASSERT_EQ(a.states.size(), 6u);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(a.states[i].arc, 5.0 + 0.1 * i, 1e-12);
  EXPECT_EQ(a.poses.p_WR(3), b.poses.p_WR(1));
}

TEST(AnimationBuffer, FootprintsThatGoOnAreMergedAsIfTheBufferHadBeenOne) {
  const std::vector<double> left = {0.1, 0.4, 0.7, 1.5, 0.1, 0.4, 0.7},
                            right = {0.6, 1.5, 0.1, 0.4, 0.7, 1.5, 0.1};
  const AnimationBuffer whole = bufferOf({left, right});
  for (size_t cut = 0; cut < left.size(); ++cut) {
    const auto c = static_cast<std::ptrdiff_t>(cut);
    AnimationBuffer a =
        bufferOf({{{left.begin(), left.begin() + c + 1}, {right.begin(), right.begin() + c + 1}}});
    a.append(bufferOf({{{left.begin() + c, left.end()}, {right.begin() + c, right.end()}}}));
    ASSERT_EQ(a.footprints.size(), whole.footprints.size()) << "cut at " << cut;
    for (const Footprint& print : whole.footprints) {
      int found = 0;
      for (const Footprint& ours : a.footprints) {
        found += ours.side == print.side && ours.first_frame == print.first_frame &&
                 ours.last_frame == print.last_frame;
      }
      EXPECT_EQ(found, 1) << "cut at " << cut;
    }
  }
}

TEST(AnimationBuffer, AppendingNothingOrToNothingChangesNothing) {
  AnimationBuffer empty;
  const AnimationBuffer b = bufferOf({{{0.1, 0.2}, {1.2, 1.5}}}, 3.0);
  AnimationBuffer a = b;
  a.append(empty);
  EXPECT_EQ(a.size(), b.size());
  empty.append(b);
  EXPECT_EQ(empty.size(), b.size());
  EXPECT_EQ(empty.states[0].arc, 3.0);
  EXPECT_EQ(empty.footprints.size(), b.footprints.size());
}

}  // namespace
}  // namespace amble
