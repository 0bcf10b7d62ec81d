/// Memory that was freed, kept for what comes next or given back to the system.
#pragma once

#include <cstddef>

namespace amble {

/// From now on memory that is freed stays with the process, up to what is large for glibc, for what
/// the system gives anew it clears anew; and the first `bytes` that are asked for come in large
/// pages where the system has them, of which each saves five hundred interruptions. Takes none of
/// it yet. For programs of our own, at their begin: it is the whole process that changes.
void keepFreedMemory(size_t bytes);

/// Gives memory that was freed back to the system, as far as whole pages of it are free: allocators
/// keep it for later, each thread's apart, and more of it lies about the longer a program runs. It
/// costs some milliseconds, and what is needed again is cleared again. Does nothing where the C
/// library has no call for it.
void giveBackFreedMemory();

}  // namespace amble
