#include "animation/analysis/gait_events.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/captures/bvh.h"
#include "tests/animation/captures.h"
#include "tests/animation/force_trials.h"
#include "tests/animation/puppet.h"

namespace amble {
namespace {

GaitEvents eventsOf(const Puppet& puppet) {
  return findGaitEvents(puppet.clip(), Puppet::roles(), puppet.plants());
}

bool whole(const SwingEvents& swing) {
  return !std::isnan(swing.lift_off) && !std::isnan(swing.strike);
}

/// Every swing between two plants has its four events in order, and those at the clip's ends what
/// they show of them.
void expectOrdered(const GaitEvents& events, const FootPlants& plants, const std::string& what) {
  for (const Side side : {kLeft, kRight}) {
    size_t cycles = 0;
    double before = -1e9;
    for (const SwingEvents& swing : events.swings[side]) {
      if (!std::isnan(swing.lift_off)) {
        EXPECT_LE(before, swing.lift) << what;
        EXPECT_LE(swing.lift, swing.lift_off) << what;
        EXPECT_EQ(swing.lift, std::min(swing.heel.lift, swing.toe.lift)) << what;
        EXPECT_LE(std::max(swing.heel.lift, swing.toe.lift), swing.lift_off) << what;
      }
      if (whole(swing)) {
        EXPECT_LT(swing.lift_off, swing.strike) << what;
        ++cycles;
      }
      if (!std::isnan(swing.strike)) {
        EXPECT_LE(swing.strike, swing.landing) << what;
        EXPECT_EQ(swing.landing, std::max(swing.heel.landing, swing.toe.landing)) << what;
        EXPECT_GE(std::min(swing.heel.landing, swing.toe.landing), swing.strike) << what;
        before = swing.landing;
      }
    }
    const size_t stands = plants.plants[side].size();
    EXPECT_EQ(cycles, stands == 0 ? 0 : stands - 1) << what;
  }
}

TEST(GaitEvents, OfAClipWithoutFramesOrPlantsAreNone) {
  Clip clip = Puppet().clip();
  FootPlants none;
  none.frames = clip.frames();
  EXPECT_TRUE(findGaitEvents(clip, Puppet::roles(), none).swings[kLeft].empty());
  clip.poses.clear();
  clip.joint_positions.clear();
  EXPECT_TRUE(findGaitEvents(clip, Puppet::roles(), {}).swings[kLeft].empty());
}

TEST(GaitEvents, LiftAndLandingOfADrawnWalkAreWhereItsFeetRiseAndComeDown) {
  const Puppet puppet;
  const GaitEvents events = eventsOf(puppet);
  expectOrdered(events, puppet.plants(), "puppet");
  for (const Side side : {kLeft, kRight}) {
    int cycle = -1;
    for (const SwingEvents& swing : events.swings[side]) {
      if (!whole(swing)) continue;
      // The drawn foot is flat: heel and toe leave together; the low-pass sees it 50 ms early.
      while (puppet.liftOff(side, cycle) * puppet.rate < swing.lift_off - 20.0) ++cycle;
      EXPECT_NEAR(swing.lift, puppet.liftOff(side, cycle) * puppet.rate, 5.0);
      EXPECT_NEAR(swing.landing, puppet.strike(side, cycle + 1) * puppet.rate, 5.0);
    }
  }
}

TEST(GaitEvents, AreOneOrderedSetACycleWhetherFeetDragOrSink) {
  for (const double lift : {0.12, 0.02, 0.001}) {
    for (const double sink : {0.0, 0.03}) {
      const Puppet puppet{.lift = lift, .sink = sink};
      expectOrdered(eventsOf(puppet), puppet.plants(),
                    "lift " + std::to_string(lift) + " sink " + std::to_string(sink));
    }
  }
}

TEST(GaitEvents, OfALoneStandAreNone) {
  const Puppet puppet{.speed = 0.0, .lift = 0.0};
  FootPlants stand;
  stand.frames = puppet.clip().frames();
  for (const Side side : {kLeft, kRight}) {
    stand.plants[side] = {{0, stand.frames - 1, -0.5, stand.frames - 0.5}};
  }
  const GaitEvents events = findGaitEvents(puppet.clip(), Puppet::roles(), stand);
  EXPECT_TRUE(events.swings[kLeft].empty());
  EXPECT_TRUE(events.swings[kRight].empty());
}

/// Off by so much on average and at the 90th percentile [ms].
void expectWithin(std::vector<double> off, double mean, double p90, const char* what) {
  ASSERT_GE(off.size(), 10u);
  double sum = 0.0;
  for (const double value : off) sum += value;
  std::sort(off.begin(), off.end());
  EXPECT_LE(sum / static_cast<double>(off.size()), mean) << what;
  EXPECT_LE(off[static_cast<size_t>(std::ceil(0.9 * static_cast<double>(off.size()))) - 1], p90)
      << what;
}

TEST(GaitEventsOfTrials, StrikeAndLiftOffAreTheForcePlatesOnsetAndRelease) {
  AMBLE_NEEDS_TRIALS();
  std::vector<double> onset, release;
  for (const ForceTrial& trial : forceTrials()) {
    const FootPlants plants = detectPlants(trial.clip, trial.roles);
    const GaitEvents events = findGaitEvents(trial.clip, trial.roles, plants);
    expectOrdered(events, plants, trial.file.string());
    const double ms = 1000.0 * trial.clip.frame_time;
    for (const Side side : {kLeft, kRight}) {
      const std::vector<int>& truth = trial.planted[side];
      for (size_t i = 1; i < truth.size(); ++i) {
        if (truth[i] < 0 || truth[i - 1] < 0 || truth[i] == truth[i - 1]) continue;
        // A frame of the truth is the mean over that frame: the force came on within it.
        const double at = static_cast<double>(i) + (truth[i] == 1 ? 0.5 : -0.5);
        double nearest = 1e9;
        for (const SwingEvents& swing : events.swings[side]) {
          const double event = truth[i] == 1 ? swing.strike : swing.lift_off;
          if (!std::isnan(event)) nearest = std::min(nearest, std::abs(event - at));
        }
        (truth[i] == 1 ? onset : release).push_back(ms * nearest);
      }
    }
  }
  expectWithin(onset, 15.0, 30.0, "onset");
  expectWithin(release, 15.0, 30.0, "release");
}

TEST(GaitEventsOfCaptures, AreInOrderInEveryCycleOfEveryCapture) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    const Clip clip = readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit});
    const JointRoles roles = guessJointRoles(clip.skeleton, capture.path);
    const FootPlants plants = detectPlants(clip, roles);
    expectOrdered(findGaitEvents(clip, roles, plants), plants, capture.path);
  }
}

}  // namespace
}  // namespace amble
