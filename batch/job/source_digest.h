/// Which program makes a batch: told by its sources, where its version is the same.
#pragma once

#include <string>

namespace amble {

/// SHA-256 of all that this program is compiled from, beside what the machine brings: 64 digits.
/// The same wherever the same sources are built, by whatever compiler (cmake/source_digest.cmake).
std::string sourceDigest();

}  // namespace amble
