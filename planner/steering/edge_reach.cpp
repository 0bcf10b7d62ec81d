#include "planner/steering/edge_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "environments/ground/ground_cells.h"
#include "environments/scene/scene_pieces.h"

namespace amble {
namespace {

constexpr double kFootOverGround = 0.02;  // of the lowest bone [m]
constexpr float kNotReached = std::numeric_limits<float>::infinity();
constexpr float kWalled = -1.0F;  // in place of a distance

}  // namespace

EdgeReach::EdgeReach(const SceneGround& ground, const NearGround& near, const GroundRange& range,
                     double stature, double high)
    : ground_(ground), near_(near), range_(range), high_(high) {
  const double cell = ground.cells().cell();
  share_ = static_cast<int>(std::ceil(cell / (std::sqrt(2.0) * kThinnest * stature)));
  side_ = cell / share_;
  // From square to square, each beside the one before it, a curve is longer by this at most; feet
  // stand up to a square of the cells beyond those that are ground.
  longest_ = std::sqrt(2.0) * kOfBones * stature + 4.0 * side_ + 2.0 * cell;
}

// A surface of a closed piece over a place.
struct EdgeReach::Hit {
  int piece;
  double height;
  bool faces_up;
  bool operator<(const Hit& other) const {
    return std::pair(piece, height) < std::pair(other.piece, other.height);
  }
};

// Whether closed pieces, one over another, are solid there at all heights that bones have. Seams
// count once; of what is no plain solid over the place nothing is said.
bool EdgeReach::isWall(const Eigen::Vector2d& p) const {
  const Eigen::AlignedBox1d feet = range_.around(p);
  if (feet.isEmpty()) return false;
  std::vector<Hit> hits;
  bool plain = true;
  ground_.all().visitAt(p.x(), p.y(), [&](int t) {
    const ScenePiece& piece = ground_.pieces().pieceOf(t);
    if (!piece.closed || ground_.isGround(piece.object)) return;
    plain = plain && !piece.hollow;
    const Triangle3& corners = ground_.all().triangles()[t];
    if (const auto z = heightOver(corners, p.x(), p.y()))
      hits.push_back({ground_.pieces().piece_of[t], *z, upwardness(corners) > 0.0});
  });
  if (!plain || hits.empty()) return false;
  std::sort(hits.begin(), hits.end());
  const auto same = [](const Hit& a, const Hit& b) {
    return a.piece == b.piece && a.faces_up == b.faces_up && b.height - a.height <= kTouching;
  };
  hits.erase(std::unique(hits.begin(), hits.end(), same), hits.end());
  std::vector<std::pair<double, double>> solid;  // from, to
  for (size_t i = 0; i + 1 < hits.size(); ++i) {
    if (hits[i].piece == hits[i + 1].piece && !hits[i].faces_up && hits[i + 1].faces_up)
      solid.emplace_back(hits[i].height, hits[i + 1].height);
  }
  std::sort(solid.begin(), solid.end());
  double up_to = feet.min()[0] + kFootOverGround;
  for (const auto& [low, high] : solid)
    if (low <= up_to) up_to = std::max(up_to, high);
  return up_to >= feet.max()[0] + high_;
}

Eigen::Vector2d EdgeReach::middle(const Square& square) const {
  return near_.corner() + side_ * (square.cast<double>().array() + 0.5).matrix();
}

// None where no part is, or where ground is.
float* EdgeReach::distanceTo(const Square& square) const {
  const Eigen::Vector2i count = near_.squares();
  if ((square.array() < 0).any() || (square.array() >= share_ * count.array()).any())
    return nullptr;
  const Eigen::Vector2i of_near = square / share_, within = square - share_ * of_near;
  const int block = blocks_[static_cast<size_t>(of_near.y()) * count.x() + of_near.x()];
  if (block < 0) return nullptr;
  return &distances_[(static_cast<size_t>(block) * share_ + within.y()) * share_ + within.x()];
}

void EdgeReach::spread() const {
  const Eigen::Vector2i count = near_.squares();
  blocks_.assign(static_cast<size_t>(count.x()) * count.y(), -1);
  int blocks = 0;
  for (int y = 0; y < count.y(); ++y) {
    for (int x = 0; x < count.x(); ++x)
      if (near_.isBeside(x, y)) blocks_[static_cast<size_t>(y) * count.x() + x] = blocks++;
  }
  distances_.assign(static_cast<size_t>(blocks) * share_ * share_, kNotReached);
  using Open = std::pair<float, std::pair<int, int>>;  // distance, square
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  const auto reach = [&](const Square& square, double distance) {
    float* const known = distanceTo(square);
    if (known == nullptr || *known <= distance || distance > longest_) return;
    if (*known == kNotReached && isWall(middle(square))) {
      *known = kWalled;
      return;
    }
    *known = static_cast<float>(distance);
    open.emplace(*known, std::pair(square.x(), square.y()));
  };
  const auto reachAround = [&](const Square& square, double distance) {
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        if (i != 0 || j != 0)
          reach(square + Square(i, j), distance + side_ * std::sqrt(std::abs(i) + std::abs(j)));
      }
    }
  };
  // From ground, at its border with what is beside it, where no wall is.
  for (int y = 0; y < count.y(); ++y) {
    for (int x = 0; x < count.x(); ++x) {
      if (!near_.isGroundBesideOther(x, y)) continue;
      for (int k = 0; k < share_ * share_; ++k) {
        const Square square(share_ * x + k % share_, share_ * y + k / share_);
        const Eigen::Array2i within(k % share_, k / share_);
        if ((within > 0).all() && (within + 1 < share_).all()) continue;
        if (!isWall(middle(square))) reachAround(square, 0.0);
      }
    }
  }
  while (!open.empty()) {
    const auto [distance, at] = open.top();
    open.pop();
    const Square square(at.first, at.second);
    if (*distanceTo(square) == distance) reachAround(square, distance);
  }
}

bool EdgeReach::has(const Eigen::Vector2d& p, double around) const {
  if (near_.squares().isZero()) return true;
  std::call_once(once_, [&] { spread(); });
  const Eigen::Vector2d at = (p - near_.corner()) / side_;
  const int far = 1 + static_cast<int>(around / side_);
  const Square here = at.array().floor().cast<int>();
  for (int j = -far; j <= far; ++j) {
    for (int i = -far; i <= far; ++i) {
      const Square square = here + Square(i, j);
      // Of the squares about, those that p's surroundings meet.
      const Eigen::Array2d off = ((middle(square) - p).array().abs() - 0.5 * side_).max(0.0);
      if (off.matrix().norm() > around + kTouching) continue;
      const float* const distance = distanceTo(square);
      if (distance == nullptr ? near_.isOver(middle(square))
                              : *distance != kWalled && *distance != kNotReached)
        return true;
    }
  }
  return false;
}

}  // namespace amble
