// Whether another program's copy of a motion has every joint where the motion has it, to a
// millimetre.   compare_motions WALK.bvh COPY...
#include <algorithm>
#include <cstdio>
#include <map>

#include "animation/captures/motion_reader.h"
#include "base/error.h"

namespace amble {
namespace {

constexpr double kLargest = 1e-3;  // [m]

std::vector<JointFrame> jointsAt(const Clip& clip, int frame) {
  std::vector<JointFrame> joints(clip.skeleton.size());
  forwardKinematics(clip, frame, joints);
  return joints;
}

bool compare(const Clip& walk, const std::string& file) {
  const Clip copy = readMotion(file).clip;
  double worst = 0.0;
  int compared = 0;
  const int frames = std::min(walk.frames(), copy.frames());
  for (int i = 0; i < frames; ++i) {
    const std::vector<JointFrame> a = jointsAt(walk, i), b = jointsAt(copy, i);
    for (int j = 0; j < walk.skeleton.size(); ++j) {
      const int other = copy.skeleton.find(walk.skeleton.joint(j).name);
      if (other < 0) continue;
      ++compared;
      worst = std::max(worst, (a[j].p_WJ - b[other].p_WJ).norm());
    }
  }
  std::printf("%s: %d of %d joints, %d of %d frames of %.6f s, farthest apart %.4f mm\n",
              file.c_str(), frames > 0 ? compared / frames : 0, walk.skeleton.size(), copy.frames(),
              walk.frames(), copy.frame_time, 1000.0 * worst);
  return frames == walk.frames() && compared == frames * walk.skeleton.size() && worst <= kLargest;
}

}  // namespace
}  // namespace amble

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  try {
    const amble::Clip walk = amble::readMotion(argv[1]).clip;
    bool good = true;
    for (int i = 2; i < argc; ++i) good = amble::compare(walk, argv[i]) && good;
    return good ? 0 : 1;
  } catch (const amble::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
