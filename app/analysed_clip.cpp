#include "app/analysed_clip.h"

#include <atomic>

#include "animation/clips/good_frames.h"
#include "animation/clips/level_capture.h"
#include "base/error.h"
#include "base/parallel.h"

namespace amble {

AnalysedClip analyseMotion(CapturedMotion motion, const std::filesystem::path& file, bool as_is) {
  AnalysedClip result;
  result.file = file;
  result.motion = std::move(motion);
  Clip& clip = result.motion.clip;
  if (clip.frames() == 0) throw InputError(file.string(), 0, "holds no frames", "a motion");
  result.file_frames = clip.frames();
  if (as_is) {
    result.floor = fitFloor(clip, result.motion.roles);
  } else {
    const GoodFrames good = goodFrames(clip);
    result.first_frame = good.first;
    clip = levelled(trimmed(clip, good.first, good.last), result.motion.roles, &result.floor);
    const std::string doubt = doubtOf(result.floor);
    if (!doubt.empty()) result.motion.warnings.push_back("the floor " + doubt);
  }
  result.analysis = analyseClip(clip, result.motion.roles);
  clip.poses.clear();
  clip.joint_positions.clear();
  return result;
}

AnalysedClip analyseFile(const std::filesystem::path& file, const ClipReading& how) {
  return analyseMotion(readMotion(file, how.read), file, how.as_is);
}

std::vector<AnalysedClip> analyseFiles(const std::vector<std::filesystem::path>& files,
                                       const ClipReading& how, int threads,
                                       const std::function<bool(int done)>& done) {
  std::vector<AnalysedClip> results(files.size());
  std::atomic<int> finished{0};
  std::atomic<bool> stopped{false};
  parallelFor(static_cast<int>(files.size()), threads, [&](int i, int) {
    if (stopped) return;
    try {
      results[i] = analyseFile(files[i], how);
    } catch (const InputError& error) {
      results[i].file = files[i];
      results[i].error = error.what();
    }
    if (!done(++finished)) stopped = true;
  });
  return results;
}

}  // namespace amble
