#include "animation/grafting/graft_clip.h"

#include <gtest/gtest.h>

#include <sstream>

#include "animation/captures/bvh.h"
#include "animation/clips/good_frames.h"
#include "animation/clips/mirror_clip.h"
#include "animation/grafting/arm_leg_phase.h"
#include "animation/grafting/kinematic_chains.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/grafting/graft_sources.h"

namespace amble {
namespace {

Graft grafted(const LocomotiveClip& base, const LocomotiveClip& upper,
              const GraftWishes& wishes = {}) {
  const GraftPlan plan = planGraft(base, upper, wishes);
  EXPECT_EQ(plan.refusal, "");
  return makeGraft(base, upper, plan, wishes);
}

// Numbers of a BVH's motion, a row a frame, and for each the joint that it belongs to.
std::vector<std::vector<std::string>> motionOf(const Clip& clip) {
  std::ostringstream text;
  writeBvh(text, clip);
  std::istringstream in(text.str());
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line) && !line.starts_with("Frame Time");) continue;
  for (std::string line; std::getline(in, line);) {
    std::istringstream numbers(line);
    rows.emplace_back();
    for (std::string number; numbers >> number;) rows.back().push_back(number);
  }
  return rows;
}

size_t firstChannel(int joint) { return joint == 0 ? 0 : 3 + 3 * static_cast<size_t>(joint); }

TEST(GraftClip, TheLowerBodyIsTheBasesToTheLastDigitOfTheBvh) {
  AMBLE_NEEDS_CAPTURES();
  const LocomotiveClip &base = graftSource(kWalk), &upper = graftSource(kRun);
  GraftWishes wishes;
  wishes.chains = {"upper"};
  const Graft graft = grafted(base, upper, wishes);
  const std::vector<bool> lower = lowerBody(base.clip.skeleton, base.roles);
  const auto was = motionOf(base.clip), is = motionOf(graft.clip);
  ASSERT_EQ(was.size(), is.size());
  bool changed = false;
  for (size_t i = 0; i < was.size(); ++i) {
    for (int j = 0; j < base.clip.skeleton.size(); ++j) {
      const size_t at = firstChannel(j), count = j == 0 ? 6 : 3;
      const bool same =
          std::equal(was[i].begin() + at, was[i].begin() + at + count, is[i].begin() + at);
      EXPECT_TRUE(same || !lower[j]) << "frame " << i << ", " << base.clip.skeleton.joint(j).name;
      changed = changed || !same;
    }
  }
  EXPECT_TRUE(changed);
}

// The thesis' nine, of real clips: what is on at least a third of a second of the base.
TEST(GraftClip, EveryPermittedPairIsMadeAndEveryOtherRefused) {
  AMBLE_NEEDS_CAPTURES();
  const char* const clips[] = {kStand, kWalk, kRun, kJump};
  int made = 0;
  for (const char* const upper : clips) {
    for (const char* const base : clips) {
      const GraftPlan plan = planGraft(graftSource(base), graftSource(upper), {});
      if (!plan.refusal.empty()) {
        EXPECT_NE(plan.refusal.find("thesis 5.4.2, rule"), std::string::npos) << plan.refusal;
        continue;
      }
      const Graft graft = makeGraft(graftSource(base), graftSource(upper), plan, {});
      EXPECT_GT((graft.last - graft.first) * graft.clip.frame_time, 0.33) << upper << " " << base;
      EXPECT_EQ(graft.clip.frames(), graftSource(base).clip.frames());
      ++made;
    }
  }
  EXPECT_EQ(made, 9);
}

TEST(GraftClip, NoJointPopsWhereArmsPassOver) {
  AMBLE_NEEDS_CAPTURES();
  const std::pair<const char*, const char*> pairs[] = {
      {kWalk, kRun},   {kRun, kWalk},
      {kWalk, kStand}, {kLongWalk, kCarry},
      {kJump, kStand}, {"cmu_mb2/07_01.bvh", "accad_female1/Female1_D3_ConversationGestures.bvh"}};
  for (const auto& [base, upper] : pairs) {
    const Graft graft = grafted(graftSource(base), graftSource(upper));
    EXPECT_LE(graft.acceleration, 1.05 * graft.source_acceleration) << upper << " on " << base;
  }
}

