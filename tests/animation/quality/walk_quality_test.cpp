#include "animation/quality/walk_quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/body/pelvis.h"
#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/rotation.h"

namespace amble {
namespace {

TEST(QualityAnchors, AtACapturedSpeedTheJerkIsThatOfTheCaptureOrOfTheNoisiestThatCounts) {
  const MotionLibrary library = openMotionLibrary("default");
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk || motion.turning || motion.source.mirrored) continue;
    const double jerk = std::min(motion.cycle.capture.joint_jerk, 130.0);
    EXPECT_NEAR(anchorsOf(library, 1.0, motion.cycle.speed).joint_jerk, jerk, 0.01 * jerk);
  }
}

// QUALITY.md: jerk over 130 m/s^3 or root acceleration over 12 m/s^2.
TEST(QualityAnchors, NoisySourcesRaiseNoBar) {
  MotionLibrary library = openMotionLibrary("default");
  const QualityAnchors all = anchorsOf(library, 1.0, 1.2);
  const auto noisy = [](const Motion& motion) {
    return motion.kind == MotionKind::kWalk && (motion.cycle.capture.joint_jerk > 130.0 ||
                                                motion.cycle.capture.root_acceleration > 12.0);
  };
  MotionLibrary clean = library, dirty = library;
  EXPECT_GT(std::erase_if(clean.motions, noisy), 0U);  // B10, the fast walks of CMU 07
  const QualityAnchors of_clean = anchorsOf(clean, 1.0, 1.2);
  EXPECT_EQ(all.root_acceleration, of_clean.root_acceleration);
  EXPECT_EQ(all.pops, of_clean.pops);
  std::erase_if(dirty.motions, [&](const Motion& motion) { return !noisy(motion); });
  const QualityAnchors of_dirty = anchorsOf(dirty, 1.0, 1.7);
  EXPECT_EQ(of_dirty.root_acceleration, 12.0);
  EXPECT_EQ(of_dirty.joint_jerk, 130.0);
  EXPECT_EQ(of_dirty.pops, 0.0);
}

TEST(QualityAnchors, BetweenAndBeyondTheCapturesNothingIsExtrapolated) {
  const MotionLibrary library = openMotionLibrary("default");
  double least = 1e9, most = 0.0;
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk || motion.turning) continue;
    least = std::min(least, motion.cycle.capture.joint_jerk);
    most = std::max(most, motion.cycle.capture.joint_jerk);
  }
  for (double speed = 0.3; speed < 3.0; speed += 0.1) {
    const double jerk = anchorsOf(library, 1.0, speed).joint_jerk;
    EXPECT_GE(jerk, least);
    EXPECT_LE(jerk, most);
  }
}

// Lengths times s, times of its root: accelerations stay, jerk is over the root.
TEST(QualityAnchors, ScaleFollowsFroude) {
  const MotionLibrary library = openMotionLibrary("default");
  const QualityAnchors one = anchorsOf(library, 1.0, 1.3);
  const QualityAnchors tall = anchorsOf(library, 1.21, 1.1 * 1.3);
  EXPECT_NEAR(tall.joint_jerk, one.joint_jerk / 1.1, 1e-9 * one.joint_jerk);
  EXPECT_EQ(tall.root_acceleration, one.root_acceleration);
}

/// Six metres straight ahead, from standing to standing.
class JudgeWalk : public testing::Test {
 protected:
  JudgeWalk() : library_(openMotionLibrary("default")), synthesizer_(library_, ground_, {}) {
    walkFrom({0, 0, 0}, 0.0);
  }
  void walkFrom(const Eigen::Vector3d& place, double heading, double length = 6.0) {
    Stance from, to;
    from.position = place;
    to.position = place + length * Eigen::Vector3d(std::cos(heading), std::sin(heading), 0.0);
    from.heading = to.heading = heading;
    const RootPath path(
        {makeBezier(from.position.head<2>(), heading, to.position.head<2>(), heading)});
    EXPECT_EQ(synthesizer_.walk(from, to, path, true, walk_).refused, WalkRule::kNone);
    clip_ = {"walk", synthesizer_.skeleton(), walk_.frame_time, walk_.poses, {}};
  }
  // Straight ahead, so far [m].
  void walkTo(const WalkSynthesizer& walker, double length) {
    Stance from, to;
    to.position.x() = length;
    const RootPath path({makeBezier(from.position.head<2>(), 0.0, to.position.head<2>(), 0.0)});
    ASSERT_EQ(walker.walk(from, to, path, true, walk_).refused, WalkRule::kNone) << length;
    clip_ = {"walk", walker.skeleton(), walk_.frame_time, walk_.poses, {}};
  }
  std::vector<QualityLine> judged() const {
    QualityAnchors anchors = anchorsOf(library_, 1.0, synthesizer_.settings().speed);
    anchors.end = end_;
    return judgeWalk(clip_, synthesizer_.roles(), walk_, ground_, anchors);
  }
  QualityLine line(const std::string& measure) const {
    for (const QualityLine& each : judged()) {
      if (each.measure == measure) return each;
    }
    ADD_FAILURE() << "no line '" << measure << "'";
    return {};
  }

