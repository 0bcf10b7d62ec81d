// What holds of small tools of base for any input: what they do to numbers that are moved, turned,
// reordered or cut up.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/base64.h"
#include "base/cubic_spline.h"
#include "base/ease.h"
#include "base/parts.h"
#include "base/range_maximum.h"
#include "base/rotation.h"
#include "base/sample_stream.h"
#include "base/sha256.h"
#include "base/statistics.h"
#include "base/text.h"
#include "base/union_find.h"

namespace amble {
namespace {

std::vector<double> drawnNumbers(SampleStream& random, int count) {
  std::vector<double> values(count);
  for (double& value : values) value = random.uniform(-5.0, 5.0);
  return values;
}

TEST(BaseLaws, MiddlesGoAlongWithValuesThatAreMovedScaledOrReordered) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SampleStream random(seed, 11);
    const std::vector<double> values = drawnNumbers(random, 1 + random.below(20));
    const double by = random.uniform(-9, 9), times = random.uniform(0.1, 4.0);
    std::vector<double> other(values.rbegin(), values.rend());
    for (double& value : other) value = times * value + by;
    EXPECT_NEAR(mean(other), times * mean(values) + by, 1e-12);
    EXPECT_NEAR(median(other), times * median(values) + by, 1e-12);
    EXPECT_NEAR(upperMedian(other), times * upperMedian(values) + by, 1e-12);
    for (const double share : {0.0, 0.3, 0.9, 1.0})
      EXPECT_NEAR(quantile(other, share), times * quantile(values, share) + by, 1e-12);
    std::vector<double> minus = values;
    for (double& value : minus) value = -value;
    EXPECT_EQ(median(minus), -median(values));
    EXPECT_LE(quantile(values, 0.0), mean(values) + 1e-12);
    EXPECT_GE(quantile(values, 1.0), mean(values) - 1e-12);
  }
}

TEST(BaseLaws, TheGreatestOfARunIsThatOfItsTwoParts) {
  SampleStream random(1, 12);
  for (int n = 0; n < 60; ++n) {
    const int count = 2 + random.below(70);
    const RangeMaximum maximum(drawnNumbers(random, count));
    for (int k = 0; k < 40; ++k) {
      const int a = random.below(count), b = random.below(count);
      const int first = std::min(a, b), last = std::max(a, b);
      const int cut = first + random.below(last - first + 1);
      EXPECT_EQ(
          maximum.over(first, last),
          std::max(maximum.over(first, cut), maximum.over(cut + 1 <= last ? cut + 1 : cut, last)));
    }
  }
}

TEST(BaseLaws, SetsDoNotDependOnTheOrderInWhichTheyAreJoined) {
  SampleStream random(2, 13);
  for (int n = 0; n < 60; ++n) {
    const int count = 1 + random.below(40);
    std::vector<std::pair<int, int>> joins;
    for (int i = 0; i < count; ++i) joins.emplace_back(random.below(count), random.below(count));
    UnionFind forth(count), back(count);
    int sets = count;
    for (const auto& [a, b] : joins) sets -= forth.join(a, b);
    for (auto join = joins.rbegin(); join != joins.rend(); ++join)
      back.join(join->second, join->first);
    int roots = 0;
    for (int i = 0; i < count; ++i) {
      EXPECT_EQ(forth.find(i), back.find(i));
      EXPECT_LE(forth.find(i), i);
      roots += forth.find(i) == i;
    }
    EXPECT_EQ(roots, sets);  // each join of two leaves one less
  }
}

TEST(BaseLaws, PartsAreTheFewestThatAreShortEnough) {
  SampleStream random(3, 14);
  for (int n = 0; n < 2000; ++n) {
    const double length = random.uniform(0.0, 20.0), longest = random.uniform(0.01, 3.0);
    const int parts = partsOf(length, longest);
    EXPECT_LE(length / parts, longest * (1.0 + 1e-6));
    if (parts > 1) {
      EXPECT_GT(length / (parts - 1), longest);
    }
    EXPECT_LE(parts, partsOf(length + 0.5, longest));
    EXPECT_GE(parts, partsOf(length, longest + 0.1));
  }
}

// By differences on both sides of every joint and end.
TEST(BaseLaws, EasesHaveSlopesWithoutJumpsAndAreSteepestHalfWay) {
  constexpr double kStep = 1e-5;
  for (double (*const ease)(double) : {smoothstep, minimumJerk}) {
    const auto slope = [&](double t) { return (ease(t + kStep) - ease(t - kStep)) / (2 * kStep); };
    for (double t = -0.1; t < 1.1; t += 0.001) {
      EXPECT_LT(std::abs(slope(t + 0.001) - slope(t)), 0.01) << t;
      EXPECT_GE(slope(t), -1e-9);
      EXPECT_LE(slope(t), slope(0.5) + 1e-9);
    }
  }
}

