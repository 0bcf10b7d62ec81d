#include "planner/steering/ground_chords.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/rotation.h"
#include "environments/ground/ground_cells.h"

namespace amble {
namespace {

constexpr int kChordDirections = 8;     // of half a turn
constexpr int kMostOfChord = 40;        // squares of one
constexpr double kHardlyFarther = 0.2;  // than the nearest squares, of others beside them [squares]

}  // namespace

GroundChords::GroundChords(const SceneGround& ground, const ReachedGround& reached, double longest)
    : cells_(ground.cells()), longest_(longest), level_(ground.heights()) {
  if (!ground.isLevel()) heights_ = reached.heights();
}

Eigen::AlignedBox1d GroundChords::at(const Eigen::Vector2i& square) const {
  if (square.x() < 0 || square.y() < 0 || square.x() >= cells_.columns() ||
      square.y() >= cells_.rows())
    return {};
  return heights_[static_cast<size_t>(square.y()) * cells_.columns() + square.x()];
}

Eigen::AlignedBox1d GroundChords::through(const Eigen::Vector2d& p) const {
  if (heights_.empty()) return level_;
  const Eigen::Vector2i here = cells_.squareAt(p);
  Eigen::AlignedBox1d all = linesAt(here);
  if (!all.isEmpty()) return all;
  double nearest = kFarthest;
  for (int j = -kFarthest; j <= kFarthest; ++j) {
    for (int i = -kFarthest; i <= kFarthest; ++i) {
      if (std::hypot(i, j) < nearest && !at(here + Eigen::Vector2i(i, j)).isEmpty())
        nearest = std::hypot(i, j);
    }
  }
  for (int j = -kFarthest; j <= kFarthest; ++j) {
    for (int i = -kFarthest; i <= kFarthest; ++i) {
      const Eigen::Vector2i there = here + Eigen::Vector2i(i, j);
      if (std::hypot(i, j) <= nearest + kHardlyFarther && !at(there).isEmpty())
        all.extend(linesAt(there));
    }
  }
  return all;
}

Eigen::AlignedBox1d GroundChords::linesAt(const Eigen::Vector2i& here) const {
  const int count =
      std::min(kMostOfChord - 1, static_cast<int>(std::ceil(longest_ / cells_.cell())));
  Eigen::AlignedBox1d all = at(here);
  std::array<Eigen::AlignedBox1d, kMostOfChord> ahead, behind;  // by squares from here
  for (int k = 0; k < kChordDirections; ++k) {
    const double heading = kPi * k / kChordDirections;
    const Eigen::Array2d way(std::cos(heading), std::sin(heading));
    for (int i = 1; i < count; ++i) {
      const Eigen::Vector2i off = (i * way).round().cast<int>();
      ahead[i] = at(here + off);
      behind[i] = at(here - off);
    }
    for (int i = 1; i < count; ++i) {
      if (ahead[i].isEmpty()) continue;
      for (int j = 1; i + j <= count; ++j) {
        if (behind[j].isEmpty()) continue;
        const double share = static_cast<double>(i) / (i + j);  // of what is behind
        all.extend(Eigen::AlignedBox1d((1.0 - share) * ahead[i].min() + share * behind[j].min(),
                                       (1.0 - share) * ahead[i].max() + share * behind[j].max()));
      }
    }
  }
  return all;
}

}  // namespace amble
