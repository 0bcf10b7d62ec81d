// Where Amble puts every joint of a BVH: a line `frame joint x y z` each [m, World], for other
// programs to compare with.
//
//   place_joints WALK.bvh STEP     every STEP-th frame

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "animation/captures/bvh.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const amble::Clip clip = amble::readBvh(std::filesystem::path(argv[1]));
  std::vector<amble::JointFrame> joints(clip.skeleton.size());
  for (int frame = 0; frame < clip.frames(); frame += std::atoi(argv[2])) {
    amble::forwardKinematics(clip, frame, joints);
    for (int j = 0; j < clip.skeleton.size(); ++j) {
      const Eigen::Vector3d& p = joints[j].p_WJ;
      std::printf("%d %s %.9f %.9f %.9f\n", frame, clip.skeleton.joint(j).name.c_str(), p.x(),
                  p.y(), p.z());
    }
  }
  return 0;
}
