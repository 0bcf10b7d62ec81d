#include "viz/pictures/plan_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/output_file.h"
#include "base/text.h"
#include "viz/pictures/color.h"
#include "viz/pictures/plan_things.h"
#include "viz/pictures/svg.h"
#include "viz/pictures/tiny_text.h"

namespace amble {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRugLift = 0.002;   // what lies higher on the floor is a rug [m]
constexpr double kWidth = 1100;      // of the room [units]
constexpr double kTallest = 1300;    // of the room [units]
constexpr double kMargin = 30;       // about the room [units]
constexpr double kHeader = 46;       // for the title [units]
constexpr double kFooter = 60;       // for scale bar and legend [units]
constexpr double kWhyLine = 18;      // for a line of why there is no walk [units]
constexpr double kWhyLetter = 6.8;   // mean width of its letters [units]
constexpr double kAround = 0.3;      // shown beyond what the picture is about [m]
constexpr double kBeyondWalk = 3.0;  // shown of a large scene around the walk [m]

constexpr const char* kInk = "#2b2f36";
constexpr const char* kEdgeColor = "#3d8f6b";  // of the roadmap
const XmlAttributes kBodyStyle = {
    {"fill", "#d3d8df"}, {"stroke", "#8b94a1"}, {"stroke-width", 0.8}};
const XmlAttributes kReachedStyle = {{"fill", hexColor(kReachedColor)}, {"fill-opacity", 0.16}};
const XmlAttributes kRefusedStyle = {{"fill", "none"},
                                     {"stroke", hexColor(kStopColor)},
                                     {"stroke-width", 0.8},
                                     {"stroke-opacity", 0.35},
                                     {"stroke-dasharray", "5 4"}};
const XmlAttributes kHipStyle = {{"fill", "#9aa4b2"}, {"stroke", "#6f7987"}, {"stroke-width", 0.6}};

AlignedBox2d walkBox(const WalkView& view) {
  AlignedBox2d box;
  for (const Vector2d& p : pathLine(view)) box.extend(p);
  for (const auto& place : {view.start, view.goal})
    if (place) box.extend(place->position);
  for (const PlaceView& place : view.via) box.extend(place.position);
  if (view.obstruction != nullptr) box.extend(view.obstruction->at.head<2>());
  return box;
}

// The whole scene where it is a room; of a large one what is around the walk.
AlignedBox2d shownBox(const WalkView& view) {
  const Eigen::AlignedBox3d bounds = view.scene->bounds();
  AlignedBox2d box(bounds.min().head<2>(), bounds.max().head<2>());
  AlignedBox2d walk = walkBox(view);
  if (walk.isEmpty()) return box;
  AlignedBox2d around(walk.min() - Vector2d::Constant(kBeyondWalk),
                      walk.max() + Vector2d::Constant(kBeyondWalk));
  box = box.intersection(around);
  box.extend(walk);
  return {box.min() - Vector2d::Constant(kAround), box.max() + Vector2d::Constant(kAround)};
}

Vector2d pictureDirection(double heading) { return {std::cos(heading), -std::sin(heading)}; }

// Writes the drawing, layer by layer from the floor up.
class Drawing {
 public:
  Drawing(std::ostream& out, const WalkView& view)
      : xml_(out), view_(view), shown_(shownBox(view)) {
    const Vector2d size = shown_.sizes();
    frame_.scale = std::min(kWidth / size.x(), kTallest / size.y());
    frame_.origin = Vector2d(shown_.min().x(), shown_.max().y());
    width_ = size.x() * frame_.scale;
    height_ = size.y() * frame_.scale;
    why_ = brokenLines(view.why, static_cast<size_t>(width_ / kWhyLetter));
    header_ = kHeader + kWhyLine * static_cast<double>(why_.size());
  }

  void draw() {
    xml_.declare();
    const double wide = width_ + 2 * kMargin, tall = height_ + header_ + kFooter + kMargin;
    const auto svg = xml_.open("svg", svgScalingRoot(wide, tall));
    drawTitle(wide, tall);
    const auto page = xml_.open(
        "g", {{"transform", "translate(" + xmlNumber(kMargin) + " " + xmlNumber(header_) + ")"}});
    drawRoom();
    xml_.empty("rect", roomBox() + XmlAttributes{{"fill", "none"}, {"stroke", "#c9ccd2"}});
    drawScaleBar();
    drawLegend();
  }

 private:
  XmlAttributes roomBox() const {
    return {{"x", 0}, {"y", 0}, {"width", width_}, {"height", height_}};
  }

