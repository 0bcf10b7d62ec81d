/// Who says whether a capsule touches a thing, and how far it is.
#pragma once

namespace amble {

enum class Checker {
  kFast,  ///< our own trees of triangles; the answers of FCL up to its accuracy, 1e-6 m
  kFcl,   ///< FCL, which they are measured against
};

}  // namespace amble
