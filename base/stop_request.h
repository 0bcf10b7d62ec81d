/// A wish that long work ends: Ctrl-C, or a time limit that has passed.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <stdexcept>

namespace amble {

/// Thrown by work that has no result when it is stopped; what() is for people.
class Stopped : public std::runtime_error {
 public:
  explicit Stopped(bool by_time)
      : std::runtime_error(by_time ? "the time limit passed while the scene was loaded"
                                   : "stopped while the scene was loaded"),
        by_time_(by_time) {}
  bool byTime() const { return by_time_; }  ///< else by the user

 private:
  bool by_time_;
};

struct StopRequest {
  const std::atomic<bool>* flag = nullptr;  ///< Ctrl-C; outlives the work
  std::optional<std::chrono::steady_clock::time_point> deadline;

  bool flagged() const { return flag && flag->load(std::memory_order_relaxed); }
  bool late() const { return deadline && std::chrono::steady_clock::now() >= *deadline; }
  bool asked() const { return flagged() || late(); }
  /// @throws Stopped if it is asked. Costs about 30 ns.
  void check() const {
    if (flagged()) throw Stopped(false);
    if (late()) throw Stopped(true);
  }
};

}  // namespace amble
