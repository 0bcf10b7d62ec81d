#include "environments/ground/ground_patches.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "environments/ground/plan_strip.h"
#include "environments/ground/plan_triangle.h"
#include "environments/scene/scene_pieces.h"

namespace amble {
namespace {

// Patches are taken to be larger by so much than rounding makes them [m].
constexpr double kPatchRounding = 1e-6;
// Of heights of what is clipped [m].
constexpr double kHeightRounding = 1e-6;

float below(double height) {
  return std::nextafter(static_cast<float>(height - kHeightRounding), -HUGE_VALF);
}

float above(double height) {
  return std::nextafter(static_cast<float>(height + kHeightRounding), HUGE_VALF);
}

Eigen::AlignedBox2d grown(const Eigen::AlignedBox2d& box) {
  return {box.min().array() - PlanTriangle::kSeen, box.max().array() + PlanTriangle::kSeen};
}

}  // namespace

struct GroundPatches::Tile {
  // Between which heights what of a triangle is over a part of a patch ends.
  struct Ends {
    float low, high;  // rounded outwards [m]
    int triangle;
  };
  struct Patch {
    int levels = 0, level_count = -1;  // -1: not level
    int ends = 0, end_count = 0;
    float low = HUGE_VALF, high = -HUGE_VALF;  // of all of those [m]
  };
  std::array<Patch, kTile * kTile> patches;
  std::vector<double> levels;
  std::vector<Ends> ends;
  double lowest = HUGE_VAL, highest = -HUGE_VAL;  // between which `ends` are kept [m]
  std::optional<double> level;                    // the one of every patch, if there is one [m]
};

class GroundPatches::Maker {
 public:
  Maker(const GroundPatches& patches, int column, int row)
      : patches_(patches), corner_(column, row) {}

  std::unique_ptr<const Tile> make() {
    auto tile = std::make_unique<Tile>();
    findGround(*tile);
    findEnds(*tile);
    return tile;
  }

 private:
  // Of the triangles near the tile that `is_one` each once.
  template <typename Condition>
  std::vector<int> near(const TriangleGrid& grid, Condition is_one) const {
    std::vector<int> near;
    const Eigen::AlignedBox2d all = box(0)
                                        .merged(box(kTile * kTile - 1))
                                        .merged(box(kTile - 1))
                                        .merged(box(kTile * kTile - kTile));
    const Eigen::AlignedBox2d around = grown(all);
    grid.visitBox(around, [&](int t) {
      if (is_one(grid.triangles()[t])) near.push_back(t);
    });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
  }

  Eigen::AlignedBox2d box(int patch) const {
    return patches_.patchBox(corner_.x() + patch % kTile, corner_.y() + patch / kTile);
  }

  // Calls visit_one(patch, its box) for those of the tile that a triangle may meet.
  template <typename Visit>
  void eachMet(const PlanTriangle& t, Visit visit_one) const {
    const auto within = [&](double value, int axis) {
      return std::clamp(patches_.patchAt(value, axis) - corner_[axis], 0, kTile - 1);
    };
    const double more = PlanTriangle::kSeen + kPatchRounding;
    const int left = within(t.box().min().x() - more, 0),
              right = within(t.box().max().x() + more, 0);
    const int low = within(t.box().min().y() - more, 1), high = within(t.box().max().y() + more, 1);
    const bool few = right - left < 3 && high - low < 3;
    for (int j = low; j <= high; ++j) {
      for (int i = left; i <= right; ++i) {
        const Eigen::AlignedBox2d at = box(j * kTile + i);
        if (few || t.mayMeet(at)) visit_one(j * kTile + i, at);
      }
    }
  }

  void findGround(Tile& tile) const {
    const std::vector<Triangle3>& triangles = patches_.ground_->triangles();
    std::array<std::vector<int>, kTile * kTile> met;
    for (const int t : near(*patches_.ground_, [](const Triangle3&) { return true; })) {
      for (const Eigen::Vector3d& corner : triangles[t]) {
        tile.lowest = std::min(tile.lowest, corner.z() - kKeptBelow);
        tile.highest = std::max(tile.highest, corner.z() + kKeptAbove);
      }
      eachMet(PlanTriangle(triangles[t]),
              [&](int patch, const Eigen::AlignedBox2d&) { met[patch].push_back(t); });
    }
    for (int k = 0; k < kTile * kTile; ++k) {
      const auto levels = levelsOf(met[k], cornersOf(box(k)));
      if (!levels) continue;
      tile.patches[k].levels = static_cast<int>(tile.levels.size());
      tile.patches[k].level_count = static_cast<int>(levels->size());
      tile.levels.insert(tile.levels.end(), levels->begin(), levels->end());
    }
    const bool one = std::ranges::all_of(tile.patches, [&](const Tile::Patch& patch) {
      return patch.level_count == 1 && tile.levels[patch.levels] == tile.levels[0];
    });
    if (one) tile.level = tile.levels[0];
  }

