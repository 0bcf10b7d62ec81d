#include "app/output_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "base/error.h"

namespace amble {

namespace fs = std::filesystem;

void checkOutputFolder(const fs::path& folder) {
  std::error_code unknown;
  fs::path there = fs::absolute(folder).lexically_normal();
  while (!fs::exists(there, unknown) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_directory(there, unknown)) {
    throw InputError(folder.string(), 0,
                     fmt::format("cannot be made: {} is no folder", there.string()), "a folder");
  }
  if (::access(there.c_str(), W_OK | X_OK) != 0) {
    throw InputError(
        folder.string(), 0,
        fmt::format("{} cannot be written to: {}", there.string(), std::strerror(errno)),
        "a folder that may be written to");
  }
}

}  // namespace amble
