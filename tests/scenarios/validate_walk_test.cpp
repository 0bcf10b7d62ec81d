#include "scenarios/validate_walk.h"

#include <cmath>
#include <sstream>

#include "animation/captures/bvh.h"
#include "base/rotation.h"
#include "scenarios/problem.h"
#include "scenarios/run_scenario.h"
#include "scenarios/standing_feet.h"
#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

class ValidateWalk : public SmallRoom {
 protected:
  // Planned once for all claims.
  void SetUp() override {
    SmallRoom::SetUp();
    static const RunResult planned = runScenario(readScenario(write("case.yaml", kScenario)));
    result_ = &planned;
    ASSERT_EQ(result_->report.status, PlanStatus::kSolved);
    walk_ = write("walk.bvh", result_->bvh);
  }
  WalkValidation validate(const ValidateOptions& options = {}) const {
    return validateWalk(walk_, folder_ / "scene.yaml", options);
  }
  Clip walkClip() const {
    const WalkSynthesizer& synthesizer = result_->problem->synthesizer;
    const AnimationBuffer& walk = result_->outcome.walk.buffer;
    return {"walk", synthesizer.skeleton(), walk.frame_time, walk.poses, {}};
  }
  // The same walk elsewhere.
  std::filesystem::path moved(const Eigen::Vector3d& by, double unit = 1.0) const {
    Clip clip = walkClip();
    for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i) += by;
    BvhWriteOptions options;
    options.metres_per_unit = unit;
    writeBvh(folder_ / "moved.bvh", clip, options);
    return folder_ / "moved.bvh";
  }
  WalkValidation validateMoved(const Eigen::Vector3d& by) const {
    return validateWalk(moved(by), folder_ / "scene.yaml");
  }

  const RunResult* result_ = nullptr;
  std::filesystem::path walk_;
};

TEST_F(ValidateWalk, BadFilesAreInputErrors) {
  EXPECT_THROW(validateWalk(folder_ / "none.bvh", folder_ / "scene.yaml"), InputError);
  EXPECT_THROW(validateWalk(walk_, folder_ / "none.yaml"), InputError);
  EXPECT_THROW(validateWalk(folder_ / "scene.yaml", folder_ / "scene.yaml"), InputError);
}

TEST_F(ValidateWalk, AWalkOutsideOfTheSceneIsAnInputError) {
  const std::string error = inputError([&] { validateMoved({50, 0, 0}); });
  EXPECT_TRUE(holds(error, "has no floor")) << error;
}

TEST_F(ValidateWalk, OurOwnWalkTouchesNothingAndHasTheReportsClearance) {
  const WalkValidation found = validate();
  for (const ContactSpan& contact : found.contacts) {
    ADD_FAILURE() << contact.part << " and " << contact.object << " at " << contact.start;
  }
  EXPECT_EQ(found.frames, result_->report.frames);
  EXPECT_EQ(found.metres_per_unit, 1.0);
  EXPECT_NEAR(found.stature, result_->report.stature, 1e-4);
  EXPECT_NEAR(found.clearance, result_->report.clearance.min, 1e-4);
  EXPECT_EQ(found.clearance_object, result_->report.clearance.object);
  EXPECT_NEAR(found.floor, 0.0, 1e-9);
  EXPECT_LE(found.feet.skate_mean, 0.002);
  EXPECT_GE(found.feet.plants, 6);
}

TEST_F(ValidateWalk, OurOwnWalkSlidesAsItsReportSaysThoughPlantsAreFoundAnew) {
  const WalkValidation found = validate();
  EXPECT_NEAR(found.feet.skate_max, result_->report.foot_skate_max, 0.001);
  EXPECT_LE(found.feet.skate_max, 0.002) << "the bar of QUALITY.md";
}

TEST_F(ValidateWalk, OurOwnWalkStandsOnTheGround) {
  const WalkValidation found = validate();
  EXPECT_FALSE(found.hovers());
  EXPECT_LT(found.feet.hover_max, 0.005);
  EXPECT_EQ(found.feet.hover_share, 0.0);
}

TEST_F(ValidateWalk, AWalkThatIsLiftedHangsInTheAirByAsMuch) {
  for (const double lift : {0.02, 0.5}) {
    const WalkValidation found = validateMoved({0, 0, lift});
    EXPECT_TRUE(found.hovers()) << lift;
    EXPECT_NEAR(found.feet.hover_max, lift, 0.005);
    EXPECT_GT(found.feet.hover_share, 0.9);
    EXPECT_NEAR(found.floor, 0.0, 1e-9) << "lifted feet have no other floor";
    EXPECT_TRUE(found.contacts.empty());
  }
  EXPECT_EQ(validateMoved({0, 0, 3.0}).feet.hover_max, kMostHover);
}

TEST_F(ValidateWalk, WhoIsNoPersonIsAnInputError) {
  ValidateOptions options;
  for (const double unit : {1e-6, 0.1, 4e6}) {
    options.metres_per_unit = unit;
    const std::string error = inputError([&] { validate(options); });
    EXPECT_TRUE(holds(error, "walk.bvh: the body is ")) << unit << ": " << error;
    EXPECT_TRUE(holds(error, "expected 0.4 to 3 m; --unit")) << error;
  }
}

