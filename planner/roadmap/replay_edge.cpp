#include "planner/roadmap/replay_edge.h"

namespace amble {
namespace {

// The first contact of what could be animated; else the rule that let no more be made.
EdgeReplay::Stop stopOf(const AnimationBuffer& buffer, const SteeringFailure& answer, WalkRule rule,
                        const WalkSteering& steering, SteeringScratch& scratch) {
  EdgeReplay::Stop stop;
  const auto contact =
      steering.world().check(buffer.poses, buffer.soles, false, *steering.world().makeScratch());
  if (contact) {
    stop.rule = WalkRule::kContact;
    stop.frame = contact->frame;
    stop.between = contact->between;
    stop.part = contact->part;
    stop.object = contact->object;
    stop.at = steering.touched(*contact, buffer, scratch).at;
  } else {
    stop.rule = rule == WalkRule::kNone ? answer.rule : rule;
    stop.frame = buffer.size() - 1;
    stop.at = answer.at;
  }
  return stop;
}

}  // namespace

Waypoint waypointOf(const RoadmapPicture::Node& node) {
  return {node.stance, node.any_heading, node.any_leading};
}

EdgeReplay replayEdge(const WalkSteering& steering, const Waypoint& from, const Waypoint& to) {
  const SteeringScratchPtr scratch = steering.makeScratch();
  EdgeReplay replay;
  const WalkSteering::Attempt attempt = steering.attempt(from, to, *scratch);
  if (attempt.result.edge) {
    steering.animate(*attempt.result.edge, replay.buffer);
    return replay;
  }
  WalkEdge proposal;  // none: standing at its begin
  proposal.from = proposal.to = from.stance;
  if (attempt.refused) proposal = *attempt.refused;
  const WalkRule rule = steering.animateRefused(proposal, replay.buffer);
  replay.stop = stopOf(replay.buffer, attempt.result.failure, rule, steering, *scratch);
  return replay;
}

}  // namespace amble
