/// The ways from one frame to another over a graph, in words.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "animation/graph/graph_file.h"
#include "animation/graph/transition_search.h"

namespace amble {

struct WayLimits {
  double error = kGraphError;  ///< frames that differ by less are alike [m, >= 0]
  double stay = 0.5;           ///< a clip is played so long between two jumps [s, >= 0]
};

struct NamedWay {
  const char* name;   ///< for machines
  const char* title;  ///< for people
  GraphWay way;
};

struct GraphWays {
  int from = 0, to = 0;         ///< among those of all clips
  double difference = 0.0;      ///< of the two frames [m, >= 0]
  std::vector<NamedWay> all;    ///< as the thesis asks for them: the first is the usual one
  nlohmann::ordered_json data;  ///< all of it, for machines
};

/// @param from,to  CLIP:FRAME. @throws InputError where there is no such frame
GraphWays waysBetween(const KeptGraph& kept, const std::string& from, const std::string& to,
                      const WayLimits& limits = {});

}  // namespace amble
