#include "batch/labels/batch_statistics.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.h"
#include "base/statistics.h"

namespace amble {
namespace {

// 1, 2 or 5 times a power of ten, not less than `width`.
double roundWidth(double width) {
  const double power = std::pow(10.0, std::floor(std::log10(width)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= width) return factor * power;
  return 10.0 * power;
}

// Name and unit of each figure, and what it is of a walk; nothing of a walk that has none.
struct FigureKind {
  const char* name;
  const char* unit;
  std::optional<double> (*of)(const WalkRow& row);
};

std::optional<double> ratio(double what, double by) {
  return by > 0.0 ? std::optional<double>(what / by) : std::nullopt;
}

constexpr double kMinute = 60.0;  // [s]

const FigureKind kFigures[] = {
    {"length", "m", [](const WalkRow& row) { return std::optional(row.length); }},
    {"duration", "s", [](const WalkRow& row) { return std::optional(row.duration); }},
    {"mean speed", "m/s", [](const WalkRow& row) { return ratio(row.length, row.duration); }},
    {"steps", "", [](const WalkRow& row) { return std::optional<double>(row.steps); }},
    {"step length", "m", [](const WalkRow& row) { return ratio(row.length, row.steps); }},
    {"cadence", "1/min",
     [](const WalkRow& row) { return ratio(kMinute * row.steps, row.duration); }},
    {"clearance", "m", [](const WalkRow& row) { return std::optional(row.clearance); }},
    {"foot skate", "m", [](const WalkRow& row) { return std::optional(row.foot_skate); }},
    {"stature", "m", [](const WalkRow& row) { return std::optional(row.height); }}};

}  // namespace

Spread spreadOf(const Measure& measure) {
  const std::vector<double>& values = measure.values;
  const auto at = [&](double share) {
    return values[static_cast<size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
  };
  return {values.front(), at(0.1), median(values), at(0.9), values.back(), mean(values)};
}

Histogram histogramOf(const Measure& measure, int most) {
  Histogram histogram;
  if (measure.values.empty()) return histogram;
  const double least = measure.values.front(), greatest = measure.values.back();
  // Values that are all but the same are in one bin. Two bins more than the span fills, since the
  // first and the last begin and end at round numbers.
  constexpr double kLeastShare = 0.01, kLeastSpan = 1e-9;
  const double span = std::max({greatest - least, kLeastShare * std::abs(greatest), kLeastSpan});
  histogram.width = roundWidth(span / (most - 2));
  if (measure.unit.empty()) histogram.width = std::max(1.0, histogram.width);
  const double first = std::floor(least / histogram.width);
  histogram.from = first * histogram.width;
  const auto binOf = [&](double value) {
    return static_cast<size_t>(std::max(0.0, std::floor(value / histogram.width) - first));
  };
  histogram.counts.resize(binOf(greatest) + 1);
  for (const double value : measure.values) ++histogram.counts[binOf(value)];
  return histogram;
}

BatchStatistics statisticsOf(std::span<const WalkRow> rows) {
  BatchStatistics all;
  for (const FigureKind& kind : kFigures) all.measures.push_back({kind.name, kind.unit, {}});
  for (const WalkRow& row : rows) {
    ++all.walks;
    ++all.statuses[row.status];
    if (row.status != "solved") {
      ++all.refusals[row.rule.empty() ? row.status : row.rule];
      continue;
    }
    ++all.solved;
    for (size_t i = 0; i < std::size(kFigures); ++i)
      if (const auto figure = kFigures[i].of(row)) all.measures[i].values.push_back(*figure);
    ++all.scenes[row.scene];
    ++all.styles[row.style];
    for (const std::string& action : row.actions) ++all.actions[action];
  }
  for (Measure& measure : all.measures) std::sort(measure.values.begin(), measure.values.end());
  return all;
}

void addLabels(const std::string& labels, const std::string& file, BatchStatistics& statistics) {
  try {
    const auto json = nlohmann::json::parse(labels);
    const double frame_time = json.at("frame_time");
    const double duration = frame_time * json.at("frames").get<double>();
    for (const auto& stretch : json.at("activities")) {
      const double first = stretch.at("from"), last = stretch.at("to");
      statistics.activities[stretch.at("activity")] += last - first + frame_time;
    }
    for (const auto& motion : json.at("motions")) {
      const double time = motion.at("share").get<double>() * duration;
      if (time > 0.0) statistics.motions[motion.at("motion")] += time;
    }
  } catch (const nlohmann::json::exception&) {
    throw InputError(file, 0, "holds no labels of a walk", "what amble batch has written");
  }
}

}  // namespace amble
