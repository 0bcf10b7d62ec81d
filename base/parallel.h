/// A loop on a few threads.
#pragma once

#include <functional>

namespace amble {

/// Calls task(i, thread) for i in 0 .. count - 1, thread in 0 .. threads - 1, each i once. An
/// exception of a task is thrown again when all have ended. With one thread (or one i) no thread is
/// started.
void parallelFor(int count, int threads, const std::function<void(int i, int thread)>& task);

}  // namespace amble
