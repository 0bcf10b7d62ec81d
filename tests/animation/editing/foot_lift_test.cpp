#include "animation/editing/foot_lift.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/editing/edited_walks.h"

namespace amble {
namespace {

/// A walk, and its tracks where every swing's lift is so many times the captured.
struct Lifted {
  const CapturedWalk& walk;
  WalkTracks before = tracksOf(walk.clip, walk.roles);
  WalkTracks after = before;

  Lifted(const CapturedWalk& the_walk, double factor) : walk(the_walk) {
    scaleLift(
        walk, [factor](int) { return factor; }, after);
  }
  double change(Side side, int frame) const {
    return after.feet[side].ankle[frame].z() - before.feet[side].ankle[frame].z();
  }
  /// How high the sole is over the line between its prints [m].
  double height(const WalkTracks& tracks, const PlantMeasures& from, const PlantMeasures& to,
                int frame) const {
    const FootTrack& foot = tracks.feet[from.side];
    const double heel = kAnkleHeightOfLeg * walk.roles.legLength(walk.clip.skeleton, from.side);
    return heightOver(from.ends, to.ends,
                      capturedSole(foot.ankle[frame], foot.toe[frame], heel, from.flat_pitch));
  }
  /// Calls `of(from, to)` with the plants around every swing.
  template <typename Of>
  void swings(const Of& of) const {
    for (const Side side : {kLeft, kRight}) {
      const PlantMeasures* before_it = nullptr;
      for (const PlantMeasures& plant : walk.analysis.gait.plants) {
        if (plant.side != side) continue;
        if (before_it != nullptr) of(*before_it, plant);
        before_it = &plant;
      }
    }
  }
};

class FootLifts : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { AMBLE_NEEDS_CAPTURES(); }
  const CapturedWalk walk = captures().empty() ? CapturedWalk() : capturedWalk(GetParam());
};

TEST_P(FootLifts, OnceIsWhatWasCaptured) {
  const Lifted lifted(walk, 1.0);
  for (const Side side : {kLeft, kRight}) {
    EXPECT_EQ(lifted.after.feet[side].ankle, lifted.before.feet[side].ankle);
    EXPECT_EQ(lifted.after.feet[side].toe, lifted.before.feet[side].toe);
  }
}

TEST_P(FootLifts, RaiseFeetAndNeitherMoveNorTurnThem) {
  for (const double factor : {0.6, 1.8}) {
    const Lifted lifted(walk, factor);
    EXPECT_EQ(lifted.after.root, lifted.before.root);
    for (const Side side : {kLeft, kRight}) {
      const FootTrack &a = lifted.before.feet[side], &b = lifted.after.feet[side];
      for (int i = 0; i < walk.clip.frames(); ++i) {
        const Eigen::Vector3d by = b.ankle[i] - a.ankle[i];
        EXPECT_EQ(by.head<2>().norm(), 0.0);
        EXPECT_LT((b.toe[i] - a.toe[i] - by).norm(), 1e-12);
        EXPECT_EQ(b.q_WF[i].coeffs(), a.q_WF[i].coeffs());
        EXPECT_GE((factor - 1.0) * by.z(), 0.0);
      }
    }
  }
}

TEST_P(FootLifts, AreSoManyTimesTheCaptured) {
  for (const double factor : {0.5, 0.8, 1.3, 3.0}) {
    const Lifted lifted(walk, factor);
    lifted.swings([&](const PlantMeasures& from, const PlantMeasures& to) {
      double captured = 0.0, now = 0.0;
      for (int i = from.plant.last; i <= to.plant.first; ++i) {
        captured = std::max(captured, lifted.height(lifted.before, from, to, i));
        now = std::max(now, lifted.height(lifted.after, from, to, i));
      }
      EXPECT_NEAR(now, factor * captured, 1e-9) << factor << " from frame " << from.plant.last;
    });
  }
}

// Neither heel nor ball goes below the line between the prints, but where it was below it.
TEST_P(FootLifts, LoweredPutNoFootIntoTheFloor) {
  for (const double factor : {0.5, 0.7, 0.9}) {
    const Lifted lifted(walk, factor);
    lifted.swings([&](const PlantMeasures& from, const PlantMeasures& to) {
      for (int i = from.plant.last; i <= to.plant.first; ++i) {
        const double captured = lifted.height(lifted.before, from, to, i);
        EXPECT_GT(lifted.height(lifted.after, from, to, i), std::min(0.0, captured) - 1e-3) << i;
      }
    });
  }
}

// Tips of toes are where they were or over where they stand, seen from the line between the prints.
TEST_P(FootLifts, LoweredPutNoToesIntoTheFloor) {
  for (const double factor : {0.3, 0.5, 0.8}) {
    const Lifted lifted(walk, factor);
    const Clip edited = followTracks(walk.clip, walk.roles, lifted.after);
    lifted.swings([&](const PlantMeasures& from, const PlantMeasures& to) {
      const int toe = walk.roles.legs[from.side].toe;
      if (toe < 0 || walk.clip.skeleton.joint(toe).end_sites.size() != 1) return;
      const auto tipOf = [&](const Clip& clip, int i) {
        const Eigen::Vector3d tip =
            jointFrames(clip, i)[toe] * clip.skeleton.joint(toe).end_sites[0];
        const SoleEnds before{from.ends.ball, from.ends.ball}, after{to.ends.ball, to.ends.ball};
        return heightOver(before, after, {tip, tip});
      };
      const double stood = tipOf(walk.clip, (from.plant.first + from.plant.last) / 2);
      for (int i = from.plant.last; i <= to.plant.first; ++i)
        EXPECT_GT(tipOf(edited, i), std::min(stood, tipOf(walk.clip, i)) - 1e-3) << i;
    });
  }
}

// What is raised is smoothed over half a tenth of a second; what is lowered ends with the swing.
TEST_P(FootLifts, LeaveFeetThatStandWhereTheyAre) {
  const int reach = static_cast<int>(std::ceil(0.05 / walk.clip.frame_time)) + 1;
  for (const double factor : {0.5, 2.0}) {
    const Lifted lifted(walk, factor);
    for (const PlantMeasures& plant : walk.analysis.gait.plants) {
      const int beside = factor < 1.0 ? 1 : reach;
      for (int i = plant.plant.first + beside; i <= plant.plant.last - beside; ++i) {
        EXPECT_NEAR(lifted.change(plant.side, i), 0.0, 1e-12) << i;
      }
    }
  }
}

TEST_P(FootLifts, AreHigherAtEveryFrameWhereMoreIsAsked) {
  Lifted before(walk, 0.5);
  for (const double factor : {0.7, 0.9, 1.2, 2.0, 3.0}) {
    const Lifted more(walk, factor);
    for (const Side side : {kLeft, kRight}) {
      for (int i = 0; i < walk.clip.frames(); ++i)
        EXPECT_GE(more.change(side, i), before.change(side, i) - 1e-12);
    }
    before.after = more.after;
  }
}

TEST_P(FootLifts, AskedByFrameAreThoseOfTheMiddleOfEachSwing) {
  WalkTracks ramp = tracksOf(walk.clip, walk.roles);
  const auto factor = [&](int frame) { return 1.0 + frame / (1.0 * walk.clip.frames()); };
  scaleLift(walk, factor, ramp);
  const Lifted plain(walk, 1.0);
  plain.swings([&](const PlantMeasures& from, const PlantMeasures& to) {
    double captured = 0.0, now = 0.0;
    for (int i = from.plant.last; i <= to.plant.first; ++i) {
      captured = std::max(captured, plain.height(plain.before, from, to, i));
      now = std::max(now, plain.height(ramp, from, to, i));
    }
    EXPECT_NEAR(now, factor((from.plant.last + to.plant.first) / 2) * captured, 1e-9);
  });
}

// A foot that comes up for a moment only has little else that can be lowered.
TEST(FootLift, OfSharpSwingsLoweredPutsNoFootUnderTheLineBetweenItsPrints) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* clip :
       {"mocap/cmu_mb2/06_10.bvh", "mocap/accad_male1/Male1_B13_WalkTurnRight45.bvh"}) {
    const CapturedWalk walk = capturedWalk(clip);
    for (const double factor : {0.5, 0.8}) {
      const Lifted lifted(walk, factor);
      lifted.swings([&](const PlantMeasures& from, const PlantMeasures& to) {
        for (int i = from.plant.last; i <= to.plant.first; ++i) {
          const double captured = lifted.height(lifted.before, from, to, i);
          EXPECT_GE(lifted.height(lifted.after, from, to, i), std::min(captured, 0.0) - 1e-4)
              << clip << " " << factor << " " << i;
        }
      });
    }
  }
}

