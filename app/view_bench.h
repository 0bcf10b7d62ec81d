/// What `amble view` shows of captures beside their motion: what `amble analyse` says of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "animation/captures/motion_reader.h"
#include "viz/page/graph_bench.h"
#include "viz/page/library_bench.h"

namespace amble {

/// Captures that could be read, in the order of their files, and a line for each that could not.
struct ReadClips {
  std::vector<ShownClip> clips;
  std::vector<std::string> errors;
};
/// On all threads; the result does not depend on them. Stops early when the program is told to.
ReadClips readClips(const std::vector<std::filesystem::path>& files,
                    const MotionReadOptions& options);

/// @pre the clips outlive it
Bench benchOf(const std::vector<ShownClip>& clips);

/// Of a cluster graph's clips and transitions. @pre it outlives the bench
Bench benchOf(const BenchGraph& graph);
/// Of a library's motions. @pre it outlives the bench
Bench benchOf(const BenchLibrary& library);
/// Where a library's captures are: the folder that is asked for, or else that of the recipe beside
/// it (`captures:` of NAME.recipe.yaml), or else its own. @throws InputError for a bad recipe
std::filesystem::path capturesOf(const std::filesystem::path& library, const std::string& asked);

/// To standard output, for machines: a list with an object a clip; of a library or a graph one
/// object.
void printBench(const Bench& bench);

}  // namespace amble
