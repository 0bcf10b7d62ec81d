/// Inputs stay as they are: nothing is written over what is read.
#pragma once

#include <filesystem>
#include <vector>

namespace amble {

/// Refuses an output that is one of the files that are read, by whatever spelling of its path or
/// link; among inputs `-` is the file that standard input comes from. To be asked before any work.
/// @throws InputError
void keepInputs(const std::filesystem::path& output,
                const std::vector<std::filesystem::path>& inputs);

}  // namespace amble