TEST(BaseLaws, ASplineIsLinearInItsHeightsAndGoesAlongWithItsPlaces) {
  SampleStream random(4, 15);
  for (int n = 0; n < 60; ++n) {
    const int count = 2 + random.below(8);
    std::vector<double> x = {random.uniform(-3, 3)};
    while (static_cast<int>(x.size()) < count) x.push_back(x.back() + random.uniform(0.2, 1.5));
    const std::vector<double> y = drawnNumbers(random, count), z = drawnNumbers(random, count);
    std::vector<double> sum = y, farther = x;
    for (int i = 0; i < count; ++i) sum[i] += 2.0 * z[i];
    for (double& at : farther) at += 7.5;
    const CubicSpline a(x, y, 0.3, -1.0), b(x, z, 0.5, 2.0), both(x, sum, 1.3, 3.0),
        moved_on(farther, y, 0.3, -1.0);
    for (double t = 0.0; t <= 1.0; t += 0.05) {
      const double at = x.front() + t * (x.back() - x.front());
      EXPECT_NEAR(both.at(at), a.at(at) + 2.0 * b.at(at), 1e-10);
      EXPECT_NEAR(moved_on.at(at + 7.5), a.at(at), 1e-10);
      EXPECT_NEAR(moved_on.slope(at + 7.5), a.slope(at), 1e-9);
    }
  }
}

TEST(BaseLaws, OneBitOfTheInputChangesAboutHalfOfADigest) {
  SampleStream random(5, 16);
  std::string bytes;
  for (int i = 0; i < 200; ++i) bytes += static_cast<char>(random.below(256));
  const std::string digest = sha256(bytes);
  EXPECT_EQ(digest.size(), 64u);
  for (int n = 0; n < 100; ++n) {
    std::string other = bytes;
    other[random.below(200)] ^= static_cast<char>(1 << random.below(8));
    const std::string changed = sha256(other);
    int same = 0;
    for (size_t i = 0; i < 64; ++i) same += digest[i] == changed[i];
    EXPECT_LT(same, 20);  // 4 of 64 are expected
  }
}

// Six bits a letter, by hand.
TEST(BaseLaws, Base64IsTheBytesSixBitsAtATime) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SampleStream random(seed, 17);
    std::string bytes, back;
    for (int i = random.below(40); i > 0; --i) bytes += static_cast<char>(random.below(256));
    const std::string coded = base64(bytes);
    EXPECT_EQ(coded.size(), (bytes.size() + 2) / 3 * 4);
    unsigned bits = 0;
    int held = 0;
    for (const char c : coded) {
      if (c == '=') break;
      bits = bits << 6 | static_cast<unsigned>(letters.find(c));
      held += 6;
      if (held < 8) continue;
      held -= 8;
      back += static_cast<char>(bits >> held & 0xFF);
    }
    EXPECT_EQ(back, bytes);
  }
}

TEST(BaseLaws, RotationVectorsTurnWithWhatTheyTurn) {
  SampleStream random(6, 18);
  const auto vector = [&](double most) {
    return Eigen::Vector3d(random.uniform(-most, most), random.uniform(-most, most),
                           random.uniform(-most, most));
  };
  for (int n = 0; n < 300; ++n) {
    const Eigen::Vector3d v = vector(1.7);
    const Eigen::Quaterniond q = expRotation(vector(2.0));
    EXPECT_LT(expRotation(q * v).angularDistance(q * expRotation(v) * q.inverse()), 1e-7);
    EXPECT_LT((logRotation(expRotation(v).inverse()) + logRotation(expRotation(v))).norm(), 1e-9);
    EXPECT_LT((expRotation(v) * v - v).norm(), 1e-12);
    EXPECT_LT(expRotation(0.5 * v).angularDistance(expRotation(-0.5 * v) * expRotation(v)), 1e-7);
  }
}

TEST(BaseLaws, PartsThatAreJoinedAreSplitAgainOneByOne) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SampleStream random(seed, 19);
    std::vector<std::string> parts;
    for (int i = 1 + random.below(6); i > 0; --i)
      parts.push_back("v" + std::to_string(random.below(999)));
    const std::string text = joined(parts, "::");
    std::string_view rest = text;
    for (size_t i = 0; i + 1 < parts.size(); ++i) {
      const auto two = splitAt(rest, "::");
      ASSERT_TRUE(two);
      EXPECT_EQ(two->first, parts[i]);
      rest = two->second;
    }
    EXPECT_EQ(rest, parts.back());
    EXPECT_FALSE(splitAt(rest, "::"));
  }
}

}  // namespace
}  // namespace amble
