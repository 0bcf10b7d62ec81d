/// Which skeleton an AMC goes with: file names tell, by custom.
#pragma once

#include <filesystem>

namespace amble {

/// The ASF beside an AMC: that of the same name; else the one whose name the AMC's begins with, the
/// longest; else the only one of the same subject (what stands before the first `_` or `-`); else
/// the only one. @throws InputError where none or several are left.
std::filesystem::path findAsf(const std::filesystem::path& amc);

}  // namespace amble
