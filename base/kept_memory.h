/// How a program's own memory is kept between uses: what the system gives anew it clears anew, and
/// in pages of 4 kB it interrupts for each.
#pragma once

#include <cstddef>

namespace amble {

/// From now on memory that is freed stays with the process, up to what is large for glibc, and the
/// first `bytes` that are asked for come in large pages where the system has them: each saves five
/// hundred interruptions. Takes none of it yet. For programs of our own, at their begin: it is the
/// whole process that changes.
void keepFreedMemory(size_t bytes);

}  // namespace amble
