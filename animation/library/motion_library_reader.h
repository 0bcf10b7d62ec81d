/// Motion libraries as files (DESIGN.md, section 5, Motion library), read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "animation/library/motion_library.h"

namespace amble {

class YamlNode;

/// @throws InputError with file and line: unknown keys, sizes that do not fit the skeleton, a walk
/// that is called straight and turns. Whether it can walk is another question: whyItCannotWalk.
MotionLibrary readMotionLibrary(const std::filesystem::path& file);

/// The library called `default`, or the one at a path (relative to `relative_to`), to walk with in
/// a style (library_style.h). @throws InputError, also where it cannot walk, or not so
MotionLibrary openMotionLibrary(const std::string& name,
                                const std::filesystem::path& relative_to = {},
                                const std::string& style = "");
/// The same of one that is read. @param all  with all its styles
MotionLibrary openMotionLibrary(const MotionLibrary& all, const std::string& style);
/// The file of that library.
std::filesystem::path motionLibraryFile(const std::string& name,
                                        const std::filesystem::path& relative_to = {});

/// `valid:` always | at_start | at_end | {from: , to: } | {clearance_above: }, of libraries and
/// their recipes; of a walk always, since every walk of a library is blended with the others.
/// @throws InputError
Validity readValidity(const YamlNode& node, MotionKind kind);
/// `style:` a name, of libraries and their recipes; of walks, starts, stops
/// and turns on the spot. @throws InputError
std::string readStyle(const YamlNode& node, MotionKind kind);
/// `joints:` all, or a list of chains. @throws InputError for what is no chain, and for a leg: legs
/// walk
std::vector<std::string> readChains(const YamlNode& node);

}  // namespace amble
