#include "animation/clips/blend_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/animation/planted_clip.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

/// `#` is a frame in which the foot stands.
std::vector<FootHold> contacts(const std::string& before, const std::string& after) {
  const auto planted = [](const std::string& drawn) {
    std::vector<bool> values;
    for (const char c : drawn) values.push_back(c == '#');
    return values;
  };
  return contactsOf(kRight, planted(before), planted(after), 2);
}

void expectHold(const FootHold& hold, ContactCase which, int first, int last) {
  EXPECT_EQ(hold.which, which);
  EXPECT_EQ(hold.first, first);
  EXPECT_EQ(hold.last, last);
  EXPECT_EQ(hold.side, kRight);
}

TEST(BlendContacts, AFootThatStandsAsTheBlendBeginsGoesWithTheMotionBefore) {
  const auto holds = contacts("####...........", "##.............");
  ASSERT_EQ(holds.size(), 1u);
  expectHold(holds[0], ContactCase::kBefore, 0, 3);
}

TEST(BlendContacts, AFootThatStandsAsItEndsGoesWithTheMotionAfter) {
  const auto holds = contacts(".............##", "...........####");
  ASSERT_EQ(holds.size(), 1u);
  expectHold(holds[0], ContactCase::kAfter, 11, 14);
}

TEST(BlendContacts, AContactWithinGoesWithTheNearerMotion) {
  const auto early = contacts("..####.........", "....####.......");
  ASSERT_EQ(early.size(), 1u);
  expectHold(early[0], ContactCase::kWithin, 2, 5);
  const auto late = contacts(".......####....", ".........####..");
  ASSERT_EQ(late.size(), 1u);
  expectHold(late[0], ContactCase::kWithin, 9, 12);
}

TEST(BlendContacts, AFootThatStandsThroughoutSlips) {
  for (const auto& [before, after] :
       std::vector<std::pair<std::string, std::string>>{{"###############", "###############"},
                                                        {"########.......", ".....##########"},
                                                        {"######.........", "........#######"}}) {
    const auto holds = contacts(before, after);
    ASSERT_EQ(holds.size(), 1u) << before;
    expectHold(holds[0], ContactCase::kSlips, 0, 14);
  }
}

TEST(BlendContacts, AStepWithinTheBlendLeavesOneAndEntersTheOther) {
  const auto holds = contacts("####...........", "...........####");
  ASSERT_EQ(holds.size(), 2u);
  expectHold(holds[0], ContactCase::kBefore, 0, 3);
  expectHold(holds[1], ContactCase::kAfter, 11, 14);
}

TEST(BlendContacts, AFootThatOnlyTheMotionBeforeKeepsDownLeavesWithTheOneAfter) {
  const auto holds = contacts("###############", "##########.....");
  ASSERT_EQ(holds.size(), 1u);
  expectHold(holds[0], ContactCase::kBefore, 0, 9);
}

/// Over joins at every frame of a cycle, the frames of a walk with those of itself a cycle on and
/// of another's: each held foot goes along the way of its source, and what slips says how far.
TEST(BlendContacts, HeldFeetKeepToTheirSourcesAndEveryCaseComesUp) {
  AMBLE_NEEDS_CAPTURES();
  const PlantedClip walk = plantedClip("accad_female1/Female1_B03_Walk1.bvh");
  std::map<ContactCase, int> seen;
  int held = 0, within = 0;
  for (int leave = 60; leave < 97; ++leave) {
    for (const int blend : {8, 14, 40}) {
      JoinedClip joined = joinedFrom(walk, 0);
      joinOn(joined, walk, walk.roles, {leave, leave + 37, blend});  // a cycle on
      const JoinReport& report = joined.joins[0];
      for (const FootHold& hold : report.feet) {
        ++seen[hold.which];
        std::vector<JointFrame> joints(walk.clip.skeleton.size());
        const int foot = walk.roles.legs[hold.side].toe;
        const auto at = [&](const Clip& clip, int frame) {
          forwardKinematics(clip, frame, joints);
          return joints[foot].p_WJ;
        };
        double off = 0.0;
        for (int i = hold.first; i <= hold.last; ++i) {
          const Eigen::Vector3d before = at(walk.clip, i);
          const Eigen::Vector3d after = report.moved * at(walk.clip, i - report.frame_shift);
          const Eigen::Vector3d is = at(joined.clip, i);
          // Slipping, it goes from the one way to the other, and is on neither for long.
          const double own =
              hold.which == ContactCase::kSlips
                  ? (after - before).head<2>().norm()
                  : std::min((is - before).head<2>().norm(), (is - after).head<2>().norm());
          off = std::max(off, own);
        }
        if (hold.which != ContactCase::kSlips) {
          // Legs that would have to be longer than they are stay short of their way, and say so.
          EXPECT_LE(off, 0.0031) << leave << ' ' << blend;
          ++held, within += off <= 0.002 ? 1 : 0;
        }
        EXPECT_NEAR(hold.slip, off, hold.which == ContactCase::kSlips ? 1e-9 : 0.002);
      }
    }
  }
  EXPECT_GE(within, 0.97 * held);
  for (const ContactCase which :
       {ContactCase::kBefore, ContactCase::kAfter, ContactCase::kWithin, ContactCase::kSlips})
    EXPECT_GT(seen[which], 0) << static_cast<int>(which);
}

