/// What is in a ZIP whose entries are stored and not deflated, as NpyArchive writes it (PKWARE's
/// APPNOTE 6.3, section 4.3.7).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace amble {

struct ZipEntry {
  std::string name, bytes;
};

/// In the file's order. @param file  stands for it in messages
/// @throws InputError for what is cut off, deflated or no ZIP
std::vector<ZipEntry> readStoredZip(std::string_view zip, const std::string& file);

}  // namespace amble
