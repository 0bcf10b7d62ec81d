#include "base/output_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "base/error.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

/// A folder of this test's own, gone afterwards.
class OutputFile : public testing::Test {
 protected:
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::path(testing::TempDir()) / ("amble_output_file_" + name);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string read(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  int files() const { return static_cast<int>(std::distance(fs::directory_iterator(folder_), {})); }

  fs::path folder_;
};

TEST_F(OutputFile, RefusesAFolderThatIsNotThere) {
  EXPECT_THROW(writeFile(folder_ / "none" / "a.txt", [](std::ostream&) {}), InputError);
  EXPECT_EQ(files(), 0);
}

TEST_F(OutputFile, RefusesAFolderThatIsAFile) {
  writeFile(folder_ / "file", [](std::ostream& out) { out << "x"; });
  try {
    writeFile(folder_ / "file" / "a.txt", [](std::ostream&) {});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), (folder_ / "file" / "a.txt").string());
    EXPECT_NE(std::string(error.what()).find("Not a directory"), std::string::npos);
  }
}

TEST_F(OutputFile, RefusesToReplaceAFolder) {
  EXPECT_THROW(writeFile(folder_, [](std::ostream&) {}), InputError);
  EXPECT_TRUE(fs::is_directory(folder_));
}

TEST_F(OutputFile, NoticesAFullDisk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  try {
    writeFile("/dev/full", [](std::ostream& out) { out << std::string(1 << 20, 'x'); });
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos) << error.what();
  }
  // Few bytes, which only the flush writes.
  EXPECT_THROW(writeFile("/dev/full", [](std::ostream& out) { out << "x"; }), InputError);
}

TEST_F(OutputFile, LeavesTheOldFileWhenWritingFails) {
  const fs::path file = folder_ / "a.txt";
  writeFile(file, [](std::ostream& out) { out << "old"; });
  EXPECT_THROW(writeFile(file,
                         [](std::ostream& out) {
                           out << "half";
                           throw std::runtime_error("stopped");
                         }),
               std::runtime_error);
  EXPECT_THROW(writeFile(file, [](std::ostream& out) { out.setstate(std::ios::badbit); }),
               InputError);
  EXPECT_EQ(read(file), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFile, IsWholeAndAloneAfterwards) {
  const fs::path file = folder_ / "a.txt";
  for (const char* text : {"first", "second, longer", "3rd"}) {
    writeFile(file, [&](std::ostream& out) { out << text; });
    EXPECT_EQ(read(file), text);
    EXPECT_EQ(files(), 1);
  }
}

TEST_F(OutputFile, IsNotThereBeforeItIsWhole) {
  const fs::path file = folder_ / "a.txt";
  writeFile(file, [&](std::ostream& out) {
    out << "half" << std::flush;
    EXPECT_FALSE(fs::exists(file));
  });
  EXPECT_TRUE(fs::exists(file));
}

TEST_F(OutputFile, FilesThatBelongTogetherAreAllThereOrNone) {
  writeFile(folder_ / "a.txt", [](std::ostream& out) { out << "old"; });
  const auto good = [](std::ostream& out) { out << "new"; };
  const auto bad = [](std::ostream& out) { out.setstate(std::ios::badbit); };
  EXPECT_THROW(writeFiles({{folder_ / "a.txt", good}, {folder_ / "b.txt", bad}}), InputError);
  EXPECT_EQ(read(folder_ / "a.txt"), "old");
  EXPECT_EQ(files(), 1);
  EXPECT_THROW(writeFiles({{folder_ / "a.txt", good}, {folder_ / "none" / "b.txt", good}}),
               InputError);
  EXPECT_EQ(read(folder_ / "a.txt"), "old");
  writeFiles({{folder_ / "a.txt", good}, {folder_ / "b.txt", good}});
  EXPECT_EQ(read(folder_ / "a.txt"), "new");
  EXPECT_EQ(read(folder_ / "b.txt"), "new");
  EXPECT_EQ(files(), 2);
}

}  // namespace
}  // namespace amble
