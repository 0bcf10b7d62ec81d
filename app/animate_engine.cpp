#include "app/animate_engine.h"

#include <fmt/format.h>

#include <cmath>

#include "animation/body/joint_names.h"
#include "animation/captures/bvh.h"
#include "animation/library/speed_engine_reader.h"
#include "app/exit_status.h"
#include "app/locked_engine_walk.h"
#include "app/say.h"
#include "base/keep_inputs.h"
#include "base/output_file.h"
#include "viz/exchange/glb.h"
#include "viz/figure/captured_figure.h"

namespace amble {
namespace {

constexpr double kSameSpeed = 0.01;  // as written and as measured [m/s]

// Speeds that nobody was captured at.
void warn(const SpeedEngine& engine, const Ramp& asked, double scale) {
  for (const double speed : {asked.from, asked.to}) {
    const double own = speed / scale;
    if (std::abs(engine.clamped(own) - own) > kSameSpeed) {
      say(stderr, "warning: {:g} m/s is beyond what was captured; {:.2f} is taken\n", speed,
          engine.clamped(own) * scale);
    } else if (!engine.isCaptured(own - kSameSpeed) && !engine.isCaptured(own + kSameSpeed)) {
      say(stderr,
          "warning: {:g} m/s lies between the fastest walk and the slowest run that were captured; "
          "it is a mixture of both\n",
          speed);
    }
    if (asked.from == asked.to) break;
  }
}

void write(const MotionOutput& output, const EngineData& engine, Clip clip) {
  const std::filesystem::path file = output.file;
  clip.skeleton = renamed(clip.skeleton, jointNames(clip.skeleton, engine.roles, output.names));
  if (!output.isGlb()) {
    writeBvh(file, clip, {.metres_per_unit = output.bvhUnit()});
    return;
  }
  const Figure figure = capturedFigure(clip, engine.roles);
  writeFile(file, [&](std::ostream& out) { writeGlb(out, clip, figure); });
}

}  // namespace

int animateEngine(const EngineAnimation& options) {
  const SpeedEngine engine(readSpeedEngine(options.engine));
  const EngineData& data = engine.data();
  keepInputs(options.out.file, {data.file, data.file.parent_path() / data.skeleton_file});
  const double scale = options.height > 0.0 ? options.height / data.stature : 1.0;
  warn(engine, options.speed, scale);
  FootLock lock;
  const EngineWalk walk =
      lockedEngineWalk(engine, {options.speed, options.duration, 1.0 / options.fps, scale}, &lock);
  write(options.out, data, walk.clip);
  say(options.out.file == "-" ? stderr : stdout,
      "{}: {:.2f} s, {} frames, {:.1f} cycles, {:.2f} m; feet that stand are held, by {:.0f} mm at "
      "most\n",
      options.out.file, walk.clip.duration(), walk.clip.frames(),
      walk.phases.back() - walk.phases.front(), walk.length, 1000.0 * lock.farthest);
  return kExitDone;
}

}  // namespace amble
