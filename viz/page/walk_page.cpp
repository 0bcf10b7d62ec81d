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

template <typename Things, typename Name>
int indexOf(const Things& things, const std::string& name, Name name_of) {
  for (size_t i = 0; i < things.size(); ++i)
    if (name_of(things[i]) == name) return static_cast<int>(i);
  return -1;
}

// Somebody who stands where he may not, for want of an attempt to walk.
void addBlockedStance(const RunResult& result, double sole, WalkPage& page) {
  const Problem& problem = *result.problem;
  const std::optional<Obstruction>& why = result.outcome.why;
  if (!why || !page.subject.takes.empty()) return;
  Stance stance;
  stance.position = why->body;
  stance.heading = why->heading;
  AnimationBuffer standing;
  if (problem.synthesizer.stand(stance, standing).refused != WalkRule::kNone) return;
  PageTake take = takeOf(standing, sole);
  take.name = fmt::format(
      "Blocked: {}", why->object.empty() ? walkRuleName(why->rule) : std::string_view(why->object));
  take.poses = &page.poses.emplace_back(standing.poses);
  take.stop = {0.0,
               indexOf(problem.body.parts, why->part, [](const BodyPart& p) { return p.name; }),
               indexOf(problem.scene.objects, why->object, objectName), why->at};
  page.subject.takes.push_back(std::move(take));
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
  subject.actors = {{.name = "walker", .skeleton = view.skeleton, .body = view.body}};
  if (view.hasBody()) {
    addWalk(result, view, subject);
  } else {
    tellWhy(result, subject);
  }
  addEdgeTakes(problem, result.outcome.roadmap, soleLength(view), page);
  if (!view.hasBody()) addBlockedStance(result, soleLength(view), page);
  addRoomToWalk(problem, subject);
  return page;
}

}  // namespace amble
