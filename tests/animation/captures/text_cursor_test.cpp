#include "animation/captures/text_cursor.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>

#include "base/error.h"

namespace amble {
namespace {

std::string cursorRefusal(const std::string& text, const std::function<void(TextCursor&)>& act) {
  TextCursor cursor(text, "f");
  try {
    act(cursor);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TextCursor, SaysFileLineWhatIsThereAndWhatWasExpected) {
  EXPECT_EQ(cursorRefusal("\n\n  one", [](TextCursor& in) { in.expectWord("two"); }),
            "f:3: 'one'; expected two");
  EXPECT_EQ(cursorRefusal("", [](TextCursor& in) { in.word(); }),
            "f:1: the file ends here; expected more");
  EXPECT_EQ(cursorRefusal("a b", [](TextCursor& in) { in.word(), in.expectLineEnd(); }),
            "f:1: 'b'; expected the end of the line");
  EXPECT_EQ(cursorRefusal("Frame: 3", [](TextCursor& in) { in.expectLabel("Frames"); }),
            "f:1: no 'Frames:'; expected it here");
}

TEST(TextCursor, QuotesNoMoreThanALineCanHold) {
  const std::string long_word(100'000, 'x');
  EXPECT_LT(cursorRefusal(long_word, [](TextCursor& in) { in.expectWord("y"); }).size(), 80u);
}

TEST(TextCursor, RefusesWhatIsNoNumberNotFiniteOrTooLarge) {
  for (const char* const bad : {"x", "1x", "1,5", "nan", "inf", "1e999", "-1e999", "1001", "-1001",
                                "+", "-", ".", "--1", "+-1", "0x1"}) {
    EXPECT_NE(cursorRefusal(bad, [](TextCursor& in) { in.number(1000.0); }), "") << bad;
  }
  for (const char* const bad : {"-1", "1.5", "x", "99999999999", "", "3x"}) {
    EXPECT_NE(cursorRefusal(bad, [](TextCursor& in) { in.count(); }), "") << bad;
  }
}

TEST(TextCursor, ReadsNumbersAsCWritesThem) {
  const std::vector<std::pair<std::string, double>> numbers = {
      {"1", 1.0},  {"+2.5", 2.5}, {"-0.125", -0.125}, {"1e-2", 0.01},  {"5E1", 50.0},
      {".5", 0.5}, {"5.", 5.0},   {"1e-999", 0.0},    {"-1E-999", 0.0}};
  for (const auto& [text, value] : numbers) {
    TextCursor in(text, "f");
    EXPECT_EQ(in.number(1000.0), value) << text;
  }
}

constexpr double kAnySize = std::numeric_limits<double>::infinity();

// Of up to 21 digits, with and without an exponent, as printf writes them.
std::string randomNumber(std::mt19937_64& generator) {
  const auto draw = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(generator);
  };
  const double value = std::uniform_real_distribution<double>(-1.0, 1.0)(generator);
  constexpr const char* kFormats[] = {"%.*f", "%.*e", "%.*g", "%.*E"};
  char text[64];
  std::snprintf(text, sizeof text, kFormats[draw(0, 3)], draw(0, 20),
                value * std::pow(10.0, draw(-30, 30) / 3));
  return text;
}

TEST(TextCursor, NumbersAreTheNearestDoublesAsStrtodFindsThem) {
  // At the ends of what is decided in one step, beyond them, and halfway between two doubles.
  std::string text =
      "9007199254740991 9007199254740992 9007199254740993 9007199254740993.0 9999999999999999999 "
      "99999999999999999999 9223372036854775808 18446744073709551616 0.1e1 1e22 1e23 3e-22 3e-23 "
      "9007199254740992e22 1.7976931348623157e308 2.2250738585072014e-308 4.9e-324 -0 -0.0 0e5 "
      "123456789012345678.9 0.00000000000000000000001 1000000000000000000000000 0.1 .1 1. 00001.5 "
      "1e+3 1E-03 8.5e0000002 1e000 0.500000000000000166533453693773481063544750213623046875 "
      "1.00000000000000011102230246251565404236316680908203125 1234567890123456789.5 ";
  std::mt19937_64 generator(3);
  for (int n = 0; n < 1000000; ++n) text += randomNumber(generator) + " ";
  TextCursor in(text, "f");
  const char* at = text.c_str();
  while (in.skipBlankLines()) {
    char* end = nullptr;
    const double right = std::strtod(at, &end), found = in.number(kAnySize);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(found), std::bit_cast<std::uint64_t>(right))
        << std::string_view(at, static_cast<size_t>(end - at));
    at = end;
  }
}

TEST(TextCursor, ARowOfNumbersEndsWithItsLine) {
  const std::string text = " 1\t2 \r\n\n 3";
  TextCursor in(text, "f");
  double value = 0.0;
  EXPECT_TRUE(in.numberInLine(10.0, value));
  EXPECT_TRUE(in.numberInLine(10.0, value));
  EXPECT_EQ(value, 2.0);
  EXPECT_FALSE(in.numberInLine(10.0, value));
  EXPECT_TRUE(in.atLineEnd());
  EXPECT_TRUE(in.skipBlankLines());
  EXPECT_EQ(in.line(), 3);
  EXPECT_TRUE(in.numberInLine(10.0, value));
  EXPECT_FALSE(in.skipBlankLines());
  EXPECT_EQ(in.remaining(), 0u);
}

TEST(TextCursor, WordsLabelsAndLinesAreTrimmedAndOfAnyCase) {
  const std::string text = "\xEF\xBB\xBFHIERARCHY\r\n JOINT  a b \r\nFrames :\t7";
  TextCursor in(text, "f");
  in.expectWord("Hierarchy");
  EXPECT_EQ(in.word(), "JOINT");
  EXPECT_EQ(in.restOfLine(), "a b");
  in.expectLabel("FRAMES");
  EXPECT_EQ(in.count(), 7);
  EXPECT_TRUE(sameWord("aBc", "AbC"));
  EXPECT_FALSE(sameWord("ab", "abc"));
  EXPECT_EQ(trimmed(" \t x y\n"), "x y");
}

}  // namespace
}  // namespace amble
