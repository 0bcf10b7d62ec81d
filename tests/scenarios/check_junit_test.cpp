#include "scenarios/check_junit.h"

#include <pugixml.hpp>
#include <sstream>

#include "base/text.h"
#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

TEST(WriteJUnit, CountsAndEscapes) {
  CheckRow good, bad, skipped, error;
  good.file = "s/good.yaml";
  good.scenario = "good";
  bad.scenario = "bad & \"worse\"";
  bad.verdict = CheckVerdict::kDiffers;
  bad.notes = {"length is 5 m; expected < 4", "second"};
  skipped.verdict = CheckVerdict::kSkipped;
  error.verdict = CheckVerdict::kError;
  std::ostringstream out;
  writeJUnit(out, {good, bad, skipped, error});
  const std::string xml = out.str();
  EXPECT_TRUE(holds(xml, "tests=\"4\" failures=\"1\" errors=\"1\" skipped=\"1\"")) << xml;
  EXPECT_TRUE(holds(xml, "classname=\"s\" name=\"good\"")) << xml;
  EXPECT_TRUE(holds(xml, "name=\"bad &amp; &quot;worse&quot;\"")) << xml;
  EXPECT_TRUE(holds(xml, "expected &lt; 4; second")) << xml;
}

TEST(WriteJUnit, NamesOfAnyBytesGiveValidXml) {
  CheckRow row;
  row.file = "caf\xe9/gr\xfc\xdf.yaml";  // Latin-1
  row.scenario = "\x01 a\x00b \xff\xfe \xed\xa0\x80 \xe2\x82\xac";
  row.verdict = CheckVerdict::kStopped;
  row.notes = {"\x1b[31m", "\xc3"};
  std::ostringstream out;
  writeJUnit(out, {row});
  const std::string xml = out.str();
  EXPECT_TRUE(holds(xml, "skipped=\"1\"")) << xml;
  EXPECT_TRUE(holds(xml, "\xe2\x82\xac")) << "what is UTF-8 stays: " << xml;
  EXPECT_TRUE(holds(xml, "classname=\"caf\xef\xbf\xbd\"")) << xml;
  // Every byte is ASCII that XML may hold, or part of the two characters above.
  std::string rest = xml;
  for (const char* const character : {"\xe2\x82\xac", "\xef\xbf\xbd"}) {
    for (size_t at; (at = rest.find(character)) != std::string::npos;) rest.erase(at, 3);
  }
  for (const char c : rest) {
    const auto byte = static_cast<unsigned char>(c);
    EXPECT_TRUE((byte >= 0x20 && byte < 0x7f) || c == '\n') << static_cast<int>(byte);
  }
}

TEST(WriteJUnit, NamesOfAnyBytesAreReadBack) {
  CheckRow row;
  row.file =
      "K\xFC"
      "che/1\x01.yaml";
  row.scenario =
      "K\xFC"
      "che \xED\xA0\x80";
  row.verdict = CheckVerdict::kDiffers;
  row.notes = {"'\x1b[31m' <is> \"unknown\""};
  std::ostringstream out;
  writeJUnit(out, {row});
  pugi::xml_document read;
  ASSERT_TRUE(read.load_string(out.str().c_str())) << out.str();
  const pugi::xml_node test = read.child("testsuites").child("testsuite").child("testcase");
  EXPECT_EQ(test.attribute("name").value(), utf8Text(row.scenario));
  EXPECT_EQ(test.child("failure").attribute("message").value(), utf8Text(row.notes[0]));
  EXPECT_EQ(out.str(), utf8Text(out.str())) << "not all of it is text of XML";
}

}  // namespace
}  // namespace amble
