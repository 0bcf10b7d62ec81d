#include "batch/labels/frame_labels.h"

#include <algorithm>
#include <cmath>

#include "animation/synthesis/motion_shares.h"
#include "scenarios/foot_measures.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

// Slower nobody gets anywhere [m/s], and nobody turns [rad/s].
constexpr double kStill = 0.02, kStraight = 0.05;

void labelClearance(const RunResult& run, FrameLabels& labels) {
  const Problem& problem = *run.problem;
  const PoseArray& poses = run.outcome.walk.buffer.poses;
  const auto scratch = problem.world.makeScratch();
  const PartClearances found = problem.world.clearances(poses, kLabelClearance, *scratch);
  labels.clearance.assign(found.distance.begin(), found.distance.end());
  labels.nearest.assign(found.object.begin(), found.object.end());
  for (const SceneObject& object : problem.scene.objects)
    labels.objects.push_back(objectName(object));
  for (const BodyPart& part : problem.body.parts) labels.parts.push_back(part.name);
  const SoleTracks soles(problem.synthesizer.skeleton(), problem.body, poses, problem.ground);
  for (int frame = 0; frame < labels.frames; ++frame) {
    for (size_t part = 0; part < labels.parts.size(); ++part) {
      const int sole = problem.body.parts[part].sole;
      const size_t cell = static_cast<size_t>(frame) * labels.parts.size() + part;
      const bool stands = sole >= 0 && soles.height(static_cast<Side>(sole), frame) <= kTouchHeight;
      labels.contact.push_back(stands || found.distance[cell] <= 0.0 ? 1 : 0);
    }
  }
}

// Up or down by the step that is under way at a time: that which the next strike ends.
Activity stepAt(const std::vector<StepMeasure>& steps, double time) {
  const auto next = std::find_if(steps.begin(), steps.end(),
                                 [&](const StepMeasure& step) { return step.strike >= time; });
  if (next == steps.end() || std::abs(next->climb) < kStairStep) return Activity::kWalk;
  return next->climb > 0.0 ? Activity::kClimb : Activity::kDescend;
}

void labelActivity(const RunResult& run, FrameLabels& labels) {
  const AnimationBuffer& walk = run.outcome.walk.buffer;
  for (int frame = 0; frame < labels.frames; ++frame) {
    const FrameState& state = walk.states[static_cast<size_t>(frame)];
    Activity activity = stepAt(run.report.steps, frame * walk.frame_time);
    if (state.speed < kStill) {
      const bool steps = !state.planted[kLeft] || !state.planted[kRight];
      activity =
          steps || std::abs(state.turn_rate) > kStraight ? Activity::kTurn : Activity::kStand;
    }
    labels.activity.push_back(static_cast<int32_t>(activity));
  }
}

// A print that the walk begins with has no strike, one that it ends with no lift-off.
void labelEvents(const AnimationBuffer& walk, FrameLabels& labels) {
  for (const Footprint& print : walk.footprints) {
    if (print.first_frame > 0) labels.events.push_back({print.side, true, print.first_frame});
    if (print.last_frame + 1 < labels.frames)
      labels.events.push_back({print.side, false, print.last_frame + 1});
  }
  std::sort(labels.events.begin(), labels.events.end(), [](const auto& a, const auto& b) {
    return std::pair(a.frame, a.side) < std::pair(b.frame, b.side);
  });
}

// What is averaged into one has equal parts of its share.
void labelMotions(const RunResult& run, FrameLabels& labels) {
  const MotionShares shares(run.problem->library, run.problem->synthesizer);
  for (const auto& motions : shares.motions())
    labels.motions.insert(labels.motions.end(), motions.begin(), motions.end());
  for (const FrameState& state : run.outcome.walk.buffer.states) {
    const std::vector<double> now = shares.at(state);
    for (size_t i = 0; i < now.size(); ++i) {
      const size_t parts = shares.motions()[i].size();
      labels.shares.insert(labels.shares.end(), parts,
                           static_cast<float>(now[i] / static_cast<double>(parts)));
    }
  }
}

}  // namespace

const std::vector<std::string>& activityNames() {
  static const std::vector<std::string> names = {"stand", "walk", "turn", "climb", "descend"};
  return names;
}

FrameLabels labelFrames(const RunResult& run, bool near) {
  FrameLabels labels;
  labels.frames = run.outcome.walk.buffer.size();
  if (near) labelClearance(run, labels);
  labelActivity(run, labels);
  labelEvents(run.outcome.walk.buffer, labels);
  labelMotions(run, labels);
  return labels;
}

}  // namespace amble
