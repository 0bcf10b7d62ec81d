/// Files that are there whole or not at all: written beside, then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace amble {

/// Calls `write` with a stream to a file beside `file`, flushes it, checks it and renames it. `-` is standard output.
/// @throws InputError if the folder is missing or not writable, or the disk is full; nothing is left behind then.
void writeFile(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

}  // namespace amble
