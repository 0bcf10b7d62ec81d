#include "environments/ground/ground_column.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/rotation.h"

namespace amble {
namespace {

// Beyond what the steepest slope explains, as far as a foot reaches, a surface may be uneven by so
// much and be one to stand on [m].
constexpr double kUneven = 0.01;

}  // namespace

GroundColumn::GroundColumn(const Scene& scene, const ScenePieces& pieces,
                           const std::vector<bool>& up, const GroundSettings& settings)
    : scene_(scene),
      pieces_(pieces),
      all_(pieces.grid),
      up_(up),
      settings_(settings),
      inside_(pieces.pieces.size(), false),
      depth_(scene.objects.size(), 0) {
  for (int k = 0; k < kFootHeadings; ++k) {
    const double heading = kPi * k / kFootHeadings;
    const Eigen::Vector2d along =
        0.5 * settings.foot_length * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    const Eigen::Vector2d aside =
        0.5 * settings.foot_breadth * Eigen::Vector2d(-std::sin(heading), std::cos(heading));
    feet_[k] = {pairAlong(along), pairAlong(0.5 * along), pairAlong(aside)};
  }
}

GroundColumn::Pair GroundColumn::pairAlong(const Eigen::Vector2d& offset) const {
  const double most = std::tan(settings_.limits.max_slope) * offset.norm() + kUneven;
  return {Beside{-offset, most}, Beside{offset, most}};
}

// Surfaces over the point, lowest first, each once: a line through an edge meets the triangles on
// both sides.
void GroundColumn::collect() {
  hits_.clear();
  all_.visitAt(at_.x(), at_.y(), [&](int t) {
    if (const auto z = heightOver(all_.triangles()[t], at_.x(), at_.y()))
      hits_.push_back({*z, t, pieces_.piece_of[t], upwardness(all_.triangles()[t]) > 0.0});
  });
  std::sort(hits_.begin(), hits_.end(), [](const Hit& a, const Hit& b) {
    return std::tie(a.height, a.piece, a.faces_up, a.triangle) <
           std::tie(b.height, b.piece, b.faces_up, b.triangle);
  });
  const auto doubled = [](const Hit& a, const Hit& b) {
    return a.piece == b.piece && a.faces_up == b.faces_up && b.height - a.height < kTouching;
  };
  hits_.erase(std::unique(hits_.begin(), hits_.end(), doubled), hits_.end());
}

// The line enters or leaves a closed piece. Of an object it may be in solids, and in hollows of
// them.
void GroundColumn::cross(int piece) {
  const int object = pieces_.pieces[piece].solid_of;
  inside_[piece] = !inside_[piece];
  const bool adds = inside_[piece] != pieces_.pieces[piece].hollow;
  const int before = depth_[object];
  depth_[object] += adds ? 1 : -1;
  solids_ += (depth_[object] > 0) - (before > 0);
}

const std::vector<GroundColumn::Surface>& GroundColumn::surfacesAt(const Eigen::Vector2d& p) {
  at_ = p;
  surfaces_.clear();
  for (auto& foot : feet_)
    for (Pair& pair : foot)
      for (Beside& beside : pair) beside.known = false;
  collect();
  for (size_t begin = 0, end; begin < hits_.size(); begin = end) {
    bool stands = false, is_said = false;
    for (end = begin; end < hits_.size() && hits_[end].height - hits_[begin].height < kTouching;
         ++end) {
      const Hit& hit = hits_[end];
      const ScenePiece& piece = pieces_.pieces[hit.piece];
      if (piece.closed) cross(hit.piece);
      stands = stands || up_[hit.triangle];
      is_said =
          is_said || (up_[hit.triangle] && scene_.objects[piece.object].role == Role::kGround);
    }
    if (!stands) continue;
    const double height = hits_[end - 1].height;
    const bool open = end == hits_.size() || hits_[end].height - height >= settings_.headroom;
    surfaces_.push_back({height, solids_ == 0 && open && hasRoom(height), is_said});
  }
  // A surface that is met an odd number of times, by its edge, leaves something open.
  for (const Hit& hit : hits_)
    if (inside_[hit.piece]) cross(hit.piece);
  return surfaces_;
}

// The surface there that a slope from the middle, at height z, could lead to, the nearest in
// height. What lies there is looked up once for all surfaces over the point.
std::optional<double> GroundColumn::nearest(double z, Beside& beside) {
  if (!beside.known) {
    beside.heights.clear();
    const Eigen::Vector2d p = at_ + beside.offset;
    all_.visitAt(p.x(), p.y(), [&](int t) {
      if (!up_[t]) return;
      if (const auto height = heightOver(all_.triangles()[t], p.x(), p.y()))
        beside.heights.push_back(*height);
    });
    std::sort(beside.heights.begin(), beside.heights.end());
    beside.known = true;
  }
  const auto above = std::lower_bound(beside.heights.begin(), beside.heights.end(), z);
  std::optional<double> found;
  if (above != beside.heights.end() && *above - z <= beside.most) found = *above;
  if (above == beside.heights.begin()) return found;
  const double below = *(above - 1);
  if (z - below <= beside.most && (!found || z - below < *found - z)) found = below;
  return found;
}

// Whether the ground goes on straight to both sides of the middle.
bool GroundColumn::isStraight(double z, Pair& pair) {
  const auto before = nearest(z, pair[0]);
  if (!before) return false;
  const auto after = nearest(z, pair[1]);
  return after && std::abs(*before + *after - 2.0 * z) <= 2.0 * kUneven;
}

bool GroundColumn::hasRoom(double z) {
  return std::any_of(feet_.begin(), feet_.end(), [&](auto& foot) {
    return std::all_of(foot.begin(), foot.end(), [&](Pair& pair) { return isStraight(z, pair); });
  });
}

}  // namespace amble
