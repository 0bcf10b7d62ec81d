/// The default library with turns on the spot of captures, and their mirror images.
#pragma once

#include "animation/preparation/motion_library_add.h"
#include "tests/animation/captures.h"
#include "tests/animation/default_library.h"

namespace amble {

/// @param clip  within mocap/
inline MotionRequest turnOf(const std::string& name, const std::string& clip) {
  MotionRequest request;
  request.name = name;
  request.kind = MotionKind::kTurnOnSpot;
  request.file = sharedFolder() / "mocap" / clip;
  request.source = {clip, {0, 0}, false, "as the captures'", "their makers"};
  return request;
}

/// Turns that people make who stand, by 88 degrees while dribbling a ball and by 186, and by 171 in
/// the middle of a walk; each to both sides.
inline const MotionLibrary& turningLibrary() {
  static const MotionLibrary library = [] {
    MotionLibrary made = defaultLibrary();
    for (MotionRequest request :
         {turnOf("quarter", "cmu_mb2/06_10.bvh"), turnOf("half", "cmu_mb2/01_01.bvh"),
          turnOf("about", "accad_female1/Female1_B15_WalkTurnAround180.bvh")}) {
      if (request.name == "quarter") request.frames = {225, 380};
      addMotion(made, request);
      request.name += "-mirrored";
      request.source.mirrored = true;
      addMotion(made, request);
    }
    return made;
  }();
  return library;
}

}  // namespace amble
