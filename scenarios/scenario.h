/// A scenario: one problem, as a YAML file says it (DESIGN.md, section 5).
///
/// In the file: metres, seconds, degrees. Here: metres, seconds, radians, World.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/rotation.h"
#include "planner/plan_walk.h"

namespace amble {

class YamlNode;

/// Where to be, and facing where.
struct Place {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< [m]
  std::optional<double> z;        ///< stands on the floor within kFloorReach of it [m]
  std::optional<double> heading;  ///< [rad]; none: any
};

struct CharacterSpec {
  double height = 0.0;              ///< stature [m, 0.5 to 2.5]; 0: the library's own
  std::string library = "default";  ///< `default`, or a path that stands on its own
  GroundLimits limits;              ///< `max_slope`, `max_climb`, `max_drop`
};

struct WalkSpec {
  double speed = 1.2;         ///< on the straight [m/s, 0.3 to 2]
  std::string style;          ///< in whose manner, of the library's (library_style.h), or ""
  bool own_speed = false;     ///< no speed is said: of a style its own, once the library is read
  double comfort = 0.05;      ///< things nearer than this cost, but forbid nothing [m, 0 to 0.5]
  bool from_standing = true;  ///< `from: stand`; else the walk begins in mid-walk
  bool to_standing = true;
  std::vector<std::string>
      actions;  ///< movements and postures of the library, held for the whole walk
};

struct PlannerSpec {
  std::string name = "visibility";
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

/// Where a scenario's values stood, for messages and reports.
struct ScenarioSource {
  std::filesystem::path file;        ///< `-` for standard input
  std::string sha256;                ///< of the file's bytes as they were read
  std::map<std::string, int> lines;  ///< by the value's path: "scene", "goal.at", "walk.actions[1]"

  /// @param key  of a value; one that the file leaves to its default has no line.
  [[noreturn]] void fail(const std::string& key, const std::string& problem,
                         const std::string& expected) const;
};

/// One of the walks that `queries:` asks for.
struct ScenarioQuery {
  std::string name;  ///< its folder's: unique, a single name without blanks
  Place start, goal;
  std::vector<Place> via = {};  ///< in order
};

struct Scenario {
  std::string name;  ///< the file's, without folder and extension
  ScenarioSource source;
  std::filesystem::path scene;
  CharacterSpec character;
  Place start, goal;                   ///< of the first query, where there are queries
  std::vector<Place> via;              ///< in order
  bool has_ends = true;                ///< false: a scene alone, of which a roadmap is made
  std::vector<ScenarioQuery> queries;  ///< in order; none: start, goal and via are what is asked
  std::optional<Bounds> bounds;
  WalkSpec walk;
  PlannerSpec planner;
  std::optional<Expectation> expect;
};

/// A file as it was read: a pipe can be read but once, and what is run is what is hashed.
struct ScenarioFile {
  std::filesystem::path file;
  std::string text;
  std::string unread = {};  ///< why a file of a folder could not be read; "" where it was
};

/// Larger files are no scenarios.
inline constexpr size_t kMaxScenario = size_t{1} << 20;  // [bytes]

/// @param file  `-` is standard input. @throws InputError if it cannot be read or is too large.
ScenarioFile readScenarioFile(const std::filesystem::path& file);

/// @throws InputError as DESIGN.md, section 5, asks, and for a file that is unread.
Scenario readScenario(const ScenarioFile& file);
/// Both at once.
Scenario readScenario(const std::filesystem::path& file);

/// Parts of it, for other files that hold such: {at, heading}, and a list of {at}. @throws
/// InputError
Place readPlace(const YamlNode& node, bool with_heading);
std::vector<Place> readVia(const YamlNode& node);

/// Whether it is a scenario: YAML with `scene:` and `start:` or `queries:`. Other files are passed
/// over by `amble check`, so one that is no such YAML is none here unless a line of it begins with
/// `scene:` and another with `start:` or `queries:`.
bool isScenario(const ScenarioFile& file);

}  // namespace amble
