// Small tools of base against the plainest way to the same answer, on drawn input.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "base/ease.h"
#include "base/guarded_run.h"
#include "base/parallel.h"
#include "base/sample_stream.h"
#include "base/statistics.h"
#include "base/strict_yaml.h"
#include "base/text.h"

namespace amble {
namespace {

std::vector<double> drawn(SampleStream& random, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(random.below(20) - 7.0);  // with many alike
  return values;
}

TEST(BruteForce, MediansAndQuantilesAreThoseOfTheSortedValues) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SampleStream random(seed, 1);
    const std::vector<double> values = drawn(random, 1 + random.below(30));
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const size_t n = sorted.size();
    EXPECT_EQ(median(values), 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]));
    EXPECT_EQ(upperMedian(values), sorted[n / 2]);
    EXPECT_EQ(quantile(values, 0.0), sorted.front());
    EXPECT_EQ(quantile(values, 1.0), sorted.back());
    double last = sorted.front();
    for (double share = 0.0; share <= 1.0; share += 0.05) {
      const double value = quantile(values, share);
      EXPECT_GE(value, last);
      last = value;
      const auto below =
          std::count_if(values.begin(), values.end(), [&](double other) { return other < value; });
      EXPECT_LE(below, share * static_cast<double>(n - 1) + 1e-9);
    }
    double sum = std::accumulate(values.begin(), values.end(), 0.0);
    EXPECT_NEAR(mean(values) * static_cast<double>(n), sum, 1e-9);
  }
}

// Slopes by differences: the begin and the end are at rest, and nothing goes back in between.
TEST(BruteForce, EasesRiseFromRestToRestAndTheirHalvesMirror) {
  constexpr double kStep = 1e-4;
  for (double (*const ease)(double) : {smoothstep, minimumJerk}) {
    EXPECT_EQ(ease(-3.0), 0.0);
    EXPECT_EQ(ease(0.0), 0.0);
    EXPECT_EQ(ease(1.0), 1.0);
    EXPECT_EQ(ease(7.0), 1.0);
    for (double t = 0.0; t < 1.0; t += 0.01) {
      EXPECT_GT(ease(t + 0.01), ease(t));
      EXPECT_NEAR(ease(t) + ease(1.0 - t), 1.0, 1e-12);
    }
    EXPECT_LT(ease(kStep) / kStep, 1e-3);
  }
  const double curvature = (minimumJerk(2 * kStep) - 2 * minimumJerk(kStep)) / (kStep * kStep);
  EXPECT_LT(std::abs(curvature), 1e-2);
}

TEST(BruteForce, NumbersComeBackFromTheirText) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SampleStream random(seed, 2);
    const double value = random.uniform(-1.0, 1.0) * std::pow(10.0, random.below(9) - 3);
    const int digits = random.below(8);
    const double half = 0.5 * std::pow(10.0, -digits) * (1.0 + 1e-9);
    for (const std::string& text : {fixedNumber(value, digits), plainNumber(value, digits)}) {
      const auto back = numberOf(text);
      ASSERT_TRUE(back) << text;
      EXPECT_NEAR(*back, value, half) << text;
      EXPECT_FALSE(text.starts_with("-0") && *back == 0.0) << text;
    }
    const long long whole = static_cast<long long>(random.bits());
    EXPECT_EQ(wholeNumberOf(std::to_string(whole)), whole);
  }
}

// Any bytes: what XML may hold stays, and nothing is done twice.
TEST(BruteForce, TextOfAnyBytesIsMadeGoodOnce) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SampleStream random(seed, 3);
    std::string bytes;
    for (int i = random.below(40); i > 0; --i) bytes += static_cast<char>(random.below(256));
    const std::string good = utf8Text(bytes);
    EXPECT_EQ(utf8Text(good), good);
    const std::string line = withoutControls(bytes);
    EXPECT_EQ(line.size(), bytes.size());
    EXPECT_EQ(withoutControls(line), line);
    for (size_t i = 0; i < line.size(); ++i) {
      const bool control = static_cast<unsigned char>(bytes[i]) < 0x20 || bytes[i] == 0x7F;
      EXPECT_EQ(line[i], control ? ' ' : bytes[i]);
    }
    const std::string_view inner = trimmed(bytes);
    EXPECT_TRUE(inner.empty() || (!isSpace(inner.front()) && !isSpace(inner.back())));
    EXPECT_NE(bytes.find(inner), bytes.npos);
  }
}

