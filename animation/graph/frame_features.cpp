#include "animation/graph/frame_features.h"

#include <array>
#include <cmath>

#include "animation/analysis/low_pass.h"
#include "animation/body/pelvis.h"
#include "base/rotation.h"

namespace amble {
namespace {

using Points = std::array<Eigen::Vector3d, kFeaturePoints>;

int firstOf(int a, int b) { return a >= 0 ? a : b; }

Points pointsOf(const Clip& clip, const JointRoles& roles, std::span<const JointFrame> joints) {
  Points points;
  points[0] = joints[0].p_WJ;
  points[1] = joints[firstOf(roles.head, roles.neck)].p_WJ;
  for (const Side side : {kLeft, kRight}) {
    points[2 + side] = joints[firstOf(roles.arms[side].hand, roles.arms[side].fore_arm)].p_WJ;
    const LegJoints& leg = roles.legs[side];
    const auto& tips = clip.skeleton.joint(leg.foot).end_sites;
    points[4 + side] = leg.toe >= 0   ? joints[leg.toe].p_WJ
                       : tips.empty() ? joints[leg.foot].p_WJ
                                      : joints[leg.foot] * tips[0];
  }
  return points;
}

// Of the positions, adding up to 1; roots of them, which multiply distances.
std::array<double, kFeaturePoints> rootsOfWeights() {
  std::array<double, kFeaturePoints> weights = {kRootWeight, kHeadWeight, kHandWeight,
                                                kHandWeight, kFootWeight, kFootWeight};
  double sum = 0.0;
  for (const double weight : weights) sum += weight;
  for (double& weight : weights) weight = std::sqrt(weight / sum);
  return weights;
}

}  // namespace

FrameFeatures frameFeatures(const Clip& clip, const JointRoles& roles) {
  const double rate = 1.0 / clip.frame_time;
  Eigen::MatrixXd places(clip.frames(), 3 * kFeaturePoints);
  std::vector<double> headings(clip.frames());
  std::vector<JointFrame> joints(clip.skeleton.size());
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, joints);
    headings[i] = pelvisHeading(joints, roles);
    const Points points = pointsOf(clip, roles, joints);
    for (int k = 0; k < kFeaturePoints; ++k) places.block<1, 3>(i, 3 * k) = points[k].transpose();
  }
  const Eigen::MatrixXd speeds = derivative(places, rate), changes = derivative(speeds, rate);
  const auto weights = rootsOfWeights();
  FrameFeatures features = FrameFeatures::Zero(kFeatureRows, clip.frames());
  for (int i = 0; i < clip.frames(); ++i) {
    const Eigen::Matrix3d back = aboutZ(-headings[i]).toRotationMatrix();
    Eigen::Vector3d root = places.block<1, 3>(i, 0).transpose();
    root.z() = 0.0;
    for (int k = 0; k < kFeaturePoints; ++k) {
      const auto put = [&](int row, const Eigen::Vector3d& value, double scale) {
        features.block<3, 1>(row + 3 * k, i) = (weights[k] * scale * (back * value)).cast<float>();
      };
      constexpr int kRows = 3 * kFeaturePoints;
      put(0, places.block<1, 3>(i, 3 * k).transpose() - root, 1.0);
      put(kRows, speeds.block<1, 3>(i, 3 * k).transpose(), kFeatureReach);
      put(2 * kRows, changes.block<1, 3>(i, 3 * k).transpose(),
          0.5 * kFeatureReach * kFeatureReach);
    }
  }
  return features;
}

}  // namespace amble