/// The largest change of a joint's turn from frame to frame [rad].
double mostBent(const Clip& clip, int joint) {
  double most = 0.0;
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (int i = 0; i + 1 < clip.frames(); ++i) {
    const Eigen::Quaterniond& q = clip.poses.rotations(i)[joint];
    const Eigen::Vector3d turn = logRotation(q.conjugate() * clip.poses.rotations(i + 1)[joint]);
    if (i > 0) most = std::max(most, (turn - before).norm());
    before = turn;
  }
  return most;
}

// Toes point to the floor as their foot leaves it, and what lies across them then may be any way.
TEST(FootLift, ToesThatHangDownDoNotFlick) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* clip : {"mocap/cmu_mb2/06_01.bvh", "mocap/cmu_mb2/08_01.bvh",
                           "mocap/cmu_mb2/08_06.bvh", "mocap/cmu_mb2/09_12.bvh"}) {
    const CapturedWalk walk = capturedWalk(clip);
    const Lifted lifted(walk, 0.6);
    const Clip lowered = followTracks(walk.clip, walk.roles, lifted.after);
    for (const LegJoints& leg : walk.roles.legs) {
      EXPECT_LT(mostBent(lowered, leg.toe), 1.2 * mostBent(walk.clip, leg.toe)) << clip;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, FootLifts,
                         testing::Values("mocap/accad_female1/Female1_B03_Walk1.bvh",
                                         "mocap/accad_male1/Male1_B3_Walk.bvh",
                                         "mocap/cmu_mb2/02_01.bvh", "mocap/cmu_mb2/07_06.bvh",
                                         "gait/trials/zoo_HC031A06.bvh"));

}  // namespace
}  // namespace amble
