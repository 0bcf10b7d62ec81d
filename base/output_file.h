/// Files that are there whole or not at all: written beside, then renamed.
///
/// What lay there before keeps its place and its rights: a link goes on to lead to the file that it
/// led to, and that file keeps its mode. What a killed program left half-written beside a file
/// (`NAME.part-PID-N`) is cleared when that file is next written.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <vector>

namespace amble {

/// Calls `write` with a stream to a file beside `file`, flushes it, checks it and renames it. `-`
/// is standard output. A pipe is written to if somebody reads from it, or does so within
/// kReaderPatience.
/// @throws InputError if the folder is missing or not writable, the file may not be written, the
/// disk is full or nobody reads from the pipe; nothing is left behind then.
void writeFile(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

/// Whether `file` is a pipe or a device, which has no ending that says what is in it.
bool isStream(const std::filesystem::path& file);

/// Programs that a shell starts together come up within that [s].
inline constexpr int kReaderPatience = 3;

struct ResultFile {
  std::filesystem::path file;
  std::function<void(std::ostream&)> write;
};

/// Files that belong together: each is written beside its place, in this order, and none gets its
/// name before all are written, so that a disk that fills up half way leaves none of them, and what
/// lay there before. `obsolete` are files of an earlier set: they go when the new one is all
/// written, and those that are not there do not matter.
void writeFiles(const std::vector<ResultFile>& files,
                const std::vector<std::filesystem::path>& obsolete = {});

/// Removes the half-written files of the whole program, for a handler of signals that ends it: safe
/// to call in one.
void removeHalfWritten();

}  // namespace amble
