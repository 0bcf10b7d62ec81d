#include "viz/gait_plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "tests/animation/puppet.h"

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

}  // namespace
}  // namespace amble
