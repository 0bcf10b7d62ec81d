/// Rotations, skeletons and clips drawn from a seed, for tests that state theorems.
#pragma once

#include <random>
#include <string>

#include "animation/body/clip.h"

namespace amble {

using Generator = std::mt19937_64;

inline double uniform(Generator& generator, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(generator);
}

inline Eigen::Vector3d randomVector(Generator& generator, double size) {
  const double x = uniform(generator, -size, size), y = uniform(generator, -size, size);
  return {x, y, uniform(generator, -size, size)};
}

/// Uniform over all rotations.
inline Eigen::Quaterniond randomRotation(Generator& generator) {
  std::normal_distribution<double> normal;
  Eigen::Vector4d v;
  for (int i = 0; i < 4; ++i) v[i] = normal(generator);
  v.normalize();
  return {v[0], v[1], v[2], v[3]};
}

/// A tree with chains and forks; a leaf may have a tip.
inline Skeleton randomSkeleton(Generator& generator, int joints) {
  std::vector<Joint> tree(joints);
  for (int j = 0; j < joints; ++j) {
    tree[j].name = "joint_" + std::to_string(j);
    if (j == 0) continue;
    tree[j].parent = std::uniform_int_distribution<int>(std::max(0, j - 4), j - 1)(generator);
    tree[j].offset = randomVector(generator, 0.5);
    if (j % 3 == 0) tree[j].end_sites.push_back(randomVector(generator, 0.2));
  }
  return Skeleton(std::move(tree));
}

/// Poses that have nothing to do with each other.
inline Clip randomClip(Generator& generator, int joints, int frames) {
  Clip clip;
  clip.name = "random";
  clip.skeleton = randomSkeleton(generator, joints);
  clip.frame_time = 0.0123457;
  clip.poses = PoseArray(joints);
  clip.poses.resize(frames);
  for (int frame = 0; frame < frames; ++frame) {
    clip.poses.p_WR(frame) = randomVector(generator, 20.0);
    for (Eigen::Quaterniond& q : clip.poses.rotations(frame)) q = randomRotation(generator);
  }
  return clip;
}

inline std::vector<JointFrame> jointFrames(const Clip& clip, int frame) {
  std::vector<JointFrame> frames(clip.skeleton.size());
  forwardKinematics(clip, frame, frames);
  return frames;
}

}  // namespace amble
