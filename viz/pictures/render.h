/// Pictures of a walk, drawn in software: no display, no graphics card. The same walk gives the
/// same bytes.
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

#include "viz/pictures/image.h"
#include "viz/pictures/walk_shot.h"
#include "viz/walk_view.h"

namespace amble {

struct RenderSettings {
  int width = 1600;    ///< [pixels, 16 to 8192]
  int height = 1000;   ///< [pixels, 16 to 8192]
  double every = 0.5;  ///< no two bodies are closer in time [s, > 0]
  double apart = 0.5;  ///< nor, one after another, in place: else slow ones merge [m, >= 0]
  PointOfView from = PointOfView::kCorner;
  /// Of the room's four corners the one to look from [0 to 3]; none: the best for this walk.
  std::optional<int> corner = {};
  int threads = 1;  ///< change no byte of the picture [>= 1]

  /// Of a picture in which these frames are to be seen.
  ShotSettings shot(std::vector<int> frames) const {
    return {from, corner, width, height, std::move(frames), threads};
  }
};

/// walk.png: the walk in its room, seen from a raised corner unless another point of view is asked
/// for; bodies half a second and half a metre
/// apart, coloured by time, with footprints and root path on the floor. Walls towards the eye are
/// cut and ceilings left out (viz/pictures/room.h).
/// Without a walk it shows the room, how far one gets in it and what stood in the way, in words
/// too.
Image renderWalk(const WalkView& view, const RenderSettings& settings = {});

/// The frames of its bodies: the first and the last, and between them those that are far enough
/// from the one before. Ascending; one where nobody moves, none without a body.
std::vector<int> bodyFrames(const WalkView& view, const RenderSettings& settings);

struct StripSettings {
  int first = 0;          ///< frame of the first picture [>= 0]
  int step = 4;           ///< frames between two pictures [>= 1]
  int pictures = 24;      ///< fewer where the walk ends before [>= 1]
  int columns = 8;        ///< [>= 1]
  int tile_width = 240;   ///< [pixels, >= 16]
  int tile_height = 320;  ///< [pixels, >= 16]
  double window =
      2.1;  ///< height of what a tile shows of an adult; of others in proportion [m, > 0]
  /// Where the eye is, from the walker's heading, left positive: -pi/2 shows the right side, 0 the
  /// front [rad].
  double side = -1.5707963267948966;
  double lift = 0.0;  ///< how high the eye is above the horizon [rad, -0.2 to 1.5]
  int threads = 1;    ///< change no byte of the picture [>= 1]
};

/// All of a walk: ten pictures a second, fewer where that were more than 120.
StripSettings stripOfWhole(const AnimationBuffer& walk);

/// strip.png: a film strip to look at feet with: frames one after another, seen in parallel from
/// the walker's side, root held in the middle, the ground and all else in the walker's plane as
/// lines, the ground with a mark every 10 cm; left limbs blue, right orange, a bar under each foot
/// that is planted, the frame's number and time above.
Image renderStrip(const WalkView& view, const StripSettings& settings = {});

}  // namespace amble
