// Gazebo's own readers take walk.sdf with its skin and its BVH, and place every joint where Amble
// does, to 0.1 mm.   gazebo_actor WALK.sdf JOINTS FRAME_TIME     as place_joints writes them; [s]

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ignition/common/Mesh.hh>
#include <ignition/common/MeshManager.hh>
#include <ignition/common/Skeleton.hh>
#include <ignition/common/SkeletonAnimation.hh>
#include <ignition/common/SkeletonNode.hh>
#include <map>
#include <sdf/sdf.hh>
#include <string>

namespace {

namespace fs = std::filesystem;
using Frames = std::map<std::string, ignition::math::Matrix4d>;

constexpr double kLargest = 1e-4;  // [m]

// Where joints are at a time, as gz-sim's SceneManager puts the skin's nodes.
Frames placedAt(ignition::common::Skeleton& skeleton, double time) {
  Frames own;
  for (const auto& [name, frame] : skeleton.Animation(0)->PoseAt(time, false)) {
    own[skeleton.NodeNameAnimToSkin(0, name)] =
        skeleton.AlignTranslation(0, name) * frame * skeleton.AlignRotation(0, name);
  }
  Frames placed;
  for (const auto& [handle, node] : skeleton.Nodes()) {  // parents first
    const auto* parent = node->Parent();
    const auto& frame = own.at(node->Name());
    placed[node->Name()] = parent == nullptr ? frame : placed.at(parent->Name()) * frame;
  }
  return placed;
}

const sdf::Actor* actorOf(const sdf::Root& root) {
  if (root.WorldCount() != 1 || root.WorldByIndex(0)->ActorCount() != 1) return nullptr;
  return root.WorldByIndex(0)->ActorByIndex(0);
}

bool compare(ignition::common::Skeleton& skeleton, double frame_time, const std::string& joints) {
  std::ifstream lines(joints);
  int frame = 0, shown = -1, compared = 0;
  std::string joint;
  double x = 0, y = 0, z = 0, worst = 0;
  Frames placed;
  while (lines >> frame >> joint >> x >> y >> z) {
    if (frame != shown) placed = placedAt(skeleton, frame * frame_time);
    shown = frame;
    worst = std::max(worst, placed.at(joint).Translation().Distance({x, y, z}));
    ++compared;
  }
  std::printf("Gazebo: %d joints, farthest apart %.4f mm\n", compared, 1000 * worst);
  return compared > 0 && worst <= kLargest;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  sdf::Root root;
  for (const sdf::Error& error : root.Load(argv[1])) {
    std::printf("SDF: %s\n", error.Message().c_str());
    return 1;
  }
  const sdf::Actor* const actor = actorOf(root);
  if (actor == nullptr || actor->AnimationCount() != 1 || actor->TrajectoryCount() != 0) return 1;
  const fs::path folder = fs::path(argv[1]).parent_path();
  const ignition::common::Mesh* const mesh =
      ignition::common::MeshManager::Instance()->Load((folder / actor->SkinFilename()).string());
  if (mesh == nullptr || mesh->MeshSkeleton() == nullptr) return 1;
  ignition::common::Skeleton& skeleton = *mesh->MeshSkeleton();
  const sdf::Animation& animation = *actor->AnimationByIndex(0);
  std::printf("Gazebo: %u vertices, %u joints, %u of the first vertex\n", mesh->VertexCount(),
              skeleton.NodeCount(), skeleton.VertNodeWeightCount(0));
  if (mesh->VertexCount() < 100 || skeleton.VertNodeWeightCount(0) < 1) return 1;
  // Without an animation in the skin the BVH is the first, which is the one that is played.
  if (skeleton.AnimationCount() != 0) return 1;
  if (!skeleton.AddBvhAnimation((folder / animation.Filename()).string(), animation.Scale()))
    return 1;
  return compare(skeleton, std::atof(argv[3]), argv[2]) ? 0 : 1;
}
