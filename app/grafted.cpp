#include "app/grafted.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "animation/body/foot_shape.h"
#include "animation/grafting/arm_leg_phase.h"
#include "base/rotation.h"
#include "scenarios/captured_body.h"

namespace amble {
namespace {

// As deep as in the sources is allowed; upper's depths count on base's size.
Eigen::VectorXd allowedDepths(const GraftSource& base, const GraftSource& upper,
                              const CorrelationWindows& windows) {
  const Eigen::VectorXd below =
      deepest(armDepths(base.body, base.clip.clip, windows.base.first, windows.base.last));
  const Eigen::VectorXd above =
      deepest(armDepths(upper.body, upper.clip.clip, windows.upper.first, windows.upper.last));
  const double scale = statureOf(base.clip.clip.skeleton, base.clip.roles) /
                       statureOf(upper.clip.clip.skeleton, upper.clip.roles);
  return below.cwiseMax(scale * above);
}

std::vector<ArmInBody> armsInBody(const Body& body, const Clip& clip,
                                  const Eigen::VectorXd& allowed, int first, int last) {
  const Eigen::MatrixXd depths = armDepths(body, clip, first, last);
  std::vector<ArmInBody> all;
  for (Eigen::Index k = 0; k < depths.cols(); ++k) {
    const auto& [part, other] = armPairs()[static_cast<size_t>(k)];
    ArmInBody found{part, other, 0, 0, 0, 0.0, allowed[k]};
    for (int i = first; i <= last; ++i) {
      const double depth = depths(i - first, k);
      if (depth <= allowed[k] + kDepthTolerance) continue;
      if (found.frames++ == 0) found.first = i;
      found.last = i;
      found.depth = std::max(found.depth, depth);
    }
    if (found.frames > 0) all.push_back(std::move(found));
  }
  return all;
}

void measurePhases(const GraftSource& base, const GraftSource& upper, Grafted& grafted) {
  const Graft& graft = grafted.graft;
  grafted.arm_leg = armLegPhase(graft.clip, base.clip.roles, graft.first, graft.last);
  grafted.base_arm_leg = armLegPhase(base.clip.clip, base.clip.roles, graft.first, graft.last);
  const auto frame = [](double at) { return static_cast<int>(std::lround(at)); };
  grafted.upper_arm_leg =
      armLegPhase(upper.clip.clip, upper.clip.roles, frame(graft.upper_frame.front()),
                  frame(graft.upper_frame.back()));
}

}  // namespace

GraftSource graftSource(CapturedMotion motion, const std::filesystem::path& file) {
  GraftSource source;
  source.file = file;
  source.motion = std::move(motion);
  source.clip = locomotiveClip(std::move(source.motion.clip), source.motion.roles, file.string());
  const Clip& clip = source.clip.clip;
  source.body =
      capturedBody(clip, source.clip.roles, 0.0, statureOf(clip.skeleton, source.clip.roles));
  return source;
}

GraftSource readGraftSource(const std::filesystem::path& file, const MotionReadOptions& options) {
  return graftSource(readMotion(file, options), file);
}

Grafted graftOn(const GraftSource& base, const GraftSource& upper, const GraftWishes& wishes,
                bool clear) {
  Grafted grafted;
  grafted.plan = planGraft(base.clip, upper.clip, wishes);
  grafted.refusal = grafted.plan.refusal;
  if (!grafted.refusal.empty()) return grafted;
  grafted.graft = makeGraft(base.clip, upper.clip, grafted.plan, wishes);
  Graft& graft = grafted.graft;
  const Eigen::VectorXd allowed = allowedDepths(base, upper, grafted.plan.windows);
  grafted.found = armsInBody(base.body, graft.clip, allowed, graft.first, graft.last);
  grafted.left = grafted.found;
  if (clear && !grafted.found.empty()) {
    grafted.clearing =
        clearArms(base.body, base.clip.roles, allowed, graft.first, graft.last, graft.clip);
    grafted.left = armsInBody(base.body, graft.clip, allowed, graft.first, graft.last);
    graft.acceleration = accelerationOf(graft, base.clip);
    if (!grafted.left.empty()) {
      const ArmInBody& worst = *std::max_element(grafted.left.begin(), grafted.left.end(),
                                                 [](const ArmInBody& a, const ArmInBody& b) {
                                                   return a.depth - a.sources < b.depth - b.sources;
                                                 });
      grafted.refusal = fmt::format(
          "the {} is {:.0f} mm in the {} at frames {} to {}, {:.0f} in the sources, and no turn of "
          "up "
          "to {:.0f} degrees brings it out",
          worst.part, 1000.0 * worst.depth, worst.other, worst.first, worst.last,
          1000.0 * worst.sources, kMostTurned / kDegree);
    }
  }
  measurePhases(base, upper, grafted);
  return grafted;
}

}  // namespace amble
