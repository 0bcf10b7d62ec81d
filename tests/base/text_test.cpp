#include "base/text.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/sample_stream.h"

namespace amble {
namespace {

TEST(Text, WordsAreTheSameWhateverTheirCase) {
  EXPECT_TRUE(sameWord("HIERARCHY", "hierarchy"));
  EXPECT_FALSE(sameWord("root", "roots"));
  EXPECT_FALSE(sameWord("[", "{"));  // as far apart as capitals and small letters, and no letters
  EXPECT_EQ(lowerCase("Left_Foot.001"), "left_foot.001");
  EXPECT_EQ(lowerCase("\xC4"), "\xC4");
}

TEST(Text, TrimmedHasNoSpaceAtItsEndsAndAllWithin) {
  EXPECT_EQ(trimmed(" \t x y\r\n"), "x y");
  EXPECT_EQ(trimmed(" \v\f "), "");
}

TEST(Text, SplitAndJoinedAreInverse) {
  EXPECT_FALSE(splitAt("1.2", ".."));
  const auto parts = splitAt("0.5..0.8..1", "..");
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->first, "0.5");
  EXPECT_EQ(parts->second, "0.8..1");
  EXPECT_EQ(joined({std::string(parts->first), std::string(parts->second)}, ".."), "0.5..0.8..1");
}

TEST(Text, JoinedSaysListsAsPeopleDo) {
  EXPECT_EQ(joined({}), "");
  EXPECT_EQ(joined({"a"}, ", ", " or "), "a");
  EXPECT_EQ(joined({"a", "b", "c"}, ", ", " or "), "a, b or c");
}

TEST(Text, CountedIsPluralUnlessOne) {
  EXPECT_EQ(counted(0, "walk"), "0 walks");
  EXPECT_EQ(counted(1, "walk"), "1 walk");
  EXPECT_EQ(counted(2, "walk"), "2 walks");
}

TEST(Text, ControlsBecomeBlanks) { EXPECT_EQ(withoutControls("a\n\x1b[1m\x7f"), "a  [1m "); }

TEST(Text, NumbersOfOtherKindsAreNone) {
  for (const char* text :
       {"", "+", "-", "+-1", "1 ", " 1", "1e", "0x10", "inf", "nan", "1,5", "1e999"})
    EXPECT_FALSE(numberOf(text)) << text;
  for (const char* text : {"", "1.0", "1e3", "--1", "99999999999999999999"})
    EXPECT_FALSE(wholeNumberOf(text)) << text;
  EXPECT_EQ(numberOf("+1.5e-1"), 0.15);
  EXPECT_EQ(wholeNumberOf("-12"), -12);
}

TEST(Text, FixedNumbersAreWithinHalfOfTheirLastDigit) {
  SampleStream random(7, 0);
  for (int i = 0; i < 2000; ++i) {
    const double value = random.uniform(-1000.0, 1000.0);
    const int digits = random.below(8);
    const std::string fixed = fixedNumber(value, digits), plain = plainNumber(value, digits);
    EXPECT_LE(std::abs(*numberOf(fixed) - value), 0.5000001 * std::pow(10.0, -digits)) << fixed;
    EXPECT_EQ(*numberOf(fixed), *numberOf(plain)) << fixed << " " << plain;
    EXPECT_EQ(fixed.find(plain), 0u) << "more than zeros were left out: " << fixed << " " << plain;
  }
}

TEST(Text, ZeroHasNoSign) {
  for (const double value : {0.0, -0.0, -1e-9}) {
    EXPECT_EQ(fixedNumber(value, 2), "0.00");
    EXPECT_EQ(plainNumber(value, 3), "0");
  }
  EXPECT_EQ(plainNumber(-0.01, 3), "-0.01");
  EXPECT_EQ(plainNumber(100.0, 0), "100");
}

TEST(Text, TheLargestNumberIsWrittenOut) {
  EXPECT_EQ(fixedNumber(-std::numeric_limits<double>::max(), 17).size(), 1u + 309u + 1u + 17u);
}

TEST(Text, ShortNumbersHaveSoManyDigits) {
  EXPECT_EQ(shortNumber(1234567.0), "1.235e+06");
  EXPECT_EQ(shortNumber(0.123456), "0.1235");
  EXPECT_EQ(shortNumber(2.5), "2.5");
}

// Of the Unicode Standard: what is well-formed, by decoding instead of by table 3-7.
bool isXmlText(const std::string& text) {
  for (size_t i = 0; i < text.size();) {
    const unsigned first = static_cast<unsigned char>(text[i]);
    const size_t more = first < 0x80 ? 0 : first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
    if ((first >= 0x80 && first < 0xC0) || first >= 0xF8 || i + more >= text.size()) return false;
    unsigned code = more == 0 ? first : first & (0x3Fu >> more);
    for (size_t k = 1; k <= more; ++k) {
      const unsigned byte = static_cast<unsigned char>(text[i + k]);
      if (byte >> 6 != 2) return false;
      code = code << 6 | (byte & 0x3F);
    }
    constexpr unsigned kLeast[] = {0, 0x80, 0x800, 0x10000};
    const bool allowed = code == '\t' || code == '\n' || code == '\r' ||
                         (code >= 0x20 && code <= 0xD7FF) || (code >= 0xE000 && code <= 0xFFFD) ||
                         (code >= 0x10000 && code <= 0x10FFFF);
    if (code < kLeast[more] || !allowed) return false;
    i += 1 + more;
  }
  return true;
}

TEST(WithoutPercents, BytesComeBackAsTheyWereCoded) {
  std::string all, coded;
  for (int byte = 0; byte < 256; ++byte) {
    all += static_cast<char>(byte);
    char code[4];
    std::snprintf(code, sizeof code, byte % 2 == 0 ? "%%%02x" : "%%%02X", byte);
    coded += code;
  }
  EXPECT_EQ(withoutPercents(coded), all);
}

TEST(WithoutPercents, WhatIsNoCodeStays) {
  for (const std::string plain : {"", "walk.bin", "100 %", "%", "%4", "%zz", "%-1", "%+1", "% 1"})
    EXPECT_EQ(withoutPercents(plain), plain);
  EXPECT_EQ(withoutPercents("%%20"), "% ");
  EXPECT_EQ(withoutPercents("%2520"), "%20") << "once";
}

TEST(Utf8Text, WhatIsGoodStaysAsItIs) {
  for (const std::string text :
       {"", "plain", "Küche \xF0\x9F\xAA\x91", "a\tb\nc", "\xEF\xBF\xBD"}) {
    ASSERT_TRUE(isXmlText(text));
    EXPECT_EQ(utf8Text(text), text);
  }
}

TEST(Utf8Text, BytesOfAnyKindBecomeTextOfXml) {
  SampleStream random(3, 0);
  for (int i = 0; i < 3000; ++i) {
    std::string bytes;
    for (int k = random.below(12); k >= 0; --k) {
      // Mostly what begins or goes on characters, so that halves and overlong forms are frequent.
      constexpr unsigned char kLikely[] = {0x80, 0xBF, 0xA0, 0x9F, 0x8F, 0x90, 0xC0, 0xC2, 0xE0,
                                           0xED, 0xEF, 0xF0, 0xF4, 0xF5, 0xFF, 0xBE, 0x00, 0x7F};
      bytes += static_cast<char>(random.below(3) == 0 ? random.below(256)
                                                      : kLikely[random.below(sizeof kLikely)]);
    }
    EXPECT_TRUE(isXmlText(utf8Text(bytes)));
    if (isXmlText(bytes)) {
      // What XML allows is kept, but for the controls that no font shows.
      const bool controls = bytes.find('\x7f') != bytes.npos || bytes.find('\xC2') != bytes.npos;
      EXPECT_TRUE(controls || utf8Text(bytes) == bytes);
    }
  }
}

TEST(Utf8Text, EveryBadByteIsReplaced) {
  EXPECT_EQ(utf8Text("K\xFC"
                     "che\x01"),
            "K\uFFFDche\uFFFD");
  EXPECT_EQ(utf8Text("\xC0\xAF"), "\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(utf8Text("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // half of a surrogate pair
  EXPECT_EQ(utf8Text("\xE2\x82"), "\uFFFD\uFFFD");            // cut off
}

}  // namespace
}  // namespace amble
