#include "base/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>

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

TEST_F(OutputFile, AnEarlierSetGoesWhenTheNewOneIsWrittenAndNotBefore) {
  const auto text = [](const char* what) { return [what](std::ostream& out) { out << what; }; };
  const auto bad = [](std::ostream& out) { out.setstate(std::ios::badbit); };
  writeFiles({{folder_ / "a.txt", text("old")}, {folder_ / "b.txt", text("old")}});
  EXPECT_THROW(writeFiles({{folder_ / "a.txt", bad}}, {folder_ / "b.txt"}), InputError);
  EXPECT_EQ(read(folder_ / "b.txt"), "old");
  writeFiles({{folder_ / "a.txt", text("new")}}, {folder_ / "b.txt", folder_ / "c.txt"});
  EXPECT_EQ(read(folder_ / "a.txt"), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFile, ALinkGoesOnToLeadToItsFile) {
  fs::create_directories(folder_ / "far");
  fs::create_symlink("far/a.txt", folder_ / "link");  // which is not there yet
  for (const char* text : {"first", "second"}) {
    writeFile(folder_ / "link", [&](std::ostream& out) { out << text; });
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(read(folder_ / "far" / "a.txt"), text);
  }
  EXPECT_EQ(files(), 2);
}

TEST_F(OutputFile, AFileKeepsItsMode) {
  const fs::path file = folder_ / "a.txt";
  writeFile(file, [](std::ostream& out) { out << "old"; });
  for (const unsigned mode : {0600u, 0664u, 0755u}) {
    fs::permissions(file, static_cast<fs::perms>(mode));
    writeFile(file, [](std::ostream& out) { out << "new"; });
    EXPECT_EQ(static_cast<unsigned>(fs::status(file).permissions()), mode);
  }
}

TEST_F(OutputFile, WhatAKilledWriterLeftIsClearedAndNothingElse) {
  // A process that is gone for certain.
  const pid_t gone = ::fork();
  if (gone == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(gone, nullptr, 0), gone);
  const std::string left = ".part-" + std::to_string(gone) + "-0";
  const std::string others = ".part-" + std::to_string(::getppid()) + "-0";
  for (const std::string& name :
       {"a.txt" + left, "a.txt" + others, "b.txt" + left, std::string("a.txt.part-of-a-story")}) {
    std::ofstream(folder_ / name) << "half";
  }
  writeFile(folder_ / "a.txt", [](std::ostream& out) { out << "whole"; });
  EXPECT_FALSE(fs::exists(folder_ / ("a.txt" + left)));
  EXPECT_TRUE(fs::exists(folder_ / ("a.txt" + others)));
  EXPECT_TRUE(fs::exists(folder_ / ("b.txt" + left)));
  EXPECT_TRUE(fs::exists(folder_ / "a.txt.part-of-a-story"));
}

TEST_F(OutputFile, APipeThatNobodyReadsFromIsRefusedAndOneThatIsReadIsNoFile) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto write = [](std::ostream& out) { out << "through a pipe"; };
  try {
    writeFile(pipe, write);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "nobody reads from the pipe");
  }
  std::string got;
  std::thread reader([&] { got = read(pipe); });
  writeFile(pipe, write);
  reader.join();
  EXPECT_EQ(got, "through a pipe");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

}  // namespace
}  // namespace amble
