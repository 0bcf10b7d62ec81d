#include "environments/ground/ground_column.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

// A scene with all that a column asks.
struct Asked {
  explicit Asked(const std::vector<SceneObject>& objects)
      : scene(sceneOf(objects)), pieces(splitScene(scene)) {
    for (const Triangle3& t : pieces.triangles())
      up.push_back(upwardness(t) >= std::cos(settings.limits.max_slope));
  }
  std::vector<GroundColumn::Surface> at(double x, double y) const {
    return GroundColumn(scene, pieces, up, settings).surfacesAt({x, y});
  }

  Scene scene;
  ScenePieces pieces;
  std::vector<bool> up;
  GroundSettings settings;
};

TEST(GroundColumn, WhereNothingIsThereAreNoSurfaces) {
  const Asked floor({makeObject("floor", Box{{4, 4, 0.1}}, {0, 0, -0.05})});
  EXPECT_TRUE(floor.at(2.5, 0.0).empty());
  EXPECT_EQ(floor.at(0.0, 0.0).size(), 1u);
}

// Along a straight edge a foot has room from half its breadth on.
TEST(GroundColumn, AFootHasRoomHalfItsBreadthFromAnEdge) {
  const Asked floor({makeObject("floor", Box{{4, 4, 0.1}}, {0, 0, -0.05})});
  const double half = 0.5 * floor.settings.foot_breadth;
  EXPECT_TRUE(floor.at(2.0 - half - 0.002, 0.3).at(0).standable);
  EXPECT_FALSE(floor.at(2.0 - half + 0.002, 0.3).at(0).standable);
}

TEST(GroundColumn, WhoStandsNeedsHeadroom) {
  for (const double more : {-0.01, 0.01}) {
    const double ceiling = GroundSettings{}.headroom + more;
    const Asked room({makeObject("floor", Box{{4, 4, 0.1}}, {0, 0, -0.05}),
                      makeObject("roof", Box{{4, 4, 0.1}}, {0, 0, ceiling + 0.05})});
    EXPECT_EQ(room.at(0.3, 0.4).at(0).standable, more > 0.0) << ceiling;
  }
}

TEST(GroundColumn, OfWhatIsSaidToBeGroundItIsSaid) {
  const Asked floors({makeObject("floor", Box{{4, 4, 0.1}}, {0, 0, -0.05}),
                      makeObject("rug", Box{{1, 1, 0.02}}, {0, 0, 0.01}, Role::kGround)});
  EXPECT_FALSE(floors.at(1.5, 1.5).at(0).said);
  EXPECT_TRUE(floors.at(0.0, 0.0).back().said);
}

// Storeys that are farther apart than anybody is tall know nothing of one another: over each point
// the surfaces are those of each storey alone, however many there are and whatever was asked
// before.
TEST(GroundColumn, EachStoreyIsJudgedAsIfItWereAlone) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2.0, 2.0), tilt(-0.08, 0.08), size(0.05, 2.5);
  std::vector<SceneObject> all;
  std::vector<Asked> alone;
  for (int storey = 0; storey < 6; ++storey) {
    std::vector<SceneObject> boxes;
    for (int k = 0; k < 8; ++k) {
      SceneObject box =
          makeObject("box" + std::to_string(8 * storey + k), Box{{size(random), size(random), 0.1}},
                     {place(random), place(random), 4.0 * storey + tilt(random)});
      boxes.push_back(box);
      all.push_back(box);
    }
    alone.emplace_back(boxes);
  }
  const Asked together(all);
  GroundColumn column(together.scene, together.pieces, together.up, together.settings);
  int standable = 0, not_standable = 0;
  for (int k = 0; k < 300; ++k) {
    const Eigen::Vector2d p(place(random), place(random));
    std::vector<GroundColumn::Surface> expected;
    for (const Asked& storey : alone)
      for (const GroundColumn::Surface& surface : storey.at(p.x(), p.y()))
        expected.push_back(surface);
    const auto& found = column.surfacesAt(p);
    ASSERT_EQ(found.size(), expected.size()) << k;
    for (size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].height, expected[i].height);
      EXPECT_EQ(found[i].standable, expected[i].standable) << k << ' ' << i;
      ++(found[i].standable ? standable : not_standable);
    }
  }
  EXPECT_GT(standable, 100);
  EXPECT_GT(not_standable, 100);
}

}  // namespace
}  // namespace amble
