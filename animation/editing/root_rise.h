/// How the root rises and falls with the stride (Shanbhag's thesis, §6.2.1, eq. 6.1 and 6.2).
///
/// Read to the letter the equations lift the pelvis 2.5 times as much as people do (QUALITY.md),
/// and their sine has a corner at every double support. Here they are a change: the captured stride
/// gives the captured rise, another one gives it in the ratio of the two that the equations have,
/// as a raised cosine. Eq. 2 of the paper (Shanbhag & Chandran) has m - n where the thesis rightly
/// has n - m.
#pragma once

#include <functional>

#include "animation/editing/captured_walk.h"
#include "animation/editing/walk_tracks.h"

namespace amble {

/// Lowers the root about each double support, or raises it there, as the step that begins with it
/// is `factor` [> 0] times as long; over the foot that stands it stays. 1 changes nothing.
void riseWithStride(const CapturedWalk& walk, const std::function<double(int frame)>& factor,
                    WalkTracks& tracks);

/// Of the equations' rise at a stride so many times as long to that at `stride` [m, >= 0], for a
/// leg from hip to heel [m, > 0].
double riseRatio(double stride, double factor, double leg);

}  // namespace amble
