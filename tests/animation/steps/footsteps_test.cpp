#include "animation/steps/footsteps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/library/foot_cycle.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kStepLength = 0.65;

FootPlacement placement() {
  FootPlacement p;
  p.step_length = kStepLength;
  p.forward = 0.02;
  p.walk_toe_out = {0.1, -0.1};
  p.stand_toe_out = 0.15;
  p.supports << 0.12, 0.09, 0.07, 0.1;
  return p;
}

/// A straight walk of `steps` steps along +x, each one step long; half of one next to a standing
/// end.
struct Walk {
  Stance from, to;
  Footsteps steps;

  Walk(bool from_standing, bool to_standing, int count, Side first)
      : from{Eigen::Vector3d::Zero(), 0.0, from_standing, other(first)},
        to{endOf(from_standing, to_standing, count), 0.0, to_standing,
           count % 2 == 1 ? first : other(first)},
        steps(placement(), from, to, count, first) {
    const double begin = from_standing ? 0.0 : 0.5;
    steps.place([&](int i) {
      return footBeside({{kStepLength * (i + begin) + placement().forward, 0.0, 0.0}, 0.0},
                        placement().print(steps.side(i)));
    });
  }
  static Eigen::Vector3d endOf(bool from_standing, bool to_standing, int count) {
    return {kStepLength * (count - (from_standing ? 0.5 : 0.0) - (to_standing ? 0.5 : 0.0)), 0, 0};
  }
};

template <typename Check>
void forWalks(Check check) {
  for (const bool from_standing : {true, false}) {
    for (const bool to_standing : {true, false}) {
      for (const int count : {2, 3, 7}) {
        for (const Side first : {kLeft, kRight}) {
          Walk walk(from_standing, to_standing, count, first);
          check(walk);
        }
      }
    }
  }
}

bool samePlace(const FootPlace& a, const FootPlace& b) {
  return (a.position - b.position).norm() < 1e-9 && std::abs(a.heading - b.heading) < 1e-12;
}

TEST(FootBeside, AFootIsHalfTheWidthToItsSideWithToesOut) {
  const GroundPoint point{{1, 2, 0.5}, kPi / 2};
  const FootPlace left = footBeside(point, {0.0, 0.1, 0.1});
  const FootPlace right = footBeside(point, {0.0, -0.1, -0.1});
  EXPECT_LT((left.position - Eigen::Vector3d(0.9, 2, 0.5)).norm(), 1e-15);
  EXPECT_LT((right.position - Eigen::Vector3d(1.1, 2, 0.5)).norm(), 1e-15);
  EXPECT_NEAR(left.heading - kPi / 2, 0.1, 1e-15);
  EXPECT_NEAR(right.heading - kPi / 2, -0.1, 1e-15);
}

TEST(Footsteps, SidesAlternateFromTheFootThatSwingsFirst) {
  forWalks([](Walk& walk) {
    const Side first = walk.steps.side(1);
    for (int i = -1; i <= walk.steps.steps(); ++i) {
      EXPECT_EQ(walk.steps.side(i), i % 2 != 0 ? first : other(first));
    }
  });
}

TEST(Footsteps, BothEndsAreTheirStancesToTheBit) {
  forWalks([](Walk& walk) {
    for (const bool end : {false, true}) {
      const auto feet = walk.steps.at(end ? walk.steps.steps() : 0.0);
      const auto stance = Footsteps::atStance(placement(), end ? walk.to : walk.from);
      for (const Side side : {kLeft, kRight}) {
        EXPECT_EQ(feet[side].from.position, stance[side].from.position);
        EXPECT_EQ(feet[side].from.heading, stance[side].from.heading);
        EXPECT_EQ(feet[side].at, stance[side].at);
        EXPECT_TRUE(feet[side].planted());
      }
    }
  });
}

TEST(Footsteps, FeetNearTheEndsAreWhereTheStancesAre) {
  forWalks([](Walk& walk) {
    for (const bool end : {false, true}) {
      const auto feet = walk.steps.at(end ? walk.steps.steps() - 1e-9 : 1e-9);
      const auto stance = Footsteps::atStance(placement(), end ? walk.to : walk.from);
      const bool standing = end ? walk.to.standing : walk.from.standing;
      for (const Side side : {kLeft, kRight}) {
        EXPECT_TRUE(feet[side].planted());
        EXPECT_TRUE(samePlace(feet[side].from, stance[side].from));
        EXPECT_NEAR(feet[side].at, standing ? feet[side].at : stance[side].at, 1e-6);
      }
    }
  });
}

