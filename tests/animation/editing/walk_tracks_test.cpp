#include "animation/editing/walk_tracks.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/level_walk.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

class WalkTracksOf : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    AMBLE_NEEDS_CAPTURES();
    walk = std::make_unique<LevelWalk>(std::string(GetParam()));
    tracks = tracksOf(walk->clip, walk->roles);
  }
  Clip followed(TrackFit* fit = nullptr) const {
    return followTracks(walk->clip, walk->roles, tracks, fit);
  }
  std::unique_ptr<LevelWalk> walk;
  WalkTracks tracks;
};

TEST_P(WalkTracksOf, AsTheyWereCapturedGiveTheClipBack) {
  TrackFit fit;
  const Clip same = followed(&fit);
  EXPECT_LT(fit.lowered, 1e-12);
  EXPECT_LT(fit.missed, 1e-6);
  for (int i = 0; i < walk->clip.frames(); i += 7) {
    const auto a = jointFrames(walk->clip, i), b = jointFrames(same, i);
    for (size_t j = 0; j < a.size(); ++j) EXPECT_LT((a[j].p_WJ - b[j].p_WJ).norm(), 1e-6) << j;
  }
}

TEST_P(WalkTracksOf, AreWhereTheJointsAre) {
  for (int i = 0; i < walk->clip.frames(); i += 11) {
    const auto joints = jointFrames(walk->clip, i);
    EXPECT_EQ(tracks.root[i], walk->clip.poses.p_WR(i));
    for (const Side side : {kLeft, kRight}) {
      const LegJoints& leg = walk->roles.legs[side];
      EXPECT_LT((tracks.feet[side].ankle[i] - joints[leg.foot].p_WJ).norm(), 1e-12);
      EXPECT_LT(tracks.feet[side].q_WF[i].angularDistance(joints[leg.foot].q_WJ), 1e-7);
    }
  }
}

// Legs then need not bend otherwise: every joint keeps its turn.
TEST_P(WalkTracksOf, MovedAllAlikeMoveTheWholeClip) {
  const Eigen::Vector3d by(1.5, -2.5, 0.25);
  for (int i = 0; i < walk->clip.frames(); ++i) {
    tracks.root[i] += by;
    for (FootTrack& foot : tracks.feet) foot.move(i, by);
  }
  TrackFit fit;
  const Clip there = followed(&fit);
  EXPECT_LT(fit.lowered, 1e-12);
  for (int i = 0; i < walk->clip.frames(); i += 7) {
    const auto a = jointFrames(walk->clip, i), b = jointFrames(there, i);
    for (size_t j = 0; j < a.size(); ++j) EXPECT_LT((a[j].p_WJ + by - b[j].p_WJ).norm(), 1e-6) << j;
  }
}

// Feet raised and turned by a wave: ankles and soles are where the tracks have them, all but the
// legs is as it was.
TEST_P(WalkTracksOf, AreFollowedByLegsAndNothingElse) {
  for (int i = 0; i < walk->clip.frames(); ++i) {
    const double wave = 0.5 * (1.0 - std::cos(2.0 * kPi * i * walk->clip.frame_time));
    for (FootTrack& foot : tracks.feet) {
      foot.move(i, {0.02 * wave, 0.01 * wave, 0.04 * wave});
      foot.turn(i, aboutZ(0.1 * wave));
    }
  }
  TrackFit fit;
  const Clip there = followed(&fit);
  EXPECT_LT(fit.missed, 1e-6);
  std::vector<bool> of_leg(walk->clip.skeleton.size(), false);
  for (const LegJoints& leg : walk->roles.legs)
    of_leg[leg.up_leg] = of_leg[leg.leg] = of_leg[leg.foot] = true;
  for (int i = 0; i < walk->clip.frames(); ++i) {
    const auto joints = jointFrames(there, i);
    for (const Side side : {kLeft, kRight}) {
      const LegJoints& leg = walk->roles.legs[side];
      EXPECT_LT((joints[leg.foot].p_WJ - tracks.feet[side].ankle[i]).norm(), 1e-6) << i;
      EXPECT_LT(joints[leg.foot].q_WJ.angularDistance(tracks.feet[side].q_WF[i]), 1e-6) << i;
    }
    for (size_t j = 0; j < of_leg.size(); ++j) {
      if (of_leg[j]) continue;
      EXPECT_EQ(there.poses.rotations(i)[j].coeffs(), walk->clip.poses.rotations(i)[j].coeffs());
    }
  }
}

// Feet that are put lower than legs reach: the hips come down by what is missing, and as smoothly
// as they went.
TEST_P(WalkTracksOf, OutOfReachBringTheHipsDown) {
  const int middle = walk->clip.frames() / 2;
  for (int i = 0; i < walk->clip.frames(); ++i) {
    const double from_middle = (i - middle) * walk->clip.frame_time / 0.3;
    const double bump = std::exp(-from_middle * from_middle);
    for (FootTrack& foot : tracks.feet) foot.move(i, {0.0, 0.0, -0.08 * bump});
  }
  TrackFit fit;
  const Clip there = followed(&fit);
  EXPECT_GT(fit.lowered, 0.01);
  EXPECT_LT(fit.lowered, 0.16);
  EXPECT_LT(fit.missed, 0.005);
  double most = 0.0;
  for (int i = 0; i < walk->clip.frames(); ++i) {
    const Eigen::Vector3d down = walk->clip.poses.p_WR(i) - there.poses.p_WR(i);
    EXPECT_EQ(down.head<2>().norm(), 0.0);
    EXPECT_GT(down.z(), -1e-12);
    most = std::max(most, down.z());
  }
  EXPECT_NEAR(most, fit.lowered, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(, WalkTracksOf,
                         testing::Values("accad_female1/Female1_B03_Walk1.bvh", "cmu_mb2/02_01.bvh",
                                         "accad_male1/Male1_B3_Walk.bvh"));

TEST(FootTrack, TurnsAboutItsToe) {
  Generator generator(1);
  for (int trial = 0; trial < 50; ++trial) {
    FootTrack foot;
    foot.ankle.push_back(randomVector(generator, 1.0));
    foot.toe.push_back(randomVector(generator, 1.0));
    foot.q_WF.push_back(randomRotation(generator));
    const FootTrack before = foot;
    const Eigen::Quaterniond by = randomRotation(generator);
    foot.turn(0, by);
    EXPECT_EQ(foot.toe[0], before.toe[0]);
    // The toe is where it was in the foot's own frame.
    const Eigen::Vector3d in_foot = before.q_WF[0].conjugate() * (before.toe[0] - before.ankle[0]);
    EXPECT_LT((foot.q_WF[0].conjugate() * (foot.toe[0] - foot.ankle[0]) - in_foot).norm(), 1e-12);
    foot.turn(0, by.conjugate());
    EXPECT_LT((foot.ankle[0] - before.ankle[0]).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace amble
