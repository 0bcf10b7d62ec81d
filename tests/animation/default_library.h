/// The library that comes with Amble, read once.
#pragma once

#include "animation/library/motion_library_reader.h"

namespace amble {

inline const MotionLibrary& defaultLibrary() {
  static const MotionLibrary library = openMotionLibrary("default");
  return library;
}

}  // namespace amble
