// Cluster graphs: frames agglomerated, all of one support state, which is the most that as many
// frames can take; beside it the thesis' own way (§4.2.3), which keeps the distances of all pairs.
// Then what is asked of a graph: the cut at an error. Given motions drawn from formulas that come
// back to where they were, as captures do; 20,192 frames are the thesis' own.

#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>

#include "animation/graph/cluster_graph.h"
#include "base/parallel.h"

namespace {

using amble::ClusterGraph;
using amble::FrameFeatures;

// Each row a sum of a few waves: of a cycle of 37 frames, whose size and speed change from clip to
// clip of 300 frames.
FrameFeatures drawn(int frames) {
  FrameFeatures features = FrameFeatures::Zero(amble::kFeatureRows, frames);
  constexpr int kClip = 300, kRows = 54;
  for (int i = 0; i < frames; ++i) {
    const double clip = i / kClip;
    const double phase = 2.0 * M_PI * i / 37.0 * (1.0 + 0.1 * std::sin(1.7 * clip));
    for (int row = 0; row < kRows; ++row) {
      const double size = 0.1 * (1.0 + 0.3 * std::sin(0.9 * clip + row));
      const double noise = 0.004 * std::sin(12.9898 * i + 78.233 * row);
      features(row, i) = static_cast<float>(size * std::sin(phase + row) + noise);
    }
  }
  return features;
}

void agglomerateFrames(benchmark::State& state) {
  const FrameFeatures features = drawn(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(amble::agglomerate(features, static_cast<int>(state.range(1))));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(agglomerateFrames)
    ->Args({2000, 1})
    ->Args({5000, 1})
    ->Args({20192, 1})
    ->Args({20192, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// The peer: every distance there is, and the least of them looked for before each merge.
void allPairs(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0));
  const FrameFeatures features = drawn(count);
  for (auto _ : state) {
    FrameFeatures means = features;
    Eigen::MatrixXf errors(count, count);
    std::vector<int> there, frames(count, 1);
    for (int i = 0; i < count; ++i) {
      there.push_back(i);
      for (int j = 0; j < count; ++j) errors(i, j) = amble::frameError(means, i, j);
    }
    while (there.size() > 1) {
      float least = std::numeric_limits<float>::infinity();
      int a = 0, b = 0;
      for (size_t i = 0; i < there.size(); ++i)
        for (size_t j = i + 1; j < there.size(); ++j)
          if (errors(there[j], there[i]) < least)
            least = errors(there[j], there[i]), a = there[i], b = there[j];
      amble::meanOf(means.col(a).data(), frames[a], means.col(b).data(), frames[b],
                    means.col(b).data());
      frames[b] += frames[a];
      there.erase(std::find(there.begin(), there.end(), a));
      for (const int i : there) errors(i, b) = errors(b, i) = amble::frameError(means, i, b);
    }
    benchmark::DoNotOptimize(means);
  }
  state.SetItemsProcessed(state.iterations() * count);
}
BENCHMARK(allPairs)->Arg(2000)->Unit(benchmark::kMillisecond);

void cutOfAGraph(benchmark::State& state) {
  ClusterGraph graph;
  graph.features = drawn(5000);
  graph.states.assign(5000, amble::SupportState::kL);
  graph.clips = {{"drawn", 0, 5000, 0, 1.0}};
  amble::growTrees(graph, amble::usualThreads());
  for (auto _ : state) benchmark::DoNotOptimize(amble::cutAt(graph, amble::kGraphError));
}
BENCHMARK(cutOfAGraph)->Unit(benchmark::kMillisecond);

}  // namespace