std::vector<bool> anyStances(Generator& generator, int frames) {
  std::vector<bool> stands;
  bool now = uniform(generator, 0.0, 1.0) < 0.5;
  while (static_cast<int>(stands.size()) < frames) {
    const int run = std::uniform_int_distribution<int>(3, 12)(generator);
    for (int i = 0; i < run && static_cast<int>(stands.size()) < frames; ++i) stands.push_back(now);
    now = !now;
  }
  return stands;
}

// Whatever the two motions do.
TEST(BlendContacts, ContactsAreInOrderWithinTheBlendAndApart) {
  Generator generator(911);
  for (int round = 0; round < 2000; ++round) {
    const int frames = std::uniform_int_distribution<int>(6, 40)(generator);
    const auto before = anyStances(generator, frames), after = anyStances(generator, frames);
    int last = -1;
    for (const FootHold& hold : contactsOf(kLeft, before, after, 2)) {
      EXPECT_EQ(hold.side, kLeft);
      EXPECT_GT(hold.first, last);
      EXPECT_LE(hold.first, hold.last);
      EXPECT_LT(hold.last, frames);
      last = hold.last;
      EXPECT_EQ(hold.which == ContactCase::kSlips, hold.first == 0 && hold.last == frames - 1);
    }
  }
}

TEST(BlendContacts, AFootThatStandsNowhereHasNoContactAndOneThatStandsAtAnEndHasOneThere) {
  Generator generator(912);
  for (int round = 0; round < 500; ++round) {
    const int frames = std::uniform_int_distribution<int>(6, 40)(generator);
    const std::vector<bool> never(frames, false);
    EXPECT_TRUE(contactsOf(kLeft, never, never, 2).empty());
    const auto before = anyStances(generator, frames), after = anyStances(generator, frames);
    const auto holds = contactsOf(kLeft, before, after, 2);
    if (before.front()) {
      ASSERT_FALSE(holds.empty());
      EXPECT_EQ(holds.front().first, 0);
    }
    if (after.back()) {
      ASSERT_FALSE(holds.empty());
      EXPECT_EQ(holds.back().last, frames - 1);
    }
  }
}

// Backwards, what was before is after. Contacts within are chosen from the begin on.
TEST(BlendContacts, BackwardsAStanceAtTheBeginIsOneAtTheEnd) {
  Generator generator(913);
  const auto atEnds = [](std::vector<FootHold> holds) {
    std::erase_if(holds, [](const FootHold& h) { return h.which == ContactCase::kWithin; });
    return holds;
  };
  int seen = 0;
  for (int round = 0; round < 500; ++round) {
    const int frames = 2 * std::uniform_int_distribution<int>(4, 20)(generator) + 1;
    auto before = anyStances(generator, frames), after = anyStances(generator, frames);
    const auto holds = atEnds(contactsOf(kLeft, before, after, 2));
    std::reverse(before.begin(), before.end());
    std::reverse(after.begin(), after.end());
    const auto back = atEnds(contactsOf(kLeft, after, before, 2));
    ASSERT_EQ(back.size(), holds.size());
    for (size_t i = 0; i < holds.size(); ++i) {
      const FootHold &here = holds[i], &there = back[holds.size() - 1 - i];
      EXPECT_EQ(there.first, frames - 1 - here.last);
      EXPECT_EQ(there.last, frames - 1 - here.first);
      EXPECT_EQ(there.which == ContactCase::kSlips, here.which == ContactCase::kSlips);
      EXPECT_EQ(there.which == ContactCase::kAfter, here.which == ContactCase::kBefore);
      ++seen;
    }
  }
  EXPECT_GT(seen, 200);
}

}  // namespace
}  // namespace amble
