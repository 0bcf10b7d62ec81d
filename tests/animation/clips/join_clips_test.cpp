#include "animation/clips/join_clips.h"

#include <gtest/gtest.h>

#include "animation/clips/loop_clip.h"
#include "tests/animation/planted_clip.h"

namespace amble {
namespace {

constexpr int kBlend = 14;  // half a second of these captures

/// The frame of `to` most like frame `leave` of `from` among those whose feet stand alike.
int likest(const PlantedClip& from, int leave, const PlantedClip& to) {
  std::vector<JointFrame> a(from.clip.skeleton.size()), b(a.size());
  forwardKinematics(from.clip, leave, a);
  int found = -1;
  double least = 1e9;
  for (int i = kBlend; i < to.clip.frames() - kBlend; ++i) {
    const auto alike = [&](Side s) { return from.planted[s][leave] == to.planted[s][i]; };
    if (!alike(kLeft) || !alike(kRight)) continue;
    forwardKinematics(to.clip, i, b);
    const double gap = poseGap(a, b, from.roles);
    if (gap < least) least = gap, found = i;
  }
  return found;
}

JoinedClip joinedAt(const PlantedClip& from, int leave, const PlantedClip& to, int enter) {
  JoinedClip joined = joinedFrom(from, 0);
  joinOn(joined, to, from.roles, {leave, enter, kBlend});
  return joined;
}

double largestDistance(const Clip& a, const Clip& b) {
  std::vector<JointFrame> p(a.skeleton.size()), q(a.skeleton.size());
  double most = 0.0;
  for (int i = 0; i < a.frames(); ++i) {
    forwardKinematics(a, i, p);
    forwardKinematics(b, i, q);
    for (size_t j = 0; j < p.size(); ++j) most = std::max(most, (p[j].p_WJ - q[j].p_WJ).norm());
  }
  return most;
}

/// A walk and the motions that it is joined to, read once.
struct JoinClips : testing::Test {
  void SetUp() override { AMBLE_NEEDS_CAPTURES(); }
  static const PlantedClip& walk() {
    static const PlantedClip clip = plantedClip("accad_female1/Female1_B03_Walk1.bvh");
    return clip;
  }
  static const PlantedClip& turn() {
    static const PlantedClip clip = plantedClip("accad_female1/Female1_B09_WalkTurnLeft90.bvh");
    return clip;
  }
  static const PlantedClip& run() {
    static const PlantedClip clip = plantedClip("accad_female1/Female1_C05_WalkToRun.bvh");
    return clip;
  }
};

TEST_F(JoinClips, AMotionJoinedToItselfWhereItIsStaysAsItIs) {
  const JoinedClip joined = joinedAt(walk(), 120, walk(), 120);
  ASSERT_EQ(joined.clip.frames(), walk().clip.frames());
  EXPECT_LT(largestDistance(joined.clip, walk().clip), 1e-9);
  EXPECT_EQ(joined.planted, walk().planted);
}

TEST_F(JoinClips, OutsideOfTheBlendBothMotionsAreTheirOwn) {
  const int enter = likest(walk(), 120, turn());
  const JoinedClip joined = joinedAt(walk(), 120, turn(), enter);
  const JoinReport& report = joined.joins[0];
  EXPECT_EQ(report.last - report.first, kBlend);
  EXPECT_EQ(joined.clip.frames(), 120 + turn().clip.frames() - enter);
  // Corrections of feet reach no farther than this.
  const int fade = static_cast<int>(std::ceil(kHoldFade / joined.clip.frame_time));
  for (int i = 0; i < report.first - fade; ++i)
    ASSERT_EQ(joined.clip.poses.p_WR(i), walk().clip.poses.p_WR(i));
  for (int i = report.last + fade + 1; i < joined.clip.frames(); ++i) {
    const int own = i - report.frame_shift;
    ASSERT_LT((joined.clip.poses.p_WR(i) - report.moved * turn().clip.poses.p_WR(own)).norm(),
              1e-9);
    for (int j = 1; j < joined.clip.skeleton.size(); ++j)
      ASSERT_EQ(joined.clip.poses.rotations(i)[j].coeffs(),
                turn().clip.poses.rotations(own)[j].coeffs());
  }
}

TEST_F(JoinClips, WhereTheNextClipStandsAndFacesDoesNotMatter) {
  const int enter = likest(walk(), 120, turn());
  PlantedClip moved = turn();
  moveRoot(moved.clip.poses, 0, moved.clip.frames() - 1, {-2.6, {30.0, 7.0}});
  EXPECT_LT(largestDistance(joinedAt(walk(), 120, turn(), enter).clip,
                            joinedAt(walk(), 120, moved, enter).clip),
            1e-6);
}

TEST_F(JoinClips, TheRootNeverGoesFasterThanItsSourcesAndNoJointPops) {
  const double still =
      std::max({jointAcceleration(walk().clip, 0, 1000), jointAcceleration(turn().clip, 0, 1000),
                jointAcceleration(run().clip, 0, 1000)});
  for (const PlantedClip* next : {&turn(), &run()}) {
    for (int leave = 100; leave < 140; leave += 3) {
      const JoinedClip joined = joinedAt(walk(), leave, *next, likest(walk(), leave, *next));
      const JoinReport& report = joined.joins[0];
      EXPECT_LE(report.glide, 1.1) << leave;
      // The same from the outside: the way over the blend against the mean of both ways.
      const auto way = [](const Clip& clip, int first) {
        double sum = 0.0;
        for (int i = first; i < first + kBlend; ++i)
          sum += (clip.poses.p_WR(i + 1) - clip.poses.p_WR(i)).head<2>().norm();
        return sum;
      };
      const double mean = 0.5 * (way(walk().clip, report.first) +
                                 way(next->clip, report.first - report.frame_shift));
      EXPECT_LE(way(joined.clip, report.first), 1.1 * mean) << leave;
      EXPECT_LE(jointAcceleration(joined.clip, report.first - 8, report.last + 8), 1.05 * still)
          << leave;
    }
  }
}

TEST_F(JoinClips, BlendsAreShorterWhereAMotionBegins) {
  const JoinedClip joined = joinedAt(walk(), 120, walk(), 3);
  EXPECT_EQ(joined.joins[0].last - joined.joins[0].first, 6);
  const JoinedClip cut = joinedAt(walk(), 120, walk(), 0);
  EXPECT_EQ(cut.joins[0].first, cut.joins[0].last);
  EXPECT_EQ(cut.clip.frames(), 120 + walk().clip.frames());
}

/// How far a toe goes along the ground from a frame to the next [m].
double toeStep(const Clip& clip, const LegJoints& leg, int frame) {
  std::vector<JointFrame> a(clip.skeleton.size()), b(a.size());
  forwardKinematics(clip, frame, a);
  forwardKinematics(clip, frame + 1, b);
  return (b[leg.toe].p_WJ - a[leg.toe].p_WJ).head<2>().norm();
}

TEST_F(JoinClips, WhereTwoMotionsAreCutAFootSlipsAsFarAsItGoesBesidesItsOwnWay) {
  for (const int enter : {likest(walk(), 100, run()), likest(walk(), 120, run())}) {
    JoinedClip joined = joinedFrom(walk(), 0);
    joinOn(joined, run(), walk().roles, {110, enter, 0});
    ASSERT_FALSE(joined.joins[0].feet.empty());
    for (const FootHold& foot : joined.joins[0].feet) {
      const LegJoints& leg = walk().roles.legs[foot.side];
      EXPECT_NEAR(foot.slip, toeStep(joined.clip, leg, 110),
                  toeStep(run().clip, leg, enter) + 1e-9);
      EXPECT_GT(foot.slip, 0.0);
    }
  }
}

TEST_F(JoinClips, OfAMotionThatEndsWithinABlendNothingIsSaidBeyondItsEnd) {
  JoinedClip joined = joinedAt(walk(), 120, run(), likest(walk(), 120, run()));
  const int end = joined.joins[0].meeting + 2;
  ASSERT_GT(joined.joins[0].last, end);
  endAt(joined, end);
  EXPECT_EQ(joined.joins[0].last, end);
  for (const FootHold& foot : joined.joins[0].feet) {
    EXPECT_LE(foot.first, foot.last);
    EXPECT_LE(foot.last, end);
  }
}

TEST_F(JoinClips, EndsWithTheFrameThatIsAsked) {
  JoinedClip joined = joinedFrom(walk(), 20);
  endAt(joined, 30);
  EXPECT_EQ(joined.clip.frames(), 31);
  EXPECT_EQ(joined.planted[kLeft].size(), 31u);
  EXPECT_EQ(joined.clip.poses.p_WR(30), walk().clip.poses.p_WR(50));
}

}  // namespace
}  // namespace amble
