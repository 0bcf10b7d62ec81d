/// A binary glTF 2.0 file as plain data: nodes, meshes, one skin, one animation.
///
/// Everything as the file has it: right-handed, y up, metres, seconds.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace amble {

struct GlbMaterial {
  std::string name;
  Eigen::Vector3f color = Eigen::Vector3f::Ones();  ///< linear RGB, times the vertices' [0 to 1]
  bool both_sides = false;                          ///< seen from behind as well
};

/// Triangles, or a line through all its vertices. What is empty is left out.
struct GlbPrimitive {
  int material = 0;  ///< index
  bool is_line = false;
  std::vector<Eigen::Vector3f> positions;            ///< never empty [m]
  std::vector<Eigen::Vector3f> normals;              ///< unit
  std::vector<std::array<std::uint16_t, 4>> colors;  ///< linear RGB and 65535
  std::vector<std::array<std::uint16_t, 4>> joints;  ///< indices in the skin
  std::vector<std::array<float, 4>> weights;
  std::vector<std::uint32_t> indices;
};

struct GlbMesh {
  std::string name;
  std::vector<GlbPrimitive> primitives;
};

struct GlbNode {
  std::string name;  ///< any bytes: made UTF-8 and unique as it is written
  int parent = -1;   ///< index of a node before it, or -1
  int mesh = -1;     ///< index or -1
  bool skinned = false;
  Eigen::Vector3f translation = Eigen::Vector3f::Zero();  ///< [m]
  Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();
  std::string extras;  ///< JSON, or ""
};

/// One joint's motion: as many as the file's times, or none.
struct GlbTrack {
  int node = 0;
  std::vector<Eigen::Vector3f> translations;  ///< [m]
  std::vector<Eigen::Quaternionf> rotations;  ///< unit, each on the shorter way from the one before
};

struct GlbFile {
  std::string name;  ///< of scene, skin and animation
  std::vector<GlbMaterial> materials;
  std::vector<GlbMesh> meshes;
  std::vector<GlbNode> nodes;
  std::vector<int> joints;                    ///< nodes of the skin; empty: no skin
  std::vector<Eigen::Matrix4f> inverse_bind;  ///< by joint
  std::vector<float> times;                   ///< of all tracks [s, rising]
  std::vector<GlbTrack> tracks;
  std::string extras;  ///< of the scene: JSON, or ""
};

/// The same data gives the same bytes. @throws std::runtime_error where it cannot be written
void writeGlbFile(std::ostream& out, const GlbFile& file);

}  // namespace amble
