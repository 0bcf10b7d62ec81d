#include "viz/page/library_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/action.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"

namespace amble {
namespace {

using nlohmann::json;

class LibraryBench : public testing::Test {
 protected:
  LibraryBench() : library_(openMotionLibrary("default")), bench_(benchOfLibrary(library_, "")) {}

  json said() const { return json::parse(benchLibraryJson(bench_, plainNumbers())); }

  const MotionLibrary library_;
  const BenchLibrary bench_;
};

TEST_F(LibraryBench, HoldsEveryMotionWithItsCreditThosePlayedFirst) {
  const json motions = said()["motions"];
  ASSERT_EQ(motions.size(), library_.motions.size());
  for (size_t i = 0; i < motions.size(); ++i) {
    const Motion* const motion = library_.find(motions[i]["name"]);
    ASSERT_NE(motion, nullptr);
    EXPECT_EQ(motions[i]["source"]["credit"], motion->source.credit);
    EXPECT_EQ(motions[i]["source"]["clip"], motion->source.clip);
    EXPECT_EQ(i < bench_.clips.size(),
              !motions[i].contains("transition") && !motions[i].contains("turn"));
    if (i >= bench_.clips.size()) continue;
    EXPECT_EQ(bench_.clips[i].name, motion->name);
  }
}

TEST_F(LibraryBench, SaysThatACaptureIsNotThere) {
  for (const json& motion : said()["motions"]) {
    if (!motion.contains("cycle")) continue;
    EXPECT_NE(motion["lacking"].get<std::string>().find(motion["source"]["clip"]),
              std::string::npos);
    EXPECT_TRUE(motion["cycle"]["root"]["height"]["captured"].empty());
  }
}

// Pettré's eq. 2, term by term.
TEST_F(LibraryBench, CurvesAreTheSeriesOfTheLibrary) {
  for (const json& motion : said()["motions"]) {
    if (!motion.contains("cycle")) continue;
    const FourierSeries& series = library_.find(motion["name"])->cycle.series;
    const json& height = motion["cycle"]["root"]["height"]["fourier"];
    const json& hip = motion["cycle"]["joints"][1]["z"]["fourier"];
    const int points = motion["cycle"]["points"];
    ASSERT_EQ(height.size(), static_cast<size_t>(points));
    for (int i = 0; i < points; ++i) {
      const Eigen::VectorXd value = fourierAt(series, static_cast<double>(i) / (points - 1));
      EXPECT_NEAR(height[i].get<double>(), value[2], 1e-5);
      EXPECT_NEAR(hip[i].get<double>(), value[3 + 3 + 2] / kDegree, 1e-3);
    }
  }
}

// After a cycle a walker is as he was, as far on as his speed says and turned as his rate.
TEST_F(LibraryBench, PlayedWalksGoAsFastAndTurnAsMuchAsTheySay) {
  for (size_t i = 0; i < bench_.clips.size(); ++i) {
    const Motion& motion = *bench_.motions[i].motion;
    if (motion.kind != MotionKind::kWalk) continue;
    const Clip& clip = bench_.clips[i].motion.clip;
    const int last = clip.frames() - 1, middle = last / 2;
    const double turn = motion.cycle.turn_rate * clip.frame_time * last;
    const Eigen::Quaterniond turned = aboutZ(turn) * clip.poses.rotations(0)[0];
    EXPECT_NEAR(turned.angularDistance(clip.poses.rotations(last)[0]), 0.0, 1e-6) << motion.name;
    for (int joint = 1; joint < clip.skeleton.size(); ++joint) {
      EXPECT_NEAR(clip.poses.rotations(0)[joint].angularDistance(clip.poses.rotations(last)[joint]),
                  0.0, 1e-6);
    }
    if (motion.turning || last % 2 != 0) continue;
    const double way = (clip.poses.p_WR(last) - clip.poses.p_WR(middle)).norm();
    EXPECT_NEAR(way, motion.cycle.speed * motion.cycle.period, 1e-6) << motion.name;
  }
}

// As `animate --action` has it: legs and trunk are the walk's, arms the movement's.
TEST_F(LibraryBench, AMovementIsPlayedOverAWalkAndMovesItsOwnJointsOnly) {
  const auto played = [&](const Motion& motion) -> const Clip& {
    for (size_t i = 0;; ++i)
      if (bench_.motions[i].motion == &motion) return bench_.clips[i].motion.clip;
  };
  const Motion& carry = *library_.find("carry");
  const std::vector<int> moved = movedJoints(library_, carry);
  int walks = 0;
  for (const Motion& motion : library_.motions) {
    if (motion.kind != MotionKind::kWalk) continue;
    const Clip &walk = played(motion), &clip = played(carry);
    if (walk.frames() != clip.frames() || walk.frame_time != clip.frame_time) continue;
    if (walk.poses.p_WR(0) != clip.poses.p_WR(0)) continue;  // its mirror image
    ++walks;
    for (int frame = 0; frame < clip.frames(); ++frame) {
      EXPECT_EQ(clip.poses.p_WR(frame), walk.poses.p_WR(frame));
      for (int joint = 0; joint < clip.skeleton.size(); ++joint) {
        if (std::find(moved.begin(), moved.end(), joint) != moved.end()) continue;
        EXPECT_EQ(clip.poses.rotations(frame)[joint].coeffs(),
                  walk.poses.rotations(frame)[joint].coeffs());
      }
    }
    double most = 0.0;
    for (const int joint : moved)
      most = std::max(
          most, clip.poses.rotations(0)[joint].angularDistance(walk.poses.rotations(0)[joint]));
    EXPECT_GT(most, 20 * kDegree) << "arms that carry do not hang";
  }
  EXPECT_EQ(walks, 1);
}

TEST_F(LibraryBench, StartsAndStopsAreTheirFramesOfTheCapture) {
  const std::filesystem::path captures = sharedFolder() / "mocap";
  const BenchLibrary bench = benchOfLibrary(library_, captures);
  ASSERT_EQ(bench.clips.size(), library_.motions.size());
  int seen = 0;
  for (size_t i = 0; i < bench.clips.size(); ++i) {
    const Motion& motion = *bench.motions[i].motion;
    if (motion.kind != MotionKind::kStart && motion.kind != MotionKind::kStop) continue;
    ++seen;
    const Clip& clip = bench.clips[i].motion.clip;
    const Clip whole = readMotion(captures / motion.source.clip, {}).clip;
    const auto [first, last] = motion.source.frames;
    ASSERT_EQ(clip.frames(), last - first + 1);
    const Eigen::Vector3d way = clip.poses.p_WR(last - first) - clip.poses.p_WR(0);
    const Eigen::Vector3d captured = whole.poses.p_WR(last) - whole.poses.p_WR(first);
    EXPECT_NEAR(way.norm(), captured.norm(), 1e-9) << motion.name;
  }
  EXPECT_GE(seen, 2);
}

TEST_F(LibraryBench, TheLawOfStepsIsNearTheWalksThatItIsFittedTo) {
  const json law = said()["step_law"];
  ASSERT_GE(law["points"].size(), 4u);
  for (const json& point : law["points"]) {
    const Motion* const walk = library_.find(point["name"]);
    EXPECT_DOUBLE_EQ(point["speed"], walk->cycle.speed);
    EXPECT_FALSE(walk->turning);
    size_t nearest = 0;
    const auto away = [&](size_t i) {
      return std::abs(law["speeds"][i].get<double>() - walk->cycle.speed);
    };
    for (size_t i = 1; i < law["speeds"].size(); ++i)
      if (away(i) < away(nearest)) nearest = i;
    EXPECT_NEAR(law["steps"][nearest].get<double>(), point["step"].get<double>(), 0.06)
        << walk->name;
  }
}

}  // namespace
}  // namespace amble
