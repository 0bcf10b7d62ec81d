/// Frames clustered by agglomeration (Shanbhag's thesis, §4.2.3): the two that are most alike
/// become one, which is the mean of their frames, and so on until one is left. The order in which
/// that happened is a tree.
///
/// The thesis keeps all pairs sorted, n² of them. Here each cluster keeps only which of the later
/// ones is nearest to it, or a bound below which none is (Müllner, "Modern hierarchical,
/// agglomerative clustering algorithms", 2011, fig. 3): memory is that of the features, and the
/// tree is that of the thesis' steps to the bit. Chains of nearest neighbours, which are quicker,
/// would not be exact: two clusters may come nearer to a third by becoming one, so that a merge can
/// cost less than one before it. Where pairs are equally alike, the one whose first frame, then
/// whose second frame is the earlier counts; a cluster's frame is the later of the two that it was
/// made of.
///
/// "Average of those in i and j" is read as the mean of all frames in both, so that what stands for
/// a cluster does not depend on how it grew.
#pragma once

#include <vector>

#include "animation/graph/frame_features.h"
#include "base/stop_request.h"

namespace amble {

/// Two nodes of a tree become one. Nodes 0 to n - 1 are frames; merge k makes node n + k.
struct Merge {
  int a = 0, b = 0;
  float error = 0.0f;  ///< E of the two means [m², >= 0]
};

/// n - 1 merges, in the order in which they were made. @param threads  [>= 1]; changes no result.
/// Takes n² times two to four comparisons of frames. @pre finite features. @throws Stopped
std::vector<Merge> agglomerate(FrameFeatures features, int threads, const StopRequest& stop = {});

/// What stands for two clusters of so many frames each, of which `a` and `b` are the means.
void meanOf(const float* a, int frames_a, const float* b, int frames_b, float* mean);

}  // namespace amble