  void drawTitle(double wide, double tall) {
    xml_.text("title", {}, view_.title);
    {
      const auto defs = xml_.open("defs");
      const auto clip = xml_.open("clipPath", {{"id", "room"}});
      xml_.empty("rect", roomBox());
    }
    xml_.empty("rect",
               {{"x", 0}, {"y", 0}, {"width", wide}, {"height", tall}, {"fill", "#ffffff"}});
    xml_.text(
        "text",
        {{"x", kMargin}, {"y", 31}, {"font-size", 20}, {"font-weight", "bold"}, {"fill", kInk}},
        view_.title);
    for (size_t i = 0; i < why_.size(); ++i) {
      xml_.text("text",
                {{"class", "why"},
                 {"x", kMargin},
                 {"y", 35 + kWhyLine * static_cast<double>(i + 1)},
                 {"font-size", 13},
                 {"fill", hexColor(kStopColor)}},
                why_[i]);
    }
  }

  void drawRoom() {
    const auto clipped = xml_.open("g", {{"clip-path", "url(#room)"}});
    xml_.empty("rect", roomBox() + XmlAttributes{{"fill", "#f1f2f4"}});
    const std::vector<PlanThing> things = cutScene(*view_.scene, view_.floor);
    drawThings(things);
    drawReached();
    drawRefused();
    drawRoadmap();
    drawFootprints();
    drawPath();
    drawPlaces();
    drawNames(things);
    drawStop();
  }

  void drawOutlines(const std::vector<Outline>& outlines, const std::string& name,
                    const XmlAttributes& style) {
    if (outlines.empty()) return;
    std::string path;
    for (const Outline& outline : outlines) path += svgPath(frame_, outline, true);
    const auto drawn = xml_.open("path", XmlAttributes{{"d", path}} + style);
    xml_.text("title", {}, name);
  }

  void drawThings(const std::vector<PlanThing>& things) {
    const XmlAttributes floor = {{"fill", "#fbf8f2"}};
    const XmlAttributes rug = {{"fill", "#f0dcd8"}, {"stroke", "#e2c4be"}, {"stroke-width", 0.8}};
    const XmlAttributes solid = {{"fill-rule", "nonzero"}};
    {
      const auto group = xml_.open("g", {{"id", "floor"}});
      for (const PlanThing& thing : things) {
        if (thing.top > kFloorDepth) continue;
        drawOutlines(thing.floor, thing.name, thing.top > kRugLift ? rug : floor);
      }
    }
    {
      const auto group = xml_.open("g", XmlAttributes{{"id", "things"}} + kBodyStyle);
      for (const PlanThing& thing : things) drawOutlines(thing.body, thing.name, solid);
    }
    const auto group = xml_.open("g", XmlAttributes{{"id", "at-hip-height"}} + kHipStyle);
    for (const PlanThing& thing : things) drawOutlines(thing.hips, thing.name, solid);
  }

  void drawReached() {
    if (view_.reached == nullptr) return;
    const double half = view_.reached->breadth / 2;
    std::string path;
    for (const ReachedRegion::Strip& strip : view_.reached->strips) {
      const Vector2d reach(half, half);
      const Vector2d low = strip.from.head<2>() - reach, high = strip.to.head<2>() + reach;
      const std::array<Vector2d, 4> outline = {low, Vector2d(high.x(), low.y()), high,
                                               Vector2d(low.x(), high.y())};
      path += svgPath(frame_, outline, true);
    }
    xml_.empty("path", XmlAttributes{{"id", "reached"}, {"d", path}} + kReachedStyle);
  }

  // Where one gets no farther: the way that is missing, and a cross where a part touched.
  void drawStop() {
    const XmlAttributes style = {{"fill", "none"}, {"stroke", hexColor(kStopColor)}};
    if (view_.reached != nullptr) {
      const std::array<Vector2d, 2> line = {view_.reached->near.head<2>(),
                                            view_.reached->far.head<2>()};
      xml_.empty("path", XmlAttributes{{"id", "missing"},
                                       {"d", svgPath(frame_, line, false)},
                                       {"stroke-width", 2},
                                       {"stroke-dasharray", "4 3"}} +
                             style);
    }
    if (view_.obstruction == nullptr) return;
    constexpr double kArm = 7;  // [units]
    const Vector2d p = frame_(view_.obstruction->at.head<2>());
    std::string cross;
    for (const double side : {-1.0, 1.0}) {
      const Vector2d arm(kArm, side * kArm);
      cross += svgPath(std::array<Vector2d, 2>{p - arm, p + arm}, false);
    }
    xml_.empty("path", XmlAttributes{{"id", "stop"}, {"d", cross}, {"stroke-width", 3.5}} + style);
    drawStopWords(p);
  }

