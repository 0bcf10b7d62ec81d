// What we write for other programs, read by assimp, which many of them read with.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <assimp/Importer.hpp>
#include <map>
#include <sstream>

#include "base/rotation.h"
#include "tests/environments/test_meshes.h"
#include "tests/viz/test_walk.h"
#include "viz/exchange/gazebo_actor.h"
#include "viz/exchange/glb.h"
#include "viz/figure/posed_figure.h"

namespace amble {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

Eigen::Matrix4d matrixOf(const aiMatrix4x4& m) {
  Eigen::Matrix4d matrix;
  for (unsigned row = 0; row < 4; ++row)
    for (unsigned column = 0; column < 4; ++column) matrix(row, column) = m[row][column];
  return matrix;
}

// A file in memory, with where its nodes are at a frame of its animation, or without one.
class ReadFile {
 public:
  ReadFile(const std::string& text, const char* ending) {
    scene_ = importer_.ReadFileFromMemory(text.data(), text.size(), aiProcess_Triangulate, ending);
    EXPECT_NE(scene_, nullptr) << importer_.GetErrorString();
  }

  const aiScene& scene() const { return *scene_; }

  std::map<std::string, Eigen::Matrix4d> nodesAt(unsigned frame) const {
    std::map<std::string, Eigen::Matrix4d> nodes;
    place(*scene_->mRootNode, Eigen::Matrix4d::Identity(), frame, nodes);
    return nodes;
  }

  // Corners of all meshes with bones, as their bones carry them.
  std::vector<Vector3d> skinnedAt(unsigned frame) const {
    const auto nodes = nodesAt(frame);
    std::vector<Vector3d> placed;
    for (unsigned m = 0; m < scene_->mNumMeshes; ++m) {
      const aiMesh& mesh = *scene_->mMeshes[m];
      if (mesh.mNumBones == 0) continue;
      std::vector<Vector3d> sums(mesh.mNumVertices, Vector3d::Zero());
      for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone& bone = *mesh.mBones[b];
        const Eigen::Matrix4d carry = nodes.at(bone.mName.C_Str()) * matrixOf(bone.mOffsetMatrix);
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
          const aiVector3D& p = mesh.mVertices[bone.mWeights[w].mVertexId];
          const Eigen::Vector4d there = carry * Eigen::Vector4d(p.x, p.y, p.z, 1.0);
          sums[bone.mWeights[w].mVertexId] += bone.mWeights[w].mWeight * there.head<3>();
        }
      }
      placed.insert(placed.end(), sums.begin(), sums.end());
    }
    return placed;
  }

  // Around all that has no bones and is below a node of this name.
  Eigen::AlignedBox3d boundsBelow(const char* name) const {
    Eigen::AlignedBox3d box;
    const aiNode* const node = scene_->mRootNode->FindNode(name);
    if (node != nullptr) extend(*node, box);
    return box;
  }

 private:
  void place(const aiNode& node, const Eigen::Matrix4d& parent, unsigned frame,
             std::map<std::string, Eigen::Matrix4d>& nodes) const {
    Eigen::Matrix4d local = matrixOf(node.mTransformation);
    if (scene_->mNumAnimations > 0) animate(node, frame, local);
    nodes[node.mName.C_Str()] = parent * local;
    for (unsigned i = 0; i < node.mNumChildren; ++i)
      place(*node.mChildren[i], parent * local, frame, nodes);
  }

  void animate(const aiNode& node, unsigned frame, Eigen::Matrix4d& local) const {
    const aiAnimation& animation = *scene_->mAnimations[0];
    for (unsigned i = 0; i < animation.mNumChannels; ++i) {
      const aiNodeAnim& channel = *animation.mChannels[i];
      if (channel.mNodeName != node.mName) continue;
      const auto key = [&](unsigned count) { return std::min(frame, count - 1); };
      const aiVector3D& p = channel.mPositionKeys[key(channel.mNumPositionKeys)].mValue;
      const aiQuaternion& q = channel.mRotationKeys[key(channel.mNumRotationKeys)].mValue;
      local.setIdentity();
      local.topLeftCorner<3, 3>() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
      local.topRightCorner<3, 1>() = Vector3d(p.x, p.y, p.z);
    }
  }

  void extend(const aiNode& node, Eigen::AlignedBox3d& box) const {
    const Eigen::Matrix4d at = nodesAt(0).at(node.mName.C_Str());
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene_->mMeshes[node.mMeshes[i]];
      for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D& p = mesh.mVertices[v];
        box.extend((at * Eigen::Vector4d(p.x, p.y, p.z, 1.0)).head<3>());
      }
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) extend(*node.mChildren[i], box);
  }

  Assimp::Importer importer_;
  const aiScene* scene_ = nullptr;
};

Vector3d fileToWorld(const Vector3d& p) { return {p.x(), -p.z(), p.y()}; }  // of glTF

double farthestFrom(const std::vector<Vector3d>& found, const std::vector<Vector3f>& expected) {
  double most = 0.0;
  for (size_t i = 0; i < expected.size(); i += 5) {
    double least = 1e9;
    for (const Vector3d& p : found)
      least = std::min(least, (p - expected[i].cast<double>()).norm());
    most = std::max(most, least);
  }
  return most;
}

// The test walk, but that its legs swing.
std::unique_ptr<TestWalk> swingingWalk() {
  auto walk = makeTestWalk();
  PoseArray& poses = walk->animation.poses;
  for (int i = 0; i < poses.size(); ++i) {
    const double swing = 0.4 * std::sin(0.2 * i);
    poses.rotations(i)[0] = aboutZ(0.02 * i) * yUpToWorld();
    poses.rotations(i)[1] = expRotation(swing * Vector3d::UnitX());
    poses.rotations(i)[2] = expRotation(-swing * Vector3d::UnitX());
  }
  return walk;
}

