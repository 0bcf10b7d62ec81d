/// What a motion touches first, by whose word, and how deep soles may be.
#pragma once

#include "animation/steps/sole_phase.h"

namespace amble {

/// Depth to which a planted sole may sink into the ground: FCL and the capsule's curve need some;
/// more is visible [m].
inline constexpr double kSoleDepth = 0.005;

/// Depth to which a sole that is neither planted nor just being lifted or put down may be in the
/// ground: rounding [m].
inline constexpr double kSwingDepth = 0.001;

/// A motion that comes nearer than this without a contact at a frame may be refused as unproved:
/// intervals are halved until parts move by less in them. Smaller costs more halvings near contact;
/// larger closes gaps that are just wide enough [m].
inline constexpr double kProofGap = 0.001;

/// The least distance of a motion to things is told to this: what may be nearer by less between two
/// frames is not looked for. Smaller costs more halvings where something is passed close by [m].
inline constexpr double kClearanceGap = 0.0005;

/// Who says whether a capsule touches a thing, and how far it is.
enum class Checker {
  kFast,  ///< our own trees of triangles; the answers of FCL up to its accuracy, 1e-6 m
  kFcl,   ///< FCL, which they are measured against
};

struct Contact {
  int frame = 0;         ///< the frame, or the one before the moment of contact
  double between = 0.0;  ///< [0, 1): how far towards the next frame
  int part = -1;         ///< of the body
  int object = -1;       ///< of the scene
  /// Nearest distance that was proved [m]; 0 is a contact. Motions closer than kProofGap are
  /// refused as unproved.
  double gap = 0.0;
};

}  // namespace amble