  // Part, thing, what there is and what would do.
  void drawStopWords(const Vector2d& p) {
    const Obstruction& why = *view_.obstruction;
    std::vector<std::string> lines;
    if (!why.part.empty()) lines.push_back(why.part + " and " + why.object);
    if (why.width && why.needed)
      lines.push_back(plainNumber(*why.width, 2) + " m of " + plainNumber(*why.needed, 2) + " m");
    const bool left = p.x() > width_ / 2;  // of the cross, where there is more room
    for (size_t i = 0; i < lines.size(); ++i) {
      xml_.text("text",
                {{"class", "stop"},
                 {"x", p.x() + (left ? -13 : 13)},
                 {"y", p.y() - 10 + 15 * static_cast<double>(i)},
                 {"font-size", 12.5},
                 {"font-weight", "bold"},
                 {"text-anchor", left ? "end" : "start"},
                 {"fill", hexColor(kStopColor)},
                 {"stroke", "#ffffff"},
                 {"stroke-width", 3},
                 {"stroke-linejoin", "round"},
                 {"paint-order", "stroke"}},
                lines[i]);
    }
  }

  // From where to where was tried, and a dot where it failed.
  void drawRefused() {
    const auto group = xml_.open("g", XmlAttributes{{"id", "refused"}} + kRefusedStyle);
    for (const RoadmapView::Refused& refused : view_.roadmap.refused) {
      const auto attempt = xml_.open("g", {{"class", "refused"}});
      xml_.text("title", {}, refused.what);
      const std::array<Vector2d, 2> line = {frame_(refused.from), frame_(refused.to)};
      xml_.empty("path", {{"d", svgPath(line, false)}});
      const Vector2d p = frame_(refused.at);
      xml_.empty("circle", {{"cx", p.x()},
                            {"cy", p.y()},
                            {"r", 2.5},
                            {"fill", hexColor(kStopColor)},
                            {"stroke", "none"}});
    }
  }

  void drawRoadmap() {
    const RoadmapView& map = view_.roadmap;
    const auto group = xml_.open("g", {{"id", "roadmap"},
                                       {"fill", "none"},
                                       {"stroke", kEdgeColor},
                                       {"stroke-width", 1},
                                       {"stroke-opacity", 0.5}});
    for (const RoadmapView::Edge& edge : map.edges) drawEdge(edge);
    for (const RoadmapView::Node& node : map.nodes) {
      constexpr double kReach = 11;  // of the line that shows a heading [units]
      const Vector2d p = frame_(node.position);
      const std::array<Vector2d, 2> ahead = {p, p + kReach * pictureDirection(node.heading)};
      xml_.empty("path", {{"d", svgPath(ahead, false)}, {"stroke-opacity", 0.6}});
      drawNode(p, node.connector);
    }
  }

  // Its curve, and beyond the middle an arrow's head: the edge back has its own.
  void drawEdge(const RoadmapView::Edge& edge) {
    constexpr double kHeadAt = 0.6;  // of its points
    std::vector<Vector2d> line;
    for (const Vector2d& p : edge.line) line.push_back(frame_(p));
    if (line.empty()) {
      for (const int node : {edge.from, edge.to})
        line.push_back(frame_(view_.roadmap.nodes[node].position));
    }
    if ((line.back() - line.front()).norm() < 1 && line.size() < 3) return;  // turns on the spot
    xml_.empty("path", {{"class", "edge"}, {"d", svgCurve(line)}});
    const size_t i =
        std::max<size_t>(1, static_cast<size_t>(kHeadAt * static_cast<double>(line.size() - 1)));
    const Vector2d tip =
        line.size() == 2 ? Vector2d(line[0] + kHeadAt * (line[1] - line[0])) : line[i];
    drawHead(tip, (line[i] - line[i - 1]).normalized());
  }

  void drawHead(const Vector2d& tip, const Vector2d& along) {
    constexpr double kLong = 9, kWide = 3.2;  // [units]
    const Vector2d across(-along.y(), along.x());
    const std::array<Vector2d, 3> head = {tip, tip - kLong * along + kWide * across,
                                          tip - kLong * along - kWide * across};
    xml_.empty("path", {{"class", "direction"},
                        {"d", svgPath(head, true)},
                        {"fill", kEdgeColor},
                        {"fill-opacity", 0.6},
                        {"stroke", "none"}});
  }

