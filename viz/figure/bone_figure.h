/// What is shown of a skeleton that is nobody's.
#pragma once

#include "viz/figure/figure.h"

namespace amble {

/// An octahedron on each bone and a small one on each joint, in the skeleton's rest pose; each
/// hangs on its joint alone.
Figure makeBoneFigure(const Skeleton& skeleton);

}  // namespace amble
