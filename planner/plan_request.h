/// What planWalk is asked and what it answers.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "animation/synthesis/walk_synthesizer.h"
#include "environments/collision/collision_world.h"
#include "environments/ground/scene_ground.h"
#include "planner/search_limits.h"

namespace amble {

/// Where a walk starts, ends or passes.
struct PlanEnd {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< on the ground [m, World]
  std::optional<double> heading;                       ///< any where there is none [rad]
  bool standing = true;                                ///< else walking, at the plan's speed
};

struct RefineSettings {
  bool walk_on = true;  ///< false: pass 1 only
  int tries = 50;       ///< a round of pass 4 [>= 0]; by trial
};

struct PlanRequest {
  const WalkSynthesizer* synthesizer = nullptr;  ///< these three are needed and outlive the call
  const CollisionWorld* world = nullptr;
  const SceneGround* ground = nullptr;
  Eigen::AlignedBox2d bounds;  ///< where to look; widened to hold start, goal and via [m]
  /// What root paths may not leave; nothing where there is none [m]. @pre start, goal and via lie
  /// in it
  std::optional<Eigen::AlignedBox2d> within;
  PlanEnd start, goal;
  std::vector<Eigen::Vector3d> via;    ///< passed in order, by any heading [m, World]
  std::string planner = "visibility";  ///< of planners()
  SearchLimits limits;                 ///< seed, max_failures, threads, deadline, stop, progress
  RefineSettings refine;
  /// Distance to things within which walks cost more: they keep away where that costs little [m,
  /// >= 0].
  double comfort = 0.05;
};

enum class PlanStatus { kSolved, kNoWalk, kStartBlocked, kGoalBlocked };

/// What is exported, as it was checked.
struct Walk {
  RootPath path;  ///< of all edges; turns on the spot have no length
  AnimationBuffer buffer;
  std::vector<Stance> stances;  ///< nodes of the walk, start and goal included
};

/// What most often stood in the way.
struct Obstruction {
  /// What is missing there, and `width` and `needed` are of.
  enum class Lack {
    kUnknown,   ///< it was not measured, or nothing would do
    kGap,       ///< breadth, between `object` and `other`
    kHeadroom,  ///< height, below `object`
    kStep,      ///< `object`, or a step of it, is too high; `needed` is the most that would do
    kDrop,      ///< the same, to step down from `object`
    kGround,    ///< the ground has a break; the same
    kTread,     ///< depth of a step, for a sole
    kSlope,     ///< `object` is too steep: `slope` and `max_slope`
    kDistance,  ///< of an end from `object`
  };
  WalkRule rule = WalkRule::kNone;
  Lack lack = Lack::kUnknown;
  std::string part;     ///< of the body; empty where no contact refused
  std::string object;   ///< of the scene, by name; empty where no contact refused
  std::string other;    ///< beside `object`: the passage is between the two; empty where it is none
  double gap = 0.0;     ///< least distance that was proved there [m, >= 0]
  long long count = 0;  ///< how often [>= 1]
  std::optional<double> width, needed;     ///< what there is, and what would do [m, >= 0]
  std::optional<double> slope, max_slope;  ///< the same of a slope [rad]
  std::optional<double> speed;             ///< of the walk that needs it, where that matters [m/s]
  /// How deep the refused walk that came nearest to passing has `part` in `object` [m, >= 0].
  std::optional<double> overlap;
  std::optional<Eigen::Vector3d> free;  ///< of a blocked end: the nearest place that would do
  std::optional<int> via;               ///< of a blocked via point: which [>= 0]
  /// Where it happened: the part that touched, or where a walk was to begin [m, World].
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  /// The ground under the body there, and its heading; of what did not touch, where the walk was to
  /// end [m, World], [rad].
  Eigen::Vector3d body = Eigen::Vector3d::Zero();
  double heading = 0.0;
};

/// Guards and connectors are the visibility PRM's; terminals are ends of a query that can only be
/// left or only be entered (a free heading, or a stance that walks); samples are the nodes of other
/// roadmaps.
enum class NodeKind { kGuard, kConnector, kTerminal, kSample };

/// The roadmap as it was when the search ended.
struct RoadmapPicture {
  struct Node {
    Stance stance;
    NodeKind kind = NodeKind::kSample;
    bool any_heading = false;  ///< edges choose the heading (an end of a query without one)
    bool any_leading = true;   ///< edges that end here walking choose the foot in front
  };
  struct Edge {
    int from = -1;
    int to = -1;
    std::vector<Eigen::Vector2d> line;  ///< its root path [m]; empty where it only turns
  };
  /// An edge that steering refused. Its ends need be no nodes: a sample that sees what is there
  /// already is thrown away.
  struct Refused {
    Node from, to;
    WalkRule rule = WalkRule::kNone;
    int part = -1;    ///< of the body, where a contact refused
    int object = -1;  ///< of the scene, the same
    /// Where: the part that touched; else where the walk was to begin [m, World].
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
  };
  /// More of them say no more to the eye.
  static constexpr int kMostRefused = 200;

  std::vector<Node> nodes;
  std::vector<Edge> edges;  ///< directed
  /// Of what was refused, in the order in which it was asked: without a walk those nearest to the
  /// place that stood in the way, else each so-and-so-many-th; at most kMostRefused.
  std::vector<Refused> refused;
};

/// How far one gets from the start of the leg that is not walked, by a map of the room that the
/// body has (ClearanceMap): the ground under its root. Up to the narrow place that no edge was
/// found through, or, where the map knows of none, to the place that stood in the way.
struct ReachedRegion {
  /// Of the ground, straight along World x: its middle line, on the ground [m, World].
  struct Strip {
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
  };
  double breadth = 0.0;  ///< of strips, along World y; they end half of it beyond `to` [m, > 0]
  std::vector<Strip> strips;  ///< by y, then x, then height; no two overlap
  /// Where it comes nearest, in plan, to where one gets to the goal from, and that place [m,
  /// World].
  Eigen::Vector3d near = Eigen::Vector3d::Zero(), far = Eigen::Vector3d::Zero();
};

struct PlanTimes {
  double roadmap = 0.0;  ///< growing it, or a tree [s]
  double search = 0.0;   ///< whether ground leads there; the shortest walk on it, as edges
  double refine = 0.0;   ///< refinement, animation and the last check
};

struct PlanOutcome {
  PlanStatus status = PlanStatus::kNoWalk;
  Walk walk;  ///< where solved
  std::optional<Obstruction>
      why;              ///< where not; none where nothing was ever refused (it was stopped)
  bool proved = false;  ///< where not: no walk exists at all; else none was found
  std::optional<ReachedRegion> reached;  ///< where not, if one stands at the start
  RoadmapPicture roadmap;
  int guards = 0;
  int connectors = 0;
  int edges = 0;
  long long samples = 0;
  double coverage = 0.0;  ///< estimated share of the free space that guards cover [0 to 1]
  std::map<WalkRule, long long> refusals;
  long long poses_checked = 0;  ///< frames handed to the collision check
  bool time_limit_hit = false;  ///< the deadline ended the search or the refinement
  bool stopped = false;         ///< it was told to stop
  PlanTimes times;
};

}  // namespace amble
