#include "environments/scene/kept_meshes.h"

#include <gtest/gtest.h>

#include "environments/scene/scene.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

constexpr const char* kTent = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n";

std::string sceneOf(const std::string& mesh) {
  return "objects:\n  - {name: thing, mesh: " + mesh + ", up: z}\n";
}

TEST(KeptMeshes, WhatWasReadIsFoundUntilItsFileChanges) {
  const TestFolder folder;
  const auto file = folder.write("tent.obj", kTent);
  const KeptMeshes::Stamp stamp = KeptMeshes::stampOf(file);
  KeptMeshes kept;
  EXPECT_EQ(kept.find(stamp), nullptr);
  const auto mesh = std::make_shared<const MeshFile>(readMesh(file));
  kept.keep(stamp, mesh);
  EXPECT_EQ(kept.find(KeptMeshes::stampOf(file)), mesh);
  folder.write("tent.obj", std::string(kTent) + "f 2 3 4\n");
  EXPECT_EQ(kept.find(KeptMeshes::stampOf(file)), nullptr);
}

TEST(KeptMeshes, WhatWasKeptFirstGoesFirst) {
  KeptMeshes kept;
  MeshFile large;
  large.parts.resize(1);
  large.parts[0].mesh.vertices.resize(KeptMeshes::kMost / 3 / sizeof(Eigen::Vector3d));
  const auto mesh = std::make_shared<const MeshFile>(large);
  for (const char* name : {"a", "b", "c", "d"}) kept.keep(KeptMeshes::Stamp{name}, mesh);
  EXPECT_EQ(kept.find(KeptMeshes::Stamp{"a"}), nullptr);
  for (const char* name : {"b", "c", "d"})
    EXPECT_NE(kept.find(KeptMeshes::Stamp{name}), nullptr) << name;
}

TEST(KeptMeshes, AFileThatNamesOthersIsReadEachTime) {
  KeptMeshes kept;
  MeshFile with_buffer;
  with_buffer.others = {"walk.bin"};
  kept.keep(KeptMeshes::Stamp{"walk.gltf"}, std::make_shared<const MeshFile>(with_buffer));
  EXPECT_EQ(kept.find(KeptMeshes::Stamp{"walk.gltf"}), nullptr);
}

TEST(KeptMeshes, AScenesTrianglesAreThoseOfItsFilesWhetherTheyAreKeptOrNot) {
  const TestFolder folder;
  folder.write("tent.obj", kTent);
  const auto file = folder.write("scene.yaml", sceneOf("tent.obj"));
  KeptMeshes kept;
  LoadLimits limits;
  limits.meshes = &kept;
  const Scene alone = readScene(file);
  for (int i = 0; i < 2; ++i) {
    const Scene scene = readScene(file, limits);
    EXPECT_EQ(scene.triangleCount(), 2);
    EXPECT_EQ(scene.inputs, alone.inputs);
  }
  EXPECT_NE(kept.find(KeptMeshes::stampOf(file.parent_path() / "tent.obj")), nullptr);
  folder.write("tent.obj", std::string(kTent) + "f 2 3 4\n");
  EXPECT_EQ(readScene(file, limits).triangleCount(), 3);
}

}  // namespace
}  // namespace amble
