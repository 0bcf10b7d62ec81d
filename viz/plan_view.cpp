#include "viz/plan_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/output_file.h"
#include "viz/color.h"
#include "viz/outline.h"
#include "viz/svg.h"

namespace amble {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLow = 0.05, kHigh = 1.80;        // what a body can touch, over the floor [m]
constexpr double kHipLow = 0.50, kHipHigh = 1.20;  // where hips and hands are [m]
constexpr double kCell = 0.008;                    // of the outlines of meshes [m]
constexpr double kRugLift = 0.002;                 // what lies higher on the floor is a rug [m]
constexpr double kFloorDepth = 0.03;  // tops this close to the floor are floor or rug [m]
constexpr double kOneThing = 5.0;     // what a file with parts spans at most to be one thing [m]
constexpr double kWidth = 1100;       // of the room [units]
constexpr double kTallest = 1300;     // of the room [units]
constexpr double kMargin = 30;        // about the room [units]
constexpr double kHeader = 46;        // for the title [units]
constexpr double kFooter = 60;        // for scale bar and legend [units]
constexpr double kAround = 0.3;       // shown beyond what the picture is about [m]
constexpr double kBeyondWalk = 3.0;   // shown of a large scene around the walk [m]

// What of the scene is drawn: objects of one name are one thing; a file that holds a whole flat is
// a thing a part.
struct Thing {
  std::string name;
  std::vector<Outline> floor, body, hips;  // by height
  AlignedBox2d box;                        // of `body` [m]
  double top = 0;                          // highest point over the floor [m]
};

// Objects that are drawn as one thing.
struct ThingObjects {
  std::string name;
  std::vector<const SceneObject*> objects;
};

std::vector<ThingObjects> groupObjects(const Scene& scene) {
  std::vector<ThingObjects> groups;
  for (const SceneObject& object : scene.objects) {
    if (groups.empty() || groups.back().name != object.name) groups.push_back({object.name, {}});
    groups.back().objects.push_back(&object);
  }
  std::vector<ThingObjects> things;
  for (const ThingObjects& group : groups) {
    AlignedBox2d box;
    for (const SceneObject* object : group.objects)
      for (const Vector3d& p : worldMesh(*object).vertices) box.extend(p.head<2>());
    if (group.objects.size() == 1 || box.diagonal().norm() < kOneThing) {
      things.push_back(group);
    } else {
      for (const SceneObject* object : group.objects) things.push_back({object->part, {object}});
    }
  }
  return things;
}

TriangleMesh wholeMesh(const std::vector<const SceneObject*>& objects) {
  TriangleMesh whole;
  for (const SceneObject* object : objects) {
    const TriangleMesh part = worldMesh(*object);
    const int base = static_cast<int>(whole.vertices.size());
    whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& t : part.triangles)
      whole.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return whole;
}

std::vector<Thing> cutScene(const Scene& scene, double floor) {
  std::vector<Thing> things;
  for (const ThingObjects& group : groupObjects(scene)) {
    Thing& thing = things.emplace_back();
    thing.name = group.name;
    const TriangleMesh mesh = wholeMesh(group.objects);
    const bool convex =
        group.objects.size() == 1 && !std::holds_alternative<TriangleMesh>(group.objects[0]->shape);
    const auto trace = convex ? traceConvexOutline : traceOutlines;
    for (const Vector3d& p : mesh.vertices) thing.top = std::max(thing.top, p.z() - floor);
    thing.floor = trace(mesh, {floor - kFloorDepth, floor + kFloorDepth, 0.02});
    thing.body = trace(mesh, {floor + kLow, floor + kHigh, kCell});
    thing.hips = trace(mesh, {floor + kHipLow, floor + kHipHigh, kCell});
    for (const Outline& outline : thing.body)
      for (const Vector2d& p : outline) thing.box.extend(p);
  }
  return things;
}

AlignedBox2d walkBox(const WalkView& view) {
  AlignedBox2d box;
  for (const Vector2d& p : pathLine(view)) box.extend(p);
  for (const auto& place : {view.start, view.goal})
    if (place) box.extend(place->position);
  for (const PlaceView& place : view.via) box.extend(place.position);
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

// Writes the drawing, layer by layer from the floor up.
class Drawing {
 public:
  Drawing(std::ostream& out, const WalkView& view)
      : out_(out), view_(view), shown_(shownBox(view)) {
    const Vector2d size = shown_.sizes();
    frame_.scale = std::min(kWidth / size.x(), kTallest / size.y());
    frame_.origin = Vector2d(shown_.min().x(), shown_.max().y());
    width_ = size.x() * frame_.scale;
    height_ = size.y() * frame_.scale;
  }

  void draw() {
    begin();
    const std::vector<Thing> things = cutScene(*view_.scene, view_.floor);
    drawThings(things);
    drawRoadmap();
    drawFootprints();
    drawPath();
    drawPlaces();
    drawNames(things);
    out_ << "</g>\n<rect x=\"0\" y=\"0\" width=\"" << svgNumber(width_) << "\" height=\""
         << svgNumber(height_) << "\" fill=\"none\" stroke=\"#c9ccd2\"/>\n";
    drawScaleBar();
    drawLegend();
    out_ << "</g>\n</svg>\n";
  }

 private:
  void begin() {
    const double wide = width_ + 2 * kMargin, tall = height_ + kHeader + kFooter + kMargin;
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
            "width=\""
         << svgNumber(wide) << "\" height=\"" << svgNumber(tall) << "\" viewBox=\"0 0 "
         << svgNumber(wide) << ' ' << svgNumber(tall) << "\" font-family=\"sans-serif\">\n<title>"
         << svgEscape(view_.title) << "</title>\n"
         << "<defs><clipPath id=\"room\"><rect x=\"0\" y=\"0\" width=\"" << svgNumber(width_)
         << "\" height=\"" << svgNumber(height_) << "\"/></clipPath></defs>\n"
         << "<rect x=\"0\" y=\"0\" width=\"" << svgNumber(wide) << "\" height=\"" << svgNumber(tall)
         << "\" fill=\"#ffffff\"/>\n<text x=\"" << svgNumber(kMargin)
         << "\" y=\"31\" font-size=\"20\" font-weight=\"bold\" fill=\"#2b2f36\">"
         << svgEscape(view_.title) << "</text>\n<g transform=\"translate(" << svgNumber(kMargin)
         << ' ' << svgNumber(kHeader)
         << ")\">\n<g clip-path=\"url(#room)\">\n<rect x=\"0\" y=\"0\" width=\""
         << svgNumber(width_) << "\" height=\"" << svgNumber(height_) << "\" fill=\"#f1f2f4\"/>\n";
  }

  void drawOutlines(const std::vector<Outline>& outlines, const std::string& name,
                    const std::string& style) {
    if (outlines.empty()) return;
    std::string path;
    for (const Outline& outline : outlines) path += svgPath(frame_, outline, true);
    out_ << "<path d=\"" << path << "\" " << style << "><title>" << svgEscape(name)
         << "</title></path>\n";
  }

  void drawThings(const std::vector<Thing>& things) {
    out_ << "<g id=\"floor\">\n";
    for (const Thing& thing : things) {
      if (thing.top > kFloorDepth) continue;
      const bool rug = thing.top > kRugLift;
      drawOutlines(
          thing.floor, thing.name,
          !rug ? "fill=\"#fbf8f2\"" : "fill=\"#f0dcd8\" stroke=\"#e2c4be\" stroke-width=\"0.8\"");
    }
    out_ << "</g>\n<g id=\"things\" fill=\"#d3d8df\" stroke=\"#8b94a1\" stroke-width=\"0.8\">\n";
    for (const Thing& thing : things) drawOutlines(thing.body, thing.name, "fill-rule=\"nonzero\"");
    out_ << "</g>\n<g id=\"at-hip-height\" fill=\"#9aa4b2\" stroke=\"#6f7987\" "
            "stroke-width=\"0.6\">\n";
    for (const Thing& thing : things) drawOutlines(thing.hips, thing.name, "fill-rule=\"nonzero\"");
    out_ << "</g>\n";
  }

  void drawRoadmap() {
    const RoadmapView& map = view_.roadmap;
    out_ << "<g id=\"roadmap\" fill=\"none\" stroke=\"#3d8f6b\" stroke-width=\"1\" "
            "stroke-opacity=\"0.35\">\n";
    for (const RoadmapView::Edge& edge : map.edges) {
      const std::array<Vector2d, 2> straight = {map.nodes[edge.from].position,
                                                map.nodes[edge.to].position};
      const std::span<const Vector2d> line =
          edge.line.empty() ? std::span<const Vector2d>(straight) : edge.line;
      out_ << "<path class=\"edge\" d=\"" << svgPath(frame_, line, false) << "\"/>\n";
    }
    for (const RoadmapView::Node& node : map.nodes) {
      const Vector2d p = frame_(node.position);
      const Vector2d tip = p + 11 * Vector2d(std::cos(node.heading), -std::sin(node.heading));
      out_ << "<path d=\"M" << svgNumber(p.x()) << ' ' << svgNumber(p.y()) << 'L'
           << svgNumber(tip.x()) << ' ' << svgNumber(tip.y()) << "\" stroke-opacity=\"0.6\"/>\n";
      drawNode(p, node.connector);
    }
    out_ << "</g>\n";
  }

  void drawNode(const Vector2d& p, bool connector) {
    const char* style = "stroke=\"#2f7d5c\" stroke-opacity=\"0.75\" stroke-width=\"1.3\"";
    if (connector) {
      out_ << "<rect class=\"connector\" x=\"" << svgNumber(p.x() - 4) << "\" y=\""
           << svgNumber(p.y() - 4) << "\" width=\"8\" height=\"8\" fill=\"#8fd0b4\" " << style
           << "/>\n";
    } else {
      out_ << "<circle class=\"guard\" cx=\"" << svgNumber(p.x()) << "\" cy=\"" << svgNumber(p.y())
           << "\" r=\"5.5\" fill=\"#ffffff\" " << style << "/>\n";
    }
  }

  void drawFootprints() {
    if (view_.animation == nullptr) return;
    const double length = soleLength(view_);
    out_ << "<g id=\"footprints\" fill-opacity=\"0.8\">\n";
    for (const Footprint& print : view_.animation->footprints) {
      out_ << "<path class=\"" << (print.side == kLeft ? "left" : "right") << "\" d=\""
           << svgPath(frame_, placedShoe(print, length), true) << "\" fill=\""
           << hexColor(sideColor(print.side)) << "\"/>\n";
    }
    out_ << "</g>\n";
  }

  void drawPath() {
    const std::vector<Vector2d> line = pathLine(view_);
    if (line.empty()) return;
    out_ << "<path id=\"root-path\" d=\"" << svgPath(frame_, line, false)
         << "\" fill=\"none\" stroke=\"" << hexColor(kPathColor)
         << "\" stroke-width=\"2\" stroke-linejoin=\"round\"/>\n";
  }

  // A disc with a letter, and an arrow where the heading is given.
  void drawPlace(const PlaceView& place, const char* id, const std::string& letter,
                 const std::string& color) {
    const Vector2d p = frame_(place.position);
    out_ << "<g class=\"" << id << "\">\n";
    if (place.heading) {
      const Vector2d along(std::cos(*place.heading), -std::sin(*place.heading)),
          across(-along.y(), along.x());
      const Vector2d tip = p + 31 * along, left = p + 20 * along + 6.5 * across,
                     right = p + 20 * along - 6.5 * across;
      out_ << "<path d=\"M" << svgNumber(p.x()) << ' ' << svgNumber(p.y()) << 'L'
           << svgNumber((p + 22 * along).x()) << ' ' << svgNumber((p + 22 * along).y())
           << "\" stroke=\"" << color << "\" stroke-width=\"4\"/>\n<path d=\"M"
           << svgNumber(tip.x()) << ' ' << svgNumber(tip.y()) << 'L' << svgNumber(left.x()) << ' '
           << svgNumber(left.y()) << 'L' << svgNumber(right.x()) << ' ' << svgNumber(right.y())
           << "Z\" fill=\"" << color << "\"/>\n";
    }
    out_ << "<circle cx=\"" << svgNumber(p.x()) << "\" cy=\"" << svgNumber(p.y())
         << "\" r=\"11\" fill=\"" << color
         << "\" stroke=\"#ffffff\" stroke-width=\"1.5\"/>\n<text x=\"" << svgNumber(p.x())
         << "\" y=\"" << svgNumber(p.y() + 4.5)
         << "\" font-size=\"13\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"#ffffff\">"
         << letter << "</text>\n</g>\n";
  }

  void drawPlaces() {
    for (size_t i = 0; i < view_.via.size(); ++i)
      drawPlace(view_.via[i], "via", std::to_string(i + 1), "#6d5bb0");
    if (view_.start) drawPlace(*view_.start, "start", "S", hexColor(kStartColor));
    if (view_.goal) drawPlace(*view_.goal, "goal", "G", hexColor(kGoalColor));
  }

  // Names of things that are large enough to write them on; walls need none.
  void drawNames(const std::vector<Thing>& things) {
    constexpr double kLetter = 6.2;  // mean width of a letter of size 12 [units]
    out_ << "<g id=\"names\" font-size=\"12\" text-anchor=\"middle\" fill=\"#30353d\" "
            "stroke=\"#ffffff\" "
            "stroke-width=\"2.5\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n";
    for (const Thing& thing : things) {
      if (thing.body.empty() || coveredArea(thing.body) < 0.04) continue;
      const Vector2d size = thing.box.sizes() * frame_.scale;
      const double text = kLetter * static_cast<double>(thing.name.size());
      if (std::min(size.x(), size.y()) < 16 || size.x() + 24 < text) continue;
      const Vector2d p = frame_(thing.box.center());
      if (size.maxCoeff() > 0.7 * std::min(width_, height_)) continue;  // a whole flat in one file
      out_ << "<text x=\"" << svgNumber(p.x()) << "\" y=\"" << svgNumber(p.y() + 4) << "\">"
           << svgEscape(thing.name) << "</text>\n";
    }
    out_ << "</g>\n";
  }

  void drawScaleBar() {
    const double metre = frame_.scale, y = height_ + 24;
    const int metres = metre > 60 ? 1 : metre > 12 ? 5 : 10;
    out_ << "<g id=\"scale-bar\" font-size=\"12\" fill=\"#2b2f36\">\n";
    for (int i = 0; i < 4; ++i)
      out_ << "<rect x=\"" << svgNumber(i * metre * metres / 4) << "\" y=\"" << svgNumber(y)
           << "\" width=\"" << svgNumber(metre * metres / 4) << "\" height=\"6\" fill=\""
           << (i % 2 ? "#ffffff" : "#2b2f36") << "\" stroke=\"#2b2f36\" stroke-width=\"1\"/>\n";
    out_ << "<text x=\"0\" y=\"" << svgNumber(y + 22)
         << "\" text-anchor=\"start\">0</text>\n<text x=\"" << svgNumber(metre * metres)
         << "\" y=\"" << svgNumber(y + 22) << "\" text-anchor=\"middle\">" << metres
         << " m</text>\n</g>\n";
  }

  void legendText(double x, double y, const char* text) {
    out_ << "<text x=\"" << svgNumber(x) << "\" y=\"" << svgNumber(y) << "\">" << text
         << "</text>\n";
  }

  void legendSwatch(double x, double y, const char* fill, const char* stroke, const char* text) {
    out_ << "<rect x=\"" << svgNumber(x) << "\" y=\"" << svgNumber(y - 10)
         << "\" width=\"18\" height=\"12\" fill=\"" << fill << "\" stroke=\"" << stroke
         << "\" stroke-width=\"0.8\"/>\n";
    legendText(x + 26, y, text);
  }

  void legendShoe(double x, double y, Side side, const char* text) {
    Footprint print;
    print.side = side;
    const SvgFrame at{Vector2d(-x / 70, y / 70), 70};
    out_ << "<path d=\"" << svgPath(at, placedShoe(print, 0.27), true) << "\" fill=\""
         << hexColor(sideColor(side)) << "\"/>\n";
    legendText(x + 16, y + 4, text);
  }

  void drawLegend() {
    const double left = std::max(frame_.scale * 1.2, 130.0), row1 = height_ + 32, row2 = row1 + 26;
    const double column = (width_ - left) / 4;
    out_ << "<g id=\"legend\" font-size=\"12\" fill=\"#2b2f36\">\n";
    legendSwatch(left, row1, "#d3d8df", "#8b94a1", "between 0.05 and 1.8 m");
    legendSwatch(left, row2, "#9aa4b2", "#6f7987", "between 0.5 and 1.2 m");
    legendShoe(left + column + 22, row1 - 4, kLeft, "left foot");
    legendShoe(left + column + 22, row2 - 4, kRight, "right foot");
    const double third = left + 2 * column;
    out_ << "<path d=\"M" << svgNumber(third) << ' ' << svgNumber(row1 - 4) << "h22\" stroke=\""
         << hexColor(kPathColor) << "\" stroke-width=\"2\"/>\n<path d=\"M" << svgNumber(third)
         << ' ' << svgNumber(row2 - 4) << "h22\" stroke=\"#3d8f6b\" stroke-opacity=\"0.5\"/>\n";
    legendText(third + 30, row1, "root path");
    legendText(third + 30, row2, "roadmap edge");
    drawNode({third + column + 8, row1 - 4}, false);
    drawNode({third + column + 8, row2 - 4}, true);
    legendText(third + column + 24, row1, "guard");
    legendText(third + column + 24, row2, "connector");
    out_ << "</g>\n";
  }

  std::ostream& out_;
  const WalkView& view_;
  AlignedBox2d shown_;
  SvgFrame frame_;
  double width_ = 0, height_ = 0;  // of the room [units]
};

}  // namespace

void writePlanView(std::ostream& out, const WalkView& view) { Drawing(out, view).draw(); }

void writePlanView(const std::filesystem::path& file, const WalkView& view) {
  writeFile(file, [&](std::ostream& out) { writePlanView(out, view); });
}

}  // namespace amble
