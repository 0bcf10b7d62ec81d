#include "animation/analysis/foot_plants.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "animation/analysis/plant_signals.h"
#include "animation/captures/bvh.h"
#include "tests/animation/captures.h"
#include "tests/animation/force_trials.h"
#include "tests/animation/puppet.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

// A drawn foot comes down evenly and stops dead, which a low-pass sees before it is there [s].
constexpr double kTolerance = 0.05;

void expectSamePlants(const FootPlants& found, const FootPlants& truth, double rate,
                      const std::string& what) {
  const double tolerance = 1.0 + kTolerance * rate;
  for (const Side side : {kLeft, kRight}) {
    ASSERT_EQ(found.plants[side].size(), truth.plants[side].size()) << what << " side " << side;
    for (size_t i = 0; i < truth.plants[side].size(); ++i) {
      EXPECT_NEAR(found.plants[side][i].first, truth.plants[side][i].first, tolerance)
          << what << " plant " << i;
      EXPECT_NEAR(found.plants[side][i].last, truth.plants[side][i].last, tolerance)
          << what << " plant " << i;
    }
  }
}

TEST(FootPlants, OfAClipWithoutFramesAreNone) {
  Clip clip = Puppet().clip();
  clip.poses.clear();
  clip.joint_positions.clear();
  EXPECT_TRUE(detectPlants(clip, Puppet::roles()).plants[kLeft].empty());
}

TEST(FootPlants, AreRunsOfPlantedFrames) {
  const std::vector<bool> left = {true, true, false, false, true},
                          right = {false, true, true, true, false};
  const FootPlants plants = plantsOf({left, right});
  EXPECT_EQ(plants.plants[kLeft].size(), 2u);
  EXPECT_EQ(plants.plants[kRight].size(), 1u);
  EXPECT_EQ(plants.planted(kLeft), left);
  EXPECT_EQ(plants.planted(kRight), right);
  EXPECT_TRUE(plants.planted(kRight, 3));
  EXPECT_FALSE(plants.planted(kRight, 4));
  EXPECT_EQ(plants.plants[kRight][0].strike, 0.5);
  EXPECT_EQ(plants.plants[kRight][0].lift_off, 3.5);
}

TEST(FootPlants, OfADrawnWalkAreThoseItWasDrawnWith) {
  for (const double speed : {0.6, 1.2, 1.8}) {
    for (const double turn_rate : {0.0, 0.9, -0.5}) {
      const Puppet puppet{.speed = speed, .turn_rate = turn_rate, .period = 1.5 - 0.3 * speed};
      expectSamePlants(detectPlants(puppet.clip(), Puppet::roles()), puppet.plants(), puppet.rate,
                       "speed " + std::to_string(speed));
    }
  }
}

TEST(FootPlants, DoNotDependOnTheFrameRate) {
  for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
    const Puppet puppet{.rate = rate};
    expectSamePlants(detectPlants(puppet.clip(), Puppet::roles()), puppet.plants(), rate,
                     std::to_string(rate));
  }
}

Clip turned(const Clip& clip, const Eigen::Quaterniond& q) {
  Clip result = clip;
  for (int i = 0; i < clip.frames(); ++i) {
    result.poses.p_WR(i) = q * clip.poses.p_WR(i);
    result.poses.rotations(i)[0] = q * clip.poses.rotations(i)[0];
  }
  return result;
}

TEST(FootPlants, AreSeenOnATiltedFloorAndOnOneAtAnyHeight) {
  const Puppet puppet;
  const Eigen::Quaterniond tilt = fromEuler({1.1 * kDegree, 0.7 * kDegree, 0}, {'X', 'Y', 'Z'});
  Clip clip = turned(puppet.clip(), tilt);
  for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).z() += 3.5;
  expectSamePlants(detectPlants(clip, Puppet::roles()), puppet.plants(), puppet.rate, "tilted");
}

TEST(FootPlants, StandingIsOnePlantOfTheWholeClip) {
  const Puppet puppet{.speed = 0.0, .lift = 0.0};
  const FootPlants plants = detectPlants(puppet.clip(), Puppet::roles());
  for (const Side side : {kLeft, kRight}) {
    ASSERT_EQ(plants.plants[side].size(), 1u);
    EXPECT_EQ(plants.plants[side][0].first, 0);
    EXPECT_EQ(plants.plants[side][0].last, plants.frames - 1);
  }
}

TEST(FootPlants, FirstAndLastFramesBracketStrikeAndLiftOff) {
  const FootPlants plants = detectPlants(Puppet().clip(), Puppet::roles());
  for (const Side side : {kLeft, kRight}) {
    int before = -1;
    for (const FootPlant& plant : plants.plants[side]) {
      EXPECT_GT(plant.first, before);
      EXPECT_LE(plant.first, plant.last);
      EXPECT_GT(plant.strike, plant.first - 1.0);
      EXPECT_LE(plant.strike, plant.first + PlantOptions{}.strike_lead * Puppet{}.rate + 1e-9);
      EXPECT_GT(plant.lift_off, plant.last - 1e-9);
      EXPECT_LE(plant.lift_off, plant.last + 1.0 + PlantOptions{}.lift_off_contact * Puppet{}.rate);
      before = plant.last;
    }
  }
}

