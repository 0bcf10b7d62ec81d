#include "planner/roadmap/sampled_roadmap.h"

#include <gtest/gtest.h>

#include "base/sample_stream.h"
#include "planner/roadmap/nearest_roadmap.h"
#include "planner/roadmap/visibility_roadmap.h"
#include "tests/planner/disc_steering.h"
#include "tests/planner/search_limits_of.h"

namespace amble {
namespace {

/// An open map of 200 x 200 m with passages all over it, each between two places a metre apart.
class OpenMap : public DiscSteering {
 public:
  std::vector<StancePair> passages() const override {
    std::vector<StancePair> all;
    for (double x = 5; x < 200; x += 20) {
      for (double y = 5; y < 200; y += 20)
        all.push_back({standing(x, y).stance, standing(x + 1, y).stance});
    }
    return all;
  }
};
const Eigen::AlignedBox2d kMap = box(0, 0, 200, 200);

TEST(SampledRoadmap, StartAndGoalAreAskedBeforeAnyPassage) {
  const OpenMap steering;
  VisibilityRoadmap roadmap({steering, kMap});
  const int from = roadmap.insert(standing(20, 20), true, true),
            to = roadmap.insert(standing(35, 20), true, true);
  EXPECT_TRUE(roadmap.connect(from, to, limitsOf(1)));
  EXPECT_EQ(roadmap.roadmap().size(), 2);
  EXPECT_LE(steering.asked, 2);
}

TEST(SampledRoadmap, OnALargeMapPassagesAreAskedByNearness) {
  OpenMap steering;
  steering.boxes = {box(27, 18, 28, 22)};  // in the way
  VisibilityRoadmap roadmap({steering, kMap});
  const int from = roadmap.insert(standing(20, 20), true, true),
            to = roadmap.insert(standing(35, 20), true, true);
  EXPECT_TRUE(roadmap.connect(from, to, limitsOf(1)));
  for (const RoadmapNode& node : roadmap.roadmap().nodes())
    EXPECT_LT((node.at.stance.position.head<2>() - Eigen::Vector2d(27.5, 20)).norm(), 35.0);
  EXPECT_LT(steering.asked, 200);  // of 100 passages all pairs would be 40,000
}

TEST(SampledRoadmap, FarWaysRoundAreFoundAsTheRegionWidens) {
  OpenMap steering;
  steering.boxes = {box(100, -1, 101, 160)};  // the way leads round its end, 140 m off
  for (const int threads : {1, 3}) {
    VisibilityRoadmap roadmap({steering, kMap});
    const int from = roadmap.insert(standing(95, 20), true, true),
              to = roadmap.insert(standing(106, 20), true, true);
    EXPECT_TRUE(roadmap.connect(from, to, limitsOf(1, 400, threads)));
    EXPECT_TRUE(roadmap.roadmap().shortestPath(from, to).has_value());
  }
}

/// Two rooms, and somebody who knows ways from one to the other, or what shuts them off.
class GuidedRooms : public DiscSteering {
 public:
  std::vector<std::vector<Stance>> ways;
  std::optional<WayGuide::Narrow> narrow;
  std::optional<SteeringFailure> barrier;
  mutable std::vector<Eigen::Vector3d> avoided;

  std::unique_ptr<WayGuide> guide(const Eigen::Vector3d&, const Eigen::Vector3d&,
                                  const Eigen::AlignedBox2d&, const std::function<bool()>&,
                                  int) const override {
    return std::make_unique<Guide>(*this);
  }
  std::optional<SteeringFailure> shutOff(const Eigen::Vector3d&, const Eigen::Vector3d&,
                                         const std::function<bool()>&,
                                         std::span<const SteeringScratchPtr>) const override {
    return barrier;
  }

 private:
  class Guide : public WayGuide {
   public:
    explicit Guide(const GuidedRooms& rooms) : rooms_(rooms) {}
    std::optional<std::vector<Stance>> next() override {
      if (next_ == rooms_.ways.size()) return std::nullopt;
      return rooms_.ways[next_++];
    }
    void avoid(const Eigen::Vector3d& at) override { rooms_.avoided.push_back(at); }
    std::optional<Narrow> narrowest() const override { return rooms_.narrow; }

