/// One motion more in a library, from a capture (Pettré §4.1).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "animation/captures/motion_reader.h"
#include "animation/clips/level_capture.h"
#include "animation/library/motion_library.h"

namespace amble {

struct MotionRequest {
  std::string name;
  MotionKind kind = MotionKind::kWalk;
  std::optional<bool> turning;  ///< of a walk; none: a turn if the clip ends facing elsewhere
  std::string style;            ///< of what has one (hasStyle), or ""
  Validity valid;
  std::vector<std::string> chains;  ///< of a movement or a posture; empty: all
  std::filesystem::path file;       ///< the capture
  MotionReadOptions read;           ///< how to read it
  /// `clip` is what the library calls it; `frames` come out. With a `speed`, `file` is a speed
  /// engine; without licence and credit they are then those of its captures.
  MotionSource source;
  std::optional<std::pair<int, int>> frames;  ///< of the file: look only there
  int harmonics = 0;                          ///< of a cycle [1, 12]; 0: chosen by error
};

/// Whether it is for the posture `stand`, which all cycles refer to.
inline bool isStand(const MotionRequest& request) {
  return request.name == "stand" && request.kind == MotionKind::kPosture;
}

/// A capture as libraries take it: on a level floor, with toes, feet that are flat at rest and
/// names as BVH has them. @throws InputError naming the file
/// @param warnings  as addMotion has them
LevelCapture readForLibrary(const std::filesystem::path& file, const MotionReadOptions& read,
                            std::vector<std::string>* warnings = nullptr);

/// Its clip on the library's skeleton. The first capture's becomes the library's; others are
/// carried over to it. Where the library has no posture `stand`, that of the library `default` is
/// carried over, unless the capture is the one of which it will be made.
/// @param file  for messages @throws InputError
Clip clipForLibrary(MotionLibrary& library, const LevelCapture& capture, const std::string& file,
                    bool for_stand = false);

/// Prepares the motion and appends it. The first capture's skeleton is the library's; others are
/// carried over to it by role and leg length. Where there is no posture `stand` before the first
/// motion that needs one, the library `default`'s is carried over. Behind the first, the order of
/// motions does not matter (library_soles.h); one that is refused leaves the library as it was.
/// @throws InputError naming the file where the capture does not hold what is asked: no steady
/// cycle, a turn that is called straight, no toes, a name that the library has.
/// @param warnings  if not null, what is unsure of the capture is appended, the file's name before
void addMotion(MotionLibrary& library, const MotionRequest& request,
               std::vector<std::string>* warnings = nullptr);

/// The captured cycles that a walk or a movement of the library is the average of, each as a series
/// in the library's channels that leaves nothing of it out; mirrored where the motion is.
/// @param file  the capture @throws InputError also where it does not give this motion's cycle
std::vector<FourierSeries> capturedCycles(const MotionLibrary& library, const Motion& motion,
                                          const std::filesystem::path& file,
                                          const MotionReadOptions& read = {});

}  // namespace amble
