/// The page of captured motion: whoever moves in each clip, and what analysis finds in it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "animation/analysis/clip_analysis.h"
#include "animation/analysis/plant_signals.h"
#include "animation/captures/motion_reader.h"
#include "animation/clips/floor_fit.h"
#include "environments/body/body.h"
#include "environments/ground/scene_ground.h"
#include "viz/page/page.h"

namespace amble {

/// A capture with what is known of it.
struct ShownClip {
  std::string file;                               ///< as it was asked for
  std::string name;                               ///< of the file, without its folder
  CapturedMotion motion;                          ///< every frame of the file, or every `every`th
  int file_frames = 0;                            ///< of the file
  int every = 1;                                  ///< [>= 1]; thin_clips.h
  double floor = 0.0;                             ///< that it is on [m, World]
  std::optional<Body> body;                       ///< none where nobody is found in the skeleton
  std::optional<ClipAnalysis> analysis;           ///< the same
  FloorFit fit;                                   ///< of the floor, for the analysis
  std::optional<std::array<PlantTrace, 2>> feet;  ///< by Side, of the analysis' frames
  int first_frame = 0;                            ///< of the file, that is frame 0 of the analysis
};

/// Reads a capture, finds its floor, body, plants and events. @throws InputError as readMotion
ShownClip readShownClip(const std::filesystem::path& file, const MotionReadOptions& options);
/// The same of a part of it, of the file's frames, which is then all that there is; as in a mirror
/// if that is asked for. @throws InputError where the part is not within the file
struct ShownPart {
  std::array<int, 2> frames = {0, 0};  ///< first and last [>= 0]
  bool mirrored = false;
};
ShownClip readShownPart(const std::filesystem::path& file, const ShownPart& part);
/// The same of a walk in a scene: floor and plants are over its ground.
ShownClip readWalkIn(const Scene& scene, const std::filesystem::path& file,
                     const MotionReadOptions& options);

/// @pre the clips, and the scene, outlive it; there is a clip. @param scene  null: an empty floor
PageSubject clipPage(const std::vector<ShownClip>& clips, const Scene* scene = nullptr);

}  // namespace amble
