/// Whether one of the balls that a body holds wherever it walks (BodyReach) is shut off: a flood
/// over squares, from both ends in turn.
///
/// First whatever is nearest to the other end goes on: where the two meet nothing is shut, and they
/// have met after few squares where there is a way. What they found of squares is kept; only of one
/// that is shut off all is flooded evenly, square after square as they were reached, so that what
/// is told of it lies in the middle.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "environments/collision/collision_world.h"
#include "environments/ground/ground_cells.h"
#include "planner/steering/body_reach.h"
#include "planner/steering/edge_reach.h"
#include "planner/steering/ground_chords.h"
#include "planner/steering/ground_range.h"
#include "planner/steering/near_ground.h"

namespace amble {

/// What the floods of all balls ask of the ground.
struct FloodGround {
  /// @param stature  [m, > 0]; @param longest_step  [m, > 0]; @param high  of all balls over the
  /// ground [m]
  /// @param beyond  how far the flood may leave the ground [m, >= 0] @pre both outlive it
  FloodGround(const SceneGround& ground, const ReachedGround& reached, double stature,
              double longest_step, double high, double beyond);
  const NearGround& near(const BodyReach::Ball& ball) const {
    return ball.post ? near_post : ball.beyond < BodyReach::kBeyond ? near_legs : near_body;
  }

  GroundRange range;
  GroundChords chords;
  NearGround near_body, near_legs, near_post;
  EdgeReach edges;
};

class BallFlood {
 public:
  using Ball = BodyReach::Ball;
  using Barrier = BodyReach::Barrier;

  /// @param square  side [m, > 0]; @param from, to  on the ground [m, World]
  /// @pre all that is given as a reference outlives it
  BallFlood(const Ball& ball, double square, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
            const CollisionWorld& world, const SceneGround& ground, const FloodGround& around,
            double beyond, CollisionScratch& scratch);

  /// Whether start and goal are in different parts; no where it is stopped.
  bool isShut(const std::function<bool()>& stopped);
  Barrier barrier();  ///< @pre isShut

 private:
  // What is known of a square: reached from an end, 1 and 2, or only seen on the way from it.
  static constexpr std::uint8_t kUnknown = 0, kShut = 3, kFar = 4, kSeen = 5;
  static constexpr int kNothing = -1, kNoGround = -2;  // in place of objects

  Eigen::Vector2d middle(int square) const {
    return min_ + square_ * Eigen::Vector2d(square % count_.x() + 0.5, square / count_.x() + 0.5);
  }
  double detour(int square) const {
    const Eigen::Vector2d p = middle(square);
    return (p - from_.head<2>()).norm() + (p - to_.head<2>()).norm();
  }
  int touched(const Eigen::Vector2d& p, double low, double high, double radius) const {
    return world_.touched({p.x(), p.y(), low}, {p.x(), p.y(), high}, radius, scratch_);
  }
  int touchedAtAll(const Eigen::Vector2d& p, double low, double high, double radius) const;
  Eigen::AlignedBox1d carried(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet);
  int touchedOnUneven(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet, double radius);
  int touchedByFoot(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet, double radius) const;
  bool isTooHigh(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet) const;
  int touchedByStack(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet) const;
  int object(const Eigen::Vector2d& p);
  int thing(const Eigen::Vector2d& p);
  std::uint8_t look(int square, std::uint8_t if_open);
  template <typename Visit>
  bool anyAround(int square, Visit visit) const;
  template <typename Visit>
  bool anyBeside(const Eigen::Vector3d& end, Visit visit) const;
  std::optional<bool> meets(const std::function<bool()>& stopped);
  std::vector<int> wayOut(bool over_ground);
  Barrier between(std::vector<int> way);
  bool reach(int square, int side);
  bool spread(int square, int side);
  bool flood(int side, size_t most);

  const Ball& ball_;
  const FloodGround& around_;
  const SceneGround& ground_;
  const GroundCells& cells_;
  const double square_;  // side [m]
  const Eigen::Vector3d from_, to_;
  const CollisionWorld& world_;
  CollisionScratch& scratch_;
  Eigen::Vector2d min_{0, 0};
  Eigen::Vector2i count_{0, 0};
  std::vector<std::uint8_t> reached_;        // by square
  std::array<std::vector<int>, 2> squares_;  // reached from each end, in order
  std::array<size_t, 2> next_ = {0, 0};      // of them whose neighbours are to be looked at
  std::map<std::pair<int, int>, Eigen::AlignedBox1d> chords_;  // by square of the cells
};

}  // namespace amble
