/// The report of a run: what a machine needs to know of a walk, or of why there is none (DESIGN.md,
/// section 5).
///
/// Lengths in metres, angles in radians here and in degrees in JSON.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/body/step_measure.h"
#include "animation/quality/walk_quality.h"
#include "environments/body/body.h"
#include "scenarios/scenario.h"

namespace amble {

struct ClearanceReport {
  double min = 0.0;  ///< to everything but the ground that soles stand on [m]
  std::string part;  ///< of the body; empty where nothing was near
  std::string object;
  double time = 0.0;  ///< [s]
};

struct RoadmapReport {
  int guards = 0, connectors = 0, edges = 0;
  long long samples = 0;
  /// Estimated share of free space, 1 - 1/M when the search stopped by failures [0 to 1].
  double coverage = 0.0;
  int refused = 0;  ///< edges that were refused, of which pictures and pages tell
};

/// How far one gets where there is no walk, by a map.
struct ReachedReport {
  double area = 0.0;  ///< of ground, in plan [m^2]
  /// Where it comes nearest to where one gets to the goal from, and that place [m, World].
  Eigen::Vector3d near = Eigen::Vector3d::Zero(), far = Eigen::Vector3d::Zero();
};

/// What loading is made of, in its order [s]: the scene and its mesh files; the motion library;
/// what of the scene is ground; the character with its gaits; what a body is checked against.
struct LoadTimes {
  double scene = 0.0, library = 0.0, ground = 0.0, character = 0.0, collision = 0.0;
};

/// Seconds by the clock: the only part that differs from run to run.
struct RunTimes {
  double load = 0.0;  ///< all of it, with the hashes of the inputs
  LoadTimes loading;
  double roadmap = 0.0, search = 0.0, refine = 0.0, export_ = 0.0;

  double planning() const { return roadmap + search + refine; }
};

struct Report {
  PlanStatus status = PlanStatus::kNoWalk;
  std::string scenario;
  std::uint64_t seed = 1;
  std::string planner;
  /// "time_limit" or "interrupt" where that ended loading, search or refinement; else empty, and
  /// the result is the counted one.
  std::string stopped_by;
  double length = 0.0;    ///< of the root path [m]
  double duration = 0.0;  ///< [s]
  int frames = 0;
  double frame_time = 0.0;           ///< [s]
  std::vector<StepMeasure> steps;    ///< the placings, and the swings that led to them
  double goal_position_error = 0.0;  ///< [m]
  double goal_heading_error = 0.0;   ///< 0 where any heading was right [rad]
  ClearanceReport clearance;
  double foot_skate_mean = 0.0, foot_skate_max = 0.0;  ///< of the placings' slides [m]
  double ground_penetration = 0.0;  ///< largest depth of a sole's underside under the ground [m]
  RoadmapReport roadmap;
  std::map<std::string, long long> refusals;  ///< by rule
  long long poses_checked = 0;
  RunTimes times;
  std::map<std::string, std::string>
      inputs;  ///< file, relative to the scenario's folder, and its SHA-256
  std::string version;
  double bvh_unit = 1.0;  ///< length of the BVH's unit [m]
  double stature = 0.0;   ///< [m]
  std::vector<BodyPart> body;
  std::vector<std::string> joint_names;    ///< as the BVH has them, by joint
  std::vector<QualityLine> quality;        ///< empty without a walk
  std::string why;                         ///< without a walk: what most often stood in the way
  std::optional<Obstruction> obstruction;  ///< the same for machines; none where nothing was tried
  bool proved = false;                     ///< without a walk: none exists; else none was found
  std::optional<ReachedReport> reached;    ///< without a walk, where it is known
};

/// Indented JSON with the fields of DESIGN.md, `times` last. Numbers are the shortest that read
/// back the same, of values rounded to a nanometre: the same report gives the same bytes.
/// @param with_times  false leaves out all that the clock says, so that the same walk gives them
void writeJson(std::ostream& out, const Report& report, bool with_times = true);

}  // namespace amble
