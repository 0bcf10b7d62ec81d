#include "planner/steering/ground_reach.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "animation/steps/unevenness.h"
#include "base/union_find.h"
#include "environments/ground/ground_cells.h"
#include "environments/scene/scene_pieces.h"
#include "environments/scene/triangle_grid.h"

namespace amble {
namespace {

// How far the square that a place stands on may be from it in height: kerbs beside it [m].
constexpr double kSameFloor = 0.3;
constexpr int kNearSquares = 2;      // and to each side, where its own has no ground
constexpr double kTwoFeet = 0.2;     // from one foot's line to the other's, and more [m]
constexpr double kSole = 0.35;       // what tilts a foot is no farther from its middle [m]
constexpr double kFlat = 1e-3;       // of heights on ground without a slope [m]
constexpr int kSweepsOfNearest = 4;  // from one side of a gap to the other
constexpr int kBlock = 8;            // squares along a side of what is looked at as one
constexpr double kLevel = GroundCells::kLevel;
// Ground that is narrower than a square is ground where it is so near to what its square has, or
// one beside it, in height; a sole stands on the highest of what is under it [m].
constexpr double kOfSpot = kLevel + Unevenness::kStraddled;
// Beyond the highest step: how far from a square's height a sole may feel ground there [m].
constexpr double kUnderSole = kOfSpot + Unevenness::kLeastStep;
constexpr double kRounding = 1e-6;  // of heights [m]

// Ground over a square.
struct Spot {
  Eigen::Vector2i square;
  double height = 0.0;
  int floor = -1;  // of GroundCells
};

// What ground there is over some squares: no floor, one, or several.
struct Block {
  bool known = false, several = false;
  std::optional<int> floor;
  double low = HUGE_VAL, high = -HUGE_VAL;  // [m]
};

// How feet stand whose middles are over a square, on this ground.
struct Feet {
  Eigen::AlignedBox1d heights;  // [m]
  double steepest = 0.0;        // tangent
};

class Reach {
 public:
  Reach(const SceneGround& ground, double longest_step)
      : ground_(ground),
        cells_(ground.cells()),
        // Walks without a climb take what is natural, whatever they are let.
        climb_(std::max(ground.settings().limits.max_climb, Unevenness::kNatural)),
        drop_(std::max(ground.settings().limits.max_drop, Unevenness::kNatural)),
        steepest_(std::tan(ground.settings().limits.max_slope)),
        reach_(longest_step + kTwoFeet + 2.0 * cells_.cell()) {}

  /// The ground that somebody at p stands on.
  std::optional<Spot> spotAt(const Eigen::Vector3d& p) const;
  /// Floors that a step leads from one to another of, and back, become one set; where it leads one
  /// way only that is known of the two.
  void joinFloors();
  /// Whether steps lead from set to set, from that of the first of these, or back to it.
  enum class Way { kThere, kBack };
  std::vector<bool> setsFrom(const Spot& spot, Way way);
  bool has(const std::vector<bool>& sets, const Spot& spot) { return sets[setOf(spot.floor)]; }
  bool isMet(const Spot& spot) const { return numbers_.contains(spot.floor); }
  Spot spotOf(const Eigen::Vector2i& square, const GroundCells::Span& span) const {
    // Ground that no floor goes on to is one of its own.
    const int own = -2 - (square.y() * cells_.columns() + square.x());
    return {square, span.height, span.both >= 0 ? span.both : own};
  }
  /// From where the ground ends that is reached from `from` to where that begins which leads to
  /// `to`.
  GroundGap gap(const Spot& from, const Spot& to);

