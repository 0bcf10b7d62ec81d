#include "batch/run/make_walk.h"

#include <algorithm>

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/text.h"

namespace amble {
namespace {

bool wants(const BatchJob& job, const std::string& format) {
  return std::find(job.formats.begin(), job.formats.end(), format) != job.formats.end();
}

WalkRow rowOf(const WalkOrder& order) {
  const Scenario scenario = scenarioOf(order.job, order.item);
  WalkRow row;
  row.key = order.key;
  row.scene = order.job.scenes[static_cast<size_t>(order.item.scene)].name;
  row.library = relativeText(order.job, scenario.character.library);
  row.style = scenario.walk.style;
  row.actions = scenario.walk.actions;
  row.height = order.item.height;
  row.speed = order.item.speed;
  row.way = wayName(order.job, order.item);
  row.seed = order.item.seed;
  return row;
}

// What is asked: false where a way was to be drawn and there is none.
bool chooseEnds(const WalkOrder& order, Scenario& scenario) {
  const int drawn = drawnWay(order.job, order.item);
  if (drawn < 0) return true;
  const BatchDraw& draw = order.job.draw;
  SampleStream stream(order.job.seed, static_cast<std::uint64_t>(drawn));
  const auto ends = order.drawer->drawer->draw(stream, draw.least, draw.most);
  if (!ends) return false;
  scenario.start = ends->start;
  scenario.goal = ends->goal;
  scenario.has_ends = true;
  return true;
}

RunResult plan(const WalkOrder& order, const Scenario& scenario) {
  InputDigests inputs = order.scene.inputs;
  inputs.insert(order.library.inputs.begin(), order.library.inputs.end());
  RunOptions how;
  how.frame_time = 1.0 / order.job.fps;
  how.stop = order.stop;
  auto problem = std::make_unique<const Problem>(*order.walker->problem, scenario);
  const Planner* planner = order.walker->planner ? &*order.walker->planner : nullptr;
  return runProblem(std::move(problem), inputs, planner, how);
}

}  // namespace

namespace {

// Why there is nothing to plan, or "".
std::string whatIsWrong(const WalkOrder& order) {
  if (!order.scene.wrong.empty()) return order.scene.wrong;
  if (!order.library.wrong.empty()) return order.library.wrong;
  if (order.drawer && !order.drawer->wrong.empty()) return order.drawer->wrong;
  return order.walker->wrong;
}

void label(const BatchJob& job, MadeWalk& made) {
  const Stopwatch watch;
  made.labels = labelWalk(*made.run, wants(job, "labels"));
  made.row.caption = made.labels->caption;
  const std::set<std::string> credits = creditsOf(made.labels->motions);
  made.row.credits.assign(credits.begin(), credits.end());
  made.labelling = watch.seconds();
}

// With the distances, which may be why.
std::string noWayText(const BatchDraw& draw) {
  std::string text = "no start and goal were found that ground leads between, ";
  text += draw.most < BatchDraw().most
              ? shortNumber(draw.least) + " to " + shortNumber(draw.most) + " m apart"
              : shortNumber(draw.least) + " m apart or more";
  return text + " (`least` and `most` of `ways`)";
}

}  // namespace

MadeWalk makeWalk(const WalkOrder& order) {
  MadeWalk made;
  made.row = rowOf(order);
  made.row.status = "error";
  made.row.reason = whatIsWrong(order);
  if (!made.row.reason.empty()) return made;
  Scenario scenario = scenarioOf(order.job, order.item);
  scenario.name = "walk-" + order.key;
  if (!chooseEnds(order, scenario)) {
    made.row.status = "no_way";
    made.row.reason = noWayText(order.job.draw);
    return made;
  }
  try {
    made.run = plan(order, scenario);
  } catch (const InputError& error) {
    made.row.reason = relativeText(order.job, error.what());
    return made;
  }
  if (made.run->report.stopped_by == "interrupt") throw Stopped(false);
  made.planning = made.run->report.times.planning();
  fillRow(*made.run, made.row);
  if (made.run->report.status == PlanStatus::kSolved) label(order.job, made);
  return made;
}

void writeWalk(const BatchJob& job, MadeWalk& made, const std::filesystem::path& folder,
               const BatchOptions& options) {
  std::vector<ResultFile> files;
  if (made.run) {
    const Report& report = made.run->report;
    if (wants(job, "bvh") && !made.run->bvh.empty())
      files.push_back({folder / "walk.bvh", [&](std::ostream& out) { out << made.run->bvh; }});
    if (wants(job, "json"))
      files.push_back(
          {folder / "report.json", [&](std::ostream& out) { writeJson(out, report, false); }});
  }
  if (made.labels && wants(job, "labels")) {
    files.push_back({folder / "labels.json",
                     [&](std::ostream& out) { writeLabelsJson(out, *made.run, *made.labels); }});
    files.push_back({folder / "labels.npz",
                     [&](std::ostream& out) { writeLabelsNpz(out, *made.run, *made.labels); }});
  }
  files.push_back(
      {folder / "row.json", [&](std::ostream& out) { out << rowJson(made.row) << '\n'; }});
  const auto write = [&] { writeFiles(files); };
  if (made.run && options.more) {
    std::vector<ResultFile> more;
    options.more(*made.run, more, [&] {
      for (ResultFile& file : more) {
        file.file = folder / file.file;
        files.push_back(std::move(file));
      }
      write();
    });
    return;
  }
  write();
}

}  // namespace amble
