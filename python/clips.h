/// Captures, and motions that are made of them, as Python holds them.
#pragma once

#include "animation/captures/motion_reader.h"

namespace amble {

/// Const once it is there: views of it keep it.
struct PythonClip {
  CapturedMotion motion;
  std::string file;           ///< that it is from, for messages
  std::string report = "{}";  ///< what making it came to, as JSON
};

}  // namespace amble
