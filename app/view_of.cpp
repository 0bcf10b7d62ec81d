#include "app/view_of.h"

#include "viz/page/edge_takes.h"

namespace amble {
namespace {

PlaceView viewOf(const Place& place, const Eigen::Vector3d& on_floor) {
  return {place.at, place.heading, on_floor.z()};
}

RoadmapView viewOf(const Problem& problem, const RoadmapPicture& roadmap) {
  RoadmapView view;
  for (const RoadmapPicture::Node& node : roadmap.nodes) {
    view.nodes.push_back({node.stance.position.head<2>(), node.stance.heading,
                          node.kind == NodeKind::kConnector, node.stance.position.z()});
  }
  for (const RoadmapPicture::Edge& edge : roadmap.edges) {
    view.edges.push_back({edge.from, edge.to, edge.line});
  }
  for (const RoadmapPicture::Refused& refused : roadmap.refused) {
    view.refused.push_back({refused.from.stance.position.head<2>(),
                            refused.to.stance.position.head<2>(), refused.at.head<2>(),
                            whatRefused(problem, refused.rule, refused.part, refused.object)});
  }
  return view;
}

}  // namespace

WalkView viewOf(const RunResult& result) {
  const Problem& problem = *result.problem;
  const Walk& walk = result.outcome.walk;
  WalkView view;
  view.title = problem.scenario.name;
  view.scene = &problem.scene;
  view.floor = problem.floor;
  view.ground = &problem.ground;
  view.skeleton = &problem.synthesizer.skeleton();
  view.body = &problem.body;
  if (walk.buffer.size() > 0) {
    view.animation = &walk.buffer;
    view.path = &walk.path;
  }
  if (result.report.status != PlanStatus::kSolved) view.why = result.report.why;
  if (result.outcome.why) view.obstruction = &*result.outcome.why;
  if (result.outcome.reached) view.reached = &*result.outcome.reached;
  view.roadmap = viewOf(problem, result.outcome.roadmap);
  const PlanQuery asked = problem.query();
  view.start = viewOf(problem.scenario.start, asked.start.position);
  view.goal = viewOf(problem.scenario.goal, asked.goal.position);
  for (size_t i = 0; i < asked.via.size(); ++i)
    view.via.push_back(viewOf(problem.scenario.via[i], asked.via[i]));
  return view;
}

}  // namespace amble
