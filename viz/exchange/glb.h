/// Motion as binary glTF: an animated skeleton with the skinned figure, and what is known of the
/// walk.
///
/// Nodes: a joint each, of the joints' own names (made unique); `figure`; `root path`; `footprints`
/// with one a print below it, `footprint 1 left`; `scene` with its objects below it. A frame of the
/// animation is a frame of the motion, and what viewers show between two of them is what was
/// checked (DESIGN.md, section 3): the root goes straight, joints turn by slerp. World (x, y, z) is
/// glTF's (x, z, -y).
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "animation/body/clip.h"
#include "viz/figure/figure.h"
#include "viz/walk_view.h"

namespace amble {

/// A scene of more triangles is thinned (viz/pictures/thin_mesh.h); the node says so.
inline constexpr size_t kMostGlbTriangles = 300000;

/// Any clip. @param figure  of its skeleton. @pre the clip has frames
void writeGlb(std::ostream& out, const Clip& clip, const Figure& figure);

struct GlbWalkOptions {
  bool scene = true;
  std::vector<std::string> joint_names = {};  ///< by joint; empty: the skeleton's own
  /// Of the run, as writeJson() has it, or "": the file's scene has it in its extras, but for its
  /// times, which are other ones each time.
  std::string report = {};
};

/// A planned walk. @param figure  of its body. @pre view.hasBody()
void writeGlb(std::ostream& out, const WalkView& view, const Figure& figure,
              const GlbWalkOptions& options = {});

}  // namespace amble
