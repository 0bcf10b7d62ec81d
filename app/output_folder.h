/// Folders that results go into.
#pragma once

#include <filesystem>

namespace amble {

/// That a folder is there or can be made, and written to: to be asked before any work, not after
/// it. @throws InputError
void checkOutputFolder(const std::filesystem::path& folder);

}  // namespace amble
