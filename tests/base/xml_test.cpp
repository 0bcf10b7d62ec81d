#include "base/xml.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <sstream>

#include "base/text.h"

namespace amble {
namespace {

TEST(Xml, NumbersAreShortAndFinite) {
  EXPECT_EQ(xmlNumber(1.5), "1.5");
  EXPECT_EQ(xmlNumber(-0.0001), "0");
  EXPECT_EQ(xmlNumber(1234.56789), "1234.568");
  EXPECT_EQ(xmlNumber(std::nan("")), "0");
  EXPECT_EQ(xmlNumber(std::numeric_limits<double>::infinity()), "0");
}

TEST(Xml, ElementsCloseWhereTheirLifeEnds) {
  std::ostringstream out;
  {
    XmlWriter xml(out);
    xml.declare();
    const auto outer = xml.open("a", {{"n", 3}});
    {
      const auto inner = xml.open("b");
      xml.empty("c", {{"x", 0.5}});
    }
    xml.text("d", {}, "text");
  }
  EXPECT_EQ(out.str(),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<a n=\"3\">\n<b>\n<c x=\"0.5\"/>\n</b>\n<d>text</d>\n</a>\n");
}

TEST(Xml, AParserReadsWhatWasWritten) {
  for (const std::string said : {"plain", "<b>&\"quoted\" 'twice'</b>", "]]>", "&amp;", "Küche",
                                 "K\xFC"
                                 "che",
                                 "bell \x07 and zero", "\xED\xA0\x80", "--><!--"}) {
    std::ostringstream out;
    {
      XmlWriter xml(out);
      const auto root = xml.open("root", {{"name", said}});
      xml.text("text", {}, said);
    }
    pugi::xml_document read;
    ASSERT_TRUE(read.load_string(out.str().c_str(), pugi::parse_full)) << out.str();
    EXPECT_EQ(read.child("root").attribute("name").value(), utf8Text(said));
    EXPECT_EQ(read.child("root").child("text").text().get(), utf8Text(said));
  }
}

}  // namespace
}  // namespace amble