 private:
  Eigen::Vector3d middle(const Spot& spot) const {
    Eigen::Vector3d p;
    p << cells_.middle(spot.square.x(), spot.square.y()), spot.height;
    return p;
  }
  template <typename Visit>
  void eachOver(const Eigen::Vector2i& square, Visit visit) const {
    for (const GroundCells::Span& span : cells_.spans(square.x(), square.y())) {
      if (span.ground) visit(spotOf(square, span));
    }
  }
  const Block& blockAt(const Eigen::Vector2i& block);
  bool mayJoin(const Spot& spot, const Block& block);
  void joinAround(const Spot& spot);
  bool isInner(const Spot& spot) const;
  Feet feetOver(const Spot& spot) const;
  const Feet& feetOn(const Spot& spot);
  bool joins(const Spot& a, const Spot& b) { return setOf(a.floor) == setOf(b.floor); }
  bool leads(const Spot& a, const Spot& b);
  void joinSteps(const Spot& a, const Spot& b);
  int numberOf(int floor) {
    return numbers_.emplace(floor, static_cast<int>(numbers_.size())).first->second;
  }
  int setOf(int floor) { return sets_.find(numberOf(floor)); }
  Eigen::Vector3d nearest(const std::vector<bool>& sets, const Eigen::Vector3d& p);

  const SceneGround& ground_;
  const GroundCells& cells_;
  const double climb_, drop_;  // highest steps up and down [m]
  const double steepest_;      // tangent
  double reach_;
  std::map<std::pair<int, double>, Feet> feet_;  // by square and height
  std::map<int, int> numbers_;                   // of floors, as they were met
  UnionFind sets_{0};                            // of these numbers
  std::set<std::pair<int, int>> one_way_;        // from number to number
  std::vector<Spot> edges_;    // where ground ends, or something is over or under it
  std::vector<Block> blocks_;  // kBlock squares by as many, x fastest
  int block_columns_ = 0;
};

std::optional<Spot> Reach::spotAt(const Eigen::Vector3d& p) const {
  const Eigen::Vector2i at = cells_.squareAt(p.head<2>());
  std::optional<Spot> best;
  double least = HUGE_VAL;
  for (int j = -kNearSquares; j <= kNearSquares; ++j) {
    for (int i = -kNearSquares; i <= kNearSquares; ++i) {
      eachOver(at + Eigen::Vector2i(i, j), [&](const Spot& spot) {
        const double off = std::abs(spot.height - p.z());
        const double distance = off + cells_.cell() * std::hypot(i, j);
        if (off > kSameFloor || distance >= least) return;
        least = distance;
        best = spot;
      });
    }
  }
  return best;
}

// By all triangles that a sole could feel there. Where they are level it stands on one of them
// (FootholdFinder); else it may be as steep as ground may be, unless all have nearly one height.
Feet Reach::feetOver(const Spot& spot) const {
  const Eigen::Vector2d p = cells_.middle(spot.square.x(), spot.square.y());
  const Eigen::AlignedBox2d box(p.array() - kSole, p.array() + kSole);
  bool level = true, flat = true;
  Eigen::AlignedBox1d levels(spot.height, spot.height);
  ground_.surfaces().visitBox(box, [&](int t) {
    if (!level && !flat) return;
    const Triangle3& corners = ground_.surfaces().triangles()[t];
    const auto within = heightsWithin(corners, box);
    if (!within) return;
    const double off = std::max(within->low - spot.height, spot.height - within->high);
    if (off > std::max(climb_, drop_) + kUnderSole) return;
    level = level && std::abs(upwardness(corners)) > 1.0 - Unevenness::kVertical;
    flat = flat && within->low >= spot.height - kFlat && within->high <= spot.height + kFlat;
    if (off <= kOfSpot) levels.extend(Eigen::AlignedBox1d(within->low, within->high));
  });
  if (level) return {levels, 0.0};
  return {{spot.height - 0.5 * kLevel, spot.height + 0.5 * kLevel}, flat ? 0.0 : steepest_};
}

const Feet& Reach::feetOn(const Spot& spot) {
  const int square = spot.square.y() * cells_.columns() + spot.square.x();
  const auto [known, is_new] = feet_.try_emplace({square, spot.height});
  if (is_new) known->second = feetOver(spot);
  return known->second;
}

// A step from a to b: its height is what the mean of the slopes under both feet does not explain
// (stepHeight of steps/foot_state.h), each as steep as ground may be unless it is flat there.
bool Reach::leads(const Spot& a, const Spot& b) {
  const double way = cells_.cell() * (b.square - a.square).cast<double>().norm();
  if (way > reach_) return false;
  const double up = b.height - a.height, off = std::max(up - climb_, -up - drop_);
  if (off <= 0.0) return true;
  // Each foot may be anywhere over its square.
  const double farthest = way + 3.0 * cells_.cell();
  if (off > 2.0 * kOfSpot + steepest_ * farthest) return false;
  const Feet &from = feetOn(a), &to = feetOn(b);
  return std::max(to.heights.min()[0] - from.heights.max()[0] - climb_,
                  from.heights.min()[0] - to.heights.max()[0] - drop_) <=
         0.5 * (from.steepest + to.steepest) * farthest + kRounding;
}

// What is known of their floors, and what steps between the two add.
void Reach::joinSteps(const Spot& a, const Spot& b) {
  const std::pair there(numberOf(a.floor), numberOf(b.floor)), back(there.second, there.first);
  const bool leads_there = one_way_.contains(there) || leads(a, b);
  const bool leads_back = one_way_.contains(back) || leads(b, a);
  if (leads_there && leads_back)
    sets_.join(there.first, there.second);
  else if (leads_there || leads_back)
    one_way_.insert(leads_there ? there : back);
}

std::vector<bool> Reach::setsFrom(const Spot& spot, Way way) {
  std::map<int, std::vector<int>> next;  // of sets
  for (const auto& [from, to] : one_way_) {
    const int a = sets_.find(from), b = sets_.find(to);
    next[way == Way::kThere ? a : b].push_back(way == Way::kThere ? b : a);
  }
  std::vector<int> open = {setOf(spot.floor)};
  std::vector<bool> reached(numbers_.size(), false);
  reached[open.back()] = true;
  while (!open.empty()) {
    const int set = open.back();
    open.pop_back();
    for (const int other : next[set]) {
      if (!reached[other]) open.push_back(other);
      reached[other] = true;
    }
  }
  return reached;
}

// Whether the same floor goes on all around, with nothing over or under it: what is reached from
// there is reached from where it does not.
bool Reach::isInner(const Spot& spot) const {
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      const Eigen::Vector2i square = spot.square + Eigen::Vector2i(i, j);
      const auto spans = cells_.spans(square.x(), square.y());
      if (spans.size() != 1 || !spans.front().ground ||
          spotOf(square, spans.front()).floor != spot.floor)
        return false;
    }
  }
  return true;
}

