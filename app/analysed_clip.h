/// Clips read, levelled and analysed: one, or many at once.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "animation/analysis/clip_analysis.h"
#include "animation/captures/motion_reader.h"
#include "animation/clips/floor_fit.h"

namespace amble {

struct ClipReading {
  MotionReadOptions read;
  bool as_is = false;  ///< all frames, and the floor is z = 0: nothing is cut off or levelled
};

struct AnalysedClip {
  std::filesystem::path file;
  std::string error;      ///< what() of the InputError; empty where it could be read
  CapturedMotion motion;  ///< with the clip's skeleton, without its poses
  int file_frames = 0;    ///< of the file
  int first_frame = 0;    ///< of the file that is frame 0 of the analysis
  FloorFit floor;
  ClipAnalysis analysis;

  bool good() const { return error.empty(); }
};

/// @param file  that it is from, for messages. @throws InputError for a clip without frames
AnalysedClip analyseMotion(CapturedMotion motion, const std::filesystem::path& file, bool as_is);
/// The same of a file. @throws InputError as readMotion does too
AnalysedClip analyseFile(const std::filesystem::path& file, const ClipReading& how);

/// Each file on one of `threads` threads; the results are in the files' order and the same at any
/// number of threads. A file that cannot be read has its error and holds up no other.
/// @param done  called with how many are finished, from any thread; @return false to stop: the rest
/// are left out then
std::vector<AnalysedClip> analyseFiles(const std::vector<std::filesystem::path>& files,
                                       const ClipReading& how, int threads,
                                       const std::function<bool(int done)>& done);

}  // namespace amble