// Letters left out, added, changed or exchanged, by the definition: the shortest way over a table.
int distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<int>> table(a.size() + 1, std::vector<int>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i) {
    for (size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        table[i][j] = static_cast<int>(i + j);
        continue;
      }
      table[i][j] = std::min({table[i - 1][j] + 1, table[i][j - 1] + 1,
                              table[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
    }
  }
  return table[a.size()][b.size()];
}

TEST(BruteForce, TheNearestWordIsOneOfTheNearest) {
  const std::vector<std::string> words = {"start", "goal", "scene", "speed", "seed", "stride"};
  int meant = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    SampleStream random(seed, 4);
    std::string word = words[random.below(static_cast<int>(words.size()))];
    for (int slips = 1 + random.below(2); slips > 0 && !word.empty(); --slips) {
      const int at = random.below(static_cast<int>(word.size()));
      const char letter = static_cast<char>('a' + random.below(26));
      const int kind = random.below(3);
      if (kind == 0) word.erase(at, 1);
      if (kind == 1) word.insert(at, 1, letter);
      if (kind == 2) word[at] = letter;
    }
    int least = 100;
    for (const std::string& other : words) least = std::min(least, distance(word, other));
    const std::string found = nearestWord(word, words);
    if (found.empty()) continue;
    ++meant;
    // Exchanged letters may be counted as one slip.
    EXPECT_LE(distance(word, found), least + 1) << word << ' ' << found;
  }
  EXPECT_GE(meant, 300);
}

TEST(BruteForce, ALoopOnThreadsIsTheLoop) {
  for (const int count : {0, 1, 2, 63, 1000}) {
    std::vector<double> wanted(count), found(count);
    for (int i = 0; i < count; ++i) wanted[i] = std::sin(i) * i;
    for (const int threads : {1, 2, 5, 64}) {
      std::fill(found.begin(), found.end(), 0.0);
      parallelFor(count, threads, [&](int i, int) { found[i] = std::sin(i) * i; });
      EXPECT_EQ(found, wanted);
    }
  }
}

TEST(BruteForce, StreamsOfNeighboursShareNoNumbers) {
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t index = 0; index < 100; ++index) {
    SampleStream stream(5, index);
    for (int i = 0; i < 50; ++i) numbers.push_back(stream.bits());
  }
  std::sort(numbers.begin(), numbers.end());
  EXPECT_EQ(std::adjacent_find(numbers.begin(), numbers.end()), numbers.end());
}

TEST(BruteForce, GuardedWorkGivesWhatItWouldGiveUnguarded) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const auto work = [seed] {
      SampleStream random(seed, 6);
      std::string bytes;
      for (int i = random.below(5000); i > 0; --i) bytes += static_cast<char>(random.below(256));
      return bytes;
    };
    const GuardedAnswer answer = runGuarded(work);
    EXPECT_TRUE(answer.done());
    EXPECT_EQ(answer.bytes, work());
  }
}

// A document is drawn as a tree, written as YAML and walked again.
struct Tree {
  std::string text;         // of a leaf
  std::vector<Tree> items;  // of a list
  bool leaf() const { return items.empty(); }
};

Tree drawnTree(SampleStream& random, int depth) {
  Tree tree;
  if (depth == 0 || random.below(3) == 0) {
    tree.text = "v" + std::to_string(random.below(1000));
    return tree;
  }
  for (int i = 1 + random.below(3); i > 0; --i) tree.items.push_back(drawnTree(random, depth - 1));
  return tree;
}

std::string flow(const Tree& tree) {
  if (tree.leaf()) return tree.text;
  std::string text = "[";
  for (const Tree& item : tree.items) text += (text.size() > 1 ? ", " : "") + flow(item);
  return text + "]";
}

void expectRead(const YamlNode& node, const Tree& tree) {
  if (tree.leaf()) {
    EXPECT_EQ(node.asString(), tree.text);
    return;
  }
  ASSERT_TRUE(node.isSequence()) << node.path();
  ASSERT_EQ(node.size(), static_cast<int>(tree.items.size()));
  const std::vector<YamlNode> items = node.items();
  for (size_t i = 0; i < items.size(); ++i) expectRead(items[i], tree.items[i]);
}

TEST(BruteForce, ADocumentIsReadAsItWasDrawn) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SampleStream random(seed, 7);
    std::vector<Tree> trees;
    std::string text;
    for (int line = 0; line < 8; ++line) {
      trees.push_back(drawnTree(random, 4));
      text += "key" + std::to_string(line) + ": " + flow(trees.back()) + "\n";
    }
    const YamlNode root = parseYaml(text, "it.yaml");
    for (int line = 0; line < 8; ++line) {
      const YamlNode node = root.at("key" + std::to_string(line));
      EXPECT_EQ(node.line(), line + 1);
      expectRead(node, trees[line]);
    }
    EXPECT_FALSE(root["key8"]);
  }
}

}  // namespace
}  // namespace amble
