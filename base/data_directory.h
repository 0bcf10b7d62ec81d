/// Where the data lies that comes with Amble: motion libraries, scenes, scenarios.
#pragma once

#include <filesystem>

namespace amble {

/// The folder that holds `animation/motions/`, `environments/scenes/` and `scenarios/`, as the
/// source tree does: the first that is there of
///   1. the environment variable AMBLE_DATA,
///   2. `../share/amble` beside the running program's folder (an installed program),
///   3. the folder that useDataDirectory() named,
///   4. the source tree that Amble was built from,
///   5. `share/amble` of the prefix that it was configured for.
/// @throws InputError if AMBLE_DATA names no such folder, or none of the others is there.
std::filesystem::path dataDirectory();

/// Of a program that is not ours, and has Amble within it, such as Python: where that Amble has its
/// data. To be said before anything else is asked.
void useDataDirectory(const std::filesystem::path& folder);

}  // namespace amble