  // Lowest first, of the ground's triangles that a patch may meet; none where it is not level, or
  // not all over the patch.
  std::optional<std::vector<double>> levelsOf(const std::vector<int>& met,
                                              const BoxCorners& patch) const {
    const std::vector<Triangle3>& triangles = patches_.ground_->triangles();
    std::vector<double> levels;
    std::vector<int> parts;
    for (const int t : met) {
      if (!isLevel(triangles[t])) return std::nullopt;
      const PlanTriangle seen(triangles[t]);
      const bool all = std::all_of(patch.begin(), patch.end(),
                                   [&](const Eigen::Vector2d& p) { return seen.holds(p); });
      if (all)
        levels.push_back(triangles[t][0].z());
      else
        parts.push_back(t);
    }
    for (const int t : parts) {
      const double height = triangles[t][0].z();
      if (std::find(levels.begin(), levels.end(), height) != levels.end()) continue;
      const PlanTriangle seen(triangles[t]);
      const bool whole = std::any_of(parts.begin(), parts.end(), [&](int other) {
        return other != t && triangles[other][0].z() == height &&
               seen.holdsWith(PlanTriangle(triangles[other]), patch);
      });
      if (!whole) return std::nullopt;
      levels.push_back(height);
    }
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
  }

  static HeightRange heightsOf(const Triangle3& t) {
    const auto [low, high] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
    return {low, high};
  }

  void findEnds(Tile& tile) const {
    const std::vector<Triangle3>& triangles = patches_.all_->triangles();
    std::vector<std::pair<int, Tile::Ends>> found;  // with their patch, by triangle
    const auto counts = [&](const Triangle3& t) {
      const HeightRange heights = heightsOf(t);
      return !(heights.high < tile.lowest || heights.low > tile.highest);
    };
    for (const int t : near(*patches_.all_, counts)) {
      const Triangle3& corners = triangles[t];
      const auto [low, high] = heightsOf(corners);
      const bool upright = low < high && std::abs(upwardness(corners)) < kUpright;
      const HeightRange own{upright ? high : low, high};
      if (own.low > tile.highest) continue;
      const PlanTriangle seen(corners);
      const bool large = own.low < own.high && seen.box().sizes().maxCoeff() > 4.0 * kPatch;
      const Tile::Ends all{below(own.low), above(own.high), t};
      eachMet(seen, [&](int patch, const Eigen::AlignedBox2d& at) {
        if (!large) {
          found.push_back({patch, all});
        } else if (const auto here = heightsWithin(corners, grown(at))) {
          found.push_back({patch, {below(here->low), above(here->high), t}});
        }
      });
    }
    for (const auto& [patch, ends] : found) ++tile.patches[patch].end_count;
    int next = 0;
    for (Tile::Patch& patch : tile.patches) next = (patch.ends = next) + patch.end_count;
    tile.ends.resize(found.size());
    std::array<int, kTile* kTile> filled = {};
    for (const auto& [at, ends] : found) {
      Tile::Patch& patch = tile.patches[at];
      tile.ends[patch.ends + filled[at]++] = ends;
      patch.low = std::min(patch.low, ends.low);
      patch.high = std::max(patch.high, ends.high);
    }
  }

