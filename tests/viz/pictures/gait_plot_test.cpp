#include "viz/pictures/gait_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <pugixml.hpp>
#include <sstream>

#include "tests/animation/puppet.h"
#include "viz/pictures/color.h"

namespace amble {
namespace {

std::string plot(const ClipAnalysis& analysis, const std::string& title = "walk",
                 int first_frame = 0) {
  std::ostringstream out;
  writeGaitPlot(out, analysis, title, first_frame);
  return out.str();
}

ClipAnalysis walk() { return analyseClip(Puppet().clip(), Puppet::roles()); }

size_t count(const std::string& text, const std::string& what) {
  size_t found = 0;
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

bool wellFormed(const std::string& svg) { return pugi::xml_document().load_string(svg.c_str()); }

TEST(GaitPlot, OfAClipWithoutFramesIsAPictureWithItsTitle) {
  const std::string svg = plot({}, "nothing");
  EXPECT_TRUE(wellFormed(svg));
  EXPECT_NE(svg.find("nothing"), std::string::npos);
}

TEST(GaitPlot, NamesCannotBreakIt) {
  const std::string svg = plot(walk(), "<b>&\"walk\"");
  EXPECT_TRUE(wellFormed(svg));
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
}

TEST(GaitPlot, MarksEveryEventThatTheClipShows) {
  const ClipAnalysis analysis = walk();
  size_t events = 0;
  for (const Side side : {kLeft, kRight}) {
    for (const SwingEvents& swing : analysis.events.swings[side]) {
      for (const double at : {swing.lift, swing.lift_off, swing.strike, swing.landing}) {
        events += std::isnan(at) ? 0 : 1;
      }
    }
  }
  const size_t legend = 4;
  EXPECT_EQ(count(plot(analysis), "class=\"mark\""), events + legend);
}

TEST(GaitPlot, ShowsTheTypeOfTheMotionAndBothFeet) {
  const std::string svg = plot(walk());
  for (const char* text : {">walk<", ">left foot<", ">right foot<", ">planted<", "walk 100 %"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(GaitPlot, CountsFramesOfTheFile) {
  EXPECT_NE(plot(walk(), "walk", 25).find(">50<"), std::string::npos);
  EXPECT_EQ(plot(walk(), "walk", 25).find(">0 s<"), std::string::npos);
  EXPECT_NE(plot(walk()).find(">0 s<"), std::string::npos);
}

TEST(GaitPlot, TheSameAnalysisGivesTheSameBytes) { EXPECT_EQ(plot(walk()), plot(walk())); }

/// Where a plot has its seconds: by the labels of its axis.
struct PlotAxis {
  explicit PlotAxis(const pugi::xml_document& plot) {
    std::vector<std::pair<double, double>> labels;  // [s], [units]
    for (const auto& found : plot.select_nodes("//text")) {
      const std::string text = found.node().text().get();
      double seconds = 0.0;
      int end = 0;
      if (std::sscanf(text.c_str(), "%lf s%n", &seconds, &end) == 1 &&
          end == static_cast<int>(text.size()))
        labels.emplace_back(seconds, found.node().attribute("x").as_double());
    }
    EXPECT_GE(labels.size(), 2u);
    second = (labels.back().second - labels.front().second) /
             (labels.back().first - labels.front().first);
    zero = labels.front().second - second * labels.front().first;
  }
  double at(double x) const { return (x - zero) / second; }
  double second = 1.0, zero = 0.0;  // [units]
};

TEST(GaitPlot, EventsAreMarkedAtTheirTimes) {
  const ClipAnalysis analysis = walk();
  pugi::xml_document plot_read;
  ASSERT_TRUE(plot_read.load_string(plot(analysis).c_str()));
  const PlotAxis axis(plot_read);
  std::vector<double> drawn, expected;
  for (const auto& found : plot_read.select_nodes("//path[@class='mark']")) {
    double x = 0.0, y = 0.0;
    ASSERT_EQ(std::sscanf(found.node().attribute("d").value(), "M%lf %lf", &x, &y), 2);
    if (y > 60.0) drawn.push_back(axis.at(x));  // the legend is above
  }
  for (const Side side : {kLeft, kRight})
    for (const SwingEvents& swing : analysis.events.swings[side])
      for (const double frame : {swing.lift, swing.lift_off, swing.strike, swing.landing})
        if (!std::isnan(frame)) expected.push_back(frame * analysis.frame_time);
  std::sort(drawn.begin(), drawn.end());
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(drawn.size(), expected.size());
  for (size_t i = 0; i < drawn.size(); ++i) EXPECT_NEAR(drawn[i], expected[i], 1e-4);
}

TEST(GaitPlot, BarsOfPlantsLastAsLongAsThePlants) {
  const ClipAnalysis analysis = walk();
  pugi::xml_document plot_read;
  ASSERT_TRUE(plot_read.load_string(plot(analysis).c_str()));
  const PlotAxis axis(plot_read);
  const double end = (analysis.frames() - 0.5) * analysis.frame_time;
  for (const Side side : {kLeft, kRight}) {
    double drawn = 0.0, expected = 0.0;
    const std::string query = "//rect[@fill='" + hexColor(sideColor(side)) + "']";
    for (const auto& found : plot_read.select_nodes(query.c_str()))
      drawn += found.node().attribute("width").as_double() / axis.second;
    for (const FootPlant& plant : analysis.plants.plants[side]) {
      const double from = plant.first == 0 ? -0.5 : plant.strike;
      expected += std::min(plant.lift_off * analysis.frame_time, end) -
                  std::max(from, -0.5) * analysis.frame_time;
    }
    EXPECT_NEAR(drawn, expected, 1e-3);
  }
}

TEST(GaitPlot, TheTypesBandFillsAllOfTheTime) {
  const ClipAnalysis analysis = walk();
  pugi::xml_document plot_read;
  ASSERT_TRUE(plot_read.load_string(plot(analysis).c_str()));
  const PlotAxis axis(plot_read);
  double band = 0.0;
  for (const auto& found : plot_read.select_nodes("//rect[@height='22']"))
    band += found.node().attribute("width").as_double();
  EXPECT_NEAR(band / axis.second, analysis.frames() * analysis.frame_time, 1e-3);
}

TEST(GaitPlot, TheTwoFeetHaveTheColoursOfTheirSides) {
  const std::string svg = plot(walk());
  EXPECT_GT(count(svg, hexColor(sideColor(kLeft))), 10u);
  EXPECT_GT(count(svg, hexColor(sideColor(kRight))), 10u);
}

TEST(GaitPlot, ALongClipIsNoWiderThanAPicture) {
  ClipAnalysis analysis = walk();
  const double before = [&] {
    pugi::xml_document read;
    read.load_string(plot(analysis).c_str());
    return read.child("svg").attribute("width").as_double();
  }();
  analysis.frame_time *= 1000.0;
  pugi::xml_document read;
  ASSERT_TRUE(read.load_string(plot(analysis).c_str()));
  EXPECT_GT(read.child("svg").attribute("width").as_double(), before);
  EXPECT_LT(read.child("svg").attribute("width").as_double(), 6200.0);
  EXPECT_LT(read.select_nodes("//text").size(), 300u);  // labels give way too
}

}  // namespace
}  // namespace amble
