#include "base/assimp_scene.h"

#include <assimp/scene.h>

#include <cctype>
#include <cmath>
#include <set>

#include "base/error.h"

namespace amble {
namespace {

int metadataInt(const aiScene& scene, const char* key, int fallback) {
  int value = fallback;
  return scene.mMetaData && scene.mMetaData->Get(key, value) ? value : fallback;
}

}  // namespace

double fbxUnit(const aiScene& scene) {
  double centimetres = 1.0;
  if (scene.mMetaData) {
    float single = 1.0f;
    if (!scene.mMetaData->Get("UnitScaleFactor", centimetres) &&
        scene.mMetaData->Get("UnitScaleFactor", single))
      centimetres = single;
  }
  if (!(centimetres > 0.0) || !std::isfinite(centimetres)) centimetres = 1.0;
  return 0.01 * centimetres;
}

Eigen::Affine3d fbxToWorld(const aiScene& scene, const std::string& file) {
  const int up = metadataInt(scene, "UpAxis", 1), front = metadataInt(scene, "FrontAxis", 2);
  const int side = metadataInt(scene, "CoordAxis", 0);
  if (std::set<int>{up, front, side} != std::set<int>{0, 1, 2})
    throw InputError(file, 0, "its axes are not three", "UpAxis, FrontAxis and CoordAxis 0 to 2");
  Eigen::Matrix3d R = Eigen::Matrix3d::Zero();  // rows: x, y, z of World
  R(0, side) = metadataInt(scene, "CoordAxisSign", 1);
  R(1, front) = -metadataInt(scene, "FrontAxisSign", 1);
  R(2, up) = metadataInt(scene, "UpAxisSign", 1);
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  X.linear() = fbxUnit(scene) * R;
  return X;
}

Eigen::Affine3d nodeTransform(const aiNode& node) {
  const aiMatrix4x4& m = node.mTransformation;
  Eigen::Affine3d X;
  X.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2,
      m.d3, m.d4;
  return X;
}

std::string oneLine(std::string text) {
  for (char& c : text)
    if (std::iscntrl(static_cast<unsigned char>(c))) c = ' ';
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

}  // namespace amble
