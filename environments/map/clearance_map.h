/// A map of the room that a walking body has, over every layer of the ground: where a way may lead,
/// and how near to things.
///
/// What is beside a body matters at heights of its own: legs pass between seats that arms swing
/// over. So the body is given as bands of height over the ground, each with its breadth to either
/// side of the path. In each band what lies over a cell is an obstacle of that cell; where the
/// ground ends is one of the lowest. `spare` of a place is the least, over all obstacles, of the
/// distance in plan less the breadth of the body in the obstacle's band: a walk by that place may
/// stray so far to its sides. What is lower than the first band over the ground is stepped over.
///
/// A guide for the search, which proves nothing: cells are 5 cm, distances are of their middles,
/// and bodies sway. Distances spread from obstacle cells to their neighbours, each of which knows
/// the obstacle that is nearest to it (P.-E. Danielsson, "Euclidean distance mapping", Computer
/// Graphics and Image Processing 14, 1980), over ground that steps join (ClearanceStrip). Cost:
/// linear in places, and in the cells that obstacles lie over.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "environments/ground/scene_ground.h"

namespace amble {

class ClearanceMap {
 public:
  /// How far the body reaches at some heights.
  struct Band {
    double low = 0.0, high = 0.0;  ///< over the ground [m, low < high]
    double half_breadth = 0.0;     ///< from the path to either side [m, >= 0]
  };
  /// Of the body: what beside its feet is in the way, from the lowest on, and how far its feet are
  /// from the path.
  struct Breadth {
    std::vector<Band> bands;  ///< at most kMostBands
    double feet = 0.0;        ///< [m, >= 0]
  };

  static constexpr int kMostBands = 100;
  static constexpr double kFarthest = 0.5;  ///< more room is not told apart [m]
  static constexpr double kCell = 0.05;     ///< [m]
  /// Coarser ones where there would be more: beyond 210 x 210 m.
  static constexpr double kMostCells = 18e6;

  /// Of the ground within `bounds`. @param stopped  asked now and then, by any thread: where it
  /// says so the map is left empty. @param threads  that make it; it is the same for any number [>=
  /// 1]
  /// @throws std::invalid_argument for more bands than kMostBands
  ClearanceMap(
      const SceneGround& ground, const Eigen::AlignedBox2d& bounds, const Breadth& body,
      const std::function<bool()>& stopped = [] { return false; }, int threads = 1);

  /// Places are numbered from 0.
  int size() const { return static_cast<int>(places_.size()); }
  double cell() const { return cell_; }  ///< [m, > 0]
  Eigen::Vector3d at(int place) const {
    const Eigen::Vector2i cell = cellOf(place);
    return {middle(0, cell.x()), middle(1, cell.y()), places_[place].height};
  }
  double height(int place) const { return places_[place].height; }  ///< [m, World]
  /// Cells along x and y, and those over which a place is, from 0 on.
  Eigen::Vector2i cells() const { return count_; }
  Eigen::Vector2i cellOf(int place) const {
    return {cell_of_[place] % count_.x(), cell_of_[place] / count_.x()};
  }
  /// Where the middle of a column (axis 0) or row (axis 1) of cells is along that axis [m, World].
  double middle(int axis, int cell) const { return min_[axis] + cell_ * (cell + 0.5); }
  /// Room to either side, at most kFarthest; negative where the body does not fit [m].
  double spare(int place) const { return places_[place].spare; }
  /// Of the body's bands that of least breadth: with so much less than none something is in one of
  /// them right over the place, or as little room is beside it in another [m, >= 0].
  double leastBreadth() const {
    const auto least = std::ranges::min_element(body_.bands, {}, &Band::half_breadth);
    return least == body_.bands.end() ? 0.0 : least->half_breadth;
  }
  /// The place beside one, `dx` and `dy` cells on, to which a step leads [-1 to 1 each]; -1: none.
  int beside(int place, int dx, int dy) const {
    const int cell = cell_of_[place] + dy * count_.x() + dx;
    int best = -1;
    float least = static_cast<float>(step_);
    for (int i = start_[cell]; i < start_[cell + 1]; ++i) {
      const float rise = std::abs(places_[i].height - places_[place].height);
      if (rise > least) continue;
      least = rise;
      best = i;
    }
    return best;
  }
  /// Has the memory fetched that beside() reads of a place. @return a place of each row there, or
  /// the end of all, by which whoever knows more of places may have that fetched
  std::array<int, 3> fetch(int place) const {
    std::array<int, 3> rows;
    for (int row = 0; row < 3; ++row) {
      rows[row] = start_[cell_of_[place] + (row - 1) * count_.x()];
      __builtin_prefetch(places_.data() + rows[row]);
    }
    return rows;
  }
  /// That which somebody stands on at p, or the nearest to it within a few cells; -1: none.
  int placeAt(const Eigen::Vector3d& p) const;

 private:
  friend class ClearanceStrip;

  struct Place {
    float height, spare;  // [m]
  };
  // The same of some rows, with where the places of each of their cells end.
  struct Rows {
    std::vector<int> cell_of, end;
    std::vector<Place> places;
  };

  // False where they are stopped.
  bool layPlaces(const SceneGround& ground, const Eigen::AlignedBox2d& bounds, int threads,
                 const std::function<bool()>& stopped);
  bool layRows(const GroundCells& squares, int begin, int end, const std::function<bool()>& stopped,
               Rows& rows) const;
  void append(Rows rows);
  // Where the i-th of so many blocks of rows begins.
  int rowsBefore(int i, int blocks) const {
    return static_cast<int>(static_cast<long long>(count_.y()) * i / blocks);
  }
  int firstOfRow(int row) const { return start_[static_cast<size_t>(row) * count_.x()]; }
  bool measure(const SceneGround& ground, int threads, const std::function<bool()>& stopped);

  Breadth body_;
  Eigen::Vector2d min_{0, 0};
  Eigen::Vector2i count_{0, 0};  // cells; those at the rim have no places
  double cell_ = kCell;
  double step_ = 0.0;         // highest [m]
  std::vector<int> start_;    // of each cell's places, lowest first; x fastest; and the end
  std::vector<int> cell_of_;  // by place
  std::vector<Place> places_;
};

}  // namespace amble
