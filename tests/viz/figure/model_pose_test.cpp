#include "viz/figure/model_pose.h"

#include <gtest/gtest.h>

#include "animation/body/foot_shape.h"
#include "animation/captures/motion_reader.h"
#include "base/rotation.h"
#include "scenarios/captured_body.h"
#include "tests/animation/captures.h"
#include "tests/environments/test_walker.h"

namespace amble {
namespace {

using Eigen::Vector3d;

const TestWalker kModelled;

Vector3d along(const Body& body, const std::vector<JointFrame>& frames, Side side,
               const char* part) {
  const BodyPart& one = body.parts[findPart(body, side, part)];
  return (frames[one.joint].q_WJ * (one.to - one.from)).normalized();
}

void expectModelled(const Skeleton& skeleton, const Body& body, const std::string& who) {
  const std::vector<JointFrame> frames = modelPose(skeleton, body);
  ASSERT_EQ(frames.size(), static_cast<size_t>(skeleton.size()));
  EXPECT_LT(frames[0].p_WJ.norm(), 1e-12) << who;
  const auto at = [&](int part) -> Vector3d { return frames[body.parts[part].joint].p_WJ; };
  for (const Side side : {kLeft, kRight}) {
    const double out = side == kLeft ? 1.0 : -1.0;
    const Vector3d arm =
        (at(findPart(body, side, "forearm")) - at(findPart(body, side, "upper arm"))).normalized();
    EXPECT_NEAR(out * arm.y(), std::sqrt(0.5), 1e-6) << who;
    EXPECT_NEAR(arm.z(), -std::sqrt(0.5), 1e-6) << who;
    const Vector3d thigh =
        (at(findPart(body, side, "shank")) - at(findPart(body, side, "thigh"))).normalized();
    EXPECT_NEAR(thigh.z(), -std::cos(6.0 * kDegree), 1e-6) << who;
    EXPECT_NEAR(out * thigh.y(), std::sin(6.0 * kDegree), 1e-6) << who;
    const Vector3d sole = along(body, frames, side, "sole, outside");
    EXPECT_GT(sole.x(), 0.8) << who;  // ahead
    EXPECT_LT(std::abs(sole.z()), 0.1) << who;
  }
  EXPECT_GT(at(findPart(body, "head")).z(), 0.3) << who;
}

TEST(ModelPose, StandsUprightWithArmsAndLegsApart) {
  expectModelled(kModelled.skeleton, kModelled.body, "test walker");
}

// Whoever was captured, in whatever rig and whichever way he faces in its rest pose.
TEST(ModelPose, OfCapturesOfAllRigsIsTheSame) {
  AMBLE_NEEDS_CAPTURES();
  int seen = 0;
  std::string before;
  for (const Capture& capture : captures()) {
    const std::string subject = capture.path.substr(0, capture.path.find('/'));
    if (subject == before || capture.frames > 2000) continue;
    before = subject;
    MotionReadOptions options;
    options.person = false;
    const CapturedMotion motion = readMotion(capture.file, options);
    if (!motion.no_person.empty()) continue;
    const Clip& clip = motion.clip;
    const Body body = capturedBody(clip, motion.roles, lowestAnkle(clip, motion.roles) - 0.08,
                                   statureOf(clip.skeleton, motion.roles));
    ASSERT_TRUE(isPerson(body)) << capture.path;
    expectModelled(clip.skeleton, body, capture.path);
    ++seen;
  }
  EXPECT_GE(seen, 2);
}

TEST(ModelPose, KeepsTheLengthsOfAllBones) {
  const std::vector<JointFrame> frames = modelPose(kModelled.skeleton, kModelled.body);
  for (int j = 1; j < kModelled.skeleton.size(); ++j) {
    const Joint& joint = kModelled.skeleton.joint(j);
    EXPECT_NEAR((frames[j].p_WJ - frames[joint.parent].p_WJ).norm(), joint.offset.norm(), 1e-12);
    EXPECT_NEAR(frames[j].q_WJ.norm(), 1.0, 1e-12);
  }
}

TEST(ModelPose, OfSomebodyWithoutAllPartsIsThePoseHeWasShapedIn) {
  Body few = kModelled.body;
  few.parts.pop_back();
  EXPECT_FALSE(isPerson(few));
  const std::vector<JointFrame> frames = modelPose(kModelled.skeleton, few);
  for (int j = 1; j < kModelled.skeleton.size(); ++j) {
    const Joint& joint = kModelled.skeleton.joint(j);
    EXPECT_LT((frames[j].p_WJ - frames[joint.parent].p_WJ - yUpToWorld() * joint.offset).norm(),
              1e-12);
  }
}

TEST(FindPart, TellsSidesApartAndKnowsWhatIsNotThere) {
  const Body& body = kModelled.body;
  for (const Side side : {kLeft, kRight}) {
    const int hand = findPart(body, side, "hand");
    ASSERT_GE(hand, 0);
    EXPECT_EQ(body.parts[hand].name, side == kLeft ? "left hand" : "right hand");
  }
  EXPECT_EQ(findPart(body, "hand"), -1);
  EXPECT_EQ(findPart(Body{}, "head"), -1);
}

}  // namespace
}  // namespace amble
