#include "animation/graph/agglomeration.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "tests/animation/graph/graph_captures.h"

namespace amble {
namespace {

/// The thesis' steps: the distances of all pairs; the pair that is least becomes one, those of
/// either are removed, those of the new one inserted.
std::vector<Merge> plainAgglomeration(FrameFeatures means) {
  const int count = static_cast<int>(means.cols());
  std::vector<int> there(count), node(count), frames(count, 1);
  Eigen::MatrixXf errors(count, count);
  for (int i = 0; i < count; ++i) {
    there[i] = node[i] = i;
    for (int j = 0; j < count; ++j) errors(i, j) = frameError(means, i, j);
  }
  std::vector<Merge> merges;
  while (there.size() > 1) {
    int a = -1, b = -1;
    float least = std::numeric_limits<float>::infinity();
    for (size_t i = 0; i < there.size(); ++i) {
      for (size_t j = i + 1; j < there.size(); ++j) {
        const float e = errors(there[j], there[i]);
        if (e < least) least = e, a = there[i], b = there[j];
      }
    }
    merges.push_back({node[a], node[b], least});
    Eigen::VectorXf mean(kFeatureRows);
    meanOf(means.col(a).data(), frames[a], means.col(b).data(), frames[b], mean.data());
    means.col(b) = mean;
    frames[b] += frames[a];
    node[b] = count + static_cast<int>(merges.size()) - 1;
    there.erase(std::find(there.begin(), there.end(), a));
    for (const int i : there) errors(i, b) = errors(b, i) = frameError(means, i, b);
  }
  return merges;
}

void expectSame(const std::vector<Merge>& a, const std::vector<Merge>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].a, b[k].a) << k;
    ASSERT_EQ(a[k].b, b[k].b) << k;
    ASSERT_EQ(a[k].error, b[k].error) << k;
  }
}

FrameFeatures onALine(const std::vector<float>& places) {
  FrameFeatures features = FrameFeatures::Zero(kFeatureRows, static_cast<int>(places.size()));
  for (size_t i = 0; i < places.size(); ++i) features(0, static_cast<int>(i)) = places[i];
  return features;
}

TEST(Agglomeration, OfNoneAndOfOneFrameIsNone) {
  EXPECT_TRUE(agglomerate(onALine({}), 1).empty());
  EXPECT_TRUE(agglomerate(onALine({3.0f}), 1).empty());
}

TEST(Agglomeration, MostAlikeFramesComeFirstAndStandForTheirMean) {
  const auto merges = agglomerate(onALine({0.0f, 10.0f, 1.0f, 13.0f}), 1);
  ASSERT_EQ(merges.size(), 3u);
  expectSame(merges, {{0, 2, 1.0f}, {1, 3, 9.0f}, {4, 5, 121.0f}});
}

TEST(Agglomeration, AMergeMayCostLessThanTheOneBefore) {
  // Three corners of a triangle, the third a little farther away than the first two from one
  // another: the middle of those is nearer to it than either was.
  FrameFeatures corners = onALine({0.0f, 2.0f, 1.0f});
  corners(1, 2) = 1.9f;
  const auto merges = agglomerate(corners, 1);
  ASSERT_EQ(merges.size(), 2u);
  EXPECT_LT(merges[1].error, merges[0].error);
  expectSame(merges, plainAgglomeration(corners));
}

TEST(Agglomeration, EqualPairsComeInTheOrderOfTheirFrames) {
  const FrameFeatures equal = onALine({0, 1, 2, 3, 4, 5, 6, 7, 7, 7, 0, 0});
  expectSame(agglomerate(equal, 1), plainAgglomeration(equal));
}

TEST(Agglomeration, IsThePlainAlgorithmsToTheBitOnTwoThousandFramesOfCaptures) {
  AMBLE_NEEDS_CAPTURES();
  const ClusterGraph& graph = someGraph();
  std::array<FrameFeatures, kSupportStates> features;
  int taken = 0;
  for (int state = 0; state < kSupportStates; ++state) {
    std::vector<int> frames;
    for (int i = 0; i < graph.frames(); ++i)
      if (static_cast<int>(graph.states[i]) == state && frames.size() < 900) frames.push_back(i);
    taken += static_cast<int>(frames.size());
    FrameFeatures own(kFeatureRows, static_cast<int>(frames.size()));
    for (size_t i = 0; i < frames.size(); ++i)
      own.col(static_cast<int>(i)) = graph.features.col(frames[i]);
    expectSame(agglomerate(own, 1 + state % 3), plainAgglomeration(own));
  }
  EXPECT_GE(taken, 2000);
}

TEST(Agglomeration, ThreadsChangeNothing) {
  AMBLE_NEEDS_CAPTURES();
  // As many as are shared out, of all states.
  const FrameFeatures features = someGraph().features.leftCols(2600);
  expectSame(agglomerate(features, 1), agglomerate(features, 3));
}

}  // namespace
}  // namespace amble
