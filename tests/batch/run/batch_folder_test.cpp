// Where a batch writes.

#include "batch/run/batch_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "base/error.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

const std::string kKey = "3f2a9c0b1d4e5f60";

class BatchFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(testing::TempDir()) /
            ("batch-folder-" +
             std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  static void writeRow(const fs::path& folder, const std::string& text = "row") {
    std::ofstream(folder / "row.json") << text;
  }
  std::set<std::string> files() const {
    std::set<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(root_))
      if (entry.is_regular_file()) found.insert(fs::relative(entry.path(), root_).string());
    return found;
  }

  fs::path root_;
};

TEST_F(BatchFolderTest, WhatCannotBeWrittenLeavesNoName) {
  const BatchFolder folder(root_);
  EXPECT_THROW(
      folder.make(kKey, [](const fs::path&) { throw InputError("row.json", 0, "disk is full"); }),
      InputError);
  EXPECT_FALSE(folder.has(kKey));
}

TEST_F(BatchFolderTest, TwoWhoMakeOneWalkAtOnceDoNotDisturbEachOther) {
  const BatchFolder folder(root_), other(root_);
  folder.make(kKey, [&](const fs::path& first) {
    std::ofstream(first / "walk.bvh") << "bvh";
    other.make(kKey, [&](const fs::path& second) {
      EXPECT_NE(first, second);
      std::ofstream(second / "walk.bvh") << "bvh";
      writeRow(second);
    });
    EXPECT_TRUE(fs::exists(first / "walk.bvh"));
    writeRow(first);
  });
  const std::string name = BatchFolder::nameOf(kKey).string();
  EXPECT_EQ(files(), (std::set<std::string>{name + "/row.json", name + "/walk.bvh"}));
}

TEST_F(BatchFolderTest, WhoIsSweptAwayWhenAnotherHasMadeTheWalkHasNotFailed) {
  const BatchFolder folder(root_), other(root_);
  folder.make(kKey, [&](const fs::path& beside) {
    other.make(kKey, [](const fs::path& second) { writeRow(second); });
    other.sweep([](const std::string&) { return true; });
    EXPECT_FALSE(fs::exists(beside));
    throw InputError(beside.string(), 0, "cannot be written");
  });
  EXPECT_TRUE(folder.has(kKey));
}

TEST_F(BatchFolderTest, SweepingTakesWhatIsUnfinishedAndWhatIsNotWanted) {
  const BatchFolder folder(root_);
  const std::string unwanted = "3fffffffffffffff";
  for (const std::string& key : {kKey, unwanted})
    folder.make(key, [](const fs::path& beside) { writeRow(beside); });
  fs::create_directories(folder.folderOf(kKey).string() + ".part-another-host-1-0");
  EXPECT_EQ(folder.sweep([](const std::string& key) { return key == kKey; }), 1);
  EXPECT_EQ(files(), std::set<std::string>{BatchFolder::nameOf(kKey).string() + "/row.json"});
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.walks() / "3f"), {}), 1);
}

}  // namespace
}  // namespace amble
