// BVH read and write, in MB/s: beside Assimp's importer, which reads the same text from memory too,
// and beside a writer that asks snprintf for each number. Peers take turns, five times each, under
// --benchmark_repetitions=5 --benchmark_enable_random_interleaving=true.

#include <benchmark/benchmark.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <sstream>
#include <streambuf>
#include <string>

#include "animation/captures/bvh.h"
#include "base/rotation.h"

namespace {

using amble::Clip;

constexpr int kJoints = 60;    // of a rig with fingers
constexpr int kFrames = 2000;  // half a minute at 60 Hz: 7 MB of text

// A chain that waves: every number has all its digits, as in a capture.
Clip makeClip() {
  std::vector<amble::Joint> joints(kJoints);
  for (int i = 0; i < kJoints; ++i) {
    joints[i].name = "joint" + std::to_string(i);
    joints[i].parent = i - 1;
    if (i > 0) joints[i].offset = {0.0, 0.1 + 0.001 * i, 0.0123456};
  }
  joints.back().end_sites.emplace_back(0.0, 0.1, 0.0);
  Clip clip{"chain", amble::Skeleton(joints), 1.0 / 60.0, amble::PoseArray(kJoints), {}};
  clip.poses.resize(kFrames);
  for (int frame = 0; frame < kFrames; ++frame) {
    clip.poses.p_WR(frame) = {0.02 * frame, std::sin(0.01 * frame), 1.0};
    for (int j = 0; j < kJoints; ++j) {
      const double angle = 0.7 * std::sin(0.05 * frame + j);
      clip.poses.rotations(frame)[j] = amble::expRotation(angle * Eigen::Vector3d(0.6, 0.48, 0.64));
    }
  }
  return clip;
}

const std::string& text() {
  static const std::string written = [] {
    std::ostringstream out;
    amble::writeBvh(out, makeClip());
    return out.str();
  }();
  return written;
}

void readBvh(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(amble::parseBvh(text(), "chain.bvh"));
  state.SetBytesProcessed(state.iterations() * static_cast<int64_t>(text().size()));
}
BENCHMARK(readBvh)->Unit(benchmark::kMillisecond);

// What is written goes nowhere: a file costs both the same.
class Nowhere : public std::streambuf {
  int_type overflow(int_type c) override { return traits_type::not_eof(c); }
  std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
};

void writeBvh(benchmark::State& state) {
  const Clip clip = makeClip();
  for (auto _ : state) {
    Nowhere nowhere;
    std::ostream out(&nowhere);
    amble::writeBvh(out, clip);
    benchmark::DoNotOptimize(out);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<int64_t>(text().size()));
}
BENCHMARK(writeBvh)->Unit(benchmark::kMillisecond);

// The frames of the same clip as a program writes them that takes no care: the Euler angles of each
// joint, whether they jump or not.
void writeBvhWithSnprintf(benchmark::State& state) {
  const Clip clip = makeClip();
  for (auto _ : state) {
    Nowhere nowhere;
    std::ostream out(&nowhere);
    std::string line;
    const auto put = [&](double x, double y, double z) {
      char numbers[128];
      const int length = std::snprintf(numbers, sizeof numbers, "%.6f %.6f %.6f ", x, y, z);
      line.append(numbers, static_cast<size_t>(length));
    };
    for (int frame = 0; frame < clip.frames(); ++frame) {
      line.clear();
      const Eigen::Vector3d& p = clip.poses.p_WR(frame);
      put(p.x(), p.z(), -p.y());
      for (const Eigen::Quaterniond& q : clip.poses.rotations(frame)) {
        const Eigen::Vector3d angles = amble::toEuler(q, {'Z', 'X', 'Y'}) / amble::kDegree;
        put(angles[0], angles[1], angles[2]);
      }
      line.back() = '\n';
      out.write(line.data(), static_cast<std::streamsize>(line.size()));
    }
    benchmark::DoNotOptimize(out);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<int64_t>(text().size()));
}
BENCHMARK(writeBvhWithSnprintf)->Unit(benchmark::kMillisecond);

void readBvhWithAssimp(benchmark::State& state) {
  for (auto _ : state) {
    Assimp::Importer importer;
    benchmark::DoNotOptimize(importer.ReadFileFromMemory(text().data(), text().size(), 0, "bvh"));
  }
  state.SetBytesProcessed(state.iterations() * static_cast<int64_t>(text().size()));
}
BENCHMARK(readBvhWithAssimp)->Unit(benchmark::kMillisecond);

}  // namespace
