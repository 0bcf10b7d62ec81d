/// Which clips a command is asked about, and where what it writes of each goes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace amble {

/// Files as they are given, and every motion file (motion_reader.h) in the folders among them and
/// below, by name. `-` is standard input, once.
/// @throws InputError for a folder without a motion file, and for `-` given twice
std::vector<std::filesystem::path> findClips(const std::vector<std::string>& paths);

/// One file a clip: `pattern` with {stem} replaced by the clip's name without its ending; or
/// STEM.`extension` in `pattern` where that is a folder or ends in a slash; or, for a single clip,
/// `pattern` itself. Folders of these names are made.
/// @param option  for messages, such as "--plot"
/// @throws InputError where two clips would get the same file, or several a file without {stem}
std::vector<std::filesystem::path> outputNames(const std::string& option,
                                               const std::string& pattern,
                                               const std::string& extension,
                                               const std::vector<std::filesystem::path>& clips);

}  // namespace amble
