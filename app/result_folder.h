/// A folder that `amble plan` has written, as other commands read it.
#pragma once

#include <filesystem>
#include <optional>

namespace amble {

/// Whether it holds a walk and its report.
bool isResultFolder(const std::filesystem::path& folder);

/// The page that was written with the results; none where the folder has no report or no page.
std::optional<std::filesystem::path> pageOfResult(const std::filesystem::path& folder);

/// Where a folder holds one run's folder of results, and no clip beside that, this one: what `amble
/// plan -o out/NAME` leaves in out. None where there are several, or none.
std::optional<std::filesystem::path> onlyResultIn(const std::filesystem::path& folder);

/// The scene that its walk was planned in. The report names its inputs relative to the scenario's
/// folder, which it does not name: that is looked for here, in scenarios/ here and where Amble's
/// data lies, and in the folders of results and above; a file is the scene if its bytes are those
/// that were read.
/// @throws InputError where it is found nowhere
std::filesystem::path sceneOfResult(const std::filesystem::path& folder);

}  // namespace amble