/// What force plates have and what we find: frames planted and not, and when contacts begin and
/// end.
struct Score {
  double hits = 0, false_plants = 0, misses = 0, rejections = 0;
  std::vector<double> onsets, offsets;  // [ms], absolute
  int missed = 0;                       // contacts without a single planted frame

  double precision() const { return hits / (hits + false_plants); }
  double recall() const { return hits / (hits + misses); }
  double specificity() const { return rejections / (rejections + false_plants); }
  double accuracy() const {
    return (hits + rejections) / (hits + rejections + false_plants + misses);
  }
};

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

void addOnsetsAndOffsets(const std::vector<int>& truth, const FootPlants& plants, Side side,
                         double frame_time, Score& score) {
  for (size_t i = 1; i < truth.size(); ++i) {
    if (truth[i] < 0 || truth[i - 1] < 0 || truth[i] == truth[i - 1]) continue;
    double nearest = 1e9;
    for (const FootPlant& plant : plants.plants[side]) {
      const double off = truth[i] == 1 ? plant.first - static_cast<double>(i)
                                       : plant.last + 1.0 - static_cast<double>(i);
      nearest = std::min(nearest, std::abs(off));
    }
    (truth[i] == 1 ? score.onsets : score.offsets).push_back(1000.0 * nearest * frame_time);
  }
}

void addFoot(const ForceTrial& trial, const FootPlants& plants, Side side, double frame_time,
             int start, Score& score) {
  const std::vector<int>& truth = trial.planted[side];
  std::vector<bool> seen(truth.size(), false);
  for (int i = 0; i < plants.frames; ++i) {
    const size_t at =
        static_cast<size_t>(start + std::lround(i * frame_time / trial.clip.frame_time));
    if (at >= truth.size() || truth[at] < 0) continue;  // unknown
    const bool found = plants.planted(side, i);
    seen[at] = found;
    (truth[at] == 1 ? (found ? score.hits : score.misses)
                    : (found ? score.false_plants : score.rejections)) += 1;
  }
  for (size_t i = 0; i < truth.size();) {
    bool any = truth[i] != 1;
    size_t end = i + 1;
    for (; !any && end < truth.size() && truth[end] == 1; ++end) {
    }
    for (size_t k = i; k < end; ++k) any = any || seen[k];
    if (!any) ++score.missed;
    i = end;
  }
  if (frame_time == trial.clip.frame_time) {
    addOnsetsAndOffsets(truth, plants, side, frame_time, score);
  }
}

/// Of all trials, each changed first, to begin at frame `start` of what it was.
Score scoreOfTrials(const std::function<Clip(const Clip&)>& change, int start = 0) {
  Score score;
  for (const ForceTrial& trial : forceTrials()) {
    const Clip clip = change(trial.clip);
    const FootPlants plants = detectPlants(clip, trial.roles);
    for (const Side side : {kLeft, kRight})
      addFoot(trial, plants, side, clip.frame_time, start, score);
  }
  return score;
}

Clip startingAt(const Clip& clip, int frame) {
  Clip result = clip;
  result.poses.clear();
  result.poses.append(clip.poses, frame, clip.frames() - frame);
  return result;
}

Clip resampled(const Clip& clip, double rate) {
  Clip result = clip;
  result.poses.clear();
  result.frame_time = 1.0 / rate;
  Pose pose;
  for (int i = 0; i <= clip.duration() * rate; ++i) {
    const double frame = i / rate / clip.frame_time;
    const int from = std::min(static_cast<int>(frame), clip.frames() - 2);
    interpolatePose(clip.poses[from], clip.poses[from + 1], frame - from, pose);
    result.poses.append(pose);
  }
  return result;
}

/// Every coordinate of every place of ankle and toe off by so much (standard deviation).
Clip noisy(const Clip& clip, const JointRoles& roles, double metres, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> draw(0.0, metres);
  Clip result = clip;
  for (int i = 0; i < clip.frames(); ++i) {
    for (int j = 0; j < clip.skeleton.size(); ++j) {
      Eigen::Vector3d place = clip.skeleton.joint(j).offset;
      for (const LegJoints& leg : roles.legs) {
        if (j == leg.foot || j == leg.toe) {
          place += Eigen::Vector3d(draw(generator), draw(generator), draw(generator));
        }
      }
      result.joint_positions.push_back(place);
    }
  }
  return result;
}

TEST(FootPlantsOfTrials, AgreeWithForcePlatesBetterThanTheThesisWithItsEyes) {
  AMBLE_NEEDS_TRIALS();
  const Score score = scoreOfTrials([](const Clip& clip) { return clip; });
  // The thesis' own: 0.970, 0.973, 0.932, 0.960.
  EXPECT_GE(score.precision(), 0.987);
  EXPECT_GE(score.recall(), 0.980);
  EXPECT_GE(score.specificity(), 0.983);
  EXPECT_GE(score.accuracy(), 0.980);
  EXPECT_EQ(score.missed, 0);
  EXPECT_LE(mean(score.onsets), 10.0);
  EXPECT_LE(mean(score.offsets), 14.0);
}