  const GroundPatches& patches_;
  Eigen::Vector2i corner_;  // its first patch
};

GroundPatches::GroundPatches(const TriangleGrid& ground, const TriangleGrid& all)
    : ground_(&ground), all_(&all) {
  if (all.triangles().empty()) return;
  min_ = all.extent().min();
  const Eigen::Vector2d size = all.extent().sizes();
  patch_ = std::max(kPatch, size.maxCoeff() / (kTile * kMostTiles));
  per_metre_ = 1.0 / patch_;
  tiles_of_ = (size / (patch_ * kTile)).cast<int>() + Eigen::Vector2i::Ones();
  slots_ = std::make_unique<Slot[]>(static_cast<size_t>(tiles_of_.x()) * tiles_of_.y());
}

GroundPatches::~GroundPatches() {
  const size_t count = slots_ ? static_cast<size_t>(tiles_of_.x()) * tiles_of_.y() : 0;
  for (size_t i = 0; i < count; ++i) delete slots_[i].tile.load(std::memory_order_acquire);
}

Eigen::AlignedBox2d GroundPatches::patchBox(int column, int row) const {
  const Eigen::Vector2d low = min_ + patch_ * Eigen::Vector2d(column, row);
  return {low.array() - kPatchRounding, low.array() + (patch_ + kPatchRounding)};
}

// None where it is not worth being made yet. Of threads that make one at once the first keeps its
// own: they are the same.
const GroundPatches::Tile* GroundPatches::makeTile(int i, int j) const {
  Slot& slot = slots_[static_cast<size_t>(j) * tiles_of_.x() + i];
  if (slot.asked.fetch_add(1, std::memory_order_relaxed) < kAskedBefore) return nullptr;
  std::unique_ptr<const Tile> own = Maker(*this, i * kTile, j * kTile).make();
  const Tile* there = nullptr;
  if (slot.tile.compare_exchange_strong(there, own.get(), std::memory_order_acq_rel))
    return own.release();
  return there;
}

std::optional<std::span<const double>> GroundPatches::levelsAt(double x, double y) const {
  const int column = patchAt(x, 0), row = patchAt(y, 1);
  if (column < 0 || row < 0 || column >= tiles_of_.x() * kTile || row >= tiles_of_.y() * kTile)
    return std::nullopt;
  const Tile* tile = tileOf(column, row);
  if (tile == nullptr) return std::nullopt;
  const Tile::Patch& patch = tile->patches[row % kTile * kTile + column % kTile];
  if (patch.level_count < 0) return std::nullopt;
  return std::span(tile->levels.data() + patch.levels, static_cast<size_t>(patch.level_count));
}

// Calls visit_row(tile, its patches of one row, their count, column and row of the first) for those
// that meet a box, until it says no. False where that is so or a tile is not there.
template <typename Visit>
bool GroundPatches::visitPatches(const Eigen::AlignedBox2d& box, Visit visit_row) const {
  const auto within = [&](double value, int axis) {
    return std::clamp(patchAt(value, axis), 0, tiles_of_[axis] * kTile - 1);
  };
  const int left = within(box.min().x() - kPatchRounding, 0);
  const int right = within(box.max().x() + kPatchRounding, 0);
  const int last = within(box.max().y() + kPatchRounding, 1);
  for (int j = within(box.min().y() - kPatchRounding, 1); j <= last; ++j) {
    for (int i = left; i <= right;) {
      const Tile* tile = tileOf(i, j);
      if (tile == nullptr) return false;
      const int end = std::min(right + 1, i - i % kTile + kTile);
      if (!visit_row(*tile, &tile->patches[j % kTile * kTile + i % kTile], end - i, i, j))
        return false;
      i = end;
    }
  }
  return true;
}

// Of the patches of a tile from one to another, in its rows and columns; of one that is level all
// over, at once. False where there is none, or not one for all of them and those before.
bool GroundPatches::isLevelWithin(const Tile& tile, const Eigen::Vector2i& first,
                                  const Eigen::Vector2i& last, double z, double reach,
                                  std::optional<double>& level) {
  const auto agrees = [&](double height) { return height == level.value_or(height); };
  if (tile.level && std::abs(*tile.level - z) <= reach && agrees(*tile.level)) {
    level = tile.level;
    return true;
  }
  for (int j = first.y(); j <= last.y(); ++j) {
    for (int i = first.x(); i <= last.x(); ++i) {
      const Tile::Patch& patch = tile.patches[j * kTile + i];
      const double* levels = tile.levels.data() + patch.levels;
      int k = patch.level_count - 1;  // the highest
      while (k >= 0 && std::abs(levels[k] - z) > reach) --k;
      if (k < 0 || !agrees(levels[k])) return false;
      level = levels[k];
    }
  }
  return true;
}

std::optional<double> GroundPatches::levelOver(const Eigen::AlignedBox2d& box, double z,
                                               double reach) const {
  Eigen::Vector2i first, last;
  for (const int axis : {0, 1}) {
    first[axis] = patchAt(box.min()[axis], axis);
    last[axis] = patchAt(box.max()[axis], axis);
    if (first[axis] < 0 || last[axis] < 0 || last[axis] >= tiles_of_[axis] * kTile)
      return std::nullopt;
  }
  const Eigen::Vector2i end = last / kTile;
  std::optional<double> level;
  for (Eigen::Vector2i at = first / kTile; at.y() <= end.y(); ++at.y()) {
    for (at.x() = first.x() / kTile; at.x() <= end.x(); ++at.x()) {
      const Tile* tile = tileOf(at.x() * kTile, at.y() * kTile);
      const Eigen::Vector2i corner = kTile * at;
      if (tile == nullptr || !isLevelWithin(*tile, (first - corner).cwiseMax(0),
                                            (last - corner).cwiseMin(kTile - 1), z, reach, level))
        return std::nullopt;
    }
  }
  return level;
}

namespace {

// A strip against the patches of a row, one after another.
class PatchesOfStrip {
 public:
  PatchesOfStrip(const PlanStrip& strip, double patch, const Eigen::Vector2d& first_middle)
      : low_(strip.box.min()),
        high_(strip.box.max()),
        step_(patch * strip.along.x()),
        step_aside_(patch * strip.aside.x()) {
    const Eigen::Vector2d from = first_middle - strip.origin;
    at_ << strip.along.dot(from), strip.aside.dot(from);
    const double reach = (0.5 * patch + kPatchRounding + PlanTriangle::kSeen) *
                             (std::abs(strip.along.x()) + std::abs(strip.along.y())) +
                         kPatchRounding;
    low_.array() -= reach;
    high_.array() += reach;
  }

