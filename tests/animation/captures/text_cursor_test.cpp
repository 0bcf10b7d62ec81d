#include "animation/captures/text_cursor.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/error.h"

namespace amble {
namespace {

std::string refusal(const std::string& text, const std::function<void(TextCursor&)>& act) {
  TextCursor cursor(text, "f");
  try {
    act(cursor);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TextCursor, SaysFileLineWhatIsThereAndWhatWasExpected) {
  EXPECT_EQ(refusal("\n\n  one", [](TextCursor& in) { in.expectWord("two"); }),
            "f:3: 'one'; expected two");
  EXPECT_EQ(refusal("", [](TextCursor& in) { in.word(); }),
            "f:1: the file ends here; expected more");
  EXPECT_EQ(refusal("a b", [](TextCursor& in) { in.word(), in.expectLineEnd(); }),
            "f:1: 'b'; expected the end of the line");
  EXPECT_EQ(refusal("Frame: 3", [](TextCursor& in) { in.expectLabel("Frames"); }),
            "f:1: no 'Frames:'; expected it here");
}

TEST(TextCursor, QuotesNoMoreThanALineCanHold) {
  const std::string long_word(100'000, 'x');
  EXPECT_LT(refusal(long_word, [](TextCursor& in) { in.expectWord("y"); }).size(), 80u);
}

TEST(TextCursor, RefusesWhatIsNoNumberNotFiniteOrTooLarge) {
  for (const char* const bad : {"x", "1x", "1,5", "nan", "inf", "1e999", "-1e999", "1001", "-1001",
                                "+", "-", ".", "--1", "+-1", "0x1"}) {
    EXPECT_NE(refusal(bad, [](TextCursor& in) { in.number(1000.0); }), "") << bad;
  }
  for (const char* const bad : {"-1", "1.5", "x", "99999999999", "", "3x"}) {
    EXPECT_NE(refusal(bad, [](TextCursor& in) { in.count(); }), "") << bad;
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
