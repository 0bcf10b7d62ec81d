#include "viz/plan_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "base/error.h"
#include "test_walk.h"

namespace amble {
namespace {

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

}  // namespace
}  // namespace amble