  void drawNode(const Vector2d& p, bool connector) {
    const XmlAttributes style = {
        {"stroke", "#2f7d5c"}, {"stroke-opacity", 0.75}, {"stroke-width", 1.3}};
    if (connector) {
      xml_.empty("rect", XmlAttributes{{"class", "connector"},
                                       {"x", p.x() - 4},
                                       {"y", p.y() - 4},
                                       {"width", 8},
                                       {"height", 8},
                                       {"fill", "#8fd0b4"}} +
                             style);
    } else {
      xml_.empty(
          "circle",
          XmlAttributes{
              {"class", "guard"}, {"cx", p.x()}, {"cy", p.y()}, {"r", 5.5}, {"fill", "#ffffff"}} +
              style);
    }
  }

  void drawFootprints() {
    if (view_.animation == nullptr) return;
    const double length = soleLength(view_);
    const auto group = xml_.open("g", {{"id", "footprints"}, {"fill-opacity", 0.8}});
    for (const Footprint& print : view_.animation->footprints) {
      xml_.empty("path", {{"class", print.side == kLeft ? "left" : "right"},
                          {"d", svgPath(frame_, placedShoe(print, length), true)},
                          {"fill", hexColor(sideColor(print.side))}});
    }
  }

  void drawPath() {
    const std::vector<Vector2d> line = pathLine(view_);
    if (line.empty()) return;
    xml_.empty("path", {{"id", "root-path"},
                        {"d", svgPath(frame_, line, false)},
                        {"fill", "none"},
                        {"stroke", hexColor(kPathColor)},
                        {"stroke-width", 2},
                        {"stroke-linejoin", "round"}});
  }

  // A disc with a letter, and an arrow where the heading is given.
  void drawPlace(const PlaceView& place, const char* id, const std::string& letter,
                 const std::string& color) {
    const Vector2d p = frame_(place.position);
    const auto group = xml_.open("g", {{"class", id}});
    if (place.heading) {
      const Vector2d along = pictureDirection(*place.heading), across(-along.y(), along.x());
      const std::array<Vector2d, 2> shaft = {p, p + 22 * along};
      const std::array<Vector2d, 3> head = {p + 31 * along, p + 20 * along + 6.5 * across,
                                            p + 20 * along - 6.5 * across};
      xml_.empty("path", {{"d", svgPath(shaft, false)}, {"stroke", color}, {"stroke-width", 4}});
      xml_.empty("path", {{"d", svgPath(head, true)}, {"fill", color}});
    }
    xml_.empty("circle", {{"cx", p.x()},
                          {"cy", p.y()},
                          {"r", 11},
                          {"fill", color},
                          {"stroke", "#ffffff"},
                          {"stroke-width", 1.5}});
    xml_.text("text",
              {{"x", p.x()},
               {"y", p.y() + 4.5},
               {"font-size", 13},
               {"font-weight", "bold"},
               {"text-anchor", "middle"},
               {"fill", "#ffffff"}},
              letter);
  }

  void drawPlaces() {
    for (size_t i = 0; i < view_.via.size(); ++i)
      drawPlace(view_.via[i], "via", std::to_string(i + 1), "#6d5bb0");
    if (view_.start) drawPlace(*view_.start, "start", "S", hexColor(kStartColor));
    if (view_.goal) drawPlace(*view_.goal, "goal", "G", hexColor(kGoalColor));
  }

  // Names of things that are large enough to write them on; walls need none.
  void drawNames(const std::vector<PlanThing>& things) {
    constexpr double kLetter = 6.2;  // mean width of a letter of size 12 [units]
    const auto group = xml_.open("g", {{"id", "names"},
                                       {"font-size", 12},
                                       {"text-anchor", "middle"},
                                       {"fill", "#30353d"},
                                       {"stroke", "#ffffff"},
                                       {"stroke-width", 2.5},
                                       {"stroke-linejoin", "round"},
                                       {"paint-order", "stroke"}});
    std::vector<AlignedBox2d> written;
    for (const PlanThing& thing : things) {
      if (thing.body.empty() || coveredArea(thing.body) < 0.04) continue;
      const Vector2d size = thing.box.sizes() * frame_.scale;
      const double text = kLetter * static_cast<double>(thing.name.size());
      if (std::min(size.x(), size.y()) < 16 || size.x() + 24 < text) continue;
      if (size.maxCoeff() > 0.7 * std::min(width_, height_)) continue;  // a whole flat in one file
      const Vector2d p = frame_(thing.box.center()), half(text / 2, 7);
      const AlignedBox2d box(p - half, p + half);
      if (std::any_of(written.begin(), written.end(),
                      [&](const AlignedBox2d& other) { return other.intersects(box); }))
        continue;  // of the treads of a stair some
      written.push_back(box);
      xml_.text("text", {{"x", p.x()}, {"y", p.y() + 4}}, thing.name);
    }
  }

