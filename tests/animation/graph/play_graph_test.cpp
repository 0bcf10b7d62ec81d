#include "animation/graph/play_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/animation/graph/graph_captures.h"
#include "tests/animation/planted_clip.h"

namespace amble {
namespace {

constexpr int kBlend = 15;

struct PlayGraph : testing::Test {
  void SetUp() override {
    AMBLE_NEEDS_CAPTURES();
    cut = cutAt(someGraph(), kGraphError);
    for (const int i : {0, 1}) {
      const Clip& clip = someClips().clips[i].clip;
      still = std::max(still, jointAcceleration(clip, 0, clip.frames()));
    }
  }
  const ClusterGraph& graph = someGraph();
  GraphCut cut;
  double still = 0.0;  // largest of the walk and the run that are played below [rad/s²]

  /// Every bar of a join that the motion itself shows.
  void expectSmooth(const JoinedClip& motion) const {
    for (const JoinReport& join : motion.joins) {
      EXPECT_LE(join.glide, 1.1);
      EXPECT_LE(jointAcceleration(motion.clip, join.first - 5, join.last + 5), 1.05 * still);
      for (int i = join.first; i < join.last; ++i) {
        const auto way = [&](const Clip& clip, int at) {
          return (clip.poses.p_WR(at + 1) - clip.poses.p_WR(at)).head<2>().norm();
        };
        EXPECT_LT(way(motion.clip, i), 0.2) << i;  // 6 m/s: nobody is moved to another place
      }
      for (const FootHold& foot : join.feet)
        if (foot.which != ContactCase::kSlips) {
          EXPECT_LE(foot.slip, 0.005);
        }
    }
  }
};

TEST_F(PlayGraph, OneRangeIsThatPartOfTheClip) {
  const JoinedClip motion = played(someClips(), {{0, 40, 90}}, kBlend);
  ASSERT_EQ(motion.clip.frames(), 51);
  const Clip& clip = someClips().clips[0].clip;
  for (int i = 0; i <= 50; ++i) EXPECT_EQ(motion.clip.poses.p_WR(i), clip.poses.p_WR(40 + i));
}

TEST_F(PlayGraph, ALoopGoesOnForAsLongAsItIsAskedTo) {
  const FrameLoop loop = loopsOf(graph, cut, 0, 12)[0];
  const Clip& walk = someClips().clips[0].clip;
  const int cycle = loop.leave - loop.enter;
  for (const int count : {1, 2, 7}) {
    const JoinedClip motion = played(someClips(), rangesOf(graph, loop, count), kBlend);
    EXPECT_EQ(motion.clip.frames(), walk.frames() + (count - 1) * cycle);
    EXPECT_EQ(motion.joins.size(), static_cast<size_t>(count - 1));
    expectSmooth(motion);
  }
  // Each time round leads as far: nothing is lost or gained at a join.
  const JoinedClip motion = played(someClips(), rangesOf(graph, loop, 7), kBlend);
  const auto at = [&](int i) { return motion.clip.poses.p_WR(loop.leave + kBlend + i * cycle); };
  for (int i = 1; i < 5; ++i)
    EXPECT_NEAR((at(i + 1) - at(i)).head<2>().norm(), (at(1) - at(0)).head<2>().norm(), 1e-6);
}

TEST_F(PlayGraph, WalksIntoARunAndTakesUpOtherMotionsOnTheWay) {
  const int from = graph.clips[0].first + 60, to = graph.clips[1].first + 120;
  for (const auto& way : {nearestWay(graph, cut, from, to), bestWay(graph, cut, from, to)}) {
    ASSERT_TRUE(way);
    const auto ranges = rangesOf(graph, *way, from, to);
    const JoinedClip motion = played(someClips(), ranges, kBlend);
    int frames = 1;
    for (const PlayedRange& range : ranges) frames += range.last - range.first;
    EXPECT_EQ(motion.clip.frames(), frames);
    expectSmooth(motion);
  }
}

TEST_F(PlayGraph, ClipsOfOtherPeopleAreOnTheFirstOnesSkeletonAndStandOnItsFloor) {
  const GraphClips& clips = someClips();
  const Skeleton& first = clips.clips[0].clip.skeleton;
  for (const PlayableClip& clip : clips.clips) {
    ASSERT_EQ(clip.clip.skeleton.size(), first.size());
    EXPECT_EQ(clip.clip.frame_time, clips.frame_time);
    std::vector<JointFrame> joints(first.size());
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < clip.clip.frames(); ++i) {
      forwardKinematics(clip.clip, i, joints);
      for (const Side side : {kLeft, kRight}) {
        if (!clip.planted[side][i]) continue;
        sum += joints[clips.roles.legs[side].foot].p_WJ.z();
        ++count;
      }
    }
    EXPECT_NEAR(sum / count, 0.08, 0.03);  // ankles over the floor
  }
}

}  // namespace
}  // namespace amble