TEST(Footsteps, BothFeetArePlantedInDoubleSupportAndOneFootBetween) {
  forWalks([](Walk& walk) {
    for (int i = 1; i < walk.steps.steps(); ++i) {
      const Side front = walk.steps.side(i);
      for (const double off : {-1.05, -0.95, 0.0, 0.95, 1.05}) {
        const auto feet = walk.steps.at(i + off * placement().supports(front, off < 0.0 ? 0 : 1));
        EXPECT_EQ(feet[kLeft].planted() && feet[kRight].planted(), std::abs(off) < 1.0) << i;
      }
    }
    for (int i = 0; i < walk.steps.steps(); ++i) {
      const auto feet = walk.steps.at(i + 0.5);
      EXPECT_TRUE(feet[walk.steps.side(i)].planted());
      EXPECT_FALSE(feet[walk.steps.side(i + 1)].planted());
    }
  });
}

// A foot changes from the swing that it came by to the one that it leaves by while it is flat.
TEST(Footsteps, AFootTurnsAsTheSwingThatItIsIn) {
  Walk walk(true, true, 8, kLeft);
  for (int i = 2; i <= 6; ++i) walk.steps.landings()[i + 1].turn_rate = i;
  for (double progress = 0.01; progress < 8.0; progress += 0.01) {
    for (const Side side : {kLeft, kRight}) {
      const FootState foot = walk.steps.at(progress)[side];
      int landed = -1;  // by the print that it stands on or leaves
      for (int i = 0; i <= 8; ++i)
        if (walk.steps.side(i) == side && samePlace(walk.steps.places()[i + 1], foot.from))
          landed = i;
      const int swings_to = foot.at < FootCycle::kFlat ? landed : landed + 2;
      EXPECT_EQ(foot.turn_rate, swings_to >= 2 && swings_to <= 6 ? swings_to : 0.0) << progress;
    }
  }
}

TEST(Footsteps, EverySwingEndsWhereTheNextStanceBegins) {
  forWalks([](Walk& walk) {
    auto before = walk.steps.at(0.0);
    int landings = 0;
    for (int k = 1; k <= 1000 * walk.steps.steps(); ++k) {
      const auto feet = walk.steps.at(k / 1000.0);
      for (const Side side : {kLeft, kRight}) {
        if (feet[side].planted() && !before[side].planted()) {
          ++landings;
          EXPECT_TRUE(samePlace(feet[side].from, before[side].to));
          EXPECT_GT(before[side].at, 1.99);
        } else if (feet[side].planted() == before[side].planted()) {
          EXPECT_TRUE(samePlace(feet[side].from, before[side].from));
        } else {
          EXPECT_TRUE(samePlace(feet[side].from, before[side].from));  // lifts off where it stood
        }
      }
      before = feet;
    }
    EXPECT_EQ(landings, walk.steps.steps());
  });
}

TEST(Footsteps, StepsOfAStraightWalkAreAlike) {
  forWalks([](Walk& walk) {
    std::vector<FootPlace>& places = walk.steps.places();
    const int n = walk.steps.steps();
    for (int i = walk.from.standing ? 2 : 0; i <= (walk.to.standing ? n - 1 : n); ++i) {
      EXPECT_NEAR(places[i + 1].position.x() - places[i].position.x(), kStepLength, 1e-9);
    }
  });
}

TEST(Footsteps, AStandingStanceHasItsFeetSideBySide) {
  const auto feet = Footsteps::atStance(placement(), {{1, 0, 0}, 0.0, true, kLeft});
  EXPECT_NEAR(feet[kLeft].from.position.x(), 1.02, 1e-15);
  EXPECT_NEAR(feet[kRight].from.position.x(), 1.02, 1e-15);
  EXPECT_NEAR(feet[kLeft].from.position.y() - feet[kRight].from.position.y(),
              placement().stand_width, 1e-15);
}

TEST(Footsteps, AWalkingStanceIsOneStepLongWithItsLeadingFootInFront) {
  for (const Side leading : {kLeft, kRight}) {
    const auto feet = Footsteps::atStance(placement(), {{1, 0, 0}, 0.0, false, leading});
    EXPECT_NEAR(feet[leading].from.position.x() - feet[other(leading)].from.position.x(),
                kStepLength, 1e-15);
    EXPECT_LT(feet[leading].at, feet[other(leading)].at);
  }
}

}  // namespace
}  // namespace amble
