#include "viz/page/page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/viz/test_walk.h"

namespace amble {
namespace {

using Json = nlohmann::json;

PageSubject subjectOf(const TestWalk& walk) {
  PageSubject page;
  page.title = walk.view.title;
  page.scene = &walk.scene;
  page.walk = &walk.view;
  page.actors = {{.name = "walker", .skeleton = &walk.skeleton}};
  PageTake take;
  take.name = "walk";
  take.frame_time = walk.animation.frame_time;
  take.poses = &walk.animation.poses;
  take.footprints = walk.animation.footprints;
  page.takes = {take};
  return page;
}

std::string written(const PageSubject& page) {
  std::ostringstream out;
  writePage(out, page);
  return out.str();
}

// What stands in the element of that id, up to its end tag as a browser sees it.
std::string elementText(const std::string& html, const std::string& id) {
  const size_t begin = html.find('>', html.find("id=\"" + id + "\"")) + 1;
  return html.substr(begin, html.find("</", begin) - begin);
}

Json dataOf(const std::string& html) { return Json::parse(elementText(html, "amble-data")); }

size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

const std::string kNasty =
    "a\"b'</script><script>alert(1)</script><!--\n\t\xe2\x80\xa8\xe6\xbc\xa2 & \\u003c";

TEST(Page, NamesOfAnyKindStayText) {
  const auto walk = makeTestWalk();
  const size_t scripts = count(written(subjectOf(*walk)), "<script");
  walk->scene.objects.back().name = kNasty;
  walk->body.parts[0].name = kNasty;
  PageSubject page = subjectOf(*walk);
  page.actors[0].body = &walk->body;
  page.title = page.description = page.why = page.takes[0].name = kNasty;
  page.facts = {{kNasty, kNasty}};
  page.notes = {kNasty};
  const std::string html = written(page);
  EXPECT_EQ(count(html, "<script"), scripts);
  EXPECT_EQ(count(html, "alert(1)</script>"), 0u);
  const Json data = dataOf(html);
  EXPECT_EQ(data["title"], kNasty);
  EXPECT_EQ(data["notes"][0], kNasty);
  EXPECT_EQ(data["room"]["objects"].back(), kNasty);
  EXPECT_EQ(data["actors"][0]["body"]["parts"][0]["name"], kNasty);
}

TEST(Page, BytesThatAreNoTextAreReplaced) {
  const auto walk = makeTestWalk();
  PageSubject page = subjectOf(*walk);
  page.title = std::string("bad \xff\xfe\x00 end", 12);
  const std::string html = written(page);
  EXPECT_EQ(html.find('\xff'), std::string::npos);
  EXPECT_EQ(html.find('\0'), std::string::npos);
  EXPECT_EQ(dataOf(html)["title"].get<std::string>().substr(0, 4), "bad ");
}

TEST(Page, ItAsksForNothingElse) {
  const auto walk = makeTestWalk();
  std::string html = written(subjectOf(*walk));
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
  const std::string frame = html.substr(0, html.find("id=\"amble-data\""));
  EXPECT_FALSE(std::regex_search(frame, std::regex("(src|href)=[\"'](?!data:)")));
  EXPECT_EQ(html.find("@import"), std::string::npos);
}

TEST(Page, TheSameSubjectGivesTheSameBytes) {
  const auto walk = makeTestWalk();
  EXPECT_EQ(written(subjectOf(*walk)), written(subjectOf(*walk)));
}

TEST(Page, EqualThingsAndBoxesOfAllSizesShareAMesh) {
  const auto walk = makeTestWalk();
  const size_t plain = written(subjectOf(*walk)).size();
  constexpr int kMany = 10000;
  for (int i = 0; i < kMany; ++i) {
    walk->scene.objects.push_back(testBox("box-" + std::to_string(i), {0.1 + 1e-5 * i, 0.1, 0.2},
                                          {0.05 * (i % 100), 0.04 * (i / 100), 0.1}));
  }
  const std::string html = written(subjectOf(*walk));
  const Json room = dataOf(html)["room"];
  ASSERT_EQ(room["meshes"].size(), 1u);
  EXPECT_EQ(room["meshes"][0]["objects"]["n"], kMany + 6);
  EXPECT_EQ(room["triangles"], 12 * (kMany + 6));
  EXPECT_LT(html.size() - plain, 150u * kMany);
}

TEST(Page, VeryManyTrianglesAreThinnedAndThePageKnows) {
  const auto walk = makeTestWalk();
  EXPECT_EQ(dataOf(written(subjectOf(*walk)))["room"]["thinned"], 0.0);
  TriangleMesh ground;  // 400 x 400 squares of rolling ground
  constexpr int kSide = 400;
  for (int i = 0; i <= kSide; ++i)
    for (int k = 0; k <= kSide; ++k)
      ground.vertices.emplace_back(0.02 * i, 0.02 * k,
                                   0.1 * std::sin(0.1 * i) * std::cos(0.07 * k));
  for (int i = 0; i < kSide; ++i) {
    for (int k = 0; k < kSide; ++k) {
      const int a = i * (kSide + 1) + k, b = a + kSide + 1;
      ground.triangles.push_back({a, b, b + 1});
      ground.triangles.push_back({a, b + 1, a + 1});
    }
  }
  SceneObject object;
  object.name = "hills";
  object.shape = ground;
  walk->scene.objects.push_back(object);
  const std::string html = written(subjectOf(*walk));
  const Json room = dataOf(html)["room"];
  EXPECT_EQ(room["triangles"], 2 * kSide * kSide + 6 * 12);
  EXPECT_LT(room["shown"], 160000);
  EXPECT_GT(room["shown"], 20000);
  EXPECT_GT(room["thinned"], 0.0);
  EXPECT_LT(html.size(), 5'000'000u);
}

}  // namespace
}  // namespace amble
