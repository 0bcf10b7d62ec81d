// Scenes that were read wrongly once, and what is right (cases/README.md, beside the captures).
#include <gtest/gtest.h>

#include "environments/ground/ground_warnings.h"
#include "test_paths.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

class SceneCases : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kCases)) GTEST_SKIP() << "the cases are not there";
  }
  static Scene read(const std::string& name) { return readScene(kCases / name / "scene.yaml"); }
  static std::string problemOf(const std::string& name) {
    return errorOf([&] { read(name); });
  }
  static bool says(const std::vector<std::string>& lines, const std::string& what) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.find(what) != std::string::npos;
    });
  }

  static inline const std::filesystem::path kCases =
      std::filesystem::path(AMBLE_SHARED) / "cases" / "scenes";
};

TEST_F(SceneCases, ARoomInCentimetresIsWarnedOf) {
  EXPECT_TRUE(says(read("s03_cm_forgot").warnings, "`scale: 0.01`"));
}

TEST_F(SceneCases, AFloorThatFacesDownIsWarnedOf) {
  const Scene scene = read("s10_floor_plane_facing_down");
  EXPECT_TRUE(says(groundWarnings(scene, SceneGround(scene)), "floor: faces down"));
}

TEST_F(SceneCases, CoordinatesOfMillionsAreWarnedOfAndBroughtBackByAt) {
  EXPECT_TRUE(says(read("s16_geo_offset").warnings, "its shape is lost"));
  const Scene back = readScene(kCases / "s16_geo_offset" / "scene-at.yaml");
  EXPECT_LT(back.bounds().max().cwiseAbs().maxCoeff(), 10.0);
}

TEST_F(SceneCases, AHouseOnASiteOf400MetresHasItsStairs) {
  const Scene scene = read("s17_site400");
  const SceneGround ground(scene);
  for (int i = 0; i < 8; ++i) {
    const double x = 3.0 + (i + 0.5) * 0.29;
    EXPECT_TRUE(ground.height(x, 1.6, (i + 1) * 0.17, 0.02).has_value()) << i;
  }
  EXPECT_TRUE(ground.height(150, -150, -0.02, 0.01).has_value());
}

TEST_F(SceneCases, PointsOnlyAreCalledThat) {
  EXPECT_NE(problemOf("s19_ply_points").find("only points or lines, no faces"), std::string::npos);
}

TEST_F(SceneCases, ARequiredExtensionThatIsNotKnownIsNamed) {
  EXPECT_NE(problemOf("s23_gpu_instancing").find("EXT_mesh_gpu_instancing"), std::string::npos);
}

}  // namespace
}  // namespace amble
