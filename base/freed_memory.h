/// Memory between works that take much of it.
#pragma once

namespace amble {

/// Gives memory that was freed back to the system, as far as whole pages of it are free: allocators
/// keep it for later, each thread's apart, and more of it lies about the longer a program runs. It
/// costs some milliseconds, and what is needed again is cleared again. Does nothing where the C
/// library has no call for it.
void giveBackFreedMemory();

}  // namespace amble
