/// A job: which walks a batch is of, as a YAML file says it (docs/batch.md).
///
/// Along each axis there are values; the walks are their product, in the order of the axes below,
/// or a seeded sample of it. In the file: metres, seconds, degrees. Here: metres, seconds, radians.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace amble {

/// Values of an axis: these, or whatever lies between two.
struct BatchNumbers {
  std::vector<double> values;
  std::optional<std::pair<double, double>> range;  ///< samples are drawn of it; no values then
  int line = 0;                                    ///< in the file; 0: it is left to its default
};

/// From where to where.
struct BatchWay {
  std::string name;
  Place start, goal;
  std::vector<Place> via;
  int line = 0;
};

struct BatchScene {
  std::filesystem::path file;
  std::string name;  ///< the path as the job has it, which is relative to the job
  int line = 0;
  std::vector<BatchWay> ways;  ///< of this scene alone
  std::optional<Bounds> bounds;
};

/// Starts and goals that are drawn in every scene: free, and on ground that leads to one another.
struct BatchDraw {
  int count = 0;                   ///< of ways in a scene [>= 0]
  double least = 2.0, most = 1e5;  ///< from start to goal as the crow flies [m, 0 <= least <= most]
};

enum class BatchRoadmap {
  kEach,   ///< every walk is planned from nothing, as `amble plan` does it
  kShared  ///< one of each walker in each scene, which its walks ask first: for many ways of few
};

struct BatchJob {
  std::filesystem::path file;
  std::vector<BatchScene> scenes;
  // Axes, in the order of the product.
  std::vector<std::string> libraries = {"default"};  ///< `default`, or a path that stands alone
  BatchNumbers heights = {{0.0}, {}, 0};             ///< [m, 0.5 to 2.5]; 0: the library's own
  BatchNumbers speeds = {{0.0}, {}, 0};              ///< [m/s, 0.3 to 2]; 0: 1.2, or a style's own
  std::vector<std::string> styles = {""};
  std::vector<std::vector<std::string>> actions = {{}};
  BatchDraw draw;
  std::vector<std::uint64_t> seeds = {1};
  int sample = 0;          ///< so many of the product [>= 0]; 0: all
  std::uint64_t seed = 1;  ///< of the sample and of drawn ways

  GroundLimits limits;
  WalkSpec walk;  ///< comfort and how walks begin and end; the rest is along the axes
  PlannerSpec planner;
  BatchRoadmap roadmap = BatchRoadmap::kEach;
  double fps = 60.0;  ///< [1/s, 24 to 240]
  std::vector<std::string> formats = {"bvh", "json", "labels"};

  std::map<std::string, int> lines;  ///< where axes stood, by their keys

  /// Of the heights, for whom ways are drawn [m]; 0 where none is said.
  double tallest() const;
};

/// @param formats  that may be asked for beside "labels", by name
/// @throws InputError with file and line
BatchJob readBatchJob(const std::filesystem::path& file, const std::vector<std::string>& formats);

/// The time after which a walk that says none is given up [s]: results are to depend on counts.
inline constexpr double kBatchTimeLimit = 86400.0;

}  // namespace amble
