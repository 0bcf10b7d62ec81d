/// A file's nodes with all of its animations, whichever format it is: what the readers of the
/// formats give to node_file.h. They run inside its guard.
#pragma once

#include <string>
#include <vector>

#include "animation/captures/capture_file.h"
#include "animation/captures/node_animation.h"

namespace amble {

struct NodeScene {
  AnimatedNodes nodes;  ///< at rest, without tracks; X_WFile as the file says
  std::vector<NodeTake> takes;
  double metres_per_unit = 1.0;  ///< as the file says [m]
  UpAxis up = UpAxis::kY;
};

/// A file by its name, or its bytes where they are there already.
struct NodeSource {
  std::string name;
  const std::string_view* bytes = nullptr;  ///< null: to be read from the file
};

/// FBX and Collada. @throws InputError with a line where Assimp names one.
NodeScene assimpScene(const NodeSource& source);
/// A helper of an FBX node's turn is a node of its own above it. Where none of them is animated the
/// node's own tracks are its whole place, as Assimp has them: the helpers are folded into it.
void foldPivots(AnimatedNodes& scene);

/// glTF, GLB and VRM animation. @throws InputError
NodeScene gltfScene(const NodeSource& source);

/// What they expected, for messages.
inline constexpr const char* kNodeFile = "animation of a skeleton as FBX, glTF, GLB, VRMA or DAE";
/// Far more than a person's; a scene around one has some thousands.
inline constexpr size_t kMaxNodes = 100'000;

}  // namespace amble
