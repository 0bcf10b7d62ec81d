#include "app/result_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "app/stop.h"
#include "base/child_program.h"
#include "base/error.h"
#include "viz/exchange/gazebo_actor.h"
#include "viz/exchange/glb.h"
#include "viz/exchange/movie.h"
#include "viz/exchange/walk_csv.h"
#include "viz/exchange/walk_npz.h"
#include "viz/page/walk_page.h"
#include "viz/pictures/plan_view.h"
#include "viz/pictures/render.h"
#include "viz/pictures/report_page.h"

namespace amble {
namespace {

const std::string& planViewOf(const ResultSubject& subject) {
  SharedParts& shared = *subject.shared;
  std::call_once(shared.svg_made, [&] {
    std::ostringstream out;
    writePlanView(out, subject.view);
    shared.svg = std::move(out).str();
  });
  return shared.svg;
}

const std::string& pictureOf(const ResultSubject& subject) {
  SharedParts& shared = *subject.shared;
  std::call_once(shared.png_made, [&] {
    std::ostringstream out;
    writePng(out, renderWalk(subject.view, {.threads = subject.threads}));
    shared.png = std::move(out).str();
  });
  return shared.png;
}

// @pre subject.view.hasBody()
const Figure& figureOf(const ResultSubject& subject) {
  SharedParts& shared = *subject.shared;
  std::call_once(shared.figure_made,
                 [&] { shared.figure = makeFigure(*subject.view.skeleton, *subject.view.body); });
  return *shared.figure;
}

void addPlanView(const ResultSubject& subject, std::vector<ResultFile>& files) {
  files.push_back({"top.svg", [subject](std::ostream& out) { out << planViewOf(subject); }});
}

void addPicture(const ResultSubject& subject, std::vector<ResultFile>& files) {
  files.push_back({"walk.png", [subject](std::ostream& out) { out << pictureOf(subject); }});
}

// Each under its name.
const std::vector<std::pair<std::string, PointOfView>>& pointsOfView() {
  static const std::vector<std::pair<std::string, PointOfView>> points = {
      {"top", PointOfView::kTop},
      {"side", PointOfView::kSide},
      {"corner", PointOfView::kCorner},
      {"first", PointOfView::kFirst}};
  return points;
}

void addViews(const ResultSubject& subject, std::vector<ResultFile>& files) {
  for (const auto& [name, from] : pointsOfView()) {
    if (std::find(subject.views.begin(), subject.views.end(), name) == subject.views.end())
      continue;
    if (from == PointOfView::kCorner) {  // as walk.png is seen
      files.push_back(
          {"walk-" + name + ".png", [subject](std::ostream& out) { out << pictureOf(subject); }});
      continue;
    }
    files.push_back(
        {"walk-" + name + ".png", [subject, from](std::ostream& out) {
           writePng(out, renderWalk(subject.view, {.from = from, .threads = subject.threads}));
         }});
  }
}

void addReportPage(const ResultSubject& subject, std::vector<ResultFile>& files) {
  files.push_back({"report.html", [subject](std::ostream& out) {
                     writeReportPage(out, {.report = subject.result.report,
                                           .command = subject.command,
                                           .picture = pictureOf(subject),
                                           .plan = planViewOf(subject),
                                           .reached = subject.view.reached});
                   }});
}

void addPage(const ResultSubject& subject, std::vector<ResultFile>& files) {
  files.push_back({"walk.html", [subject](std::ostream& out) {
                     WalkPage page = walkPage(subject.result, subject.view);
                     PageActor& walker = page.subject.actors.front();
                     if (subject.view.hasBody()) walker.figure = &figureOf(subject);
                     writePage(out, page.subject);
                   }});
}

void addStrip(const ResultSubject& subject, std::vector<ResultFile>& files) {
  StripSettings strip = stripOfWhole(*subject.view.animation);
  strip.threads = subject.threads;
  files.push_back({"strip.png", [view = &subject.view, strip](std::ostream& out) {
                     writePng(out, renderStrip(*view, strip));
                   }});
}

void addGlb(const ResultSubject& subject, std::vector<ResultFile>& files) {
  files.push_back({"walk.glb", [subject](std::ostream& out) {
                     std::ostringstream json;
                     writeJson(json, subject.result.report);
                     writeGlb(out, subject.view, figureOf(subject),
                              {.scene = subject.scene_in_glb,
                               .joint_names = subject.result.joint_names,
                               .report = json.str()});
                   }});
}

void addTables(const ResultSubject& subject, std::vector<ResultFile>& files) {
  const WalkView* const view = &subject.view;
  const Report* const report = &subject.result.report;
  files.push_back({"path.csv", [=](std::ostream& out) { writePathCsv(out, *view); }});
  files.push_back(
      {"steps.csv", [=](std::ostream& out) { writeStepsCsv(out, *view, report->steps); }});
  files.push_back(
      {"joints.csv", [=](std::ostream& out) { writeJointsCsv(out, *view, report->joint_names); }});
}

void addArrays(const ResultSubject& subject, std::vector<ResultFile>& files) {
  files.push_back(
      {"walk.npz", [view = &subject.view, report = &subject.result.report](std::ostream& out) {
         writeWalkNpz(out, *view, report->joint_names);
       }});
}

void addActor(const ResultSubject& subject, std::vector<ResultFile>& files) {
  const Report* const report = &subject.result.report;
  const bool with_room = subject.scene_in_glb;
  files.push_back(
      {"walk.sdf", [=](std::ostream& out) { writeActorSdf(out, report->bvh_unit, with_room); }});
  if (with_room) {
    files.push_back({"room.dae", [view = &subject.view](std::ostream& out) {
                       writeRoomCollada(out, *view->scene, view->floor);
                     }});
  }
  files.push_back({"walk.dae", [=](std::ostream& out) {
                     writeSkinCollada(out, *subject.view.skeleton, figureOf(subject),
                                      report->joint_names);
                   }});
}

// A wish to stop that was there before, which ended the planning, does not end the film too.
void addFilm(const ResultSubject& subject, std::vector<ResultFile>& files) {
  FilmSettings settings;
  settings.threads = subject.threads;
  settings.follow = subject.film_follows;
  const StopRequest stop{.flag = stopFlag() ? nullptr : &stopFlag(), .deadline = {}};
  files.push_back({"walk.mp4", [subject, settings, stop](std::ostream& out) {
                     writeMp4(out, subject.view, figureOf(subject), settings, stop);
                   }});
}

std::vector<ResultFormat> formatsUnasked() {
  return {
      {.name = "bvh", .files = {"walk.bvh"}, .what = "the walk"},
      {.name = "json", .files = {"report.json"}, .what = "its report", .of_walk = false},
      {.name = "svg",
       .files = {"top.svg"},
       .what = "seen from above",
       .of_walk = false,
       .add = addPlanView},
      {.name = "png",
       .files = {"walk.png"},
       .what = "a picture",
       .of_walk = false,
       .add = addPicture},
      {.name = "html",
       .files = {"walk.html"},
       .what = "a page to look at it in a browser",
       .of_walk = false,
       .add = addPage},
      {.name = "report",
       .files = {"report.html"},
       .what = "its report as a page to read and to print",
       .of_walk = false,
       .add = addReportPage},
  };
}

std::vector<ResultFormat> formatsIfAsked() {
  return {
      {.name = "views",
       .files = {"walk-top.png", "walk-side.png", "walk-corner.png", "walk-first.png"},
       .what = "pictures from above, from the side, from a corner and by the walker's eyes",
       .usual = false,
       .of_walk = false,
       .add = addViews},
      {.name = "strip",
       .files = {"strip.png"},
       .what = "frame by frame from the side",
       .usual = false,
       .add = addStrip},
      {.name = "glb",
       .files = {"walk.glb"},
       .what = "the walk with a body, in its scene, for Blender, Unity, Unreal, Godot",
       .usual = false,
       .add = addGlb},
      {.name = "csv",
       .files = {"path.csv", "steps.csv", "joints.csv"},
       .what = "tables of root path, steps and joints",
       .usual = false,
       .add = addTables},
      {.name = "npz",
       .files = {"walk.npz"},
       .what = "arrays for NumPy",
       .usual = false,
       .add = addArrays},
      {.name = "sdf",
       .files = {"walk.sdf", "walk.dae", "room.dae"},
       .what = "an actor for Gazebo, with its BVH and the room",
       .usual = false,
       .with = "bvh",
       .add = addActor},
      {.name = "mp4",
       .files = {"walk.mp4"},
       .what = "a film, which ffmpeg makes",
       .usual = false,
       .program = "ffmpeg",
       .add = addFilm},
  };
}

}  // namespace

std::vector<std::string> viewNames() {
  std::vector<std::string> names;
  for (const auto& [name, from] : pointsOfView()) names.push_back(name);
  return names;
}

const std::vector<ResultFormat>& resultFormats() {
  static const std::vector<ResultFormat> formats = [] {
    std::vector<ResultFormat> all = formatsUnasked(), others = formatsIfAsked();
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }();
  return formats;
}

std::vector<std::string> formatNames() {
  std::vector<std::string> names;
  for (const ResultFormat& format : resultFormats()) names.emplace_back(format.name);
  return names;
}

std::vector<std::string> usualFormats() {
  std::vector<std::string> names;
  for (const ResultFormat& format : resultFormats())
    if (format.usual) names.emplace_back(format.name);
  return names;
}

void checkPrograms(const std::vector<std::string>& formats) {
  for (const ResultFormat& format : resultFormats()) {
    const bool asked = std::find(formats.begin(), formats.end(), format.name) != formats.end();
    if (!asked || format.program == nullptr || !findProgram(format.program).empty()) continue;
    throw InputError("--formats", 0,
                     fmt::format("{} is made by the program {}, which is not installed",
                                 format.name, format.program),
                     "it, or other formats");
  }
}

std::string formatsHelp() {
  std::vector<std::string> all;
  for (const ResultFormat& format : resultFormats())
    all.push_back(fmt::format("{} ({})", format.name, format.what));
  return fmt::format("What to write: {}", fmt::join(all, ", "));
}

std::vector<std::filesystem::path> resultFileNames() {
  std::vector<std::filesystem::path> names;
  for (const ResultFormat& format : resultFormats())
    for (const char* file : format.files) names.emplace_back(file);
  return names;
}

}  // namespace amble
