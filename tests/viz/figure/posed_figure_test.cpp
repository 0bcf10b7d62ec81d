#include "viz/figure/posed_figure.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/environments/test_walker.h"

namespace amble {
namespace {

using Eigen::Vector3d;

struct Posable {
  const TestWalker walker;
  const Figure figure = makeFigure(walker.skeleton, walker.body);
};

TEST(PosedFigure, InItsBindPoseEverythingIsWhereItIs) {
  const Posable posable;
  const PosedFigure posed = poseFigure(posable.figure, posable.figure.bind);
  ASSERT_EQ(posed.vertices.size(), posable.figure.vertices.size());
  for (size_t i = 0; i < posed.vertices.size(); ++i) {
    EXPECT_LT((posed.vertices[i] - posable.figure.vertices[i]).norm(), 1e-5F);
    EXPECT_LT((posed.normals[i] - posable.figure.normals[i]).norm(), 1e-5F);
  }
}

// Joints that all move as one body carry the skin as one body.
TEST(PosedFigure, ARigidMotionOfTheJointsIsOneOfTheSkin) {
  const Posable posable;
  const Eigen::Quaterniond turn = expRotation(Vector3d(0.3, -0.8, 1.9));
  const Vector3d by(2.0, -3.0, 0.5);
  std::vector<JointFrame> frames = posable.figure.bind;
  for (JointFrame& frame : frames) frame = {turn * frame.q_WJ, turn * frame.p_WJ + by};
  const PosedFigure posed = poseFigure(posable.figure, frames);
  for (size_t i = 0; i < posed.vertices.size(); ++i) {
    const Vector3d vertex = turn * posable.figure.vertices[i].cast<double>() + by;
    const Vector3d normal = turn * posable.figure.normals[i].cast<double>();
    EXPECT_LT((posed.vertices[i].cast<double>() - vertex).norm(), 1e-5);
    EXPECT_LT((posed.normals[i].cast<double>() - normal).norm(), 1e-5);
  }
}

// A turned fore-arm takes along what hangs on it alone, and leaves what hangs on others.
TEST(PosedFigure, AJointCarriesWhatHangsOnItAndNothingElse) {
  const Posable posable;
  const int joint = posable.walker.roles.arms[kLeft].fore_arm;
  std::vector<JointFrame> frames = posable.figure.bind;
  frames[joint].p_WJ += Vector3d(0, 0, 1);
  const PosedFigure posed = poseFigure(posable.figure, frames);
  for (size_t i = 0; i < posed.vertices.size(); ++i) {
    float weight = 0.0F;
    for (int k = 0; k < 4; ++k)
      if (posable.figure.joints[i][k] == joint) weight += posable.figure.weights[i][k];
    EXPECT_NEAR(posed.vertices[i].z() - posable.figure.vertices[i].z(), weight, 1e-5F);
  }
}

}  // namespace
}  // namespace amble
