/// Where the data lies that comes with Amble: motion libraries, scenes, scenarios.
#pragma once

#include <filesystem>

namespace amble {

/// The folder that holds `animation/motions/`, `environments/scenes/` and `scenarios/`, as the
/// source tree does: the first that is there of
///   1. the environment variable AMBLE_DATA,
///   2. `../share/amble` beside the running program's folder (an installed program),
///   3. the source tree that Amble was built from,
///   4. `share/amble` of the prefix that it was configured for.
/// @throws InputError if AMBLE_DATA names no such folder, or none of the others is there.
std::filesystem::path dataDirectory();

}  // namespace amble