  FlatGround ground_;
  MotionLibrary library_;
  WalkSynthesizer synthesizer_;
  AnimationBuffer walk_;
  Clip clip_;
  StancePelvis end_;
};

TEST_F(JudgeWalk, AStraightWalkHoldsEveryBar) {
  const auto lines = judged();
  EXPECT_GE(lines.size(), 14u);
  for (const QualityLine& each : lines) {
    EXPECT_TRUE(each.holds()) << each.measure << " is " << each.value << " " << each.unit
                              << "; expected at most " << each.bar;
  }
}

// 3 cm/s to the side: planted toes travel as fast.
TEST_F(JudgeWalk, ADragIsSkateAndDrift) {
  for (int i = 0; i < clip_.frames(); ++i) clip_.poses.p_WR(i).y() += 0.03 * i * walk_.frame_time;
  EXPECT_FALSE(line("toe skate").holds());
  EXPECT_NEAR(line("toe skate").value, 0.03, 0.01);
  EXPECT_FALSE(line("drift per plant").holds());
}

// In mid-walk a pelvis sways and turns with the step: it is compared with that stance's own.
TEST_F(JudgeWalk, AnEndInMidWalkIsItsStances) {
  for (const double speed : {0.5, 1.2, 1.8}) {
    const WalkSynthesizer walker(library_, ground_, {.speed = speed});
    for (const double length : {0.0, 4.0, 5.3}) {
      Stance from, to;
      from.standing = to.standing = false;
      from.position = {2, -1, 0};
      from.heading = to.heading = 0.7;
      to.position = from.position + length * Eigen::Vector3d(std::cos(0.7), std::sin(0.7), 0.0);
      if (length == 0.0) {
        ASSERT_EQ(walker.stand(from, walk_).refused, WalkRule::kNone);
      } else {
        const RootPath path({makeBezier(from.position.head<2>(), 0.7, to.position.head<2>(), 0.7)});
        const WalkResult walked = walker.walk(from, to, path, true, walk_);
        ASSERT_EQ(walked.refused, WalkRule::kNone) << speed << " " << length;
        to.leading = walked.leading;
      }
      clip_ = {"walk", walker.skeleton(), walk_.frame_time, walk_.poses, {}};
      end_ = pelvisOf(walker, to);
      EXPECT_GT(std::abs(end_.left), 0.005) << "nobody sways so little";
      for (const char* measure : {"path error, mean", "path error, end", "end heading"})
        EXPECT_TRUE(line(measure).holds()) << measure << " " << speed << " " << length;
      EXPECT_NEAR(line("path error, end").value, 0.0, 1e-9);
      EXPECT_NEAR(line("end heading").value, 0.0, 1e-6);
      const int last = clip_.frames() - 1;  // 5 cm beside it is an error still
      clip_.poses.p_WR(last).x() += 0.05;
      EXPECT_NEAR(line("path error, end").value, 0.05, 1e-9);
    }
  }
}

TEST_F(JudgeWalk, WhoStandsHasHisPelvisOverThePath) {
  const StancePelvis stands = pelvisOf(synthesizer_, Stance{});
  EXPECT_EQ(stands.ahead, 0.0);
  EXPECT_EQ(stands.left, 0.0);
  EXPECT_EQ(stands.turned, 0.0);
}

TEST_F(JudgeWalk, AWalkBesideItsPathIsAPathError) {
  for (int i = 0; i < clip_.frames(); ++i) clip_.poses.p_WR(i).y() += 0.1;
  EXPECT_NEAR(line("path error, end").value, 0.1, 0.02);
  EXPECT_FALSE(line("path error, mean").holds());
  EXPECT_FALSE(line("path error, end").holds());
}

