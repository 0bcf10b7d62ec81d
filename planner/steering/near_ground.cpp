#include "planner/steering/near_ground.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/rotation.h"
#include "environments/ground/ground_cells.h"
#include "environments/scene/triangle_grid.h"

namespace amble {
namespace {

// Larger grounds are near everywhere: of 400 m by 250 m.
constexpr double kMostNear = 1e7;  // squares
constexpr int kBins = 64;          // of all directions
// So far a surface may be from what its square, or one beside it, has in height: as the next tread.
constexpr double kSameSurface = 0.3;  // [m]

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

// The point of a triangle that is nearest to p, seen from above.
Eigen::Vector3d nearestInPlan(const Triangle3& t, const Eigen::Vector2d& p) {
  Eigen::Vector3d best = t[0];
  bool left = false, right = false;  // of its sides
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d& a = t[i];
    const Eigen::Vector3d side = t[(i + 1) % 3] - a;
    const Eigen::Vector2d way = side.head<2>(), to = p - a.head<2>();
    const double along = way.dot(to) / std::max(way.squaredNorm(), 1e-18);
    const Eigen::Vector3d there = a + std::clamp(along, 0.0, 1.0) * side;
    if ((there.head<2>() - p).squaredNorm() < (best.head<2>() - p).squaredNorm()) best = there;
    const double turn = way.x() * to.y() - way.y() * to.x();
    left = left || turn > 0.0;
    right = right || turn < 0.0;
  }
  if (left && right) return best;
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  if (normal.z() == 0.0) return best;
  const double z = t[0].z() - normal.head<2>().dot(p - t[0].head<2>()) / normal.z();
  return {p.x(), p.y(), z};
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
    : ground_(ground), cells_(ground.cells()), beyond_(beyond) {
  const double cell = cells_.cell();
  if (cells_.columns() == 0 || static_cast<double>(cells_.columns()) * cells_.rows() > kMostNear)
    return;
  heights_ = reached.heights();
  margin_ = static_cast<int>(std::ceil(beyond / cell)) + 2;
  count_ = Eigen::Vector2i(cells_.columns(), cells_.rows()).array() + 2 * margin_;
  on_.resize(static_cast<size_t>(count_.x()) * count_.y(), kFar);
  std::vector<size_t> grounds;
  for (int row = 0; row < cells_.rows(); ++row) {
    for (int column = 0; column < cells_.columns(); ++column) {
      if (heights_[static_cast<size_t>(row) * cells_.columns() + column].isEmpty()) continue;
      grounds.push_back(static_cast<size_t>(row + margin_) * count_.x() + column + margin_);
      on_[grounds.back()] = kBeside;
    }
  }
  markBridges(static_cast<int>(std::ceil(longest_step / cell)) + 1);
  widen(beyond + kMostAround + std::sqrt(2.0) * cell);
  for (const size_t square : grounds) on_[square] = kNear;
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
  for (const size_t square : between) on_[square] = kNear;
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
      const std::uint8_t own = was(x, y);
      if (own == kFar ||
          std::min({was(x - 1, y), was(x + 1, y), was(x, y - 1), was(x, y + 1)}) >= own)
        continue;
      for (int j = std::max(-far, -y); j <= std::min(far, count_.y() - 1 - y); ++j) {
        const size_t row = static_cast<size_t>(y + j) * count_.x();
        const int half = widths[j + far];
        const int last = std::min(x + half, count_.x() - 1);
        for (int i = std::max(x - half, 0); i <= last; ++i)
          on_[row + i] = std::max(on_[row + i], own);
      }
    }
  }
}

std::uint8_t NearGround::squareOf(const Eigen::Vector2d& p) const {
  const Eigen::Array2d at = ((p - cells_.middle(0, 0)).array() / cells_.cell()).round() + margin_;
  if ((at < 0.0).any() || (at >= count_.cast<double>().array()).any()) return kFar;
  return on_[static_cast<size_t>(at.y()) * count_.x() + static_cast<int>(at.x())];
}

bool NearGround::has(const Eigen::Vector2d& p, double around) const {
  if (on_.empty()) return true;
  const std::uint8_t square = squareOf(p);
  return square == kBeside ? isWithin(p, beyond_ + around) : square == kNear;
}

Eigen::Vector2d NearGround::corner() const {
  return cells_.middle(0, 0).array() - (margin_ + 0.5) * cells_.cell();
}

bool NearGround::isGroundBesideOther(int x, int y) const {
  if (at(x, y) != kNear) return false;
  for (int j = std::max(0, y - 1); j <= std::min(count_.y() - 1, y + 1); ++j) {
    for (int i = std::max(0, x - 1); i <= std::min(count_.x() - 1, x + 1); ++i)
      if (at(i, j) == kBeside) return true;
  }
  return false;
}

// Whether ground that is reached is so near, by its triangles.
bool NearGround::isWithin(const Eigen::Vector2d& p, double distance) const {
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(distance);
  bool found = false;
  ground_.surfaces().visitBox({p - reach, p + reach}, [&](int t) {
    if (found) return;
    const Eigen::Vector3d nearest = nearestInPlan(ground_.surfaces().triangles()[t], p);
    found = (nearest.head<2>() - p).norm() <= distance && isReached(nearest);
  });
  return found;
}

// Whether a surface is ground that is reached, there or at a square beside it.
bool NearGround::isReached(const Eigen::Vector3d& surface) const {
  const Eigen::Vector2i at = cells_.squareAt(surface.head<2>());
  for (int y = std::max(0, at.y() - 1); y <= std::min(cells_.rows() - 1, at.y() + 1); ++y) {
    for (int x = std::max(0, at.x() - 1); x <= std::min(cells_.columns() - 1, at.x() + 1); ++x) {
      const Eigen::AlignedBox1d& reached = heights_[static_cast<size_t>(y) * cells_.columns() + x];
      if (!reached.isEmpty() &&
          reached.exteriorDistance(Eigen::AlignedBox1d::VectorType(surface.z())) <= kSameSurface)
        return true;
    }
  }
  return false;
}

}  // namespace amble
