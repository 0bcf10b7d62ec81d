/// Speed engines as files (docs/files.md, Speed engine), read.
#pragma once

#include <filesystem>

#include "animation/library/speed_engine.h"

namespace amble {

/// Whether the file is one, by its keys. @throws InputError where it is no YAML
bool isSpeedEngine(const std::filesystem::path& file);

/// @throws InputError with file and line: unknown keys, sizes that do not fit the skeleton, clips
/// that are not in order of speed, neither walks nor runs.
EngineData readSpeedEngine(const std::filesystem::path& file);

}  // namespace amble