void Reach::joinFloors() {
  for (int row = 0; row < cells_.rows(); ++row) {
    for (int column = 0; column < cells_.columns(); ++column) {
      if (cells_.isPlainAround(column, row)) continue;
      eachOver({column, row}, [&](const Spot& spot) {
        numberOf(spot.floor);
        if (!isInner(spot)) edges_.push_back(spot);
      });
    }
  }
  sets_ = UnionFind(static_cast<int>(numbers_.size()));
  block_columns_ = (cells_.columns() + kBlock - 1) / kBlock;
  blocks_.resize(static_cast<size_t>(block_columns_) * ((cells_.rows() + kBlock - 1) / kBlock));
  for (const Spot& spot : edges_) joinAround(spot);
}

const Block& Reach::blockAt(const Eigen::Vector2i& at) {
  Block& block = blocks_[static_cast<size_t>(at.y()) * block_columns_ + at.x()];
  if (std::exchange(block.known, true)) return block;
  for (int j = 0; j < kBlock; ++j) {
    for (int i = 0; i < kBlock; ++i) {
      eachOver(kBlock * at + Eigen::Vector2i(i, j), [&](const Spot& spot) {
        block.several = block.several || block.floor.value_or(spot.floor) != spot.floor;
        block.floor = spot.floor;
        block.low = std::min(block.low, spot.height);
        block.high = std::max(block.high, spot.height);
      });
    }
  }
  return block;
}

// False of what is joined to the spot already, or too high over it or too far below.
bool Reach::mayJoin(const Spot& spot, const Block& block) {
  if (!block.floor || (!block.several && setOf(*block.floor) == setOf(spot.floor))) return false;
  const double off = std::max(block.low - spot.height, spot.height - block.high);
  const double most = steepest_ * (reach_ + 3.0 * cells_.cell());
  return off <= std::max(climb_, drop_) + 2.0 * kOfSpot + most;
}

