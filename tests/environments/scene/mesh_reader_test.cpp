#include "environments/scene/mesh_reader.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "environments/scene/scene.h"
#include "test_paths.h"
#include "tests/environments/test_files.h"
#include "tests/environments/test_meshes.h"

namespace amble {
namespace {

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

// A disc, whose corners are those of one face.
std::string discObj(int corners) {
  std::string vertices, face = "f";
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * M_PI * k / corners;
    vertices +=
        "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    face += " " + std::to_string(k + 1);
  }
  return "o disc\n" + vertices + face + "\n";
}

// Cutting it up takes time of the square of its corners: 9 s for the largest.
TEST(ReadMesh, AFaceOfTooManyCornersIsRefusedBeforeItIsCutUp) {
  const TestFolder folder;
  for (const int corners : {10001, 200000}) {
    const auto file = folder.write("disc.obj", discObj(corners));
    EXPECT_EQ(errorOf([&] { readMesh(file); }),
              file.string() + ":" + std::to_string(corners + 2) + ": a face of 'disc' has " +
                  std::to_string(corners) + " corners; expected at most 10000 in a face");
  }
  const auto ply = folder.write("fan.ply", [] {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n0 0 0\n2 0 "
        "0\n0 1 0\n10002";
    for (int k = 0; k < 10002; ++k) text += " " + std::to_string(k % 3);
    return text + "\n";
  }());
  EXPECT_NE(errorOf([&] { readMesh(ply); }).find("has 10002 corners"), std::string::npos);
}

TEST(ReadMesh, AFaceOfThousandsOfCornersIsCutUpWhole) {
  const TestFolder folder;
  const MeshFile file = readMesh(folder.write("disc.obj", discObj(2000)));
  double area = 0.0;
  for (const auto& t : file.parts[0].mesh.triangles) {
    const auto& v = file.parts[0].mesh.vertices;
    area += 0.5 * (v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]).z();
  }
  EXPECT_NEAR(area, M_PI, 1e-4);
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

TEST(ReadMesh, WhatAnObjWarnsOfComesOutOfTheGuard) {
  const TestFolder folder;
  const std::filesystem::path file = folder.write("cube.obj", cubeObj() + "f 1 2\n");
  const MeshFile alone = readMesh(file);
  ASSERT_EQ(alone.warnings.size(), 1u);
  EXPECT_TRUE(alone.warnings[0].starts_with(file.string() + ":")) << alone.warnings[0];
  const std::filesystem::path whole = folder.write("whole.obj", cubeObj());
  const auto together = SmallMeshes({file, whole}).take();
  EXPECT_EQ(together.at(file).warnings, alone.warnings);
  EXPECT_TRUE(together.at(whole).warnings.empty());
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

// What each format's users have made of it, and right is one line, soon, within bounds.
TEST(ReadMesh, FilesMadeToBreakAReaderAreRefusedInOneLine) {
  const std::filesystem::path folder = std::filesystem::path(AMBLE_SHARED) / "cases" / "hostile";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the cases are not there";
  int tried = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".bvh") continue;
    const std::string error = errorOf([&] { readMesh(entry.path()); });
    EXPECT_TRUE(error.starts_with(entry.path().string() + ": ")) << entry.path() << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
    ++tried;
  }
  EXPECT_GE(tried, 9);
}

TEST(ReadMesh, WhatIsNoRegularFileIsNotOpened) {
  const TestFolder folder;
  const std::filesystem::path pipe = folder.path() / "mesh.obj";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_NE(errorOf([&] { readMesh(pipe); }).find("is no regular file"), std::string::npos);
}

TEST(ReadMesh, APipeThatAMeshNamesIsPassedOver) {
  const TestFolder folder;
  ASSERT_EQ(mkfifo((folder.path() / "looks.mtl").c_str(), 0600), 0);
  const MeshFile file = readMesh(folder.write("cube.obj", "mtllib looks.mtl\n" + cubeObj()));
  EXPECT_EQ(file.parts.size(), 1u);
}

// A triangle whose corners are in a file of `uri`.
std::string gltfOf(const std::string& uri, const std::string& more = "") {
  return R"({"asset":{"version":"2.0"},)" + more + R"("scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"name":"door","mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "buffers":[{"byteLength":36,"uri":")" +
         uri + R"("}]})";
}

const char* const kTriangle =
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAAA";

