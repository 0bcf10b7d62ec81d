/// A scenario: one problem, as a YAML file says it (DESIGN.md, section 5).
///
/// In the file: metres, seconds, degrees. Here: metres, seconds, radians, World.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/rotation.h"
#include "base/strict_yaml.h"
#include "planner/plan_walk.h"

namespace amble {

/// Where to be, and facing where.
struct Place {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< [m]
  std::optional<double> z;        ///< stands on the floor within kFloorReach of it [m]
  std::optional<double> heading;  ///< [rad]; none: any
  int line = 0;                   ///< of `at` in the file, for messages
};

/// How far from a place's z its floor may lie [m].
inline constexpr double kFloorReach = 0.3;

struct CharacterSpec {
  double height = 0.0;                ///< stature [m, 0.5 to 2.5]; 0: the library's own
  std::string library = "default";    ///< `default`, or a path that stands on its own
  int library_line = 0;               ///< where the file names it; 0: it does not
  double max_slope = 20.0 * kDegree;  ///< [rad, 0 to 45 degrees]
  double max_climb = 0.25;            ///< highest step up [m, 0 to 1]
  double max_drop = 0.25;             ///< highest step down [m, 0 to 1]
};

struct WalkSpec {
  double speed = 1.2;         ///< on the straight [m/s, 0.3 to 2]
  bool from_standing = true;  ///< `from: stand`; else the walk begins in mid-walk
  bool to_standing = true;
  /// Movements and postures of the library that are held for the whole walk, and the lines that
  /// name them.
  std::vector<std::pair<std::string, int>> actions;
};

struct PlannerSpec {
  std::string name = "visibility";
  int name_line = 0;         ///< where the file names it; 0: it does not
  std::uint64_t seed = 1;    ///< [0 to 2^31 - 1]
  int max_failures = 500;    ///< the visibility PRM's M [1 to 1,000,000]
  double time_limit = 60.0;  ///< [s, > 0, at most a day]
};

struct Bounds {
  Eigen::Vector2d min, max;  ///< [m]
};

/// "solved", "no_walk", "start_blocked", "goal_blocked", as files and reports write it.
std::string statusName(PlanStatus status);

/// What `amble check` compares with; what is not there is not judged.
struct Expectation {
  std::optional<PlanStatus> status;
  std::optional<double> max_length;         ///< [m, > 0]
  std::optional<double> min_clearance;      ///< [m, >= 0]
  std::optional<double> max_foot_skate;     ///< largest slide of a planted foot [m, >= 0]
  std::optional<double> max_planning_time;  ///< [s, > 0]
  std::optional<std::string> bvh_sha256;    ///< 64 lower-case hexadecimal digits
};

struct Scenario {
  std::string name;  ///< the file's, without folder and extension
  std::filesystem::path file;
  std::string sha256;  ///< of the file as it was read; empty where a text was given
  std::filesystem::path scene;
  int scene_line = 0;
  CharacterSpec character;
  Place start, goal;
  std::vector<Place> via;  ///< in order
  std::optional<Bounds> bounds;
  WalkSpec walk;
  PlannerSpec planner;
  std::optional<Expectation> expect;
};

/// @param file  `-` is standard input. @throws InputError as DESIGN.md, section 5, asks.
Scenario readScenario(const std::filesystem::path& file);
/// The same from a text that was read already.
Scenario readScenario(const YamlNode& root);

/// Whether a YAML file is a scenario: a map with `scene:` and `start:`. Other files are passed over
/// by `amble check`, so a broken one is none here unless a line of it begins with `scene:` and
/// another with `start:`.
bool isScenario(const std::filesystem::path& file);

}  // namespace amble
