#include "animation/foot_plants.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "animation/bvh.h"
#include "tests/animation/captures.h"
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
      EXPECT_LE(plant.strike, plant.first + 1e-9);
      EXPECT_GT(plant.lift_off, plant.last - 1e-9);
      EXPECT_LE(plant.lift_off, plant.last + 1.0);
      before = plant.last;
    }
  }
}

/// Frames planted and not, as force plates have it and as we find it.
struct Score {
  double hits = 0, false_plants = 0, misses = 0, rejections = 0;

  double precision() const { return hits / (hits + false_plants); }
  double recall() const { return hits / (hits + misses); }
  double specificity() const { return rejections / (rejections + false_plants); }
  double accuracy() const {
    return (hits + rejections) / (hits + rejections + false_plants + misses);
  }
};

void addTrial(const std::filesystem::path& bvh, const Eigen::Quaterniond& tilt, Score& score) {
  const Clip clip = turned(readBvh(bvh, {.metres_per_unit = 0.01}), tilt);
  const FootPlants plants = detectPlants(clip, guessJointRoles(clip.skeleton, bvh.string()));
  std::ifstream truth(std::filesystem::path(bvh).replace_extension(".contact.csv"));
  std::string line;
  std::getline(truth, line);
  while (std::getline(truth, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream row(line);
    double time;
    int frame, planted[2];
    row >> frame >> time >> planted[kLeft] >> planted[kRight];
    for (const Side side : {kLeft, kRight}) {
      if (planted[side] < 0) continue;  // unknown
      const bool found = plants.planted(side, frame);
      (planted[side] == 1 ? (found ? score.hits : score.misses)
                          : (found ? score.false_plants : score.rejections)) += 1;
    }
  }
}

Score scoreOfTrials(const Eigen::Quaterniond& tilt) {
  Score score;
  for (const auto& entry :
       std::filesystem::directory_iterator(sharedFolder() / "gait" / "trials")) {
    if (entry.path().extension() == ".bvh") addTrial(entry.path(), tilt, score);
  }
  return score;
}

TEST(FootPlantsOfCaptures, AgreeWithForcePlatesBetterThanTheThesisWithItsEyes) {
  if (!std::filesystem::exists(sharedFolder() / "gait"))
    GTEST_SKIP() << "no trials in " << sharedFolder();
  const Score score = scoreOfTrials(Eigen::Quaterniond::Identity());
  // The thesis' own: 0.970, 0.973, 0.932, 0.960.
  EXPECT_GT(score.precision(), 0.985);
  EXPECT_GT(score.recall(), 0.970);
  EXPECT_GT(score.specificity(), 0.980);
  EXPECT_GT(score.accuracy(), 0.975);
  const Score tilted = scoreOfTrials(fromEuler({1.05 * kDegree, 0, 0}, {'X', 'Y', 'Z'}));
  EXPECT_GT(tilted.accuracy(), score.accuracy() - 0.005);
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
