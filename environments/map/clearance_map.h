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
/// Graphics and Image Processing 14, 1980), over ground that steps join. Cost: linear in places,
/// and in the cells that obstacles lie over.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "environments/ground/scene_ground.h"
#include "environments/scene/triangle_grid.h"

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

  /// Of the ground within `bounds`. @param stopped  asked now and then: where it says so the map is
  /// left empty. @throws std::invalid_argument for more bands than kMostBands
  ClearanceMap(
      const SceneGround& ground, const Eigen::AlignedBox2d& bounds, const Breadth& body,
      const std::function<bool()>& stopped = [] { return false; });

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
  /// That which somebody stands on at p, or the nearest to it within a few cells; -1: none.
  int placeAt(const Eigen::Vector3d& p) const;

 private:
  // What a place's spare room is measured to: so many cells away.
  struct Source {
    std::int16_t dx = 0, dy = 0;
    std::int8_t band = kFeet;  // of the body; kMostBands fit
    bool waits = false;        // the place is in the queue
  };
  static constexpr int kFeet = -1;

  // False where they are stopped.
  bool layPlaces(const SceneGround& ground, const Eigen::AlignedBox2d& bounds,
                 const std::function<bool()>& stopped);
  bool markObstacles(const SceneGround& ground, const std::function<bool()>& stopped);
  bool spread(const std::function<bool()>& stopped);
  void fetchAhead(size_t next) const;
  void markEdges();
  void markTriangle(const Triangle3& t);
  // Heights of something, and of the first bands those that it is in at some place of all, and at
  // every place.
  struct Between {
    double low, high;     // [m]
    bool others = false;  // whether there are more bands
    std::uint8_t at_some = 0, at_all = 0;
  };
  Between between(double low, double high) const;
  bool isNewsTo(const Eigen::Vector2i& cell, const Between& heights);
  bool mayBeNews(const Triangle3& t, const Between& heights);
  Eigen::Vector2i cellAt(const Eigen::Vector2d& p) const;
  void markColumn(const Eigen::Vector2i& at, double low, double high);
  template <typename Visit>
  bool anyOver(const Eigen::Vector2i& at, double low, double high, Visit visit) const;
  void measureDistances();
  double spareFrom(const Source& source) const;
  bool isNews(int place, double spare) const;
  void see(int place, const Source& source);

  Breadth body_;
  Eigen::Vector2d min_{0, 0};
  Eigen::Vector2i count_{0, 0};  // cells; those at the rim have no places
  double cell_ = kCell;
  double step_ = 0.0;         // highest [m]
  std::vector<int> start_;    // of each cell's places, lowest first; x fastest; and the end
  std::vector<int> cell_of_;  // by place
  struct Place {
    float height, spare;  // [m]
  };
  std::vector<Place> places_;
  std::vector<Source> source_;  // by place, while the map is built
  // By cell, while the map is built: a bit for each of the first bands in which nothing over the
  // cell is news to any place any more.
  static constexpr int kBandsDone = 8;
  std::vector<std::uint8_t> done_;
  float lowest_ = HUGE_VALF, highest_ = -HUGE_VALF;  // of all places [m]
  std::vector<int> queue_;  // places that saw something nearer, while the map is built
  // To an obstacle so many cells away along x and y, while the map is built [m].
  std::vector<double> distance_;
  int far_ = 0;  // cells along a side of these
};

}  // namespace amble