TEST_F(JudgeWalk, AWalkFasterThanItsPlanIsNotWhatWasAsked) {
  for (int i = 0; i < clip_.frames(); ++i) clip_.poses.p_WR(i).x() *= 1.2;
  EXPECT_NEAR(line("speed, achieved against asked").value, 0.2, 0.03);
  EXPECT_FALSE(line("speed, achieved against asked").holds());
}

// A pelvis that is where its plan has it goes as fast as was asked.
TEST_F(JudgeWalk, AWalkThatIsWhereItsPlanHasItIsAsFastAsAsked) {
  for (const double length : {4.5, 6.0, 8.0}) {
    walkFrom({0, 0, 0}, 0.4, length);
    const std::vector<Eigen::Vector3d> pelvis = pelvisPath(clip_, synthesizer_.roles());
    for (int i = 0; i < clip_.frames(); ++i)
      clip_.poses.p_WR(i).head<2>() += (walk_.states[i].position - pelvis[i]).head<2>();
    EXPECT_LT(line("speed, achieved against asked").value, 1e-9) << length;
  }
}

// Frames fall where they will between strikes and lift-offs: the time between these does not.
TEST_F(JudgeWalk, DoubleSupportIsTheSameAtAnyFrameRate) {
  for (const double speed : {0.9, 2.0}) {
    std::vector<double> off;
    for (const double fps : {48.0, 60.0, 75.0, 240.0}) {
      const WalkSynthesizer walker(library_, ground_, {.speed = speed, .frame_time = 1.0 / fps});
      walkTo(walker, 6.0);
      off.push_back(line("double support, from its norm").value);
    }
    for (const double each : off) EXPECT_NEAR(each, off.back(), 0.006) << speed;
  }
}

// Short and slow, steps are so smooth that they hide no corner of an ankle's way, and slower than
// any captured walk they have their own speed's double support.
TEST_F(JudgeWalk, ShortSlowWalksHoldEveryBar) {
  for (const double height : {1.4, 1.5, 1.6, 1.8, 2.0}) {
    for (const double speed : {0.4, 0.6, 0.8}) {
      const WalkSynthesizer walker(library_, ground_, {.height = height, .speed = speed});
      for (const double length : {1.05, 1.4, 2.1, 3.2}) {
        walkTo(walker, length * walker.shortestWalk());
        for (const QualityLine& each : judged()) {
          EXPECT_TRUE(each.holds()) << each.measure << " is " << each.value << " of " << each.bar
                                    << ": " << height << " m, " << speed << " m/s, " << length;
        }
      }
    }
  }
}

TEST_F(JudgeWalk, WhereAWalkIsAndWhichWayItFacesIsNothingToItsQuality) {
  const auto here = judged();
  walkFrom({-40.0, 7.5, 0.0}, 2.5);
  const auto there = judged();
  ASSERT_EQ(there.size(), here.size());
  for (size_t i = 0; i < here.size(); ++i) {
    EXPECT_EQ(there[i].measure, here[i].measure);
    EXPECT_NEAR(there[i].value, here[i].value, 0.01 * std::max(1.0, std::abs(here[i].value)))
        << here[i].measure;
    EXPECT_NEAR(there[i].bar, here[i].bar, 1e-6 * std::max(1.0, here[i].bar)) << here[i].measure;
  }
}

TEST_F(JudgeWalk, AJointThatFlipsOverForAFrameIsAPopAndAJerk) {
  const int arm = synthesizer_.roles().arms[kLeft].arm;
  Eigen::Quaterniond& q = clip_.poses.rotations(clip_.frames() / 2)[arm];
  q = q * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX());
  EXPECT_FALSE(line("pops").holds());
}

TEST_F(JudgeWalk, AKneeThatBendsBackwardsIsSeenForAsLongAsItDoes) {
  EXPECT_EQ(line("knee backwards").value, 0.0);
  const int knee = synthesizer_.roles().legs[kRight].leg;
  Eigen::AngleAxisd most(0.0, Eigen::Vector3d::UnitX());
  for (int i = 0; i < clip_.frames(); ++i) {
    const Eigen::AngleAxisd bend(clip_.poses.rotations(i)[knee]);
    if (bend.angle() > most.angle()) most = bend;
  }
  const int tenth = clip_.frames() / 10;
  for (int i = 0; i < tenth; ++i)
    clip_.poses.rotations(i)[knee] = Eigen::AngleAxisd(-0.6, most.axis());
  EXPECT_NEAR(line("knee backwards").value, 0.1, 0.01);
  EXPECT_FALSE(line("knee backwards").holds());
}