   private:
    const GuidedRooms& rooms_;
    size_t next_ = 0;
  };
};

struct Ends {
  int from, to;
};
Ends insertEnds(VisibilityRoadmap& roadmap) {
  return {roadmap.insert(standing(1, 1), true, true), roadmap.insert(standing(7, 1), true, true)};
}

TEST(SampledRoadmap, AWayThatTheMapKnowsIsTakenBeforeAnySample) {
  GuidedRooms steering;
  twoRooms(steering, 0.8);  // through the gap about y = 4.5
  steering.ways = {{standing(3, 4.5).stance, standing(5, 4.5).stance}};
  VisibilityRoadmap roadmap({steering, kRoom});
  const Ends ends = insertEnds(roadmap);
  EXPECT_TRUE(roadmap.connect(ends.from, ends.to, limitsOf(1)));
  EXPECT_EQ(roadmap.samples(), 0);
  EXPECT_EQ(roadmap.roadmap().size(), 4);
}

TEST(SampledRoadmap, TheMapIsToldWhereAWayWasRefused) {
  GuidedRooms steering;
  twoRooms(steering, 0.8);
  steering.ways = {{standing(2, 2).stance, standing(6, 2).stance},  // through the wall
                   {standing(4, 1).stance},                         // in it
                   {standing(3, 4.5).stance, standing(5, 4.5).stance}};
  VisibilityRoadmap roadmap({steering, kRoom});
  const Ends ends = insertEnds(roadmap);
  EXPECT_TRUE(roadmap.connect(ends.from, ends.to, limitsOf(1)));
  EXPECT_EQ(roadmap.samples(), 0);
  ASSERT_GE(steering.avoided.size(), 2u);
  EXPECT_EQ(steering.avoided[1], standing(4, 1).stance.position);
}

TEST(SampledRoadmap, WhatIsShutOffIsNotSearched) {
  GuidedRooms steering;
  twoRooms(steering, 0.0);
  steering.barrier = SteeringFailure{WalkRule::kDisconnected, 2, 1};
  VisibilityRoadmap roadmap({steering, kRoom});
  const Ends ends = insertEnds(roadmap);
  EXPECT_FALSE(roadmap.connect(ends.from, ends.to, limitsOf(1)));
  EXPECT_EQ(roadmap.samples(), 0);
  ASSERT_TRUE(roadmap.shutOff().has_value());
  EXPECT_EQ(roadmap.shutOff()->part, 2);
  EXPECT_EQ(roadmap.steering().refusals.at(WalkRule::kDisconnected), 1);
  roadmap.clear();
  EXPECT_FALSE(roadmap.shutOff().has_value());
}

TEST(SampledRoadmap, AboutANarrowPlaceThatMayNotBePassedSamplesAreDrawnAndNowhereElse) {
  GuidedRooms steering;
  steering.boxes = {box(29.95, -1, 30.05, 61)};
  steering.narrow = WayGuide::Narrow{{30, 30, 0}, 0.0, false};
  VisibilityRoadmap roadmap({steering, box(0, 0, 60, 60)});
  const int from = roadmap.insert(standing(5, 30), true, true),
            to = roadmap.insert(standing(55, 30), true, true);
  EXPECT_FALSE(roadmap.connect(from, to, limitsOf(1, 20)));
  EXPECT_LE(roadmap.samples(), 10);  // of 40, since walks straight through it were refused
  for (const RoadmapNode& node : roadmap.roadmap().nodes()) {
    const Eigen::Vector2d p = node.at.stance.position.head<2>();
    if (p == Eigen::Vector2d(5, 30) || p == Eigen::Vector2d(55, 30)) continue;
    EXPECT_LE((p - Eigen::Vector2d(30, 30)).cwiseAbs().maxCoeff(), 2.5) << p.transpose();
  }
}

TEST(SampledRoadmap, WhereAWayMayPassAllIsSearchedAfterTheNarrowPlace) {
  GuidedRooms steering;
  twoRooms(steering, 0.8);
  steering.narrow = WayGuide::Narrow{{1, 5, 0}, 0.5 * kPi, true};  // where nothing leads on
  VisibilityRoadmap roadmap({steering, kRoom});
  const Ends ends = insertEnds(roadmap);
  EXPECT_TRUE(roadmap.connect(ends.from, ends.to, limitsOf(1)));
}

TEST(SampledRoadmap, ANarrowPlaceIsWalkedStraightThroughBeforeAnySample) {
  for (const double off : {0.0, 0.15}) {  // of what the map says
    GuidedRooms steering;
    twoRooms(steering, 0.8);
    steering.narrow = WayGuide::Narrow{{4, 4.5, 0}, off, false};
    VisibilityRoadmap roadmap({steering, kRoom});
    const Ends ends = insertEnds(roadmap);
    EXPECT_TRUE(roadmap.connect(ends.from, ends.to, limitsOf(1)));
    EXPECT_EQ(roadmap.samples(), 0);
  }
}

TEST(SampledRoadmap, ANarrowPlaceBesideWhichNobodyStandsIsSearchedInFull) {
  GuidedRooms steering;
  steering.boxes = {box(28, -1, 32, 61)};
  steering.narrow = WayGuide::Narrow{{30, 30, 0}, 0.0, false};
  VisibilityRoadmap roadmap({steering, box(0, 0, 60, 60)});
  const int from = roadmap.insert(standing(5, 30), true, true),
            to = roadmap.insert(standing(55, 30), true, true);
  EXPECT_FALSE(roadmap.connect(from, to, limitsOf(1, 20)));
  EXPECT_GE(roadmap.samples(), 20);
}

/// The same, where steps may lead up.
class UnevenRooms : public GuidedRooms {
 public:
  int layers() const override { return 1; }
};

// Samples about a place in a thin wall, straight through which all walks are refused.
template <typename Rooms>
long long samplesAboutThinWall(bool blocked) {
  Rooms steering;
  steering.boxes = {box(29.95, -1, 30.05, 61)};
  steering.narrow = WayGuide::Narrow{{30, 30, 0}, 0.0, false, blocked};
  VisibilityRoadmap roadmap({steering, box(0, 0, 60, 60)});
  const int from = roadmap.insert(standing(5, 30), true, true),
            to = roadmap.insert(standing(55, 30), true, true);
  EXPECT_FALSE(roadmap.connect(from, to, limitsOf(1, 20)));
  return roadmap.samples();
}

TEST(SampledRoadmap, WhatLiesRightAcrossIsSearchedLessOnlyWhereNoStepsLeadUp) {
  EXPECT_LE(samplesAboutThinWall<GuidedRooms>(true), 10);  // of 40
  EXPECT_LE(samplesAboutThinWall<GuidedRooms>(false), 10);
  EXPECT_LE(samplesAboutThinWall<UnevenRooms>(false), 10);  // there is one place only
  EXPECT_GE(samplesAboutThinWall<UnevenRooms>(true), 20);
}

/// The same, and passages.
class StairRooms : public GuidedRooms {
 public:
  std::vector<StancePair> lines;
  std::vector<StancePair> passages() const override { return lines; }
};

// Samples about a place in a wall that nobody stands beside, with passages through it at y.
long long samplesAboutWall(double y, bool blocked) {
  StairRooms steering;
  steering.boxes = {box(28, -1, 32, 61)};
  steering.narrow = WayGuide::Narrow{{30, 30, 0}, 0.0, false, blocked, true};
  for (const double off : {0.0, 0.3})
    steering.lines.push_back({standing(26.5, y + off).stance, standing(33.5, y + off).stance});
  VisibilityRoadmap roadmap({steering, box(0, 0, 60, 60)});
  const int from = roadmap.insert(standing(5, 30), true, true),
            to = roadmap.insert(standing(55, 30), true, true);
  EXPECT_FALSE(roadmap.connect(from, to, limitsOf(1, 20)));
  return roadmap.samples();
}

TEST(SampledRoadmap, WherePassagesByABlockedPlaceAreRefusedItIsSearchedLess) {
  EXPECT_LE(samplesAboutWall(30.4, true), 10);  // of 40
  EXPECT_GE(samplesAboutWall(40.0, true), 20);  // those passages are elsewhere
  EXPECT_GE(samplesAboutWall(30.4, false), 20);
}

TEST(SampledRoadmap, ASearchEndsWhereTheWholeMapIsCovered) {
  DiscSteering steering;
  steering.boxes = {box(99, -1, 101, 201)};
  VisibilityRoadmap roadmap({steering, kMap});
  const int from = roadmap.insert(standing(20, 100), true, true),
            to = roadmap.insert(standing(180, 100), true, true);
  EXPECT_FALSE(roadmap.connect(from, to, limitsOf(1, 20)));
  EXPECT_EQ(roadmap.failures(), 20);
}

TEST(SampledRoadmap, EachPairIsSteeredOnceThroughPassagesToo) {
  OpenMap steering;
  steering.boxes = {box(27, 18, 28, 22)};
  steering.counts = true;
  VisibilityRoadmap roadmap({steering, kMap});
  const int from = roadmap.insert(standing(20, 20), true, true),
            to = roadmap.insert(standing(35, 20), true, true);
  ASSERT_TRUE(roadmap.connect(from, to, limitsOf(1)));
  for (const auto& [pair, times] : steering.pairs) EXPECT_EQ(times, 1);
  EXPECT_EQ(roadmap.steering().asked, steering.asked);
}

void expectSame(const SampledRoadmap& a, const SampledRoadmap& b) {
  ASSERT_EQ(a.roadmap().size(), b.roadmap().size());
  for (int i = 0; i < a.roadmap().size(); ++i) {
    const RoadmapNode &one = a.roadmap().nodes()[i], &other = b.roadmap().nodes()[i];
    EXPECT_EQ(one.at.stance.position, other.at.stance.position);
    EXPECT_EQ(one.kind, other.kind);
  }
  const auto &edges = a.roadmap().edges(), &others = b.roadmap().edges();
  ASSERT_EQ(edges.size(), others.size());
  for (size_t i = 0; i < edges.size(); ++i)
    EXPECT_EQ(std::pair(edges[i].from, edges[i].to), std::pair(others[i].from, others[i].to));
  ASSERT_EQ(a.refused().size(), b.refused().size());
  for (size_t i = 0; i < a.refused().size(); ++i) {
    const RefusedLink &one = a.refused()[i], &other = b.refused()[i];
    EXPECT_EQ(std::pair(one.from_node, one.to_node), std::pair(other.from_node, other.to_node));
    EXPECT_EQ(one.from.stance.position, other.from.stance.position);
    EXPECT_EQ(one.failure.object, other.failure.object);
  }
  EXPECT_EQ(a.steering().asked, b.steering().asked);
  EXPECT_EQ(a.steering().refusals, b.steering().refusals);
  EXPECT_EQ(a.samples(), b.samples());
}

/// Rooms full of boxes and one-way doors, with ways, passages and a narrow place anywhere.
struct DrawnRooms : GuidedRooms {
  explicit DrawnRooms(std::uint64_t seed) {
    twoRooms(*this, 0.6);
    SampleStream random(seed, 0);
    const auto place = [&] { return Eigen::Vector2d(random.uniform(0, 8), random.uniform(0, 6)); };
    for (int i = 0; i < 6; ++i) {
      const Eigen::Vector2d low = place();
      boxes.push_back({low, low + Eigen::Vector2d(random.uniform(0, 1), random.uniform(0, 1))});
    }
    doors = {{place(), place()}, {place(), place()}};
    for (int i = 0; i < 4; ++i) {
      ways.emplace_back();
      for (int k = 0; k < 3; ++k) ways.back().push_back({.position = inSpace(place())});
    }
    for (int i = 0; i < 4; ++i)
      pairs_of_passages.push_back({{.position = inSpace(place())}, {.position = inSpace(place())}});
    narrow = {inSpace({4, 4.5}), random.uniform(-0.3, 0.3), seed % 2 == 0};
  }
  static Eigen::Vector3d inSpace(const Eigen::Vector2d& p) { return {p.x(), p.y(), 0.0}; }
  std::vector<StancePair> passages() const override { return pairs_of_passages; }

