/// How clips and frames of a cluster graph are called on the command line: CLIP:FRAME and
/// CLIP:A-B, frames as the clip's file numbers them, from 0.
#pragma once

#include <string>
#include <vector>

#include "animation/graph/kept_clips.h"

namespace amble {

/// Reads a graph, and refuses one whose clips have changed.
KeptGraph readFreshGraph(const std::string& file);

/// @param option  for messages. @throws InputError where no clip, or several, are called so
int clipNamed(const KeptGraph& kept, const std::string& name, const std::string& option);
/// CLIP:FRAME, as a frame among those of all clips. @throws InputError
int frameNamed(const KeptGraph& kept, const std::string& text, const std::string& option);

/// CLIP:A-B.
struct NamedRange {
  int clip = 0;
  int first = 0, last = 0;  ///< of the file
};
/// CLIP:A-B,CLIP:C-D; names may hold commas and colons. @throws InputError
std::vector<NamedRange> rangesNamed(const KeptGraph& kept, const std::string& text,
                                    const std::string& option);

}  // namespace amble
