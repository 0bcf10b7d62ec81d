/// How long something takes, for reports: no result depends on it.
#pragma once

#include <chrono>

namespace amble {

/// Runs from its making.
class Stopwatch {
 public:
  /// Since it was made or last set back [s].
  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  /// The same, and begins anew.
  double restart() {
    const double passed = seconds();
    begin_ = Clock::now();
    return passed;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
};

/// The moment so many seconds from now [s, >= 0].
inline std::chrono::steady_clock::time_point deadlineIn(double seconds) {
  using Clock = std::chrono::steady_clock;
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace amble
