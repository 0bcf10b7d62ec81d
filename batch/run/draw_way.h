/// Starts and goals drawn in a scene: where somebody can stand, on ground that leads from one to
/// the other by the map of the room that the walker has (ClearanceMap).
///
/// The map is a guide: that a walk leads there is for the planner to say. What is drawn depends on
/// the walker, the scene and the stream of numbers.
#pragma once

#include <memory>
#include <optional>

#include "base/sample_stream.h"
#include "scenarios/problem.h"

namespace amble {

class WayDrawer {
 public:
  /// @pre the problem outlives it
  explicit WayDrawer(const Problem& problem);
  ~WayDrawer();

  struct Ends {
    Place start, goal;  ///< to the millimetre, on floors that they name, by any heading
  };
  /// @param least, most  from start to goal as the crow flies, in plan [m]
  /// @return none where nothing was found in kTries
  std::optional<Ends> draw(SampleStream& stream, double least, double most) const;
  static constexpr int kStarts = 50, kGoals = 200, kTries = 2000;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace amble
