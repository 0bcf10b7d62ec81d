/// What `amble view` shows of captures beside their motion: what `amble analyse` says of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "animation/captures/motion_reader.h"
#include "viz/page/bench.h"

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

/// To standard output, for machines: a list with an object a clip.
void printBench(const Bench& bench);

}  // namespace amble
