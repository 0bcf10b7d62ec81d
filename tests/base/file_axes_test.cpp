#include "base/file_axes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/rotation.h"

namespace amble {
namespace {

TEST(FileAxes, PointsAndMatrixAgreeWithTheQuaternion) {
  const Eigen::Vector3d p(1, 2, 3);
  EXPECT_EQ(fileToWorld(p, UpAxis::kY), Eigen::Vector3d(1, -3, 2));
  EXPECT_EQ(fileToWorld(p, UpAxis::kZ), p);
  EXPECT_EQ(yUpMatrix() * p, fileToWorld(p, UpAxis::kY));
  EXPECT_LT((yUpToWorld() * p - fileToWorld(p, UpAxis::kY)).norm(), 1e-15);
}

}  // namespace
}  // namespace amble
