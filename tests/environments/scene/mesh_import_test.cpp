#include "environments/scene/mesh_import.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "base/file_axes.h"
#include "base/rotation.h"
#include "tests/environments/test_files.h"
#include "tests/environments/test_meshes.h"

namespace amble {
namespace {

/// A tetrahedron, its faces counter-clockwise from outside.
const TriangleMesh kSolid{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}},
                          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  char number[32];
  for (const double value : values) {
    std::snprintf(number, sizeof number, "%.9g", value);
    text += (text.empty() ? "[" : ", ") + std::string(number);
  }
  return text + "]";
}

/// A place in a file: translation, then rotation, then scale, as glTF's nodes have them.
struct NodePlace {
  Eigen::Vector3d t;
  Eigen::Quaterniond q;
  Eigen::Vector3d s;

  Eigen::Affine3d transform() const {
    return Eigen::Translation3d(t) * q * Eigen::Affine3d(Eigen::Scaling(s));
  }
  std::string json() const {
    return R"("translation": )" + numbers({t.x(), t.y(), t.z()}) + R"(, "rotation": )" +
           numbers({q.x(), q.y(), q.z(), q.w()}) + R"(, "scale": )" +
           numbers({s.x(), s.y(), s.z()});
  }
};

NodePlace randomPlace(std::mt19937_64& generator, bool mirrored) {
  std::uniform_real_distribution<double> place(-3, 3), turn(-3, 3), size(0.4, 1.8);
  const double scale = size(generator);
  return {{place(generator), place(generator), place(generator)},
          expRotation({turn(generator), turn(generator), turn(generator)}),
          {mirrored ? -scale : scale, scale, scale}};
}

/// The solid below three nodes that hang on one another, the corners in a file beside.
std::filesystem::path writeNested(const TestFolder& folder, const std::vector<NodePlace>& nodes) {
  std::string bytes;
  for (const Eigen::Vector3d& v : kSolid.vertices)
    for (int k = 0; k < 3; ++k) {
      const float value = static_cast<float>(v[k]);
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
  for (const auto& t : kSolid.triangles)
    for (const int v : t) {
      const unsigned short index = static_cast<unsigned short>(v);
      bytes.append(reinterpret_cast<const char*>(&index), sizeof index);
    }
  folder.write("solid.bin", bytes);
  std::string list;
  for (size_t i = 0; i < nodes.size(); ++i) {
    const bool last = i + 1 == nodes.size();
    list += (i == 0 ? "" : ", ") + std::string(R"({"name": "node)") + std::to_string(i) + R"(", )" +
            nodes[i].json() +
            (last ? R"(, "mesh": 0})" : R"(, "children": [)" + std::to_string(i + 1) + "]}");
  }
  return folder.write("nested.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
    "scenes": [{"nodes": [0]}], "nodes": [)" +
                                         list + R"(],
    "meshes": [{"name": "solid", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                   "min": [0, 0, 0], "max": [1, 2, 3]},
                  {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
    "buffers": [{"byteLength": 72, "uri": "solid.bin"}]})");
}

TEST(ImportMesh, NodesOnNodesPlaceAMeshAsTheirProductDoes) {
  const TestFolder folder;
  std::mt19937_64 generator(81);
  for (int n = 0; n < 8; ++n) {
    const std::vector<NodePlace> nodes = {randomPlace(generator, false),
                                          randomPlace(generator, n % 2 == 1),
                                          randomPlace(generator, false)};
    Eigen::Affine3d X = Eigen::Affine3d::Identity();
    for (const NodePlace& node : nodes) X = X * node.transform();
    const MeshFile file = importMesh(writeNested(folder, nodes));
    ASSERT_EQ(file.parts.size(), 1u);
    const TriangleMesh& mesh = file.parts[0].mesh;
    ASSERT_EQ(mesh.triangles.size(), kSolid.triangles.size());
    for (const Eigen::Vector3d& corner : kSolid.vertices) {
      const Eigen::Vector3d expected = fileToWorld(X * corner, UpAxis::kY);
      double nearest = 1.0;
      for (const Eigen::Vector3d& v : mesh.vertices)
        nearest = std::min(nearest, (v - expected).norm());
      EXPECT_LT(nearest, 1e-4);
    }
    // Mirrored or not, it is wound outwards.
    EXPECT_NEAR(volumeOf(mesh), std::abs(X.linear().determinant()), 1e-3);
  }
}

TEST(ImportMesh, APartHasTheNamesOfWhatItHangsUnderNearestFirst) {
  const TestFolder folder;
  std::mt19937_64 generator(82);
  const std::vector<NodePlace> nodes(3, randomPlace(generator, false));
  const auto names = importMesh(writeNested(folder, nodes)).parts.at(0).names;
  const std::vector<std::string> expected = {"node2", "solid", "node1", "node0"};
  EXPECT_EQ(names, expected);
}

TEST(ImportMesh, OfManyGroupsNothingIsLost) {
  const TestFolder folder;
  std::string text;
  for (int i = 0; i < 20; ++i) {
    text += "o thing" + std::to_string(i) + "\n";
    for (const Eigen::Vector3d& v : kSolid.vertices)
      text += "v " + std::to_string(v.x() + 3 * i) + " " + std::to_string(v.y()) + " " +
              std::to_string(v.z()) + "\n";
    for (const auto& t : kSolid.triangles)
      text += "f " + std::to_string(4 * i + t[0] + 1) + " " + std::to_string(4 * i + t[1] + 1) +
              " " + std::to_string(4 * i + t[2] + 1) + "\n";
  }
  const MeshFile file = importMesh(folder.write("many.obj", text));
  ASSERT_EQ(file.parts.size(), 20u);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(file.parts[i].names.front(), "thing" + std::to_string(i));
    EXPECT_NEAR(volumeOf(file.parts[i].mesh), 1.0, 1e-5);
    EXPECT_NEAR(boundsOf(file.parts[i].mesh).min().x(), 3.0 * i, 1e-5);
  }
}

TEST(ImportMesh, EndingsAreKnownInAnyCase) {
  EXPECT_EQ(meshEnding("a/B.c/House.OBJ"), ".obj");
  EXPECT_EQ(meshEnding("noending"), "");
  for (const char* known : {".obj", ".gltf", ".glb", ".ply", ".stl", ".dae", ".fbx", ".ifc"})
    EXPECT_TRUE(isMeshEnding(known)) << known;
  for (const char* unknown : {"", ".txt", ".yaml", ".bvh2"})
    EXPECT_FALSE(isMeshEnding(unknown)) << unknown;
}

}  // namespace
}  // namespace amble
