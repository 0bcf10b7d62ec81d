/// A loop on a few threads, which oneTBB keeps.
#pragma once

#include <functional>

namespace amble {

/// More threads than this help nobody.
inline constexpr int kMostThreads = 64;

/// As many as the machine runs at a time, or the withThreads that this is within if that is fewer
/// [1 to kMostThreads].
int usualThreads();

/// Calls work() on the caller's thread. Until it returns no more threads than these work for it,
/// its own among them, whatever its loops ask for; an exception goes on to the caller.
/// @param threads  [>= 1]
void withThreads(int threads, const std::function<void()>& work);

/// Calls task(i, thread) for i in 0 .. count - 1, each once, begun in this order, and
/// thread in 0 .. threads - 1, never two at a time of one thread. No more of them run at a time
/// than the machine has. Where tasks throw no further ones are begun, and the exception of the
/// smallest i is thrown again when all have ended: it does not depend on the threads either.
/// With one thread (or one i) the caller does it all. A task may have a loop of its own; while it
/// waits for that, its thread begins no other task of this one.
/// @param threads  [>= 1]
void parallelFor(int count, int threads, const std::function<void(int i, int thread)>& task);

/// The smallest i in 0 .. count - 1 whose task(i, thread) says yes, or count where none does. Of
/// those before it each was called once, of those after it perhaps a few that were begun meanwhile:
/// the answer does not depend on the threads, and none goes on for long that is of no use. Calls as
/// in parallelFor; with one thread none after it. An exception before it is thrown again, one after
/// it is as if it had not been.
/// @param threads  [>= 1]
int firstOf(int count, int threads, const std::function<bool(int i, int thread)>& task);

}  // namespace amble
