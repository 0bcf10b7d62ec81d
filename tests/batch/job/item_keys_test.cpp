// Keys of walks: the same where all that decides a walk is the same, and only there.

#include <algorithm>
#include <numeric>

#include "tests/batch/small_job.h"

namespace amble {
namespace {

using ItemKeys = SmallJob;

constexpr const char* kPlain =
    "scenes:\n"
    "  - scene: scene.yaml\n"
    "    bounds: {min: [0, 0], max: [6, 3]}\n"
    "    ways: [{name: there, start: {at: [0.8, 1.5]}, via: [{at: [1, 1]}], goal: {at: [2, 1]}}]\n"
    "heights: [1.7]\n"
    "speeds: [1.1]\n"
    "seeds: [7]\n"
    "fps: 30\n"
    "walk: {comfort: 0.1}\n"
    "planner: {name: prm, max_failures: 90}\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST_F(ItemKeys, WhatDecidesAWalkIsInItsKey) {
  const auto keyOf = [&](const std::string& text) {
    const BatchJob walks = job(text);
    return keysOfItems(walks, listItems(walks), {}).at(0);
  };
  const std::string plain = keyOf(kPlain);
  EXPECT_EQ(keyOf(kPlain), plain);
  EXPECT_EQ(plain.size(), 16u);
  std::set<std::string> keys = {plain};
  const std::vector<std::pair<const char*, const char*>> changes = {
      {"at: [0.8, 1.5]", "at: [0.8, 1.5000000001]"},
      {"at: [0.8, 1.5]", "at: [0.8, 1.5], heading: 0"},
      {"at: [0.8, 1.5]", "at: [0.8, 1.5], heading: 90"},
      {"goal: {at: [2, 1]}", "goal: {at: [2, 1.1]}"},
      {"via: [{at: [1, 1]}], ", ""},
      {"via: [{at: [1, 1]}]", "via: [{at: [1, 1]}, {at: [1.5, 1]}]"},
      {"name: there", "name: here"},
      {"max: [6, 3]", "max: [6, 2.9]"},
      {"    bounds: {min: [0, 0], max: [6, 3]}\n", ""},
      {"[1.7]", "[1.71]"},
      {"[1.1]", "[1.2]"},
      {"[7]", "[8]"},
      {"fps: 30", "fps: 60"},
      {"fps: 30", "fps: 30\nformats: [bvh]"},
      {"comfort: 0.1", "comfort: 0.2"},
      {"comfort: 0.1", "comfort: 0.1, from: walking"},
      {"comfort: 0.1", "comfort: 0.1, to: walking"},
      {"prm", "rrt"},
      {"90", "91"},
      {"90", "90, time_limit: 5"},
      {"90", "90, roadmap: shared"}};
  for (const auto& [from, to] : changes)
    EXPECT_TRUE(keys.insert(keyOf(with(kPlain, from, to))).second) << to;
}

TEST_F(ItemKeys, WhereAndBesideWhatAJobStandsIsInNoKey) {
  const auto keyOf = [&](const BatchJob& walks, size_t item) {
    return keysOfItems(walks, listItems(walks), {}).at(item);
  };
  const std::string plain = keyOf(job(kPlain), 0);
  // Another job's file, of more walks, in another order.
  const std::string more =
      with(with(kPlain, "seeds: [7]", "seeds: [9, 7]"), "heights: [1.7]", "heights: [1.7, 1.8]");
  const BatchJob two = job(more);
  const std::vector<std::string> keys = keysOfItems(two, listItems(two), {});
  EXPECT_EQ(keys.size(), 4u);
  EXPECT_EQ(std::count(keys.begin(), keys.end(), plain), 1);
  // The order of formats, which are the default ones.
  EXPECT_EQ(keyOf(job(std::string(kPlain) + "formats: [json, labels, bvh]\n"), 0), plain);
  // The seed of samples that are not drawn.
  EXPECT_EQ(keyOf(job(std::string(kPlain) + "seed: 5\n"), 0), plain);
  // The same files in another folder.
  write("elsewhere/scene.yaml", kScene);
  EXPECT_EQ(keyOf(readBatchJob(write("elsewhere/other-name.yaml", kPlain), {"bvh", "json"}), 0),
            plain);
}

TEST_F(ItemKeys, AreThoseOfTheBytesOfAScene) {
  const BatchJob walks = job(kPlain);
  const auto key = [&] { return keysOfItems(walks, listItems(walks), {}).at(0); };
  const std::string plain = key();
  write("scene.yaml", std::string(kScene) + "# a comment\n");
  const std::string commented = key();
  EXPECT_NE(commented, plain);
  write("scene.yaml", kScene);
  EXPECT_EQ(key(), plain);
  write("scene.yaml", "objects: 3\n");
  const std::string wrong = key();
  EXPECT_NE(wrong, plain);
  write("scene.yaml", "objects: {}\n");
  EXPECT_NE(key(), wrong) << "what is wrong is another thing";
}

// Drawn ways are of the job's seed, and how far they are to lead.
TEST_F(ItemKeys, OfDrawnWaysHoldWhatTheyAreDrawnBy) {
  const auto keysOf = [&](const std::string& more) {
    const BatchJob walks = job("scenes: [scene.yaml]\n" + more);
    const auto keys = keysOfItems(walks, listItems(walks), {});
    return std::set<std::string>(keys.begin(), keys.end());
  };
  const auto plain = keysOf("ways: {draw: 3}\n");
  EXPECT_EQ(plain.size(), 3u);
  for (const char* other : {"ways: {draw: 3}\nseed: 2\n", "ways: {draw: 3, least: 2.5}\n",
                            "ways: {draw: 3, most: 4}\n", "ways: {draw: 3}\nheights: [1.9]\n"}) {
    for (const std::string& key : keysOf(other)) EXPECT_FALSE(plain.contains(key)) << other;
  }
  const auto more = keysOf("ways: {draw: 5}\n");
  EXPECT_TRUE(std::includes(more.begin(), more.end(), plain.begin(), plain.end()));
}

TEST_F(ItemKeys, AreFoundTheSameForItemsInAnyCompany) {
  const BatchJob walks = twoRooms("seeds: [1, 2]\nheights: [1.6, 1.8]\n");
  const std::vector<BatchItem> items = listItems(walks);
  const std::vector<std::string> all = keysOfItems(walks, items, {});
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), items.size());
  std::vector<BatchItem> some;
  for (size_t i = 0; i < items.size(); i += 3) some.push_back(items[i]);
  const std::vector<std::string> keys = keysOfItems(walks, some, {});
  for (size_t i = 0; i < some.size(); ++i) EXPECT_EQ(keys[i], all[3 * i]);
}

TEST_F(ItemKeys, ADescriptionHasALineForEachThingAndNoOther) {
  const BatchJob walks = job(kPlain);
  BatchItem item = listItems(walks).at(0);
  const std::string text = describeItem(walks, item, "scene\nseed 9", "library");
  std::set<std::string> heads;
  size_t lines = 0;
  for (size_t at = 0; at < text.size(); at = text.find('\n', at) + 1, ++lines)
    heads.insert(text.substr(at, text.find(' ', at) - at));
  EXPECT_EQ(heads.size(), lines) << "no name with a line's end makes a line of another thing";
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), static_cast<long>(lines));
}

}  // namespace
}  // namespace amble
