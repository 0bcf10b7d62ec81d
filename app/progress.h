/// How far the work is, on standard error: a bar on a terminal, a line now and then elsewhere.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace amble {

/// Safe to update from any thread. Draws at most ten times a second; the bar is gone when the
/// object is.
class Progress {
 public:
  /// @param wanted  false draws nothing: where the work is done in a moment.
  explicit Progress(bool wanted = true);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param done  of the stage [0, 1]; below 0 where it is not known
  void update(const std::string& stage, double done);
  /// Takes the bar away, so that something else can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  void draw(const std::string& stage, double done);

  const bool wanted_;
  const bool terminal_;
  const bool colour_;
  std::mutex mutex_;
  Clock::time_point last_;
  bool drawn_ = false;
};

}  // namespace amble
