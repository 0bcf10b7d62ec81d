/// A line of a batch's table: what one walk is of, and what came of it.
///
/// Lengths in metres, angles in radians here and in degrees in files.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/run_scenario.h"

namespace amble {

struct WalkRow {
  std::string key;                    ///< its folder's name
  std::string scene, library, style;  ///< as the job has them
  std::vector<std::string> actions;
  double height = 0.0;  ///< that was walked with [m]; 0 where it is not known
  double speed = 0.0;   ///< asked for on the straight [m/s]; 0 where it is not known
  std::string way;
  std::uint64_t seed = 1;
  /// x, y, z on the ground [m, World]; none where there is none.
  std::optional<Eigen::Vector3d> start, goal;
  /// Of a report; `no_way` where no start and goal could be drawn; `error` where its input is
  /// wrong.
  std::string status;
  std::string rule;    ///< that most often refused, where there is no walk
  std::string reason;  ///< why there is none, in a line
  std::string stopped_by;
  double length = 0.0, duration = 0.0;  ///< [m], [s]; these and the next of a walk only
  int frames = 0, steps = 0;
  double clearance = 0.0, foot_skate = 0.0;  ///< the least and the most [m]
  std::string caption;
  std::vector<std::string> credits;  ///< "LICENCE: CREDIT" of all captures that it is made of
};

/// The figures of a run.
void fillRow(const RunResult& result, WalkRow& row);

/// One line of JSON, the same for the same row.
std::string rowJson(const WalkRow& row);
/// @param file, line  for messages. @throws InputError where it is no such line
WalkRow readRow(const std::string& json, const std::string& file, int line = 1);

/// Heads of the table's columns, and a row's fields, as RFC 4180 has them, without line ends.
std::string rowCsvHead();
std::string rowCsv(const WalkRow& row);

}  // namespace amble
