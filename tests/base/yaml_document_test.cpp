#include "base/yaml_document.h"

#include <gtest/gtest.h>

#include "base/strict_yaml.h"

namespace amble {
namespace {

/// The error that the text is refused with; a test fails where it is taken.
InputError refusalOf(const std::string& text) {
  try {
    parseYamlDocument(text, "a.yaml");
  } catch (const InputError& error) {
    return error;
  }
  ADD_FAILURE() << "taken: " << text.substr(0, 200);
  return {"", 0, ""};
}

/// All that a document holds but its lines.
std::string contentOf(const YamlNode& node) {
  if (node.isNull()) return "~";
  if (node.isScalar()) return "'" + node.asString() + "'";
  std::string all = node.isMap() ? "{" : "[";
  if (node.isMap()) {
    for (const auto& [key, value] : node.entries()) all += key + ":" + contentOf(value) + ",";
  } else {
    for (const YamlNode& item : node.items()) all += contentOf(item) + ",";
  }
  return all + (node.isMap() ? "}" : "]");
}

std::string contentOf(const std::string& text) { return contentOf(parseYaml(text, "a.yaml")); }

std::string lines(int count) {
  std::string text;
  for (int i = 1; i <= count; ++i) text += "key_" + std::to_string(i) + ": some value\n";
  return text;
}

/// As UTF-16; characters up to U+FFFF.
std::string utf16(const std::u16string& text, bool big_endian) {
  std::string bytes;
  for (const char16_t c : u"\uFEFF" + text) {
    const char high = static_cast<char>(c >> 8), low = static_cast<char>(c & 0xFF);
    bytes += big_endian ? high : low;
    bytes += big_endian ? low : high;
  }
  return bytes;
}

// The parent of each is where its `up` says, and neighbours follow one another as `span` says.
void expectWhole(const YamlValue& value) {
  std::uint32_t children = 0;
  const YamlValue* child = value.begin();
  for (; child < value.end(); child = child->next()) {
    EXPECT_EQ(child->parent(), &value);
    EXPECT_EQ(child->index, children++);
    EXPECT_GE(child->line, value.line);
    expectWhole(*child);
  }
  EXPECT_EQ(child, value.end());
  EXPECT_EQ(children, value.size);
}

TEST(YamlDocument, ValuesStandBeforeTheirChildrenAndAfterTheirParents) {
  const auto document =
      parseYamlDocument("a: [1, [], [2, {b: 3}], 4]\nc:\nd:\n- e: {f: {g: h}}\n  i: []\n- j\n", "");
  EXPECT_EQ(document->values.size(), 17u);
  EXPECT_EQ(document->values[0].span, 17u);
  EXPECT_EQ(document->values[0].parent(), nullptr);
  expectWhole(document->values[0]);
}

TEST(YamlDocument, AnEmptyValueStandsOnTheLineOfItsKey) {
  const YamlNode root = parseYaml("a:\n\nb:\n  - \n  -\nc: 1\n", "");
  EXPECT_EQ(root.at("a").line(), 1);
  EXPECT_EQ(root.at("b").items()[0].line(), 4);
  EXPECT_EQ(root.at("b").items()[1].line(), 5);
}

// libyaml reads ahead by thousands of bytes.
TEST(YamlDocument, BytesThatAreNoTextAreRefusedWithTheirLine) {
  for (const int before : {0, 2, 5000}) {
    for (const std::string& bad : {std::string(1, '\0'), std::string("\x01"), std::string("\x7F"),
                                   std::string("\xE9"), std::string("\x80"), std::string("\xC3("),
                                   std::string("\xED\xA0\x80"), std::string("\xC0\xAF")}) {
      for (const std::string& text : {"x: " + bad, "# " + bad + "\n", "x: \"" + bad + "\"\n"}) {
        const InputError error = refusalOf(lines(before) + text + lines(3));
        EXPECT_EQ(error.line(), before + 1) << error.what();
        EXPECT_EQ(error.expected(), "YAML, in UTF-8");
      }
    }
  }
}

TEST(YamlDocument, ATextIsTheSameInUtf8WithAndWithoutItsMarkAndInUtf16) {
  const std::u16string wide = u"k\u00FCche: [\u2603, \"\u4E2D\"]\nb: c\n";
  const std::string text = "k\u00FCche: [\u2603, \"\u4E2D\"]\nb: c\n";
  const std::string content = contentOf(text);
  EXPECT_EQ(content, "{k\u00FCche:['\u2603','\u4E2D',],b:'c',}");
  EXPECT_EQ(contentOf("\xEF\xBB\xBF" + text), content);
  for (const bool big_endian : {false, true})
    EXPECT_EQ(contentOf(utf16(wide, big_endian)), content);
}

TEST(YamlDocument, LinesEndAsOnUnixWindowsAndOldMacs) {
  const std::string text = "a: 1\nb:\n  - x\n  - 'y\n    z'\nc: |\n  1\n  2\n";
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? std::string(end) : std::string(1, c);
    const YamlNode root = parseYaml(other, "");
    EXPECT_EQ(contentOf(root), contentOf(text));
    EXPECT_EQ(root.at("b").items()[1].line(), 4);
    EXPECT_EQ(root.at("c").line(), 6);
  }
}

TEST(YamlDocument, WordsForNothingAreThatWithoutQuotesOnly) {
  EXPECT_EQ(contentOf("[~, null, Null, NULL]").find('\''), std::string::npos);
  EXPECT_EQ(contentOf("['~', \"null\", nULL, nil]"), "['~','null','nULL','nil',]");
}

TEST(YamlDocument, ATagIsRefusedWhateverItStandsBefore) {
  for (const char* text : {"! 1", "! \"1\"", "!", "!!str", "!!str 1", "!x [1]", "!<y> {a: b}",
                           "!!set {a, b}", "&a !!int 1", "!!float &a 1"}) {
    const InputError error = refusalOf("a: 1\nb: " + std::string(text) + "\n");
    EXPECT_EQ(error.line(), 2) << text;
    EXPECT_TRUE(error.problem().starts_with("a tag (")) << error.what();
  }
}

// Each of its lists would hold ten of the one before.
TEST(YamlDocument, NamesDoNoHarmAndWhatUsesThemIsRefused) {
  EXPECT_EQ(contentOf("a: &x 1\nb: &y [&z 2]\n"), "{a:'1',b:['2',],}");
  std::string laughs = "a0: &a0 [ha]\n";
  for (int i = 1; i <= 20; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    laughs += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before;
    for (int j = 1; j < 10; ++j) laughs += ", " + before;
    laughs += "]\n";
  }
  EXPECT_STREQ(refusalOf(laughs).what(), "a.yaml:2: an alias (*name); expected the value itself");
  EXPECT_EQ(refusalOf("a: &x {b: 1}\nc:\n  <<: *x\n").line(), 3);
}

TEST(YamlDocument, TheVersionMayBeSaidAndNothingElseMay) {
  for (const char* version : {"1.1", "1.2"}) {
    EXPECT_EQ(contentOf("%YAML " + std::string(version) + "\n---\na: yes\n"), "{a:'yes',}");
  }
  for (const char* text :
       {"%YAML 2.0\n---\na: 1\n", "%YAML 1.2\na: 1\n", "%YAML 1.2\n%YAML 1.2\n---\n",
        "%PADDING x\n---\na: 1\n", "%TAG ! !\n---\na: !x 1\n"}) {
    EXPECT_LE(refusalOf(text).line(), 3) << text;
  }
}

TEST(YamlDocument, WhatFollowsAWholeDocumentIsAnother) {
  for (const char* text : {"a: 1\n--- b\n", "[1]\n[2]\n", "a # b\nc: 1\n", "--- 1\n--- 2\n--- 3\n",
                           "a\n--- !x y\n", "'a'\n'b'\n"}) {
    const InputError error = refusalOf(text);
    EXPECT_EQ(error.problem(), "a second document") << error.what();
    EXPECT_EQ(error.line(), 2) << text;
  }
  for (const char* text : {"a: 1\n...\n", "--- # x\na: 1\n", "---\na: 1\n...\n# end\n"}) {
    EXPECT_EQ(contentOf(text), "{a:'1',}");
  }
}

TEST(YamlDocument, WhatIsNotClosedIsToldWithWhereItBegan) {
  for (const char* open : {"'x", "\"x", "[1, 2", "{a: 1", "[[1], [2]"}) {
    const InputError error = refusalOf("a: 1\nb: " + std::string(open) + "\n\n\n");
    EXPECT_NE(error.problem().find("begins on line 2"), std::string::npos) << error.what();
    EXPECT_GT(error.line(), 2) << error.what();
  }
}

TEST(YamlDocument, ATabBehindADashIsNamedWithItsLine) {
  for (const char* text : {"a:\n-\tx\n", "a:\n - \t- x\n", "a:\n- -\t- x\n"}) {
    const InputError error = refusalOf(text);
    EXPECT_EQ(error.line(), 2) << text;
    EXPECT_EQ(error.problem(), "a tab before its text") << text;
  }
  EXPECT_EQ(contentOf("a:\t1\t# one\nb: [1,\t2,\n\t3]\n"), "{a:'1',b:['1','2','3',],}");
}

TEST(YamlDocument, AKeyGivenTwiceIsFoundAmongAnyNumber) {
  for (const int count : {1, 2, 17, 1000, 100'000}) {
    const InputError error = refusalOf(lines(count) + "key_1: again\n");
    EXPECT_EQ(error.line(), count + 1);
    EXPECT_EQ(error.problem(), "the key 'key_1' is given twice");
  }
  // The same key in another map is another.
  EXPECT_EQ(contentOf("a: {b: 1, c: {b: 2, a: 3}}\nb: [{b: 4}, {b: 5}]\n"),
            "{a:{b:'1',c:{b:'2',a:'3',},},b:[{b:'4',},{b:'5',},],}");
}

// Each doubles the work of a reader that looks at what is open again and again.
TEST(YamlDocument, NestingOfEveryKindIsRefusedBeforeItCosts) {
  constexpr int kDeep = 300'000;
  for (const char* part : {"[", "{a: ", "{? ", "- ", "? ", "[? ", "[{a: "}) {
    std::string text;
    for (int i = 0; i < kDeep; ++i) text += part;
    const std::string problem = refusalOf(text).problem();
    EXPECT_TRUE(problem == "nested too deeply" || problem == "a key that is a list or a map")
        << part << ": " << problem;
  }
  std::string stairs;
  for (int i = 0; i < 500; ++i) stairs += std::string(i, ' ') + "a:\n";
  EXPECT_EQ(refusalOf(stairs).problem(), "nested too deeply");
}

}  // namespace
}  // namespace amble