std::string glbOf(const TestWalk& walk, const GlbWalkOptions& options = {}) {
  std::ostringstream out;
  writeGlb(out, walk.view, figureOfTestWalk(), options);
  return out.str();
}

TEST(GlbByAssimp, TheSkinIsWhereTheFigureIsInEveryPose) {
  const auto walk = swingingWalk();
  const ReadFile file(glbOf(*walk), "glb");
  std::vector<JointFrame> frames(walk->skeleton.size());
  for (const int frame : {0, 17, 60, 120}) {
    forwardKinematics(walk->skeleton, walk->animation.poses[frame], frames);
    std::vector<Vector3d> found;
    for (const Vector3d& p : file.skinnedAt(frame)) found.push_back(fileToWorld(p));
    EXPECT_LT(farthestFrom(found, poseFigure(figureOfTestWalk(), frames).vertices), 1e-4) << frame;
  }
}

TEST(GlbByAssimp, TheAnimationLastsAsLongAsTheWalkAndHasItsFrames) {
  const auto walk = swingingWalk();
  const ReadFile file(glbOf(*walk), "glb");
  ASSERT_EQ(file.scene().mNumAnimations, 1u);
  const aiAnimation& animation = *file.scene().mAnimations[0];
  EXPECT_NEAR(animation.mDuration / animation.mTicksPerSecond, 120 / 30.0, 1e-3);
  for (unsigned i = 0; i < animation.mNumChannels; ++i)
    EXPECT_EQ(animation.mChannels[i]->mNumRotationKeys, 121u);
}

TEST(GlbByAssimp, TheSceneIsWhereItIs) {
  const auto walk = swingingWalk();
  const ReadFile file(glbOf(*walk), "glb");
  Eigen::AlignedBox3d found;
  const Eigen::AlignedBox3d box = file.boundsBelow("scene");
  found.extend(fileToWorld(box.min()));
  found.extend(fileToWorld(box.max()));
  const Eigen::AlignedBox3d expected = walk->scene.bounds();
  EXPECT_LT((found.min() - expected.min()).norm(), 1e-4) << found.min().transpose();
  EXPECT_LT((found.max() - expected.max()).norm(), 1e-4) << found.max().transpose();
  EXPECT_TRUE(ReadFile(glbOf(*walk, {.scene = false}), "glb").boundsBelow("scene").isEmpty());
}

TEST(GlbByAssimp, EveryBoneIsANodeAndWeightsOfACornerSumToOne) {
  const auto walk = swingingWalk();
  const ReadFile file(glbOf(*walk), "glb");
  for (unsigned m = 0; m < file.scene().mNumMeshes; ++m) {
    const aiMesh& mesh = *file.scene().mMeshes[m];
    if (mesh.mNumBones == 0) continue;
    std::vector<double> sums(mesh.mNumVertices, 0.0);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      EXPECT_NE(file.scene().mRootNode->FindNode(mesh.mBones[b]->mName), nullptr);
      for (unsigned w = 0; w < mesh.mBones[b]->mNumWeights; ++w)
        sums[mesh.mBones[b]->mWeights[w].mVertexId] += mesh.mBones[b]->mWeights[w].mWeight;
    }
    for (const double sum : sums) EXPECT_NEAR(sum, 1.0, 1e-5);
  }
}

std::vector<std::string> namesOf(const Skeleton& skeleton) {
  std::vector<std::string> names;
  for (const Joint& joint : skeleton.joints()) names.push_back(joint.name);
  return names;
}

TEST(ColladaByAssimp, TheSkinOfTheActorIsTheRestedFigureOnTheTreeOfTheSkeleton) {
  const auto walk = makeTestWalk();
  std::ostringstream out;
  writeSkinCollada(out, walk->skeleton, figureOfTestWalk(), namesOf(walk->skeleton));
  const ReadFile file(out.str(), "dae");
  for (int j = 1; j < walk->skeleton.size(); ++j) {
    const aiNode* const node =
        file.scene().mRootNode->FindNode(walk->skeleton.joint(j).name.c_str());
    ASSERT_NE(node, nullptr) << j;
    EXPECT_EQ(node->mParent->mName.C_Str(),
              walk->skeleton.joint(walk->skeleton.joint(j).parent).name);
  }
  // Assimp turns a file that is z up to y up: distances between corners are the same all the same.
  const std::vector<Vector3d> found = file.skinnedAt(0);
  const Figure rested = restedFigure(walk->skeleton, figureOfTestWalk());
  Eigen::AlignedBox3d box;
  Eigen::AlignedBox3f expected;
  for (const Vector3d& p : found) box.extend(p);
  for (const Vector3f& p : rested.vertices) expected.extend(p);
  Vector3d a = box.sizes(), b = expected.sizes().cast<double>();
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  EXPECT_LT((a - b).norm(), 1e-4) << a.transpose() << " and " << b.transpose();
}

TEST(ColladaByAssimp, TheRoomIsAsLargeAsItIsAndHasItsTriangles) {
  const Scene room = testRoom();
  std::ostringstream out;
  writeRoomCollada(out, room, 0.0);
  const ReadFile file(out.str(), "dae");
  unsigned triangles = 0;
  for (unsigned m = 0; m < file.scene().mNumMeshes; ++m)
    triangles += file.scene().mMeshes[m]->mNumFaces;
  EXPECT_EQ(triangles, 12 * room.objects.size());
  Vector3d a = file.boundsBelow(file.scene().mRootNode->mName.C_Str()).sizes(),
           b = room.bounds().sizes();
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  EXPECT_LT((a - b).norm(), 1e-4) << a.transpose() << " and " << b.transpose();
}

}  // namespace
}  // namespace amble
