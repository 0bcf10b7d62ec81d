#include "viz/pictures/plan_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <pugixml.hpp>
#include <regex>
#include <sstream>

#include "base/error.h"
#include "tests/viz/test_walk.h"
#include "viz/pictures/color.h"

namespace amble {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::string planOf(const WalkView& view) {
  std::ostringstream out;
  writePlanView(out, view);
  return out.str();
}

int countOf(const std::string& text, const std::string& word) {
  int count = 0;
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

// Empty where a parser reads it; else what is wrong.
std::string malformed(const std::string& svg) {
  pugi::xml_document read;
  const pugi::xml_parse_result result = read.load_string(svg.c_str());
  return result ? "" : result.description();
}

TEST(PlanView, IsNotWrittenIntoAFolderThatIsNotThere) {
  const auto walk = makeTestWalk();
  EXPECT_THROW(writePlanView(std::filesystem::path("no-such-folder/top.svg"), walk->view),
               InputError);
}

TEST(PlanView, IsWellFormedWhateverTheNames) {
  const auto walk = makeTestWalk();
  walk->scene.objects.back().name = "a \"chest\" <of> drawers & more\x01";
  EXPECT_EQ(malformed(planOf(walk->view)), "");
  EXPECT_EQ(planOf(walk->view).find('\x01'), std::string::npos);
}

TEST(PlanView, HasEveryFootprintByFoot) {
  const std::string svg = planOf(makeTestWalk()->view);
  EXPECT_EQ(countOf(svg, "class=\"left\""), 4);
  EXPECT_EQ(countOf(svg, "class=\"right\""), 4);
  EXPECT_EQ(countOf(svg, "id=\"root-path\""), 1);
}

TEST(PlanView, TellsGuardsFromConnectors) {
  const auto walk = makeTestWalk();
  auto& map = walk->view.roadmap;
  map.nodes = {{{1, 1}, 0, false}, {{3, 3}, 1, true}, {{5, 1}, 2, false}};
  map.edges = {{0, 1, {}}, {1, 2, {{3, 3}, {4, 2.5}, {5, 1}}}};
  const std::string svg = planOf(walk->view);
  EXPECT_EQ(malformed(svg), "");
  EXPECT_EQ(countOf(svg, "class=\"guard\""), 2 + 1);  // one in the legend
  EXPECT_EQ(countOf(svg, "class=\"connector\""), 1 + 1);
  EXPECT_EQ(countOf(svg, "class=\"edge\""), 2);
}

// The arrow's head of an edge lies on its line, the tip first.
TEST(PlanView, EveryEdgeTellsItsDirection) {
  const auto walk = makeTestWalk();
  auto& map = walk->view.roadmap;
  map.nodes = {{{1, 1}, 0, false}, {{5, 1}, 0, false}, {{5, 1}, 2, false}};
  map.edges = {{0, 1, {}}, {1, 0, {{5, 1}, {4, 1}, {3, 1}, {2, 1}, {1, 1}}}, {1, 2, {}}};
  pugi::xml_document svg;
  svg.load_string(planOf(walk->view).c_str());
  std::vector<double> tips;
  for (const auto& found : svg.select_nodes("//path[@class='direction']")) {
    double x[3], y[3];
    const std::string head = found.node().attribute("d").value();
    ASSERT_EQ(
        std::sscanf(head.c_str(), "M%lf %lfL%lf %lfL%lf %lfZ", x, y, x + 1, y + 1, x + 2, y + 2),
        6);
    EXPECT_NEAR(x[1], x[2], 1e-6);  // the edge runs along x
    EXPECT_NEAR(y[1] + y[2], 2 * y[0], 1e-2);
    tips.push_back(x[0] - x[1]);
  }
  ASSERT_EQ(tips.size(), 2u);  // who turns on the spot goes nowhere
  EXPECT_GT(tips[0], 5);
  EXPECT_LT(tips[1], -5);
}

// Of a metre to the east one that failed half-way.
TEST(PlanView, RefusedAttemptsAreDrawnWithWhereAndWhy) {
  const auto walk = makeTestWalk();
  EXPECT_EQ(countOf(planOf(walk->view), ">refused<"), 0);
  walk->view.roadmap.refused = {{{1, 1}, {2, 1}, {1.5, 1}, "contact: hand & <vase>"}};
  const std::string drawn = planOf(walk->view);
  EXPECT_EQ(malformed(drawn), "");
  pugi::xml_document svg;
  svg.load_string(drawn.c_str());
  const pugi::xml_node one = svg.select_node("//g[@class='refused']").node();
  EXPECT_STREQ(one.child_value("title"), "contact: hand & <vase>");
  double x[2], y[2];
  ASSERT_EQ(
      std::sscanf(one.child("path").attribute("d").value(), "M%lf %lfL%lf %lf", x, y, x + 1, y + 1),
      4);
  EXPECT_GT(x[1], x[0]);
  EXPECT_NEAR(one.child("circle").attribute("cx").as_double(), 0.5 * (x[0] + x[1]), 0.02);
  EXPECT_NEAR(one.child("circle").attribute("cy").as_double(), y[0], 0.02);
  EXPECT_EQ(countOf(drawn, ">refused<"), 1);  // in the legend
}

TEST(PlanView, IsAsWideAsItsWindowAndKeepsItsShape) {
  pugi::xml_document svg;
  svg.load_string(planOf(makeTestWalk()->view).c_str());
  EXPECT_STREQ(svg.document_element().attribute("width").value(), "100%");
  EXPECT_TRUE(svg.document_element().attribute("viewBox"));
  EXPECT_FALSE(svg.document_element().attribute("height"));
}

TEST(PlanView, NoTwoNamesAreWrittenOverOneAnother) {
  const auto walk = makeTestWalk();
  for (int i = 1; i <= 12; ++i)
    walk->scene.objects.push_back(
        testBox("tread-" + std::to_string(i), {0.3, 1.0, 0.17 * i}, {0.3 * i, 3, 0.085 * i}));
  pugi::xml_document svg;
  svg.load_string(planOf(walk->view).c_str());
  std::vector<double> places;
  for (const auto& found : svg.select_nodes("//g[@id='names']/text"))
    if (std::string_view(found.node().text().get()).find("tread") == 0)
      places.push_back(found.node().attribute("x").as_double());
  ASSERT_GE(places.size(), 2u);
  for (size_t i = 1; i < places.size(); ++i) EXPECT_GT(std::abs(places[i] - places[i - 1]), 40);
}

TEST(PlanView, ShowsTheRoomWhereThereIsNoWalk) {
  const Scene room = testRoom();
  WalkView view;
  view.scene = &room;
  const std::string svg = planOf(view);
  EXPECT_EQ(malformed(svg), "");
  EXPECT_EQ(countOf(svg, "id=\"root-path\""), 0);
  EXPECT_GE(countOf(svg, "<title>chest</title>"), 1);
}

TEST(PlanView, MarksWhatIsAtTheHeightOfHips) {
  auto scene = testRoom();
  scene.objects.push_back(testBox("stool", {0.4, 0.4, 0.45}, {2, 1, 0.225}));
  WalkView view;
  view.scene = &scene;
  const std::string svg = planOf(view);
  EXPECT_EQ(countOf(svg, "<title>stool</title>"), 1);  // lower than hips
  EXPECT_EQ(countOf(svg, "<title>chest</title>"), 2);  // reaches them
}

TEST(PlanView, GivesTheSameBytesTwice) {
  EXPECT_EQ(planOf(makeTestWalk()->view), planOf(makeTestWalk()->view));
}

/// A plan that is read back: places in it as places in World.
class ReadPlan {
 public:
  explicit ReadPlan(const std::string& svg) {
    EXPECT_TRUE(read_.load_string(svg.c_str()));
    const auto centre = [&](const char* place) {
      const pugi::xml_node circle =
          read_.select_node((std::string("//g[@class='") + place + "']/circle").c_str()).node();
      return Eigen::Vector2d(circle.attribute("cx").as_double(),
                             circle.attribute("cy").as_double());
    };
    start_ = centre("start");
    scale_ = (centre("goal") - start_).norm() / 4.0;  // which are 4 m apart in the test's walk
  }
  double scale() const { return scale_; }
  const pugi::xml_document& xml() const { return read_; }
  /// The points of a path, in World: y goes down in the drawing.
  std::vector<Eigen::Vector2d> points(const pugi::xml_node& path) const {
    std::vector<Eigen::Vector2d> points;
    const std::string text = path.attribute("d").value();
    static const std::regex pair("(-?[0-9.]+) (-?[0-9.]+)");
    for (std::sregex_iterator it(text.begin(), text.end(), pair), end; it != end; ++it) {
      const Eigen::Vector2d p(std::stod((*it)[1].str()), std::stod((*it)[2].str()));
      const Eigen::Vector2d off = (p - start_) / scale_;
      points.emplace_back(1.0 + off.x(), 2.0 - off.y());  // the start is at (1, 2)
    }
    return points;
  }
  std::vector<pugi::xml_node> nodes(const char* query) const {
    std::vector<pugi::xml_node> nodes;
    for (const auto& found : read_.select_nodes(query)) nodes.push_back(found.node());
    return nodes;
  }

 private:
  pugi::xml_document read_;
  Eigen::Vector2d start_ = Eigen::Vector2d::Zero();
  double scale_ = 1.0;
};

constexpr double kDrawn =
    2e-5;  // a plan's numbers have three decimals, of a hundredth of a metre [m]

TEST(PlanView, FootprintsLieWhereTheWalkHasThem) {
  const auto walk = makeTestWalk();
  for (size_t i = 0; i < walk->animation.footprints.size(); ++i)
    walk->animation.footprints[i].heading = 0.2 * static_cast<double>(i) - 0.7;
  const ReadPlan plan(planOf(walk->view));
  const auto prints = plan.nodes("//g[@id='footprints']/path");
  ASSERT_EQ(prints.size(), walk->animation.footprints.size());
  for (size_t i = 0; i < prints.size(); ++i) {
    const Footprint& print = walk->animation.footprints[i];
    EXPECT_STREQ(prints[i].attribute("class").value(), print.side == kLeft ? "left" : "right");
    EXPECT_EQ(prints[i].attribute("fill").value(), hexColor(sideColor(print.side)));
    const auto shoe = placedShoe(print, soleLength(walk->view));
    const auto drawn = plan.points(prints[i]);
    ASSERT_EQ(drawn.size(), shoe.size());
    for (size_t k = 0; k < shoe.size(); ++k) EXPECT_LT((drawn[k] - shoe[k]).norm(), kDrawn);
  }
}

TEST(PlanView, TheRootPathIsDrawnAlongItself) {
  const auto walk = makeTestWalk();
  walk->path = RootPath({makeBezier({1, 2}, 0.8, {5, 2}, -0.4)});
  const ReadPlan plan(planOf(walk->view));
  const auto drawn = plan.points(plan.nodes("//path[@id='root-path']").at(0));
  const auto line = pathLine(walk->view);
  ASSERT_EQ(drawn.size(), line.size());
  for (size_t i = 0; i < line.size(); ++i) EXPECT_LT((drawn[i] - line[i]).norm(), kDrawn);
}

TEST(PlanView, ThingsAreDrawnByTheirCorners) {
  const auto walk = makeTestWalk();
  walk->scene.objects.back().X_WO.linear() =
      Eigen::AngleAxisd(0.4, Vector3d::UnitZ()).toRotationMatrix();
  const ReadPlan plan(planOf(walk->view));
  for (const auto& path : plan.nodes("//g[@id='things']/path")) {
    if (std::string(path.child("title").text().get()) != "chest") continue;
    const auto drawn = plan.points(path);
    EXPECT_EQ(drawn.size(), 4u);
    for (const Vector2d& corner : drawn) {
      double nearest = 1.0;
      for (const auto& v : worldMesh(walk->scene.objects.back()).vertices)
        nearest = std::min(nearest, (v.head<2>() - corner).norm());
      EXPECT_LT(nearest, kDrawn);
    }
  }
}

TEST(PlanView, TheScaleBarIsAsLongAsItSays) {
  for (const double stretch : {1.0, 4.0, 25.0}) {
    const auto walk = makeTestWalk();
    // A larger hall about the same walk, cut off 3 m beyond it; then a longer walk.
    walk->scene.objects.front() = testBox("floor", {6 * stretch, 4 * stretch, 0.1}, {3, 2, -0.05});
    if (stretch > 10.0) walk->view.via = {{{40, 2}, {}}, {{-30, 2}, {}}};
    const ReadPlan plan(planOf(walk->view));
    double length = 0.0;
    for (const auto& rect : plan.nodes("//g[@id='scale-bar']/rect"))
      length += rect.attribute("width").as_double();
    const std::string label = plan.nodes("//g[@id='scale-bar']/text").back().text().get();
    EXPECT_NEAR(length / plan.scale(), std::stod(label), 1e-3) << label;
    EXPECT_TRUE(label.ends_with(" m"));
    EXPECT_GT(length, 30.0);
  }
}

TEST(PlanView, ArrowsPointAlongTheHeadings) {
  const auto walk = makeTestWalk();
  for (const double heading : {0.0, 1.0, -2.5}) {
    walk->view.start->heading = heading;
    const ReadPlan plan(planOf(walk->view));
    const auto shaft = plan.points(plan.nodes("//g[@class='start']/path").at(0));
    const Vector2d way = shaft.at(1) - shaft.at(0);
    EXPECT_NEAR(std::atan2(way.y(), way.x()), heading, 1e-3);
    EXPECT_TRUE(plan.nodes("//g[@class='goal']/path").empty());  // any heading will do there
  }
}

TEST(PlanView, ViaPointsAreNumberedInTheirOrder) {
  const auto walk = makeTestWalk();
  walk->view.via = {{{2, 3}, 0.5}, {{4, 1}, {}}, {{3, 2}, {}}};
  const ReadPlan plan(planOf(walk->view));
  const auto texts = plan.nodes("//g[@class='via']/text");
  ASSERT_EQ(texts.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(texts[i].text().get(), std::to_string(i + 1));
}

// Where the room is in the world does not matter: the drawing is of it, not of its coordinates.
TEST(PlanView, AWorldThatIsMovedGivesTheSameDrawing) {
  const auto here = makeTestWalk(), there = makeTestWalk();
  const Vector2d by(64, -32);
  for (SceneObject& object : there->scene.objects) object.X_WO.translation().head<2>() += by;
  for (Footprint& print : there->animation.footprints) print.position.head<2>() += by;
  for (int i = 0; i < there->animation.size(); ++i) there->animation.poses.p_WR(i).head<2>() += by;
  there->path = RootPath({makeBezier({65, -30}, 0, {69, -30}, 0)});
  there->view.start->position += by;
  there->view.goal->position += by;
  const std::string a = planOf(here->view), b = planOf(there->view);
  static const std::regex number("-?[0-9]+(\\.[0-9]+)?");
  std::sregex_iterator i(a.begin(), a.end(), number), k(b.begin(), b.end(), number), end;
  for (; i != end && k != end; ++i, ++k)
    EXPECT_NEAR(std::stod(i->str()), std::stod(k->str()), 0.0011);
  EXPECT_TRUE(i == end && k == end);
}

TEST(PlanView, RoomsFillThePageAndLargeScenesAreShownAroundTheWalk) {
  const auto walk = makeTestWalk();
  const auto sizeOf = [&]() -> Vector2d {
    const ReadPlan plan(planOf(walk->view));
    const pugi::xml_node rect = plan.nodes("//clipPath/rect").at(0);
    return Vector2d(rect.attribute("width").as_double(), rect.attribute("height").as_double()) /
           plan.scale();
  };
  EXPECT_LT((sizeOf() - Vector2d(6.2 + 0.6, 4.2 + 0.6)).norm(), 0.01);
  walk->scene.objects.front() = testBox("floor", {300, 200, 0.1}, {3, 2, -0.05});
  EXPECT_LT((sizeOf() - Vector2d(4 + 6 + 0.6, 6 + 0.6)).norm(), 0.01);  // 3.3 m about the walk
}

double areaOfPath(const std::string& path) {
  double area = 0.0;
  static const std::regex ring("M([^Z]*)Z");
  static const std::regex pair("(-?[0-9.]+) (-?[0-9.]+)");
  for (std::sregex_iterator it(path.begin(), path.end(), ring), end; it != end; ++it) {
    const std::string points = (*it)[1].str();
    std::vector<Vector2d> at;
    for (std::sregex_iterator p(points.begin(), points.end(), pair), last; p != last; ++p)
      at.emplace_back(std::stod((*p)[1].str()), std::stod((*p)[2].str()));
    for (size_t i = 0; i < at.size(); ++i) {
      const Vector2d &a = at[i], &b = at[(i + 1) % at.size()];
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
  }
  return std::abs(area);
}

// A room of 6 x 4 m of which 2 x 3 m are reached, in strips of 0.1 m.
TEST(PlanView, WithoutAWalkShowsHowFarOneGetsAndWhatStoodInTheWay) {
  const auto walk = makeTestWalk();
  WalkView& view = walk->view;
  view.animation = nullptr;
  view.path = nullptr;
  view.why = "contact: pelvis and <chest>, 0.52 m wide, needed 0.66 m";
  ReachedRegion reached;
  reached.breadth = 0.1;
  for (int i = 0; i < 30; ++i)
    reached.strips.push_back({{0.5 + 0.05, 0.55 + 0.1 * i, 0}, {2.5 - 0.05, 0.55 + 0.1 * i, 0}});
  reached.near = {2.5, 2, 0};
  reached.far = {3.5, 2, 0};
  Obstruction why;
  why.part = "pelvis";
  why.object = "<chest>";
  why.at = {2.8, 2.1, 0.9};
  why.width = 0.52;
  why.needed = 0.66;
  view.reached = &reached;
  view.obstruction = &why;
  pugi::xml_document svg;
  ASSERT_TRUE(svg.load_string(planOf(view).c_str()));
  const double scale = 1100 / 6.8;  // units a metre: the room, its walls and 0.3 m around them
  EXPECT_NEAR(areaOfPath(svg.select_node("//path[@id='reached']").node().attribute("d").value()),
              6.0 * scale * scale, 0.05 * scale * scale);
  EXPECT_TRUE(svg.select_node("//path[@id='missing']"));
  EXPECT_TRUE(svg.select_node("//path[@id='stop']"));
  std::string words;
  for (const auto& found : svg.select_nodes("//text[@class='stop']"))
    words += std::string(found.node().text().get()) + ";";
  EXPECT_EQ(words, "pelvis and <chest>;0.52 m of 0.66 m;");
  EXPECT_EQ(view.why, svg.select_node("//text[@class='why']").node().text().get());
}

TEST(PlanView, OfManyThingsEachIsDrawn) {
  const auto walk = makeTestWalk();
  for (int i = 0; i < 400; ++i)
    walk->scene.objects.push_back(testBox("b-" + std::to_string(i), {0.02, 0.02, 0.5},
                                          {0.2 + 0.28 * (i % 20), 0.2 + 0.18 * (i / 20), 0.25}));
  pugi::xml_document svg;
  ASSERT_TRUE(svg.load_string(planOf(walk->view).c_str()));
  EXPECT_EQ(svg.select_nodes("//g[@id='things']/path/title[starts-with(., 'b-')]").size(), 400u);
}

}  // namespace
}  // namespace amble
