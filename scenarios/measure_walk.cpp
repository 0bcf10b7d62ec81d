#include "scenarios/measure_walk.h"

#include <algorithm>
#include <cmath>

#include "animation/quality/walk_quality.h"
#include "base/rotation.h"
#include "scenarios/foot_measures.h"

namespace amble {
namespace {

// How far clearances are looked for: what is farther is nowhere near [m].
constexpr double kClearanceLimit = 2.0;

// The goal asks for a pose: that of standing there. Where the walk goes on it asks for a stance.
void reportGoalError(const Problem& problem, const Walk& walk, const PoseArray& poses,
                     Report& report) {
  const Scenario& scenario = problem.scenario;
  const Stance& last = walk.stances.back();
  const int frame = poses.size() - 1;
  Eigen::Vector2d position = last.position.head<2>();
  double error = scenario.goal.heading ? last.heading - *scenario.goal.heading : 0.0;
  AnimationBuffer asked;
  Stance goal = last;
  if (scenario.goal.heading) goal.heading = *scenario.goal.heading;
  if (scenario.walk.to_standing &&
      problem.synthesizer.stand(goal, asked).refused == WalkRule::kNone) {
    position = poses.p_WR(frame).head<2>();
    const Eigen::Matrix3d turn =
        (poses.rotations(frame)[0] * asked.poses.rotations(0)[0].conjugate()).toRotationMatrix();
    if (scenario.goal.heading) error = std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1));
  }
  report.goal_position_error = (position - scenario.goal.at).norm();
  report.goal_heading_error = std::abs(wrapAngle(error));
}

void reportClearance(const Problem& problem, const AnimationBuffer& walk, const PoseArray& poses,
                     CollisionScratch& scratch, Report& report) {
  const Clearance near = problem.world.clearance(poses, kClearanceLimit, scratch);
  report.clearance.min = near.object < 0 ? kClearanceLimit : near.distance;
  if (near.object < 0) return;
  report.clearance.part = problem.body.parts.at(near.part).name;
  report.clearance.object = objectName(problem.scene.objects.at(near.object));
  report.clearance.time = (near.frame + near.between) * walk.frame_time;
}

// Skate is of all prints, those too that stand from the begin on; steps are what feet landed on.
void reportFeet(const Problem& problem, const AnimationBuffer& walk, const PoseArray& poses,
                Report& report) {
  const SoleTracks soles(problem.synthesizer.skeleton(), problem.body, poses, problem.ground);
  report.steps = measureSteps(walk, soles);
  double sum = 0.0;
  for (const StepMeasure& step : report.steps) {
    sum += step.slide;
    report.foot_skate_max = std::max(report.foot_skate_max, step.slide);
  }
  if (!report.steps.empty()) {
    report.foot_skate_mean = sum / static_cast<double>(report.steps.size());
  }
  std::erase_if(report.steps, [](const StepMeasure& step) { return step.strike <= 0.0; });
  report.ground_penetration = soles.penetration();
}

void reportQuality(const Problem& problem, const Walk& planned, const PoseArray& poses,
                   Report& report) {
  const AnimationBuffer& walk = planned.buffer;
  const WalkSynthesizer& synthesizer = problem.synthesizer;
  const Clip clip = {problem.scenario.name, synthesizer.skeleton(), walk.frame_time, poses, {}};
  QualityAnchors anchors =
      anchorsOf(problem.library, synthesizer.stature() / problem.library.stature,
                synthesizer.settings().speed);
  anchors.end = pelvisOf(synthesizer, planned.stances.back());
  report.quality = judgeWalk(clip, synthesizer.roles(), walk, problem.ground, anchors);
}

}  // namespace

void measureWalk(const Problem& problem, const Walk& walk, const PoseArray& poses,
                 CollisionScratch& scratch, Report& report) {
  const AnimationBuffer& frames = walk.buffer;
  report.length = walk.path.length();
  report.frames = frames.size();
  report.frame_time = frames.frame_time;
  report.duration = (frames.size() - 1) * frames.frame_time;
  reportGoalError(problem, walk, poses, report);
  reportClearance(problem, frames, poses, scratch, report);
  reportFeet(problem, frames, poses, report);
  reportQuality(problem, walk, poses, report);
}

}  // namespace amble
