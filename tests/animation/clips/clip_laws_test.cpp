// What is done to a clip, of captures of every kind: what comes back, what stays, what is the same
// wherever the clip is and whichever way it goes.

#include <gtest/gtest.h>

#include "animation/body/foot_shape.h"
#include "animation/body/pelvis.h"
#include "animation/captures/capture_checks.h"
#include "animation/clips/carry_over.h"
#include "animation/clips/good_frames.h"
#include "animation/clips/loop_clip.h"
#include "animation/clips/mirror_clip.h"
#include "animation/clips/resample_clip.h"
#include "animation/clips/root_motion.h"
#include "animation/clips/steady_clip.h"
#include "base/rotation.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/some_captures.h"

namespace amble {
namespace {

/// Largest distance of joints of the same index in the same frame, every `step` frames [m].
double farApart(const Clip& a, const Clip& b, int step = 1) {
  EXPECT_EQ(a.frames(), b.frames());
  double most = 0.0;
  for (int i = 0; i < std::min(a.frames(), b.frames()); i += step) {
    const std::vector<JointFrame> p = jointFrames(a, i), q = jointFrames(b, i);
    for (size_t j = 0; j < p.size(); ++j) most = std::max(most, (p[j].p_WJ - q[j].p_WJ).norm());
  }
  return most;
}

class ClipLaws : public testing::Test {
 protected:
  void SetUp() override { AMBLE_NEEDS_CAPTURES(); }
};

TEST_F(ClipLaws, AFinerClipHasTheCapturedFramesAmongItsOwnAndGivesThemBack) {
  for (const SomeCapture& one : someCaptures()) {
    const Clip part = trimmed(one.clip, 0, std::min(100, one.clip.frames() - 1));
    for (const int factor : {2, 3}) {
      const Clip fine = resampleClip(part, part.frame_time / factor);
      ASSERT_EQ(fine.frames(), factor * (part.frames() - 1) + 1) << one.path;
      EXPECT_LT(farApart(resampleClip(fine, part.frame_time), part, 5), 1e-9) << one.path;
    }
  }
}

TEST_F(ClipLaws, NoJointGoesFartherBetweenFramesThanTheFrames) {
  for (const SomeCapture& one : someCaptures()) {
    const Clip part = trimmed(one.clip, 0, std::min(60, one.clip.frames() - 1));
    const Clip fine = resampleClip(part, part.frame_time / 2.0);
    for (int i = 0; i + 1 < part.frames(); ++i) {
      const Eigen::Vector3d middle = 0.5 * (part.poses.p_WR(i) + part.poses.p_WR(i + 1));
      EXPECT_LT((fine.poses.p_WR(2 * i + 1) - middle).norm(), 1e-12) << one.path;
      for (int j = 0; j < part.skeleton.size(); ++j) {
        const Eigen::Quaterniond &a = part.poses.rotations(i)[j],
                                 &b = part.poses.rotations(i + 1)[j],
                                 &m = fine.poses.rotations(2 * i + 1)[j];
        EXPECT_NEAR(a.angularDistance(m), 0.5 * a.angularDistance(b), 1e-6) << one.path;
      }
    }
  }
}

TEST_F(ClipLaws, AResampledClipLastsAsLongToWithinAFrame) {
  for (const SomeCapture& one : someCaptures()) {
    for (const double rate : {24.0, 30.0, 50.0, 90.0}) {
      const Clip other = resampleClip(one.clip, 1.0 / rate);
      EXPECT_LE(other.duration(), one.clip.duration() + 0.011 / rate) << one.path;
      EXPECT_GT(other.duration(), one.clip.duration() - 1.0 / rate) << one.path;
      EXPECT_EQ(other.skeleton.size(), one.clip.skeleton.size());
    }
  }
}

// Joints without a role are as the reference has them from the first mirror on (carry_over.h); of
// rigs that stand at rest as nobody does that is the clip's mean pose, of another clip a little
// another.
TEST_F(ClipLaws, AMirrorImageOfAMirrorImageOfAMirrorImageIsAMirrorImage) {
  for (const SomeCapture& one : someCaptures()) {
    if (!one.clip.joint_positions.empty()) continue;
    if (one.roles.legs[kLeft].toe < 0) continue;  // referenceOf asks for toes
    const Clip once = mirrorClip(one.clip, one.roles);
    const Clip thrice = mirrorClip(mirrorClip(once, one.roles), one.roles);
    EXPECT_LT(farApart(thrice, once, 20), 0.02) << one.path;
  }
}

TEST_F(ClipLaws, InAMirrorThePelvisGoesAndFacesTheOtherWay) {
  for (const SomeCapture& one : someCaptures()) {
    if (!one.clip.joint_positions.empty() || one.roles.legs[kLeft].toe < 0) continue;
    const Clip image = mirrorClip(one.clip, one.roles);
    const std::vector<double> here = pelvisHeadings(one.clip, one.roles),
                              there = pelvisHeadings(image, one.roles);
    const std::vector<Eigen::Vector3d> way = pelvisPath(one.clip, one.roles),
                                       other_way = pelvisPath(image, one.roles);
    for (size_t i = 0; i < here.size(); i += 10) {
      // Rigs whose one hip is put before the other face askew by as much, whoever is in the mirror.
      EXPECT_NEAR(wrapAngle(here[i] + there[i]), 0.0, 1.5 * kDegree) << one.path;
      const Eigen::Vector3d& p = way[i];
      EXPECT_LT((Eigen::Vector3d(p.x(), -p.y(), p.z()) - other_way[i]).norm(), 1e-9) << one.path;
    }
  }
}

// Joints without a role are as the target's reference has them; those with one stay.
TEST_F(ClipLaws, CarriedOverToALargerSelfAndBackAClipIsAsCarriedOverToItself) {
  for (const SomeCapture& one : someCaptures()) {
    if (!one.clip.joint_positions.empty() || one.roles.legs[kLeft].toe < 0) continue;
    const ReferencePose reference = referenceOf(one.clip, one.roles);
    const UprightRig own{one.clip.skeleton, one.roles, reference};
    const Skeleton large = one.clip.skeleton.scaled(1.4);
    const UprightRig other{large, one.roles, reference};
    const Clip here = carriedOver(one.clip, own, own), there = carriedOver(one.clip, own, other);
    EXPECT_LT(farApart(carriedOver(here, own, own), here, 20), 1e-6) << one.path;
    EXPECT_LT(farApart(carriedOver(there, other, own), here, 20), 1e-6) << one.path;
    for (int i = 0; i < here.frames(); i += 20) {
      const std::vector<JointFrame> a = jointFrames(one.clip, i), b = jointFrames(here, i);
      for (const std::string& role : roleNames()) {
        const int joint = roleJoint(one.roles, role);
        if (joint < 0) continue;
        EXPECT_LT(a[joint].q_WJ.angularDistance(b[joint].q_WJ), 1e-6) << one.path << ' ' << role;
      }
    }
  }
}

TEST_F(ClipLaws, TrimmingTwiceIsTrimmingOnce) {
  for (const SomeCapture& one : someCaptures()) {
    const int last = one.clip.frames() - 1, third = last / 3;
    const Clip once = trimmed(one.clip, third, 2 * third);
    const Clip twice =
        trimmed(trimmed(one.clip, third - third / 2, last), third / 2, third / 2 + third);
    EXPECT_EQ(farApart(once, twice, 7), 0.0) << one.path;
  }
}

TEST_F(ClipLaws, WhatIsGoodIsGood) {
  for (const SomeCapture& one : someCaptures()) {
    const GoodFrames good = goodFrames(one.clip);  // trimmed to its good frames before
    EXPECT_EQ(good.last, one.clip.frames() - 1) << one.path;
    EXPECT_LE(good.first, 2) << one.path;
  }
}

// The fit is held towards level: what it leaves is less than what it found.
TEST_F(ClipLaws, ALevelledClipIsNearerToLevelThanItWas) {
  for (const SomeCapture& one : someCaptures()) {
    if (jointJitter(one.clip) > kNoisy) continue;
    FloorFit before, after;
    const Clip again = levelled(one.clip, one.roles, &before);
    if (!doubtOf(before).empty()) continue;
    levelled(again, one.roles, &after);
    EXPECT_LE(after.tilt(), before.tilt() + 1e-7) << one.path;
    EXPECT_NEAR(after.ankle_mean, before.ankle_mean, 0.02) << one.path;
  }
}

// Up to three degrees about any axis along the ground, as captures are tilted: feet that spread
// show it.
TEST_F(ClipLaws, ATiltOfACaptureIsTakenOutWhereItsFeetSpread) {
  Generator generator(501);
  int seen = 0;
  for (const SomeCapture& one : someCaptures()) {
    const FloorFit own = fitFloor(one.paths, one.legs, one.clip.frame_time);
    double spread = 0.0;
    const std::vector<Eigen::Vector3d> path = pelvisPath(one.clip, one.roles);
    for (const Eigen::Vector3d& p : path) spread = std::max(spread, (p - path[0]).head<2>().norm());
    if (own.plants < 6 || spread < 2.5) continue;
    ++seen;
    Eigen::Vector3d way = path.back() - path.front();
    for (const Eigen::Vector3d& p : path) {
      if ((p - path[0]).head<2>().norm() > way.head<2>().norm()) way = p - path[0];
    }
    way.z() = 0.0;
    const double angle = uniform(generator, 0.5, 2.5) * kDegree;
    const Eigen::Quaterniond tilt(
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ().cross(way).normalized()));
    const FloorFit tilted = fitFloor(moved(one.clip, tilt, {0, 0, 0}), one.roles);
    const double found = std::acos(std::min(1.0, tilted.normal.dot(own.normal)));
    EXPECT_NEAR(found, angle, 0.15 * angle) << one.path;
  }
  EXPECT_GT(seen, 5);
}

TEST_F(ClipLaws, LevelledClipsStandWithTheirAnklesAtTheHeightAsked) {
  for (const SomeCapture& one : someCaptures()) {
    const FloorFit floor = fitFloor(one.clip, one.roles);
    if (floor.samples == 0) continue;
    for (const double height : {0.0, 0.09}) {
      const Clip level = levelClip(one.clip, levelPlane(floor), height);
      EXPECT_NEAR(fitFloor(level, one.roles).ankle_mean, height, 1e-9) << one.path;
      EXPECT_LT(fitFloor(level, one.roles).residual, floor.residual + 0.05) << one.path;
    }
  }
}

TEST_F(ClipLaws, SteadyingKnowsNeitherPlaceNorHeadingNorDirectionOfTime) {
  for (const SomeCapture& one : someCaptures()) {
    const Clip part = trimmed(one.clip, 0, std::min(80, one.clip.frames() - 1));
    const Clip steady = steadied(part);
    const Clip there = steadied(moved(part, aboutZ(1.3), {2.0, 3.0, 0.0}));
    EXPECT_LT(farApart(there, moved(steady, aboutZ(1.3), {2.0, 3.0, 0.0}), 8), 1e-9) << one.path;
    const int last = part.frames() - 1;
    Clip back = part;
    for (int i = 0; i <= last; ++i) {
      const auto from = part.poses.rotations(last - i);
      std::copy(from.begin(), from.end(), back.poses.rotations(i).begin());
    }
    const Clip turned = steadied(back);
    for (int i = 0; i <= last; i += 8) {
      for (int j = 0; j < part.skeleton.size(); ++j) {
        EXPECT_LT(turned.poses.rotations(last - i)[j].angularDistance(steady.poses.rotations(i)[j]),
                  1e-6)
            << one.path;
      }
    }
  }
}

TEST_F(ClipLaws, SteadyingLessAndLessLeavesTheClip) {
  for (const SomeCapture& one : someCaptures()) {
    const Clip part = trimmed(one.clip, 0, std::min(60, one.clip.frames() - 1));
    EXPECT_LT(farApart(steadied(part, 0.05 * part.frame_time), part, 5), 1e-9) << one.path;
    EXPECT_LE(jointJitter(steadied(part)), jointJitter(part) + 1e-12) << one.path;
  }
}

TEST_F(ClipLaws, PlacesAndCarriagesGiveEveryMotionBack) {
  for (const SomeCapture& one : someCaptures()) {
    const int last = one.clip.frames() - 1;
    const RootMotion motion = rootMotion(one.clip, one.roles, 0, last);
    Clip rebuilt = one.clip;
    RootPlace place = motion.places[0];
    for (int i = 0; i <= last; ++i) {
      placeRoot(rebuilt.poses, i, place, motion.carriages[i]);
      if (i < last) place = advanced(place, motion.step(i));
    }
    EXPECT_LT(farApart(rebuilt, one.clip, 25), 1e-8) << one.path;
    for (int i = 1; i <= last; ++i) {
      EXPECT_LT(std::abs(motion.places[i].heading - motion.places[i - 1].heading), kPi) << one.path;
    }
  }
}

TEST(RootSteps, MixedWithWeightsOfNoneAndAllAreTheOneAndTheOther) {
  Generator generator(502);
  for (int i = 0; i < 50; ++i) {
    const RootStep a{randomVector(generator, 1.0).head<2>(), uniform(generator, -1, 1)},
        b{randomVector(generator, 1.0).head<2>(), uniform(generator, -1, 1)};
    EXPECT_EQ(mixed(a, b, 0.0).way, a.way);
    EXPECT_EQ(mixed(a, b, 1.0).way, b.way);
    const double w = uniform(generator, 0.0, 1.0);
    const RootStep there = mixed(a, b, w), back = mixed(b, a, 1.0 - w);
    EXPECT_LT((there.way - back.way).norm(), 1e-12);
    EXPECT_NEAR(there.yaw, back.yaw, 1e-12);
    const RootCarriage c{0.9, randomRotation(generator)}, d{1.1, randomRotation(generator)};
    EXPECT_LT(mixed(c, d, w).q_HR.angularDistance(mixed(d, c, 1.0 - w).q_HR), 1e-6);
    EXPECT_NEAR(mixed(c, d, w).height, 0.9 + 0.2 * w, 1e-12);
  }
}

TEST(RootSteps, ShiftsThereAndOnAreOneShiftAndBackNone) {
  Generator generator(503);
  const auto anywhere = [&]() -> RootPlace {
    return {randomVector(generator, 5.0).head<2>(), uniform(generator, -6.0, 6.0)};
  };
  for (int i = 0; i < 50; ++i) {
    const RootPlace a = anywhere(), b = anywhere(), c = anywhere();
    const Eigen::Vector3d p = randomVector(generator, 3.0);
    const GroundShift ab = between(a, b), bc = between(b, c), ac = between(a, c),
                      ba = between(b, a);
    EXPECT_LT((bc * (ab * p) - ac * p).norm(), 1e-12);
    EXPECT_LT((ba * (ab * p) - p).norm(), 1e-12);
    EXPECT_EQ((ab * p).z(), p.z());
    const JointFrame joint{randomRotation(generator), p};
    const Eigen::Vector3d inside = randomVector(generator, 1.0);
    EXPECT_LT(((ab * joint) * inside - ab * (joint * inside)).norm(), 1e-12);
  }
}

TEST_F(ClipLaws, ThePoseGapIsADistanceThatHeadingsDoNotChange) {
  for (const SomeCapture& one : someCaptures()) {
    const int last = one.clip.frames() - 1;
    const std::vector<JointFrame> a = jointFrames(one.clip, 0), b = jointFrames(one.clip, last / 2),
                                  c = jointFrames(one.clip, last);
    EXPECT_EQ(poseGap(a, a, one.roles), 0.0) << one.path;
    EXPECT_NEAR(poseGap(a, b, one.roles), poseGap(b, a, one.roles), 1e-12) << one.path;
    EXPECT_LE(poseGap(a, c, one.roles), poseGap(a, b, one.roles) + poseGap(b, c, one.roles) + 1e-12)
        << one.path;
    const Clip there = moved(one.clip, aboutZ(-2.0), {8.0, 1.0, 0.0});
    EXPECT_NEAR(poseGap(jointFrames(there, 0), b, one.roles), poseGap(a, b, one.roles), 1e-9)
        << one.path;
  }
}

}  // namespace
}  // namespace amble
