#include "viz/regression/check_page.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <sstream>

namespace amble {
namespace {

RunFigures walkOf(double length) {
  return {"solved", length, 4.0, 0.02, 0.001, 0.5, std::string(64, 'a')};
}

CheckRow rowOf(const std::string& name) {
  CheckRow row;
  row.file = "s/" + name + ".yaml";
  row.scenario = name;
  row.run = walkOf(5.25);
  row.picture = "new";
  return row;
}

std::string pageOf(const std::vector<CheckRow>& rows) {
  std::ostringstream out;
  writeCheckPage(out, rows);
  return out.str();
}

// What the page shows, by an independent reader. Script and style are no markup.
class CheckPage : public testing::Test {
 protected:
  void read(std::string page) {
    for (const std::string element : {"style", "script"}) {
      const size_t from = page.find("<" + element + ">") + element.size() + 2;
      page.erase(from, page.find("</" + element + ">") - from);
    }
    page.erase(0, page.find('\n'));  // <!DOCTYPE html>
    const auto result = document_.load_string(page.c_str());
    ASSERT_TRUE(result) << result.description() << " at " << page.substr(result.offset, 200);
  }
  pugi::xpath_node_set all(const char* path) const { return document_.select_nodes(path); }
  std::string text(const char* path) const {
    return document_.select_node(path).node().text().as_string();
  }
  pugi::xml_document document_;
};

TEST_F(CheckPage, WhatIsNotAsAcceptedIsShownBeforeAndAfter) {
  CheckRow same = rowOf("same"), other = rowOf("other");
  same.accepted = AcceptedRun{walkOf(5.25), "old"};
  other.accepted = AcceptedRun{walkOf(5.0), "old"};
  other.changes = changesSince(other.accepted->figures, other.run);
  other.verdict = CheckVerdict::kDiffers;
  read(pageOf({same, other}));
  EXPECT_EQ(all("//article").size(), 2u);
  EXPECT_EQ(all("//article[@data-name='same']//img").size(), 1u);
  const auto pictures = all("//article[@data-name='other']//img/@src");
  ASSERT_EQ(pictures.size(), 2u);  // RFC 4648: "old" and "new"
  EXPECT_STREQ(pictures[0].attribute().value(), "data:image/png;base64,b2xk");
  EXPECT_STREQ(pictures[1].attribute().value(), "data:image/png;base64,bmV3");
  const char* const length = "//article[@data-name='other']//tr[th='length']/td[%]";
  const auto cell = [&](char column) {
    std::string path = length;
    path[path.find('%')] = column;
    return text(path.c_str());
  };
  EXPECT_EQ(cell('1'), "5.00 m");
  EXPECT_EQ(cell('2'), "5.25 m");
  EXPECT_EQ(cell('3'), "+0.25 m");
}

TEST_F(CheckPage, ShowsWhatWasNeverRunWithItsReason) {
  CheckRow row;
  row.scenario = "broken";
  row.verdict = CheckVerdict::kError;
  row.notes = {"broken.yaml:2: unknown key"};
  read(pageOf({row}));
  EXPECT_EQ(text("//article[@class='error']//li"), "broken.yaml:2: unknown key");
  EXPECT_EQ(all("//article//img").size(), 0u);
  EXPECT_EQ(all("//article//table").size(), 0u);
}

TEST_F(CheckPage, NamesOfAnyBytesAreTextAndNothingElse) {
  const std::string name = "</script><script>alert(1)</script>\" onload='x' \xff\x1b \xe8\xb5\xb0";
  CheckRow row = rowOf(name);
  row.notes = {name};
  row.why = name;
  const std::string page = pageOf({row});
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find('\x1b'), std::string::npos);
  read(page);
  const std::string shown =
      "</script><script>alert(1)</script>\" onload='x' "
      "\xef\xbf\xbd\xef\xbf\xbd \xe8\xb5\xb0";
  EXPECT_EQ(text("//article/header/h2"), shown);
  EXPECT_EQ(text("//article//li"), shown);
}

TEST_F(CheckPage, AsksForNothingOutsideOfItself) {
  const std::string page = pageOf({rowOf("one")});
  EXPECT_EQ(page.find("http:"), std::string::npos);
  EXPECT_EQ(page.find("https:"), std::string::npos);
  read(page);
  EXPECT_EQ(all("//link").size() + all("//script[@src]").size(), 0u);
}

TEST_F(CheckPage, OfNoRowsIsAPage) {
  read(pageOf({}));
  EXPECT_EQ(text("//h1"), "amble check");
}

}  // namespace
}  // namespace amble
