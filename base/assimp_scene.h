/// What all that reads through Assimp shares: axes and unit of a scene, its names, its errors.
/// Assimp's own headers stay in .cpp files.
#pragma once

#include <Eigen/Geometry>
#include <string>

struct aiNode;
struct aiScene;

namespace amble {

/// Takes an FBX file's axes to World and its unit to metres; Assimp leaves both in the scene's
/// metadata. @throws InputError naming `file` where the axes are not three.
Eigen::Affine3d fbxToWorld(const aiScene& scene, const std::string& file);
/// Length of an FBX file's unit [m].
double fbxUnit(const aiScene& scene);
/// X_PN, a node in its parent.
Eigen::Affine3d nodeTransform(const aiNode& node);
/// Without control characters and a full stop at the end: messages are one line.
std::string oneLine(std::string text);

}  // namespace amble
