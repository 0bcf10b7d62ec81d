// A good walk that is spoilt in one way fails the bars of that and keeps the others: each bar
// watches its own thing.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "animation/library/motion_library_reader.h"
#include "animation/quality/step_measures.h"
#include "animation/quality/walk_quality.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/rotation.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

using Names = std::set<std::string>;

/// Five metres straight ahead, made once.
struct GoodWalk {
  FlatGround ground;
  MotionLibrary library = openMotionLibrary("default");
  WalkSynthesizer walker{library, ground, {}};
  AnimationBuffer walk;
  Clip clip;
  QualityAnchors anchors = anchorsOf(library, 1.0, walker.settings().speed);

  GoodWalk() {
    Stance from, to;
    to.position = {5.0, 0.0, 0.0};
    const RootPath path({makeBezier(from.position.head<2>(), 0.0, to.position.head<2>(), 0.0)});
    EXPECT_EQ(walker.walk(from, to, path, true, walk).refused, WalkRule::kNone);
    clip = {"walk", walker.skeleton(), walk.frame_time, walk.poses, {}};
  }
  std::vector<QualityLine> judged(const Clip& spoilt) const {
    return judgeWalk(spoilt, walker.roles(), walk, ground, anchors);
  }
  /// Which bars a spoilt clip fails.
  Names failed(const std::function<void(Clip&)>& spoil) const {
    Clip spoilt = clip;
    spoil(spoilt);
    Names names;
    for (const QualityLine& line : judged(spoilt)) {
      if (!line.holds()) names.insert(line.measure);
    }
    return names;
  }
};

const GoodWalk& goodWalk() {
  static const GoodWalk kWalk;
  return kWalk;
}

/// 0 at the clip's ends and 1 in its middle, with no jerk anywhere.
double bell(const Clip& clip, int frame) {
  return 0.5 - 0.5 * std::cos(2.0 * kPi * frame / (clip.frames() - 1.0));
}

TEST(SpoiltWalk, WithoutASpoiltFrameNoBarFails) {
  EXPECT_EQ(goodWalk().failed([](Clip&) {}), Names());
}

// Gently, so that nothing but the height is other than it was.
TEST(SpoiltWalk, SunkGentlyItPenetratesAndNothingElse) {
  const Names failed = goodWalk().failed([](Clip& clip) {
    for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).z() -= 0.03 * bell(clip, i);
  });
  EXPECT_EQ(failed, Names{"penetration"});
}

TEST(SpoiltWalk, LiftedGentlyItKeepsItsPathAndSlidesNoFoot) {
  const Names failed = goodWalk().failed([](Clip& clip) {
    for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).z() += 0.03 * bell(clip, i);
  });
  for (const char* const other : {"toe skate", "drift per plant", "path error, mean", "pops",
                                  "knee backwards", "speed, achieved against asked"}) {
    EXPECT_FALSE(failed.contains(other)) << other;
  }
}

TEST(SpoiltWalk, BesideItsPathItIsOffThePathAndNothingElse) {
  for (const double turn : {0.0, 0.5 * kPi, -0.5 * kPi}) {
    const Names failed = goodWalk().failed([turn](Clip& clip) {
      for (int i = 0; i < clip.frames(); ++i) {
        clip.poses.p_WR(i) += aboutZ(turn) * Eigen::Vector3d(0.09, 0.0, 0.0);
      }
    });
    EXPECT_TRUE(failed.contains("path error, end")) << turn;
    if (turn != 0.0) {
      EXPECT_EQ(failed, (Names{"path error, mean", "path error, largest", "path error, end"}));
    }
    EXPECT_FALSE(failed.contains("toe skate")) << turn;
    EXPECT_FALSE(failed.contains("joint jerk")) << turn;
  }
}

TEST(SpoiltWalk, SlidAsideItSkatesAndDriftsAndIsNoRougher) {
  const Names failed = goodWalk().failed([](Clip& clip) {
    for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).y() += 0.05 * i * clip.frame_time;
  });
  EXPECT_TRUE(failed.contains("toe skate"));
  EXPECT_TRUE(failed.contains("drift per plant"));
  for (const char* const other : {"root acceleration", "joint jerk", "pops", "foot turn",
                                  "knee backwards", "penetration", "flight", "end heading"}) {
    EXPECT_FALSE(failed.contains(other)) << other;
  }
}