TEST_F(JudgeWalk, AFootThatTurnsOverInAFrameIsTold) {
  const int foot = synthesizer_.roles().legs[kRight].foot;
  Eigen::Quaterniond& q = clip_.poses.rotations(clip_.frames() / 2)[foot];
  q = q * Eigen::Quaterniond(Eigen::AngleAxisd(25.0 * kDegree, Eigen::Vector3d::UnitX()));
  EXPECT_FALSE(line("foot turn").holds());
  EXPECT_NEAR(line("foot turn").value, 25.0 / walk_.frame_time, 12.0 / walk_.frame_time);
}

// Feet are as fast as captured ones up to the fastest walk.
TEST_F(JudgeWalk, NoSpeedTurnsAFootOver) {
  for (const double speed : {0.5, 1.0, 1.6, 2.0}) {
    const WalkSynthesizer walker(library_, ground_, {.speed = speed});
    Stance from, to;
    to.position = {6.0, 0.0, 0.0};
    const RootPath path({makeBezier(from.position.head<2>(), 0.0, to.position.head<2>(), 0.0)});
    ASSERT_EQ(walker.walk(from, to, path, true, walk_).refused, WalkRule::kNone) << speed;
    clip_.poses = walk_.poses;
    EXPECT_TRUE(line("foot turn").holds()) << line("foot turn").value << " at " << speed;
  }
}

// At speeds that look alike (Froude) people of any height are judged alike; of grown ones, whose
// legs are 0.75 to 1 m long, the bars are those of the captures.
TEST_F(JudgeWalk, BarsOfThePathAndOfFeetThatTurnGrowAndShrinkWithTheBody) {
  const QualityLine grown_turn = line("foot turn"), grown_path = line("path error, mean");
  for (const double height : {0.6, 1.0, 1.3, 1.75, 2.5}) {
    const double speed = 1.4 * std::sqrt(height / library_.stature);
    const WalkSynthesizer walker(library_, ground_, {.height = height, .speed = speed});
    Stance from, to;
    to.position.x() = 6.0 * height / library_.stature;
    const RootPath path({makeBezier(from.position.head<2>(), 0.0, to.position.head<2>(), 0.0)});
    ASSERT_EQ(walker.walk(from, to, path, true, walk_).refused, WalkRule::kNone) << height;
    clip_ = {"walk", walker.skeleton(), walk_.frame_time, walk_.poses, {}};
    const JointRoles& roles = walker.roles();
    const double leg = 0.5 * (roles.legLength(walker.skeleton(), kLeft) +
                              roles.legLength(walker.skeleton(), kRight));
    const double scale = leg < 0.75 ? leg / 0.75 : leg > 1.0 ? leg : 1.0;
    const QualityLine turn = line("foot turn"), mean = line("path error, mean");
    EXPECT_TRUE(turn.holds()) << height << ": " << turn.value << " of " << turn.bar;
    EXPECT_TRUE(mean.holds()) << height << ": " << mean.value << " of " << mean.bar;
    EXPECT_NEAR(turn.bar, grown_turn.bar / std::sqrt(scale), 1e-6 * turn.bar) << height;
    EXPECT_NEAR(mean.bar, grown_path.bar * scale, 1e-6) << height;
  }
}

TEST_F(JudgeWalk, ASunkenFrameIsPenetration) {
  clip_.poses.p_WR(clip_.frames() / 2).z() -= 0.05;
  EXPECT_FALSE(line("penetration").holds());
}

TEST_F(JudgeWalk, StandingHasNoSpeedToJudge) {
  ASSERT_EQ(synthesizer_.stand({}, walk_).refused, WalkRule::kNone);
  clip_.poses = walk_.poses;
  for (const QualityLine& each : judged()) {
    EXPECT_TRUE(each.holds()) << each.measure;
    EXPECT_NE(each.measure, "speed, achieved against asked");
  }
}

}  // namespace
}  // namespace amble
