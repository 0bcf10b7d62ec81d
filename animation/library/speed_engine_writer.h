/// Speed engines as files (docs/files.md, Speed engine), written.
#pragma once

#include <filesystem>

#include "animation/library/speed_engine.h"

namespace amble {

/// Writes the engine and, beside it, the BVH of its skeleton; folders that are not there are made.
/// Nothing is lost: only engines and the skeletons of libraries are written over. @throws
/// InputError
void writeSpeedEngine(const EngineData& engine, const std::filesystem::path& file);

}  // namespace amble
