/// What an edit was asked for and what it came to, measured on the clip that is written.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "animation/editing/edit_walk.h"

namespace amble {

/// Means over steps; what the clip has no steps for is 0.
struct EditReport {
  GaitMeasures captured, achieved;
  /// Seen from above; on stairs what is achieved is the mean tread's [m].
  double captured_stride = 0.0, achieved_stride = 0.0;
  /// Of a print over the other foot's, by a stride straight up the slope or the stairs, however the
  /// walk turns on it [m].
  double captured_rise = 0.0, achieved_rise = 0.0;
  std::optional<double> asked_stride;   ///< seen from above [m]
  std::optional<double> asked_lift;     ///< [m]
  std::optional<double> asked_rise;     ///< [m]
  std::optional<double> arrival_error;  ///< [m, >= 0]
};

EditReport editReport(const CapturedWalk& walk, const EditRequest& request,
                      const EditedWalk& edited);
/// A line a quantity, for people.
std::vector<std::string> editLines(const EditReport& report, const EditedWalk& edited);
nlohmann::ordered_json editJson(const EditReport& report, const CapturedWalk& walk,
                                const EditRequest& request, const EditedWalk& edited,
                                const std::string& in, const std::string& out);

}  // namespace amble