void Reach::joinAround(const Spot& spot) {
  const int far = static_cast<int>(std::ceil(reach_ / cells_.cell()));
  const Eigen::Vector2i low = (spot.square.array() - far).max(0);
  const Eigen::Vector2i high =
      (spot.square.array() + far).min(Eigen::Array2i(cells_.columns(), cells_.rows()) - 1);
  for (int row = low.y() / kBlock; row <= high.y() / kBlock; ++row) {
    for (int column = low.x() / kBlock; column <= high.x() / kBlock; ++column) {
      if (!mayJoin(spot, blockAt({column, row}))) continue;
      for (int y = std::max(low.y(), kBlock * row);
           y <= std::min(high.y(), kBlock * row + kBlock - 1); ++y) {
        for (int x = std::max(low.x(), kBlock * column);
             x <= std::min(high.x(), kBlock * column + kBlock - 1); ++x) {
          eachOver({x, y}, [&](const Spot& other) {
            if (other.floor != spot.floor && !joins(spot, other)) joinSteps(spot, other);
          });
        }
      }
    }
  }
}

Eigen::Vector3d Reach::nearest(const std::vector<bool>& sets, const Eigen::Vector3d& p) {
  Eigen::Vector3d best = p;
  double least = HUGE_VAL;
  for (const Spot& spot : edges_) {
    if (!has(sets, spot)) continue;
    const double distance = (middle(spot) - p).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best = middle(spot);
  }
  return best;
}

GroundGap Reach::gap(const Spot& from, const Spot& to) {
  const std::vector<bool> reached = setsFrom(from, Way::kThere), lead = setsFrom(to, Way::kBack);
  GroundGap gap{middle(from), middle(to)};
  for (int i = 0; i < kSweepsOfNearest; ++i) {
    gap.near = nearest(reached, gap.far);
    gap.far = nearest(lead, gap.near);
  }
  return gap;
}

}  // namespace

std::optional<GroundGap> findGap(const SceneGround& ground, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to, double longest_step) {
  if (ground.cells().columns() == 0) return std::nullopt;
  Reach reach(ground, longest_step);
  const auto begin = reach.spotAt(from), end = reach.spotAt(to);
  if (!begin || !end || begin->floor == end->floor) return std::nullopt;
  reach.joinFloors();
  if (!reach.isMet(*begin) || !reach.isMet(*end)) return std::nullopt;
  if (reach.has(reach.setsFrom(*begin, Reach::Way::kThere), *end)) return std::nullopt;
  return reach.gap(*begin, *end);
}

ReachedGround::ReachedGround(const SceneGround& ground, const Eigen::Vector3d& from,
                             double longest_step)
    : cells_(ground.cells()) {
  if (ground.isLevel() || ground.cells().columns() == 0) return;
  const auto reach = std::make_shared<Reach>(ground, longest_step);
  const auto spot = reach->spotAt(from);
  if (!spot) return;
  reach->joinFloors();
  if (!reach->isMet(*spot)) return;
  is_apart_ = [reach, reached = reach->setsFrom(*spot, Reach::Way::kThere)](
                  int column, int row, const GroundCells::Span& span) {
    const Spot there = reach->spotOf({column, row}, span);
    return reach->isMet(there) && !reach->has(reached, there);
  };
}

bool ReachedGround::has(int column, int row, const GroundCells::Span& span) const {
  return !is_apart_ || !is_apart_(column, row, span);
}

std::vector<Eigen::AlignedBox1d> ReachedGround::heights() const {
  std::vector<Eigen::AlignedBox1d> all(static_cast<size_t>(cells_.columns()) * cells_.rows());
  for (int row = 0; row < cells_.rows(); ++row) {
    for (int column = 0; column < cells_.columns(); ++column) {
      for (const GroundCells::Span& span : cells_.spans(column, row)) {
        if (span.ground && has(column, row, span))
          all[static_cast<size_t>(row) * cells_.columns() + column].extend(
              Eigen::AlignedBox1d::VectorType(span.height));
      }
    }
  }
  return all;
}

}  // namespace amble