// Two triangles over four corners, the second one's last index as given.
TEST(ReadMesh, ATriangleOfAGltfWhoseCornerIsNotThereIsNamed) {
  const TestFolder folder;
  const float corners[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const auto square = [&](std::array<std::uint16_t, 6> indices) {
    std::string bytes(reinterpret_cast<const char*>(corners), sizeof corners);
    bytes.append(reinterpret_cast<const char*>(indices.data()), sizeof indices);
    folder.write("square.bin", bytes);
    return folder.write("square.gltf", R"({"asset":{"version":"2.0"},"scene":0,
      "scenes":[{"nodes":[0]}],"nodes":[{"name":"floor","mesh":0}],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
      "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
                   {"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],
      "bufferViews":[{"buffer":0,"byteLength":48},
                     {"buffer":0,"byteOffset":48,"byteLength":12}],
      "buffers":[{"byteLength":60,"uri":"square.bin"}]})");
  };
  const auto problemOf = [&](std::array<std::uint16_t, 6> indices) {
    const auto file = square(indices);
    return errorOf([&] { readMesh(file); });
  };
  EXPECT_EQ(problemOf({0, 1, 2, 0, 2, 3}), "");
  for (const std::uint16_t beyond : {4, 65535}) {
    for (const auto& indices : {std::array<std::uint16_t, 6>{0, 1, 2, 0, 2, beyond},
                                std::array<std::uint16_t, 6>{0, 1, beyond, 0, 2, beyond}}) {
      const std::string problem = problemOf(indices);
      EXPECT_NE(problem.find("square.gltf: a triangle names a vertex that is not there; expected"),
                std::string::npos)
          << problem;
    }
  }
}

TEST(ReadMesh, ReferencesOutOfTheFolderAreNotFollowed) {
  const TestFolder folder;
  const std::filesystem::path inner = folder.path() / "inner";
  std::filesystem::create_directories(inner);
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 2, 0};
  const std::string bytes(reinterpret_cast<const char*>(corners), sizeof corners);
  folder.write("outside.bin", bytes);
  folder.write("inner/inside.bin", bytes);
  const auto outside = folder.write("inner/outside.gltf", gltfOf("../outside.bin"));
  const auto inside = folder.write("inner/inside.gltf", gltfOf("inside.bin"));
  const auto far = folder.write("inner/far.gltf", gltfOf("http://127.0.0.1/outside.bin"));
  EXPECT_EQ(errorOf([&] { readMesh(inside); }), "");
  EXPECT_NE(errorOf([&] { readMesh(outside); }).find("it refers to '"), std::string::npos);
  EXPECT_NE(errorOf([&] { readMesh(far); }), "");
  // Nor by a link; while a mesh may itself be named by one.
  std::filesystem::create_symlink("../outside.bin", inner / "link.bin");
  const auto linked = folder.write("inner/linked.gltf", gltfOf("link.bin"));
  EXPECT_NE(errorOf([&] { readMesh(linked); }).find("it refers to '"), std::string::npos);
  std::filesystem::create_symlink("inner/inside.gltf", folder.path() / "named.gltf");
  std::filesystem::create_symlink("inner/inside.bin", folder.path() / "inside.bin");
  EXPECT_EQ(errorOf([&] { readMesh(folder.path() / "named.gltf"); }), "");
}

TEST(ReadMesh, WhatIsReadBesideTheFileIsToldAndNamedByItsAddress) {
  const TestFolder folder;
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 2, 0};
  const std::string bytes(reinterpret_cast<const char*>(corners), sizeof corners);
  const auto buffer = folder.write("my corners.bin", bytes);
  const auto coded = readMesh(folder.write("coded.gltf", gltfOf("my%20corners.bin")));
  EXPECT_EQ(coded.others, std::vector<std::string>{buffer.string()});
  // Materials of an OBJ say nothing of its shape.
  folder.write("looks.mtl", "newmtl a\n");
  const auto cube = readMesh(folder.write("cube.obj", "mtllib looks.mtl\n" + cubeObj()));
  EXPECT_TRUE(cube.others.empty());
}

