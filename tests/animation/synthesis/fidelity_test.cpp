// Walks at the speed of their own capture against the captured mean cycle.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "animation/body/foot_shape.h"
#include "animation/preparation/mirror_cycle.h"
#include "animation/preparation/motion_library_add.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/carried_walk.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

/// The level, but for a pit.
class Pit : public FlatGround {
 public:
  explicit Pit(const Eigen::Vector2d& middle) : middle_(middle) {}
  std::optional<SurfacePoint> surface(double x, double y, double z, double reach) const override {
    constexpr double kRadius = 0.05;  // [m]
    if ((Eigen::Vector2d(x, y) - middle_).norm() < kRadius) return std::nullopt;
    return FlatGround::surface(x, y, z, reach);
  }

 private:
  Eigen::Vector2d middle_;
};

/// A library of one walk, or of a straight walk and a turn; the walk that is made of it at its own
/// speed and turn rate, and the captured cycle. Over a pit, if it is asked for, steps are chosen.
struct Compared {
  MotionLibrary library;
  std::string compared = "walk";
  std::vector<Carried> captured;  // by phase
  CarriedWalk made;
  std::vector<Footprint> prints;  // of what was made

  explicit Compared(const std::string& clip, const std::string& stand, const std::string& turn = "",
                    bool pit = false) {
    if (!stand.empty()) add(MotionKind::kPosture, "stand", stand);
    add(MotionKind::kWalk, "walk", clip);
    if (!turn.empty()) {
      add(MotionKind::kWalk, compared = "turn", turn);
      Motion other = *library.find("turn");  // who turns one way only is not let turn as fast
      other.name = "other";
      other.cycle =
          mirrorCycle(other.cycle, library.skeleton, library.roles, library.stand().rotations);
      library.motions.push_back(other);
    }
    captured = carriedInCapture(library, *library.find(compared),
                                sharedFolder() / "mocap" / (turn.empty() ? clip : turn));
    walk(pit);
  }

  void add(MotionKind kind, const std::string& name, const std::string& clip) {
    MotionRequest request;
    request.kind = kind;
    request.name = name;
    request.file = (sharedFolder() / "mocap") / clip;
    request.source = {"clip", {0, 0}, false, "none", "none"};
    addMotion(library, request);
  }

  const WalkCycle& cycle() const { return library.find(compared)->cycle; }

  void walk(bool pit) {
    constexpr int kSteps = 12;  // four of them on either side are left out
    CharacterSettings settings;
    settings.speed = cycle().speed;
    settings.frame_time = 1.0 / 240.0;
    const double length = kSteps * cycle().stepLength(), rate = cycle().turn_rate;
    const RootPath path = rate == 0.0
                              ? straightPath(length)
                              : circlePath(cycle().speed / rate, length * rate / cycle().speed);
    std::unique_ptr<const Ground> ground = std::make_unique<FlatGround>();
    if (pit) ground = std::make_unique<Pit>(toesOf(*ground, settings, path));
    const WalkSynthesizer walker(library, *ground, settings);
    AnimationBuffer buffer;
    ASSERT_EQ(
        walker.walk(stanceAt(path, false, false), stanceAt(path, true, false), path, false, buffer)
            .refused,
        WalkRule::kNone);
    made = carriedWalk(buffer, library.skeleton, library.roles);
    prints = buffer.footprints;
  }

  /// Where the toes of the third step are put down.
  Eigen::Vector2d toesOf(const Ground& ground, const CharacterSettings& settings,
                         const RootPath& path) const {
    const WalkSynthesizer walker(library, ground, settings);
    AnimationBuffer buffer;
    walker.walk(stanceAt(path, false, false), stanceAt(path, true, false), path, false, buffer);
    const Footprint& print = buffer.footprints.at(4);
    const double ahead = 0.5 * kFootLengthOfStature * walker.stature();
    return print.position.head<2>() +
           ahead * Eigen::Vector2d(std::cos(print.heading), std::sin(print.heading));
  }

  double rms(std::array<double, 2> Carried::*angle, Side side) const {
    return rmsBetween(made.at, captured, angle, side);
  }
};