TEST_F(ValidateWalk, AThingThatTheWalkBeginsInIsNotItsFloor) {
  // A block of 2.5 m about the start: what could be stood on there is its top.
  write("block.yaml", std::string(kScene) +
                          "  - {name: block, box: {size: [1, 1, 2.5]}, at: [0.8, 1.5, 1.25]}\n");
  const WalkValidation found = validateWalk(walk_, folder_ / "block.yaml");
  EXPECT_NEAR(found.floor, 0.0, 1e-9);
  EXPECT_FALSE(found.hovers());
  ASSERT_FALSE(found.contacts.empty());
  EXPECT_EQ(found.contacts.front().object, "block");
  EXPECT_EQ(found.contacts.front().start, 0.0);
}

TEST_F(ValidateWalk, MorePosesThanThereIsRoomForAreRefusedBeforeTheyAreMade) {
  ValidateOptions options;
  options.fps = 1e6;
  EXPECT_TRUE(holds(inputError([&] { validate(options); }), "--fps: 1e+06 frames a second"));
}

TEST_F(ValidateWalk, WhatIsGroundIsAsSteepAndHighAsTheWalksLimits) {
  // The floor is one plane of 24 degrees: ground to one who climbs 30, an obstacle to one of 20.
  const double tilt = std::tan(24.0 * kDegree);
  std::ostringstream plane;
  plane << "v 0 0 0\nv 6 0 0\nv 6 3 " << 3 * tilt << "\nv 0 3 " << 3 * tilt << "\nf 1 2 3 4\n";
  write("plane.obj", plane.str());
  write("slope.yaml", "name: slope\nobjects:\n  - {name: plane, mesh: plane.obj, up: z}\n");
  ValidateOptions options;
  options.limits.max_slope = 30.0 * kDegree;
  const std::filesystem::path walk = moved({0, 0, 1.5 * tilt});  // along the slope, at its middle
  const WalkValidation able = validateWalk(walk, folder_ / "slope.yaml", options);
  for (const ContactSpan& contact : able.contacts) {
    EXPECT_EQ(contact.part.find("pelvis"), std::string::npos) << "nothing but feet is low";
  }
  EXPECT_NEAR(able.floor, 1.5 * tilt, 0.2);
  const std::string error = inputError([&] { validateWalk(walk, folder_ / "slope.yaml"); });
  EXPECT_TRUE(holds(error, "has no floor")) << error;
}

TEST_F(ValidateWalk, NothingIsTouchedBetweenTheFramesEither) {
  ValidateOptions options;
  options.fps = 240.0;
  const WalkValidation found = validate(options);
  EXPECT_TRUE(found.contacts.empty());
  EXPECT_EQ(found.poses_checked, 4 * (found.frames - 1) + 1);
}

TEST_F(ValidateWalk, AWalkMovedIntoAWallTouchesIt) {
  // Start and goal are 1.5 m from the wall: their middle comes to 0.15 m from it, and a pelvis is
  // wider.
  const WalkValidation found = validateMoved({0, 1.35, 0});
  ASSERT_FALSE(found.contacts.empty());
  bool north = false;
  for (const ContactSpan& contact : found.contacts) {
    north |= contact.object == "wall-north";
    EXPECT_LE(contact.start, contact.end);
    EXPECT_LE(contact.end, (found.frames - 1) * found.frame_time + 1e-9);
  }
  EXPECT_TRUE(north);
  EXPECT_EQ(found.clearance, 0.0);
}

TEST_F(ValidateWalk, ASunkenWalkTouchesTheFloor) {
  constexpr double kDepth = 0.02;
  const WalkValidation found = validateMoved({0, 0, -kDepth});
  ASSERT_FALSE(found.contacts.empty());
  EXPECT_EQ(found.contacts.front().object, "floor");
  EXPECT_NEAR(found.ground_penetration, kDepth, 0.002);
}

TEST_F(ValidateWalk, TheUnitIsGuessedFromTheLegs) {
  const WalkValidation found =
      validateWalk(moved(Eigen::Vector3d::Zero(), 0.01), folder_ / "scene.yaml");
  EXPECT_EQ(found.metres_per_unit, 0.01);
  EXPECT_TRUE(found.contacts.empty());
  EXPECT_NEAR(found.stature, result_->report.stature, 1e-4);
}

TEST_F(ValidateWalk, ADragThatTheGaitDoesNotKnowIsSkate) {
  Clip clip = walkClip();
  for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).y() += 0.0005 * i;  // 3 cm/s sideways
  writeBvh(folder_ / "dragged.bvh", clip);
  const WalkValidation found = validateWalk(folder_ / "dragged.bvh", folder_ / "scene.yaml");
  EXPECT_GT(found.feet.skate_mean, validate().feet.skate_mean + 0.002);
}

TEST_F(ValidateWalk, WhoGetsLessFarThanHisStepsReachSlides) {
  EXPECT_FALSE(validate().slides());
  Clip clip = walkClip();
  for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).x() *= 0.6;
  writeBvh(folder_ / "shorter.bvh", clip);
  EXPECT_TRUE(validateWalk(folder_ / "shorter.bvh", folder_ / "scene.yaml").slides());
}

TEST_F(ValidateWalk, AJointThatIsElsewhereForAFrameIsAPop) {
  EXPECT_FALSE(validate().hasPops());
  for (int joint = 1; joint < walkClip().skeleton.size(); joint += 4) {
    Clip clip = walkClip();
    clip.poses.rotations(100)[joint] *=
        Eigen::Quaterniond(Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitX()));
    writeBvh(folder_ / "jumps.bvh", clip);
    EXPECT_TRUE(validateWalk(folder_ / "jumps.bvh", folder_ / "scene.yaml").hasPops())
        << clip.skeleton.joint(joint).name;
  }
}

}  // namespace
}  // namespace amble
