#include "environments/scene/mesh_header.h"

#include <gtest/gtest.h>

#include "tests/environments/test_files.h"

namespace amble {
namespace {

std::string problemOf(const std::filesystem::path& file) {
  return errorOf([&] { checkMeshHeader(file); });
}

TEST(MeshHeader, AnIfcOfAnotherSchemaIsNamedByIt) {
  const TestFolder folder;
  const auto ifc = [&](const std::string& schema) {
    return folder.write("house.ifc",
                        "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('" + schema + "'));\nENDSEC;\n");
  };
  EXPECT_EQ(problemOf(ifc("IFC2X3")), "");
  EXPECT_EQ(problemOf(ifc("ifc2x3")), "");
  EXPECT_NE(problemOf(ifc("IFC4")).find("is of the schema IFC4; expected IFC2X3"),
            std::string::npos);
  EXPECT_NE(problemOf(ifc("IFC4X3_ADD2")).find("IFC4X3_ADD2"), std::string::npos);
  EXPECT_NE(problemOf(folder.write("none.ifc", "ISO-10303-21;\n")).find("says no schema"),
            std::string::npos);
}

TEST(MeshHeader, EveryRequiredExtensionThatChangesShapesIsNamed) {
  const TestFolder folder;
  const auto gltf = [&](const std::string& name) {
    return folder.write("room.gltf", R"({"asset": {"version": "2.0"}, "extensionsRequired": [")" +
                                         name + R"("], "extensionsUsed": ["X"]})");
  };
  for (const char* name : {"EXT_mesh_gpu_instancing", "KHR_draco_mesh_compression", "ACME_rooms"}) {
    EXPECT_NE(problemOf(gltf(name)).find(std::string("requires the extension ") + name),
              std::string::npos);
  }
  for (const char* name : {"KHR_materials_unlit", "KHR_texture_transform", "KHR_lights_punctual"})
    EXPECT_EQ(problemOf(gltf(name)), "") << name;
}

TEST(MeshHeader, AnExtensionThatIsOnlyUsedIsNotRequired) {
  const TestFolder folder;
  EXPECT_EQ(problemOf(folder.write("room.gltf", R"({"extensionsUsed": ["ACME_rooms"]})")), "");
}

TEST(MeshHeader, AGlbIsAsLongAsItSays) {
  const TestFolder folder;
  const auto glb = [&](char whole, char chunk) {
    return folder.write("room.glb", std::string("glTF\x02\0\0\0", 8) + whole +
                                        std::string("\0\0\0", 3) + chunk +
                                        std::string("\0\0\0JSON{}", 9));
  };
  EXPECT_EQ(problemOf(glb(22, 2)), "");
  EXPECT_NE(problemOf(glb(23, 2)).find("shorter than its header says"), std::string::npos);
  EXPECT_NE(problemOf(glb(22, 3)).find("shorter than its header says"), std::string::npos);
  EXPECT_NE(problemOf(folder.write("cut.glb", "glTF")).find("is no GLB"), std::string::npos);
}

TEST(MeshHeader, OtherFormatsSayNothing) {
  const TestFolder folder;
  EXPECT_EQ(problemOf(folder.write("cube.obj", cubeObj())), "");
}

}  // namespace
}  // namespace amble