  std::vector<StancePair> pairs_of_passages;
};

TEST(SampledRoadmap, WithWaysPassagesAndNarrowPlacesItIsTheSameAtAnyNumberOfThreads) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    DrawnRooms one(seed);
    VisibilityRoadmap of_one({one, kRoom});
    for (const int threads : {1, 2, 5}) {
      DrawnRooms steering(seed);
      VisibilityRoadmap roadmap({steering, kRoom});
      VisibilityRoadmap& made = threads == 1 ? of_one : roadmap;
      const int from = made.insert(standing(1, 1), true, seed % 3 != 0, threads),
                to = made.insert(standing(7, 1), true, true, threads);
      made.connect(from, to, limitsOf(seed, 40, threads));
      expectSame(of_one, made);
    }
  }
}

// Other threads begin no edge ahead that one thread would not ask for.
TEST(SampledRoadmap, AWayOverTheMapCostsNoEdgeMoreOnSeveralThreads) {
  for (const int threads : {1, 2, 5}) {
    GuidedRooms steering;
    twoRooms(steering, 0.8);
    steering.ways = {{standing(2, 2).stance, standing(6, 2).stance},
                     {standing(3, 4.5).stance, standing(5, 4.5).stance}};
    VisibilityRoadmap roadmap({steering, kRoom});
    const int from = roadmap.insert(standing(1, 1), true, true, threads),
              to = roadmap.insert(standing(7, 1), true, true, threads);
    EXPECT_TRUE(roadmap.connect(from, to, limitsOf(1, 60, threads)));
    EXPECT_EQ(steering.asked, roadmap.steering().asked);
  }
}

