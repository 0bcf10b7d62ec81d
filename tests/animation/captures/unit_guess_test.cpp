#include "animation/captures/unit_guess.h"

#include <gtest/gtest.h>

#include "animation/captures/motion_reader.h"
#include "tests/animation/captures.h"

namespace amble {
namespace {

TEST(UnitGuess, LegsWithoutALengthSayNothing) {
  EXPECT_FALSE(guessUnit(0.0, {}).sure);
  EXPECT_TRUE(checkSaidUnit(1.0, 0.0).sure);
}

TEST(UnitGuess, AnAdultsLegsAreSureInEveryUsualUnit) {
  for (const double unit : {1.0, 0.01, 0.0254, 0.056444, 0.001, 0.3048}) {
    for (const double leg : {0.78, 0.83, 0.92}) {
      const Reading<double> guess = guessUnit(leg / unit, {});
      EXPECT_EQ(guess.value, unit) << leg;
      EXPECT_TRUE(guess.sure) << guess.text;
    }
  }
}

TEST(UnitGuess, DecimetresAreFoundThoughTheyAreRare) { EXPECT_EQ(guessUnit(8.0, {}).value, 0.1); }

TEST(UnitGuess, AChildOrAGiantIsUnsureAndBothAreNamed) {
  const Reading<double> guess = guessUnit(0.48 / 0.0254, {});
  EXPECT_FALSE(guess.sure);
  EXPECT_NE(guess.text.find("0.056444 m"), std::string::npos) << guess.text;
  EXPECT_NE(guess.text.find("0.0254 m"), std::string::npos) << guess.text;
}

TEST(UnitGuess, CadenceTellsAChildFromAGiant) {
  // 0.48 m or 1.07 m of leg: so many steps at such a speed are those of short legs.
  StepRhythm child{10, 0.0, 1.5, 1.5}, giant = child;
  child.cadence = 2.0 * 0.743 * std::sqrt(1.5) * std::pow(0.83 / 0.48, 0.25);
  giant.cadence = 2.0 * 0.743 * std::sqrt(1.5) * std::pow(0.83 / 1.07, 0.25);
  EXPECT_EQ(guessUnit(0.48 / 0.0254, child).value, 0.0254);
  EXPECT_EQ(guessUnit(0.48 / 0.0254, giant).value, 0.056444);
}

TEST(UnitGuess, CmusUnitIsExpectedAtCmusRateAndElseASmallChildInInchesIsThoughtOf) {
  // 0.36 m of leg in inches, or an adult's 0.80 m in CMU's unit.
  const double leg = 0.36 / 0.0254;
  EXPECT_TRUE(guessUnit(leg, {}, kCmuFrameTime).sure);
  const Reading<double> other = guessUnit(leg, {}, 1.0 / 30.0);
  EXPECT_FALSE(other.sure);
  EXPECT_NE(other.text.find("or is it 0.0254 m, with legs of 0.36 m?"), std::string::npos)
      << other.text;
}

TEST(UnitGuess, AWalkThatWouldBeARunMakesAnAdultUnsure) {
  // Steps of CMU subject 8, in the time that legs of 0.36 m take for them; 0.92 m in inches.
  StepRhythm quick{4, 2.74, 0.35, 2.52, 2.52}, slow = quick;
  slow.speed = slow.ground_speed = 1.6;
  slow.cadence = 1.85;
  const Reading<double> guess = guessUnit(0.36 / 0.01, quick, 1.0 / 60.0);
  EXPECT_FALSE(guess.sure) << guess.text;
  EXPECT_NE(guess.text.find("0.01 m"), std::string::npos) << guess.text;
  EXPECT_TRUE(guessUnit(0.36 / 0.01, slow, 1.0 / 60.0).sure);
}

TEST(UnitGuess, WhereNobodyHasSuchLegsThoseThatSomebodyHasAreNamed) {
  // A small child in feet has the legs of a giant in metres.
  const Reading<double> guess = guessUnit(0.36 / 0.3048, {}, 1.0 / 30.0);
  EXPECT_FALSE(guess.sure);
  EXPECT_NE(guess.text.find("0.3048 m, with legs of 0.36 m"), std::string::npos) << guess.text;
}

TEST(UnitGuess, LegsThatNobodyHasAreNeverSure) {
  for (const double leg : {0.002, 3.9e-5, 5e4}) {
    EXPECT_FALSE(guessUnit(leg, {}).sure) << leg;
  }
}

TEST(UnitGuess, AFilesOwnUnitIsDoubtedOnlyWhereItMakesNoPerson) {
  for (const double leg : {0.35, 0.48, 0.83, 1.1})
    EXPECT_TRUE(checkSaidUnit(0.01, leg).sure) << leg;
  const Reading<double> dwarf = checkSaidUnit(1.0, 0.008), giant = checkSaidUnit(1.0, 83.0);
  EXPECT_FALSE(dwarf.sure || giant.sure);
  EXPECT_EQ(dwarf.value, 1.0) << "what the file says is kept";
  EXPECT_NE(dwarf.text.find("a person of 1.6 cm; --unit 100 makes one of 1.63 m"),
            std::string::npos)
      << dwarf.text;
  EXPECT_NE(giant.text.find("--unit 0.01 makes one of 1.69 m"), std::string::npos) << giant.text;
}

TEST(UnitGuessOfCases, AreRightOrNameTheOther) {
  const std::filesystem::path folder = sharedFolder() / "cases/captures";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  EXPECT_EQ(readMotion(folder / "a25_unit_dm.bvh").metres_per_unit.value, 0.1);
  const CapturedMotion child = readMotion(folder / "a25_unit_child_inch_060.bvh");
  EXPECT_TRUE(child.metres_per_unit.value == 0.0254 || !child.metres_per_unit.sure);
  EXPECT_NE(child.metres_per_unit.text.find("0.0254"), std::string::npos);
  const CapturedMotion dwarf = readMotion(folder / "g5_armature_cm.gltf");
  EXPECT_FALSE(dwarf.metres_per_unit.sure);
  EXPECT_EQ(dwarf.warnings.size(), 1u);
}

}  // namespace
}  // namespace amble