TEST(ReadMesh, AMeshOfPointsSaysSo) {
  const TestFolder folder;
  const auto file =
      folder.write("cloud.ply",
                   "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                   "property float z\nend_header\n0 0 0\n1 0 0\n");
  EXPECT_NE(errorOf([&] { readMesh(file); }).find("only points or lines, no faces"),
            std::string::npos);
}

TEST(ReadMesh, WhatTakesTooMuchMemorySaysHowToLetIt) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "a sanitizer's memory has no bound";
#endif
  const TestFolder folder;
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 1000000; ++i) text += "f 1 2 3\n";
  const auto file = folder.write("faces.obj", text);
  const std::string error = errorOf([&] { readMesh(file, size_t{16} << 20); });
  EXPECT_NE(error.find("more than 16 MB of memory"), std::string::npos) << error;
  EXPECT_NE(error.find("--memory"), std::string::npos) << error;
  EXPECT_EQ(errorOf([&] { readMesh(file); }), "");
}

const std::string kFlat = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(SmallMeshes, GiveWhatEachAloneGives) {
  const TestFolder folder;
  const std::vector<std::filesystem::path> files = {
      folder.write("a.obj", kFlat), folder.write("b.obj", "o two\n" + kFlat),
      folder.write("ramp.dae", collada("0.01", "Z_UP"))};
  const auto together = SmallMeshes(files).take();
  ASSERT_EQ(together.size(), files.size());
  for (const std::filesystem::path& file : files) {
    const MeshFile alone = readMesh(file);
    const MeshFile& found = together.at(file);
    EXPECT_EQ(found.has_axes, alone.has_axes);
    ASSERT_EQ(found.parts.size(), alone.parts.size());
    EXPECT_EQ(found.parts[0].names, alone.parts[0].names);
    EXPECT_EQ(found.parts[0].mesh.vertices, alone.parts[0].mesh.vertices);
    EXPECT_EQ(found.parts[0].mesh.triangles, alone.parts[0].mesh.triangles);
  }
}

TEST(SmallMeshes, OfManyFilesEachIsItsOwn) {
  const TestFolder folder;
  std::vector<std::filesystem::path> files;
  for (int k = 1; k <= 9; ++k) {
    const std::string end = std::to_string(k);
    std::string text = "v 0 0 0\nv " + end + " 0 0\nv 0 1 0\nf 1 2 3\n";
    for (int line = 0; line < 40 * k; ++line) text += "# of different lengths\n";
    files.push_back(folder.write("m" + end + ".obj", text));
  }
  const auto together = SmallMeshes(files).take();
  ASSERT_EQ(together.size(), files.size());
  for (int k = 1; k <= 9; ++k)
    EXPECT_EQ(together.at(files[k - 1]).parts[0].mesh.vertices[1].x(), k);
}

TEST(SmallMeshes, LeaveOutWhatCannotBeRead) {
  const TestFolder folder;
  const auto good = folder.write("good.obj", kFlat), other = folder.write("other.obj", kFlat);
  const auto broken = folder.write("broken.obj", "this is\nno mesh\n");
  const std::vector<std::filesystem::path> files = {
      folder.write("chair.txt", "chair"), broken, good, other, "/nowhere/chair.obj", good};
  const auto together = SmallMeshes(files).take();
  ASSERT_EQ(together.size(), 2u);
  EXPECT_TRUE(together.contains(good) && together.contains(other));
}

// Nodes so deep that Assimp's parser runs out of stack.
TEST(SmallMeshes, WhereOneBreaksTheReaderTheOthersAreReadAlone) {
  const TestFolder folder;
  std::string deep = collada("1", "Z_UP");
  const size_t at = deep.find("<node ");
  std::string down, up;
  for (int k = 0; k < 60000; ++k) {
    down += "<node>";
    up += "</node>";
  }
  deep.insert(deep.find("</visual_scene>", at), up);
  deep.insert(at, down);
  folder.write("deep.dae", deep);
  folder.write("a.obj", kFlat);
  const std::vector<std::filesystem::path> both = {folder.path() / "a.obj",
                                                   folder.path() / "deep.dae"};
  EXPECT_TRUE(SmallMeshes(both).take().empty());
  const auto scene = folder.write("s.yaml",
                                  "objects:\n  - {name: a, mesh: a.obj, up: z}\n"
                                  "  - {name: deep, mesh: deep.dae}\n");
  const std::string error = errorOf([&] { readScene(scene); });
  EXPECT_NE(error.find("deep.dae: cannot be read: it breaks its reader"), std::string::npos)
      << error;
}

}  // namespace
}  // namespace amble
