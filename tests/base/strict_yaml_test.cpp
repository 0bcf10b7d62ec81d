#include "base/strict_yaml.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace amble {
namespace {

enum class Fruit { kApple, kPear };

/// What the error says that `read` throws of `text`; empty where it throws none.
template <typename Read>
std::string errorOf(const std::string& text, Read read) {
  try {
    read(parseYaml(text, "a.yaml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string errorOf(const std::string& text) {
  return errorOf(text, [](const YamlNode&) {});
}

TEST(StrictYaml, RefusesWhatIsNoYamlWithItsLine) {
  EXPECT_EQ(errorOf("a: 1\nb: [1, 2\n").rfind("a.yaml:", 0), 0u);
  EXPECT_EQ(errorOf("a: 1\n b: 2\n").rfind("a.yaml:2: ", 0), 0u) << errorOf("a: 1\n b: 2\n");
  EXPECT_EQ(errorOf(""), "a.yaml: is empty; expected YAML");
  EXPECT_EQ(errorOf("# nothing\n"), "a.yaml: is empty; expected YAML");
}

TEST(StrictYaml, RefusesADoubledKeyAtAnyDepth) {
  EXPECT_EQ(errorOf("a: 1\nb: 2\na: 3\n"),
            "a.yaml:3: the key 'a' is given twice; expected it once (it is on line 1 too)");
  EXPECT_EQ(errorOf("l:\n  - {x: 1}\n  - {y: 1, 'y': 2}\n"),
            "a.yaml:3: the key 'y' is given twice; expected it once (it is on line 3 too)");
}

TEST(StrictYaml, RefusesAliasesTagsAndSecondDocuments) {
  EXPECT_EQ(errorOf("a: &x 1\nb: *x\n"), "a.yaml:2: an alias (*name); expected the value itself");
  EXPECT_EQ(errorOf("a: !!float 1\n").rfind("a.yaml:1: a tag", 0), 0u);
  EXPECT_EQ(errorOf("a: 1\n---\nb: 2\n"),
            "a.yaml:3: a second document; expected one document a file");
}

TEST(StrictYaml, RefusesKeysThatAreNoNames) {
  EXPECT_EQ(errorOf("? [1, 2]\n: 3\n").rfind("a.yaml:1: a key that is a list or a map", 0), 0u);
  EXPECT_EQ(errorOf("~: 3\n").rfind("a.yaml:1: an empty key", 0), 0u);
}

TEST(StrictYaml, RefusesHostileNesting) {
  const auto nested = [](int depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(errorOf(nested(kMaxYamlDepth)), "");
  EXPECT_EQ(errorOf(nested(kMaxYamlDepth + 1)),
            "a.yaml:1: nested too deeply; expected at most 100 levels");
  EXPECT_NE(errorOf(std::string(1000000, '[')), "");
}

TEST(StrictYaml, RefusesMoreValuesThanAnyFileOfOursHas) {
  std::string list = "a:\n- [";
  for (size_t i = 0; i < kMaxYamlValues; ++i) list += i % 100 == 99 ? "1,\n  " : "1,";
  const std::string error = errorOf(list + "]\n");
  EXPECT_NE(error.find(": too many values; expected at most 2000000"), std::string::npos) << error;
}

TEST(StrictYaml, RefusesMissingFilesAndFolders) {
  EXPECT_THROW(readYaml("no/such/file.yaml"), InputError);
  EXPECT_THROW(readYaml("/dev/zero", {"a small file", 1000}), InputError);
  EXPECT_THROW(readYaml(std::filesystem::temp_directory_path()), InputError);
}

TEST(StrictYaml, NamesTheKeyThatWasMeant) {
  const auto read = [](const YamlNode& root) { root.at("s").requireKeys({"heading", "at"}); };
  EXPECT_EQ(errorOf("s:\n  at: 1\n  headnig: 2\n", read),
            "a.yaml:3: unknown key 'headnig' in s; expected 'heading'");
  EXPECT_EQ(errorOf("s:\n  colour:\n    red\n", read),
            "a.yaml:2: unknown key 'colour' in s; expected heading or at");
}

TEST(StrictYaml, NamesTheKeyThatIsMissing) {
  EXPECT_EQ(errorOf("a: 1\n", [](const YamlNode& root) { root.at("goal"); }),
            "a.yaml:1: the key 'goal' is missing; expected 'goal:' and its value");
  EXPECT_EQ(errorOf("a:\n  b: 1\n", [](const YamlNode& root) { root.at("a").at("c"); }),
            "a.yaml:2: a: the key 'c' is missing; expected 'c:' and its value");
}

TEST(StrictYaml, TakesDecimalNumbersOnly) {
  const auto read = [](const YamlNode& root) { return root.at("n").asDouble(); };
  for (const char* good : {"0", "-0", "1", "+1.5", "-.5", "5.", "1e3", "1.25E-2", "0.010"}) {
    EXPECT_EQ(read(parseYaml(std::string("n: ") + good, "a.yaml")), std::strtod(good, nullptr));
  }
  for (const char* bad : {"010", "0x10", "0o10", "1_000", ".inf", ".nan", "inf", "nan", "1e999",
                          "1,5", "'1'", "yes", "1 m", "--1", ".", "1e", "", "[1]", "{a: 1}"}) {
    EXPECT_EQ(errorOf(std::string("n: ") + bad, read).rfind("a.yaml:1: n is ", 0), 0u) << bad;
  }
}

TEST(StrictYaml, ChecksRangesWithTheirEnds) {
  const auto read = [](const YamlNode& root) { root.at("h").asDouble(0.5, 2.5, "height [m]"); };
  EXPECT_EQ(errorOf("h: 0.5", read), "");
  EXPECT_EQ(errorOf("h: 2.5", read), "");
  EXPECT_EQ(errorOf("h: 2.6", read), "a.yaml:1: h is '2.6'; expected height [m] from 0.5 to 2.5");
  EXPECT_EQ(errorOf("h: tall", read),
            "a.yaml:1: h is 'tall'; expected height [m] from 0.5 to 2.5, a number");
  const auto positive = [](const YamlNode& root) { root.at("h").asPositive("radius [m]"); };
  EXPECT_EQ(errorOf("h: 0", positive), "a.yaml:1: h is '0'; expected radius [m] above 0");
}

TEST(StrictYaml, TakesWholeNumbersAndTruthValuesAsTheyAre) {
  const auto whole = [](const YamlNode& root) { root.at("n").asInt(1, 10, "threads"); };
  EXPECT_EQ(errorOf("n: 10", whole), "");
  for (const char* bad : {"1.0", "1e1", "011", "0", "11", "99999999999", "two"}) {
    EXPECT_NE(errorOf(std::string("n: ") + bad, whole), "") << bad;
  }
  const auto truth = [](const YamlNode& root) { root.at("n").asBool(); };
  EXPECT_TRUE(parseYaml("n: true", "").at("n").asBool());
  EXPECT_FALSE(parseYaml("n: false", "").at("n").asBool());
  for (const char* bad : {"yes", "no", "on", "True", "1", "'true'", ""}) {
    EXPECT_NE(errorOf(std::string("n: ") + bad, truth), "") << bad;
  }
}

TEST(StrictYaml, CountsTheNumbersOfAVector) {
  EXPECT_EQ(parseYaml("[1, -2, 0.5]", "").asVec(3), Eigen::Vector3d(1, -2, 0.5));
  const auto read = [](const YamlNode& root) { root.at("at").asVec2("coordinates [m]"); };
  EXPECT_EQ(errorOf("at: [1]", read),
            "a.yaml:1: at is a list of 1; expected 2 coordinates [m] in brackets");
  EXPECT_EQ(errorOf("at:\n  - 1\n  - x\n", read), "a.yaml:3: at[1] is 'x'; expected number");
}

TEST(StrictYaml, NamesTheChoicesOfAnEnumeration) {
  const auto read = [](const YamlNode& root) {
    return root.at("f").asEnum<Fruit>({{"apple", Fruit::kApple}, {"pear", Fruit::kPear}});
  };
  EXPECT_EQ(read(parseYaml("f: pear", "")), Fruit::kPear);
  EXPECT_EQ(errorOf("f: paer", read), "a.yaml:1: f is 'paer'; expected 'pear'");
  EXPECT_EQ(errorOf("f: nut", read), "a.yaml:1: f is 'nut'; expected apple or pear");
}

TEST(StrictYaml, ATabThatIndentsIsNamedWithItsLine) {
  for (const char* text :
       {"a: 1\nb:\n\tc: 1\n", "a: 1\nb:\n \tc: 1\n\td: 2\n", "a: 1\nb:\n\t- 1\n\t- 2\n"}) {
    try {
      parseYaml(text, "tab.yaml");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.line(), 3) << text << error.what();
      EXPECT_NE(error.problem().find("a tab"), std::string::npos) << error.what();
    }
  }
}

TEST(StrictYaml, AFaultBesideTabsThatDoNoHarmIsNotBlamedOnThem) {
  try {
    parseYaml("a: [1,\n\t2]\nb: 1\nc: [1\n", "tab.yaml");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem().find("a tab"), std::string::npos) << error.what();
  }
}

TEST(StrictYaml, KeepsTheOrderOfTheFile) {
  const YamlNode root = parseYaml("z: 1\na: 2\nm: 3\n", "");
  std::string keys;
  for (const auto& [key, value] : root.entries()) keys += key + value.asString();
  EXPECT_EQ(keys, "z1a2m3");
}

TEST(StrictYaml, NodesOutliveTheirDocument) {
  YamlNode inner;
  EXPECT_FALSE(inner);
  { inner = parseYaml("a: {b: [1, {c: deep}]}", "").at("a").at("b").items()[1].at("c"); }
  EXPECT_EQ(inner.asString(), "deep");
  EXPECT_EQ(inner.path(), "a.b[1].c");
}

TEST(StrictYaml, PathsAreRelativeToTheFileThatNamesThem) {
  const YamlNode root = parseYaml("p: ../x/y.bvh\nq: /abs.bvh\n", "dir/sub/a.yaml");
  EXPECT_EQ(root.at("p").asPath(), "dir/x/y.bvh");
  EXPECT_EQ(root.at("q").asPath(), "/abs.bvh");
}

TEST(StrictYaml, AMissingKeyIsNothingAndAnEmptyOneIsNull) {
  const YamlNode root = parseYaml("a:\n", "");
  EXPECT_TRUE(root["a"].isNull());
  EXPECT_FALSE(root["b"]);
}

TEST(NearestWord, FindsSlipsAndNothingElse) {
  const std::vector<std::string> words = {"start", "goal", "scene"};
  EXPECT_EQ(nearestWord("strat", words), "start");
  EXPECT_EQ(nearestWord("gaol", words), "goal");
  EXPECT_EQ(nearestWord("secne", words), "scene");
  EXPECT_EQ(nearestWord("walk", words), "");
  EXPECT_EQ(nearestWord("", words), "");
}

}  // namespace
}  // namespace amble
