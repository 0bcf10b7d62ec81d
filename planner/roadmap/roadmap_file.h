/// Kept roadmaps as files.
///
/// A line that says what it is, and of which format; then, as base/byte_pack.h lays them on a
/// little-endian machine, the source, the counts, the nodes (position [m], heading [rad], kind) and
/// the edges (from, to, cost [s]); at the end the SHA-256 of all before it. What was cut off or
/// altered is seen by that; what was made up is seen by its values: every number is checked, and
/// memory is taken for what is there, never for what is announced.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "planner/roadmap/kept_roadmap.h"

namespace amble {

/// Larger files are not read [bytes].
inline constexpr size_t kMaxRoadmapFile = size_t{256} << 20;

std::string packRoadmap(const KeptRoadmap& roadmap);
/// @param name  of the file, in messages. @throws InputError
KeptRoadmap unpackRoadmap(std::string_view bytes, const std::string& name);

/// @throws InputError
void writeRoadmap(const KeptRoadmap& roadmap, const std::filesystem::path& file);
KeptRoadmap readRoadmap(const std::filesystem::path& file);

}  // namespace amble
