#include "viz/pictures/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/viz/test_walk.h"
#include "viz/pictures/color.h"

namespace amble {
namespace {

constexpr RenderSettings kSmall{.width = 320, .height = 200};

// Pixels in which one colour channel leads the others clearly: none of wall and floor does.
int strongPixels(const Image& image, int channel) {
  int count = 0;
  for (size_t i = 0; i < image.rgb.size(); i += 3) {
    const int own = image.rgb[i + channel];
    const int other = std::max(image.rgb[i + (channel + 1) % 3], image.rgb[i + (channel + 2) % 3]);
    count += own > other + 50;
  }
  return count;
}

TEST(RenderWalk, HasTheSizeThatIsAskedForAndIsNotBlank) {
  const Image image = renderWalk(makeTestWalk()->view, kSmall);
  ASSERT_EQ(image.width, 320);
  ASSERT_EQ(image.height, 200);
  EXPECT_GT(strongPixels(image, 0), 50);  // late bodies are red
  EXPECT_GT(strongPixels(image, 2), 50);  // early ones blue
}

TEST(RenderWalk, GivesTheSamePictureTwice) {
  EXPECT_EQ(renderWalk(makeTestWalk()->view, kSmall).rgb,
            renderWalk(makeTestWalk()->view, kSmall).rgb);
}

TEST(RenderWalk, ThreadsChangeNoByte) {
  RenderSettings two = kSmall;
  two.threads = 2;
  EXPECT_EQ(renderWalk(makeTestWalk()->view, kSmall).rgb,
            renderWalk(makeTestWalk()->view, two).rgb);
}

TEST(RenderWalk, TheBestCornerIsOneOfFourThatDiffer) {
  const auto walk = makeTestWalk();
  const Image best = renderWalk(walk->view, kSmall);
  std::set<std::vector<uint8_t>> pictures;
  for (int corner = 0; corner < 4; ++corner) {
    RenderSettings settings = kSmall;
    settings.corner = corner;
    pictures.insert(renderWalk(walk->view, settings).rgb);
  }
  EXPECT_EQ(pictures.size(), 4u);
  EXPECT_TRUE(pictures.contains(best.rgb));
}

TEST(RenderWalk, ShowsTheRoomWhereThereIsNoWalk) {
  const Scene room = testRoom();
  WalkView view;
  view.scene = &room;
  const Image image = renderWalk(view, kSmall);
  const auto [low, high] = std::minmax_element(image.rgb.begin(), image.rgb.end());
  EXPECT_GT(*high - *low, 60);
}

TEST(RenderWalk, SeesAWalkBehindAWall) {
  const auto walk = makeTestWalk();
  const int before = strongPixels(renderWalk(walk->view, kSmall), 0);
  walk->scene.objects.push_back(testBox("divider", {4, 0.1, 2.5}, {3, 1.2, 1.25}));
  walk->scene.objects.push_back(testBox("divider-2", {4, 0.1, 2.5}, {3, 2.8, 1.25}));
  EXPECT_GT(strongPixels(renderWalk(walk->view, kSmall), 0), before / 3);
}

TEST(RenderStrip, IsAGridOfTiles) {
  StripSettings settings;
  settings.pictures = 5;
  settings.columns = 3;
  settings.tile_width = 60;
  settings.tile_height = 80;
  const Image strip = renderStrip(makeTestWalk()->view, settings);
  EXPECT_EQ(strip.width, 180);
  EXPECT_EQ(strip.height, 160);
}

int redPixels(const Image& image) {
  int count = 0;
  for (size_t i = 0; i < image.rgb.size(); i += 3)
    count += image.rgb[i] > 150 && image.rgb[i + 1] < 60 && image.rgb[i + 2] < 75;
  return count;
}

TEST(RenderStrip, DrawsWhatSinksBelowTheFloorRed) {
  const auto walk = makeTestWalk();
  StripSettings settings;
  settings.pictures = 1;
  settings.tile_width = 120;
  settings.tile_height = 160;
  EXPECT_EQ(redPixels(renderStrip(walk->view, settings)), 0);
  walk->animation.poses.p_WR(0).z() -= 0.05;
  EXPECT_GT(redPixels(renderStrip(walk->view, settings)), 5);
}

// On a stair the path's ground is between the treads that the feet stand on.
TEST(RenderStrip, AFootOnATreadBelowThePathIsNotBelowTheFloor) {
  const auto walk = makeTestWalk();
  for (FrameState& state : walk->animation.states) state.position.z() += 0.1;
  const StripSettings settings{.pictures = 4, .columns = 4, .tile_width = 120, .tile_height = 160};
  EXPECT_EQ(redPixels(renderStrip(walk->view, settings)), 0);
}

TEST(RenderStrip, OfNothingIsOneTile) {
  const Scene room = testRoom();
  WalkView view;
  view.scene = &room;
  EXPECT_EQ(renderStrip(view).width, StripSettings{}.tile_width);
}

TEST(WalkView, ShoesAreMirrorImagesWithTheBigToeInside) {
  const auto left = shoeOutline(kLeft, 0.27), right = shoeOutline(kRight, 0.27);
  ASSERT_EQ(left.size(), right.size());
  for (const auto& outline : {left, right}) {
    double area = 0;
    for (size_t i = 0; i < outline.size(); ++i) {
      const auto &a = outline[i], &b = outline[(i + 1) % outline.size()];
      area += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    EXPECT_GT(area, 0.012);  // counter-clockwise, and a sole's size
    EXPECT_LT(area, 0.03);
  }
  for (size_t i = 0; i < left.size(); ++i) {
    EXPECT_DOUBLE_EQ(left[i].x(), right[left.size() - 1 - i].x());
    EXPECT_DOUBLE_EQ(left[i].y(), -right[left.size() - 1 - i].y());
  }
  const auto tip = *std::max_element(right.begin(), right.end(),
                                     [](const auto& a, const auto& b) { return a.x() < b.x(); });
  EXPECT_GT(tip.y(), 0);  // of the right foot: to the left of its middle
}

TEST(WalkView, SoleLengthIsThatOfTheBody) {
  EXPECT_NEAR(soleLength(makeTestWalk()->view), 0.18 + 2 * 0.04, 1e-9);
  EXPECT_NEAR(soleLength(WalkView{}), 0.27, 1e-9);
}

TEST(Colors, AreWhatTheNamesSay) {
  EXPECT_EQ(hexColor(rgb(255, 0, 16)), "#ff0010");
  EXPECT_TRUE(namedColor("flat", "IKEA_sofa").has_value());
  EXPECT_FALSE(namedColor("zzz", "").has_value());
  EXPECT_EQ(otherColor("zzz"), otherColor("zzz"));
}

TEST(RenderWalk, MoreBodiesCoverMoreOfThePicture) {
  const auto walk = makeTestWalk();
  RenderSettings often = kSmall, seldom = kSmall;
  often.every = 0.25;
  seldom.every = 4.0;
  const Image many = renderWalk(walk->view, often), few = renderWalk(walk->view, seldom);
  EXPECT_GT(strongPixels(many, 2) + strongPixels(many, 0),
            strongPixels(few, 2) + strongPixels(few, 0));
}

// How often a body is drawn: the same walk at a quarter of its speed has four times the frames.
TEST(RenderWalk, WhoWalksSlowlyIsDrawnAsOftenAsWhoWalksFast) {
  const auto fast = makeTestWalk(), slow = makeTestWalk();
  slow->animation.poses.resize(481);
  slow->animation.states.resize(481);
  for (int i = 0; i <= 480; ++i) slow->animation.poses.p_WR(i) = {1 + 4.0 * i / 480, 2, 0.9};
  const std::vector<int> frames = bodyFrames(fast->view, {}), slowly = bodyFrames(slow->view, {});
  ASSERT_EQ(frames.size(), 9u);  // 4 m, a body every half metre
  ASSERT_EQ(slowly.size(), frames.size());
  for (size_t i = 0; i < frames.size(); ++i) EXPECT_NEAR(slowly[i], 4 * frames[i], 4);
}

TEST(RenderWalk, BodiesStandApartInTimeAndPlaceFromTheFirstFrameToTheLast) {
  const auto walk = makeTestWalk();
  for (int i = 0; i <= 120; ++i)  // comes to a stand
    walk->animation.poses.p_WR(i).x() = 1 + 4.0 * std::sin(i / 120.0 * std::acos(0.0));
  for (const double apart : {0.0, 0.3, 0.5, 1.1}) {
    for (const double every : {0.05, 0.5, 0.9}) {
      const std::vector<int> frames = bodyFrames(walk->view, {.every = every, .apart = apart});
      EXPECT_EQ(frames.front(), 0);
      EXPECT_EQ(frames.back(), 120);
      for (size_t k = 1; k < frames.size(); ++k) {
        const bool last = k + 1 == frames.size();
        EXPECT_GE(frames[k] - frames[k - 1], (last ? 15 : 30) * every - 1);
        EXPECT_GE(walk->animation.poses.p_WR(frames[k]).x() -
                      walk->animation.poses.p_WR(frames[k - 1]).x(),
                  apart);
      }
    }
  }
}

TEST(RenderWalk, WhoOnlyStandsIsDrawnOnce) {
  const auto walk = makeTestWalk();
  for (int i = 0; i <= 120; ++i) walk->animation.poses.p_WR(i) = {1, 2, 0.9};
  EXPECT_EQ(bodyFrames(walk->view, {}).size(), 1u);
  EXPECT_TRUE(bodyFrames(WalkView{}, {}).empty());
}

// Where each view has its eye, from the middle of the room of 6 x 4 m.
TEST(RenderWalk, PointsOfViewAreWhereTheyAreSaidToBe) {
  const auto walk = makeTestWalk();  // along +x
  const auto cameraOf = [&](PointOfView from) {
    RenderSettings settings = kSmall;
    settings.from = from;
    return takeShot(walk->view, settings.shot(bodyFrames(walk->view, settings))).camera;
  };
  const Camera top = cameraOf(PointOfView::kTop), side = cameraOf(PointOfView::kSide),
               corner = cameraOf(PointOfView::kCorner), first = cameraOf(PointOfView::kFirst);
  EXPECT_TRUE(top.parallel);
  EXPECT_EQ(top.axes.row(2), Eigen::RowVector3f(0, 0, -1));
  EXPECT_LT(std::abs(side.axes(2, 0)), 1e-5f);  // across the way
  EXPECT_LT(std::abs(side.axes(2, 2)), std::abs(corner.axes(2, 2)));
  EXPECT_GT(std::abs(corner.axes(2, 0)), 0.1f);
  EXPECT_GT(std::abs(corner.axes(2, 1)), 0.1f);
  EXPECT_NEAR(first.eye.x(), 3.0f, 0.05f);  // half of the way
  EXPECT_NEAR(first.eye.y(), 2.0f, 1e-5f);
  EXPECT_GT(first.axes(2, 0), 0.9f);  // the way that is walked
}

TEST(RenderWalk, EveryPointOfViewShowsTheWalkInTheSameBytes) {
  const auto walk = makeTestWalk();
  for (const PointOfView from : {PointOfView::kTop, PointOfView::kSide, PointOfView::kFirst}) {
    RenderSettings settings = kSmall, two = kSmall;
    settings.from = two.from = from;
    two.threads = 2;
    const Image image = renderWalk(walk->view, settings);
    EXPECT_GT(strongPixels(image, 0), 50);
    EXPECT_EQ(image.rgb, renderWalk(walk->view, two).rgb);
  }
}

// The ground gets greener where one gets to, and there only; the pin is red.
TEST(RenderWalk, WithoutAWalkShowsHowFarOneGetsAndWhatStoodInTheWay) {
  const auto walk = makeTestWalk();
  WalkView& view = walk->view;
  view.animation = nullptr;
  view.path = nullptr;
  view.start = view.goal = std::nullopt;
  RenderSettings settings = kSmall;
  settings.from = PointOfView::kTop;
  const Image before = renderWalk(view, settings);
  ReachedRegion reached;
  reached.breadth = 0.1;
  for (int i = 0; i < 30; ++i)
    reached.strips.push_back({{0.55, 0.55 + 0.1 * i, 0}, {2.45, 0.55 + 0.1 * i, 0}});
  reached.near = {2.5, 2, 0};
  reached.far = {3.5, 2, 0};
  Obstruction why;
  why.at = {3, 2, 0.9};
  view.reached = &reached;
  view.obstruction = &why;
  const Image after = renderWalk(view, settings);
  const auto redness = [](const Image& image, size_t i) { return image.rgb[i] - image.rgb[i + 1]; };
  int greener = 0, redder = 0;
  for (size_t i = 0; i < before.rgb.size(); i += 3) {
    greener += redness(after, i) < redness(before, i) - 8;
    redder += redness(after, i) > redness(before, i) + 60;
  }
  const Camera camera = takeShot(view, settings.shot({})).camera;
  const double metre = static_cast<double>(camera.scale);        // [pixels]
  EXPECT_NEAR(greener, 6 * metre * metre, 0.3 * metre * metre);  // 2 x 3 m
  EXPECT_GT(redder, 20);
  EXPECT_LT(redder, 0.2 * metre * metre);
}

TEST(RenderWalk, AThingThatIsAddedChangesThePictureWhereItIsOnly) {
  const auto walk = makeTestWalk();
  const Image before = renderWalk(walk->view, kSmall);
  walk->scene.objects.push_back(testBox("crate", {0.3, 0.3, 0.3}, {0.4, 3.6, 0.15}));
  const Image after = renderWalk(walk->view, kSmall);
  long changed = 0;
  for (size_t i = 0; i < before.rgb.size(); ++i) changed += before.rgb[i] != after.rgb[i];
  EXPECT_GT(changed, 20);
  EXPECT_LT(changed, static_cast<long>(before.rgb.size() / 10));
}

TEST(RenderWalk, WhereTheWorldIsDoesNotMatter) {
  const auto here = makeTestWalk(), there = makeTestWalk();
  const Eigen::Vector3d by(32, -16, 0);
  for (SceneObject& object : there->scene.objects) object.X_WO.translation() += by;
  for (Footprint& print : there->animation.footprints) print.position += by;
  for (int i = 0; i < there->animation.size(); ++i) {
    there->animation.poses.p_WR(i) += by;
    there->animation.states[i].position += by;
  }
  there->path = RootPath({makeBezier({33, -14}, 0, {37, -14}, 0)});
  there->view.start->position += by.head<2>();
  there->view.goal->position += by.head<2>();
  const Image a = renderWalk(here->view, kSmall), b = renderWalk(there->view, kSmall);
  long differ = 0;  // planks lie by World's metres: the floor's grain is another
  for (size_t i = 0; i < a.rgb.size(); ++i) differ += std::abs(a.rgb[i] - b.rgb[i]) > 40;
  EXPECT_LT(differ, static_cast<long>(a.rgb.size() / 100));
}

TEST(RenderWalk, AnyAskedSizeIsDrawn) {
  const auto walk = makeTestWalk();
  for (const auto& [width, height] : {std::pair{16, 16}, std::pair{33, 90}, std::pair{200, 40}}) {
    const Image image = renderWalk(walk->view, {.width = width, .height = height, .every = 1.0});
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    EXPECT_EQ(image.rgb.size(), static_cast<size_t>(3 * width * height));
  }
}

// The bar in the lower left corner is the key to the bodies' colours.
TEST(RenderWalk, TheTimeBarRunsThroughTheColoursOfTime) {
  const Image image = renderWalk(makeTestWalk()->view, {.width = 640, .height = 400, .every = 1.0});
  const auto near = [&](int x, const Color& color) {
    const uint8_t* p = image.pixel(x, 400 - 26 - 7);
    return (rgb(p[0], p[1], p[2]) - color).cwiseAbs().maxCoeff() < 0.02f;
  };
  int first = 0;
  while (first < 640 && !near(first, timeColor(0.0))) ++first;
  ASSERT_LT(first, 200);
  for (int i = 4; i < 256; i += 4) EXPECT_TRUE(near(first + i, timeColor(i / 260.0))) << i;
}

}  // namespace
}  // namespace amble
