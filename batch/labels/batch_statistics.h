/// What the walks of a batch are like: how their figures are spread, and why there are none.
///
/// Depends on the rows alone, and on their order in nothing.
#pragma once

#include <map>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "batch/labels/walk_row.h"

namespace amble {

/// One figure of the walks that were found.
struct Measure {
  std::string name;            ///< "length", "mean speed", ...
  std::string unit;            ///< "m", "m/s", "s", "1/min"; "" of a count
  std::vector<double> values;  ///< ascending, one a walk at most
};

/// Of values that are not empty; the nearest value to each share of them.
struct Spread {
  double least = 0.0, tenth = 0.0, median = 0.0, ninetieth = 0.0, most = 0.0, mean = 0.0;
};
Spread spreadOf(const Measure& measure);

/// Bins of one width, a round number and of counts a whole one, whose edges are multiples of it;
/// every value is in one.
struct Histogram {
  double from = 0.0, width = 1.0;  ///< lower edge of the first; of each [> 0]
  std::vector<int> counts;
};
/// @param most  bins [>= 3]; no counts of no values
Histogram histogramOf(const Measure& measure, int most);

using Counts = std::map<std::string, int>;
using Times = std::map<std::string, double>;  ///< [s]

struct BatchStatistics {
  int walks = 0, solved = 0;       ///< rows; those with a walk
  std::vector<Measure> measures;   ///< always the same ones
  Counts statuses;                 ///< of all rows
  Counts refusals;                 ///< of those without a walk: by rule, or by status where none is
  Counts scenes, styles, actions;  ///< of the walks that were found
  /// What was done for how long, and of which captured motions it is made; of labels.
  Times activities, motions;
};
BatchStatistics statisticsOf(std::span<const WalkRow> rows);
/// Adds what a walk's labels.json tells. @param file  for messages. @throws InputError
void addLabels(const std::string& labels, const std::string& file, BatchStatistics& statistics);

/// One drawing (SVG): a histogram of each measure, bars of statuses and refusals. The same
/// statistics give the same bytes.
void writeStatisticsPlot(std::ostream& out, const BatchStatistics& statistics,
                         const std::string& title);

}  // namespace amble
