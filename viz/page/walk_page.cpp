#include "viz/page/walk_page.h"

#include <fmt/format.h>

#include "viz/page/edge_takes.h"
#include "viz/page/motion_sources.h"
#include "viz/page/nearest_things.h"
#include "viz/page/room_to_walk.h"

namespace amble {
namespace {

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

void addWalk(const RunResult& result, const WalkView& view, PageSubject& page) {
  const Problem& problem = *result.problem;
  PageTake walk = takeOf(*view.animation, soleLength(view));
  walk.name = view.title;
  walk.clearance = nearestThings(problem.world, *view.skeleton, view.animation->poses);
  walk.sources = motionSources(*view.animation, problem.library, problem.synthesizer);
  page.takes.push_back(std::move(walk));
  describeWalk(result.report, page);
}

// How far one gets, and what is in the way.
void tellWhy(const RunResult& result, PageSubject& page) {
  page.why = result.report.why;
  page.description =
      fmt::format("The room of {}, in which no walk was found: {}", page.title, result.report.why);
  const PlanOutcome& outcome = result.outcome;
  if (outcome.reached) page.reached = reachedGround(*outcome.reached);
  if (outcome.why) page.obstruction = outcome.why->at;
}

void addRoomToWalk(const Problem& problem, PageSubject& page) {
  const WalkSteering steering(problem.synthesizer, problem.world, problem.ground);
  const auto map = steering.map(problem.bounds(), [] { return false; });
  if (map) page.room_to_walk = roomToWalk(*map);
}

}  // namespace

WalkPage walkPage(const RunResult& result, const WalkView& view) {
  WalkPage page;
  PageSubject& subject = page.subject;
  const Problem& problem = *result.problem;
  subject.title = view.title;
  subject.scene = view.scene;
  subject.floor = view.floor;
  subject.walk = &view;
  subject.actors = {{"walker", view.skeleton, view.body}};
  if (view.hasBody()) {
    addWalk(result, view, subject);
  } else {
    tellWhy(result, subject);
  }
  addEdgeTakes(problem, result.outcome.roadmap, soleLength(view), page);
  addRoomToWalk(problem, subject);
  return page;
}

}  // namespace amble
