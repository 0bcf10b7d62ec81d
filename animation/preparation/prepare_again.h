/// Motions of a library prepared once more from their captures: to be compared with, or on another
/// `stand`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "animation/captures/motion_reader.h"
#include "animation/library/motion_library.h"
#include "animation/preparation/motion_library_add.h"

namespace amble {

/// Where the captures of a library's motions lie, and how they are read.
struct LibraryCaptures {
  std::vector<std::filesystem::path> folders;  ///< one or more; a clip is of the first that has it
  MotionReadOptions read;
};

/// In one line why a motion is not what its capture gives; empty where it is, to 1e-4 (m, rad, 1).
/// A `stand` may be the one that the library's second motion borrowed, or one that took its place.
std::string problemOf(const MotionLibrary& library, const Motion& motion,
                      const LibraryCaptures& captures);

/// Whether the library's `stand` is the library `default`'s, carried over to its skeleton because
/// it had none of its own.
bool hasBorrowedStand(const MotionLibrary& library);

/// Puts the person's own `stand` in the place of the one that was borrowed. All motions were made
/// with that, and are made again from their captures: the library is then as if this `stand` had
/// been the first, to rounding, where the capture is of the library's rig; another's is carried
/// over. A library in which anything fails stays as it was.
/// @pre hasBorrowedStand(library); request.name is `stand`
/// @throws InputError also where a motion's capture is not there, or gives another motion
/// @param warnings  of the request's capture, as addMotion has them
void replaceStand(MotionLibrary& library, const MotionRequest& request,
                  const LibraryCaptures& captures, std::vector<std::string>* warnings = nullptr);

}  // namespace amble
