/// Ctrl-C: searches poll a flag and stop cleanly, so that no half-written file is left.
#pragma once

#include <atomic>

namespace amble {

/// From now on SIGINT and SIGTERM set the flag; a second one ends the program at once.
void stopOnSignals();
/// Set when the user asked to stop.
const std::atomic<bool>& stopFlag();

}  // namespace amble
