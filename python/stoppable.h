/// Work that Ctrl-C stops.
#pragma once

#include <atomic>
#include <functional>

#include "base/parallel.h"

namespace amble {

/// Does `work` without the interpreter's lock. Python hands signals to its main thread only, and
/// only while that runs Python: so where the main thread asks, another does the work, and the main
/// one looks for signals now and then. A handler that raises (as Ctrl-C's does) sets `stop`; once
/// the work has ended its exception is thrown on, whatever the work came to.
/// @param threads  no more of them work for it (withThreads)
/// @throws what the work throws; pybind11::error_already_set. @pre the interpreter's lock is held
void runStoppable(int threads, const std::function<void(const std::atomic<bool>& stop)>& work);

}  // namespace amble
