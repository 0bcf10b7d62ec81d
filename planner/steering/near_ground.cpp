#include "planner/steering/near_ground.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/rotation.h"
#include "environments/ground/ground_cells.h"

namespace amble {
namespace {

// Larger grounds are near everywhere: of 400 m by 250 m.
constexpr double kMostNear = 1e7;  // squares
constexpr int kBins = 64;          // of all directions

// Directions to squares around one: bits of bins, by offsets of -reach to reach, x fastest.
std::vector<std::uint64_t> binsAround(int reach) {
  std::vector<std::uint64_t> bins;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double turn = std::atan2(dy, dx) / (2.0 * kPi);
      bins.push_back(std::uint64_t{1}
                     << (static_cast<int>(std::floor((turn + 1.0) * kBins)) % kBins));
    }
  }
  return bins;
}

// Whether directions in these bins leave no half of all out.
bool isAround(std::uint64_t bins) {
  // Of a bin and so many after it none; doubled each time.
  std::uint64_t none = ~bins;
  for (int run = 1; run < kBins / 2; run *= 2) none &= std::rotr(none, run);
  return none == 0;
}

}  // namespace

NearGround::NearGround(const SceneGround& ground, const ReachedGround& reached, double longest_step,
                       double beyond)
    : cells_(ground.cells()) {
  const double cell = cells_.cell();
  if (cells_.columns() == 0 || static_cast<double>(cells_.columns()) * cells_.rows() > kMostNear)
    return;
  margin_ = static_cast<int>(std::ceil(beyond / cell)) + 2;
  count_ = Eigen::Vector2i(cells_.columns(), cells_.rows()).array() + 2 * margin_;
  on_.resize(static_cast<size_t>(count_.x()) * count_.y());
  for (int row = 0; row < cells_.rows(); ++row) {
    for (int column = 0; column < cells_.columns(); ++column) {
      bool on = false;
      for (const GroundCells::Span& span : cells_.spans(column, row))
        on = on || (span.ground && reached.has(column, row, span));
      on_[static_cast<size_t>(row + margin_) * count_.x() + column + margin_] = on;
    }
  }
  markBridges(static_cast<int>(std::ceil(longest_step / cell)) + 1);
  widen(beyond + std::sqrt(2.0) * cell);
}

// Rings of squares around it, up to where what they have of ground lies all around.
bool NearGround::isBetween(int x, int y, int reach, std::span<const std::uint64_t> bins) const {
  std::uint64_t seen = 0;
  const auto look = [&](int dx, int dy) {
    if (isOn(x + dx, y + dy)) seen |= bins[(dy + reach) * (2 * reach + 1) + dx + reach];
  };
  for (int ring = 1; ring <= reach; ++ring) {
    for (int i = -ring; i < ring; ++i) {
      look(i, -ring);
      look(ring, i);
      look(-i, ring);
      look(-ring, -i);
    }
    if (isAround(seen)) return true;
  }
  return false;
}

void NearGround::markBridges(int reach) {
  const std::vector<std::uint64_t> bins = binsAround(reach);
  std::vector<size_t> between;
  for (int y = margin_; y + margin_ < count_.y(); ++y) {
    for (int x = margin_; x + margin_ < count_.x(); ++x) {
      if (!isOn(x, y) && isBetween(x, y, reach, bins))
        between.push_back(static_cast<size_t>(y) * count_.x() + x);
    }
  }
  for (const size_t square : between) on_[square] = true;
}

void NearGround::widen(double by) {
  const std::vector<std::uint8_t> before = on_;
  const auto was = [&](int x, int y) { return before[static_cast<size_t>(y) * count_.x() + x]; };
  const double reach = by / cells_.cell();
  const int far = static_cast<int>(reach);
  std::vector<int> widths;  // of each row of the disc half of it, from -far on
  for (int j = -far; j <= far; ++j) {
    int i = far;
    while (i > 0 && std::hypot(i, j) > reach) --i;
    widths.push_back(i);
  }
  for (int y = 1; y + 1 < count_.y(); ++y) {
    for (int x = 1; x + 1 < count_.x(); ++x) {
      if (!was(x, y) || (was(x - 1, y) && was(x + 1, y) && was(x, y - 1) && was(x, y + 1)))
        continue;
      for (int j = std::max(-far, -y); j <= std::min(far, count_.y() - 1 - y); ++j) {
        const size_t row = static_cast<size_t>(y + j) * count_.x();
        const int half = widths[j + far];
        const int last = std::min(x + half, count_.x() - 1);
        for (int i = std::max(x - half, 0); i <= last; ++i) on_[row + i] = true;
      }
    }
  }
}

bool NearGround::has(const Eigen::Vector2d& p) const {
  if (on_.empty()) return true;
  const Eigen::Array2d at = ((p - cells_.middle(0, 0)).array() / cells_.cell()).round() + margin_;
  if ((at < 0.0).any() || (at >= count_.cast<double>().array()).any()) return false;
  return isOn(static_cast<int>(at.x()), static_cast<int>(at.y()));
}

}  // namespace amble
