#include "planner/steering/open_way.h"

#include <cmath>
#include <queue>
#include <utility>
#include <vector>

#include "planner/steering/ground_range.h"

namespace amble {
namespace {

constexpr double kMostOpenSquares = 1e7;  // of a flood; larger ones are not begun
constexpr int kOpenPerLook = 1 << 10;     // squares between looks at the clock

class OpenWay {
 public:
  OpenWay(const Eigen::Vector3d& to, const UprightPost& post, double square,
          const CollisionWorld& world, const SceneGround& ground, const ReachedGround& reached,
          const NearGround& near, CollisionScratch& scratch)
      : to_(to.head<2>()),
        post_(post),
        square_(square),
        region_(ground.extent()),
        world_(world),
        range_(ground, reached, post.around + square),  // around all of a square
        near_(near),
        scratch_(scratch) {
    const Eigen::Array2d squares = region_.sizes().array() / square;
    if (region_.isEmpty() || squares.prod() > kMostOpenSquares || !range_.isKnown()) return;
    count_ = squares.cast<int>();
    known_.resize(static_cast<size_t>(count_.x()) * count_.y());
  }

  bool leads(const Eigen::Vector2d& from, const std::function<bool()>& stopped);

 private:
  Eigen::Vector2d middle(int x, int y) const {
    return region_.min() + square_ * Eigen::Vector2d(x + 0.5, y + 0.5);
  }
  void reach(int x, int y);

  const Eigen::Vector2d to_;
  const UprightPost post_;
  const double square_;
  const Eigen::AlignedBox2d region_;
  const CollisionWorld& world_;
  const GroundRange range_;
  const NearGround& near_;
  CollisionScratch& scratch_;
  Eigen::Vector2i count_{0, 0};
  std::vector<bool> known_;  // by square
  using Open = std::pair<double, int>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;  // by distance to the goal
};

void OpenWay::reach(int x, int y) {
  if (x < 0 || y < 0 || x >= count_.x() || y >= count_.y()) return;
  const int square = y * count_.x() + x;
  if (known_[square]) return;
  known_[square] = true;
  const Eigen::Vector2d p = middle(x, y);
  const Eigen::AlignedBox1d ground = range_.around(p);
  if (!near_.has(p) || ground.isEmpty()) return;
  const double radius = post_.radius + std::sqrt(0.5) * square_;
  if (world_.touched({p.x(), p.y(), ground.min()[0] + post_.low},
                     {p.x(), p.y(), ground.max()[0] + post_.high}, radius, scratch_) < 0)
    open_.emplace((p - to_).norm(), square);
}

bool OpenWay::leads(const Eigen::Vector2d& from, const std::function<bool()>& stopped) {
  if (known_.empty()) return false;
  const int far = static_cast<int>(std::ceil(post_.aside / square_));
  const Eigen::Vector2i at = ((from - region_.min()) / square_).cast<int>();
  for (int y = at.y() - far; y <= at.y() + far; ++y) {
    for (int x = at.x() - far; x <= at.x() + far; ++x)
      if ((middle(x, y) - from).norm() <= post_.aside) reach(x, y);
  }
  for (int i = 0; !open_.empty(); ++i) {
    if (i % kOpenPerLook == 0 && stopped()) return false;
    const auto [distance, square] = open_.top();
    if (distance <= post_.aside) return true;
    open_.pop();
    const int x = square % count_.x(), y = square / count_.x();
    for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) reach(x + dx, y + dy);
  }
  return false;
}

}  // namespace

bool isOpenWay(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const UprightPost& post,
               double square, const CollisionWorld& world, const SceneGround& ground,
               const ReachedGround& reached, const NearGround& near, CollisionScratch& scratch,
               const std::function<bool()>& stopped) {
  return OpenWay(to, post, square, world, ground, reached, near, scratch)
      .leads(from.head<2>(), stopped);
}

}  // namespace amble
