/// Ctrl-C: work that can be stopped polls a flag and ends cleanly; anything else ends at once. No
/// half-written file is left either way. Nor is one where files may not be as large (`ulimit -f`):
/// writing on fails then, as on a full disk, and no signal ends the program.
#pragma once

#include <atomic>

namespace amble {

/// While one lives the first SIGINT or SIGTERM sets the flag, and the work that goes on polls it. A
/// second one, or the first without such work, ends the program with kExitStopped.
class StoppableWork {
 public:
  StoppableWork();
  ~StoppableWork();
  StoppableWork(const StoppableWork&) = delete;
  StoppableWork& operator=(const StoppableWork&) = delete;
};

/// From now on signals are treated so.
void stopOnSignals();
/// Set when the user asked to stop.
const std::atomic<bool>& stopFlag();

}  // namespace amble
