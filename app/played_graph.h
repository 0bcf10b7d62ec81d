/// Parts of a graph's clips played one after another.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "animation/editing/foot_lock.h"
#include "animation/graph/transition_search.h"
#include "app/graph_words.h"

namespace amble {

struct GraphPlaying {
  double blend = kGraphBlend;  ///< time over which two clips are mixed at a join [s, >= 0]
  double fps = 0.0;            ///< [1/s]; 0: the graph's
  bool foot_lock = false;      ///< planted feet are held where they stand
};

struct PlayedGraph {
  JoinedClip motion;
  JointRoles roles;
  std::optional<FootLock> lock;  ///< what it took to hold feet, where they were to be
};

/// Its clips are read again. @param file  the graph's. @throws InputError
PlayedGraph playGraph(const KeptGraph& kept, const std::string& file,
                      std::vector<NamedRange> ranges, const GraphPlaying& how);

/// Which loop of a clip.
struct LoopWishes {
  double error = kGraphError;    ///< frames that differ by less are alike [m, >= 0]
  double shortest = 0.4;         ///< loops take at least so long [s, >= 0]
  std::optional<int> left_near;  ///< frame of the file near which it is left; none: the smoothest
};
/// The loops in a clip, that which is wished for first. @throws InputError for a frame that the
/// clip does not have
std::vector<FrameLoop> loopsIn(const KeptGraph& kept, int clip, const LoopWishes& wishes);
/// What is played to go through a loop so many times. @param count  [>= 1]
std::vector<NamedRange> rangesOfLoop(const KeptGraph& kept, const FrameLoop& loop, int count);

}  // namespace amble
