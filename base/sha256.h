/// SHA-256 (FIPS 180-4), by nettle: which bytes a report speaks of.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace amble {

/// 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);
/// Read in pieces: a file of any size takes little memory.
/// @throws InputError if the file cannot be read.
std::string sha256OfFile(const std::filesystem::path& file);

}  // namespace amble