TEST(GraftClip, ArmsSwingAgainstTheLegsOfTheBaseAsTheyDidAgainstTheirOwn) {
  AMBLE_NEEDS_CAPTURES();
  const std::pair<const char*, const char*> pairs[] = {
      {kWalk, kRun}, {kRun, kWalk}, {kLongWalk, kWalk}, {"cmu_mb2/07_12.bvh", "cmu_mb2/09_06.bvh"}};
  for (const auto& [base_path, upper_path] : pairs) {
    const LocomotiveClip &base = graftSource(base_path), &upper = graftSource(upper_path);
    const Graft graft = grafted(base, upper);
    const auto own =
        armLegPhase(upper.clip, upper.roles, static_cast<int>(std::ceil(graft.upper_frame.front())),
                    static_cast<int>(std::floor(graft.upper_frame.back())));
    const auto here = armLegPhase(graft.clip, base.roles, graft.first, graft.last);
    const auto bases = armLegPhase(base.clip, base.roles, graft.first, graft.last);
    for (const Side side : {kLeft, kRight}) {
      EXPECT_GT(here[side], std::min(own[side], bases[side]) - 0.05)
          << upper_path << " on " << base_path;
    }
  }
}

// Cut off by some frames the upper clip is another clip, whose plants are counted otherwise.
TEST(GraftClip, AShiftedUpperClipGivesTheSameGraft) {
  AMBLE_NEEDS_CAPTURES();
  const LocomotiveClip &base = graftSource(kWalk), &upper = graftSource(kLongWalk);
  GraftWishes wishes;
  wishes.range = {60, 250};
  wishes.ease = 0.2;
  const Graft graft = grafted(base, upper, wishes);
  const int cut = static_cast<int>(graft.upper_frame.front()) - 8;
  ASSERT_GT(cut, 0);
  Clip later = trimmed(upper.clip, cut, upper.clip.frames() - 1);
  const Graft again = grafted(base, locomotiveClip(std::move(later), upper.roles, "cut"), wishes);
  double worst = 0.0;
  for (int i = graft.first + 20; i <= graft.last - 20; ++i) {
    for (const int j : graft.joints) {
      worst = std::max(worst, graft.clip.poses.rotations(i)[j].angularDistance(
                                  again.clip.poses.rotations(i)[j]));
    }
  }
  EXPECT_LT(worst, 1.0 * kDegree);
}

// Left arms with left legs, whichever foot the clip begins with: what is mirrored before is as what
// is mirrored after.
TEST(GraftClip, TheGraftOfMirroredClipsIsTheMirroredGraft) {
  AMBLE_NEEDS_CAPTURES();
  const LocomotiveClip &base = graftSource(kWalk), &upper = graftSource(kRun);
  const auto mirrored = [](const LocomotiveClip& clip) {
    Clip good = trimmed(clip.clip, 1, clip.clip.frames() - 1);
    return locomotiveClip(mirrorClip(good, clip.roles), clip.roles, clip.file);
  };
  const LocomotiveClip plain =
      locomotiveClip(trimmed(base.clip, 1, base.clip.frames() - 1), base.roles, base.file);
  const Graft after = grafted(plain, upper), before = grafted(mirrored(base), mirrored(upper));
  const Clip image = mirrorClip(after.clip, base.roles);
  ASSERT_NEAR(before.first, after.first, 1);
  double sum = 0.0;
  int count = 0;
  for (int i = after.first + 25; i <= after.last - 25; ++i) {
    for (const int j : after.joints) {
      sum += image.poses.rotations(i)[j].angularDistance(before.clip.poses.rotations(i)[j]);
      ++count;
    }
  }
  EXPECT_LT(sum / count, 1.0 * kDegree);
}

