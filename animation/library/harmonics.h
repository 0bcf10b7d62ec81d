/// How finely a cycle may be described.
#pragma once

namespace amble {

/// Most harmonics of a library's series: beyond, a cycle holds what its capture shakes [1].
inline constexpr int kMaxHarmonics = 12;

}  // namespace amble