// What issue and QUALITY.md ask for: 2.5 degrees for hips, knees and ankles, 2 for the least
// flexion, 1 % of the period, 4 mm of the pelvis, 2 % of the cycle for strikes and lift-offs.
TEST(Fidelity, AtItsOwnSpeedAWalkIsTheCapturedOne) {
  AMBLE_NEEDS_CAPTURES();
  for (const auto& [clip, stand] :
       {std::pair("accad_female1/Female1_B03_Walk1.bvh", "accad_female1/Female1_A01_Stand.bvh"),
        std::pair("accad_male1/Male1_B3_Walk.bvh", ""), std::pair("cmu_mb2/02_01.bvh", ""),
        std::pair("cmu_mb2/07_05.bvh", ""), std::pair("cmu_mb2/07_01.bvh", ""),
        std::pair("cmu_mb2/07_10.bvh", ""), std::pair("cmu_mb2/07_12.bvh", ""),
        std::pair("cmu_mb2/08_03.bvh", ""), std::pair("cmu_mb2/08_09.bvh", ""),
        std::pair("cmu_mb2/07_02.bvh", ""), std::pair("cmu_mb2/07_03.bvh", ""),
        std::pair("cmu_mb2/07_06.bvh", ""), std::pair("cmu_mb2/07_08.bvh", ""),
        std::pair("cmu_mb2/08_04.bvh", ""), std::pair("cmu_mb2/08_06.bvh", ""),
        std::pair("cmu_mb2/06_01.bvh", "")}) {
    SCOPED_TRACE(clip);
    const Compared walk(clip, stand);
    EXPECT_NEAR(walk.made.period, walk.cycle().period, 0.01 * walk.cycle().period);
    double height = 0.0, squares = 0.0;
    for (int i = 0; i < kCompared; ++i)
      height += (walk.made.at[i].height - walk.captured[i].height) / kCompared;
    for (int i = 0; i < kCompared; ++i)
      squares += std::pow(walk.made.at[i].height - walk.captured[i].height, 2) / kCompared;
    EXPECT_LT(std::abs(height), 0.001);
    EXPECT_LT(std::sqrt(squares), 0.004);
    for (const Side side : {kLeft, kRight}) {
      EXPECT_LT(walk.rms(&Carried::hip, side), 2.5) << side;
      EXPECT_LT(walk.rms(&Carried::knee, side), 2.5) << side;
      EXPECT_LT(walk.rms(&Carried::ankle, side), 2.5) << side;
      const FootCycle& foot = walk.cycle().feet[side];
      EXPECT_NEAR(std::remainder(walk.made.strike[side] - foot.strike, 1.0), 0.0, 0.02);
      EXPECT_NEAR(std::remainder(walk.made.lift_off[side] - foot.lift_off, 1.0), 0.0, 0.02);
      EXPECT_NEAR(leastKnee(walk.made.at, side), leastKnee(walk.captured, side), 2.0) << side;
    }
    for (const Footprint& print : walk.prints)
      EXPECT_NEAR(print.heading, walk.cycle().toe_out[print.side], 1e-9) << print.side;
  }
}

// The bar is 4 degrees. Steps that turn are those of the capture: when and where they are put down,
// how they swing and roll, how long they are.
TEST(Fidelity, AtItsOwnRateATurnIsTheCapturedOne) {
  AMBLE_NEEDS_CAPTURES();
  const std::string person = "accad_female1/Female1_";
  for (const char* turn :
       {"B09_WalkTurnLeft90.bvh", "B12_WalkTurnRight90.bvh", "B10_WalkTurnLeft45.bvh"}) {
    SCOPED_TRACE(turn);
    const Compared walk(person + "B03_Walk1.bvh", person + "A01_Stand.bvh", person + turn);
    EXPECT_NEAR(walk.made.period, walk.cycle().period, 0.01 * walk.cycle().period);
    for (const Side side : {kLeft, kRight}) {
      EXPECT_LT(walk.rms(&Carried::hip, side), 2.5) << side;
      EXPECT_LT(walk.rms(&Carried::knee, side), 3.0) << side;
      const FootCycle& foot = walk.cycle().feet[side];
      EXPECT_NEAR(std::remainder(walk.made.strike[side] - foot.strike, 1.0), 0.0, 0.01);
      EXPECT_NEAR(std::remainder(walk.made.lift_off[side] - foot.lift_off, 1.0), 0.0, 0.01);
    }
  }
}

// Where one step has to be chosen all of the walk are: they turn as they would without.
TEST(Fidelity, WhereStepsAreChosenForTheGroundATurnIsTheCapturedOneToo) {
  AMBLE_NEEDS_CAPTURES();
  const std::string person = "accad_female1/Female1_";
  const std::string walk = person + "B03_Walk1.bvh", stand = person + "A01_Stand.bvh",
                    turn = person + "B10_WalkTurnLeft45.bvh";
  const Compared natural(walk, stand, turn), chosen(walk, stand, turn, true);
  EXPECT_NEAR(chosen.made.period, natural.made.period, 0.03 * natural.made.period);
  for (const Side side : {kLeft, kRight}) {
    EXPECT_NEAR(chosen.rms(&Carried::hip, side), natural.rms(&Carried::hip, side), 0.5) << side;
    EXPECT_NEAR(chosen.rms(&Carried::knee, side), natural.rms(&Carried::knee, side), 0.5) << side;
  }
}

}  // namespace
}  // namespace amble
