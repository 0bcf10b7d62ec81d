/// Files and streams read whole, up to a limit, so that none of them eats the machine: `/dev/zero`
/// and a pipe that somebody fills for ever are files too.
#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <string>

namespace amble {

/// What is read, for messages, and how large it may be.
struct FileKind {
  const char* name;  ///< "a scenario (YAML)"
  size_t limit;      ///< [bytes]
};

/// Programs that a shell starts together come up within that [s].
inline constexpr int kWriterPatience = 3;

/// The bytes of a file, a device or a pipe; `-` is standard input. Each is opened once and read
/// once, from its begin to its end.
/// @throws InputError if it is missing, a folder, unreadable, larger than its kind may be, or a
/// pipe that nobody has begun to write to within kWriterPatience
std::string readWholeFile(const std::filesystem::path& file, const FileKind& kind);
/// The rest of a stream. @param name  stands for it in messages
std::string readWholeStream(std::istream& in, const std::string& name, const FileKind& kind);

/// "64 MiB", "500 bytes": in the largest unit that divides it.
std::string sizeText(size_t bytes);

}  // namespace amble
