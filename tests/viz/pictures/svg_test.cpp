#include "viz/pictures/svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <regex>
#include <sstream>

#include "base/text.h"
#include "tests/animation/puppet.h"
#include "tests/viz/test_walk.h"
#include "viz/pictures/gait_plot.h"
#include "viz/pictures/plan_view.h"

namespace amble {
namespace {

std::string svgOf(const WalkView& view) {
  std::ostringstream out;
  writePlanView(out, view);
  return out.str();
}

std::string plotOf(const std::string& title) {
  std::ostringstream out;
  writeGaitPlot(out, analyseClip(Puppet().clip(), Puppet::roles()), title);
  return out.str();
}

/// Points that an element names, in its own units.
std::vector<Eigen::Vector2d> pointsOf(const pugi::xml_node& node) {
  std::vector<Eigen::Vector2d> points;
  const auto number = [&](const char* name) { return node.attribute(name).as_double(); };
  const std::string name = node.name(), path = node.attribute("d").value();
  if (name == "line") points = {{number("x1"), number("y1")}, {number("x2"), number("y2")}};
  if (name == "text" || name == "rect") points.push_back({number("x"), number("y")});
  if (name == "rect")
    points.push_back({number("x") + number("width"), number("y") + number("height")});
  if (name == "circle") points.push_back({number("cx"), number("cy")});
  static const std::regex pair("(-?[0-9.]+) (-?[0-9.]+)");
  for (std::sregex_iterator it(path.begin(), path.end(), pair), end; it != end; ++it)
    points.push_back({*numberOf((*it)[1].str()), *numberOf((*it)[2].str())});
  return points;
}

/// Every number that is drawn and not clipped lies in the view box. @return how many points did
int expectInBox(const pugi::xml_node& node, const Eigen::Vector2d& size, Eigen::Vector2d shift) {
  if (node.attribute("clip-path")) return 0;
  const std::string transform = node.attribute("transform").value();
  static const std::regex translate("translate\\(([0-9.]+) ([0-9.]+)\\)");
  std::smatch match;
  if (std::regex_match(transform, match, translate))
    shift += Eigen::Vector2d(*numberOf(match[1].str()), *numberOf(match[2].str()));
  int count = 0;
  for (const Eigen::Vector2d& p : pointsOf(node)) {
    const Eigen::Vector2d at = p + shift;
    EXPECT_TRUE((at.array() >= -1e-3).all() && (at.array() <= size.array() + 1e-3).all())
        << node.name() << " " << at.transpose();
    ++count;
  }
  for (const pugi::xml_node& child : node.children()) count += expectInBox(child, size, shift);
  return count;
}

int expectDrawing(const std::string& text) {
  pugi::xml_document read;
  EXPECT_TRUE(read.load_string(text.c_str()));
  const pugi::xml_node svg = read.child("svg");
  std::istringstream box(svg.attribute("viewBox").value());
  Eigen::Vector2d low, size;
  box >> low.x() >> low.y() >> size.x() >> size.y();
  EXPECT_TRUE(box);
  EXPECT_EQ(low, Eigen::Vector2d(0, 0));
  EXPECT_EQ(text, utf8Text(text));
  return expectInBox(svg, size, Eigen::Vector2d::Zero());
}

TEST(Svg, ACurveGoesThroughItsPointsAndAlongThem) {
  std::vector<Eigen::Vector2d> circle;
  for (int i = 0; i <= 12; ++i)
    circle.emplace_back(100 * std::cos(0.2 * i), 100 * std::sin(0.2 * i));
  const std::string path = svgCurve(circle);
  static const std::regex cubic(
      "C(-?[0-9.]+) (-?[0-9.]+) (-?[0-9.]+) (-?[0-9.]+) (-?[0-9.]+) (-?[0-9.]+)");
  Eigen::Vector2d from = circle[0];
  size_t i = 0;
  for (std::sregex_iterator it(path.begin(), path.end(), cubic), end; it != end; ++it) {
    const auto point = [&](int k) {
      return Eigen::Vector2d(*numberOf((*it)[k].str()), *numberOf((*it)[k + 1].str()));
    };
    const Eigen::Vector2d middle = (from + 3 * point(1) + 3 * point(3) + point(5)) / 8;
    EXPECT_LT((point(5) - circle[++i]).norm(), 2e-3);
    if (i > 1 && i < 12) {
      EXPECT_NEAR(middle.norm(), 100, 0.01);  // a chord's middle lies at 99.5
    }
    from = point(5);
  }
  EXPECT_EQ(i, 12u);
}

TEST(Svg, ACurveOfPointsOnALineIsThatLine) {
  const std::vector<Eigen::Vector2d> line = {{0, 0}, {1, 2}, {2, 4}, {30, 60}};
  EXPECT_EQ(svgCurve(line), svgPath(std::vector<Eigen::Vector2d>{{0, 0}, {30, 60}}, false));
  EXPECT_EQ(svgCurve({}), "");
}

TEST(Svg, YGoesDown) {
  const SvgFrame frame{{1, 5}, 100};
  EXPECT_EQ(svgPath(frame, std::vector<Eigen::Vector2d>{{1, 5}, {2, 4}}, true), "M0 0L100 100Z");
}

TEST(Svg, DrawingsLieInTheirViewBox) {
  EXPECT_GT(expectDrawing(svgOf(makeTestWalk()->view)), 50);
  EXPECT_GT(expectDrawing(plotOf("walk")), 500);
}

TEST(Svg, NamesOfAnyBytesAreReadBack) {
  const std::string name =
      "K\xFC"
      "che \x01<&\">'\xED\xA0\x80\xF0\x9F\xAA\x91";
  const auto walk = makeTestWalk();
  walk->view.title = name;
  walk->scene.objects.back().name = name;
  for (const std::string& text : {svgOf(walk->view), plotOf(name)}) {
    expectDrawing(text);
    pugi::xml_document read;
    ASSERT_TRUE(read.load_string(text.c_str()));
    EXPECT_EQ(read.child("svg").child("title").text().get(), utf8Text(name));
  }
}

TEST(Svg, RoadmapEdgesAreDrawnAlongTheirWalks) {
  const auto walk = makeTestWalk();
  walk->view.roadmap.nodes = {{{1, 1}, 0, false}, {{5, 1}, 0, true}};
  std::vector<Eigen::Vector2d> curve;
  for (int i = 0; i <= 20; ++i) curve.push_back({1 + 0.2 * i, 1 + std::sin(0.157 * i)});
  walk->view.roadmap.edges = {{0, 1, curve}, {1, 0, {}}};
  pugi::xml_document read;
  ASSERT_TRUE(read.load_string(svgOf(walk->view).c_str()));
  const auto edges = read.select_nodes("//path[@class='edge']");
  ASSERT_EQ(edges.size(), 2u);
  const std::vector<Eigen::Vector2d> there = pointsOf(edges[0].node()),
                                     back = pointsOf(edges[1].node());
  ASSERT_EQ(there.size(), 3 * curve.size() - 2);  // two handles between each two
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(there.front(), back.back());
  const double scale = (back[0] - back[1]).norm() / 4;  // of the straight walk's 4 m
  for (size_t i = 0; i < curve.size(); ++i)
    EXPECT_NEAR(there[3 * i].y() - there[0].y(), -scale * (curve[i].y() - 1), 0.01);
}

TEST(Svg, AFramesPicturesAreMapsOfTheWorld) {
  const SvgFrame frame{{-3, 7}, 40};
  const Eigen::Vector2d a(1, 2), b(4, -2);
  // Lengths by the scale, left turns become right turns, and the way back is exact.
  EXPECT_DOUBLE_EQ((frame(a) - frame(b)).norm(), 40 * (a - b).norm());
  const Eigen::Vector2d back(frame(a).x() / 40 - 3, 7 - frame(a).y() / 40);
  EXPECT_LT((back - a).norm(), 1e-12);
  EXPECT_GT(frame(a + Eigen::Vector2d(1, 0)).x(), frame(a).x());
  EXPECT_LT(frame(a + Eigen::Vector2d(0, 1)).y(), frame(a).y());
}

TEST(Svg, PathsHaveEveryPointOnceAndCloseWhereAsked) {
  EXPECT_EQ(svgPath(std::vector<Eigen::Vector2d>{}, false), "");
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 9; ++i) points.push_back({i * 1.5, -i * 0.25});
  for (const bool closed : {false, true}) {
    const std::string path = svgPath(points, closed);
    EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 1);
    EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 8);
    EXPECT_EQ(path.back() == 'Z', closed);
  }
}

TEST(Svg, AttributesFollowOneAnother) {
  const XmlAttributes both = XmlAttributes{{"a", 1}, {"b", "x"}} + XmlAttributes{{"c", 2.5}};
  ASSERT_EQ(both.size(), 3u);
  EXPECT_EQ(both[0].name + both[1].name + both[2].name, "abc");
  EXPECT_EQ(both[2].value, "2.5");
}

}  // namespace
}  // namespace amble
