#include "base/yaml_writer.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "base/strict_yaml.h"
#include "base/text.h"

namespace amble {
namespace {

using Generator = std::mt19937_64;

int below(Generator& generator, int end) {
  return std::uniform_int_distribution<int>(0, end - 1)(generator);
}

/// What `write` writes, a document.
template <typename Write>
std::string written(const Write& write) {
  std::ostringstream text;
  YamlWriter out(text);
  write(out);
  return text.str() + '\n';
}

/// Characters of all lengths, and many of those that mean something to a reader of YAML.
std::string randomText(Generator& generator) {
  constexpr std::string_view kMarks[] = {
      " ",      "  ",     ":",      ": ",     "#",      " #",   "-",    "- ",   "?",
      ",",      "[",      "]",      "{",      "}",      "'",    "\"",   "\\",   "|",
      ">",      "&",      "*",      "!",      "%",      "@",    "`",    "\n",   "\t",
      "\r",     "~",      "=",      "<<",     "---",    "...",  "0",    "1.5",  "e3",
      "x",      "abc",    "é",      "☃",      "😀",      "yes",  "null", "\x01", "\x7F",
      "\u0085", "\u00A0", "\u2028", "\u2029", "\uFEFF", "true", "0x1F", "1:30"};
  std::string text;
  for (int i = below(generator, 6); i >= 0; --i) {
    text += kMarks[below(generator, std::size(kMarks))];
  }
  return text;
}

struct Tree {
  enum Kind { kText, kWhole, kList, kMap } kind = kText;
  std::string text;
  int number = 0;
  std::vector<std::pair<std::string, Tree>> children;  // of a list, without their names
};

Tree randomTree(Generator& generator, int depth) {
  Tree tree;
  tree.kind = depth == 0 ? (below(generator, 2) ? Tree::kText : Tree::kWhole)
                         : static_cast<Tree::Kind>(below(generator, 4));
  tree.number = below(generator, 2000) - 1000;
  tree.text = randomText(generator);
  if (tree.kind < Tree::kList) return tree;
  for (int i = below(generator, 5); i > 0; --i) {
    // Its number makes it another than the others.
    std::string name = randomText(generator) + std::to_string(i);
    tree.children.emplace_back(std::move(name), randomTree(generator, depth - 1));
  }
  return tree;
}

void writeTree(YamlWriter& out, const Tree& tree, Generator& generator) {
  const auto style = below(generator, 3) == 0 ? YamlWriter::kFlow : YamlWriter::kBlock;
  switch (tree.kind) {
    case Tree::kText:
      below(generator, 2) ? out.text(tree.text) : out.quoted(tree.text);
      return;
    case Tree::kWhole:
      out.whole(tree.number);
      return;
    case Tree::kList:
      out.beginList(style);
      for (const auto& child : tree.children) writeTree(out, child.second, generator);
      break;
    case Tree::kMap:
      out.beginMap(style);
      for (const auto& [name, child] : tree.children) writeTree(out.key(name), child, generator);
      break;
  }
  out.end();
}

void expectSame(const YamlNode& node, const Tree& tree) {
  if (tree.kind == Tree::kWhole) {
    EXPECT_EQ(node.asInt(-1000, 1000), tree.number);
    return;
  }
  if (tree.kind == Tree::kText) {
    ASSERT_TRUE(node.isScalar()) << tree.text;
    EXPECT_EQ(node.asString(), tree.text);
    EXPECT_THROW(node.asDouble(), InputError) << tree.text;
    EXPECT_THROW(node.asBool(), InputError) << tree.text;
    return;
  }
  ASSERT_EQ(node.isMap(), tree.kind == Tree::kMap);
  ASSERT_EQ(node.size(), static_cast<int>(tree.children.size()));
  for (size_t i = 0; i < tree.children.size(); ++i) {
    if (node.isMap()) {
      EXPECT_EQ(node.entries()[i].first, tree.children[i].first);
    }
    expectSame(node.isMap() ? node.entries()[i].second : node.items()[i], tree.children[i].second);
  }
}

TEST(YamlWriter, WhatIsWrittenIsReadAsItWas) {
  Generator generator(1);
  for (int trial = 0; trial < 3000; ++trial) {
    const Tree tree = randomTree(generator, below(generator, 5));
    const std::string text = written([&](YamlWriter& out) { writeTree(out, tree, generator); });
    SCOPED_TRACE(text);
    ASSERT_NO_THROW(expectSame(parseYaml(text, "w.yaml"), tree));
    if (HasFailure()) break;
  }
}

// Bytes that are no UTF-8 are marked, and the others stay.
TEST(YamlWriter, TextsOfAnyBytesGiveAFileThatIsRead) {
  Generator generator(2);
  for (int trial = 0; trial < 3000; ++trial) {
    std::string bytes;
    for (int i = below(generator, 12); i >= 0; --i) {
      bytes += static_cast<char>(below(generator, 3) ? below(generator, 256)
                                                     : 0xC0 + below(generator, 64));
    }
    const std::string text = written([&](YamlWriter& out) {
      out.beginMap().key(bytes).text(bytes);
      out.key("list").beginList(YamlWriter::kFlow).text(bytes).quoted(bytes).end().end();
    });
    const YamlNode root = parseYaml(text, "w.yaml");
    const std::string read = root.entries()[0].second.asString();
    EXPECT_EQ(root.entries()[0].first, read);
    for (const YamlNode& item : root.at("list").items()) EXPECT_EQ(item.asString(), read);
    // Without controls, which XML may not hold, they are what XML makes of them.
    EXPECT_EQ(utf8Text(withoutControls(read)).size(), utf8Text(withoutControls(bytes)).size())
        << text;
  }
}

TEST(YamlWriter, ATextThatLooksLikeAValueStandsInQuotes) {
  for (const char* text : {"1",
                           "-1.5",
                           "1e3",
                           ".5",
                           "0x1F",
                           "0o17",
                           "1_000",
                           "12:30:45",
                           "07_12",
                           "2001-12-14",
                           "2001-12-14T21:59:43.10-05:00",
                           "yes",
                           "No",
                           "ON",
                           "true",
                           "False",
                           "y",
                           "~",
                           "null",
                           "",
                           ".inf",
                           "-.INF",
                           ".NaN",
                           "<<",
                           "=",
                           "+1"}) {
    EXPECT_EQ(written([&](YamlWriter& out) { out.text(text); }), "\"" + std::string(text) + "\"\n");
  }
  for (const char* text : {"walk", "Left Foot", "mixamorig:Hips", "a/b-c_d.bvh", "07_12.bvh",
                           "it's", "50 %", "a#b", "nothing", "yesterday", "x=1", "-a", "é"}) {
    EXPECT_EQ(written([&](YamlWriter& out) { out.text(text); }), std::string(text) + "\n");
  }
}

TEST(YamlWriter, EachEntryHasItsLineTwoBlanksFurtherInAndFlowHasOne) {
  const std::string text = written([](YamlWriter& out) {
    out.beginMap().key("a").whole(1);
    out.key("list").beginList();
    out.beginMap().key("b").text("c").key("d").beginMap().key("e").truth(true).end().end();
    out.beginList(YamlWriter::kFlow).plain("0.5").beginMap().key("f").text("g, h").end().end();
    out.text("i, j").end();
    out.key("none").beginList().end();
    out.key("nor").beginMap(YamlWriter::kFlow).end().end();
  });
  EXPECT_EQ(text,
            "a: 1\n"
            "list:\n"
            "  - b: c\n"
            "    d:\n"
            "      e: true\n"
            "  - [0.5, {f: \"g, h\"}]\n"
            "  - i, j\n"
            "none:\n"
            "  []\n"
            "nor: {}\n");
}

}  // namespace
}  // namespace amble
