#include "animation/editing/stair_climb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "animation/analysis/motion_measures.h"
#include "animation/editing/stair_swing.h"
#include "tests/animation/editing/edited_walks.h"

namespace amble {
namespace {

const std::array<std::string, 3> kClimbers = {"mocap/accad_female1/Female1_B03_Walk1.bvh",
                                              "mocap/accad_male1/Male1_B3_Walk.bvh",
                                              "mocap/cmu_mb2/07_03.bvh"};

struct Climb {
  CapturedWalk walk;
  EditedWalk edited;
  GaitMeasures gait;  // by the capture's plants

  double along(const Eigen::Vector3d& p) const {
    const double heading = edited.place.heading;
    const Eigen::Vector2d from = p.head<2>() - edited.place.origin;
    return from.x() * std::cos(heading) + from.y() * std::sin(heading);
  }
};

Climb climbed(const std::string& path, const StairSize& size) {
  Climb climb{capturedWalk(path), {}, {}};
  EditRequest request;
  request.stairs = size;
  request.foot_lock = true;
  climb.edited = editWalk(climb.walk, request);
  climb.gait = measureGait(climb.edited.clip, climb.walk.roles, climb.walk.analysis.plants);
  return climb;
}

TEST(StairClimb, EachPrintStandsInItsPlaceOnATreadOfItsOwn) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& path : kClimbers) {
    for (const double rise : {0.17, -0.17}) {
      const Climb climb = climbed(path, {rise, 0.29});
      ASSERT_EQ(climb.edited.refused, "") << path;
      const std::vector<PlantMeasures>& plants = climb.gait.plants;
      for (size_t i = 1; i < plants.size(); ++i) {
        EXPECT_NEAR(climb.along(plants[i].at) - climb.along(plants[i - 1].at), 0.29, 0.02)
            << path << i;
      }
      const std::vector<PlantMeasures>& before = climb.walk.analysis.gait.plants;
      for (size_t i = 1; i < plants.size(); ++i) {
        EXPECT_NEAR(plants[i].ends.ball.z() - before[i].ends.ball.z(),
                    rise * static_cast<double>(i), 0.005)
            << path << i;
      }
    }
  }
}

/// Whether a foot swings at a frame, and is not just being lifted or put down: in the first and
/// last tenth of a swing it is (DESIGN.md, section 3).
bool swings(const FootPlants& plants, Side side, int frame) {
  int first = frame, last = frame;
  while (first > 0 && !plants.planted(side, first)) --first;
  while (last + 1 < plants.frames && !plants.planted(side, last)) ++last;
  const double tenth = 0.1 * (last - first);
  return frame > first + tenth && frame < last - tenth;
}

/// The least height at which a point of a foot's sole passes over a nosing while it swings [m].
double leastOverNosings(const Climb& climb, Side side) {
  const WalkTracks captured = tracksOf(climb.walk.clip, climb.walk.roles);
  const WalkTracks tracks = tracksOf(climb.edited.clip, climb.walk.roles);
  const FootTrack& foot = tracks.feet[side];
  const Stairs& stairs = climb.edited.place.stairs;
  double least = 1.0;
  for (const Eigen::Vector3d& point : solePoints(climb.walk, captured.feet[side], side)) {
    for (int i = 1; i < climb.walk.clip.frames(); ++i) {
      const FootPlants& plants = climb.walk.analysis.plants;
      if (!swings(plants, side, i - 1) || !swings(plants, side, i)) continue;
      const Eigen::Vector3d before = foot.ankle[i - 1] + foot.q_WF[i - 1] * point;
      const Eigen::Vector3d after = foot.ankle[i] + foot.q_WF[i] * point;
      const double from = climb.along(before), to = climb.along(after);
      for (int k = 0; k < stairs.count; ++k) {
        const double nosing = stairs.start + k * stairs.going;
        if ((from - nosing) * (to - nosing) > 0.0 || from == to) continue;
        const double share = (nosing - from) / (to - from);
        const double height = before.z() + share * (after.z() - before.z());
        least = std::min(least, height - stairs.rise * (stairs.rise > 0.0 ? k + 1 : k));
      }
    }
  }
  return least;
}

TEST(StairClimb, SwingingSolesPassOverNosingsByTenMillimetres) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& path : kClimbers) {
    for (const double rise : {0.17, -0.17}) {
      const Climb climb = climbed(path, {rise, 0.29});
      for (const Side side : {kLeft, kRight}) {
        const double least = leastOverNosings(climb, side);
        EXPECT_GT(least, 0.010) << path << rise << side;
        EXPECT_LT(least, 0.15) << path << rise << side;  // and do not march
      }
    }
  }
}

TEST(StairClimb, HeldFeetStayAndNothingJumps) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& path : {kClimbers[0], kClimbers[1]}) {
    for (const double rise : {0.17, -0.17}) {
      const Climb climb = climbed(path, {rise, 0.29});
      EXPECT_LT(climb.gait.largest_drift, 0.002) << path;
      // A foot goes up two risers in the time of a step on the level.
      EXPECT_LT(jointJerk(climb.edited.clip), 1.15 * jointJerk(climb.walk.clip)) << path;
      EXPECT_LT(pops(climb.edited.clip), std::max(2.5, pops(climb.walk.clip))) << path;
      EXPECT_EQ(kneeBackwardsShare(climb.edited.clip, climb.walk.roles), 0.0) << path;
    }
  }
}

TEST(StairClimb, WhoStandsFirstBeginsWithBothFeetOnOneTread) {
  AMBLE_NEEDS_CAPTURES();
  const Climb climb = climbed("mocap/accad_male1/Male1_B1_StandToWalk.bvh", {0.15, 0.3});
  ASSERT_EQ(climb.edited.refused, "");
  const std::vector<PlantMeasures>& plants = climb.gait.plants;
  EXPECT_NEAR(plants[0].ends.ball.z(), plants[1].ends.ball.z(), 0.04);
  EXPECT_GT(plants.back().ends.ball.z(), 0.15 * static_cast<double>(plants.size() - 3));
}

TEST(StairClimb, ATurningWalkIsRefused) {
  AMBLE_NEEDS_CAPTURES();
  const Climb climb = climbed("mocap/accad_female1/Female1_B12_WalkTurnRight90.bvh", {});
  EXPECT_EQ(climb.edited.refused, "it turns by 57 degrees, and stairs are for straight walks");
}

// On the way he turns about once on the spot, on which his way is straight.
TEST(StairClimb, WhoTurnsAboutOnTheSpotOrWalksBackwardsIsRefused) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const clip :
       {"mocap/cmu_mb2/06_10.bvh", "mocap/accad_female1/Female1_B05_WalkBackwards.bvh",
        "mocap/cmu_mb2/06_06.bvh"}) {
    const Climb climb = climbed(clip, {});
    EXPECT_NE(climb.edited.refused.find("and stairs are for who walks ahead"), std::string::npos)
        << clip << ": " << climb.edited.refused;
  }
}

}  // namespace
}  // namespace amble
