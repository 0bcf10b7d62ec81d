#include "viz/pictures/film.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/viz/test_walk.h"
#include "viz/pictures/draw_mesh.h"

namespace amble {
namespace {

constexpr FilmSettings kSmallFilm{.width = 320, .height = 200, .rate = 10.0, .threads = 1};

// The first row of the time in the corner.
constexpr int kTimeRow = 200 - 26 - 14 - 8;

// All of a picture drawn at once, from the nearer of room and body.
Image drawnAtOnce(const WalkView& view, int frame) {
  RenderSettings settings;
  settings.width = kSmallFilm.width;
  settings.height = kSmallFilm.height;
  WalkShot shot = takeShot(view, settings.shot(bodyFrames(view, settings)));
  shot.light.shadow_size = WalkFilm::kShadowSize;
  const Camera large = shot.camera.enlarged(kSupersampling);
  const int width = kSupersampling * kSmallFilm.width, height = kSupersampling * kSmallFilm.height;
  SampleBuffer samples = rasterize(shot.triangles, large, width, height);
  std::vector<DrawTriangle> body;
  addFigure(view, frame, figureOfTestWalk(), body);
  const SampleBuffer front = rasterize(body, large, width, height);
  for (size_t i = 0; i < samples.depth.size(); ++i) {
    const float near = front.depth[i], far = samples.depth[i];
    if (near == 0 || (far > 0 && near >= far)) continue;
    samples.depth[i] = near;
    samples.look[i] = front.look[i];
  }
  shot.triangles.insert(shot.triangles.end(), body.begin(), body.end());
  return lightSamples(samples, large, shot.triangles, shot.light);
}

TEST(WalkFilm, APictureIsWhatDrawingAllOfItGives) {
  const auto walk = makeTestWalk();
  const WalkFilm film(walk->view, figureOfTestWalk(), kSmallFilm);
  for (const int i : {0, 17, 40}) {
    const Image picture = film.picture(i), whole = drawnAtOnce(walk->view, 3 * i);
    int other = 0;
    for (int y = 0; y < kTimeRow; ++y)
      for (int x = 0; x < 3 * picture.width; ++x)
        other += picture.pixel(0, y)[x] != whole.pixel(0, y)[x];
    EXPECT_LT(other, 20) << "picture " << i << ": more than edges' rounding";
  }
}

TEST(WalkFilm, LastsAsLongAsTheWalk) {
  const auto walk = makeTestWalk();
  EXPECT_EQ(WalkFilm(walk->view, figureOfTestWalk(), kSmallFilm).pictures(), 41);  // 4 s
}

TEST(WalkFilm, ShowsABodyThatMoves) {
  const auto walk = makeTestWalk();
  const WalkFilm film(walk->view, figureOfTestWalk(), kSmallFilm);
  EXPECT_NE(film.picture(3).rgb, film.picture(4).rgb);
}

// What the figure changes of a picture: where it is, and its shadow.
TEST(WalkFilm, WhereTheEyeGoesAlongTheWalkerIsInTheMiddleOfEveryPicture) {
  const auto walk = makeTestWalk();
  FilmSettings along = kSmallFilm;
  along.follow = true;
  Figure nobody = figureOfTestWalk();
  nobody.triangles.clear();
  const WalkFilm film(walk->view, figureOfTestWalk(), along), empty(walk->view, nobody, along);
  for (const int i : {0, 20, 40}) {
    const Image with = film.picture(i), without = empty.picture(i);
    double x_sum = 0.0, y_sum = 0.0;
    int changed = 0;
    for (int y = 0; y < kTimeRow; ++y) {
      for (int x = 0; x < with.width; ++x) {
        if (std::equal(with.pixel(x, y), with.pixel(x, y) + 3, without.pixel(x, y))) continue;
        x_sum += x;
        y_sum += y;
        ++changed;
      }
    }
    ASSERT_GT(changed, 1000) << "a person is large in picture " << i;
    EXPECT_NEAR(x_sum / changed, 160.0, 40.0) << i;
    EXPECT_NEAR(y_sum / changed, 100.0, 40.0) << i;
  }
  EXPECT_EQ(film.pictures(), 41);
}

TEST(WalkFilm, ThreadsChangeNoByte) {
  const auto walk = makeTestWalk();
  FilmSettings two = kSmallFilm;
  two.threads = 2;
  EXPECT_EQ(WalkFilm(walk->view, figureOfTestWalk(), kSmallFilm).picture(20).rgb,
            WalkFilm(walk->view, figureOfTestWalk(), two).picture(20).rgb);
}

}  // namespace
}  // namespace amble
