#include "environments/scene/mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/rotation.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

Eigen::AlignedBox3d boundsOf(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices) box.extend(v);
  return box;
}

double volumeOf(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles)
    volume += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  return volume;
}

void expectBounds(const TriangleMesh& mesh, const Eigen::Vector3d& min,
                  const Eigen::Vector3d& max) {
  EXPECT_LT((boundsOf(mesh).min() - min).norm(), 1e-6) << boundsOf(mesh).min().transpose();
  EXPECT_LT((boundsOf(mesh).max() - max).norm(), 1e-6) << boundsOf(mesh).max().transpose();
}

std::string collada(const std::string& unit, const std::string& up) {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter=")" +
         unit + R"("/><up_axis>)" + up + R"(</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 100 0 0 0 200 300</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="ramp">
<translate>0 0 100</translate><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

TEST(ReadMesh, AMissingFileIsNamed) {
  EXPECT_EQ(errorOf([] { readMesh("/nowhere/chair.obj"); }),
            "/nowhere/chair.obj: no such file; expected a mesh as OBJ, glTF or GLB, PLY, STL, DAE, "
            "FBX or IFC");
}

TEST(ReadMesh, AnUnknownFormatIsRefused) {
  const TestFolder folder;
  const auto file = folder.write("chair.txt", "chair");
  EXPECT_NE(errorOf([&] { readMesh(file); }).find("not a format for meshes"), std::string::npos);
}

TEST(ReadMesh, ABrokenFileIsRefusedInOneLine) {
  const TestFolder folder;
  for (const char* name :
       {"broken.gltf", "broken.ply", "broken.fbx", "broken.dae", "broken.ifc", "broken.obj"}) {
    const auto file = folder.write(name, "this is\nno mesh\n");
    const std::string error = errorOf([&] { readMesh(file); });
    EXPECT_TRUE(error.starts_with(file.string() + ": ")) << name << ": " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST(ReadMesh, AMeshWithoutTrianglesIsRefused) {
  const TestFolder folder;
  const auto points = folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n");
  EXPECT_NE(errorOf([&] { readMesh(points); }), "");
  const auto line = folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  EXPECT_NE(errorOf([&] { readMesh(line); }).find("no triangles"), std::string::npos);
}

TEST(ReadMesh, ANumberThatIsNotFiniteIsRefused) {
  const TestFolder folder;
  for (const char* number : {"nan", "inf", "-inf", "1e400"}) {
    const auto file =
        folder.write("bad.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 ") + number + " 0\nf 1 2 3\n");
    EXPECT_NE(errorOf([&] { readMesh(file); }), "") << number;
  }
}

TEST(ReadMesh, AnObjIsLeftAsItIsAndSaysNoAxes) {
  const TestFolder folder;
  const MeshFile file = readMesh(folder.write("cube.obj", cubeObj()));
  EXPECT_FALSE(file.has_axes);
  ASSERT_EQ(file.parts.size(), 1u);
  EXPECT_EQ(file.parts[0].names, std::vector<std::string>{"cube"});
  EXPECT_EQ(file.parts[0].mesh.triangles.size(), 12u);
  EXPECT_EQ(file.parts[0].mesh.vertices.size(), 8u);
  expectBounds(file.parts[0].mesh, {0, 0, 0}, {1, 1, 1});
  EXPECT_NEAR(volumeOf(file.parts[0].mesh), 1.0, 1e-12);
}

TEST(ReadMesh, ObjectsAndGroupsOfAnObjAreParts) {
  const TestFolder folder;
  const MeshFile file = readMesh(folder.write(
      "two.obj",
      "o seat\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ng legs\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 4 5 6\n"));
  ASSERT_EQ(file.parts.size(), 2u);
  EXPECT_EQ(file.parts[0].names.front(), "seat");
  EXPECT_EQ(file.parts[1].names.front(), "legs");
}

TEST(ReadMesh, EqualVerticesAreJoinedAndEmptyTrianglesDropped) {
  const TestFolder folder;
  const MeshFile file = readMesh(folder.write("quad.obj",
                                              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 "
                                              "0\nf 1 2 3\nf 4 5 6\nf 1 4 2\nf 1 5 3\n"));
  EXPECT_EQ(file.parts[0].mesh.vertices.size(), 4u);
  EXPECT_EQ(file.parts[0].mesh.triangles.size(), 2u);
}

TEST(ReadMesh, ColladaSaysItsUnitAndAxes) {
  const TestFolder folder;
  // Corners (0,0,0) (100,0,0) (0,200,300) moved by 100 along the file's z, in centimetres.
  const MeshFile y_up = readMesh(folder.write("y.dae", collada("0.01", "Y_UP")));
  EXPECT_TRUE(y_up.has_axes);
  expectBounds(y_up.parts[0].mesh, {0, -4, 0}, {1, -1, 2});
  const MeshFile z_up = readMesh(folder.write("z.dae", collada("0.01", "Z_UP")));
  expectBounds(z_up.parts[0].mesh, {0, 0, 1}, {1, 2, 4});
  const MeshFile metres = readMesh(folder.write("m.dae", collada("1", "Z_UP")));
  expectBounds(metres.parts[0].mesh, {0, 0, 100}, {100, 200, 400});
  EXPECT_EQ(z_up.parts[0].names.front(), "ramp");
}

TEST(ReadMesh, GltfIsYUpWithItsNodesPlaced) {
  const TestFolder folder;
  // Corners (0,0,0) (1,0,0) (0,2,0) as little-endian floats, under a node moved by (0, 0, 3).
  const MeshFile file = readMesh(folder.write("t.gltf", R"({"asset":{"version":"2.0"},"scene":0,
    "scenes":[{"nodes":[0]}],"nodes":[{"name":"cupboard","children":[1]},{"name":"door","mesh":0,"translation":[0,0,3]}],
    "meshes":[{"name":"leaf","primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,2,0]}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAAA"}]})"));
  EXPECT_TRUE(file.has_axes);
  ASSERT_EQ(file.parts.size(), 1u);
  expectBounds(file.parts[0].mesh, {0, -3, 0}, {1, -3, 2});
  const auto& names = file.parts[0].names;
  EXPECT_EQ(names.front(), "door");
  EXPECT_NE(std::find(names.begin(), names.end(), "cupboard"), names.end());
}

TEST(ReadMesh, StlAndPlyAreRead) {
  const TestFolder folder;
  const std::string stl =
      "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\nendsolid t\n";
  expectBounds(readMesh(folder.write("t.stl", stl)).parts[0].mesh, {0, 0, 0}, {1, 1, 0});
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n0 1 0\n3 "
      "0 1 2\n";
  expectBounds(readMesh(folder.write("t.ply", ply)).parts[0].mesh, {0, 0, 0}, {2, 1, 0});
}

// Debian's package assimp-testmodels.
const std::filesystem::path kModels = "/usr/share/assimp/models";

TEST(ReadMesh, FbxSaysItsUnitAndAxes) {
  const auto file = kModels / "FBX" / "cubes_with_names.fbx";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "assimp-testmodels is not installed";
  const MeshFile mesh = readMesh(file);
  EXPECT_TRUE(mesh.has_axes);
  // y up, unit 1 cm: a cube of side 1 whose node scales it by 10.
  const auto cube = std::find_if(mesh.parts.begin(), mesh.parts.end(),
                                 [](const MeshPart& p) { return p.names.front() == "Cube2"; });
  ASSERT_NE(cube, mesh.parts.end());
  EXPECT_LT((boundsOf(cube->mesh).sizes() - Eigen::Vector3d::Constant(0.1)).norm(), 1e-5);
}

TEST(ReadMesh, AnIfcHouseStandsUprightInMetresWithoutItsRooms) {
  const auto file = kModels / "IFC" / "AC14-FZK-Haus.ifc";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "assimp-testmodels is not installed";
  const MeshFile house = readMesh(file);
  EXPECT_TRUE(house.has_axes);
  Eigen::AlignedBox3d walls;
  int doors = 0;
  for (const MeshPart& part : house.parts) {
    for (const std::string& name : part.names) {
      EXPECT_FALSE(name.starts_with("IfcSpace") || name.starts_with("IfcOpening")) << name;
      EXPECT_FALSE(name.starts_with("$")) << name;
    }
    const std::string& name = part.names.front();
    if (name.starts_with("IfcWallStandardCase_Wand-Ext-ERDG")) walls.extend(boundsOf(part.mesh));
    doors += std::any_of(part.names.begin(), part.names.end(),
                         [](const std::string& n) { return n.starts_with("IfcDoor"); });
  }
  EXPECT_NEAR(walls.sizes().x(), 12.0,
              1e-3);  // the ground floor's outer walls, as the file places them
  EXPECT_NEAR(walls.min().z(), 0.0, 0.3);
  EXPECT_LT(walls.sizes().z(), 4.0);
  EXPECT_EQ(doors, 5);
}

TEST(Primitives, AreClosedAndOfTheirVolume) {
  const std::vector<std::pair<TriangleMesh, double>> shapes = {
      {makeBox({1, 2, 3}), 6.0},
      {makeCylinder(0.5, 2.0, 96), kPi * 0.25 * 2.0},
      {makeSphere(0.5, 96), kPi / 6.0},
      {makeCapsule(0.5, 2.0, 96), kPi / 6.0 + kPi * 0.25}};
  for (const auto& [mesh, volume] : shapes) {
    const auto pieces = splitComponents(mesh);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_TRUE(pieces[0].closed);
    EXPECT_NEAR(volumeOf(mesh), volume, 0.004 * volume);
    EXPECT_LE(volumeOf(mesh), volume + 1e-12);
  }
}

TEST(Primitives, AreCentredWithTheirWholeHeight) {
  expectBounds(makeCapsule(0.25, 1.0), {-0.25, -0.25, -0.5}, {0.25, 0.25, 0.5});
  expectBounds(makeCylinder(0.25, 1.0), {-0.25, -0.25, -0.5}, {0.25, 0.25, 0.5});
  expectBounds(makeBox({1, 2, 3}), {-0.5, -1, -1.5}, {0.5, 1, 1.5});
}

TEST(SplitComponents, PartsThatShareNoEdgeAreApart) {
  TriangleMesh mesh = makeBox({1, 1, 1});
  const TriangleMesh other = makeBox({1, 1, 1});
  const int base = static_cast<int>(mesh.vertices.size());
  for (const Eigen::Vector3d& v : other.vertices)
    mesh.vertices.push_back(v + Eigen::Vector3d(3, 0, 0));
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  mesh.triangles.pop_back();
  const auto pieces = splitComponents(mesh);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_TRUE(pieces[0].closed);
  EXPECT_FALSE(pieces[1].closed);
  EXPECT_EQ(pieces[1].mesh.triangles.size(), 11u);
}

TEST(SplitComponents, VerticesOfTheSamePlaceCloseAMesh) {
  TriangleMesh soup;
  const TriangleMesh box = makeBox({1, 1, 1});
  for (const auto& t : box.triangles) {
    const int base = static_cast<int>(soup.vertices.size());
    for (int v : t) soup.vertices.push_back(box.vertices[v]);
    soup.triangles.push_back({base, base + 1, base + 2});
  }
  const auto pieces = splitComponents(soup);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_TRUE(pieces[0].closed);
}

TEST(SplitComponents, OfNothingIsNothing) { EXPECT_TRUE(splitComponents({}).empty()); }

}  // namespace
}  // namespace amble