TEST(SampledRoadmap, ThreadsChangeNothing) {
  DiscSteering steering;
  twoRooms(steering, 0.8);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    NearestRoadmap one({steering, kRoom}), three({steering, kRoom});
    for (auto [roadmap, threads] : {std::pair{&one, 1}, std::pair{&three, 3}}) {
      const int from = roadmap->insert(standing(1, 1), true, true),
                to = roadmap->insert(standing(7, 1), true, true);
      roadmap->connect(from, to, limitsOf(seed, 60, threads));
    }
    expectSame(one, three);
  }
}

TEST(SampledRoadmap, ClearedItIsAsNew) {
  DiscSteering steering;
  twoRooms(steering, 0.8);
  VisibilityRoadmap roadmap({steering, kRoom});
  std::vector<long long> samples;
  for (int run = 0; run < 2; ++run) {
    const int from = roadmap.insert(standing(1, 1), true, true),
              to = roadmap.insert(standing(7, 1), true, true);
    EXPECT_TRUE(roadmap.connect(from, to, limitsOf(5)));
    samples.push_back(roadmap.samples());
    roadmap.clear();
    EXPECT_EQ(roadmap.roadmap().size(), 0);
    EXPECT_EQ(roadmap.steering().asked, 0);
  }
  EXPECT_EQ(samples[0], samples[1]);
}

TEST(SampledRoadmap, ProgressIsToldOfEverySample) {
  DiscSteering steering;
  twoRooms(steering, 0.3);
  VisibilityRoadmap roadmap({steering, kRoom});
  const int from = roadmap.insert(standing(1, 1), true, true),
            to = roadmap.insert(standing(7, 1), true, true);
  SearchLimits limits = limitsOf(1, 30);
  long long calls = 0, last = 0;
  limits.progress = [&](const SearchProgress& at) {
    ++calls;
    last = at.done;
    EXPECT_LE(at.done, at.total);
  };
  EXPECT_FALSE(roadmap.connect(from, to, limits));
  EXPECT_EQ(calls, roadmap.samples());
  EXPECT_EQ(last, 30);
}

}  // namespace
}  // namespace amble
