#include "environments/scene/mesh_warnings.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

MeshFile fileOf(const Eigen::Vector3d& size, const Eigen::Vector3d& at = {0, 0, 0}) {
  MeshFile file;
  file.parts.push_back({{"room"}, makeBox(size)});
  for (Eigen::Vector3d& v : file.parts[0].mesh.vertices) v += at;
  return file;
}

std::string onlyWarning(const MeshFile& file, double scale, bool is_guessed, bool y_up = false) {
  const auto warnings = meshWarnings("house", file, scale, is_guessed, y_up);
  EXPECT_LE(warnings.size(), 1u);
  return warnings.empty() ? "" : warnings[0];
}

TEST(MeshWarnings, ARoomInCentimetresIsToldWithItsScale) {
  const MeshFile room = fileOf({620, 420, 260});
  EXPECT_EQ(onlyWarning(room, 1.0, true),
            "house: 620 m wide, 420 m deep and 260 m high; if its unit is the centimetre, `scale: "
            "0.01` makes it 6.2, 4.2 and 2.6 m");
  EXPECT_EQ(onlyWarning(room, 1.0, false), "");  // said so
  EXPECT_NE(onlyWarning(fileOf({620, 260, 420}), 1.0, true, true), "");
}

TEST(MeshWarnings, ARoomInInchesIsToldSo) {
  EXPECT_NE(onlyWarning(fileOf({240, 160, 98}), 1.0, true).find("scale: 0.0254"),
            std::string::npos);
}

TEST(MeshWarnings, RoomsHousesAndHillsAreNot) {
  EXPECT_EQ(onlyWarning(fileOf({6, 4, 2.6}), 1.0, true), "");
  EXPECT_EQ(onlyWarning(fileOf({30, 20, 50}), 1.0, true), "");
  EXPECT_EQ(onlyWarning(fileOf({900, 900, 90}), 1.0, true), "");
}

// A float has 24 bits: beyond 8,192 units they are more than a thousandth apart.
TEST(MeshWarnings, AMeshFarFromItsOriginHasLostItsShape) {
  EXPECT_EQ(onlyWarning(fileOf({6, 4, 2.6}, {8000, 0, 0}), 1.0, true), "");
  EXPECT_NE(onlyWarning(fileOf({6, 4, 2.6}, {451234, 5412345, 312}), 1.0, true).find("0.5 m apart"),
            std::string::npos);
  EXPECT_EQ(onlyWarning(fileOf({600, 400, 260}, {80000, 0, 0}), 0.01, false), "");
}

TEST(MeshWarnings, WhatWasPassedOverIsToldWithItsObject) {
  MeshFile file = fileOf({6, 4, 2.6});
  file.warnings = {"house.obj:7: something"};
  EXPECT_EQ(onlyWarning(file, 1.0, false), "house: house.obj:7: something");
}

TEST(MeshWarnings, OfNothingAreNone) { EXPECT_EQ(onlyWarning({}, 1.0, true), ""); }

}  // namespace
}  // namespace amble
