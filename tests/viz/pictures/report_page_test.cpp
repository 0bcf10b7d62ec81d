#include "viz/pictures/report_page.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <sstream>

namespace amble {
namespace {

// What a file name may hold, and a page must not take for its own.
constexpr const char* kHostile =
    "a \"b\" 'c' <script>alert(1)</script> &amp; \xd0\xb6\xe6\xa1\x8c\xf0\x9f\xaa\x91\n\x01\xff "
    "--> "
    "</style> {{x}}";

Report solvedReport() {
  Report report;
  report.status = PlanStatus::kSolved;
  report.scenario = "room";
  report.planner = "visibility";
  report.length = 5.25;
  report.duration = 6.5;
  report.clearance = {0.026, "left hand", "piano", 3.2};
  report.quality = {{"drift_per_plant", 1.5, 2.0, "mm"}, {"joint_jerk", 130.0, 100.0, "m/s\u00b3"}};
  report.times.load = 0.3;
  report.times.roadmap = 0.1;
  report.times.search = 0.2;
  report.times.refine = 0.4;
  report.refusals = {{"contact", 40}, {"turn_rate", 10}};
  report.inputs = {{"room.yaml", std::string(64, 'a')}};
  report.steps.resize(3);
  return report;
}

std::string pageOf(const ReportPage& page) {
  std::ostringstream out;
  writeReportPage(out, page);
  return out.str();
}

// Read as XML, which the page is too.
pugi::xml_document readPage(const ReportPage& page) {
  pugi::xml_document read;
  const std::string text = pageOf(page);
  const pugi::xml_parse_result result = read.load_string(text.c_str(), pugi::parse_full);
  EXPECT_TRUE(result) << result.description() << " near " << text.substr(result.offset, 60);
  return read;
}

double widthOf(const pugi::xml_node& node) {
  double share = -1.0;
  std::sscanf(node.attribute("style").value(), "width:%lf%%", &share);
  return share;
}

TEST(ReportPage, NamesOfAnyBytesAreTextAndNothingElse) {
  Report report = solvedReport();
  report.scenario = report.planner = report.clearance.part = report.clearance.object = kHostile;
  report.inputs = {{kHostile, kHostile}};
  report.refusals = {{kHostile, 1}};
  report.quality[0].measure = kHostile;
  const ReportPage page{.report = report, .command = kHostile};
  const pugi::xml_document read = readPage(page);
  EXPECT_TRUE(read.select_nodes("//script").empty());
  EXPECT_EQ(read.select_nodes("//style").size(), 1u);
  EXPECT_NE(std::string(read.child("html").child("body").child("h1").text().get())
                .find("<script>alert(1)</script> &amp; \xd0\xb6\xe6\xa1\x8c\xf0\x9f\xaa\x91"),
            std::string::npos);
  const std::string text = pageOf(page);
  EXPECT_EQ(text.find('\x01'), std::string::npos);
  EXPECT_EQ(text.find('\xff'), std::string::npos);
}

TEST(ReportPage, AsksForNothingElse) {
  const Report report = solvedReport();
  const pugi::xml_document read =
      readPage({.report = report, .picture = "\x89PNG", .plan = "<svg/>"});
  for (const char* name : {"src", "href"})
    for (const auto& found : read.select_nodes((std::string("//@") + name).c_str()))
      EXPECT_EQ(std::string_view(found.attribute().value()).substr(0, 5), "data:");
  EXPECT_EQ(read.select_nodes("//img").size(), 2u);
  EXPECT_TRUE(read.select_nodes("//script | //link | //@onload").empty());
}

TEST(ReportPage, TheShareOfEachPhaseIsItsWidth) {
  const Report report = solvedReport();  // 1 s in all
  const pugi::xml_document read = readPage({.report = report});
  for (const auto& [name, share] :
       {std::pair{"load", 30.0}, {"roadmap", 10.0}, {"search", 20.0}, {"refine", 40.0}}) {
    const std::string path = "//div[@class='phases']/span[@class='" + std::string(name) + "']";
    EXPECT_NEAR(widthOf(read.select_node(path.c_str()).node()), share, 1e-9) << name;
  }
}

TEST(ReportPage, TellsWhichBarsHold) {
  const Report report = solvedReport();
  const pugi::xml_document read = readPage({.report = report});
  EXPECT_EQ(read.select_nodes("//td[@class='holds']").size(), 1u);
  EXPECT_EQ(read.select_nodes("//td[@class='fails']").size(), 1u);
}

// Measure, value and bar of each line, as they are read.
std::vector<std::array<std::string, 3>> qualityRows(const std::vector<QualityLine>& lines) {
  Report report = solvedReport();
  report.quality = lines;
  std::vector<std::array<std::string, 3>> rows;
  for (const auto& found : readPage({.report = report}).select_nodes("//tr[td[@class='gauge']]")) {
    const auto cells = found.node().children("td");
    auto cell = cells.begin();
    std::array<std::string, 3> row;
    for (std::string& text : row) text = (cell++)->text().get();
    if (found.node().select_node("td[@class='holds' or @class='fails']")) rows.push_back(row);
  }
  return rows;
}

TEST(ReportPage, MeasuresAreInUnitsInWhichTheirBarsRead) {
  const auto rows = qualityRows({{"toe skate", 3.2312e-05, 0.01, "m/s"},
                                 {"drift", 0.0123456, 0.002, "m"},
                                 {"bone length change", 2e-10, 1e-9, "m"},
                                 {"path", 1.5, 3.0, "m"},
                                 {"acceleration", 4.02, 18.13, "m/s2"},
                                 {"foot turn", 534.4467, 900.0, "degrees/s"},
                                 {"end heading", 7.19e-07, 2.0, "degrees"},
                                 {"speed", 0.01388, 0.05, "1"},
                                 {"pops", 2.48, 5.328, "1"},
                                 {"knee backwards", 0.0, 0.0, "1"}});
  const std::vector<std::array<std::string, 3>> expected = {
      {"toe skate", "0.03 mm/s", "10 mm/s"},
      {"drift", "12.346 mm", "2 mm"},
      {"bone length change", "0.2 nm", "1 nm"},
      {"path", "1.5 m", "3 m"},
      {"acceleration", "4.02 m/s\u00b2", "18.13 m/s\u00b2"},
      {"foot turn", "534.4\u00b0/s", "900\u00b0/s"},
      {"end heading", "0\u00b0", "2\u00b0"},
      {"speed", "1.388 %", "5 %"},
      {"pops", "2.48", "5.328"},
      {"knee backwards", "0", "0"}};
  ASSERT_EQ(rows.size(), expected.size());
  for (size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i], expected[i]) << i;
}

TEST(ReportPage, NoMeasureIsWrittenWithAPowerOfTen) {
  std::vector<QualityLine> lines;
  for (const char* const unit : {"m", "m/s", "m/s2", "m/s3", "degrees", "degrees/s", "1"})
    for (const double bar : {0.0, 1e-9, 3e-7, 2e-5, 0.004, 0.3, 7.0, 900.0, 31000.0})
      for (const double share : {0.0, 1e-7, 0.013, 0.9, 1.0, 1.7}) {
        const double value = bar > 0.0 ? share * bar : share;
        lines.push_back({"measure", value, bar, unit});
      }
  const auto rows = qualityRows(lines);
  ASSERT_EQ(rows.size(), lines.size());
  for (const auto& [measure, value, bar] : rows)
    for (const std::string& text : {value, bar})
      EXPECT_EQ(text.find_first_of("eE"), std::string::npos) << text;
}

// Whoever reads that a bar does not hold sees by how much.
TEST(ReportPage, WhatIsOverItsBarByAHairIsNotWrittenAsTheBar) {
  for (const double over : {1.0 + 1e-3, 1.0 + 1e-5, 1.0 + 1e-7}) {
    const auto rows = qualityRows({{"drift", 0.002 * over, 0.002, "m"}});
    EXPECT_NE(rows[0][1], rows[0][2]) << over;
    EXPECT_GT(std::stod(rows[0][1]), std::stod(rows[0][2])) << over;
  }
  const auto equal = qualityRows({{"drift", 0.002, 0.002, "m"}});
  EXPECT_EQ(equal[0][1], equal[0][2]);
}

TEST(ReportPage, WithoutAWalkTellsWhatStoodInTheWayAndWhatIsNeeded) {
  Report report = solvedReport();
  report.status = PlanStatus::kNoWalk;
  report.why = "contact: pelvis and divider";
  report.quality.clear();
  report.steps.clear();
  report.obstruction = Obstruction{};
  report.obstruction->part = "pelvis";
  report.obstruction->object = "divider";
  report.obstruction->width = 0.52;
  report.obstruction->needed = 0.66;
  ReachedRegion reached;
  reached.near = {1, 2, 0};
  reached.far = {1.5, 2, 0};
  const std::string text = pageOf({.report = report, .reached = &reached});
  for (const char* told : {"contact: pelvis and divider", ">0.52 m<", ">0.66 m<", "0.5 m from"})
    EXPECT_NE(text.find(told), std::string::npos) << told;
  EXPECT_EQ(text.find("<h2>Steps"), std::string::npos);
}

TEST(ReportPage, OfAnEmptyReportIsAPage) {
  const Report report;
  EXPECT_TRUE(readPage({.report = report}).child("html").child("body"));
}

}  // namespace
}  // namespace amble
