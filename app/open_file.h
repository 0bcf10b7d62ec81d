/// Shows a file in the program that people have set for its kind.
#pragma once

#include <filesystem>

namespace amble {

/// By xdg-open (open, on a Mac), which goes on by itself. @throws InputError where there is none
void openFile(const std::filesystem::path& file);

}  // namespace amble