// A mirrored clip begins with the other foot: by the feet it is a step aside.
TEST(GraftClip, AMirroredUpperClipIsInStepAgain) {
  AMBLE_NEEDS_CAPTURES();
  const LocomotiveClip &base = graftSource(kLongWalk), &upper = graftSource(kWalk);
  Clip good = trimmed(upper.clip, 1, upper.clip.frames() - 1);
  const LocomotiveClip mirrored =
      locomotiveClip(mirrorClip(good, upper.roles), upper.roles, "mirrored");
  const GraftPlan one = planGraft(base, upper, {}), other = planGraft(base, mirrored, {});
  ASSERT_TRUE(one.alternatives[0].same_foot && other.alternatives[0].same_foot);
  EXPECT_EQ((one.alternatives[0].shift + other.alternatives[0].shift) % 2 == 0, false);
  const Graft a = makeGraft(base, upper, one, {}), b = makeGraft(base, mirrored, other, {});
  const auto phase = armLegPhase(b.clip, base.roles, b.first, b.last);
  EXPECT_GT(std::min(phase[kLeft], phase[kRight]), 0.8);
  EXPECT_GT(a.last - a.first, 20);
}

TEST(GraftClip, AStepAsideArmsSwingWithTheirOwnLegs) {
  AMBLE_NEEDS_CAPTURES();
  const LocomotiveClip &base = graftSource(kWalk), &upper = graftSource(kLongWalk);
  GraftWishes wishes;
  wishes.ease = 0.1;
  const GraftPlan plan = planGraft(base, upper, wishes);
  while (plan.alternatives[wishes.alternative].same_foot) ++wishes.alternative;
  EXPECT_GT(plan.alternatives[wishes.alternative].mismatch, 3.0 * plan.alternatives[0].mismatch);
  const Graft aside = makeGraft(base, upper, plan, wishes);
  const auto phase = armLegPhase(aside.clip, base.roles, aside.first, aside.last);
  EXPECT_LT(std::max(phase[kLeft], phase[kRight]), -0.5);
}

TEST(GraftClip, OutsideOfItsRangeAndOnItselfNothingChanges) {
  AMBLE_NEEDS_CAPTURES();
  const LocomotiveClip& base = graftSource(kWalk);
  GraftWishes wishes;
  wishes.range = {100, 250};
  const Graft part = grafted(base, graftSource(kRun), wishes);
  EXPECT_GE(part.first, 100);
  EXPECT_LE(part.last, 250);
  for (int i = 0; i < base.clip.frames(); ++i) {
    if (i > part.first && i < part.last) continue;
    for (int j = 0; j < base.clip.skeleton.size(); ++j) {
      EXPECT_EQ(part.clip.poses.rotations(i)[j].coeffs(), base.clip.poses.rotations(i)[j].coeffs());
    }
  }
  const Graft same = grafted(base, base);
  for (int i = 0; i < base.clip.frames(); ++i) {
    for (const int j : same.joints) {
      EXPECT_LT(same.clip.poses.rotations(i)[j].angularDistance(base.clip.poses.rotations(i)[j]),
                1e-7);
    }
  }
}

TEST(GraftClip, FramesAndAlternativesThatAreNotThereAreRefused) {
  AMBLE_NEEDS_CAPTURES();
  const LocomotiveClip &base = graftSource(kWalk), &upper = graftSource(kRun);
  GraftWishes wishes;
  wishes.range = {10, 100000};
  EXPECT_THROW(planGraft(base, upper, wishes), InputError);
  wishes = {};
  wishes.action = {50, 50};
  EXPECT_THROW(planGraft(base, upper, wishes), InputError);
  wishes = {};
  wishes.alternative = 1000;
  EXPECT_THROW(planGraft(base, upper, wishes), InputError);
  wishes = {};
  wishes.range = {100, 130};  // less than two changes of feet
  EXPECT_NE(planGraft(base, upper, wishes).refusal.find("5.3.1"), std::string::npos);
}

}  // namespace
}  // namespace amble
