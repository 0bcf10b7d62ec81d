/// Work on input that may bring down what reads it: done by a process of its own, with bounds on
/// memory and time, so that a crash there is an answer here.
///
/// Other people's parsers recurse as deep as a file nests, and without end where it is its own
/// child.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "base/guard_limits.h"

namespace amble {

/// How guarded work ended.
enum class GuardEnd { kDone, kMemory, kTime, kStopped, kBroken };

struct GuardedAnswer {
  GuardEnd end = GuardEnd::kBroken;
  std::string bytes;  ///< what the work returned; empty unless done

  bool done() const { return end == GuardEnd::kDone; }
  /// For messages, why there is no result: "it fills more than 768 MB of memory".
  std::string why(const GuardLimits& limits) const;
};

/// Work that a copy of this process does meanwhile. The copy shares no memory, writes nothing to
/// the terminal and ends without destructors. Costs a millisecond and the copying of the result.
/// Under a sanitizer memory is not bounded.
class GuardedWork {
 public:
  /// Begins it. @throws std::system_error where there can be no more processes
  explicit GuardedWork(const std::function<std::string()>& work, GuardLimits limits = {});
  /// Ends it where nobody asked for its answer.
  ~GuardedWork();
  GuardedWork(GuardedWork&& other) noexcept
      : limits_(std::move(other.limits_)),
        copy_(std::exchange(other.copy_, -1)),
        from_(other.from_) {}
  GuardedWork& operator=(GuardedWork&&) = delete;

  /// Waits for what it returned, or which limit it went beyond; kBroken where it threw or crashed.
  /// @pre asked once
  GuardedAnswer answer();

 private:
  int end(bool kill_it);

  GuardLimits limits_;
  int copy_ = -1;  // process; -1 once it has ended
  int from_ = -1;  // where its answer comes out
};

/// The same, with nothing done meanwhile.
GuardedAnswer runGuarded(const std::function<std::string()>& work, const GuardLimits& limits = {});

}  // namespace amble
