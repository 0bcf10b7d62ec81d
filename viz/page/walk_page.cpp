#include "viz/page/walk_page.h"

#include <fmt/format.h>

#include "viz/page/motion_sources.h"
#include "viz/page/nearest_things.h"

namespace amble {
namespace {

constexpr double kWaySpacing = 0.04;  // between points of the root path [m]

// The root's way on the ground, a point every few centimetres.
std::vector<Eigen::Vector3d> wayOf(const AnimationBuffer& walk) {
  std::vector<Eigen::Vector3d> way;
  for (const FrameState& state : walk.states) {
    if (way.empty() || (state.position - way.back()).norm() >= kWaySpacing)
      way.push_back(state.position);
  }
  return way;
}

PageTake takeOf(const AnimationBuffer& walk, double sole) {
  PageTake take;
  take.frame_time = walk.frame_time;
  take.poses = &walk.poses;
  take.way = wayOf(walk);
  take.sole = sole;
  for (const FrameState& state : walk.states)
    take.headings.push_back(static_cast<float>(state.heading));
  take.footprints = walk.footprints;
  for (const Footprint& print : walk.footprints)
    take.planted[print.side].push_back({print.first_frame, print.last_frame});
  return take;
}

void describeWalk(const Report& report, PageSubject& page) {
  page.facts = {{"Length", fmt::format("{:.2f} m", report.length)},
                {"Time", fmt::format("{:.2f} s", report.duration)},
                {"Steps", std::to_string(report.steps.size())}};
  if (!report.clearance.object.empty()) {
    page.facts.emplace_back("Nearest",
                            fmt::format("{:.1f} cm, {} and {}", 100.0 * report.clearance.min,
                                        report.clearance.part, report.clearance.object));
  }
  page.description =
      fmt::format("A person walks {:.1f} m through {} in {:.1f} s, with {} steps.", report.length,
                  report.scenario, report.duration, report.steps.size());
}

}  // namespace

PageSubject walkPage(const RunResult& result, const WalkView& view) {
  PageSubject page;
  page.title = view.title;
  page.scene = view.scene;
  page.floor = view.floor;
  page.walk = &view;
  if (!view.hasBody()) {
    page.why = result.report.why;
    page.description = fmt::format("The room of {}, in which no walk was found.", view.title);
    return page;
  }
  describeWalk(result.report, page);
  page.actors = {{"walker", view.skeleton, view.body}};
  page.takes = {takeOf(*view.animation, soleLength(view))};
  PageTake& walk = page.takes[0];
  walk.name = view.title;
  const Problem& problem = *result.problem;
  walk.clearance = nearestThings(problem.world, *view.skeleton, view.animation->poses);
  walk.sources = motionSources(*view.animation, problem.library, problem.synthesizer);
  return page;
}

}  // namespace amble
