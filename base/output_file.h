/// Files that are there whole or not at all: written beside, then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <vector>

namespace amble {

/// Calls `write` with a stream to a file beside `file`, flushes it, checks it and renames it. `-`
/// is standard output.
/// @throws InputError if the folder is missing or not writable, or the disk is full; nothing is
/// left behind then.
void writeFile(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

struct ResultFile {
  std::filesystem::path file;
  std::function<void(std::ostream&)> write;
};

/// Files that belong together: each is written beside its place, in this order, and none gets its
/// name before all are written, so that a disk that fills up half way leaves none of them, and what
/// lay there before.
void writeFiles(const std::vector<ResultFile>& files);

}  // namespace amble