TEST(SpoiltWalk, TurnedAtItsEndOnlyItsHeadingIsOff) {
  const Names failed = goodWalk().failed([](Clip& clip) {
    // About the last root's place, over the last second, in which feet stand: they turn with it.
    const int from = clip.frames() - static_cast<int>(1.0 / clip.frame_time);
    const Eigen::Vector3d centre = clip.poses.p_WR(clip.frames() - 1);
    for (int i = from; i < clip.frames(); ++i) {
      const double share = static_cast<double>(i - from) / (clip.frames() - 1 - from);
      const Eigen::Quaterniond turn = aboutZ(4.0 * kDegree * (0.5 - 0.5 * std::cos(kPi * share)));
      clip.poses.p_WR(i) = centre + turn * (clip.poses.p_WR(i) - centre);
      clip.poses.rotations(i)[0] = turn * clip.poses.rotations(i)[0];
    }
  });
  EXPECT_TRUE(failed.contains("end heading"));
  for (const char* const other :
       {"path error, end", "pops", "knee backwards", "penetration", "flight", "foot turn"}) {
    EXPECT_FALSE(failed.contains(other)) << other;
  }
}

TEST(SpoiltWalk, JoltedOnceItsRootAcceleratesAndItsJointsDoNotPop) {
  const Names failed =
      goodWalk().failed([](Clip& clip) { clip.poses.p_WR(clip.frames() / 2).x() += 0.06; });
  EXPECT_TRUE(failed.contains("root acceleration"));
  for (const char* const other : {"pops", "knee backwards", "bone length change", "end heading",
                                  "path error, mean", "flight", "foot turn"}) {
    EXPECT_FALSE(failed.contains(other)) << other;
  }
}

TEST(SpoiltWalk, TwistedForAFrameAnArmPopsAndItsFeetStand) {
  const Names failed = goodWalk().failed([](Clip& clip) {
    const int arm = goodWalk().walker.roles().arms[kRight].fore_arm;
    Eigen::Quaterniond& q = clip.poses.rotations(clip.frames() / 2)[arm];
    q = q * expRotation({0.6, 0.0, 0.0});
  });
  EXPECT_TRUE(failed.contains("pops"));
  for (const char* const other :
       {"toe skate", "drift per plant", "penetration", "root acceleration", "foot turn",
        "knee backwards", "path error, largest", "end heading", "flight"}) {
    EXPECT_FALSE(failed.contains(other)) << other;
  }
}

TEST(SpoiltWalk, ShakenItJerks) {
  Generator generator(701);
  const Names failed = goodWalk().failed([&](Clip& clip) {
    for (int i = 0; i < clip.frames(); ++i) {
      for (const ArmJoints& arm : goodWalk().walker.roles().arms) {
        Eigen::Quaterniond& q = clip.poses.rotations(i)[arm.arm];
        q = q * expRotation(randomVector(generator, 0.12));
      }
    }
  });
  EXPECT_TRUE(failed.contains("joint jerk"));
  EXPECT_FALSE(failed.contains("root acceleration"));
  EXPECT_FALSE(failed.contains("toe skate"));
  EXPECT_FALSE(failed.contains("path error, mean"));
}

TEST(SpoiltWalk, StretchedItIsFasterThanAskedAndSlides) {
  const Names failed = goodWalk().failed([](Clip& clip) {
    for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).x() *= 1.1;
  });
  EXPECT_TRUE(failed.contains("speed, achieved against asked"));
  EXPECT_TRUE(failed.contains("toe skate"));
  EXPECT_FALSE(failed.contains("pops"));
  EXPECT_FALSE(failed.contains("penetration"));
}

TEST(SpoiltWalk, WithABoneThatGrowsItsBonesChangeByThat) {
  Clip clip = goodWalk().clip;
  for (int i = 0; i < clip.frames(); ++i) {
    for (const Joint& joint : clip.skeleton.joints()) clip.joint_positions.push_back(joint.offset);
  }
  const int hand = goodWalk().walker.roles().arms[kLeft].hand;
  const auto change = [&] {
    for (const QualityLine& line : goodWalk().judged(clip)) {
      if (line.measure == "bone length change") return line;
    }
    return QualityLine{};
  };
  EXPECT_TRUE(change().holds());
  const int frame = clip.frames() / 2;
  Eigen::Vector3d& p = clip.joint_positions[frame * clip.skeleton.size() + hand];
  const double length = p.norm();
  p *= 1.1;
  EXPECT_NEAR(change().value, 0.1 * length, 1e-9);
  EXPECT_FALSE(change().holds());
}

