#include "base/data_directory.h"

#include <cstdlib>
#include <system_error>

#include "base/error.h"

namespace amble {
namespace {

bool holdsData(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::is_directory(folder / "animation" / "motions", ignored);
}

std::filesystem::path& namedFolder() {
  static std::filesystem::path folder;
  return folder;
}

}  // namespace

void useDataDirectory(const std::filesystem::path& folder) { namedFolder() = folder; }

std::filesystem::path dataDirectory() {
  if (const char* named = std::getenv("AMBLE_DATA"); named != nullptr && *named != '\0') {
    if (!holdsData(named)) {
      throw InputError(named, 0, "AMBLE_DATA names a folder without Amble's data",
                       "a folder that holds animation/motions/");
    }
    return named;
  }
  std::error_code unknown;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  const std::filesystem::path candidates[] = {
      program.parent_path().parent_path() / "share" / "amble", namedFolder(), AMBLE_SOURCE_DATA,
      AMBLE_INSTALLED_DATA};
  for (const auto& folder : candidates) {
    if (!folder.empty() && holdsData(folder)) return folder;
  }
  throw InputError(AMBLE_INSTALLED_DATA, 0, "Amble's data is not there",
                   "an installed Amble, or its folder in AMBLE_DATA");
}

}  // namespace amble
