/// Parts of a graph's clips played one after another.
#pragma once

#include <string>
#include <vector>

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
};

/// Its clips are read again. @param file  the graph's. @throws InputError
PlayedGraph playGraph(const KeptGraph& kept, const std::string& file,
                      std::vector<NamedRange> ranges, const GraphPlaying& how);

}  // namespace amble