TEST(SpoiltWalk, WorseIsNeverBetter) {
  const auto value = [](const std::string& measure, const std::function<void(Clip&)>& spoil) {
    Clip spoilt = goodWalk().clip;
    spoil(spoilt);
    for (const QualityLine& line : goodWalk().judged(spoilt)) {
      if (line.measure == measure) return line.value;
    }
    return std::nan("");
  };
  double skate = 0.0, depth = 0.0, aside = 0.0;
  for (const double by : {0.02, 0.04, 0.08, 0.16}) {
    const double slid = value("toe skate", [by](Clip& clip) {
      for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).y() += by * i * clip.frame_time;
    });
    const double sunk = value("penetration", [by](Clip& clip) {
      for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).z() -= by;
    });
    const double off = value("path error, mean", [by](Clip& clip) {
      for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).y() += by;
    });
    EXPECT_GT(slid, skate);
    EXPECT_GT(off, aside);
    EXPECT_GE(sunk, depth - 1e-12);  // measured from where feet stand: rounding
    skate = slid, depth = sunk, aside = off;
  }
  EXPECT_NEAR(skate, 0.16, 0.02);
  EXPECT_NEAR(aside, 0.16, 0.02);
}

/// A step that came to what it was asked to be, on level ground.
JudgedStep goodStep() {
  JudgedStep step;
  step.asked.stride = step.achieved.stride = 0.6;
  step.asked.lift = step.achieved.lift = 0.1;
  step.asked.climb = step.achieved.climb = 0.15;
  step.achieved.supported = 1.0;
  return step;
}

Names failedSteps(const std::function<void(JudgedStep&)>& spoil) {
  std::vector<JudgedStep> steps(7, goodStep());
  spoil(steps[4]);
  Names names;
  for (const QualityLine& line : judgeSteps(steps)) {
    if (!line.holds()) names.insert(line.measure);
  }
  return names;
}

TEST(JudgeSteps, EachBarWatchesItsOwnParameterOfTheWorstStep) {
  EXPECT_TRUE(judgeSteps({}).empty());
  EXPECT_EQ(failedSteps([](JudgedStep&) {}), Names());
  EXPECT_EQ(failedSteps([](JudgedStep& s) { s.achieved.stride *= 1.03; }),
            Names{"step length, achieved against asked"});
  EXPECT_EQ(failedSteps([](JudgedStep& s) { s.achieved.lift *= 0.97; }),
            Names{"lift, achieved against asked"});
  EXPECT_EQ(failedSteps([](JudgedStep& s) { s.achieved.climb *= 1.03; }),
            Names{"rise per step, achieved against asked"});
  EXPECT_EQ(failedSteps([](JudgedStep& s) { s.achieved.tilt = 3.1 * kDegree; }),
            Names{"sole to ground at mid-stance"});
  EXPECT_EQ(failedSteps([](JudgedStep& s) { s.achieved.supported = 0.69; }),
            Names{"unsupported share of a sole"});
}

TEST(JudgeSteps, JustWithinTheBarsAStepHolds) {
  EXPECT_EQ(failedSteps([](JudgedStep& s) {
              s.achieved.stride *= 1.019;
              s.achieved.lift *= 0.981;
              s.achieved.climb *= 1.019;
              s.achieved.tilt = 2.9 * kDegree;
              s.achieved.supported = 0.71;
            }),
            Names());
}

TEST(JudgeSteps, TheOrderOfStepsIsNothingToThem) {
  Generator generator(702);
  std::vector<JudgedStep> steps(9, goodStep());
  for (JudgedStep& step : steps) {
    step.achieved.stride += uniform(generator, -0.1, 0.1);
    step.achieved.lift += uniform(generator, -0.05, 0.05);
    step.achieved.tilt = uniform(generator, 0.0, 0.1);
    step.achieved.supported = uniform(generator, 0.5, 1.0);
  }
  const auto before = judgeSteps(steps);
  std::reverse(steps.begin(), steps.end());
  const auto after = judgeSteps(steps);
  for (size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[i].value, before[i].value);
  // A step more is never better.
  steps.push_back(goodStep());
  steps.back().achieved.stride = 1.0;
  const auto more = judgeSteps(steps);
  for (size_t i = 0; i < before.size(); ++i) EXPECT_GE(more[i].value, before[i].value);
  EXPECT_NEAR(more[0].value, 0.4 / 0.6, 1e-12);
}

TEST(QualityLines, AreNamedOnceWithUnitsAndBarsThatCanBeHeld) {
  Names names;
  for (const QualityLine& line : goodWalk().judged(goodWalk().clip)) {
    EXPECT_TRUE(names.insert(line.measure).second) << line.measure;
    EXPECT_FALSE(line.unit.empty()) << line.measure;
    EXPECT_GE(line.bar, 0.0) << line.measure;
    EXPECT_GE(line.value, 0.0) << line.measure;
  }
}

}  // namespace
}  // namespace amble
