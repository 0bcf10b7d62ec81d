/// From where a picture of a walk is taken, and the room as it is seen from there.
#pragma once

#include <optional>
#include <vector>

#include "viz/pictures/camera.h"
#include "viz/pictures/lighting.h"
#include "viz/pictures/rasterizer.h"
#include "viz/walk_view.h"

namespace amble {

/// The points of view; the first three are those of Pettré's figure 9.
enum class PointOfView {
  kTop,     ///< straight from above, without perspective
  kSide,    ///< from the side of the way from start to goal, hardly raised
  kCorner,  ///< from the corner of the room from which most of the walk is seen, and widest
  kFirst,   ///< by the walker's eyes, in the middle of the walk
};

struct ShotSettings {
  PointOfView from = PointOfView::kCorner;
  std::optional<int> corner = {};  ///< of kCorner the one that is meant [0 to 3]
  int width = 1600;                ///< [pixels, 16 to 8192]
  int height = 1000;               ///< [pixels, 16 to 8192]
  std::vector<int> frames;         ///< in which the walk is to be seen
  int threads = 1;                 ///< change no byte of the picture [>= 1]
};

/// What a picture shows before bodies are drawn: the room with the marks on the floor, and the
/// light in it.
struct WalkShot {
  Camera camera;
  std::vector<DrawTriangle> triangles;
  LightSettings light;
};
WalkShot takeShot(const WalkView& view, const ShotSettings& settings);

/// The frame in which kFirst is taken.
int middleFrame(const WalkView& view);

}  // namespace amble