  void drawScaleBar() {
    const double metre = frame_.scale, y = height_ + 24;
    const int metres = metre > 60 ? 1 : metre > 12 ? 5 : 10;
    const auto group = xml_.open("g", {{"id", "scale-bar"}, {"font-size", 12}, {"fill", kInk}});
    for (int i = 0; i < 4; ++i) {
      xml_.empty("rect", {{"x", i * metre * metres / 4},
                          {"y", y},
                          {"width", metre * metres / 4},
                          {"height", 6},
                          {"fill", i % 2 != 0 ? "#ffffff" : kInk},
                          {"stroke", kInk},
                          {"stroke-width", 1}});
    }
    xml_.text("text", {{"x", 0}, {"y", y + 22}, {"text-anchor", "start"}}, "0");
    xml_.text("text", {{"x", metre * metres}, {"y", y + 22}, {"text-anchor", "middle"}},
              std::to_string(metres) + " m");
  }

  void legendText(double x, double y, const char* text) {
    xml_.text("text", {{"x", x}, {"y", y}}, text);
  }

  void legendSwatch(double x, double y, const XmlAttributes& style, const char* text) {
    xml_.empty("rect",
               XmlAttributes{{"x", x}, {"y", y - 10}, {"width", 18}, {"height", 12}} + style);
    legendText(x + 26, y, text);
  }

  void legendShoe(double x, double y, Side side, const char* text) {
    Footprint print;
    print.side = side;
    const SvgFrame at{Vector2d(-x / 70, y / 70), 70};
    xml_.empty("path", {{"d", svgPath(at, placedShoe(print, 0.27), true)},
                        {"fill", hexColor(sideColor(side))}});
    legendText(x + 16, y + 4, text);
  }

  void legendLine(double x, double y, const XmlAttributes& style, const char* text) {
    const std::array<Vector2d, 2> line = {Vector2d(x, y - 4), Vector2d(x + 22, y - 4)};
    xml_.empty("path", XmlAttributes{{"d", svgPath(line, false)}} + style);
    legendText(x + 30, y, text);
  }

  void drawLegend() {
    const double left = std::max(frame_.scale * 1.2, 130.0), row1 = height_ + 32, row2 = row1 + 26;
    const double column = (width_ - left) / 4, third = left + 2 * column;
    const auto group = xml_.open("g", {{"id", "legend"}, {"font-size", 12}, {"fill", kInk}});
    legendSwatch(left, row1, kBodyStyle, "between 0.05 and 1.8 m");
    legendSwatch(left, row2, kHipStyle, "between 0.5 and 1.2 m");
    legendShoe(left + column + 22, row1 - 4, kLeft, "left foot");
    legendShoe(left + column + 22, row2 - 4, kRight, "right foot");
    if (view_.reached != nullptr)
      legendSwatch(third, row1, kReachedStyle, "reached from the start");
    else
      legendLine(third, row1, {{"stroke", hexColor(kPathColor)}, {"stroke-width", 2}}, "root path");
    legendLine(third, row2, {{"stroke", kEdgeColor}, {"stroke-opacity", 0.5}}, "roadmap edge");
    drawNode({third + column + 8, row1 - 4}, false);
    drawNode({third + column + 8, row2 - 4}, true);
    legendText(third + column + 24, row1, "guard");
    legendText(third + column + 24, row2, "connector");
    if (!view_.roadmap.refused.empty())
      legendLine(third + column + 106, row2, kRefusedStyle, "refused");
  }

  XmlWriter xml_;
  const WalkView& view_;
  AlignedBox2d shown_;
  SvgFrame frame_;
  double width_ = 0, height_ = 0;  // of the room [units]
  double header_ = kHeader;        // [units]
  std::vector<std::string> why_;   // lines
};

}  // namespace

void writePlanView(std::ostream& out, const WalkView& view) { Drawing(out, view).draw(); }

void writePlanView(const std::filesystem::path& file, const WalkView& view) {
  writeFile(file, [&](std::ostream& out) { writePlanView(out, view); });
}

}  // namespace amble