TEST(FootPlantsOfTrials, HardlySufferFromATiltedFloor) {
  AMBLE_NEEDS_TRIALS();
  const double accuracy = scoreOfTrials([](const Clip& clip) { return clip; }).accuracy();
  for (const Eigen::Vector3d& tilt :
       {Eigen::Vector3d(1.05 * kDegree, 0, 0), Eigen::Vector3d(0, 1.05 * kDegree, 0)}) {
    const Score score = scoreOfTrials([&](const Clip& clip) {
      return turned(clip, fromEuler(tilt, {'X', 'Y', 'Z'}));
    });
    EXPECT_GT(score.accuracy(), accuracy - 0.005);
    EXPECT_EQ(score.missed, 0);
  }
}

// Where the frames of a slow clip fall among those of the truth is chance, worth half a percent:
// the mean over starts.
TEST(FootPlantsOfTrials, HardlySufferFromALowFrameRate) {
  AMBLE_NEEDS_TRIALS();
  const double accuracy = scoreOfTrials([](const Clip& clip) { return clip; }).accuracy();
  constexpr int kStarts = 10;
  for (const double rate : {30.0, 50.0, 60.0}) {
    double slow = 0.0;
    for (int start = 0; start < kStarts; ++start) {
      const Score score = scoreOfTrials(
          [&](const Clip& clip) { return resampled(startingAt(clip, start), rate); }, start);
      slow += score.accuracy() / kStarts;
      EXPECT_EQ(score.missed, 0) << rate;
    }
    EXPECT_GT(slow, accuracy - 0.005) << rate;
  }
}

TEST(FootPlantsOfTrials, HardlySufferFromTwoMillimetresOfNoise) {
  AMBLE_NEEDS_TRIALS();
  const double accuracy = scoreOfTrials([](const Clip& clip) { return clip; }).accuracy();
  double noisy_accuracy = 0.0;
  constexpr int kSeeds = 4;  // of one seed the score is chance to half a percent
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const Score score = scoreOfTrials([&](const Clip& clip) {
      return noisy(clip, guessJointRoles(clip.skeleton, clip.name), 0.002, seed);
    });
    noisy_accuracy += score.accuracy() / kSeeds;
    EXPECT_EQ(score.missed, 0);
  }
  EXPECT_GT(noisy_accuracy, accuracy - 0.005);
}

// Runners draw their feet up behind them, slowly for such a swing.
TEST(FootPlantsOfCaptures, AFootThatComesDownAndLeavesIsDown) {
  AMBLE_NEEDS_CAPTURES();
  constexpr double kHigher = 0.03;  // than what is low, in leg lengths: in the air for certain
  int plants = 0;
  for (const Capture& capture : captures()) {
    if (capture.kind != "walk" && capture.kind != "run" && capture.kind != "run_turn") continue;
    const Clip clip = readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit});
    const JointRoles roles = guessJointRoles(clip.skeleton, capture.path);
    const FootPlants found = detectPlants(clip, roles);
    const std::array<double, 2> legs = legLengths(clip, roles);
    const auto traces = tracePlants(footPaths(clip, roles), legs, clip.frame_time);
    for (const Side side : {kLeft, kRight}) {
      const PlantTrace& trace = traces[side];
      for (const FootPlant& plant : found.plants[side]) {
        ++plants;
        for (const int i : {plant.first, plant.last}) {
          const double ankle = trace.signals.height(i, 0) - trace.limits.height[0];
          const double toe = trace.signals.height(i, 1) - trace.limits.height[1];
          EXPECT_LT(std::min(ankle, toe), kHigher * legs[side]) << capture.path << " frame " << i;
        }
      }
    }
  }
  EXPECT_GT(plants, 100);
}

TEST(FootPlantsOfCaptures, WalkersAreHardlyEverInTheAirAndRunnersAre) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    const bool walk = capture.kind == "walk", run = capture.kind == "run";
    if ((!walk && !run) || capture.path.starts_with("cmu_daz"))
      continue;  // retargeted: feet are not anchored
    const Clip clip = readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit});
    const FootPlants plants = detectPlants(clip, guessJointRoles(clip.skeleton, capture.path));
    const std::vector<bool> left = plants.planted(kLeft), right = plants.planted(kRight);
    int air = 0;
    for (int i = capture.skip; i < clip.frames(); ++i) air += !left[i] && !right[i];
    const double share = static_cast<double>(air) / (clip.frames() - capture.skip);
    if (walk) {
      EXPECT_LT(share, 0.03) << capture.path;
    } else {
      EXPECT_GT(share, 0.1) << capture.path;
    }
  }
}

}  // namespace
}  // namespace amble