  bool meets(int k) const {
    const double u = at_.x() + k * step_, v = at_.y() + k * step_aside_;
    return u >= low_.x() && u <= high_.x() && v >= low_.y() && v <= high_.y();
  }

 private:
  Eigen::Vector2d low_, high_, at_;
  double step_, step_aside_;
};

}  // namespace

// Calls visit_one(triangle), for some more than once, until it says yes.
// @return whether it did; none where all triangles must be asked
template <typename Visit>
std::optional<bool> GroundPatches::visitEnds(const Eigen::AlignedBox2d& box, const PlanStrip* strip,
                                             double low, double high, Visit visit_one) const {
  if (!slots_) return false;
  bool found = false;
  const bool all = visitPatches(
      box, [&](const Tile& tile, const Tile::Patch* row, int count, int column, int at_row) {
        if (low < tile.lowest || high > tile.highest) return false;
        std::optional<PatchesOfStrip> along;
        for (int i = 0; i < count; ++i) {
          const Tile::Patch& patch = row[i];
          if (patch.low > high || patch.high < low) continue;  // which most are
          if (strip != nullptr) {
            if (!along) along.emplace(*strip, patch_, patchBox(column, at_row).center());
            if (!along->meets(i)) continue;
          }
          for (int k = patch.ends; k < patch.ends + patch.end_count; ++k) {
            const Tile::Ends& ends = tile.ends[k];
            if (ends.low > high || ends.high < low || !visit_one(ends.triangle)) continue;
            found = true;
            return false;
          }
        }
        return true;
      });
  if (!all && !found) return std::nullopt;
  return found;
}

std::optional<bool> GroundPatches::anyEnding(const PlanStrip& strip, double low, double high,
                                             const std::function<bool(int)>& is_it) const {
  std::array<int, 8> seen;  // the last few
  seen.fill(-1);
  size_t next = 0;
  return visitEnds(strip.plan(), &strip, low, high, [&](int triangle) {
    if (std::find(seen.begin(), seen.end(), triangle) != seen.end()) return false;
    seen[next++ % seen.size()] = triangle;
    return is_it(triangle);
  });
}

namespace {

// Triangles, each once.
class Distinct {
 public:
  void add(int triangle) {
    constexpr size_t kFew = 16;  // among which it is quicker to look than to sort all in the end
    if (all_.size() <= kFew && std::find(all_.begin(), all_.end(), triangle) != all_.end()) return;
    if (all_.empty()) all_.reserve(kFew);
    all_.push_back(triangle);
  }

  std::vector<int> sorted() {
    std::sort(all_.begin(), all_.end());
    all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
    return std::move(all_);
  }

 private:
  std::vector<int> all_;
};

}  // namespace

std::optional<std::vector<int>> GroundPatches::endingOver(const Eigen::AlignedBox2d& box,
                                                          double low, double high) const {
  Distinct found;
  if (!visitEnds(box, nullptr, low, high, [&](int t) { return found.add(t), false; }))
    return std::nullopt;
  return found.sorted();
}

std::optional<std::vector<int>> GroundPatches::endingOver(const PlanStrip& strip, double low,
                                                          double high) const {
  Distinct found;
  if (!visitEnds(strip.plan(), &strip, low, high, [&](int t) { return found.add(t), false; }))
    return std::nullopt;
  return found.sorted();
}

}  // namespace amble
