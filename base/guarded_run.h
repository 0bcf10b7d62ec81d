/// Work on input that may bring down what reads it: done by a process of its own, with bounds on
/// memory and time, so that a crash there is an answer here.
///
/// Other people's parsers recurse as deep as a file nests, and without end where it is its own
/// child.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace amble {

struct GuardLimits {
  size_t memory = size_t{2} << 30;  ///< beyond what the process has already [bytes]
  int cpu_time = 60;                ///< [s]
};

/// Calls `work` in a copy of this process and returns what it returned; nothing where it threw,
/// crashed or went beyond a limit. The copy shares no memory, writes nothing to the terminal and
/// ends without destructors. Costs a millisecond and the copying of the result. Under a sanitizer
/// memory is not bounded.
std::optional<std::string> runGuarded(const std::function<std::string()>& work,
                                      const GuardLimits& limits = {});

}  // namespace amble
